"""Files and bytes for Arrow without Python objects inside.

Arrow's threads may release their input after the interpreter has ended. If that is a Python object, such as
an open file or bytes, the process aborts.
"""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any, BinaryIO

import pyarrow as pa


def open_file(path: Path, mode: str = "rb") -> Any:
    """A file opened by Arrow; a name in bytes need not be UTF-8. Raises OSError."""
    return pa.OSFile(os.fsencode(path), mode)


def in_memory(file: BinaryIO) -> Any:
    """The bytes of a file from its beginning in an Arrow buffer; raises OSError."""
    buffer = pa.allocate_buffer(file.seek(0, io.SEEK_END))
    file.seek(0)
    with memoryview(buffer) as signed, signed.cast("B") as free:
        size = _fill(file, free)
    return buffer.slice(0, size)


AT_ONCE = 1024 * 1024
"""Bytes that are read at a time."""


def _fill(file: BinaryIO, free: memoryview) -> int:
    """Read until the memory is full or the file ends; returns the number of bytes read."""
    size = 0
    while part := file.read(min(AT_ONCE, len(free) - size)):
        free[size : size + len(part)] = part
        size += len(part)
    return size
