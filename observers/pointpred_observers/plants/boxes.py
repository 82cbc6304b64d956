"""Boxes of scheduling variables, and matrices that are affine in each variable over them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product
from math import isfinite
from typing import Any

import numpy as np

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray, FloatTable
from pointpred_observers.numerics import equalities
from pointpred_observers.numerics.matrices import matrix, wrong

Point = Mapping[str, float]
Scheduled = Callable[[Point], FloatArray]
"""A matrix as a function of the scheduling variables."""
AXES_MOST = 12
"""Most axes of nonzero width: each doubles the number of vertices."""
BORDER = 1e-9
"""Fraction of the width by which a point may lie outside and still count as on the border."""
NO_DIFFERENCE = 1e-9
"""A difference below this share of the largest value of the same entry counts as none."""
CANCELLED = 4.0 * equalities.REMAINDER
"""The same beside the terms of a computed entry, of which a small share may have been set to zero."""
POINTS = 16
SEED = 20211217


@law
def weigh(axes: FloatTable, p: FloatArray, weights: FloatArray) -> bool:
    """The weight of each vertex of a box at a point; false for a point outside.

    ``axes``: low and high of each variable; the last one changes fastest.
    """
    count = 1
    weights[0] = 1.0
    for axis in range(len(axes)):
        low, high = axes[axis, 0], axes[axis, 1]
        slack = BORDER * (high - low)
        if not low - slack <= p[axis] <= high + slack:
            return False
        if low < high:
            up = min(max((p[axis] - low) / (high - low), 0.0), 1.0)
            for i in range(count - 1, -1, -1):
                weights[2 * i + 1] = weights[i] * up
                weights[2 * i] = weights[i] * (1.0 - up)
            count *= 2
    return True


class Box:
    """Closed intervals, one for each scheduling variable.

    An interval of zero width is allowed: its variable is constant and adds no vertices. A proof at the
    vertices does not cover points outside, so such points have no weights.

    Weights: mu_i(p) = product over the axes of (p - low) / (high - low) if vertex i is high there and (high -
    p) / (high - low) if it is low. They are nonnegative, sum to 1, and sum_i mu_i(p) M_i is M(p) for every M
    that is affine in each variable on its own.

    Parameters: ``bounds`` by name, low <= high, finite; at most 12 axes with a width.
    Raises ParameterError, also from ``weights`` for a point outside.

    Reference: Benyoucef et al. 2021, equation (25).

    >>> box = Box({"speed": (1.0, 3.0), "slope": (0.5, 0.5), "load": (0.0, 1.0)})
    >>> len(box.vertices)
    4
    >>> [float(share) for share in box.weights({"speed": 1.5, "slope": 0.5, "load": 1.0})]
    [0.0, 0.75, 0.0, 0.25]
    """

    def __init__(self, bounds: Mapping[str, tuple[float, float]]) -> None:
        if not isinstance(bounds, Mapping):
            raise wrong("bounds", "needs (low, high) by name", bounds)
        if not bounds:
            raise ParameterError("a box needs at least one axis, received none")
        self.bounds = {name: _interval(name, pair) for name, pair in bounds.items()}
        wide = sum(low < high for low, high in self.bounds.values())
        if wide > AXES_MOST:
            raise ParameterError(f"a box has at most {AXES_MOST} axes with a width, received {wide}")

    @property
    def names(self) -> tuple[str, ...]:
        """The scheduling variables in order."""
        return tuple(self.bounds)

    @property
    def axes(self) -> FloatArray:
        """Low and high of each variable."""
        return np.array(list(self.bounds.values()))

    @property
    def vertices(self) -> FloatArray:
        """One row per vertex, one column per variable; the last axis changes fastest."""
        ends = [(low,) if low == high else (low, high) for low, high in self.bounds.values()]
        return np.array(list(product(*ends)))

    @property
    def corners(self) -> list[dict[str, float]]:
        """The vertices as points."""
        return [self.named(vertex) for vertex in self.vertices]

    def named(self, point: FloatArray) -> dict[str, float]:
        """A row of ``vertices`` with the names of its variables."""
        return dict(zip(self.names, map(float, point), strict=True))

    def outside(self, point: Point) -> list[str]:
        """The variables whose values lie outside their intervals, or are NaN."""
        names = []
        for name, (low, high) in self.bounds.items():
            slack = BORDER * (high - low)
            if not low - slack <= self._value(point, name) <= high + slack:
                names.append(name)
        return names

    def nearest(self, point: Point) -> dict[str, float]:
        """The point of the box that is nearest on each axis; raises ParameterError for NaN."""
        place = {}
        for name, (low, high) in self.bounds.items():
            value = self._value(point, name)
            if value != value:
                raise wrong(name, "must be a number", value)
            place[name] = min(max(value, low), high)
        return place

    def weights(self, point: Point) -> FloatArray:
        """The weight of each vertex at a point; raises ParameterError for a point outside."""
        for name in self.outside(point):
            low, high = self.bounds[name]
            raise wrong(name, f"must lie in [{low:g}, {high:g}]", point[name])
        weights, values = np.zeros(len(self.vertices)), np.array([point[name] for name in self.names])
        weigh(self.axes, values.astype(np.float64), weights)
        return weights

    def mixed(self, matrices: FloatArray, point: Point) -> FloatArray:
        """The matrix at a point of the box from those at its vertices, (vertices, rows, columns)."""
        return np.asarray(np.tensordot(self.weights(point), matrices, 1))

    def _value(self, point: Point, name: str) -> float:
        if name not in point:
            raise ParameterError(f"a point needs {', '.join(self.names)}, received {', '.join(point)}")
        return point[name]


def _interval(name: str, pair: tuple[float, float]) -> tuple[float, float]:
    try:
        low, high = pair
        finite = is_number(low) and is_number(high) and isfinite(low) and isfinite(high)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise wrong(name, "needs (low, high)", pair) from unusable
    if not finite:
        raise wrong(name, "needs two finite numbers", pair)
    if low > high:
        raise wrong(name, "needs low <= high", pair)
    return float(low), float(high)


def scheduled(name: str, given: Any) -> Scheduled:
    """A matrix as a function of the scheduling variables; an array is the same everywhere."""
    constant = None if callable(given) else matrix(name, given)
    return given if constant is None else lambda point: constant


def at_vertices(function: Scheduled, box: Box, name: str, terms: Scheduled | None = None) -> FloatArray:
    """A matrix at each vertex of a box, which must be affine in each variable, (vertices, rows, columns).

    Compared with what its vertices give in the middle of the box and at random points, each entry by its
    own size and that of its ``terms``. Raises ParameterError.
    """
    found, inside = np.array([function(point) for point in box.corners]), samples(box)
    values = np.array([function(point) for point in inside])
    beside = None if terms is None else np.array([terms(point) for point in box.corners + inside])
    place = difference(np.array([box.mixed(found, point) for point in inside]), values, found, beside)
    if place is not None:
        row, column, error = place
        place_text = f"{error:.3g} in row {row + 1}, column {column + 1}"
        raise ParameterError(f"{name} must be affine in each variable; it is off by {place_text}", field=name)
    return found


def samples(box: Box) -> list[dict[str, float]]:
    """The middle of a box and points that are spread in it, the same every time."""
    lows, highs = box.axes.T
    random = np.random.default_rng(SEED)
    shares = np.vstack([np.full(len(lows), 0.5), random.uniform(size=(POINTS, len(lows)))])
    return [box.named(lows + share * (highs - lows)) for share in shares]


def difference(
    left: FloatArray, right: FloatArray, more: FloatArray, terms: FloatArray | None
) -> tuple[int, int, float] | None:
    """Row, column and size of a difference of lists of matrices beyond rounding; ``None`` if none.

    An entry is compared with its own largest value, also over the matrices ``more``, and of its ``terms``.
    """
    sizes = np.abs(np.concatenate([left, right, more])).max(axis=0)
    allowed = NO_DIFFERENCE * sizes + (0.0 if terms is None else CANCELLED * np.abs(terms).max(axis=0))
    error = np.abs(left - right).max(axis=0)
    wrong = ~(error <= allowed)
    if not wrong.any():
        return None
    with np.errstate(all="ignore"):
        share = np.where(wrong, error / sizes, -1.0)
    row, column = np.unravel_index(int(np.nan_to_num(share, nan=np.inf).argmax()), share.shape)
    return int(row), int(column), float(error[row, column])
