"""MATLAB ``.mat`` files of versions 5 to 7.2: vectors, matrices, cells and structures as tables."""

from __future__ import annotations

from pathlib import Path

import msgspec

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.encodings import read_unpacked
from pointpred.recordings.formats.matlab import HEADER_BYTES, UNREAD, variables_of
from pointpred.recordings.nested_records import table_at
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "MATLAB .mat"
MAGIC, HDF5 = b"MATLAB ", b"MATLAB 7.3"


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a MATLAB file of version 5 or later."""
    return head.startswith(MAGIC) and b"MAT-file" in head[:HEADER_BYTES]


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read the variables at ``reading.records``, else the only ones that fit (``record_paths``).

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
