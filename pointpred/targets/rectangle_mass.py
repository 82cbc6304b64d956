"""How much of a predicted law lies in a rectangle that people aim at the centre of."""

from __future__ import annotations

from math import exp, inf, log, pi, sqrt
from typing import NamedTuple

import numpy as np

from pointpred.compiled import law

EFFECTIVE = 4.133
"""Endpoints scatter about a target's centre with a standard deviation of its width over this number."""

NODES, WEIGHTS = (tuple(values.tolist()) for values in np.polynomial.legendre.leggauss(5))
_FEWER = [np.polynomial.legendre.leggauss(count) for count in (3, 4, 5)]
PLACES, SHARES = (tuple(np.concatenate(part).tolist()) for part in zip(*_FEWER, strict=True))
"""Of 3, 4 and 5 nodes, one after the other."""
BEGINS = (0, 0, 0, 0, 3, 7)
"""Where those of each count begin."""
OUTER, INNER = NODES[4], NODES[3]
W_OUTER, W_INNER, W_MIDDLE = WEIGHTS[4], WEIGHTS[3], WEIGHTS[2]

NEGLIGIBLE = -40.0
"""A node whose density is the exponential of this, against the densest node's, adds nothing."""
STEEPEST = 300.0
"""Exponents up to this are multiplied as factors, which can then neither overflow nor vanish."""
FLAT3, FLAT4 = 16.0, 6.0
"""Squares of a Student law's core over a rectangle's half size: from these on 3 or 4 nodes are enough ..."""
HEAVIEST = 8.0
"""... up to so many degrees of freedom."""


@law
def log_density(far: float, tail: float) -> float:
    """Logarithm of a law's density, less that at its centre, at a squared Mahalanobis distance."""
    if tail != tail:
        return -0.5 * far
    return -0.5 * (tail + 2.0) * log(1.0 + far / tail)


class Distance(NamedTuple):
    """A squared Mahalanobis distance over the unit square.

    At (u, v) in [-1, 1] x [-1, 1] it is far + 2 (u gx + v gy + u v gxy) + u^2 hx + v^2 hy.
    """

    far: float
    gx: float
    gy: float
    gxy: float
    hx: float
    hy: float


@law
def node_sum(distance: Distance, tail: float) -> float:
    """Logarithm of the weighted densities at 5 x 5 nodes: any law, any distance."""
    far, gx, gy, gxy, hx, hy = distance
    nearest = inf
    for i in range(5):
        u = NODES[i]
        for j in range(5):
            v = NODES[j]
            here = far + 2.0 * (u * gx + v * gy + u * v * gxy) + u * u * hx + v * v * hy
            nearest = min(nearest, here)
    top = log_density(nearest, tail)
    total = 0.0
    for i in range(5):
        u = NODES[i]
        for j in range(5):
            v = NODES[j]
            here = far + 2.0 * (u * gx + v * gy + u * v * gxy) + u * u * hx + v * v * hy
            less = log_density(here, tail) - top
            if less > NEGLIGIBLE:
                total += WEIGHTS[i] * WEIGHTS[j] * exp(less)
    return log(total) + top


@law
def enough(half2: float, tail: float) -> int:
    """How many nodes a Student law needs along an axis, by the squared half size in deviations."""
    if FLAT3 * half2 < tail:
        return 3
    return 4 if FLAT4 * half2 < tail else 5


@law
def student_sum(distance: Distance, tail: float) -> float:
    """``node_sum`` of a heavy-tailed law, with fewer nodes where it is flat over the rectangle."""
    far, gx, gy, gxy, hx, hy = distance
    power, whole = -0.5 * (tail + 2.0), 1.0 / (tail + far)
    across, along = enough(hy, tail), enough(hx, tail)
    total = 0.0
    for i in range(BEGINS[along], BEGINS[along] + along):
        u, part = PLACES[i], 0.0
        fixed, slope = 1.0 + whole * (2.0 * u * gx + u * u * hx), 2.0 * whole * (gy + u * gxy)
        for j in range(BEGINS[across], BEGINS[across] + across):
            v = PLACES[j]
            part += SHARES[j] * exp(power * log(fixed + v * (slope + v * whole * hy)))
        total += SHARES[i] * part
    return log(total) + log_density(far, tail)


@law
def normal_sum(distance: Distance) -> float:
    """``node_sum`` of a normal law less its value at the centre: a product along x, along y and of both.

    11 exponentials for 25 nodes, because nodes lie in pairs.
    """
    _, gx, gy, gxy, hx, hy = distance
    xo, xi = W_OUTER * exp(-0.5 * OUTER * OUTER * hx), W_INNER * exp(-0.5 * INNER * INNER * hx)
    yo, yi = W_OUTER * exp(-0.5 * OUTER * OUTER * hy), W_INNER * exp(-0.5 * INNER * INNER * hy)
    po, pi_ = exp(OUTER * gx), exp(INNER * gx)
    qo, qi = exp(OUTER * gy), exp(INNER * gy)
    oo, oi, ii = exp(-OUTER * OUTER * gxy), exp(-OUTER * INNER * gxy), exp(-INNER * INNER * gxy)
    x1, x2, x4, x5 = xo * po, xi * pi_, xi / pi_, xo / po
    y1, y2, y4, y5 = yo * qo, yi * qi, yi / qi, yo / qo
    outer = (x1 * y1 + x5 * y5) * oo + (x1 * y5 + x5 * y1) / oo
    between = (x1 * y2 + x5 * y4 + x2 * y1 + x4 * y5) * oi + (x1 * y4 + x5 * y2 + x2 * y5 + x4 * y1) / oi
    inner = (x2 * y2 + x4 * y4) * ii + (x2 * y4 + x4 * y2) / ii
    cross = W_MIDDLE * (x1 + x2 + x4 + x5 + y1 + y2 + y4 + y5 + W_MIDDLE)
    return log(outer + between + inner + cross)


@law
def log_mass(
    rectangle: tuple[float, float, float, float], spread: tuple[float, float, float, float]
) -> float:
    """Logarithm of a law's mass in a rectangle: (dx, dy, width, height) px, its centre from the law's.

    ``spread``: (sxx, sxy, syy, tail), a Student law with ``tail`` degrees of freedom and scale matrix
    (sxx, sxy, syy) px^2, a normal one where ``tail`` is NaN. It is widened first: people aim at centres and
    scatter in proportion to the width, so an endpoint predicted exactly is still known only to
    (width / 4.133, height / 4.133); these variances are
    added to the scale matrix, which is exact for a normal law. Quadrature with 5 x 5 nodes over the
    rectangle, which after the widening is at most 4.133 deviations wide in each direction: within 0.2 % of
    a mass. Cheaper sums of the same, ``normal_sum`` and ``student_sum``, stay within 3e-4 of a mass of
    ``node_sum``. Nothing underflows, however far the rectangle.

    Reference: MacKenzie 1992, section 2.3: the effective width is 4.133 standard deviations of endpoints.

    >>> from math import exp, nan
    >>> round(exp(log_mass((0.0, 0.0, 4.133, 4.133), (0.0, 0.0, 0.0, nan))), 3)  # 96 % along each axis
    0.925
    """
    dx, dy, width, height = rectangle
    sxx, sxy, syy, tail = spread
    sxx += (width / EFFECTIVE) ** 2
    syy += (height / EFFECTIVE) ** 2
    det = sxx * syy - sxy * sxy
    a, b = 0.5 * width, 0.5 * height
    ixx, ixy, iyy = syy / det, -sxy / det, sxx / det
    # The squared distance at (dx + a u, dy + b v).
    far = ixx * dx * dx + 2.0 * ixy * dx * dy + iyy * dy * dy
    gx, gy, gxy = a * (ixx * dx + ixy * dy), b * (ixy * dx + iyy * dy), a * b * ixy
    hx, hy = ixx * a * a, iyy * b * b
    distance = Distance(far, gx, gy, gxy, hx, hy)
    if tail != tail and abs(gx) + abs(gy) + abs(gxy) + hx + hy < STEEPEST:
        total = normal_sum(distance) - 0.5 * far
    elif tail <= HEAVIEST:
        total = student_sum(distance, tail)
    else:
        total = node_sum(distance, tail)
    return total + log(0.25 * width * height / (2.0 * pi * sqrt(det)))
