"""Parquet files that are not pointpred's own, as any table."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "a table of samples (Parquet)"
LISTS = (pa.types.is_list, pa.types.is_large_list, pa.types.is_fixed_size_list)


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a Parquet file."""
    return head.startswith(arrow_tables.PARQUET_MAGIC)


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """The columns of words, numbers, dates and times, and lists of numbers; structures are flattened.

    A note names the other columns. Raises RecordingError for a damaged file or a repeated name.
    """
    try:
        table, _ = arrow_tables.read_parquet(path)
    except arrow_tables.UNREADABLE as error:
        raise arrow_tables.unreadable(path, error) from error
    while any(pa.types.is_struct(kind) for kind in table.schema.types):
        table = table.flatten()
    arrow_tables.check_names(path, table.column_names)
    for name in table.column_names:
        _check_times(path, name, table[name])
    columns = {name: _plain(table[name]) for name in table.column_names}
    unread = [name for name, column in columns.items() if column is None]
    notes = (f"columns left aside, for they hold no numbers or words: {', '.join(unread)}",) if unread else ()
    return ColumnTable(
        {name: column for name, column in columns.items() if column is not None}, "Parquet", notes
    )


def _check_times(path: Path, name: str, column: Any) -> None:
    """Raise RecordingError for a date or time that Python has not: Arrow counts further than its calendar."""
    kind = column.type
    if not pa.types.is_temporal(kind):
        return
    counts = column.cast(pa.int32() if kind.bit_width == 32 else pa.int64())
    try:
        for count in (pc.min(counts), pc.max(counts)):
            count.cast(kind).as_py()
    except (OverflowError, ValueError) as error:
        raise RecordingError(f"{path}: column {name!r} holds a time out of range: {error}") from error


def _plain(column: Any) -> Any:
    """A column of words, numbers, dates and times, or lists of numbers; ``None`` for any other."""
    kind = column.type
    if pa.types.is_dictionary(kind):
        return _plain(column.cast(kind.value_type))
    if pa.types.is_null(kind) or arrow_tables.is_words(column):
        return column.cast(pa.string())
    if pa.types.is_decimal(kind):
        return column.cast(pa.float64())
    if any(is_list(kind) for is_list in LISTS):
        numeric = pa.types.is_integer(kind.value_type) or pa.types.is_floating(kind.value_type)
        return column.cast(pa.large_list(kind.value_type)) if numeric else None
    plain = pa.types.is_temporal(kind) or any(fits(kind) for fits in arrow_tables.PLAIN)
    return column if plain else None
