"""The items of a HID report descriptor, one after the other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from pointpred.errors import RecordingError

MAIN, GLOBAL, LOCAL = 0, 1, 2
"""Types of items; the fourth is reserved."""
LONG_ITEM = 0xFE


def bad_descriptor(message: str, at: int) -> RecordingError:
    """The error about a descriptor whose byte ``at`` is wrong."""
    return RecordingError(message, code="bad_descriptor", field="report_descriptor", value=at)


class Item(NamedTuple):
    """A short item: the byte where it begins, its tag and type, its value both ways, its bytes of data."""

    at: int
    tag: int
    kind: int
    unsigned: int
    signed: int
    size: int


def short_items(data: bytes) -> Iterator[Item]:
    """Every short item of a descriptor; long items are skipped.

    Raises RecordingError, naming the byte, when the descriptor ends inside an item.
    Reference: USB HID 1.11, sections 6.2.2.1 to 6.2.2.3.

    >>> [(item.tag, item.kind, item.signed) for item in short_items(bytes([0x15, 0x81]))]
    [(1, 1, -127)]
    """
    at = 0
    while at < len(data):
        prefix = data[at]
        long = prefix == LONG_ITEM
        size = (0, 1, 2, 4)[prefix & 3]
        if long:  # its size, a long tag, and so many bytes
            size = 2 + data[at + 1] if at + 1 < len(data) else 2
        value = data[at + 1 : at + 1 + size]
        if len(value) < size:
            raise bad_descriptor(f"report descriptor ends inside the item at byte {at}", at)
        if not long:
            unsigned, signed = int.from_bytes(value, "little"), int.from_bytes(value, "little", signed=True)
            yield Item(at, prefix >> 4, prefix >> 2 & 3, unsigned, signed, size)
        at += 1 + size
