"""Workbooks ``.xlsx``, as Gorilla exports them: the sheet that holds a table."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import time, timedelta
from pathlib import Path
from typing import Any
from zipfile import ZipFile

from pointpred.errors import RecordingError
from pointpred.extras import require
from pointpred.recordings.arrow_tables import ColumnTable, distinct_names, unreadable
from pointpred.recordings.nested_records import LEAST_COLUMNS, RecordTable
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.table_choice import choose

TITLE = "workbook .xlsx"
ZIP, PART = b"PK\x03\x04", b"xl/"
MOST_UNPACKED = 1 << 29
MOST_ROWS = 1 << 20
"""Most rows of an Excel sheet."""
SHEET = "sheet"
"""The column with each row's sheet if several are one table."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a workbook in the Office Open XML format."""
    return head.startswith(ZIP) and PART in head


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read the sheet that is meant (``table_choice``) of those with at least three columns.

    Sheets with the same columns are one table, with their names in the column ``sheet``.

    The first row with three cells names the columns; if it contains only numbers, they are numbered from 0.
    Empty rows are left out. Formulas have the values saved with the file.
    Raises RecordingError, also above 512 MiB of unpacked sheets; MissingExtraError.
    """
    require("tables", f"{path}: reading a workbook")
    try:
        with _opened(path) as book:
            return _sheet(book.worksheets, reading)
    except RecordingError as error:
        raise RecordingError(f"{path}: {error}") from error
    except MemoryError as error:  # the file need not be damaged
        raise unreadable(path, error) from error
    except Exception as error:  # openpyxl raises errors of many kinds on damaged bytes
        raise RecordingError(f"{path}: damaged workbook: {str(error)[:120]}") from error


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    from openpyxl import load_workbook

    with ZipFile(path) as file:
        size = sum(part.file_size for part in file.infolist())
    if size > MOST_UNPACKED:
        raise RecordingError(f"{size} bytes when unpacked, at most {MOST_UNPACKED} are read")
    # an open file, because openpyxl checks the extension of a path
    with warnings.catch_warnings(), path.open("rb") as content:
        warnings.simplefilter("ignore")  # warnings about styles and extensions without cells
        book = load_workbook(content, read_only=True, data_only=True, keep_links=False)
        try:
            yield book
        finally:
            book.close()


def _sheet(sheets: list[Any], reading: Reading) -> ColumnTable:
    """The sheet that is meant, or all those with the same columns."""
    alike: dict[tuple[str, ...], dict[str, RecordTable]] = {}
    for sheet in sheets:
        table = _table(sheet)
        if len(table.columns) >= LEAST_COLUMNS and table.rows:
            alike.setdefault(tuple(table.columns), {})[sheet.title] = table
    titles = {", ".join(map(repr, some)): list(some) for some in alike.values()}
    tables = dict(zip(titles, map(_joined, alike.values()), strict=True))
    if not tables:
        where = ", ".join(sheet.title for sheet in sheets)
        raise RecordingError(f"no table of {LEAST_COLUMNS} columns or more in the sheets {where}")
    chosen = choose(tables, reading)
    several = len(titles[chosen]) > 1
    note = f"records: {tables[chosen].rows} rows of the sheet{'s' * several} {chosen}"
    note += f"; the column {SHEET} names them" * several
    others = [sheet.title for sheet in sheets if sheet.title not in titles[chosen]]
    note += f"; other sheets left aside: {', '.join(others)}" if others else ""
    return ColumnTable(dict(tables[chosen].columns), TITLE, (note,))


def _joined(tables: dict[str, RecordTable]) -> RecordTable:
    """The rows of sheets one after another, with the name of their sheet if they are several."""
    whole = RecordTable()
    for title, table in tables.items():
        whole.append(table, {SHEET: title} if len(tables) > 1 else {})
    return whole


def _table(sheet: Any) -> RecordTable:
    """The cells of a sheet below the row that names its columns."""
    sheet.reset_dimensions()  # the size stored in a file may be wrong
    table = RecordTable()
    titles: list[str] = []
    for number, row in enumerate(sheet.iter_rows(values_only=True)):
        if number >= MOST_ROWS:
            raise RecordingError(f"the sheet {sheet.title!r} has more than {MOST_ROWS} rows")
        cells = {at: _cell(value) for at, value in enumerate(row) if value is not None}
        if not titles:
            if len(cells) < LEAST_COLUMNS:
                continue
            titles = _titles(cells)
            table.columns = {title: [] for title in titles}
            if any(isinstance(cell, str) for cell in cells.values()):
                continue
        if cells:
            table.add({titles[at] if at < len(titles) else str(at): cell for at, cell in cells.items()})
    return table.finish()


def _titles(cells: dict[int, Any]) -> list[str]:
    """A name for each column up to the last of the first row: its text, else its place from 0."""
    names = [cells.get(at) for at in range(max(cells) + 1)]
    return distinct_names([name if isinstance(name, str) else str(at) for at, name in enumerate(names)])


def _cell(value: Any) -> Any:
    if isinstance(value, timedelta):
        return value.total_seconds()
    return value.isoformat() if isinstance(value, time) else value
