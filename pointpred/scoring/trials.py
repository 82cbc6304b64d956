"""What a trial is: where it begins, ends and arrives, whether it is clean and has sub-movements."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, sqrt
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.recording import Recording, Skip
from pointpred.records import (
    FINE,
    BoolArray,
    EventColumns,
    EventRow,
    FloatArray,
    FloatTable,
    IntArray,
    IntTable,
    event_at,
    fault_of_event,
)
from pointpred.scoring.results import ScoredTrial
from pointpred.scoring.spans import in_threads
from pointpred.targets.rectangles import Target

ONSET_PX = 3.0
"""A movement has begun once the cursor has left this circle around the trial's first position for good."""
ARRIVAL_PX = 8.0
ARRIVAL_SHARE = 0.03
"""A movement has arrived once it stays within max(8 px, 3 % of the distance) of its endpoint."""

GOOD, EMPTY, ONE_SAMPLE, UNUSABLE, BACKWARD, NEVER_LEFT, ARRIVED, INSTANT = 0, 1, 2, 3, 4, 5, 6, 7
"""Why a trial can or cannot be scored."""

# What `cut` writes for each trial: the verdict, the row it is about, the rows from onset up to stop, the
# row of arrival.
VERDICT, ROW, ONSET, STOP, ARRIVAL = 0, 1, 2, 3, 4
CUTS = 5

Cuts = NDArray[np.int64]


@law
def fault(rows: FloatTable, first: int, stop: int) -> tuple[int, int]:
    """The first reason not to score a trial as it was recorded, and its row."""
    if stop == first:
        return EMPTY, first
    for i in range(first, stop):
        if fault_of_event(EventRow(*event_at(rows, i))) != FINE:
            return UNUSABLE, i
        if i > first and rows[i, 0] < rows[i - 1, 0]:
            return BACKWARD, i
    if stop - first == 1:
        return ONE_SAMPLE, first
    return GOOD, first


@law
def selection(rows: FloatTable, first: int, stop: int) -> int:
    """The row after the selecting click: the last press of the primary button away from the start."""
    for i in range(stop - 1, first, -1):
        pressed = int(rows[i, 5]) & 1 == 1 and int(rows[i - 1, 5]) & 1 == 0
        if pressed and hypot(rows[i, 1] - rows[first, 1], rows[i, 2] - rows[first, 2]) > ONSET_PX:
            return i + 1
    return stop


@law
def departure(rows: FloatTable, first: int, stop: int) -> int:
    """The last row within 3 px of the trial's first position."""
    for i in range(stop - 1, first, -1):
        if hypot(rows[i, 1] - rows[first, 1], rows[i, 2] - rows[first, 2]) <= ONSET_PX:
            return i
    return first


@law
def settling(rows: FloatTable, onset: int, stop: int) -> int:
    """The first row from which on the cursor stays near the endpoint."""
    x, y = rows[stop - 1, 1], rows[stop - 1, 2]
    near = max(ARRIVAL_PX, ARRIVAL_SHARE * hypot(x - rows[onset, 1], y - rows[onset, 2]))
    for i in range(stop - 1, onset - 1, -1):
        if hypot(rows[i, 1] - x, rows[i, 2] - y) > near:
            return i + 1
    return onset


@law
def cut(rows: FloatTable, offsets: IntArray, out: IntTable) -> None:
    """One row of ``out`` for each trial."""
    for k in range(len(offsets) - 1):
        first, stop = offsets[k], offsets[k + 1]
        verdict, row = fault(rows, first, stop)
        onset, arrival = first, first
        if verdict == GOOD:
            stop = selection(rows, first, stop)
            onset = departure(rows, first, stop)
            arrival = settling(rows, onset, stop)
            row = onset
            if onset == stop - 1:
                verdict = NEVER_LEFT
            elif arrival == onset:
                verdict = ARRIVED
            elif rows[arrival, 0] == rows[onset, 0]:
                verdict = INSTANT
        out[k, VERDICT], out[k, ROW] = verdict, row
        out[k, ONSET], out[k, STOP], out[k, ARRIVAL] = onset, stop, arrival


DISTANCE_PX = 80.0
"""A clean trial goes at least so far."""
PATH_RATIO = 1.5
"""Its path is at most so many times the distance."""
STANDSTILL_S = 0.1
"""On the way it never stands still for longer."""
LEAVING, ARRIVING = 0.05, 0.95
"""The way: between these shares of the progress along the line from start to end."""


@law
def straight_through(table: FloatTable, first: int, stop: int) -> bool:
    """Whether the trial in rows ``first`` up to ``stop`` goes far enough, straight enough, without a stop."""
    x, y = table[first, 1], table[first, 2]
    along_x, along_y = table[stop - 1, 1] - x, table[stop - 1, 2] - y
    square = along_x * along_x + along_y * along_y
    path, moved = 0.0, first
    for i in range(first + 1, stop):
        step = hypot(table[i, 1] - table[i - 1, 1], table[i, 2] - table[i - 1, 2])
        if step > 0.0:
            progress = ((table[moved, 1] - x) * along_x + (table[moved, 2] - y) * along_y) / square
            if LEAVING < progress < ARRIVING and table[i, 0] - table[moved, 0] > STANDSTILL_S:
                return False
            moved = i
        path += step
    return bool(square >= DISTANCE_PX**2 and path <= PATH_RATIO * sqrt(square))


@law
def judge(table: FloatTable, offsets: IntArray, out: BoolArray) -> None:
    """The same for each trial."""
    for k in range(len(out)):
        out[k] = straight_through(table, offsets[k], offsets[k + 1])


def clean_trials(events: EventColumns, offsets: NDArray[np.int64]) -> BoolArray:
    """Which trials are clean: at least 80 px far, path at most 1.5 times that, no stop on the way over 0.1 s.

    Rows ``offsets[i]`` up to ``offsets[i + 1]`` are trial i; each covers some distance. The rule looks at
    the whole trial: it picks trials to compare with papers that excluded the rest, and is never used on line.
    """
    out = np.zeros(len(offsets) - 1, dtype=np.bool_)
    judge(events.table, offsets, out)
    return out


PEAK_RATIO = 5.0
"""A trial is free of sub-movements when its highest speed peak is at least so many times every other."""
DIP = 2.0
"""Two peaks are two, and no ripple on one, when the speed between them falls to this part of the lower."""


@law
def divided(motions: FloatTable, first: int, stop: int) -> bool:
    """Whether the second highest speed peak of these rows exceeds a fifth of the highest."""
    highest, second = 0.0, 0.0
    rising, extreme = True, 0.0
    for i in range(first, stop):
        speed = hypot(motions[i, 3], motions[i, 4])
        if (rising and speed >= extreme) or (not rising and speed <= extreme):
            extreme = speed
        elif not rising and speed > DIP * extreme:
            rising, extreme = True, speed
        elif rising and DIP * speed < extreme:
            highest, second = max(highest, extreme), max(second, min(highest, extreme))
            rising, extreme = False, speed
    if rising:  # a trial may end before its last peak has passed
        highest, second = max(highest, extreme), max(second, min(highest, extreme))
    return bool(PEAK_RATIO * second > highest)


@law
def divide(motions: FloatTable, offsets: IntArray, out: BoolArray) -> None:
    """The same for each trial."""
    for k in range(len(offsets) - 1):
        out[k] = divided(motions, offsets[k], offsets[k + 1])


def submovements(
    events: EventColumns, offsets: NDArray[np.int64], *, threads: int | None = None, **resolution: Any
) -> BoolArray:
    """Which trials have sub-movements; rows ``offsets[i]`` up to ``offsets[i + 1]`` are trial i.

    Assumes that a sub-movement shows as a peak of the speed: pieces that overlap so far that the speed does
    not fall by half between them count as one. Whole pixels make ripples on every peak, which is why the
    fall is asked for; a clock that stutters may still make a peak of its own.

    The speed is the length of the velocity that the homogeneous differentiator with the thesis's gains
    finds, restarted at each row marked ``begin``. ``resolution``: ``cpi`` and ``dpi`` as for ``build``.

    Reference: Khalin 2022, remark 2.3.1 and section 2.6.3 (ratio 5; what a peak is, it does not say).
    """

    def work(first: int, stop: int) -> BoolArray:
        rows = events.rows(int(offsets[first]), int(offsets[stop]))
        out = np.zeros(stop - first, dtype=np.bool_)
        divide(pattern.fresh().run(rows).table, offsets[first : stop + 1] - offsets[first], out)
        return out

    pattern = HomogeneousDifferentiator(**resolution)
    return np.concatenate([np.empty(0, dtype=np.bool_), *in_threads(work, offsets, threads)])


NEAR_SHARE = 0.03
"""An end or a distance repeats an earlier one within this share of the distance."""
LAST_ENDS, LAST_DISTANCES = 128, 12
"""So many of the person's movements before are looked at: what `kinematic-adaptive` remembers."""


def repeats(
    events: EventColumns, offsets: NDArray[np.int64], users: Sequence[str]
) -> tuple[BoolArray, BoolArray]:
    """Of each trial whether its end, and whether its distance, repeats one of the same person's before.

    An end repeats where one of the last 128 movements ended within 3 % of the distance from it, a distance
    where one of the last 12 was as long within 3 %. Rows ``offsets[i]`` up to ``offsets[i + 1]`` are trial i.

    >>> path = EventColumns.of(t=[0.0, 1.0] * 3, x=[0, 100, 100, 1, 1, 101], y=[0.0] * 6)
    >>> ends, distances = repeats(path, np.array([0, 2, 4, 6]), ["ann"] * 3)
    >>> ends.tolist(), distances.tolist()
    ([False, False, True], [False, True, True])
    """
    _, person = np.unique(np.asarray(users, dtype=str), return_inverse=True)
    order = np.argsort(person, kind="stable")
    person, first, last = person[order], offsets[:-1][order], offsets[1:][order] - 1
    x, y = events.x[last], events.y[last]
    distance = np.hypot(x - events.x[first], y - events.y[first])
    near = NEAR_SHARE * distance
    found = np.zeros((2, len(order)), dtype=np.bool_)
    for back in range(1, min(LAST_ENDS, len(order) - 1) + 1):
        later, before = slice(back, None), slice(None, -back)
        same = person[later] == person[before]
        found[0, later] |= same & (np.hypot(x[later] - x[before], y[later] - y[before]) <= near[later])
        if back <= LAST_DISTANCES:
            found[1, later] |= same & (np.abs(distance[later] - distance[before]) <= near[later])
    ends, distances = np.empty((2, len(order)), dtype=np.bool_)
    ends[order], distances[order] = found
    return ends, distances


REASONS = {
    EMPTY: "has no events",
    ONE_SAMPLE: "has one sample, a movement needs two",
    UNUSABLE: "a value is not finite or out of range",
    BACKWARD: "time runs backwards",
    NEVER_LEFT: f"ends within {ONSET_PX:g} px of its start",
    ARRIVED: (
        f"never leaves the {ARRIVAL_PX:g} px (or {ARRIVAL_SHARE:.0%}) around its endpoint after the onset"
    ),
    INSTANT: "takes no time from onset to arrival",
}


class Candidates(msgspec.Struct, frozen=True):
    """What movements could have been for."""

    targets: tuple[tuple[Target, ...], ...]
    """Of each trial: all targets of its block; none where nobody says what they are."""
    kinds: dict[str, int]
    """What they are, in words, and in how many trials."""


class Prepared(msgspec.Struct, frozen=True):
    """The trials of a recording that can be scored, ready to be replayed.

    ``events`` holds the rows from each onset to each end; rows ``offsets[i]`` up to ``offsets[i + 1]`` are
    ``trials[i]``, the first of them is marked ``begin``; ``arrivals[i]`` is its row of arrival.
    """

    name: str
    events: EventColumns
    offsets: NDArray[np.int64]
    arrivals: NDArray[np.int64]
    trials: tuple[ScoredTrial, ...]
    skipped: tuple[Skip, ...]
    candidates: Candidates | None = None
    """``None`` where nobody asked for them."""

    def rows(self, trial: int) -> EventColumns:
        """The events of one trial."""
        return self.events.rows(int(self.offsets[trial]), int(self.offsets[trial + 1]))


def prepare(
    recording: Recording,
    *,
    cpi: float | None = None,
    dpi: float | None = None,
    threads: int | None = None,
) -> Prepared:
    """Cut every trial of a recording to what is scored, and say why the others are left out.

    The trial ends with the selecting click: the last press of the primary button more than 3 px from the
    start; without one, with its last sample. Its last position is the endpoint. The onset is the last sample
    within 3 px of the first position: earlier rows are cut, and distance and progress count from there. The
    arrival is the first sample after which the cursor stays within max(8 px, 3 % of the distance) of the
    endpoint.

    Onset, endpoint and arrival are known only afterwards: they say where to read errors, and no pipeline
    sees them, save that it is reset at the onset. A movement that passes its start again begins there.

    ``cpi`` and ``dpi`` (counts and px per inch) replace the recording's own values; they matter only
    to the speed that decides on sub-movements.

    >>> from pointpred.records import EventColumns, FloatArray
    >>> from pointpred.recording import Trial
    >>> path = EventColumns.of(t=[0.0, 0.1, 0.2, 0.3], x=[0, 1, 60, 100], y=[0, 0, 0, 0])
    >>> trial = prepare(Recording.of("one", [path], [Trial("ann", "1")])).trials[0]
    >>> trial.onset_s, trial.distance_px, round(trial.arrival_s, 9), trial.events
    (0.1, 99.0, 0.2, 3)
    """
    cuts = cuts_of(recording)
    good = np.flatnonzero(cuts[:, VERDICT] == GOOD)
    onset, stop = cuts[good, ONSET], cuts[good, STOP]
    offsets = np.concatenate([[0], np.cumsum(stop - onset)]).astype(np.int64)
    source = np.repeat(onset - offsets[:-1], stop - onset) + np.arange(offsets[-1])
    begin = np.zeros(len(source), dtype=np.bool_)
    begin[offsets[:-1]] = True
    events = EventColumns(recording.events.table[source], begin)
    arrivals = cuts[good, ARRIVAL] - onset + offsets[:-1]
    divided = submovements(events, offsets, threads=threads, **resolution(recording, cpi, dpi))
    first, last = offsets[:-1], offsets[1:] - 1
    distance = np.hypot(events.x[last] - events.x[first], events.y[last] - events.y[first])
    judged = [recording.trials[k].clean for k in good.tolist()]
    ruled = clean_trials(events, offsets).tolist()
    clean = [rule if own is None else own for own, rule in zip(judged, ruled, strict=True)]
    ends, distances = repeats(events, offsets, [recording.trials[k].user for k in good.tolist()])
    measured = zip(
        good.tolist(),
        distance.tolist(),
        (events.t[first] - recording.events.t[recording.offsets[good]]).tolist(),
        (events.t[arrivals] - events.t[first]).tolist(),
        divided.tolist(),
        np.diff(offsets).tolist(),
        clean,
        ends.tolist(),
        distances.tolist(),
        strict=True,
    )
    trials = tuple(ScoredTrial(recording.trials[k], *values) for k, *values in measured)
    skipped = (*recording.skipped, *_skips(recording, cuts))
    return Prepared(recording.name, events, offsets, arrivals, trials, skipped)


def durations_s(recording: Recording) -> FloatArray:
    """The times from onset to arrival of the trials that can be scored, s: what ``prepare`` finds of them."""
    cuts, t = cuts_of(recording), recording.events.t
    good = cuts[cuts[:, VERDICT] == GOOD]
    spans: FloatArray = t[good[:, ARRIVAL]] - t[good[:, ONSET]]
    return spans


def cuts_of(recording: Recording) -> Cuts:
    """Where each trial begins, ends and arrives, a row a trial, as ``cut`` writes it."""
    cuts = np.empty((len(recording.trials), CUTS), dtype=np.int64)
    cut(recording.events.table, recording.offsets, cuts)
    return cuts


def resolution(recording: Recording, cpi: float | None, dpi: float | None) -> dict[str, Any]:
    """The device's and the screen's resolution: the arguments, otherwise the recording's values."""
    provenance = recording.provenance
    return {"cpi": provenance.cpi if cpi is None else cpi, "dpi": provenance.dpi if dpi is None else dpi}


def _skips(recording: Recording, cuts: Cuts) -> list[Skip]:
    """A skip for each trial that cannot be scored; a faulty event is named by its number in the trial."""
    skips = []
    for k in np.flatnonzero(cuts[:, VERDICT] != GOOD).tolist():
        verdict, row = int(cuts[k, VERDICT]), int(cuts[k, ROW])
        reason = REASONS[verdict]
        if verdict in (UNUSABLE, BACKWARD):
            values = ", ".join(
                f"{name} {value:g}"
                for name, value in zip(EventColumns.names, recording.events.table[row].tolist(), strict=True)
            )
            reason = f"event {row - int(recording.offsets[k])} of the trial: {reason} ({values})"
        skips.append(Skip(recording.trials[k].trial, reason, user=recording.trials[k].user))
    return skips
