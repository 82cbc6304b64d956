"""The first zero of a quartic to the right of the origin, as a law: bracketed, without complex numbers."""

from __future__ import annotations

from math import nan, sqrt

from pointpred.compiled import law

STEPS_MOST = 80
"""Bound on the cost of a zero: some six steps suffice, some forty where two zeros nearly meet."""


@law
def bend(c2: float, c3: float, c4: float, far: float) -> tuple[float, float]:
    """The points in (0, far) where the second derivative 2 c2 + 6 c3 w + 12 c4 w^2 is zero, else ``far``."""
    a, b, c = 6.0 * c4, 3.0 * c3, c2
    discriminant = b * b - 4.0 * a * c
    if discriminant < 0.0:
        return far, far
    half = -0.5 * (b + (sqrt(discriminant) if b >= 0.0 else -sqrt(discriminant)))
    one = half / a if a != 0.0 else far
    other = c / half if half != 0.0 else far
    one = one if 0.0 < one < far else far
    other = other if 0.0 < other < far else far
    return min(one, other), max(one, other)


@law
def value(c0: float, c1: float, c2: float, c3: float, c4: float, w: float) -> float:
    """The polynomial at w."""
    return c0 + w * (c1 + w * (c2 + w * (c3 + w * c4)))


@law
def between(c0: float, c1: float, c2: float, c3: float, c4: float, low: float, high: float) -> float:
    """The zero between low and high where the polynomial is monotone; ``high`` when it has none there.

    Newton's steps as long as they stay within the bracket, which every step narrows; else it is halved.
    """
    at_low = value(c0, c1, c2, c3, c4, low)
    if not at_low * value(c0, c1, c2, c3, c4, high) < 0.0:
        return high
    w = 0.5 * (low + high)
    for _ in range(STEPS_MOST):
        here = value(c0, c1, c2, c3, c4, w)
        if here == 0.0:
            return w
        if (here > 0.0) == (at_low > 0.0):
            low = w
        else:
            high = w
        slope = c1 + w * (2.0 * c2 + w * (3.0 * c3 + w * 4.0 * c4))
        new = w - here / slope if slope != 0.0 else low
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - w) <= 1e-13 * abs(w):
            return new
        w = new
    return w


@law
def first_zero(c0: float, c1: float, c2: float, c3: float, c4: float, far: float) -> float:
    """Smallest w in (0, far] where c0 + c1 w + ... + c4 w^4 comes down to zero from c0 > 0, else NaN."""
    if not c0 > 0.0:
        return nan
    bend_1, bend_2 = bend(c2, c3, c4, far)
    bounds = bend_1, bend_2, far
    left = 0.0
    for i in range(3):
        # Between two bends the slope is monotone: it is zero at most once, and splits the interval in two.
        turn = between(c1, 2.0 * c2, 3.0 * c3, 4.0 * c4, 0.0, left, bounds[i])
        if value(c0, c1, c2, c3, c4, turn) <= 0.0:
            return between(c0, c1, c2, c3, c4, left, turn)
        if value(c0, c1, c2, c3, c4, bounds[i]) <= 0.0:
            return between(c0, c1, c2, c3, c4, turn, bounds[i])
        left = bounds[i]
    return nan
