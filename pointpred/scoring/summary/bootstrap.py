"""How sure is a ratio of means? Bootstrap over people."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.records import FloatArray

DRAWS = 2000
LEVEL = 0.95
BLOCK = 4_000_000
"""Random numbers in memory at once."""


class Intervals(msgspec.Struct, frozen=True):
    """Percentile intervals of the ratio of two means, a row a measure."""

    low: FloatArray
    high: FloatArray
    resampled: str
    """What was drawn with replacement: ``"users"``, or ``"trials"`` where there is only one user."""
    units: int
    """How many of them there are."""


def ratio_intervals(
    above: FloatArray,
    below: FloatArray,
    users: Sequence[str],
    *,
    seed: int = 0,
    draws: int = DRAWS,
    level: float = LEVEL,
) -> Intervals:
    """Intervals of mean(above) / mean(below), column by column.

    ``below`` is (trials, measures), ``above`` (trials, any multiple of measures): ``below`` is repeated to
    the right, so that several predictors are compared with one floor on the same draws.

    Assumes that people are drawn independently from those the claim is about; few people make the interval
    too narrow. With one person the trials are drawn instead: the interval is then not valid for other people.

    Every draw takes as many people as there are, with replacement, each with all trials, and the same people
    for all columns. The bounds are the (1 - level) / 2 and (1 + level) / 2 quantiles; NaN where a draw's
    denominator is 0, and where there is only one person with one trial: every draw would be the same.

    Reference: Efron and Tibshirani 1993, chapter 13 (percentile interval).

    >>> error, floor = np.array([[1.0], [3.0], [2.0]]), np.array([[2.0], [6.0], [4.0]])
    >>> intervals = ratio_intervals(error, floor, ["ann", "bob", "eve"])
    >>> intervals.low.tolist(), intervals.high.tolist(), intervals.units
    ([0.5], [0.5], 3)
    """
    names, unit = np.unique(np.asarray(users, dtype=str), return_inverse=True)
    resampled = "users"
    if len(names) == 1:
        resampled, unit = "trials", np.arange(len(above))
    units, width = (int(unit.max()) + 1 if len(unit) else 0), above.shape[1]
    if units < 2:
        nothing = np.full(width, np.nan)
        return Intervals(nothing, nothing.copy(), resampled, units)
    totals = drawn_totals(_sums(np.hstack([above, below]), unit), seed, draws)
    floor = np.tile(totals[:, width:], width // below.shape[1])
    return Intervals(*ratio_bounds(totals[:, :width], floor, level), resampled, units)


def drawn_totals(sums: FloatArray, seed: int = 0, draws: int = DRAWS) -> FloatArray:
    """The totals of each draw, (draws, columns): as many rows of ``sums`` as there are, with replacement."""
    units = len(sums)
    generator = np.random.default_rng(seed)
    totals = np.empty((draws, sums.shape[1]))
    block = max(1, BLOCK // units)
    for first in range(0, draws, block):
        size = min(block, draws - first)
        sample = generator.integers(0, units, (size, units)) + units * np.arange(size)[:, None]
        counts = np.bincount(sample.ravel(), minlength=size * units).reshape(size, units)
        totals[first : first + size] = counts @ sums
    return totals


def ratio_bounds(above: FloatArray, below: FloatArray, level: float = LEVEL) -> tuple[FloatArray, FloatArray]:
    """Quantiles of the ratios of drawn totals, column by column; NaN where a denominator is 0."""
    ratios = np.full(above.shape, np.nan)
    np.divide(above, below, out=ratios, where=below > 0.0)
    low, high = np.quantile(ratios, [(1.0 - level) / 2.0, (1.0 + level) / 2.0], axis=0)
    return low, high


def _sums(values: FloatArray, unit: NDArray[np.intp]) -> FloatArray:
    """The sum of the rows of each unit; every number from 0 to the largest occurs."""
    order = np.argsort(unit, kind="stable")
    first = np.flatnonzero(np.diff(unit[order], prepend=-1))
    sums: FloatArray = np.add.reduceat(values[order], first, axis=0)
    return sums
