"""The rows of a table as trials: by its own column, where trial numbers may restart, or cut without one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow.compute as pc
from numpy.typing import NDArray

from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.columns.names import parts_of_study
from pointpred.recordings.encodings import stem_of
from pointpred.recordings.reading import Cut, Reading
from pointpred.recordings.segmentation import PAUSE_S, Groups
from pointpred.recordings.trials import (
    TARGET,
    Codes,
    codes_of,
    conditions_of,
    in_order,
    keys_of,
    one_value,
)
from pointpred.records import EVENT_FIELDS, EventColumns, FloatArray

LONG_S, GAP_S = 10.0, 1.0
"""A stream that lasts longer, or has a longer step, is cut at pauses; a shorter one is one trial."""
CUTS = {"clicks": "cut at clicks", "bursts": f"cut at pauses of {PAUSE_S:g} s", "whole": "one trial"}
JOINTS = "+|/;"
"""Separators of joined columns: the first that occurs in no cell is used."""


class Rows(msgspec.Struct):
    """The samples of a table as numbers: ``values`` by field, in px but for the clock.

    ``row_of``: the file's row of each; ``faults``: the fault of a row; ``per_second``: units of the clock in
    a second.
    """

    count: int
    row_of: IntArray
    values: dict[str, FloatArray] = {}
    faults: dict[int, str] = {}
    per_second: float = 1.0

    def blame(self, field: str, name: str, wrong: dict[int, str], expected: str) -> None:
        """Add the cells of a column that cannot be read."""
        called = field if field == name else f"{field} ({name})"
        for row, cell in wrong.items():
            self.faults.setdefault(row, f"{called} is {cell!r}, expected {expected}")


def recording_of_rows(
    path: Path,
    rows: Rows,
    keys: dict[str, Any],
    others: dict[str, Any],
    reading: Reading,
    *,
    provenance: Provenance,
    skipped: Sequence[Skip],
    notes: Sequence[str],
) -> Recording:
    """The trials of a table: ``keys`` are its columns user and trial, if present.

    Without users there is one, named after the file. Columns in ``others`` that have one value in each trial
    become conditions. Time starts at 0 in each trial.
    """
    table = np.full((rows.count, 6), np.nan)
    table[:, 5] = 0.0
    for index, field in enumerate(EVENT_FIELDS):
        if field.name in rows.values:
            table[:, index] = rows.values[field.name]
    users, one_user = keys.get("user"), stem_of(path)
    if "trial" in keys:
        groups = _by_column(rows, users, keys["trial"], one_user, others, reading.sort)
        if reading.cut is not None:
            groups.notes.append(f"cut {reading.cut!r} has no effect: the table has a column for trials")
    else:
        groups = _cut(rows, table, users, one_user, reading)
    members = np.flatnonzero(groups.group >= 0)
    group = groups.group[members]
    sizes = len(groups.keys)
    targets = [
        one_value(rows.values[field][members], group, sizes)
        if field in rows.values
        else np.full(sizes, np.nan)
        for field in TARGET
    ]
    unclear = [
        field
        for field, values in zip(TARGET, targets, strict=True)
        if field in rows.values and (np.isfinite(rows.values[field][members]) & np.isnan(values)[group]).any()
    ]
    if unclear:
        groups.notes.append(f"targets that vary within a trial are left unknown: {', '.join(unclear)}")
    known, varying = conditions_of({name: (column, members) for name, column in others.items()}, group, sizes)
    trials = [
        Trial(
            *key,
            target_x=float(targets[0][index]),
            target_y=float(targets[1][index]),
            target_w=float(targets[2][index]),
            condition=known[index] | groups.conditions[index],
        )
        for index, key in enumerate(groups.keys)
    ]
    if varying:
        groups.notes.append(f"columns left aside, for they vary within a trial: {', '.join(varying)}")
    return groups.recording(
        stem_of(path),
        table,
        trials,
        rows.per_second,
        row_of=rows.row_of,
        faults=rows.faults,
        skipped=skipped,
        unusable={
            int(index): f"target_w is {targets[-1][index]}, expected above 0 px"
            for index in np.flatnonzero(targets[-1] <= 0)
        },
        provenance=provenance,
        sort=reading.sort or "trial" not in keys,  # a stream was cut where its time starts anew
        notes=notes,
    )


def _by_column(
    rows: Rows, users: Any, trials: Any, one_user: str, others: dict[str, Any], sort: bool
) -> Groups:
    """Trials as named in the table, restarts separated; rows outside trials are left out and counted."""
    if users is None:
        user_codes, user_names = np.zeros(rows.count, dtype=np.int64), [one_user]
    else:
        user_codes, user_names = codes_of(users.fill_null(""))
    (trial_codes, trial_names), restarts = without_restarts(
        user_codes, trials, rows.values["t"], others, sort
    )
    named = np.array([bool(name.strip()) for name in trial_names] or [True])[trial_codes]
    if users is not None:
        named &= np.array([bool(name.strip()) for name in user_names] or [True])[user_codes]
    members = np.flatnonzero(named)
    group = np.full(rows.count, -1, dtype=np.int64)
    group[members], keys = keys_of((user_codes[members], user_names), (trial_codes[members], trial_names))
    notes = [] if users is not None else [f"one user, {one_user!r}: no column for users"]
    notes += restarts
    out = rows.count - len(members)
    if out:
        at = rows.row_of[np.flatnonzero(~named)[0]]
        notes.append(f"rows without user or trial left out: {out}, the first is data row {at}")
    return Groups(group, keys, [{} for _ in keys], notes=notes)


def _cut(rows: Rows, table: FloatArray, users: Any, one_user: str, reading: Reading) -> Groups:
    """One stream per user, cut according to ``reading``, else at clicks if there are any, else at pauses."""
    codes, names = (np.zeros(rows.count, dtype=np.int64), [one_user])
    if users is not None:
        codes, names = codes_of(users.fill_null(""))
    usable = np.isfinite(table[:, :3]).all(axis=1)
    groups = Groups(np.full(rows.count, -1, dtype=np.int64))
    methods: dict[str, int] = {}
    restarts = 0
    for code, user in enumerate(names):
        mine = np.flatnonzero((codes == code) & usable)
        if not len(mine):
            continue
        events = table[mine].copy()
        events[:, 0] = (events[:, 0] - events[0, 0]) / rows.per_second
        order, anew, _ = in_order(events[:, 0], reading.sort)
        restarts += len(anew)
        mine, events = mine[order], events[order]
        parts = np.split(np.arange(len(mine)), anew)
        how = reading.cut or _method(events, parts)
        methods[how] = methods.get(how, 0) + 1
        named = user or one_user
        for part in parts:
            stream = EventColumns(events[part])
            groups.add_stream(mine[part], stream, how, reading, rows.row_of, named, of=named)
    if users is None:
        groups.notes.append(f"one user, {one_user!r}: no column for users")
    cuts = " or ".join(CUTS[method] for method in methods)
    count = "" if len(groups.keys) == 1 else f"; {len(groups.keys)} trials"
    groups.notes.append(f"no column for trials: {cuts}{count}")
    if restarts:
        groups.notes.append(f"time starts anew in {restarts} rows: cut there")
    out = int(np.count_nonzero(~usable))
    if out:
        row = int(np.flatnonzero(~usable)[0])
        why = rows.faults.get(row, "t, x or y is empty or too large")
        groups.notes.append(f"rows left out: {out}, the first is data row {rows.row_of[row]}: {why}")
    return groups


def _method(events: FloatArray, parts: Sequence[NDArray[np.int64]]) -> Cut:
    """How a stream is cut by default."""
    if np.any(events[:, 5] > 0):
        return "clicks"
    spans = [events[part[-1], 0] - events[part[0], 0] for part in parts]
    steps = np.diff(events[:, 0])
    return "bursts" if max(spans) > LONG_S or np.any(steps > GAP_S) else "whole"


def join_columns(columns: list[Any]) -> Any:
    """The words of several columns as one column, such as ``2+7``; null if one of them is empty."""
    words = [pc.utf8_trim_whitespace(arrow_tables.words(column)) for column in columns]
    words = [pc.if_else(pc.equal(column, ""), None, column) for column in words]
    taken = {mark for mark in JOINTS for column in words if pc.any(pc.match_substring(column, mark)).as_py()}
    mark = next((mark for mark in JOINTS if mark not in taken), " ++ ")
    return pc.binary_join_element_wise(*words, mark, null_handling="emit_null")


def without_restarts(
    user: IntArray, column: Any, clock: FloatArray, others: Mapping[str, Any], sort: bool = False
) -> tuple[Codes, list[str]]:
    """The trial of each row by the ``column`` of trials, with restarts separated; and notes on assumptions.

    If a trial of a user has several runs of rows, a usual column such as ``block`` that separates them is
    joined to the trial. Without one, a run that begins before the end of the last one is a separate trial,
    named ``trial (2)`` and so on, unless rows are to be sorted. Rows without a trial (empty text) stay so.
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
    return (trials, []) if sort else _split(trials, runs, clock[order], order)


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
            name = f"{names[which[0]]} ({which[1] + 1})"
            while name in taken:  # a trial has this name already
                name += "'"
            taken.add(name)
            names.append(name)
        code[rows] = codes[which]
    note = f"trial numbers restart: {int(again.sum())} runs of rows are trials of their own, as 'trial (2)'"
    return (code, names), [note]
