"""Lists in cells: their items, and rows that are whole trials as one row a sample."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa

from pointpred.recording import Skip
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray, as_arrow
from pointpred.recordings.trials import Codes, codes_of

PROBE = 200
"""Rows that show what a column holds."""
LEAST_ITEMS = 3
"""Two numbers in a cell may be one with a decimal comma."""
SERIES = ("t", "x", "y", "buttons")
"""The fields of which a cell may hold a list."""
MOST_SHORT = 12
"""With more lists, all of one length below half their number, rows and columns may be mixed up."""
NOTHING = (("", ""), (None, None))
"""Values for missing positions."""
WRAPPED = re.compile(r"np\.(?:float|int)\d+\(([^()]*)\)")
OPENING, CLOSING = "[({", "])}"
MARKS = (";", "|", ",")
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
CALL = re.compile(r"^(?:(?:np\.|numpy\.)?array|c|list)\s*(?=[\[(])")


def split(cell: str | None) -> list[str]:
    """The items of a list in a cell, between commas, semicolons, bars or blanks, with or without brackets.

    numpy's ``np.float64(1.0)`` counts as 1.0; a comma between other marks is a decimal comma.

    >>> split("[1.5, np.float64(2.0)]"), split("1;2,5")
    (['1.5', '2.0'], ['1', '2.5'])
    """
    inner = CALL.sub("", WRAPPED.sub(r"\1", cell or "").strip()).strip(OPENING + CLOSING).strip()
    mark = next((mark for mark in MARKS if mark in inner), None)
    items = [item.strip().strip("'\"") for item in (inner.rstrip(mark).split(mark) if inner else [])]
    return items if mark in (",", None) else [item.replace(",", ".") for item in items]


def is_list(cell: str) -> bool:
    """Whether text is a list: in matching brackets, or several numbers.

    >>> is_list("[7]"), is_list("1 2.5"), is_list("c(1, 2)"), is_list("7"), is_list("[1, 2"), is_list("a, b")
    (True, True, True, False, False, False)
    """
    inner = CALL.sub("", cell.strip())
    opened, closed = inner[:1] in OPENING, inner[-1:] in CLOSING
    if not inner or opened != closed:
        return False
    items = split(cell)
    filled = [item for item in items if item]
    return opened or (len(filled) > 1 and all(NUMBER.fullmatch(item) for item in filled))


def items_of(cell: Any) -> list[Any]:
    """The items of a list cell or of its text; none if it is empty."""
    if not isinstance(cell, str):
        return [] if cell is None else list(cell) if isinstance(cell, list) else [cell]
    return split(cell) if is_list(cell) else [cell] if cell.strip() else []


def holds_lists(column: Any) -> bool:
    """Whether the cells of a column are lists, or text with several numbers."""
    if pa.types.is_list(column.type) or pa.types.is_large_list(column.type):
        return True
    if not arrow_tables.is_words(column):
        return False
    cells = [cell for cell in column.slice(0, PROBE).to_pylist() if cell and cell.strip()]
    return bool(cells) and is_list(cells[0]) and any(map(_is_long, cells))


def _is_long(cell: str) -> bool:
    """Whether a cell is certainly a list: in brackets, or of more than two items."""
    return is_list(cell) and (cell.rstrip()[-1] in CLOSING or len(split(cell)) >= LEAST_ITEMS)


def holds_pairs(column: Any) -> bool:
    """Whether the first cells of a column are lists of two numbers each."""
    cells = [items_of(cell) for cell in column.slice(0, PROBE).to_pylist() if cell]
    numbers = [arrow_tables.finite_numbers(as_arrow([str(item) for item in items])) for items in cells]
    return bool(cells) and all(len(two) == 2 and np.isfinite(two).all() for two, _ in numbers)


def flat(column: Any) -> Any:
    """A column as it is, or the items of its first lists one after another."""
    if not holds_lists(column):
        return column
    return as_arrow([item for cell in column.slice(0, PROBE).to_pylist() for item in items_of(cell)])


class Opened(msgspec.Struct):
    """Lists as one row a sample: the columns of ``SERIES``, the row, user and trial of each sample."""

    series: dict[str, Any]
    rows: IntArray
    user: Codes
    trial: Codes
    skipped: list[Skip]
    notes: list[str]


def open_lists(fields: Mapping[str, Any], row_of: IntArray, one_user: str) -> Opened:
    """One row a sample of rows that are trials; ``fields``: columns of ``SERIES``, of users and of trials.

    ``row_of``: the file's row of each row.

    A row without a list is counted in a note, one whose lists differ in length is a skip. Samples before the
    first position, which some programs leave empty until the pointer moves, are left out and counted, as are
    buttons that are not as many as the samples. A row without a user stays so where others have one.
    """
    cells = {field: column.to_pylist() for field, column in fields.items()}
    count = len(cells["t"])
    named = [_word(cell) for cell in cells.get("user", [None] * count)]
    users = [user or one_user for user in named] if not any(named) else named
    places = row_of.tolist()
    cells.setdefault("trial", [None] * count)
    trials = [_word(cell) or str(place) for place, cell in zip(places, cells["trial"], strict=True)]
    often = Counter(zip(users, trials, strict=True))
    trials = [
        f"{trial} (row {place})" if often[user, trial] > 1 else trial
        for user, trial, place in zip(users, trials, places, strict=True)
    ]
    items: dict[str, list[Any]] = {field: [] for field in SERIES if field in cells}
    rows: list[int] = []
    skipped = []
    empty = before = other = 0
    for row in range(count):
        some = {field: items_of(cells[field][row]) for field in items}
        sizes = [len(some[field]) for field in ("t", "x", "y")]
        if len(set(sizes)) > 1:
            words = "{} times, {} x and {} y, expected as many of each".format(*sizes)
            skipped.append(Skip(trials[row], words, places[row], users[row]))
            continue
        positions = enumerate(zip(some["x"], some["y"], strict=True))
        blank = next((at for at, position in positions if position not in NOTHING), sizes[0])
        before += blank
        empty += blank == sizes[0]
        if len(held := some.get("buttons", [])) != sizes[0]:
            other += bool(held)
            some["buttons"] = [None] * sizes[0]
        for field, column in items.items():
            column += some[field][blank:]
        rows += [row] * (sizes[0] - blank)
    notes = [f"samples before the first position left out: {before}"] if before else []
    notes += [f"rows without lists of times and positions: {empty}"] if empty else []
    notes += [f"rows whose buttons are not as many as their samples, left aside: {other}"] if other else []
    row_of_sample = np.array(rows, dtype=np.int64)
    lengths = np.bincount(row_of_sample, minlength=1)
    lengths = lengths[lengths > 0]
    if len(lengths) > MOST_SHORT and len(set(lengths.tolist())) == 1 and 2 * lengths[0] < len(lengths):
        notes.append(
            f"{len(lengths)} trials of {lengths[0]} samples each: is a column a trial, and a row a sample? "
            "then turn the table"
        )
    user, trial = (codes_of(as_arrow(names)) if names else (row_of_sample, []) for names in (users, trials))
    return Opened(
        {field: as_arrow(column) for field, column in items.items()},
        row_of_sample,
        (user[0][row_of_sample], user[1]),
        (trial[0][row_of_sample], trial[1]),
        skipped,
        notes,
    )


def _word(cell: Any) -> str:
    return "" if cell is None or cell != cell else str(cell).strip()
