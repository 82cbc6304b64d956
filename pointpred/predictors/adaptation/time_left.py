"""The time left for one person: a sum of what is known, weighted as this person's movements had it.

In medians of the person's last durations, the time left is the sum of seven terms: two estimates, a constant,
the way left, the speed, how long the cursor has been slow, and how near it is to the predicted end. Their
weights are those of the least absolute error over the person's finished movements, the earlier ones
discounted, and of everybody's weights as a prior. The least absolute error makes the sum a median.

Reference: recursive least squares with weights 1 / |residual|, which approximate the least absolute error
(Schlossmacher 1973, "An iterative technique for absolute deviations curve fitting").
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from pointpred.compiled import law, layout
from pointpred.predictors.adaptation import arrival_intervals, moments
from pointpred.predictors.adaptation.time_left_prior import PRIOR
from pointpred.records import FloatArray
from pointpred.stage import Slot, offsets

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

# What is learned, relative to its place: sums of the products of terms, of terms and residuals under the
# prior's weights, each weighted.
PRODUCTS, RESIDUALS, LEARNED = offsets(SUMS, TERMS)
MOVEMENTS = 1.001 / (1.0 - KEEP)
"""What a sum comes to that takes in 1 with each movement, for ever; rounding included."""
MOST_PRODUCT = LONGEST**2 / SMALL * MOVEMENTS
MOST_RESIDUAL = 1e9
"""No sum of residuals comes near it."""
SLOTS = (
    Slot("sums of products", SUMS, -MOST_PRODUCT, MOST_PRODUCT),
    Slot("sums of residuals", TERMS, -MOST_RESIDUAL, MOST_RESIDUAL),
)
"""What is known of a person's time left, in the order of the layout."""
LEAST_PIVOT = 0.01
"""The prior's sums alone have no smaller pivot, and a person's make none smaller."""

# The movement, relative to its place: whether its weights are there, the weights; its moments, each with the
# time left that was stated, its spread, and the terms.
_, LEFT, SPREAD, FIRST_TERM = range(4)
MOMENT, MOST = FIRST_TERM + TERMS, 32
READY, WEIGHTS, MOMENTS, STATES = offsets(1, TERMS, moments.FIRST + MOMENT * MOST)


"""The weights of the terms, then sums of products: SUMS of them."""


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


@law
def terms(
    estimates: Estimates, way: Way, pace: Pace, since: float, median: float
) -> tuple[float, float, float, float, float, float, float]:
    """What the time left is a sum of, in medians of the last durations; ``since`` s have passed."""
    mixed = min(estimates.mixed / median, LONGEST)
    predicted = min(estimates.predicted / median, LONGEST)
    share = way.left / (way.left + way.done)
    slow = min(pace.slow_s / median, 1.0) / (since / median + START)
    near = NEAR * NEAR / (NEAR * NEAR + share * share)
    return mixed, predicted, 1.0, share, pace.of_peak * predicted, slow, near


@law
def factor(memory: FloatArray, person: int, prior: FloatArray, out: FloatArray) -> float:
    """Factor the sums and the prior's into L D L' in place of their lower triangle; returns the least of D.

    ``prior``: the weights, then the sums of everybody.
    """
    least = np.inf
    for i in range(SUMS):
        out[i] = memory[person + PRODUCTS + i] + prior[TERMS + i]
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
def solve(memory: FloatArray, person: int, prior: FloatArray, weights: FloatArray) -> None:
    """The weights of the terms for this person."""
    factors = np.empty(SUMS)
    factor(memory, person, prior, factors)
    for i in range(TERMS):
        weights[i] = memory[person + RESIDUALS + i]
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
def stated(
    memory: FloatArray,
    place: tuple[int, int, int],
    cursor: tuple[float, float, float],
    since: float,
    median: float,
    estimates: Estimates,
    way: Way,
    pace: Pace,
) -> tuple[float, float]:
    """The time left in s and the spread of its logarithm, ``since`` s after the start; remembers both.

    ``place``: of the person's time left, of the person's intervals, of the movement; ``cursor``: t, x, y.
    """
    person, intervals, at = place
    if memory[at + READY] == 0.0:
        solve(memory, person, PRIOR, memory[at + WEIGHTS : at + MOMENTS])
        memory[at + READY] = 1.0
    known = terms(estimates, way, pace, since, median)
    total = 0.0
    for i in range(TERMS):
        total += memory[at + WEIGHTS + i] * known[i]
    left = max(min(total, FURTHEST) * median, LEAST * min(estimates.predicted, median))
    spread = arrival_intervals.spread(memory, intervals, since / (since + left))
    moment = moments.new_moment(memory, at + MOMENTS, cursor, MOMENT, MOST)
    if moment >= 0:
        memory[moment + LEFT], memory[moment + SPREAD] = left, spread
        for i in range(TERMS):
            memory[moment + FIRST_TERM + i] = known[i]
    return left, spread


@law
def learn(
    memory: FloatArray,
    place: tuple[int, int, int],
    span: tuple[float, float],
    median: float,
    prior: FloatArray,
) -> None:
    """Learn from a movement over ``span``, its start and its arrival in s; ``place`` as for ``stated``."""
    person, intervals, at = place
    if memory[at + READY] == 0.0:
        return
    step = arrival_intervals.next_step(memory, intervals) / JUDGED
    for i in range(LEARNED):
        memory[person + i] *= KEEP
    k = 0
    for judged in range(JUDGED):
        share = (judged + 0.5) / JUDGED
        k = moments.moment_at(memory, at + MOMENTS, k, span, share, MOMENT)
        moment = at + MOMENTS + moments.FIRST + MOMENT * k
        seconds = max(span[1] - memory[moment + moments.T], SHORTEST_S)
        arrival_intervals.judge(
            memory, intervals, share, step, (memory[moment + LEFT], memory[moment + SPREAD]), seconds
        )
        left = min(seconds / median, FURTHEST)
        off, off_prior = left, left
        for i in range(TERMS):
            off -= memory[at + WEIGHTS + i] * memory[moment + FIRST_TERM + i]
            off_prior -= prior[i] * memory[moment + FIRST_TERM + i]
        weight = 1.0 / (max(abs(off), SMALL) * JUDGED)
        for i in range(TERMS):
            term = weight * memory[moment + FIRST_TERM + i]
            memory[person + RESIDUALS + i] += term * off_prior
            for j in range(i + 1):
                memory[person + PRODUCTS + i * (i + 1) // 2 + j] += term * memory[moment + FIRST_TERM + j]


FINE, NOT_POSITIVE = 0, 31


@layout
def fault(learned: FloatArray) -> tuple[int, float]:
    """What is wrong with numbers that are within the bounds of their slots, and the number that is wrong."""
    least = factor(learned, 0, PRIOR, np.empty(SUMS))
    return (FINE, 0.0) if least >= LEAST_PIVOT else (NOT_POSITIVE, least)


def doubt(learned: FloatArray) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, value = fault(learned)
    least = f"sums of products must be those of real terms, with pivots of at least {LEAST_PIVOT:g}"
    return "" if wrong == FINE else f"{least}, one is {value:g}"
