"""From rows in any order to a recording: grouped by trial, each trial kept or skipped as a whole."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pointpred.recording import IN_MEMORY, Provenance, Recording, Skip, Trial
from pointpred.recordings.arrow_tables import IntArray
from pointpred.records import LARGEST, LATEST_S, EventColumns, FloatArray

T, X, Y, DX, DY, BUTTONS = range(6)
FIELDS = ("t", "x", "y", "dx", "dy", "buttons")
MOST_BUTTONS = 65535.0


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
) -> Recording:
    """A recording from event rows, row ``i`` of which belongs to ``trials[group[i]]``.

    Assumes that the rows of one trial are in the order of their time; rows of several trials may interleave:
    they are regrouped, with a note. A trial is skipped, with the reason and the first row at fault, when it
    has fewer than two samples, a cell that is not a finite number (``faults``: row -> fault) or beyond the
    bounds of events, one count without the other, time that runs backwards, buttons that are not a whole
    number in 0..65535, or no movement at all. ``unfit`` names further trials with the caller's reason. Equal
    times are normal. ``row_of`` is the file's row of each table row if the two differ. Every trial is
    either in the recording or in its ``skipped``. Memory: two copies of the table at most.
    """
    count = len(trials)
    sizes = np.bincount(group, minlength=count).astype(np.int64)
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    row = np.arange(len(group), dtype=np.int64) if row_of is None else row_of
    fault_rows = np.array(sorted(faults or {}), dtype=np.int64)
    words = list(notes)
    if np.any(np.diff(group) < 0):
        runs = 1 + np.count_nonzero(np.diff(group))
        if runs > np.count_nonzero(sizes):
            at = _first_return(group)
            words.append(f"row {row[at]}: the rows of trials interleave; put together by trial")
        order = np.argsort(group, kind="stable")
        table, row = table[order], row[order]
        place = np.empty(len(order), dtype=np.int64)
        place[order] = np.arange(len(order))
        faults = {int(place[at]): (faults or {})[int(at)] for at in fault_rows}
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
    return Recording(
        name,
        EventColumns(table, begin),
        offsets,
        tuple(trial for trial, keep in zip(trials, usable, strict=True) if keep),
        (*skipped, *skips),
        provenance,
        tuple(words),
    )


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
        words, size = f"{FIELDS[column]} is {{{6 + column}}}, expected", np.abs(table[:, column])
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
