"""Samples as a reader found them, and the one way from samples to trials: by name, or cut without one."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations, pairwise
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa

from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.columns.names import parts_of_study
from pointpred.recordings.reading import Cut, Reading
from pointpred.recordings.segmentation import PAUSE_S, cut
from pointpred.recordings.trials import (
    TARGET,
    TRIAL_COLUMNS,
    Codes,
    assemble,
    codes_of,
    in_order,
    keys_of,
)
from pointpred.records import EventColumns, FloatArray

LONG_S, GAP_S = 10.0, 1.0
"""A stream that lasts longer, or has a longer step, is cut at pauses; a shorter one is one trial."""
CUTS = {"clicks": "cut at clicks", "bursts": f"cut at pauses of {PAUSE_S:g} s", "whole": "one trial"}
PROBE = 1000
"""Rows compared first: most varying columns differ within them."""
MOST = 64
"""Most columns that become conditions; of more, those that differ between trials."""
LONGEST = 200
"""A column with longer text holds a track, a page or an answer, and no condition."""
SHOWN = 8
Condition = dict[str, str | float]


class Samples(msgspec.Struct, kw_only=True):
    """What a reader found in a file: samples one after another, and what the file says of them.

    ``table``: a row a sample, as in ``EventColumns``, px, but for the time in ``per_second`` units a second.
    ``row_of``: the file's row of each. ``user`` and ``trial`` by their codes, "" where a sample has none;
    ``None`` where the file names none: there is one user, ``one_user``, or a stream to be cut, by default as
    ``cut`` says. ``parts``: a number for each sample; where it changes, a stream begins anew. ``columns``
    become conditions where they have one value in each trial; ``cells`` is the row of them that belongs to
    each sample, ``None`` if it is the sample's. ``targets``: columns target_x, target_y, target_w in px,
    NaN where unknown. ``condition``: of every trial. ``faults``: what is wrong with a sample.
    """

    name: str
    table: FloatArray
    row_of: IntArray
    provenance: Provenance
    one_user: str
    per_second: float = 1.0
    user: Codes | None = None
    trial: Codes | None = None
    cut: Cut | None = None
    parts: IntArray | None = None
    columns: dict[str, Any] = {}
    cells: IntArray | None = None
    targets: FloatArray | None = None
    condition: Condition = {}
    faults: dict[int, str] = {}
    skipped: list[Skip] = []
    notes: list[str] = []

    @property
    def users(self) -> Codes:
        """The user of each sample."""
        return self.user or (np.zeros(len(self.table), dtype=np.int64), [self.one_user])

    def sort(self, order: IntArray) -> None:
        """Put the samples in another order, in which each place keeps its user."""
        if not np.any(np.diff(order) < 0):
            return
        self.table, self.row_of = self.table[order], self.row_of[order]
        self.cells = order if self.cells is None else self.cells[order]
        self.targets = None if self.targets is None else self.targets[order]
        at = np.argsort(order)
        self.faults = {int(at[row]): words for row, words in self.faults.items()}


class Groups(msgspec.Struct):
    """The trial of each sample (-1: none), and the user, name and begin of each trial."""

    group: IntArray
    keys: list[tuple[str, str]] = []
    begins: list[Condition] = []


def recording_of(samples: Samples, reading: Reading) -> Recording:
    """The trials of some samples, by name or cut according to ``reading``; time starts at 0 in each.

    A column with one value in each trial is a condition, numbers if all its cells are. What is left out, or
    assumed, is in notes; a trial that cannot be used is a skip (``assemble``).
    """
    notes = samples.notes
    groups = _by_cutting(samples, reading) if samples.trial is None else _by_name(samples, reading)
    inside = groups.group >= 0
    members = np.flatnonzero(inside)
    group, count = groups.group[members], len(groups.keys)
    targets = _targets(samples, members, group, count)
    cells = members if samples.cells is None else samples.cells[members]
    known, aside = conditions_of(samples.columns, cells, group, count)
    if aside:
        more = f" and {len(aside) - SHOWN} more" if len(aside) > SHOWN else ""
        notes.append(
            "columns left aside, for they vary within a trial or hold lists or long text: "
            f"{', '.join(aside[:SHOWN])}{more}"
        )
    trials = [
        Trial(user, name, x, y, w, condition=samples.condition | condition | begins)
        for (user, name), (x, y, w), condition, begins in zip(
            groups.keys, targets.tolist(), known, groups.begins, strict=True
        )
    ]
    table = samples.table[members]
    first = np.full(count, np.nan)
    first[group[::-1]] = table[::-1, 0]
    table[:, 0] = (table[:, 0] - first[group]) / samples.per_second
    place = np.cumsum(inside) - 1
    return assemble(
        samples.name,
        table,
        group,
        trials,
        skipped=samples.skipped,
        faults={int(place[at]): words for at, words in samples.faults.items() if inside[at]},
        unusable={
            int(index): f"target_w is {targets[index, -1]}, expected above 0 px"
            for index in np.flatnonzero(targets[:, -1] <= 0)
        },
        provenance=samples.provenance,
        notes=notes,
        row_of=samples.row_of[members],
        sort=reading.sort,
    )


def _targets(samples: Samples, members: IntArray, group: IntArray, count: int) -> FloatArray:
    """The target of each trial, NaN where its samples differ."""
    targets = np.full((count, 3), np.nan)
    if samples.targets is None:
        return targets
    given = samples.targets[members]
    unclear = []
    for at, field in enumerate(TARGET):
        targets[:, at] = one_value(given[:, at], group, count)
        if (np.isfinite(given[:, at]) & np.isnan(targets[group, at])).any():
            unclear.append(field)
    if unclear:
        samples.notes.append(f"targets that vary within a trial are left unknown: {', '.join(unclear)}")
    return targets


def one_value(values: FloatArray, group: IntArray, count: int) -> FloatArray:
    """The value of each trial, NaN if its rows differ or one is empty.

    >>> one_value(np.array([1.0, 1.0, 2.0, 3.0]), np.array([0, 0, 1, 1]), 2)
    array([ 1., nan])
    """
    last = np.full(count, np.nan)
    last[group] = values
    differs = np.zeros(count, dtype=bool)
    differs[group[values != last[group]]] = True
    return np.where(differs, np.nan, last)


def conditions_of(
    columns: Mapping[str, Any], rows: IntArray, group: IntArray, count: int
) -> tuple[list[Condition], list[str]]:
    """The conditions of each trial, and the columns that are none, because they vary within a trial.

    ``rows`` of the columns belong to ``group``. Numbers stay numbers if every cell is one; an empty cell, and
    NaN or NA among numbers, is not a condition. At most 64 columns become conditions, those that differ
    between trials first.
    """
    found: dict[str, tuple[list[int], list[str]]] = {}
    for name, column in columns.items():
        if pa.types.is_nested(column.type):
            continue
        of_trial, cells = _codes(column.take(pa.array(rows[:PROBE])), group[:PROBE], count)
        if np.isnan(of_trial[np.unique(group[:PROBE])]).any():
            continue
        of_trial, cells = _codes(column.take(pa.array(rows)), group, count)
        if not np.isnan(of_trial).any() and not any(map(_is_long, cells)):
            found[name] = (of_trial.astype(np.int64).tolist(), cells)
    if len(found) > MOST:
        order = sorted(found, key=lambda name: len(found[name][1]) == 1)[:MOST]
        found = {name: found[name] for name in found if name in order}
    conditions: list[Condition] = [{} for _ in range(count)]
    for name, (codes, cells) in found.items():
        numbers, faults = arrow_tables.finite_numbers(pa.chunked_array([pa.array(cells, pa.string())]))
        for condition, code in zip(conditions, codes, strict=True):
            value = cells[code] if faults else float(numbers[code])
            if cells[code].strip() and value == value:
                condition[condition_name(name)] = value
    return conditions, [name for name in columns if name not in found]


def _codes(column: Any, group: IntArray, count: int) -> tuple[FloatArray, list[str]]:
    """The index of each trial's only distinct cell, NaN if it has several; and the distinct cells."""
    codes, cells = codes_of(arrow_tables.words(column).fill_null(""))
    return one_value(codes.astype(np.float64), group, count), cells


def _is_long(cell: str) -> bool:
    return len(cell) > LONGEST or cell.lstrip().startswith(("[", "{"))


def condition_name(column: str) -> str:
    """A column's name as a condition, valid in our own files.

    >>> condition_name("trial"), condition_name("size, px")
    ('trial_column', 'size px')
    """
    name = " ".join(column.replace(",", " ").replace('"', " ").split())
    return f"{name}_column" if name in ("", *TRIAL_COLUMNS) else name


def _by_name(samples: Samples, reading: Reading) -> Groups:
    """Trials as the file names them, restarts separated; samples outside trials are left out and counted."""
    assert samples.trial is not None
    notes = samples.notes
    if reading.cut is not None:
        notes.append(f"cut {reading.cut!r} has no effect: the file has trials of its own")
    user, users = samples.users
    trial, trials = without_restarts(samples, reading.sort)
    named = np.array([bool(name.strip()) for name in trials] or [True])[trial]
    named &= np.array([bool(name.strip()) for name in users] or [True])[user]
    members = np.flatnonzero(named)
    group = np.full(len(named), -1, dtype=np.int64)
    group[members], keys = keys_of((user[members], users), (trial[members], trials))
    out = np.unique(samples.row_of[~named])  # of lists a row has several samples
    if len(out):
        notes.append(f"rows without user or trial left out: {len(out)}, the first is data row {out[0]}")
    return Groups(group, keys, [{} for _ in keys])


def _by_cutting(samples: Samples, reading: Reading) -> Groups:
    """One stream per user, cut according to ``reading``, else at clicks if there are any, else at pauses.

    A trial is named by its number among those of the user; its condition ``begins_s`` is its begin on the
    clock of the stream.
    """
    (codes, names), table, notes = samples.users, samples.table, samples.notes
    usable = np.isfinite(table[:, :3]).all(axis=1)
    groups = Groups(np.full(len(table), -1, dtype=np.int64))
    methods: dict[str, None] = {}
    restarts, late = 0, list[int]()
    named = any(names)
    order = np.arange(len(table), dtype=np.int64)
    by_user = np.flatnonzero(usable)[np.argsort(codes[usable], kind="stable")]
    bounds = np.searchsorted(codes[by_user], np.arange(len(names) + 1)).tolist()
    for user, (first, stop) in zip(names, pairwise(bounds), strict=True):
        mine = by_user[first:stop]
        if not len(mine):
            continue
        if named and not user:
            row = samples.row_of[mine[0]]
            notes.append(f"rows without user left out: {len(mine)}, the first is data row {row}")
            continue
        stream = table[mine]
        begin = stream[0, 0]
        stream[:, 0] = (stream[:, 0] - begin) / samples.per_second
        ordered = in_order(stream[:, 0], reading.sort)
        late += samples.row_of[mine[ordered.late]].tolist()
        order[mine] = mine[ordered.order]
        stream, anew = stream[ordered.order], ordered.anew
        restarts += len(anew)
        if samples.parts is not None:
            anew = np.union1d(anew, np.flatnonzero(np.diff(samples.parts[order[mine]])) + 1)
        parts = np.split(np.arange(len(mine)), anew)
        how = reading.cut or samples.cut or _method(stream, parts)
        methods[how] = None
        number = 0
        for part in parts:
            for piece in cut(EventColumns(stream[part]), how, reading):
                some = mine[part[piece.start : piece.stop]]
                if piece.reason:
                    ends = samples.row_of[order[some[[0, -1]]]].tolist()
                    words = "rows {} to {}".format(*ends)
                    skip = Skip(words, piece.reason, ends[0], user or samples.one_user)
                    samples.skipped.append(skip)
                    continue
                groups.group[some] = len(groups.keys)
                groups.keys.append((user or samples.one_user, str(number)))
                since = stream[part[piece.start], 0]
                groups.begins.append({"begins_s": float(since + begin / samples.per_second)})
                number += 1
    samples.sort(order)
    if late:
        notes.append(f"rows out of order, sorted by time: {len(late)}, the first is row {min(late)}")
    if samples.cut is None and methods:
        cuts = " or ".join(CUTS[method] for method in methods)
        count = "" if len(groups.keys) == 1 else f"; {len(groups.keys)} trials"
        notes.append(f"no column for trials: {cuts}{count}")
    if restarts:
        notes.append(f"time starts anew in {restarts} rows: cut there")
    out = int(np.count_nonzero(~usable))
    if out:
        row = int(np.flatnonzero(~usable)[0])
        why = samples.faults.get(row, "t, x or y is empty or too large")
        notes.append(f"rows left out: {out}, the first is data row {samples.row_of[row]}: {why}")
    return groups


def _method(stream: FloatArray, parts: list[IntArray]) -> Cut:
    """How a stream is cut by default."""
    if np.any(stream[:, 5] > 0):
        return "clicks"
    spans = [stream[part[-1], 0] - stream[part[0], 0] for part in parts]
    return "bursts" if max(spans) > LONG_S or np.any(np.diff(stream[:, 0]) > GAP_S) else "whole"


def without_restarts(samples: Samples, sort: bool) -> Codes:
    """The trial of each sample, with restarts of numbers separated, and a note on that.

    If a trial of a user has several runs of rows, or its time starts again, a usual column such as ``block``
    that separates them is joined to the trial. Without one, a run that begins before the end of the last one
    is a separate trial, named ``trial (2)`` and so on, unless rows are to be sorted. Rows without a trial
    (empty text) stay so.
    """
    assert samples.trial is not None
    (user, _), trials = samples.users, samples.trial
    order = np.argsort(user, kind="stable")
    runs = _Runs(user, trials, order)
    usual = parts_of_study(list(samples.columns))
    clock = samples.table[order, 0]
    if runs.single and not (usual and np.any(np.diff(clock)[np.diff(runs.key) == 0] < 0)):
        return trials
    column = pa.DictionaryArray.from_arrays(pa.array(trials[0]), pa.array(trials[1], pa.string()))
    for names in (*combinations(usual, 1), *combinations(usual, 2)):
        joined = arrow_tables.join_columns(
            [*(samples.columns[name] for name in names), column.cast(pa.string())]
        )
        joint = codes_of(joined.fill_null(""))
        apart = _Runs(user, joint, order)
        if _separates(apart, runs, clock) and (not runs.single or len(apart.keys) > len(runs.keys)):
            samples.notes.append(f"trial numbers restart: {' and '.join(names)} joined to the trial")
            return joint
    return trials if sort else _split(samples, runs, clock, order)


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


def _split(samples: Samples, runs: _Runs, clock: FloatArray, order: IntArray) -> Codes:
    """The trials with a new one for each run that begins before the end of the run before."""
    assert samples.trial is not None
    by_key = np.argsort(runs.keys, kind="stable")
    starts, ends, keys = runs.starts[by_key], runs.ends[by_key], runs.keys[by_key]
    again = np.zeros(len(keys), dtype=np.int64)
    again[1:] = (keys[1:] == keys[:-1]) & (clock[starts[1:]] < clock[ends[:-1]])
    if not again.any():
        return samples.trial
    total = np.cumsum(again)
    part = total - total[np.searchsorted(keys, keys)]
    code, names = samples.trial[0].copy(), list(samples.trial[1])
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
    samples.notes.append(
        f"trial numbers restart: {int(again.sum())} runs of rows are trials of their own, as 'trial (2)'"
    )
    return code, names
