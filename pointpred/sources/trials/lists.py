"""Collects trials that a file holds as lists of t, x and y, one list per quantity, into a recording."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings.trials import assemble
from pointpred.records import FloatArray

WRAPPED = re.compile(r"np\.(?:float|int)\d+\(([^()]*)\)")
OPENING, CLOSING = "[({", "])}"
BRACKETS = OPENING + CLOSING
MARKS = (";", "|", ",")
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
CALL = re.compile(r"^(?:(?:np\.|numpy\.)?array|c|list)\s*(?=[\[(])")


def split(cell: str | None) -> list[str]:
    """The items of a list in a cell, between commas, semicolons, bars or blanks, with or without brackets.

    numpy's ``np.float64(1.0)`` counts as 1.0; a comma between other marks is a decimal comma.

    >>> split("[1.5, np.float64(2.0)]"), split("1;2,5")
    (['1.5', '2.0'], ['1', '2.5'])
    """
    inner = CALL.sub("", WRAPPED.sub(r"\1", cell or "").strip()).strip(BRACKETS).strip()
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


class Lists:
    """Trials one after another, each from lists of text or numbers; unreadable ones become skips."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.trials: list[Trial] = []
        self.tables: list[FloatArray] = []
        self.rows: list[int] = []
        self.skipped: list[Skip] = []
        self.row_of: dict[tuple[str, str], int] = {}
        self.notes: list[str] = []

    def skip(self, skip: Skip) -> None:
        """Report a trial that cannot be read."""
        self.skipped.append(skip)

    def numbers(self, cells: Sequence[Any], trial: str, row: int) -> FloatArray | None:
        """The cells as numbers; if one is not, the trial is reported and the answer is ``None``."""
        for place, cell in enumerate(cells):
            try:
                float(cell)
            except (TypeError, ValueError, OverflowError):
                self.skip(Skip(trial, f"sample {place}: {str(cell)[:40]!r} is not a number", row))
                return None
        return np.array([float(cell) for cell in cells], np.float64)

    def add(
        self,
        trial: Trial,
        row: int,
        t: Sequence[object],
        x: Sequence[object],
        y: Sequence[object],
        buttons: Sequence[float] | None = None,
        *,
        scale: float,
        gain: tuple[float, float] = (1.0, 1.0),
    ) -> None:
        """Add a trial: ``scale`` s a unit of time, from its first sample; ``gain`` px a unit of x, y."""
        key = (trial.user, trial.trial)
        if key in self.row_of:
            self.skip(Skip(trial.trial, f"occurs twice, first in row {self.row_of[key]}", row, trial.user))
            return
        if not len(t) == len(x) == len(y):
            words = f"{len(t)} times, {len(x)} x and {len(y)} y, expected as many of each"
            self.skip(Skip(trial.trial, words, row, trial.user))
            return
        columns = []
        for cells in (t, x, y):
            numbers = self.numbers(cells, trial.trial, row)
            if numbers is None:
                return
            columns.append(numbers)
        self.row_of[key] = row
        table = np.full((len(t), 6), np.nan)
        table[:, 5] = 0.0 if buttons is None else buttons
        if len(t):
            with np.errstate(invalid="ignore", over="ignore"):
                table[:, 0] = (columns[0] - columns[0][0]) * scale
                table[:, 1] = columns[1] * gain[0] + 0.0  # no negative zero where an axis is turned
                table[:, 2] = columns[2] * gain[1] + 0.0
        self.trials.append(trial)
        self.tables.append(table)
        self.rows.append(row)

    def recording(self, name: str, provenance: Provenance) -> Recording:
        """The recording of the added trials; a fault's row is the row its trial was added with."""
        sizes = [len(table) for table in self.tables]
        return assemble(
            name,
            np.concatenate([*self.tables, np.empty((0, 6))]),
            np.repeat(np.arange(len(sizes), dtype=np.int64), sizes),
            self.trials,
            skipped=self.skipped,
            provenance=provenance,
            notes=self.notes,
            row_of=np.repeat(np.array(self.rows, dtype=np.int64), sizes),
        )
