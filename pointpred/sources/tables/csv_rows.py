"""The rows of a CSV file as an Arrow table; rows that are cut or too long raise an error."""

from __future__ import annotations

from pathlib import Path
from typing import Any, BinaryIO

import pyarrow as pa
import pyarrow.csv as pacsv

from pointpred.errors import RecordingError
from pointpred.sources.files.arrow_files import in_memory
from pointpred.sources.reading import row_name

LARGEST_BLOCK = 1 << 25


def parse_csv(path: Path, file: BinaryIO, skip: int, types: dict[str, Any], separator: str) -> Any:
    """The rows below ``skip`` lines of the open ``file``, named ``path`` in messages.

    The columns have the named Arrow ``types``, or are all strings if a cell is not of its type.
    Raises RecordingError naming the first row that is cut or too long, with its number as ``value``.
    """
    rows = in_memory(file)
    try:
        return _parse(rows, skip, types, pacsv.ParseOptions(delimiter=separator, newlines_in_values=True))
    except pa.ArrowInvalid:
        pass
    wrong: list[Any] = []

    def remember(row: Any) -> str:
        wrong.append(row)
        return "error"

    options = pacsv.ParseOptions(delimiter=separator, newlines_in_values=True, invalid_row_handler=remember)
    try:  # in order, so that Arrow numbers the rows, and without threads, which must not call Python
        return _parse(rows, skip, dict.fromkeys(types, pa.string()), options, threads=False)
    except pa.ArrowInvalid as error:
        if not wrong:
            raise
        number = wrong[0].number - 2 - skip
        raise RecordingError(
            f"{path}: {row_name(number)}: {wrong[0].actual_columns} cells, "
            f"expected {wrong[0].expected_columns}; cut or mixed up?",
            code="bad_row",
            value=number,
        ) from error


def _parse(rows: Any, skip: int, types: dict[str, Any], options: Any, *, threads: bool = True) -> Any:
    block = min(max(rows.size, 1), LARGEST_BLOCK)  # Arrow needs the longest row in one block
    return pacsv.read_csv(
        pa.BufferReader(rows),
        read_options=pacsv.ReadOptions(skip_rows=skip, use_threads=threads, block_size=block),
        parse_options=options,
        convert_options=pacsv.ConvertOptions(
            column_types=types,
            null_values=[""],
            strings_can_be_null=True,
            quoted_strings_can_be_null=False,
        ),
    )
