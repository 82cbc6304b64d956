"""Trial numbers that restart, as in every block: each run of rows becomes a separate trial."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations
from typing import Any

import numpy as np
import pyarrow.compute as pc

from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.columns.names import parts_of_study
from pointpred.recordings.trials import Codes, codes_of
from pointpred.records import FloatArray

JOINTS = "+|/;"
"""Separators of joined columns: the first that occurs in no cell is used."""


def join_columns(columns: list[Any]) -> Any:
    """The words of several columns as one column, such as ``2+7``; null if one of them is empty."""
    words = [pc.utf8_trim_whitespace(arrow_tables.words(column)) for column in columns]
    words = [pc.if_else(pc.equal(column, ""), None, column) for column in words]
    mark = next((mark for mark in JOINTS if not any(_holds(column, mark) for column in words)), " ++ ")
    return pc.binary_join_element_wise(*words, mark, null_handling="emit_null")


def without_restarts(
    user: IntArray, column: Any, clock: FloatArray, others: Mapping[str, Any]
) -> tuple[Codes, list[str]]:
    """The trial of each row by the ``column`` of trials, with restarts separated; and notes on assumptions.

    If a trial of a user has several runs of rows, a usual column such as ``block`` that separates them is
    joined to the trial. Without one, a run that begins before the end of the last one is a separate trial,
    named ``trial (2)`` and so on. Rows without a trial (empty text) stay so.
    """
    trials = codes_of(column.fill_null(""))
    order = np.argsort(user, kind="stable")
    runs = _Runs(user, trials, order)
    if runs.single:
        return trials, []
    usual = parts_of_study(list(others))
    for names in (*combinations(usual, 1), *combinations(usual, 2)):
        joint = codes_of(join_columns([*(others[name] for name in names), column]).fill_null(""))
        if _separates(_Runs(user, joint, order), runs, clock[order]):
            return joint, [f"trial numbers restart: {' and '.join(names)} joined to the trial"]
    return _split(trials, runs, clock[order], order)


class _Runs:
    """The runs of rows of one trial, in the order of rows of each user."""

    def __init__(self, user: IntArray, trials: Codes, order: IntArray) -> None:
        code, names = trials
        self.key = (user * max(len(names), 1) + code)[order]
        starts = np.flatnonzero(np.diff(self.key, prepend=-1))
        ends = np.append(starts[1:], len(order)) - 1
        named = np.array([bool(name.strip()) for name in names] or [True])[code[order[starts]]]
        self.starts, self.ends = starts[named], ends[named]
        self.named = int(np.sum(self.ends - self.starts + 1))
        self.keys = self.key[self.starts]

    @property
    def single(self) -> bool:
        """Whether each trial has one run."""
        return len(np.unique(self.keys)) == len(self.keys)


def _separates(joint: _Runs, runs: _Runs, clock: FloatArray) -> bool:
    """Whether joined trials have one run each and cut runs only where time goes backwards."""
    more = np.setdiff1d(joint.starts, runs.starts)
    return joint.single and joint.named == runs.named and bool(np.all(clock[more] < clock[more - 1]))


def _split(trials: Codes, runs: _Runs, clock: FloatArray, order: IntArray) -> tuple[Codes, list[str]]:
    """The trials with a new one for each run that begins before the end of the run before."""
    by_key = np.argsort(runs.keys, kind="stable")
    starts, ends, keys = runs.starts[by_key], runs.ends[by_key], runs.keys[by_key]
    again = np.zeros(len(keys), dtype=np.int64)
    again[1:] = (keys[1:] == keys[:-1]) & (clock[starts[1:]] < clock[ends[:-1]])
    if not again.any():
        return trials, []
    total = np.cumsum(again)
    part = total - total[np.searchsorted(keys, keys)]
    code, names = trials[0].copy(), list(trials[1])
    codes: dict[tuple[int, int], int] = {}
    taken = set(names)
    for at in np.flatnonzero(part).tolist():
        rows = order[starts[at] : ends[at] + 1]
        which = (int(code[rows[0]]), int(part[at]))
        if which not in codes:
            codes[which] = len(names)
            names.append(_free(f"{names[which[0]]} ({which[1] + 1})", taken))
        code[rows] = codes[which]
    note = f"trial numbers restart: {int(again.sum())} runs of rows are trials of their own, as 'trial (2)'"
    return (code, names), [note]


def _free(name: str, taken: set[str]) -> str:
    """An unused name: primed if a trial has it."""
    while name in taken:
        name += "'"
    taken.add(name)
    return name


def _holds(column: Any, mark: str) -> bool:
    return bool(pc.any(pc.match_substring(column, mark), min_count=0).as_py())
