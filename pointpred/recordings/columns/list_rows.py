"""Tables whose rows are whole trials: their cells hold the lists of times and positions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from pointpred.recording import UNKNOWN, Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.columns.buttons import pressed
from pointpred.recordings.encodings import stem_of
from pointpred.recordings.trials import (
    CLOSING,
    TARGET,
    Lists,
    condition_name,
    is_list,
    split,
)

LONGEST_CONDITION = 200
"""Longer cells of other columns are not conditions."""
PROBE = 200
"""Rows whose steps determine the unit of time."""
LEAST_ITEMS = 3
"""Two numbers in a cell may be one with a decimal comma."""
SERIES = ("t", "x", "y", "buttons")

NOTHING = (("", ""), (None, None))
"""Values for missing positions."""
Column = Callable[[str], Any]


def holds_lists(column: Any) -> bool:
    """Whether the cells of a column are lists, or text with several numbers."""
    if pa.types.is_list(column.type) or pa.types.is_large_list(column.type):
        return True
    if not arrow_tables.is_words(column):
        return False
    cells = [cell for cell in column.slice(0, PROBE).to_pylist() if cell and cell.strip()]
    return bool(cells) and is_list(cells[0]) and any(map(_is_long, cells))


def holds_pairs(column: Any) -> bool:
    """Whether the first cells of a column are lists of two numbers each."""
    cells = [items_of(cell) for cell in column.slice(0, PROBE).to_pylist() if cell]
    return bool(cells) and all(
        len(items) == 2 and not np.isnan([*map(_number, items)]).any() for items in cells
    )


def _is_long(cell: str) -> bool:
    """Whether a cell is certainly a list: in brackets, or of more than two items."""
    return is_list(cell) and (cell.rstrip()[-1] in CLOSING or len(split(cell)) >= LEAST_ITEMS)


def steps_of(column: Any) -> Any:
    """The times of the first rows concatenated, to determine their unit."""
    lists = [items_of(cell) for cell in column.slice(0, PROBE).to_pylist()]
    return np.array([_number(item) for items in lists for item in items])


def recording_of_lists(
    path: Path,
    columns: Column,
    mapping: dict[str, str],
    others: Sequence[str],
    *,
    per_second: float,
    gain: tuple[float, float],
    provenance: Provenance,
    skipped: Sequence[Skip],
    notes: Sequence[str],
    sort: bool,
) -> Recording:
    """One trial per row: ``mapping`` names the columns; those in ``others`` become conditions.

    A row without a list is counted in a note, one whose lists differ in length is a skip. Samples before the
    first position, which some programs leave empty until the pointer moves, are left out and counted.
    """
    cells = {field: columns(name).to_pylist() for field, name in mapping.items()}
    for field in TARGET:
        cells.setdefault(field, [UNKNOWN] * len(cells["t"]))
    conditions = {name: columns(name).to_pylist() for name in others if not holds_lists(columns(name))}
    lists = Lists(sort)
    lists.skipped += skipped
    lists.notes += notes
    if "user" not in mapping:
        lists.notes.append(f"one user, {stem_of(path)!r}: no column for users")
    if "trial" not in mapping:
        lists.notes.append("a trial a row, named after it: no column for trials")
    count = len(cells["t"])
    users = [_word(cell) or stem_of(path) for cell in cells.get("user", [None] * count)]
    trials = [_word(cell) or str(row) for row, cell in enumerate(cells.get("trial", [None] * count))]
    often = Counter(zip(users, trials, strict=True))
    empty = before = 0
    for row in range(count):
        series = {field: items_of(cells[field][row]) for field in SERIES if field in cells}
        blank = _blank(series)
        before += blank
        series = {field: items[blank:] for field, items in series.items()}
        if not any(series[field] for field in ("t", "x", "y")):
            empty += 1
            continue
        name = trials[row] if often[users[row], trials[row]] == 1 else f"{trials[row]} (row {row})"
        lists.add(
            Trial(
                users[row],
                name,
                target_x=_number(cells["target_x"][row]) * gain[0],
                target_y=_number(cells["target_y"][row]) * gain[1],
                target_w=_number(cells["target_w"][row]) * gain[0],
                condition=_condition({column: values[row] for column, values in conditions.items()}),
            ),
            row,
            _from_first(series["t"]),
            series["x"],
            series["y"],
            _buttons(series),
            scale=1.0 / per_second,
            gain=gain,
        )
    if before:
        lists.notes.append(f"samples before the first position left out: {before}")
    if empty:
        lists.notes.append(f"rows without lists of times and positions: {empty}")
    unread = [name for name in others if name not in conditions]
    if unread:
        lists.notes.append(f"columns left aside, for they hold lists: {', '.join(unread)}")
    return lists.recording(stem_of(path), provenance)


def items_of(cell: Any) -> list[Any]:
    """The items of a list cell or of its text; none if it is empty."""
    if not isinstance(cell, str):
        return [] if cell is None else list(cell) if isinstance(cell, list) else [cell]
    return split(cell) if is_list(cell) else [cell] if cell.strip() else []


def _blank(series: dict[str, list[Any]]) -> int:
    """Number of samples before the first position; 0 if the lists differ in length."""
    xs, ys = series["x"], series["y"]
    if not len(series["t"]) == len(xs) == len(ys):
        return 0
    places = (place for place, both in enumerate(zip(xs, ys, strict=True)) if both not in NOTHING)
    return next(places, len(xs))


def _from_first(times: Sequence[Any]) -> Sequence[Any]:
    """Integer times relative to the first: a float would round times since 1970."""
    try:
        whole = [int(time) if isinstance(time, str) else time for time in times]
    except ValueError:
        return times
    return [time - whole[0] for time in whole] if all(type(time) is int for time in whole) else times


def _buttons(series: dict[str, list[Any]]) -> list[float] | None:
    """The buttons of each sample; ``None`` if there are none, or not as many as times."""
    items = series.get("buttons", [])
    values = [pressed(item) if isinstance(item, str) else _number(item) for item in items]
    fits = len(values) == len(series["t"]) and all(value == value for value in values)
    return values if values and fits else None


def _word(cell: Any) -> str:
    return "" if cell is None else str(cell).strip()


def _number(cell: Any) -> float:
    """A cell as a number, else NaN."""
    try:
        return float(cell)
    except (TypeError, ValueError):
        return float("nan")


def _condition(cells: dict[str, Any]) -> dict[str, str | float]:
    """The cells of other columns, numbers as numbers; empty and long cells are left out."""
    conditions: dict[str, str | float] = {}
    for name, cell in cells.items():
        word = _word(cell)
        number = _number(cell)
        if word and len(word) <= LONGEST_CONDITION:
            conditions[condition_name(name)] = number if abs(number) < float("inf") else word
    return conditions
