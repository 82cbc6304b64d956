"""Conditions and users of a file with a trial in each row."""

from __future__ import annotations

from collections.abc import Container, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.recordings.columns.names import guess
from pointpred.recordings.encodings import stem_of
from pointpred.recordings.trials import MOST, is_condition

SHOWN = 5
LONGEST = 100
"""A column with a longer cell is not a condition but a track, a page or an answer."""


def row_conditions(
    rows: Sequence[dict[str, Any]], aside: Container[str | None] = ()
) -> tuple[list[dict[str, str | float]], list[str]]:
    """The conditions in each row: columns of short text or numbers that are not in ``aside``; and notes.

    Numbers stay numbers if every cell of a column is one; an empty cell is not a condition. At most 64
    columns are used, varying ones first; a note names the others.

    >>> row_conditions([{"block": "1", "cue": "left"}, {"block": "2", "cue": ""}])
    ([{'block': 1.0, 'cue': 'left'}, {'block': 2.0}], [])
    """
    columns = {name: [row.get(name) for row in rows] for row in rows for name in row if name not in aside}
    filled = {name: cells for name, cells in columns.items() if not all(map(_empty, cells))}
    fitting = [name for name, cells in filled.items() if is_condition(name) and all(map(_short, cells))]
    fitting.sort(key=lambda name: len({str(cell) for cell in filled[name]}) == 1)
    taken = set(fitting[:MOST])
    conditions: list[dict[str, str | float]] = [{} for _ in rows]
    for name in [name for name in filled if name in taken]:
        numbers = [_number(cell) for cell in filled[name] if not _empty(cell)]
        for row, cell in zip(conditions, filled[name], strict=True):
            if not _empty(cell):
                number = _number(cell)
                row[name] = str(cell) if number is None or None in numbers else number
    skipped = [name for name in filled if name not in taken]
    more = f" and {len(skipped) - SHOWN} more" if len(skipped) > SHOWN else ""
    return conditions, [f"columns left aside: {', '.join(skipped[:SHOWN])}{more}"] if skipped else []


def people_of(
    path: Path, rows: Sequence[dict[str, Any]], usual: Sequence[str]
) -> tuple[list[str], str | None, list[str]]:
    """The user of each row, the column with the users, and notes: without one, the file has one user.

    The column is the first of ``usual`` in the file, or one with a usual name. A row with an empty cell
    belongs to the first user in the file.
    """
    names = list(dict.fromkeys(name for row in rows for name in row))
    column = next((name for name in usual if name in names), None) or guess(names).best.get("user")
    cells = [] if column is None else [str(row.get(column) or "").strip() for row in rows]
    first = next(filter(None, cells), "")
    if first:
        return [cell or first for cell in cells], column, []
    stem = stem_of(path)
    return [stem] * len(rows), column, [f"one person, called {stem!r} after the file: no column names one"]


def _short(cell: Any) -> bool:
    """Whether a cell may be a condition's: neither long, nor a list or an object."""
    if isinstance(cell, str) and cell.lstrip().startswith(("[", "{")):
        return False
    return cell is None or (isinstance(cell, str | float | int) and len(str(cell)) <= LONGEST)


def _empty(cell: Any) -> bool:
    return cell is None or (isinstance(cell, str) and not cell.strip())


def _number(cell: Any) -> float | None:
    """A cell as a finite number, else ``None``."""
    try:
        number = float(cell)
    except (ValueError, OverflowError):
        return None
    return number if np.isfinite(number) else None
