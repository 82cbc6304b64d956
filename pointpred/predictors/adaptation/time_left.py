"""The time left for one person: a sum of what is known, weighted as this person's movements had it.

In medians of the person's last durations, the time left is the sum of seven terms: two estimates, a constant,
the way left, the speed, how long the cursor has been slow, and how near it is to the predicted end. Their
weights are those of the least absolute error over the person's finished movements, the earlier ones
discounted, and of everybody's weights as a prior. The least absolute error makes the sum a median.

Reference: recursive least squares with weights 1 / |residual|, which approximate the least absolute error
(Schlossmacher 1973, "An iterative technique for absolute deviations curve fitting").
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.predictors.adaptation import arrival_intervals, moments
from pointpred.predictors.adaptation.arrival_intervals import Intervals
from pointpred.predictors.adaptation.time_left_prior import PRIOR
from pointpred.records import FloatArray
from pointpred.stage import copy_values

TERMS = 7
SUMS = TERMS * (TERMS + 1) // 2
"""Sums of products of terms: the lower triangle, row after row."""
KEEP = 0.98
"""Forgetting factor of the sums per movement."""
JUDGED = 12
"""A movement is judged in the middle of each twelfth of its time."""
SMALL = 0.05
"""Residuals count as no smaller than this share of the median duration."""
FURTHEST = 20.0
"""No time left counts as longer than so many median durations."""
LEAST = 0.05
"""The least answer, as a share of the predictor's and of the median duration."""
LONGEST = 4.0
"""An estimate counts as no longer than so many median durations."""
NEAR = 0.04
"""Where this share of the way is left the end is half near."""
SHORTEST_S = 1e-6
"""No time left counts as shorter."""
START = 0.1
"""Added to the time passed, in medians, of which slow time is a share."""

MOVEMENTS = 1.001 / (1.0 - KEEP)
"""What a sum comes to that takes in 1 with each movement, for ever; rounding included."""
MOST_PRODUCT = LONGEST**2 / SMALL * MOVEMENTS
MOST_RESIDUAL = 1e9
"""No sum of residuals comes near it."""
LEAST_PIVOT = 0.01
"""The prior's sums alone have no smaller pivot, and a person's make none smaller."""
MOST = 32
"""Moments that are remembered."""


class Sums(Layout):
    """What is known of a person's time left."""

    products: Annotated[FloatArray, SUMS, Known("sums of products", -MOST_PRODUCT, MOST_PRODUCT)]
    """Of terms, weighted."""
    residuals: Annotated[FloatArray, TERMS, Known("sums of residuals", -MOST_RESIDUAL, MOST_RESIDUAL)]
    """Of terms times the residuals under the prior's weights, weighted."""


class Moment(Layout):
    """What was stated at a time: the time left, its spread, and the terms."""

    t: float
    left: float
    spread: float
    terms: Annotated[FloatArray, TERMS]


class Movement(Layout):
    """What was stated in the movement; ``ready`` if its weights of the terms are there."""

    ready: float
    weights: Annotated[FloatArray, TERMS]
    series: moments.Series
    moments: Annotated[Sequence[Moment], MOST]


class Pace(NamedTuple):
    """The hand's speed over its peak so far, and for how many s it has been below a fifth of that."""

    of_peak: float
    slow_s: float


class Way(NamedTuple):
    """Straight ways in px: from the start to the cursor, above 0; from there to the predicted end."""

    done: float
    left: float


class Estimates(NamedTuple):
    """The time left in s by the person's mixture of clock and predictor, and by the predictor alone."""

    mixed: float
    predicted: float


Terms = tuple[float, float, float, float, float, float, float]
"""What the time left is a sum of."""


@law
def terms(estimates: Estimates, way: Way, pace: Pace, since: float, median: float) -> Terms:
    """What the time left is a sum of, in medians of the last durations; ``since`` s have passed."""
    mixed = min(estimates.mixed / median, LONGEST)
    predicted = min(estimates.predicted / median, LONGEST)
    share = way.left / (way.left + way.done)
    slow = min(pace.slow_s / median, 1.0) / (since / median + START)
    near = NEAR * NEAR / (NEAR * NEAR + share * share)
    return mixed, predicted, 1.0, share, pace.of_peak * predicted, slow, near


@law
def factor(s: Sums, prior: FloatArray, out: FloatArray) -> float:
    """Factor the sums and the prior's into L D L' in place of their lower triangle; returns the least of D.

    ``prior``: the weights, then the sums of everybody.
    """
    least = np.inf
    for i in range(SUMS):
        out[i] = s.products[i] + prior[TERMS + i]
    for i in range(TERMS):
        row = i * (i + 1) // 2
        for j in range(i):
            column = j * (j + 1) // 2
            for k in range(j):
                out[row + j] -= out[row + k] * out[column + k]
        for j in range(i):
            scaled = out[row + j] / out[j * (j + 3) // 2]
            out[row + i] -= scaled * out[row + j]
            out[row + j] = scaled
        least = min(least, out[row + i])
    return least


@law
def solve(s: Sums, prior: FloatArray, weights: FloatArray) -> None:
    """The weights of the terms for this person."""
    factors = np.empty(SUMS)
    factor(s, prior, factors)
    for i in range(TERMS):
        weights[i] = s.residuals[i]
        for j in range(i):
            weights[i] -= factors[i * (i + 1) // 2 + j] * weights[j]
    for i in range(TERMS):
        weights[i] /= factors[i * (i + 3) // 2]
    for i in range(TERMS - 1, -1, -1):
        for j in range(i + 1, TERMS):
            weights[i] -= factors[j * (j + 1) // 2 + i] * weights[j]
    for i in range(TERMS):
        weights[i] += prior[i]


@law
def weighed(
    s: Sums,
    intervals: Intervals,
    movement: Movement,
    cursor: tuple[float, float, float],
    since: float,
    median: float,
    predicted: float,
    known: Terms,
    prior: FloatArray,
) -> tuple[float, float]:
    """The time left in s and the spread of its logarithm, ``since`` s after the start; remembers both.

    ``cursor``: t, x, y; ``predicted``: the time left in s by the predictor alone; ``known``: by ``terms``.
    """
    if movement.ready == 0.0:
        solve(s, prior, movement.weights)
        movement.ready = 1.0
    total = 0.0
    for i in range(TERMS):
        total += movement.weights[i] * known[i]
    left = max(min(total, FURTHEST) * median, LEAST * min(predicted, median))
    spread = arrival_intervals.spread(intervals, since / (since + left))
    last = movement.moments[max(int(movement.series.count) - 1, 0)]
    number, full = moments.next_moment(movement.series, last.t, cursor, MOST)
    if full:
        for k in range(1, number):
            copy_values(movement.moments[2 * k].memory, movement.moments[k].memory)
    if number >= 0:
        m = movement.moments[number]
        m.t, m.left, m.spread = cursor[0], left, spread
        for i in range(TERMS):
            m.terms[i] = known[i]
    return left, spread


@law
def stated(
    s: Sums,
    intervals: Intervals,
    movement: Movement,
    cursor: tuple[float, float, float],
    since: float,
    median: float,
    estimates: Estimates,
    way: Way,
    pace: Pace,
) -> tuple[float, float]:
    """``weighed`` by everybody's weights, from what the terms are made of."""
    known = terms(estimates, way, pace, since, median)
    return weighed(s, intervals, movement, cursor, since, median, estimates.predicted, known, PRIOR)


@law
def moment_at(movement: Movement, k: int, span: tuple[float, float], share: float) -> int:
    """The number of the moment at a share of the time between the start and the end in s, from ``k`` on."""
    while k + 1 < movement.series.count and moments.has_come(
        movement.series, movement.moments[k + 1].t, span, share
    ):
        k += 1
    return k


@law
def learn(
    s: Sums,
    intervals: Intervals,
    movement: Movement,
    span: tuple[float, float],
    median: float,
    prior: FloatArray,
) -> None:
    """Learn from a movement over ``span``, its start and its arrival in s."""
    if movement.ready == 0.0:
        return
    step = arrival_intervals.next_step(intervals) / JUDGED
    for i in range(SUMS):
        s.products[i] *= KEEP
    for i in range(TERMS):
        s.residuals[i] *= KEEP
    k = 0
    for judged in range(JUDGED):
        share = (judged + 0.5) / JUDGED
        k = moment_at(movement, k, span, share)
        m = movement.moments[k]
        seconds = max(span[1] - m.t, SHORTEST_S)
        arrival_intervals.judge(intervals, share, step, (m.left, m.spread), seconds)
        left = min(seconds / median, FURTHEST)
        off, off_prior = left, left
        for i in range(TERMS):
            off -= movement.weights[i] * m.terms[i]
            off_prior -= prior[i] * m.terms[i]
        weight = 1.0 / (max(abs(off), SMALL) * JUDGED)
        for i in range(TERMS):
            term = weight * m.terms[i]
            s.residuals[i] += term * off_prior
            for j in range(i + 1):
                s.products[i * (i + 1) // 2 + j] += term * m.terms[j]


FINE, NOT_POSITIVE = 0, 31


@law
def fault(learned: Sums, prior: FloatArray) -> tuple[int, float]:
    """What is wrong with numbers that are each within their bounds, and the number that is wrong."""
    least = factor(learned, prior, np.empty(SUMS))
    return (FINE, 0.0) if least >= LEAST_PIVOT else (NOT_POSITIVE, least)


def doubt(learned: Sums, prior: FloatArray = PRIOR) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, value = fault(learned.memory, prior)
    least = f"sums of products must be those of real terms, with pivots of at least {LEAST_PIVOT:g}"
    return "" if wrong == FINE else f"{least}, one is {value:g}"
