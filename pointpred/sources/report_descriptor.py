"""HID report descriptors: where relative x, y and the buttons lie in a mouse's reports, and their values."""

from __future__ import annotations

from collections.abc import Iterator

import msgspec

from pointpred.errors import RecordingError

GENERIC_DESKTOP, BUTTON_PAGE = 0x01, 0x09
X, Y = 0x30, 0x31
INPUT, OUTPUT, COLLECTION, FEATURE, END_COLLECTION = 0x8, 0x9, 0xA, 0xB, 0xC
CONSTANT, VARIABLE, RELATIVE = 1, 2, 4
LONG_ITEM = 0xFE
MOST_BITS, MOST_FIELDS = 32, 4096
BITS = {1: 1, 2: 2, 3: 4, 4: 8, 5: 16}
"""HID buttons 1 (primary), 2 (secondary), 3 (middle), 4, 5 -> bits of W3C pointer events."""


class Field(msgspec.Struct, frozen=True):
    """``bits`` bits from bit ``first`` of a report (its ID byte included), two's complement where signed."""

    first: int
    bits: int
    signed: bool

    def value(self, report: int) -> int:
        """The field's value in a report read as one little-endian number."""
        raw = (report >> self.first) & ((1 << self.bits) - 1)
        return raw - (1 << self.bits) if self.signed and raw >> (self.bits - 1) else raw


class Layout(msgspec.Struct, frozen=True):
    """The fields of one report: x and y where it has them, and (field, W3C bit) of each button."""

    size: int
    x: Field | None
    y: Field | None
    buttons: tuple[tuple[Field, int], ...]


class ReportDescriptor(msgspec.Struct, frozen=True):
    """Layouts by report ID (0 where reports carry none); ``numbered`` when the first byte is the ID."""

    numbered: bool
    layouts: dict[int, Layout]

    def decode(self, report: bytes) -> tuple[int, int, int, int] | None:
        """dx, dy, buttons and the mask of buttons this report speaks about; ``None`` for other reports.

        Raises RecordingError when the report is shorter than its descriptor says.
        """
        layout = self.layouts.get(report[0] if self.numbered and report else 0)
        if layout is None:
            return None
        if len(report) < layout.size:
            raise RecordingError(f"report of {len(report)} bytes, expected {layout.size}")
        whole = int.from_bytes(report, "little")
        pressed = mask = 0
        for field, bit in layout.buttons:
            pressed |= bit * field.value(whole)
            mask |= bit
        dx = layout.x.value(whole) if layout.x else 0
        dy = layout.y.value(whole) if layout.y else 0
        return dx, dy, pressed, mask


def parse_descriptor(data: bytes) -> ReportDescriptor:
    """Where the relative x, y and buttons lie, from a report descriptor's bytes.

    Assumes variable input fields of up to 32 bits; a field is signed when its logical minimum is negative.
    Absolute x and y (tablets, touch) and array buttons are not taken. Wheels are not read yet.
    Raises RecordingError when the bytes are no descriptor or nothing in it moves.
    Reference: USB HID 1.11, section 6.2.2.

    >>> head = "05010902a1010901a100"
    >>> three_buttons = "05091901290315002501950375018102950175058101"
    >>> two_bytes = "0501093009311581257f750895028106c0c0"
    >>> parse_descriptor(bytes.fromhex(head + three_buttons + two_bytes)).decode(bytes([1, 5, 0xFF]))
    (5, -1, 1, 7)
    """
    state = _State()
    for tag, kind, unsigned, signed, size in _items(data):
        if kind == 0:
            state.main(tag, unsigned)
        elif kind == 1:
            state.set_global(tag, unsigned, signed)
        elif kind == 2:
            state.set_local(tag, unsigned, size)
    layouts = {
        number: Layout(
            (state.reached[number] + 7) // 8, fields.get(X), fields.get(Y), tuple(state.buttons[number])
        )
        for number, fields in state.axes.items()
        if fields or state.buttons[number]
    }
    if not any(layout.x or layout.y for layout in layouts.values()):
        raise RecordingError("report descriptor without relative x or y, expected a mouse's")
    return ReportDescriptor(state.numbered, layouts)


def _items(data: bytes) -> Iterator[tuple[int, int, int, int, int]]:
    """Tag, type, unsigned and signed value and size of every short item; long items are passed over."""
    at = 0
    while at < len(data):
        prefix = data[at]
        if prefix == LONG_ITEM:
            at += 3 + (data[at + 1] if at + 1 < len(data) else 0)
            continue
        size = (0, 1, 2, 4)[prefix & 3]
        value = data[at + 1 : at + 1 + size]
        if len(value) < size:
            raise RecordingError(f"report descriptor ends inside the item at byte {at}")
        unsigned, signed = int.from_bytes(value, "little"), int.from_bytes(value, "little", signed=True)
        yield prefix >> 4, (prefix >> 2) & 3, unsigned, signed, size
        at += 1 + size


class _State:
    """The item state table of HID 1.11 and what has been found with it."""

    def __init__(self) -> None:
        self.page = self.minimum = self.size = self.count = self.report = 0
        self.pushed: list[tuple[int, int, int, int, int]] = []
        self.numbered = False
        self.usages: list[int] = []
        self.lowest: int | None = None
        self.reached: dict[int, int] = {0: 0}
        self.axes: dict[int, dict[int, Field]] = {0: {}}
        self.buttons: dict[int, list[tuple[Field, int]]] = {0: []}

    def set_global(self, tag: int, unsigned: int, signed: int) -> None:
        """Usage page, logical minimum, report size, ID and count, push and pop."""
        if tag == 0x0:
            self.page = unsigned
        elif tag == 0x1:
            self.minimum = signed
        elif tag == 0x7:
            self.size = unsigned
        elif tag == 0x8:
            self.report, self.numbered = unsigned & 0xFF, True
            self.reached.setdefault(self.report, 8)
            self.axes.setdefault(self.report, {})
            self.buttons.setdefault(self.report, [])
        elif tag == 0x9:
            self.count = unsigned
        elif tag == 0xA:
            self.pushed.append((self.page, self.minimum, self.size, self.count, self.report))
        elif tag == 0xB:
            if not self.pushed:
                raise RecordingError("report descriptor pops more than it pushes")
            self.page, self.minimum, self.size, self.count, self.report = self.pushed.pop()

    def set_local(self, tag: int, value: int, size: int) -> None:
        """Usages, one by one or as a range; 4-byte usages carry their page."""
        usage = value if size == 4 else (self.page << 16) | value
        if tag == 0x0:
            self.usages.append(usage)
        elif tag == 0x1:
            self.lowest = usage
        elif tag == 0x2 and self.lowest is not None:
            self.usages.extend(range(self.lowest, min(usage, self.lowest + MOST_FIELDS) + 1))
            self.lowest = None

    def main(self, tag: int, flags: int) -> None:
        """Input fields; every main item clears the usages."""
        if tag == INPUT:
            if self.count > MOST_FIELDS or self.size > MOST_BITS * MOST_FIELDS:
                raise RecordingError(f"report descriptor with {self.count} fields of {self.size} bits")
            for index in range(self.count):
                self._field(index, flags)
            self.reached[self.report] += self.size * self.count
        self.usages, self.lowest = [], None

    def _field(self, index: int, flags: int) -> None:
        """Take one field if it is a relative axis or a button."""
        if flags & CONSTANT or not flags & VARIABLE or not self.usages or not 0 < self.size <= MOST_BITS:
            return
        page, usage = divmod(self.usages[min(index, len(self.usages) - 1)], 1 << 16)
        field = Field(self.reached[self.report] + index * self.size, self.size, self.minimum < 0)
        if page == GENERIC_DESKTOP and usage in (X, Y) and flags & RELATIVE:
            self.axes[self.report].setdefault(usage, field)
        elif page == BUTTON_PAGE and usage in BITS and self.size == 1:
            self.buttons[self.report].append((msgspec.structs.replace(field, signed=False), BITS[usage]))
