"""The density of a mixture of bivariate Student and normal laws, and how much of it lies above a threshold.

Probabilities are counted with points that stand for equal shares of each part: a spiral of equal turns whose
squared radii are the quantiles of the part's own law (Vogel 1979).
"""

from __future__ import annotations

from math import exp, expm1, log, log1p, pi, sqrt

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray

# A part, a row of a table: its share, its centre in px, its scale matrix in px^2, its tail; 0: a normal law.
SHARE, X, Y, SXX, SXY, SYY, TAIL, WIDTH = range(8)
TURN_COS, TURN_SIN = -0.7373688780783197, 0.6754902942615238
"""The turn from one point of the spiral to the next: the golden angle."""
HALVINGS = 60
LEAST = 1e-280
"""A density below counts as none."""


@law
def squared_radius(share: float, tail: float) -> float:
    """Squared Mahalanobis distance within which a share of a part's law lies."""
    normal = -2.0 * log1p(-share)
    return float(normal if tail == 0.0 else tail * expm1(normal / tail))


@law
def part_density(parts: FloatArray, k: int, x: float, y: float) -> float:
    """The density of a part at a place, times its share, in 1 / px^2."""
    sxx, sxy, syy, tail = parts[k, SXX], parts[k, SXY], parts[k, SYY], parts[k, TAIL]
    determinant = sxx * syy - sxy * sxy
    dx, dy = x - parts[k, X], y - parts[k, Y]
    far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant
    log_density = -0.5 * far if tail == 0.0 else -0.5 * (tail + 2.0) * log1p(far / tail)
    return float(parts[k, SHARE] * exp(log_density) / (2.0 * pi * sqrt(determinant)))


@law
def density(parts: FloatArray, count: int, x: float, y: float) -> float:
    """The density of the mixture at a place, in 1 / px^2."""
    total = 0.0
    for k in range(count):
        total += part_density(parts, k, x, y)
    return total


@law
def densities(parts: FloatArray, count: int, points: int, out: FloatArray) -> None:
    """The density at so many points of each part, a row of ``out`` each."""
    for k in range(count):
        wide = sqrt(parts[k, SXX])
        slant = parts[k, SXY] / wide
        broad = sqrt(parts[k, SYY] - slant * slant)
        cos, sin = 1.0, 0.0
        for i in range(points):
            radius = sqrt(squared_radius((i + 0.5) / points, parts[k, TAIL]))
            x = parts[k, X] + radius * wide * cos
            y = parts[k, Y] + radius * (slant * cos + broad * sin)
            out[k, i] = density(parts, count, x, y)
            cos, sin = cos * TURN_COS - sin * TURN_SIN, cos * TURN_SIN + sin * TURN_COS


@law
def share_above(parts: FloatArray, count: int, points: int, known: FloatArray, threshold: float) -> float:
    """The probability of the places that are denser than a threshold; ``known``: by ``densities``."""
    total = 0.0
    for k in range(count):
        above = 0
        for i in range(points):
            above += 1 if known[k, i] > threshold else 0
        total += parts[k, SHARE] * above / points
    return total


@law
def content(parts: FloatArray, count: int, x: float, y: float, points: int) -> float:
    """The probability of the places that are denser than a place: exact for a single part."""
    if count == 1:
        own, best = part_density(parts, 0, x, y), part_density(parts, 0, parts[0, X], parts[0, Y])
        tail = parts[0, TAIL]
        power = 1.0 if tail == 0.0 else tail / (tail + 2.0)
        return float(1.0 - (own / best) ** power)
    known = np.empty((count, points))
    densities(parts, count, points, known)
    return share_above(parts, count, points, known, density(parts, count, x, y))


@law
def threshold(parts: FloatArray, count: int, level: float, points: int) -> float:
    """The density above which places of the probability ``level`` lie: exact for a single part."""
    if count == 1:
        tail = parts[0, TAIL]
        far = squared_radius(level, tail)
        log_density = -0.5 * far if tail == 0.0 else -0.5 * (tail + 2.0) * log1p(far / tail)
        return part_density(parts, 0, parts[0, X], parts[0, Y]) * exp(log_density)
    known = np.empty((count, points))
    densities(parts, count, points, known)
    most = LEAST  # no place is denser than all parts are at their centres
    for k in range(count):
        most += part_density(parts, k, parts[k, X], parts[k, Y])
    low, high = log(LEAST), log(most)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if share_above(parts, count, points, known, exp(middle)) > level:
            low = middle
        else:
            high = middle
    return exp(0.5 * (low + high))
