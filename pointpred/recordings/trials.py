"""Rows, or lists of samples, as the trials of a recording: grouped, checked and described."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.recording import IN_MEMORY, Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray
from pointpred.records import EVENT_FIELDS, LARGEST, LATEST_S, EventColumns, FloatArray

T, X, Y, DX, DY, BUTTONS = range(6)
MOST_BUTTONS = EVENT_FIELDS[BUTTONS].most
Codes = tuple[IntArray, list[str]]
"""For each row the index of its value among the distinct values, and these."""
TARGET = ("target_x", "target_y", "target_w")
TRIAL_COLUMNS = ("dataset", "user", "trial", *TARGET, "n_samples", "clean")
"""The columns of our own tables of trials; every other column is a condition."""
LATE_S, LATE_ROWS, LATE_SHARE = 0.1, 3, 0.1
"""Bounds on samples slightly out of order: how late, how many one after the other, their share of all."""
MIRRORED_LEAST, MIRRORED = 8, -0.8
"""With so many targets, and a smaller correlation with where movements end, one of the two is mirrored."""


def assemble(
    name: str,
    table: FloatArray,
    group: IntArray,
    trials: Sequence[Trial],
    *,
    skipped: Sequence[Skip] = (),
    faults: dict[int, str] | None = None,
    unusable: dict[int, str] | None = None,
    provenance: Provenance = IN_MEMORY,
    notes: Sequence[str] = (),
    row_of: IntArray | None = None,
    sort: bool = False,
) -> Recording:
    """A recording from event rows, row ``i`` of which belongs to ``trials[group[i]]``.

    Rows of several trials may interleave: they are regrouped, with a note. Rows of a trial that are slightly
    out of order (``in_order``), with ``sort`` any, are sorted by time, with a note. A trial is skipped, with
    the reason and the first row at fault, when it has fewer than two samples, a cell that is not a finite
    number (``faults``: row -> fault) or beyond the bounds of events, one count without the other, time that
    runs backwards, buttons that are not a whole number in 0..65535, or no movement at all. ``unusable`` names
    further trials with the caller's reason. Equal times are normal. ``row_of`` is the file's row of each
    table row if the two differ. Every trial is either in the recording or in its ``skipped``. Memory: two
    copies of the table at most.
    """
    count = len(trials)
    sizes = np.bincount(group, minlength=count).astype(np.int64)
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    row = np.arange(len(group), dtype=np.int64) if row_of is None else row_of
    words = list(notes)
    order: IntArray = np.arange(len(group), dtype=np.int64)
    if np.any(np.diff(group) < 0):
        runs = 1 + np.count_nonzero(np.diff(group))
        if runs > np.count_nonzero(sizes):
            at = _first_return(group)
            words.append(f"row {row[at]}: the rows of trials interleave; put together by trial")
        order = np.argsort(group, kind="stable")
        table = table[order]
    table, late = _sorted_trials(table, offsets, sort)
    if late is not None:
        words += late.notes(row[order])
        order = order[late.order]
    row = row[order]
    if faults:
        place = np.argsort(order)
        faults = {int(place[at]): fault for at, fault in faults.items()}
    reasons = _find_faults(table, offsets, faults or {})
    for index, reason in (unusable or {}).items():
        reasons.setdefault(index, (reason, int(offsets[index]) if sizes[index] else None))
    usable = np.array([index not in reasons for index in range(count)], dtype=bool)
    skips = [
        Skip(trials[index].trial, reason, None if at is None else int(row[at]), trials[index].user)
        for index, (reason, at) in sorted(reasons.items())
    ]
    if not usable.all():
        table = table[np.repeat(usable, sizes)]
        offsets = np.concatenate([[0], np.cumsum(sizes[usable])]).astype(np.int64)
    begin = np.zeros(len(table), dtype=np.bool_)
    begin[offsets[:-1]] = True
    kept = tuple(trial for trial, keep in zip(trials, usable, strict=True) if keep)
    return Recording(
        name,
        EventColumns(table, begin),
        offsets,
        kept,
        (*skipped, *skips),
        provenance,
        tuple(words),
    )


class Order(NamedTuple):
    """Samples by time: their ``order``, the places in it where time starts anew, and the late samples."""

    order: IntArray
    anew: IntArray
    late: IntArray

    def notes(self, row: IntArray) -> list[str]:
        """A note on the late samples; ``row``: the file's row of each sample."""
        if not len(self.late):
            return []
        first = int(row[self.late[0]])
        return [f"rows out of order, sorted by time: {len(self.late)}, the first is row {first}"]


def in_order(times: FloatArray, sort: bool = False) -> Order:
    """The order of samples by time where some are slightly late, and where time starts anew.

    Samples are slightly late if at most 3 in a row lie before a sample above them, by at most 0.1 s, and if
    they are at most a tenth of all; at any other step backwards time starts anew, with ``sort`` at none.

    >>> order, anew, late = in_order(np.array([0, 1, 3, 2, 4, 5, 6, 7, 8, 9, 0, 1, 2, 3, 4]) / 100)
    >>> order[:5].tolist(), anew.tolist(), late.tolist()
    ([0, 1, 3, 2, 4], [10], [3])
    """
    rows = np.arange(len(times), dtype=np.int64)
    finite = np.flatnonzero(np.isfinite(times))
    if len(finite) < len(times):  # the others keep their places
        some = in_order(times[finite], sort)
        rows[finite] = finite[some.order]
        return Order(rows, finite[some.anew], finite[some.late])
    back = np.flatnonzero(np.diff(times) < 0) + 1
    starts: list[int] = []
    seen, highest = 0, -np.inf
    for at in () if sort else back.tolist():
        if at < seen:
            continue
        highest = max(highest, float(times[seen:at].max()))
        caught_up = np.flatnonzero(times[at : at + LATE_ROWS + 1] >= highest)
        seen = at + int(caught_up[0]) if len(caught_up) else at
        if seen == at or highest - times[at:seen].min() > LATE_S:
            starts.append(at)
            seen, highest = at, -np.inf
    anew = np.array(starts, dtype=np.int64)
    latest = np.concatenate([np.maximum.accumulate(part) for part in np.split(times, anew)])
    late = np.flatnonzero(times < latest)
    if len(late) > LATE_SHARE * len(times) and not sort:
        return Order(rows, back, rows[:0])
    return Order(np.lexsort((times, np.searchsorted(anew, rows, side="right"))), anew, late)


def _sorted_trials(table: FloatArray, offsets: IntArray, sort: bool) -> tuple[FloatArray, Order | None]:
    """The rows of all trials with each trial in order where it can be; ``None``: nothing was out of order.

    A trial begins at the time at which its first row did.
    """
    back = np.diff(table[:, T], prepend=table[:1, T]) < 0
    back[offsets[offsets < len(table)]] = False
    order, late = np.arange(len(table), dtype=np.int64), []
    for owner in np.unique(np.searchsorted(offsets, np.flatnonzero(back), side="right") - 1).tolist():
        first, stop = int(offsets[owner]), int(offsets[owner + 1])
        one = in_order(table[first:stop, T], sort)
        if not len(one.anew):
            order[first:stop] = first + one.order
            late.append(first + one.late)
    if not late:
        return table, None
    sizes = np.diff(offsets)
    starts = offsets[:-1][sizes > 0]
    begins, table = table[starts, T], table[order]
    with np.errstate(invalid="ignore"):
        table[:, T] += np.repeat(begins - table[starts, T], sizes[sizes > 0])
    return table, Order(order, order[:0], np.concatenate(late))


def questions(recording: Recording) -> list[str]:
    """What to ask of a recording that pointpred did not write: trials with one time, mirrored targets."""
    if not recording.trials:
        return []
    first, ends = (
        recording.events.table[recording.offsets[:-1]],
        recording.events.table[recording.offsets[1:] - 1],
    )
    asked = []
    one = np.flatnonzero(ends[:, T] == first[:, T])
    if len(one):
        trial = recording.trials[one[0]]
        named = f"{len(one)}, the first is {trial.trial!r} of {trial.user!r}"
        asked.append(f"trials whose samples all have one time: {named}: is it their time?")
    for axis, column in (("x", X), ("y", Y)):
        targets = np.array([getattr(trial, f"target_{axis}") for trial in recording.trials])
        known = np.isfinite(targets)
        pairs = np.array([targets[known], ends[known, column]])
        if pairs.shape[1] < MIRRORED_LEAST or not np.ptp(pairs, axis=1).all():
            continue
        if np.corrcoef(pairs)[0, 1] < MIRRORED:
            asked.append(
                f"the larger target_{axis} is, the smaller is {axis} where movements end: "
                "are positions and targets counted from opposite sides?"
            )
    return asked


def _first_return(group: IntArray) -> int:
    """The first row that returns to an earlier trial."""
    starts = np.flatnonzero(np.diff(group, prepend=-1))
    _, first = np.unique(group[starts], return_index=True)
    again = np.ones(len(starts), dtype=bool)
    again[first] = False
    return int(starts[again][0])


def _find_faults(
    table: FloatArray, offsets: IntArray, faults: dict[int, str]
) -> dict[int, tuple[str, int | None]]:
    """The trials that cannot be used: index -> (reason, first row of the table at fault)."""
    reasons: dict[int, tuple[str, int | None]] = {}

    def blame(rows: IntArray, describe: dict[int, str] | str) -> None:
        owners = np.searchsorted(offsets, rows, side="right") - 1
        for owner, first in zip(*np.unique(owners, return_index=True), strict=True):
            at = int(rows[first])
            if int(owner) not in reasons:
                words = describe if isinstance(describe, str) else describe[at]
                reasons[int(owner)] = (words.format(*table[max(at - 1, 0)], *table[at]), at)

    for index in np.flatnonzero(np.diff(offsets) == 0):
        reasons[int(index)] = ("no samples", None)
    blame(
        np.array(sorted(faults), dtype=np.int64),
        {at: words.replace("{", "{{").replace("}", "}}") for at, words in faults.items()},
    )
    for column, most in ((T, LATEST_S), (X, LARGEST), (Y, LARGEST)):
        words, size = f"{EVENT_FIELDS[column].name} is {{{6 + column}}}, expected", np.abs(table[:, column])
        blame(np.flatnonzero(~np.isfinite(size)), f"{words} a finite number")
        blame(np.flatnonzero(size > most), f"{words} at most {most:g} either way")
    counts, words = np.abs(table[:, [DX, DY]]), "dx is {9} and dy {10}, expected"
    blame(np.flatnonzero(np.isinf(counts).any(axis=1)), "counts are not finite")
    blame(np.flatnonzero((counts > LARGEST).any(axis=1)), f"{words} at most {LARGEST:g} either way")
    blame(np.flatnonzero(np.isnan(counts[:, 0]) != np.isnan(counts[:, 1])), f"{words} both or neither")
    buttons = table[:, BUTTONS]
    with np.errstate(invalid="ignore"):
        bad = ~((buttons >= 0) & (buttons <= MOST_BUTTONS) & (buttons == np.floor(buttons)))
        back = np.diff(table[:, T], prepend=table[:1, T]) < 0
    back[offsets[offsets < len(table)]] = False
    blame(np.flatnonzero(bad), "buttons is {11}, expected a whole number from 0 to 65535")
    blame(np.flatnonzero(back), "time goes backwards, from {0} s to {6} s")
    sizes = np.diff(offsets)
    blame(offsets[:-1][sizes == 1], "one sample, expected at least two")
    still = (sizes > 0) & ~_moved(table, offsets)
    blame(offsets[:-1][still], "no movement: every position equals the first")
    return reasons


def _moved(table: FloatArray, offsets: IntArray) -> NDArray[np.bool_]:
    """Which trials leave their first position or have a nonzero count."""
    sizes = np.diff(offsets)
    first = offsets[:-1][sizes > 0]
    moved = (np.nan_to_num(table[:, DX]) != 0) | (np.nan_to_num(table[:, DY]) != 0)
    for column in (X, Y):
        moved |= table[:, column] != np.repeat(table[first, column], sizes[sizes > 0])
    return np.bincount(np.repeat(np.arange(len(sizes)), sizes), moved, minlength=len(sizes)) > 0


def codes_of(column: Any) -> Codes:
    """The codes of a text column without missing values."""
    encoded = column.combine_chunks().dictionary_encode()
    return arrow_tables.as_array(encoded.indices).astype(np.int64), encoded.dictionary.to_pylist()


def keys_of(users: Codes, trials: Codes) -> tuple[IntArray, list[tuple[str, str]]]:
    """For each row the index of its trial, and (user, trial) of each in the order of first appearance."""
    (user, user_names), (trial, trial_names) = users, trials
    joint = user * max(len(trial_names), 1) + trial
    starts = np.flatnonzero(np.diff(joint, prepend=-1))
    unique, first, run = np.unique(joint[starts], return_index=True, return_inverse=True)
    rank = np.empty(len(unique), dtype=np.int64)
    rank[np.argsort(first)] = np.arange(len(unique))
    group = np.repeat(rank[run], np.diff(starts, append=len(joint)))
    keys = [(user_names[user[row]], trial_names[trial[row]]) for row in np.sort(starts[first])]
    return group, keys


def condition_cells(column: Any, *, text: bool) -> list[Any]:
    """The cells of a column of text: words where it is ``text`` or one is no number, ``None`` if empty."""
    values, wrong = arrow_tables.numbers(column)
    if text or wrong:
        cells: list[Any] = column.to_pylist()
        return cells
    return [None if value != value else value for value in values.tolist()]


def is_condition(name: str) -> bool:
    """Whether a condition may have this name in pointpred's own files."""
    return bool(name) and name not in TRIAL_COLUMNS and name == name.strip(' "\r\n,') and "," not in name


def join(
    name: str,
    parts: Sequence[Recording],
    labels: Sequence[str],
    notes: Sequence[str] = (),
    *,
    unique: bool = False,
) -> Recording:
    """One recording of all trials, skips and notes of ``parts``, in their order.

    With more than one part, trials are renamed ``<label> <trial>``, unless their names are ``unique``. The
    provenance is the first part's: join only recordings of one format. Memory: a copy of all tables.
    """

    def named(label: str, trial: str) -> str:
        return trial if len(parts) == 1 or unique else f"{label} {trial}"

    tables = [part.rows(index) for part in parts for index in range(len(part.trials))]
    trials: list[Trial] = []
    skipped: list[Skip] = []
    all_notes: list[str] = []
    for label, part in zip(labels, parts, strict=True):
        trials += [msgspec.structs.replace(trial, trial=named(label, trial.trial)) for trial in part.trials]
        skipped += [msgspec.structs.replace(skip, trial=named(label, skip.trial)) for skip in part.skipped]
        all_notes += [note if len(parts) == 1 else f"{label}: {note}" for note in part.notes]
    return Recording.of(
        name, tables, _of_one_kind(trials), skipped, parts[0].provenance, [*all_notes, *notes]
    )


def _of_one_kind(trials: list[Trial]) -> list[Trial]:
    """The trials with text for a condition that is a number in some parts and text in others."""
    kinds: dict[str, set[bool]] = {}
    for trial in trials:
        for name, value in trial.condition.items():
            kinds.setdefault(name, set()).add(isinstance(value, str))
    mixed = {name for name, types in kinds.items() if len(types) > 1}
    return [
        msgspec.structs.replace(
            trial,
            condition={
                name: f"{value:.17g}" if name in mixed and not isinstance(value, str) else value
                for name, value in trial.condition.items()
            },
        )
        for trial in trials
    ]
