"""Equalities in floating point: sums whose terms cancel, and residuals as shares of their own terms."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce

import numpy as np

from pointpred.records import FloatArray

Equalities = dict[str, tuple[FloatArray, FloatArray]]
"""The left side of each equality by its name, and the sizes of its terms before they cancel."""

TOLERANCE = 1e-9
"""The largest residual of an equality of computed matrices, as a share of its own terms."""

REMAINDER = 1e-12
"""An entry below this share of its terms is what rounding left of them."""
NO_DIGIT = 1e-14
"""An entry below this share of its terms has no correct digit."""


def without_rounding(whole: FloatArray, *terms: FloatArray, share: float = REMAINDER) -> FloatArray:
    """A sum of ``terms`` with zeros for the entries that are rounding; the sizes of the terms count.

    An entry of 1e-17 that should be 0 would count as a coupling when units are chosen, and as an f that
    still acts. ``share``: below which share of its terms an entry is rounding.
    """
    sizes = sum((np.abs(one) for one in terms), np.zeros_like(whole))
    return np.where(np.abs(whole) <= share * sizes, 0.0, whole)


def share_of_terms(
    residual: FloatArray,
    terms: FloatArray,
    units: FloatArray | None = None,
    *,
    rounding: FloatArray | None = None,
) -> float:
    """The largest share that an entry of a residual has of its own terms: 0 holds, 1 fails completely.

    Entry by entry, so that no other row, column, equality or unit hides that one fails. What lies within
    ``rounding`` counts as 0: a computed matrix holds 1e-17 where 0 is meant.

    Parameters: ``residual``; ``terms``, the sums of the absolute values of the terms before they cancel;
    ``rounding``, by default that of the terms in ``units`` (columns,); all (rows, columns). NaN where an
    entry, or one of its terms, is not finite.

    >>> share_of_terms(np.array([[0.0, 4e-7]]), np.array([[1e7, 4e-7]]))
    1.0
    >>> share_of_terms(np.array([[1e-16, 0.0], [0.0, 1e-17]]), np.array([[1e-16, 2.0], [4.0, 3.0]]))
    0.0
    >>> share_of_terms(np.array([[1.0]]), np.array([[np.inf]]))
    nan
    """
    if not residual.size:
        return 0.0
    if not np.isfinite(terms).all():
        return np.nan
    left = np.abs(residual)
    beside = row_rounding(terms, units) if rounding is None else rounding
    return float((np.where(left <= beside, 0.0, left) / or_one(terms)).max())


def allowed(terms: FloatArray) -> FloatArray:
    """How much may be left of each entry: ``TOLERANCE`` of its own terms, and what is rounding."""
    return TOLERANCE * terms + row_rounding(terms)


def row_rounding(terms: FloatArray, units: FloatArray | None = None) -> FloatArray:
    """What is rounding of each entry: a share of the largest term of its row, in the unit of its column."""
    columns = column_units(terms) if units is None else units
    return NO_DIGIT * np.asarray((terms / columns).max(axis=1, initial=0.0)[:, None] * columns, np.float64)


def column_units(stacked: FloatArray) -> FloatArray:
    """A unit for each column of rows that have units of their own: its largest share of a row, 1 if none."""
    sizes = np.abs(stacked)
    return or_one((sizes / or_one(sizes.max(axis=1, initial=0.0))[:, None]).max(axis=0, initial=0.0))


def summed(*products: tuple[FloatArray, ...]) -> tuple[FloatArray, FloatArray]:
    """A sum of products of matrices, and the same sum of their absolute values: the sizes of its terms.

    >>> left, terms = summed((np.eye(1), np.array([[2.0]])), (np.array([[-3.0]]),))
    >>> left.tolist(), terms.tolist()
    ([[-1.0]], [[5.0]])
    """
    each = [reduce(np.matmul, one) for one in products]
    sizes = [reduce(np.matmul, [np.abs(factor) for factor in one]) for one in products]
    return reduce(np.add, each), reduce(np.add, sizes)


def cleared(*products: tuple[FloatArray, ...], share: float = REMAINDER) -> FloatArray:
    """A sum of products of matrices with zeros for the entries that are rounding."""
    whole, sizes = summed(*products)
    return without_rounding(whole, sizes, share=share)


def largest(equalities: Equalities) -> dict[str, float]:
    """The largest residual of each equality."""
    return {name: float(np.abs(left).max(initial=0.0)) for name, (left, _) in equalities.items()}


def stacked(equalities: Equalities) -> FloatArray:
    """Every residual, one below the other."""
    return np.concatenate([left.ravel() for left, _ in equalities.values()])


def jacobian(residuals: Callable[[FloatArray], FloatArray], at: FloatArray) -> FloatArray:
    """The derivative by central differences, which are exact for quadratic equalities."""
    return np.array([0.5 * (residuals(at + step) - residuals(at - step)) for step in np.eye(len(at))]).T


def nearest_solutions(residuals: Callable[[FloatArray], FloatArray], count: int) -> list[FloatArray]:
    """The least-squares ``count`` numbers of affine equalities, of least norm, without and with rounding.

    Rows and columns are scaled to 1, and what the first solution leaves is solved for again: the residual of
    a row is then small beside its own terms. Numbers that are rounding beside the largest are 0 in the first
    answer; in much smaller units they may be more, and the second keeps them.
    """
    slope = jacobian(residuals, np.zeros(count))
    columns = or_one(np.abs(slope).max(axis=0, initial=0.0))
    rows = or_one(np.abs(slope / columns).max(axis=1, initial=0.0))
    scaled = slope / columns / rows[:, None]
    numbers: FloatArray = np.zeros(count)
    for _ in range(2):
        left = -residuals(numbers / columns) / rows
        numbers = numbers + np.linalg.lstsq(scaled, left, rcond=None)[0]
    most = np.full(numbers.shape, np.abs(numbers).max(initial=0.0))
    return [without_rounding(numbers, most, share=NO_DIGIT) / columns, numbers / columns]


def or_one(sizes: FloatArray) -> FloatArray:
    """Sizes to divide by: 1 in place of 0."""
    return np.where(sizes > 0.0, sizes, 1.0)
