"""What is measured of the predicted point of a trial: its errors, and whether it lies in the target.

Compiled laws over a trial's events and the answers a pipeline gave to them. The truth is the last position.
Where a pipeline answers ``None`` the cursor's position is scored.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, inf

import numpy as np

from pointpred.compiled import law
from pointpred.records import ROUNDING_S, FloatArray, FloatTable, IntArray
from pointpred.scoring.results import AXIS_FRACTIONS, PATH_FRACTIONS, TIME_FRACTIONS, ScoredTrial

WEIGHT_S = 0.05
"""In the time-averaged error no sample counts for longer than this."""

FRACTIONS: FloatArray = np.array([*TIME_FRACTIONS, *PATH_FRACTIONS, *AXIS_FRACTIONS])
TIMES, PATHS, AXES = len(TIME_FRACTIONS), len(PATH_FRACTIONS), len(AXIS_FRACTIONS)

# A row of measures: time-averaged error, coverage, then one error for each of FRACTIONS.
TIME_AVERAGED, COVERAGE, BY_TIME = 0, 1, 2
BY_PATH = BY_TIME + TIMES
SINGLE_AXIS = BY_PATH + PATHS
MEASURES = SINGLE_AXIS + AXES

SOUND = -1


@law
def measure_trial(
    rows: FloatTable, answers: FloatTable, fractions: FloatArray, arrival: int, out: FloatArray
) -> int:
    """Write the measures of one trial; returns SOUND or the row of an answer that is not finite.

    ``rows`` from onset to end, ``answers`` beside them, ``arrival`` the row of arrival.
    """
    last = len(rows) - 1
    end_x, end_y = rows[last, 1], rows[last, 2]
    way_x, way_y = end_x - rows[0, 1], end_y - rows[0, 2]
    distance2 = way_x * way_x + way_y * way_y
    upright = abs(way_y) > abs(way_x)
    start_t, span_t = rows[0, 0], rows[arrival, 0] - rows[0, 0]
    next_time, next_path, next_axis = BY_TIME, BY_PATH, SINGLE_AXIS
    weighted, weights, answered = 0.0, 0.0, 0
    for i in range(last + 1):
        x, y = rows[i, 1], rows[i, 2]
        error_x, error_y = x - end_x, y - end_y
        if answers[i, 1] == answers[i, 1]:
            answered += 1
            error_x, error_y = answers[i, 1] - end_x, answers[i, 2] - end_y
        error = hypot(error_x, error_y)
        if not error < inf:
            return i
        if i < arrival:
            weight = min(rows[i + 1, 0] - rows[i, 0], WEIGHT_S)
            weighted += weight * error
            weights += weight
        while next_time < BY_PATH and (
            i == last or rows[i + 1, 0] > start_t + fractions[next_time - BY_TIME] * span_t + ROUNDING_S
        ):
            out[next_time] = error
            next_time += 1
        done_x, done_y = x - rows[0, 1], y - rows[0, 2]
        progress = done_x * way_x + done_y * way_y
        while next_path < SINGLE_AXIS and progress >= fractions[next_path - BY_TIME] * distance2:
            out[next_path] = error
            next_path += 1
        along = abs(way_y) if upright else abs(way_x)
        progress = done_y if upright else done_x
        if (way_y if upright else way_x) < 0.0:
            progress = -progress
        while next_axis < MEASURES and progress >= fractions[next_axis - BY_TIME] * along:
            out[next_axis] = abs(error_y if upright else error_x)
            next_axis += 1
    out[TIME_AVERAGED] = weighted / weights
    out[COVERAGE] = answered / (last + 1)
    return SOUND


@law
def measure(
    rows: FloatTable,
    answers: FloatTable,
    fractions: FloatArray,
    offsets: IntArray,
    arrivals: IntArray,
    out: FloatTable,
    faults: IntArray,
) -> None:
    """A row of measures for each trial that lies in these rows; ``offsets`` need not begin at 0."""
    base = offsets[0]
    for k in range(len(offsets) - 1):
        a, b = offsets[k] - base, offsets[k + 1] - base
        faults[k] = measure_trial(rows[a:b], answers[a:b], fractions, arrivals[k] - offsets[k], out[k])


DECILES = tuple(round(0.1 * i, 1) for i in range(1, 10))
"""Shares of the time from onset to arrival at which claims are read."""


@law
def moments(rows: FloatTable, first: int, arrival: int, last: int, shares: FloatArray, out: IntArray) -> None:
    """For each share of the time its row: the last at or before that time; shares ascend."""
    i, start, span = first, rows[first, 0], rows[arrival, 0] - rows[first, 0]
    for k in range(len(shares)):
        while i < last and rows[i + 1, 0] <= start + shares[k] * span + ROUNDING_S:
            i += 1
        out[k] = i


def targets(trials: Sequence[ScoredTrial]) -> FloatArray:
    """Centre and width of each trial's target, a row a trial, NaN where one of them is unknown."""
    rows = [(one.trial.target_x, one.trial.target_y, one.trial.target_w) for one in trials]
    table = np.array(rows, dtype=np.float64).reshape(-1, 3)
    table[~(np.isfinite(table).all(axis=1) & (table[:, 2] > 0.0))] = np.nan
    return table


@law
def hits(
    rows: FloatTable,
    answers: FloatTable,
    offsets: IntArray,
    arrivals: IntArray,
    discs: FloatTable,
    shares: FloatArray,
    out: FloatTable,
) -> None:
    """For each trial and share of the time: 1 where the prediction lies in the target, 0 where it does not.

    The target is the disc with its width as the diameter. Where nothing was answered the cursor's position
    is judged; NaN where the target is not known.
    """
    out[:] = np.nan
    at = np.empty(len(shares), dtype=np.int64)
    for k in range(len(offsets) - 1):
        if discs[k, 0] != discs[k, 0]:
            continue
        first, last = offsets[k] - offsets[0], offsets[k + 1] - offsets[0] - 1
        moments(rows, first, arrivals[k] - offsets[0], last, shares, at)
        for m in range(len(shares)):
            x, y = rows[at[m], 1], rows[at[m], 2]
            if answers[at[m], 1] == answers[at[m], 1]:
                x, y = answers[at[m], 1], answers[at[m], 2]
            out[k, m] = 1.0 if hypot(x - discs[k, 0], y - discs[k, 1]) <= 0.5 * discs[k, 2] else 0.0
