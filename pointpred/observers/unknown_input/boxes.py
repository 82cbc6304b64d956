"""Boxes of scheduling variables: their vertices, and the multilinear weights of a point among them."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from math import isfinite

import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray

AXES_MOST = 12
"""Most axes of nonzero width: each doubles the number of vertices."""
ROUNDING = 1e-9
"""Fraction of the width by which a point may lie outside and still count as on the border."""


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
            raise ParameterError(
                f"a box needs (low, high) by name, received {bounds!r}", field="bounds", value=bounds
            )
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
    def vertices(self) -> FloatArray:
        """One row per vertex, one column per variable; the last axis changes fastest."""
        ends = [(low,) if low == high else (low, high) for low, high in self.bounds.values()]
        return np.array(list(product(*ends)))

    def named(self, point: FloatArray) -> dict[str, float]:
        """A row of ``vertices`` with the names of its variables."""
        return dict(zip(self.names, map(float, point), strict=True))

    def outside(self, point: Mapping[str, float]) -> list[str]:
        """The variables whose values lie outside their intervals, or are NaN."""
        names = []
        for name, (low, high) in self.bounds.items():
            slack = ROUNDING * (high - low)
            if not low - slack <= self._value(point, name) <= high + slack:
                names.append(name)
        return names

    def nearest(self, point: Mapping[str, float]) -> dict[str, float]:
        """The point of the box that is nearest on each axis; raises ParameterError for NaN."""
        place = {}
        for name, (low, high) in self.bounds.items():
            value = self._value(point, name)
            if value != value:
                raise ParameterError(f"{name} must be a number, received {value!r}", field=name, value=value)
            place[name] = min(max(value, low), high)
        return place

    def weights(self, point: Mapping[str, float]) -> FloatArray:
        """The weight of each vertex at a point; raises ParameterError for a point outside."""
        for name in self.outside(point):
            low, high = self.bounds[name]
            raise ParameterError(
                f"{name} must lie in [{low:g}, {high:g}], received {point[name]!r}",
                field=name,
                value=point[name],
            )
        shares = np.ones(1)
        for name, (low, high) in self.bounds.items():
            if low < high:
                up = min(max((point[name] - low) / (high - low), 0.0), 1.0)
                shares = np.outer(shares, (1.0 - up, up)).ravel()
        return shares

    def _value(self, point: Mapping[str, float], name: str) -> float:
        if name not in point:
            raise ParameterError(f"a point needs {', '.join(self.names)}, received {', '.join(point)}")
        return point[name]


def _interval(name: str, pair: tuple[float, float]) -> tuple[float, float]:
    try:
        low, high = pair
    except (TypeError, ValueError) as unusable:
        raise ParameterError(
            f"{name} needs (low, high), received {pair!r}", field=name, value=pair
        ) from unusable
    if not (is_number(low) and is_number(high) and isfinite(low) and isfinite(high)):
        raise ParameterError(f"{name} needs two finite numbers, received {pair!r}", field=name, value=pair)
    if low > high:
        raise ParameterError(f"{name} needs low <= high, received {pair!r}", field=name, value=pair)
    return float(low), float(high)
