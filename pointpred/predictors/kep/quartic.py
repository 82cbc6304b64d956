"""The first zero of a quartic to the right of the origin, as a law: bracketed, without complex numbers."""

from __future__ import annotations

from math import nan, sqrt
from typing import NamedTuple

from pointpred.compiled import law

STEPS_MOST = 80
"""Bound on the cost of a zero: some six steps suffice, some forty where two zeros nearly meet."""


class Quartic(NamedTuple):
    """The polynomial c0 + c1 w + c2 w^2 + c3 w^3 + c4 w^4."""

    c0: float
    c1: float
    c2: float
    c3: float
    c4: float


@law
def value(p: Quartic, w: float) -> float:
    """The polynomial at w."""
    return p.c0 + w * (p.c1 + w * (p.c2 + w * (p.c3 + w * p.c4)))


@law
def derivative(p: Quartic) -> Quartic:
    """The polynomial's derivative."""
    return Quartic(p.c1, 2.0 * p.c2, 3.0 * p.c3, 4.0 * p.c4, 0.0)


@law
def bend(p: Quartic, far: float) -> tuple[float, float]:
    """The points in (0, far) where the second derivative 2 c2 + 6 c3 w + 12 c4 w^2 is zero, else ``far``."""
    a, b, c = 6.0 * p.c4, 3.0 * p.c3, p.c2
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
def between(p: Quartic, low: float, high: float) -> float:
    """The zero between low and high where the polynomial is monotone; ``high`` if there is none.

    Newton's steps as long as they stay within the bracket, which every step narrows; else it is halved.
    """
    at_low = value(p, low)
    if not at_low * value(p, high) < 0.0:
        return high
    w = 0.5 * (low + high)
    for _ in range(STEPS_MOST):
        here = value(p, w)
        if here == 0.0:
            return w
        if (here > 0.0) == (at_low > 0.0):
            low = w
        else:
            high = w
        slope = p.c1 + w * (2.0 * p.c2 + w * (3.0 * p.c3 + w * 4.0 * p.c4))
        new = w - here / slope if slope != 0.0 else low
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - w) <= 1e-13 * abs(w):
            return new
        w = new
    return w


@law
def first_zero(p: Quartic, far: float) -> float:
    """Smallest w in (0, far] where the polynomial comes down to zero from c0 > 0, else NaN."""
    if not p.c0 > 0.0:
        return nan
    bend_1, bend_2 = bend(p, far)
    bounds = bend_1, bend_2, far
    slope = derivative(p)
    left = 0.0
    for i in range(3):
        # Between two bends the slope is monotone: it is zero at most once, and splits the interval in two.
        turn = between(slope, left, bounds[i])
        if value(p, turn) <= 0.0:
            return between(p, left, turn)
        if value(p, bounds[i]) <= 0.0:
            return between(p, turn, bounds[i])
        left = bounds[i]
    return nan
