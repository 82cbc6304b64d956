"""MATLAB ``.mat`` files of versions 5 to 7.2: vectors, matrices, cells and structures as tables."""

from __future__ import annotations

import math
import struct
import zlib
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.encodings import read_unpacked
from pointpred.recordings.nested_records import check_depth
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.table_choice import table_in

TITLE = "MATLAB .mat"
MAGIC, HDF5 = b"MATLAB ", b"MATLAB 7.3"
HEADER_BYTES, TAG_BYTES = 128, 8
MATRIX, COMPRESSED = 14, 15
NUMBERS = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
"""Stored number types, which may be narrower than the array's own."""
LETTERS = {1: "latin-1", 2: "latin-1", 4: "utf-16", 16: "utf-8", 17: "utf-16", 18: "utf-32"}
CELL, STRUCTURE, CHARACTERS, FIRST_NUMERIC, LAST_NUMERIC, OPAQUE = 1, 2, 4, 6, 15, 17
LOGICAL, COMPLEX = 0x0200, 0x0800
MOST_UNPACKED = 1 << 28
MOST_ELEMENTS = 1 << 21
MOST_DIMENSIONS = 32
UNREAD = "MATLAB object"
"""Placeholder for unsupported values: objects, tables, dates, functions, complex numbers."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a MATLAB file of version 5 or later."""
    return head.startswith(MAGIC) and b"MAT-file" in head[:HEADER_BYTES]


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read the variables that are meant (``table_choice``).

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
        table = table_in(path, variables, TITLE, reading)
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
    for kind, content in _elements(memoryview(data)[HEADER_BYTES:], order, padded=False):
        inner = content if kind != COMPRESSED else _unpacked(content, MOST_UNPACKED - size)
        size += len(inner)
        if size > MOST_UNPACKED:
            raise RecordingError(
                f"more than {MOST_UNPACKED} bytes of values; save the mouse's variables alone"
            )
        parts = _elements(inner, order) if kind == COMPRESSED else [(kind, content)]
        variables |= dict(_array(array, order) for part, array in parts if part == MATRIX)
    return variables


def _elements(data: memoryview, order: str, *, padded: bool = True) -> list[tuple[int, memoryview]]:
    """The type and content of each of the elements in some bytes; raises RecordingError if one is cut."""
    elements: list[tuple[int, memoryview]] = []
    at = 0
    while at < len(data):
        if len(elements) == MOST_ELEMENTS:
            raise RecordingError(f"more than {MOST_ELEMENTS} values in one array")
        if len(data) - at < TAG_BYTES:
            raise RecordingError("cut within the tag of a value")
        kind, size = struct.unpack_from(f"{order}II", data, at)
        start = at + TAG_BYTES
        end = start + size + (-size % TAG_BYTES if padded and kind != COMPRESSED else 0)
        if kind >> 16:  # a small one, within its tag
            kind, size, start, end = kind & 0xFFFF, kind >> 16, at + TAG_BYTES // 2, at + TAG_BYTES
        if start + size > min(end, len(data)):
            raise RecordingError("cut, or a size in it is damaged")
        elements.append((kind, data[start : start + size]))
        at = end
    return elements


def _unpacked(packed: memoryview, most: int) -> memoryview:
    unpacker = zlib.decompressobj()
    try:
        data = unpacker.decompress(packed, max(most, 0) + 1)
    except zlib.error as error:
        raise RecordingError(f"a damaged variable: {error}") from error
    if not unpacker.eof and len(data) <= most:
        raise RecordingError("a variable is cut")
    return memoryview(data)


def _array(data: memoryview, order: str, depth: int = 0) -> tuple[str, Any]:
    """The name and value of an array of any class."""
    check_depth(depth)
    if not data:
        return "", []
    parts = _elements(data, order)
    arrays = [content for kind, content in parts if kind == MATRIX]
    contents = [(kind, content) for kind, content in parts if kind != MATRIX]
    if len(contents) < 3:
        raise RecordingError("the beginning of an array is cut")
    flags, shape = (_numbers(*part, order).tolist() for part in contents[:2])
    kind = int(flags[0]) & 0xFF if flags else 0
    if kind == OPAQUE:
        return str(contents[1][1], "latin-1"), UNREAD
    name, count = str(contents[2][1], "latin-1"), math.prod(shape)
    if not flags or not 2 <= len(shape) <= MOST_DIMENSIONS or min(shape) < 0:
        raise RecordingError("the size of an array is damaged")
    if kind == CELL:
        return name, _cells([_array(array, order, depth + 1)[1] for array in arrays], shape)
    if kind == STRUCTURE:
        fields = _fields(contents[3:5], order)
        if len(arrays) != count * len(fields):
            raise RecordingError(f"{count * len(fields)} values announced, {len(arrays)} follow")
        values = iter([_array(array, order, depth + 1)[1] for array in arrays])
        rows = [{field: next(values) for field in fields} for _ in range(count if fields else 0)]
        return name, rows[0] if count == 1 and fields else rows
    if not (kind == CHARACTERS or FIRST_NUMERIC <= kind <= LAST_NUMERIC) or int(flags[0]) & COMPLEX:
        return name, UNREAD
    if len(contents) < 4:
        raise RecordingError("an array is cut")
    if kind == CHARACTERS:
        return name, _words(*contents[3], order, shape)
    numbers = _numbers(*contents[3], order)
    if len(numbers) != count:
        raise RecordingError(f"an array of {count} numbers holds {len(numbers)}")
    long = [size for size in shape if size != 1]
    if int(flags[0]) & LOGICAL:
        numbers = numbers.astype(bool)
    return name, numbers.reshape(shape, order="F").reshape(long).tolist() if count else []


def _numbers(kind: int, content: memoryview, order: str) -> Any:
    if kind not in NUMBERS:
        raise RecordingError(f"type {kind} where numbers are expected")
    layout = np.dtype(order + NUMBERS[kind])
    return np.frombuffer(content[: len(content) // layout.itemsize * layout.itemsize], layout)


def _words(kind: int, content: memoryview, order: str, shape: list[int]) -> Any:
    """Characters as a string, or one string per row."""
    codec = LETTERS.get(kind, "")
    if not codec:
        raise RecordingError(f"type {kind} where letters are expected")
    wide = codec in ("utf-16", "utf-32")
    text = str(content, f"{codec}-{'be' if order == '>' else 'le'}" if wide else codec, "replace")
    rows = shape[0]
    return text if rows <= 1 else [text[at::rows].rstrip() for at in range(min(rows, len(text)))]


def _cells(values: list[Any], shape: list[int]) -> list[Any]:
    """The cells as a list, or a list of rows if there are several rows and columns."""
    if len(values) != math.prod(shape):
        raise RecordingError(f"{math.prod(shape)} values announced, {len(values)} follow")
    if not values or len([size for size in shape if size != 1]) < 2:
        return values
    return [values[at :: shape[0]] for at in range(shape[0])]


def _fields(contents: list[tuple[int, memoryview]], order: str) -> list[str]:
    """The names of a structure's fields."""
    width = int(next(iter(_numbers(*contents[0], order)), 0)) if len(contents) == 2 else 0
    names = bytes(contents[-1][1]) if contents else b""
    if width < 1 or len(names) % width:
        raise RecordingError("the names of fields are damaged")
    return [names[at : at + width].split(b"\0")[0].decode("latin-1") for at in range(0, len(names), width)]
