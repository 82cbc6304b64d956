"""MATLAB ``.mat`` files of versions 5 to 7.2: vectors, matrices, cells and structures as tables."""

from __future__ import annotations

import math
import struct
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.encodings import read_unpacked
from pointpred.recordings.nested_records import check_depth, table_at
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "MATLAB .mat"
MAGIC, HDF5 = b"MATLAB ", b"MATLAB 7.3"
HEADER_BYTES, TAG_BYTES = 128, 8
MATRIX, COMPRESSED = 14, 15
NUMBERS = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
"""Stored number types, which may be narrower than the array's own."""
LETTERS = {1: "latin-1", 2: "latin-1", 4: "utf-16", 16: "utf-8", 17: "utf-16", 18: "utf-32"}
CELL, STRUCTURE, CHARACTERS, FIRST_NUMERIC, LAST_NUMERIC = 1, 2, 4, 6, 15
LOGICAL, COMPLEX = 0x0200, 0x0800
MOST_UNPACKED = 1 << 28
MOST_DIMENSIONS = 32
BLOCK_BYTES = 1 << 20
UNREAD = "MATLAB object"
"""Placeholder for unsupported values: objects, tables, dates, functions, complex numbers."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a MATLAB file of version 5 or later."""
    return head.startswith(MAGIC) and b"MAT-file" in head[:HEADER_BYTES]


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read the variables at ``reading.records``, else the only ones that fit (``nested_records``).

    Vectors of one length and the columns of a matrix are columns; elements of a structure array are records.
    Raises RecordingError, also for version 7.3.
    """
    data = read_unpacked(path)
    if data.startswith(HDF5):
        raise RecordingError(
            f"{path}: MATLAB 7.3 files are not read; save it again in MATLAB with: save('NAME.mat', '-v7')"
        )
    try:
        variables = variables_of(data)
    except RecordingError as error:
        raise RecordingError(f"{path}: damaged MATLAB file: {error}") from error
    objects = [name for name, value in variables.items() if value == UNREAD]
    note = f"not read, as they are objects (tables, dates, strings) or complex: {', '.join(objects)}"
    try:
        table = table_at(path, variables, reading.records, TITLE)
    except RecordingError as error:
        if not objects:
            raise
        raise RecordingError(f"{error}; {note}; save their columns as vectors") from error
    return msgspec.structs.replace(table, notes=(*table.notes, note)) if objects else table


def variables_of(data: bytes) -> dict[str, Any]:
    """The variables of a file by name, as text, numbers, lists and objects.

    A vector is a list, a matrix a list of its rows, a cell array a list, a structure an object, an array of
    structures a list of objects. Raises RecordingError if the bytes are damaged, nested deeper than 32
    levels, or contain more than 256 MiB of values.
    """
    if len(data) < HEADER_BYTES:
        raise RecordingError("cut within its header")
    order = ">" if data[HEADER_BYTES - 2 : HEADER_BYTES] == b"MI" else "<"
    variables: dict[str, Any] = {}
    size = 0
    for kind, content in Elements(data[HEADER_BYTES:], order, padded=False):
        inner = content
        if kind == COMPRESSED:
            inner = _unpacked(content, MOST_UNPACKED - size)
        size += len(inner)
        if size > MOST_UNPACKED:
            raise RecordingError(
                f"more than {MOST_UNPACKED} bytes of values; save the mouse's variables alone"
            )
        for part, matrix in Elements(inner, order) if kind == COMPRESSED else [(kind, content)]:
            if part == MATRIX:
                name, value = _matrix(matrix, order, 0)
                variables[name] = value
    return variables


class Elements:
    """The consecutive elements in some bytes: the type and content of each."""

    def __init__(self, data: bytes, order: str, *, padded: bool = True) -> None:
        self.data = memoryview(data)
        self.order = order
        self.padded = padded
        self.at = 0

    def __iter__(self) -> Iterator[tuple[int, bytes]]:
        while self.at < len(self.data):
            yield self.next()

    def next(self) -> tuple[int, bytes]:
        """The next element; raises RecordingError if it is cut."""
        if self.room < TAG_BYTES:
            raise RecordingError("cut within the tag of a value")
        kind, size = struct.unpack_from(f"{self.order}II", self.data, self.at)
        start = self.at + TAG_BYTES
        if kind >> 16:
            kind, size, start = kind & 0xFFFF, kind >> 16, self.at + TAG_BYTES // 2
            end = self.at + TAG_BYTES
        else:
            end = start + size + (-size % TAG_BYTES if self.padded and kind != COMPRESSED else 0)
        if start + size > min(end, len(self.data)):
            raise RecordingError("cut, or a size in it is damaged")
        self.at = min(end, len(self.data))
        return kind, bytes(self.data[start : start + size])

    @property
    def room(self) -> int:
        """Number of remaining bytes."""
        return len(self.data) - self.at


def _unpacked(packed: bytes, most: int) -> bytes:
    unpacker = zlib.decompressobj()
    try:
        data = unpacker.decompress(packed, max(most, 0) + 1)
    except zlib.error as error:
        raise RecordingError(f"a damaged variable: {error}") from error
    if not unpacker.eof and len(data) <= most:
        raise RecordingError("a variable is cut")
    return data


def _matrix(data: bytes, order: str, depth: int) -> tuple[str, Any]:
    """The name and value of an array of any class."""
    check_depth(depth)
    if not data:
        return "", []
    parts = Elements(data, order)
    flags, shape = _whole(parts, order), _whole(parts, order)
    name = parts.next()[1].decode("latin-1")
    if not flags or not 2 <= len(shape) <= MOST_DIMENSIONS or min(shape) < 0:
        raise RecordingError("the size of an array is damaged")
    kind, count = flags[0] & 0xFF, math.prod(shape)
    if kind == CELL:
        return name, _cells(parts, order, shape, depth)
    if kind == STRUCTURE:
        return name, _structures(parts, order, count, depth)
    if kind == CHARACTERS:
        return name, _words(*parts.next(), order, shape)
    if not FIRST_NUMERIC <= kind <= LAST_NUMERIC or flags[0] & COMPLEX:
        return name, UNREAD
    values = _numbers(*parts.next(), order)
    if len(values) != count:
        raise RecordingError(f"an array of {count} numbers holds {len(values)}")
    return name, _plain(values.astype(bool) if flags[0] & LOGICAL else values, shape)


def _numbers(kind: int, content: bytes, order: str) -> Any:
    if kind not in NUMBERS:
        raise RecordingError(f"type {kind} where numbers are expected")
    layout = np.dtype(order + NUMBERS[kind])
    return np.frombuffer(content[: len(content) // layout.itemsize * layout.itemsize], layout)


def _whole(parts: Elements, order: str) -> list[int]:
    kind, content = parts.next()
    values = _numbers(kind, content, order)
    return values.tolist() if values.dtype.kind in "iu" else []


def _plain(values: Any, shape: list[int]) -> Any:
    """An array without the dimensions of size one: a number, a list, a list of rows."""
    if 0 in shape:
        return []
    long = [size for size in shape if size != 1]
    return values.reshape(shape, order="F").reshape(long).tolist()


def _words(kind: int, content: bytes, order: str, shape: list[int]) -> Any:
    """Characters as a string, or one string per row."""
    codec = LETTERS.get(kind, "")
    if not codec:
        raise RecordingError(f"type {kind} where letters are expected")
    wide = codec in ("utf-16", "utf-32")
    text = content.decode(f"{codec}-{'be' if order == '>' else 'le'}" if wide else codec, "replace")
    rows = shape[0]
    return text if rows <= 1 else [text[at::rows].rstrip() for at in range(min(rows, len(text)))]


def _cells(parts: Elements, order: str, shape: list[int], depth: int) -> list[Any]:
    """The cells as a list, or a list of rows if there are several rows and columns."""
    values = [_inner(parts, order, depth) for _ in range(_checked(math.prod(shape), parts))]
    if not values or len([size for size in shape if size != 1]) < 2:
        return values
    return [values[at :: shape[0]] for at in range(shape[0])]


def _structures(parts: Elements, order: str, count: int, depth: int) -> Any:
    """A structure as an object, several as a list of objects."""
    width = next(iter(_whole(parts, order)), 0)
    names = parts.next()[1]
    if width < 1 or len(names) % width:
        raise RecordingError("the names of fields are damaged")
    fields = [names[at : at + width].split(b"\0")[0].decode("latin-1") for at in range(0, len(names), width)]
    _checked(count * max(len(fields), 1), parts)
    rows = [{field: _inner(parts, order, depth) for field in fields} for _ in range(count)]
    return rows[0] if count == 1 else rows


def _checked(count: int, parts: Elements) -> int:
    """The number of values that follow, each of which needs at least a tag."""
    if count * TAG_BYTES > parts.room:
        raise RecordingError(f"{count} values announced, {parts.room} bytes follow")
    return count


def _inner(parts: Elements, order: str, depth: int) -> Any:
    kind, content = parts.next()
    if kind != MATRIX:
        raise RecordingError(f"type {kind} where an array is expected")
    return _matrix(content, order, depth + 1)[1]
