"""Which table is meant, of those that a document or a workbook holds."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.columns.names import guess, words_of
from pointpred.recordings.nested_records import LEAST_COLUMNS, RecordTable, Tables, survey
from pointpred.recordings.reading import NEEDED, Reading

CLEAR = 2
"""The largest table is chosen if it has at least so many times the samples of the next."""
MOST_SHOWN = 8
PLACE = re.compile(r"\.\d+$")
"""Of a number in the lists of a column, as in ``pos.0``."""


def table_in(path: Path, document: Any, title: str, reading: Reading) -> ColumnTable:
    """The list of records in a document of the format ``title`` that is meant (``choose``).

    Scalars beside the path that leads to it become columns of equal cells. Notes name what was read and what
    was left out. Raises RecordingError, which names the paths that hold records.
    """
    try:
        tables = survey(document)
        label = choose(tables, reading)
    except RecordingError as error:
        raise RecordingError(f"{path}: {error}") from error
    table = tables.pop(label)
    notes = [f"records: {_rows(table)} {f'at {label}' if label else 'of the whole file'}"]
    if tables:
        notes.append(f"other lists of records left aside: {_list_paths(tables)}")
    if table.deep_fields:
        names = list(dict.fromkeys(name for _, name, _ in table.deep_fields))
        notes.append(f"fields too deep for a cell left aside: {', '.join(names[:MOST_SHOWN])}")
    return ColumnTable(dict(table.columns), title, tuple(notes))


def choose(tables: Tables, reading: Reading) -> str:
    """The name of the only table that has the columns of ``reading``, or t, x and y under usual names.

    Of several, or where none has them, the largest one if it has at least twice the samples of the next;
    raises RecordingError where there is none.
    """
    if not tables:
        raise RecordingError(
            f"no list of records with at least {LEAST_COLUMNS} fields, expected one with times and positions"
        )
    fitting = [label for label, table in tables.items() if _fits(list(table.columns), reading)]
    first, *more = sorted(fitting or tables, key=lambda label: tables[label].samples, reverse=True)
    if more and tables[first].samples < CLEAR * tables[more[0]].samples:
        shown = _list_paths({label: tables[label] for label in fitting or tables})
        raise RecordingError(
            f"records lie at {shown}; save those that are meant as CSV, or name columns that only they have: "
            "--columns t=NAME,x=NAME,y=NAME"
        )
    return first


def _fits(names: Sequence[str], reading: Reading) -> bool:
    """Whether a table has every column that ``reading`` names, and the others of t, x and y as usual."""
    told = reading.columns or {}
    return all(has_column(names, str(column)) for column in told.values()) and (
        {*NEEDED} <= {*told, *guess(names).best}
    )


def has_column(names: Sequence[str], wanted: str) -> bool:
    """Whether a column is ``wanted``, by its name, its place, or as a sum or a part of a list.

    >>> [has_column(["t", "Mouse X", "pos"], wanted) for wanted in ("mouse_x", "2", "t+pos.0", "x")]
    [True, True, True, False]
    """
    alike = [words_of(name) for name in names]
    known = {*names, *map(str, range(len(names)))}
    return wanted in known or all(
        {part, PLACE.sub("", part)} & known or words_of(part) in alike
        for part in map(str.strip, wanted.split("+"))
    )


def _list_paths(tables: Tables) -> str:
    """Paths with the number of their rows and their columns."""
    shown = [
        f"{label or 'the top'} ({_rows(table)}: {', '.join(list(table.columns)[:MOST_SHOWN])})"
        for label, table in list(tables.items())[:MOST_SHOWN]
    ]
    return "; ".join(shown) + (f"; and {len(tables) - MOST_SHOWN} more" if len(tables) > MOST_SHOWN else "")


def _rows(table: RecordTable) -> str:
    return f"{table.rows} row{'s' * (table.rows != 1)}"
