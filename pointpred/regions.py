"""The region of a prediction: the ellipse that holds the endpoint with a given probability.

``reach`` says how far such a region goes, ``ellipse`` what it looks like. ``squared_radius`` in
``predictors/adaptation/region_widening.py`` is the Student law of ``reach`` in compiled code.
"""

from __future__ import annotations

from math import atan2, expm1, hypot, inf, isfinite, log1p, nan, sqrt
from numbers import Real

import msgspec

from pointpred.errors import ParameterError

NEARLY_NORMAL = 1e16
"""From so many degrees of freedom on, a Student law equals a normal one in float precision."""
LARGEST_LOG = 700.0
"""A region that grows further than this logarithm is infinite: exp(700) is about as large as floats get."""

HALF = 0.5
"""The level at which laws of different tails are compared."""


class Region(msgspec.Struct, frozen=True):
    """An ellipse on the screen: centre ``x y`` and half axes ``major >= minor`` in px.

    ``angle`` is that of the major axis, in radians from x towards y, which grows downwards; it lies within
    (-pi / 2, pi / 2].
    """

    x: float
    y: float
    major: float
    minor: float
    angle: float


def reach(level: float, tail: float) -> float:
    """Squared Mahalanobis distance up to which the region of a level in (0, 1) goes.

    Normal law (``tail`` NaN or infinite): -2 ln(1 - level). Bivariate Student law of ``tail`` degrees of
    freedom: tail ((1 - level)^(-2 / tail) - 1); infinite where that is too large for a float. NaN where
    ``tail`` is not positive: there is no such law.
    """
    normal = -2.0 * log1p(-level)
    if not tail < NEARLY_NORMAL:
        return normal
    if tail <= 0.0:
        return nan
    if normal / tail > LARGEST_LOG:
        return inf
    return tail * expm1(normal / tail)


def ellipse(level: float, sxx: float, sxy: float, syy: float, tail: float) -> tuple[float, float, float]:
    """Half axes (major, minor) px and angle of the region of a level, from its law's scale matrix and tail.

    All NaN where a number is missing (NaN), the matrix has no inside, or the ellipse is too large for a
    finite number, as with a tail near 0. The smaller eigenvalue is the determinant over the larger one: a
    difference would lose the breadth of a thin region to rounding.
    """
    determinant = sxx * syy - sxy * sxy
    far = reach(level, tail)
    if not (sxx > 0.0 and syy > 0.0 and 0.0 < determinant < inf and far > 0.0):
        return nan, nan, nan
    larger = 0.5 * (sxx + syy) + hypot(0.5 * (sxx - syy), sxy)
    major, minor = sqrt(far * larger), sqrt(far * (determinant / larger))
    if not isfinite(major):
        return nan, nan, nan
    return major, min(minor, major), 0.5 * atan2(2.0 * sxy, sxx - syy)


def region_of(
    level: float, x: float, y: float, sxx: float, sxy: float, syy: float, tail: float = nan
) -> Region | None:
    """The region of a level around (x, y) px, from the scale matrix in px^2 and the tail (NaN: normal).

    ``None`` where there is no such ``ellipse``, or no place for it.
    """
    major, minor, angle = ellipse(level, sxx, sxy, syy, tail)
    if not (isfinite(x) and isfinite(y) and major == major):
        return None
    return Region(x, y, major, minor, angle)


def as_normal(sxx: float, sxy: float, syy: float, tail: float) -> tuple[float, float, float]:
    """The covariance (px^2) of the normal law whose 50 % region is that of this Student law.

    For a rule that asks for a standard deviation: a Student law of a ``tail`` of 2 or less has none. NaN
    where no region is claimed or it is infinite; a normal law (``tail`` NaN) is returned as it is.
    """
    factor = reach(HALF, tail) / reach(HALF, nan)
    if factor == inf:
        factor = nan
    return factor * sxx, factor * sxy, factor * syy


def probability(level: object) -> float:
    """A level as a float; raises ParameterError unless it is a real number in (0, 1), of Python or numpy."""
    if not isinstance(level, bool) and isinstance(level, Real) and 0.0 < float(level) < 1.0:
        return float(level)
    raise ParameterError(f"level must be a probability in (0, 1), received {level!r}")
