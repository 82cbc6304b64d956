"""The size of a recording once it is unpacked, checked before it is."""

from __future__ import annotations

import gzip
import io
from typing import Any

from pointpred.errors import RecordingError
from pointpred.recordings.encodings import (
    DAMAGED,
    GZIP,
    HEAD_BYTES,
    UTF_16,
)
from pointpred_server.uploads.receiving import UploadError

PARQUET = b"PAR1"
MOST_ROWS = 500_000
"""More than eight minutes of movement at 1000 events a second."""
MOST_COLUMNS = 32
MOST_UNPACKED = 2**27
"""Bytes; reading needs a few times as many."""
BATCH_ROWS = 2**14
MOST_TEXT = 2**25
"""Bytes of unpacked text; reading it as JSON needs about twenty times as many."""
NO_TEXT = "the recording is neither text nor Parquet; 'pointpred convert' reads other files"


def check_unpacked(body: bytes) -> None:
    """Raise UploadError where the rows of a file, or what it holds, take more than is allowed.

    Raises RecordingError for a Parquet file that is damaged or holds what no recording holds, and for any
    other file that is no text. A Parquet file with a false size of its pages is not detected.
    """
    if body.startswith(PARQUET):
        _check_parquet(body)
        return
    if body.startswith(GZIP):
        body = _unpacked(body)
    if not body.startswith(UTF_16) and b"\0" in body[:HEAD_BYTES]:
        raise RecordingError(NO_TEXT)
    check_most("rows", max(body.count(b"\n"), body.count(b"\r")), MOST_ROWS + 1)


def _unpacked(body: bytes) -> bytes:
    """The content of a gzip file, read no further than is allowed."""
    try:
        with gzip.GzipFile(fileobj=io.BytesIO(body)) as file:
            unpacked = file.read(MOST_TEXT + 1)
    except DAMAGED as error:
        raise RecordingError(f"the recording: damaged gzip file: {error}") from None
    check_most("bytes", len(unpacked), MOST_TEXT)
    return unpacked


def _check_parquet(body: bytes) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    from pointpred.recordings.arrow_tables import UNREADABLE, in_memory

    try:
        file = pa.BufferReader(in_memory(io.BytesIO(body)))
        about = pq.read_metadata(file)
        check_most("rows", about.num_rows, MOST_ROWS)
        check_most("columns", about.num_columns, MOST_COLUMNS)
        groups = [about.row_group(i) for i in range(about.num_row_groups)]
        size = sum(group.total_byte_size for group in groups)
        check_most("bytes", max(size, 8 * about.num_rows * about.num_columns), MOST_UNPACKED)
        text_columns = _text_columns(about.schema.to_arrow_schema())
        _count_rows(file, text_columns)
        if text_columns:
            with pq.ParquetFile(file, read_dictionary=text_columns) as opened:
                size += sum(_text_bytes(column) for column in opened.read(columns=text_columns).columns)
            check_most("bytes", size, MOST_UNPACKED)
    except (RecordingError, MemoryError):
        raise
    except UNREADABLE as error:
        raise RecordingError(f"the recording: {' '.join(str(error).split())}") from None


def _count_rows(file: Any, text_columns: list[str]) -> None:
    """Count the rows that a file really holds: what it declares may be false.

    They are read in batches, a column at a time, so that no more is in memory than is allowed.
    """
    import pyarrow.parquet as pq

    with pq.ParquetFile(file, read_dictionary=text_columns) as opened:
        for column in range(opened.metadata.num_columns):
            name = opened.metadata.schema.column(column).path
            rows = 0
            for batch in opened.iter_batches(BATCH_ROWS, columns=[name], use_threads=False):
                rows += len(batch)
                check_most("rows", rows, MOST_ROWS)


def _text_columns(schema: Any) -> list[str]:
    """The columns of text; raises RecordingError for one that holds no text, numbers, dates or times."""
    import pyarrow as pa

    from pointpred.recordings.arrow_tables import PLAIN

    names = []
    for field in schema:
        kind = field.type.value_type if pa.types.is_dictionary(field.type) else field.type
        if not any(fits(kind) for fits in (*PLAIN, pa.types.is_temporal)):
            raise RecordingError(
                f"the recording: column {field.name!r} holds {kind}, expected text or numbers"
            )
        if pa.types.is_string(kind) or pa.types.is_large_string(kind):
            names.append(field.name)
    return names


def _text_bytes(column: Any) -> int:
    """The most bytes that a column takes with every text written out where it occurs."""
    import pyarrow.compute as pc

    size = 0
    for chunk in column.chunks:
        texts = chunk.dictionary if hasattr(chunk, "dictionary") else chunk
        longest = max((int(n or 0) for n in pc.binary_length(texts).to_pylist()), default=0)
        size += len(chunk) * (4 + longest)
    return size


def check_most(what: str, count: int, most: int) -> None:
    """Raise UploadError for a recording that only ``pointpred score`` takes."""
    if count > most:
        sentence = f"a recording scored here holds at most {most} {what}, received {count}"
        raise UploadError("too_large", f"{sentence}; 'pointpred score' takes larger ones", 413)
