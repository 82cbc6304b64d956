"""MATLAB ``.mat`` files of versions 5 to 7.2: vectors, matrices, cells and structures as tables."""

from __future__ import annotations

import io
import struct
import warnings
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.errors import RecordingError
from pointpred.extras import require
from pointpred.sources.column_table import ColumnTable
from pointpred.sources.decoding import read_unpacked
from pointpred.sources.reading import AS_IS, Reading
from pointpred.sources.record_paths import table_at
from pointpred.sources.record_tables import check_depth

TITLE = "MATLAB .mat"
MAGIC, HDF5 = b"MATLAB ", b"MATLAB 7.3"
HEADER_BYTES = 128
COMPRESSED = 15
BLOCK_BYTES = 1 << 20
MOST_UNPACKED = 1 << 28


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a MATLAB file of version 5 or later."""
    return head.startswith(MAGIC) and b"MAT-file" in head[:HEADER_BYTES]


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read the variables at ``reading.records``, else the only ones that fit (``record_paths``).

    Vectors of one length are columns, so are the columns of a matrix; a structure array is a record each.
    Raises RecordingError, also for version 7.3 and above 256 MiB of unpacked values; MissingExtraError.
    """
    require("tables", f"{path}: reading a MATLAB file")
    data = read_unpacked(path)
    if data.startswith(HDF5):
        raise RecordingError(
            f"{path}: MATLAB 7.3 files are not read; save it again in MATLAB with: save('NAME.mat', '-v7')"
        )
    _check_size(path, data)
    try:
        variables = _load(data)
        document = {name: _plain(value, 0) for name, value in variables.items() if name[:2] != "__"}
    except RecordingError as error:
        raise RecordingError(f"{path}: {error}") from error
    except Exception as error:  # scipy raises errors of many kinds on damaged bytes
        raise RecordingError(f"{path}: damaged MATLAB file: {str(error)[:120]}") from error
    return table_at(path, document, reading.records, TITLE)


def _load(data: bytes) -> dict[str, Any]:
    from scipy.io import loadmat

    with warnings.catch_warnings():
        warnings.simplefilter("error")  # a variable that cannot be read is a warning to scipy
        loaded: dict[str, Any] = loadmat(io.BytesIO(data), simplify_cells=True)
    return loaded


def _check_size(path: Path, data: bytes) -> None:
    """Raise RecordingError where the variables unpack to more than is read, before they are."""
    order = ">" if data[HEADER_BYTES - 2 : HEADER_BYTES] == b"MI" else "<"
    at, size = HEADER_BYTES, len(data)
    while at + 8 <= len(data):
        kind, count = struct.unpack_from(f"{order}II", data, at)
        at += 8
        if kind == COMPRESSED:
            size += _unpacked_size(data[at : at + count])
        if size > MOST_UNPACKED:
            raise RecordingError(
                f"{path}: more than {MOST_UNPACKED} bytes of values; save the mouse's variables alone"
            )
        at += count


def _unpacked_size(packed: bytes) -> int:
    """Bytes that a compressed variable unpacks to, counted no further than to the bound."""
    unpacker, size = zlib.decompressobj(), 0
    try:
        while packed and size <= MOST_UNPACKED:
            size += len(unpacker.decompress(packed, BLOCK_BYTES))
            packed = unpacker.unconsumed_tail
    except zlib.error:
        return size  # scipy says what is wrong
    return size


def _plain(value: Any, depth: int) -> Any:
    """MATLAB values as Python's: structures as objects, arrays and cells as lists."""
    check_depth(depth)
    if isinstance(value, dict):
        return {name: _plain(inner, depth + 1) for name, inner in value.items()}
    if isinstance(value, list):
        return [_plain(inner, depth + 1) for inner in value]
    if not isinstance(value, np.ndarray | np.generic):
        return value if isinstance(value, str | int | float | bool | None) else str(value)
    if value.dtype.kind in "biufSU":
        return value.tolist()
    if value.dtype.kind == "O" and isinstance(value, np.ndarray):
        return [_plain(inner, depth + 1) for inner in value]
    return str(value.dtype)
