"""The rows of a table as trials: by its own column, or cut without one."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.columns.sample_rows import without_restarts
from pointpred.recordings.encodings import stem_of
from pointpred.recordings.reading import Cut, Reading
from pointpred.recordings.segmentation import PAUSE_S, cut
from pointpred.recordings.trials import TARGET, assemble, codes_of, conditions_of, keys_of, one_value
from pointpred.records import EventColumns, FloatArray

EVENT = ("t", "x", "y", "dx", "dy", "buttons")
LONG_S, GAP_S = 10.0, 1.0
"""A stream that lasts longer, or has a longer step, is cut at pauses; a shorter one is one trial."""


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


class Groups(msgspec.Struct):
    """Trial of each row (-1: none), user and name of each trial, notes on left-out rows and assumptions."""

    group: IntArray
    keys: list[tuple[str, str]]
    conditions: list[dict[str, str | float]]
    skipped: list[Skip] = []
    notes: list[str] = []


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
    for index, field in enumerate(EVENT):
        if field in rows.values:
            table[:, index] = rows.values[field]
    users, one_user = keys.get("user"), stem_of(path)
    if "trial" in keys:
        groups = _by_column(rows, users, keys["trial"], one_user, others)
        if reading.cut is not None:
            groups.notes.append(f"cut {reading.cut!r} has no effect: the table has a column for trials")
    else:
        groups = _cut(rows, table, users, one_user, reading)
    members = np.flatnonzero(groups.group >= 0)
    group, table = groups.group[members], table[members]
    first = np.full(len(groups.keys), np.nan)
    first[group[::-1]] = table[::-1, 0]
    table[:, 0] = (table[:, 0] - first[group]) / rows.per_second
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
        if field in rows.values and _holds_more(rows.values[field][members], group, values)
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
    faulty = np.array(sorted(rows.faults), dtype=np.int64)
    faulty = faulty[groups.group[faulty] >= 0]
    return assemble(
        stem_of(path),
        table,
        group,
        trials,
        skipped=(*skipped, *groups.skipped),
        faults={
            int(at): rows.faults[int(row)]
            for at, row in zip(np.searchsorted(members, faulty), faulty, strict=True)
        },
        unusable=_bad_widths(targets[-1]),
        provenance=provenance,
        row_of=rows.row_of[members],
        notes=(*notes, *groups.notes),
    )


def _by_column(rows: Rows, users: Any, trials: Any, one_user: str, others: dict[str, Any]) -> Groups:
    """Trials as named in the table, restarts separated; rows outside trials are left out and counted."""
    if users is None:
        user_codes, user_names = np.zeros(rows.count, dtype=np.int64), [one_user]
    else:
        user_codes, user_names = codes_of(users.fill_null(""))
    (trial_codes, trial_names), restarts = without_restarts(user_codes, trials, rows.values["t"], others)
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
    groups = Groups(np.full(rows.count, -1, dtype=np.int64), [], [])
    methods: dict[str, int] = {}
    restarts = 0
    for code, user in enumerate(names):
        mine = np.flatnonzero((codes == code) & usable)
        if not len(mine):
            continue
        events = table[mine].copy()
        events[:, 0] = (events[:, 0] - events[0, 0]) / rows.per_second
        back = np.flatnonzero(np.diff(events[:, 0]) < 0) + 1
        restarts += len(back)
        parts = np.split(np.arange(len(mine)), back)
        how = reading.cut or _method(events, parts)
        methods[how] = methods.get(how, 0) + 1
        named = user or one_user
        for part in parts:
            _cut_part(groups, rows, mine[part], EventColumns(events[part]), how, named, reading)
    groups.notes += _assumptions(users is None, one_user, methods, reading, len(groups.keys))
    if restarts:
        groups.notes.append(f"time starts anew in {restarts} rows: cut there")
    out = int(np.count_nonzero(~usable))
    if out:
        row = int(np.flatnonzero(~usable)[0])
        why = rows.faults.get(row, "t, x or y is empty or too large")
        groups.notes.append(f"rows left out: {out}, the first is data row {rows.row_of[row]}: {why}")
    return groups


def _cut_part(
    groups: Groups, rows: Rows, mine: IntArray, events: EventColumns, how: Cut, user: str, reading: Reading
) -> None:
    """Cut the rows ``mine`` and add their trials and skips."""
    for piece in cut(events, how, reading):
        some = mine[piece.start : piece.stop]
        first, last = int(rows.row_of[some[0]]), int(rows.row_of[some[-1]])
        if piece.reason:
            groups.skipped.append(Skip(f"rows {first} to {last}", piece.reason, first, user))
            continue
        groups.group[some] = len(groups.keys)
        number = sum(1 for key in groups.keys if key[0] == user)
        groups.keys.append((user, str(number)))
        groups.conditions.append({"begins_s": float(events.t[piece.start])})


def _method(events: FloatArray, parts: Sequence[NDArray[np.int64]]) -> Cut:
    """How a stream is cut by default."""
    if np.any(events[:, 5] > 0):
        return "clicks"
    spans = [events[part[-1], 0] - events[part[0], 0] for part in parts]
    steps = np.diff(events[:, 0])
    return "bursts" if max(spans) > LONG_S or np.any(steps > GAP_S) else "whole"


def _assumptions(one: bool, user: str, methods: dict[str, int], reading: Reading, trials: int) -> list[str]:
    """Notes on assumptions about users and trials."""
    notes = [f"one user, {user!r}: no column for users"] if one else []
    words = {
        "clicks": "cut at clicks",
        "bursts": f"cut at pauses of {PAUSE_S:g} s",
        "whole": "one trial",
    }
    how = " or ".join(words[method] for method in methods)
    return [*notes, f"no column for trials: {how}" + ("" if trials == 1 else f"; {trials} trials")]


def _holds_more(values: FloatArray, group: IntArray, of_trial: FloatArray) -> bool:
    """Whether a trial without a single value has any values."""
    return bool((np.isfinite(values) & np.isnan(of_trial)[group]).any())


def _bad_widths(widths: FloatArray) -> dict[int, str]:
    """The trials whose target has an impossible width."""
    return {
        int(index): f"target_w is {widths[index]}, expected above 0 px"
        for index in np.flatnonzero(widths <= 0)
    }
