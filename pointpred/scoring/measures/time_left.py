"""The error of the predicted time left, beside that of a clock with the set's median duration."""

from __future__ import annotations

from collections.abc import Sequence
from math import log

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray, FloatTable, IntArray
from pointpred.scoring.measures.endpoint import WEIGHT_S, moments
from pointpred.scoring.measures.regions import LEVELS

DEVIATIONS = (0.6744897501960817, 1.2815515655446004, 1.959963984540054)
"""Deviations of a normal law within which its middle LEVELS lie."""

# A row of `time_left`: share of the time with a claim; time-averaged absolute error in s; that of the clock;
# share of the time with a claimed spread; share of that time with the arrival within each of LEVELS.
CLAIMED, ERROR, CLOCK, SPREAD, INSIDE = 0, 1, 2, 3, 4
WIDTH = 7

REMAINING, SPREADS = 6, 9
"""Columns of a prediction."""
SHORTEST_S = 1e-6


def clock_s(durations_s: Sequence[float] | FloatArray) -> float:
    """The median time from onset to arrival, which the clock uses; NaN without trials."""
    return float(np.median(durations_s)) if len(durations_s) else float("nan")


@law
def within(left: float, predicted: float, spread: float, deviations: float) -> bool:
    """Whether the time left lies in the predicted interval: a normal law of its logarithm."""
    off = log(max(left, SHORTEST_S) / max(predicted, SHORTEST_S))
    return abs(off) <= deviations * spread


@law
def time_left(
    rows: FloatTable,
    answers: FloatTable,
    offsets: IntArray,
    arrivals: IntArray,
    median_s: float,
    out: FloatTable,
) -> None:
    """A row of ``out`` for each trial; time counts as in the time-averaged error of the endpoint.

    The clock predicts max(median_s - time since the onset, 0). Where no time is claimed it is scored in its
    place. The interval of level p reaches from remaining_s exp(-z spread) to remaining_s exp(z spread), z the
    deviation within which the middle p of a normal law lies.
    """
    out[:] = np.nan
    for k in range(len(offsets) - 1):
        first, arrival = offsets[k] - offsets[0], arrivals[k] - offsets[0]
        all_s, claimed_s, spread_s, error, clock = 0.0, 0.0, 0.0, 0.0, 0.0
        inside = np.zeros(len(LEVELS))
        for i in range(first, arrival):
            weight = min(rows[i + 1, 0] - rows[i, 0], WEIGHT_S)
            left, by_clock = rows[arrival, 0] - rows[i, 0], max(median_s - rows[i, 0] + rows[first, 0], 0.0)
            predicted, spread = answers[i, REMAINING], answers[i, SPREADS]
            all_s += weight
            clock += weight * abs(left - by_clock)
            if predicted != predicted:
                error += weight * abs(left - by_clock)
                continue
            claimed_s += weight
            error += weight * abs(left - predicted)
            if spread == spread:
                spread_s += weight
                for j in range(len(LEVELS)):
                    if within(left, predicted, spread, DEVIATIONS[j]):
                        inside[j] += weight
        out[k, CLAIMED], out[k, SPREAD] = claimed_s / all_s, spread_s / all_s
        out[k, ERROR], out[k, CLOCK] = error / all_s, clock / all_s
        if spread_s > 0.0:
            for j in range(len(LEVELS)):
                out[k, INSIDE + j] = inside[j] / spread_s


@law
def inside_by_time(
    rows: FloatTable,
    answers: FloatTable,
    offsets: IntArray,
    arrivals: IntArray,
    shares: FloatArray,
    out: FloatTable,
) -> None:
    """A row a trial: for each share of the time and level 1 where the arrival is in the interval, else 0.

    NaN where no interval is claimed at that moment.
    """
    out[:] = np.nan
    at = np.empty(len(shares), dtype=np.int64)
    for k in range(len(offsets) - 1):
        first, arrival = offsets[k] - offsets[0], arrivals[k] - offsets[0]
        moments(rows, first, arrival, offsets[k + 1] - offsets[0] - 1, shares, at)
        for m in range(len(shares)):
            predicted, spread = answers[at[m], REMAINING], answers[at[m], SPREADS]
            if predicted != predicted or spread != spread:
                continue
            left = rows[arrival, 0] - rows[at[m], 0]
            for j in range(len(LEVELS)):
                out[k, m * len(LEVELS) + j] = 1.0 if within(left, predicted, spread, DEVIATIONS[j]) else 0.0
