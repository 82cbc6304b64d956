"""The least gamma of the camera's observer, minimised with as many digits as mpmath is set to."""

from __future__ import annotations

from itertools import product
from typing import Any

import mpmath

from pointpred_observers.unknown_input.gains import ROOMS


def least_gamma(p: mpmath.mpf, sigma: mpmath.mpf, bounds: dict[str, Any]) -> mpmath.mpf:
    """The largest eigenvalue of (-M)^-1 P R R' P over the vertices, with P = diag(p, 1) on (chi, eta)."""
    worst = mpmath.mpf(0)
    # The signs of a_z, w_x and w_y do not change the eigenvalues.
    a_z, w_x, w_y = (bounds[name][1] for name in ("a_z", "w_x", "w_y"))
    for zero, eta in product(bounds["zero"], bounds["eta"]):
        half = sigma / 2
        m = mpmath.matrix([[2 * p * (zero + half), a_z], [a_z, 2 * (eta + half)]])
        right = mpmath.matrix([[p * p, 0], [0, 1 + w_x**2 + w_y**2]])
        if m[0, 0] >= 0 or m[0, 0] * m[1, 1] - m[0, 1] ** 2 <= 0:
            return mpmath.inf
        whole = -(m**-1) * right
        trace, det = whole[0, 0] + whole[1, 1], whole[0, 0] * whole[1, 1] - whole[0, 1] * whole[1, 0]
        worst = max(worst, (trace + mpmath.sqrt(trace**2 - 4 * det)) / 2)
    return worst


def minimum(sigma: float, bounds: dict[str, tuple[float, float]]) -> mpmath.mpf:
    """The gamma at the least gamma + 0.01 trace P, which is convex in p, by golden sections in log p."""
    exact = {name: tuple(mpmath.mpf(str(round(one, 12))) for one in pair) for name, pair in bounds.items()}
    s, ratio = mpmath.mpf(str(sigma)), (mpmath.sqrt(5) - 1) / 2

    def value(log_p: mpmath.mpf) -> mpmath.mpf:
        p = mpmath.exp(log_p)
        return least_gamma(p, s, exact) + ROOMS[0].weight * (p + 1)

    low, high = mpmath.mpf(0), mpmath.mpf(14)
    for _ in range(50):
        one, two = high - ratio * (high - low), low + ratio * (high - low)
        first, second = value(one), value(two)
        if first == second == mpmath.inf or first > second:
            low = one
        else:
            high = two
    return least_gamma(mpmath.exp((low + high) / 2), s, exact)
