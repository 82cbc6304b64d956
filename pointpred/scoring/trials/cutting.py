"""Where a trial begins, ends and arrives: compiled laws over the one table that holds all trials."""

from __future__ import annotations

from math import hypot

import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.differentiators import sampling
from pointpred.records import EventRow, FloatArray, event_at

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
def fault(rows: FloatArray, first: int, stop: int) -> tuple[int, int]:
    """The first reason not to score a trial as it was recorded, and its row."""
    if stop == first:
        return EMPTY, first
    for i in range(first, stop):
        if not sampling.usable(EventRow(*event_at(rows, i))):
            return UNUSABLE, i
        if i > first and rows[i, 0] < rows[i - 1, 0]:
            return BACKWARD, i
    if stop - first == 1:
        return ONE_SAMPLE, first
    return GOOD, first


@law
def selection(rows: FloatArray, first: int, stop: int) -> int:
    """The row after the selecting click: the last press of the primary button away from the start."""
    for i in range(stop - 1, first, -1):
        pressed = int(rows[i, 5]) & 1 == 1 and int(rows[i - 1, 5]) & 1 == 0
        if pressed and hypot(rows[i, 1] - rows[first, 1], rows[i, 2] - rows[first, 2]) > ONSET_PX:
            return i + 1
    return stop


@law
def departure(rows: FloatArray, first: int, stop: int) -> int:
    """The last row within 3 px of the trial's first position."""
    for i in range(stop - 1, first, -1):
        if hypot(rows[i, 1] - rows[first, 1], rows[i, 2] - rows[first, 2]) <= ONSET_PX:
            return i
    return first


@law
def settling(rows: FloatArray, onset: int, stop: int) -> int:
    """The first row from which on the cursor stays near the endpoint."""
    x, y = rows[stop - 1, 1], rows[stop - 1, 2]
    near = max(ARRIVAL_PX, ARRIVAL_SHARE * hypot(x - rows[onset, 1], y - rows[onset, 2]))
    for i in range(stop - 1, onset - 1, -1):
        if hypot(rows[i, 1] - x, rows[i, 2] - y) > near:
            return i + 1
    return onset


@law
def cut(rows: FloatArray, offsets: Cuts, out: Cuts) -> None:
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
