"""The rows of a CSV file as an Arrow table; a row that is cut or too long is named."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, BinaryIO

import pyarrow as pa
import pyarrow.csv as pacsv

from pointpred.errors import RecordingError
from pointpred.sources.files.arrow_files import in_memory
from pointpred.sources.reading import row_name

CELLS = re.compile(r"(?:Row #(\d+): )?Expected (\d+) columns, got (\d+)")
LARGEST_BLOCK = 1 << 25


def parse_csv(path: Path, file: BinaryIO, skip: int, types: dict[str, Any], separator: str) -> Any:
    """The rows below ``skip`` lines of the opened ``file``, which messages call ``path``.

    Raises RecordingError naming the first row that is cut or too long.
    """
    rows = in_memory(file)

    def parse(threads: bool) -> Any:
        return pacsv.read_csv(
            pa.BufferReader(rows),
            read_options=pacsv.ReadOptions(skip_rows=skip, use_threads=threads, block_size=_block(rows.size)),
            parse_options=pacsv.ParseOptions(delimiter=separator, newlines_in_values=True),
            convert_options=pacsv.ConvertOptions(
                column_types=types,
                null_values=[""],
                strings_can_be_null=True,
                quoted_strings_can_be_null=False,
            ),
        )

    try:
        return parse(threads=True)
    except pa.ArrowInvalid as error:
        if not CELLS.search(str(error)):
            raise
    try:
        return parse(threads=False)  # Arrow numbers the rows only when it reads them in order
    except pa.ArrowInvalid as error:
        found = CELLS.search(str(error))
        if found is None or found.group(1) is None:
            raise
        row, expected, cells = (int(number) for number in found.groups())
        raise RecordingError(
            f"{path}: {row_name(row - 2 - skip)}: {cells} cells, expected {expected}; cut or mixed up?"
        ) from error


def _block(size: int) -> int:
    """Bytes to parse at once: Arrow wants the longest row in one block."""
    return min(max(size, 1), LARGEST_BLOCK)
