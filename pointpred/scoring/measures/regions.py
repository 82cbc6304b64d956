"""Calibration of predicted regions: shares of endpoints inside, and a score of the whole region."""

from __future__ import annotations

from math import erf, exp, inf, lgamma, log, pi, sqrt

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray, FloatTable, IntArray
from pointpred.regions import reach as plain_reach
from pointpred.scoring.measures.endpoint import WEIGHT_S, moments

# Student's law of one dimension, by which regions with a tail are judged.

TERMS = 200
"""Of the continued fraction at most; it settles after some ten."""
SETTLED = 1e-14
SMALLEST = 1e-300


@law
def beta_fraction(a: float, b: float, x: float) -> float:
    """The continued fraction of the incomplete beta function, by Lentz's method."""
    c, d = 1.0, 1.0 - (a + b) * x / (a + 1.0)
    d = 1.0 / (d if abs(d) > SMALLEST else SMALLEST)
    total = d
    for m in range(1, TERMS):
        even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
        odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))
        for k in range(2):
            term = even if k == 0 else odd
            d = 1.0 + term * d
            d = 1.0 / (d if abs(d) > SMALLEST else SMALLEST)
            c = 1.0 + term / c
            c = c if abs(c) > SMALLEST else SMALLEST
            total *= c * d
        if abs(c * d - 1.0) < SETTLED:
            break
    return total


@law
def log_beta(a: float, b: float) -> float:
    """Logarithm of the beta function."""
    return lgamma(a) + lgamma(b) - lgamma(a + b)


@law
def incomplete_beta(a: float, b: float, x: float) -> float:
    """The regularised incomplete beta function I_x(a, b).

    Reference: Olver and others, NIST Digital Library of Mathematical Functions, 8.17.22.
    """
    if x <= 0.0:
        return 0.0
    if x >= 1.0:
        return 1.0
    scale = exp(a * log(x) + b * log(1.0 - x) - log_beta(a, b))
    if x < (a + 1.0) / (a + b + 2.0):
        return scale * beta_fraction(a, b, x) / a
    return 1.0 - scale * beta_fraction(b, a, 1.0 - x) / b


@law
def distribution(z: float, tail: float) -> float:
    """Probability below ``z`` of a law with ``tail`` degrees of freedom, scale 1."""
    beyond = 0.5 * incomplete_beta(0.5 * tail, 0.5, tail / (tail + z * z))
    return 1.0 - beyond if z > 0.0 else beyond


@law
def student_score(error: float, scale: float, tail: float) -> float:
    """Continuous ranked probability score of a Student law whose centre is off by ``error``.

    With z = error / scale: scale (z (2 F(z) - 1) + 2 f(z) (tail + z^2) / (tail - 1)
    - 2 sqrt(tail) / (tail - 1) B(1/2, tail - 1/2) / B(1/2, tail/2)^2); without bound where tail <= 1, for the
    law then has no mean.

    Reference: Jordan, Krueger, Lerch 2019, "Evaluating probabilistic forecasts with scoringRules", app. A.

    >>> round(student_score(0.0, 1.0, 1e6), 4)  # the normal law: (sqrt(2) - 1) / sqrt(pi)
    0.2337
    """
    if tail <= 1.0:
        return inf
    if scale == 0.0:
        return abs(error)
    z = error / scale
    both = log_beta(0.5, 0.5 * tail)
    density = exp(-0.5 * (tail + 1.0) * log(1.0 + z * z / tail) - both) / sqrt(tail)
    spread = 2.0 * sqrt(tail) * exp(log_beta(0.5, tail - 0.5) - 2.0 * both)
    near = z * (2.0 * distribution(z, tail) - 1.0)
    return scale * (near + (2.0 * density * (tail + z * z) - spread) / (tail - 1.0))


# Regions of any law.

LEVELS = (0.5, 0.8, 0.95)
"""Regions that should hold the endpoint with these probabilities."""

# A row of `calibrate`: share of the time with a region; share of that time with the endpoint inside the
# region of each of LEVELS; continuous ranked probability score in px.
CLAIMED, INSIDE, RANKED = 0, 1, 4
WIDTH = 5

reach = law(plain_reach)
"""How far the region of a level goes, compiled."""


@law
def ranked_score(error: float, deviation: float) -> float:
    """Continuous ranked probability score of a normal law whose mean is off by ``error``."""
    if deviation == 0.0:
        return abs(error)
    z = error / deviation
    density = exp(-0.5 * z * z) / sqrt(2.0 * pi)
    return deviation * (z * erf(z / sqrt(2.0)) + 2.0 * density - 1.0 / sqrt(pi))


@law
def surprise(dx: float, dy: float, sxx: float, sxy: float, syy: float) -> float:
    """Squared Mahalanobis distance; -1 where the numbers are no covariance with an inside."""
    determinant = sxx * syy - sxy * sxy
    if not (sxx > 0.0 and syy > 0.0 and determinant > 0.0):
        return -1.0
    return (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant


@law
def axis_score(error: float, variance: float, tail: float) -> float:
    """The ranked score along one axis."""
    scale = sqrt(max(variance, 0.0))
    return ranked_score(error, scale) if tail != tail else student_score(error, scale, tail)


@law
def calibrate(
    rows: FloatTable,
    answers: FloatTable,
    offsets: IntArray,
    arrivals: IntArray,
    out: FloatTable,
) -> None:
    """A row of ``out`` for each trial, NaN where no region was given; ``offsets`` need not begin at 0.

    Time from onset to arrival counts as in the time-averaged error. The region of level p is the ellipse
    with squared Mahalanobis distance up to -2 ln(1 - p), or nu ((1 - p)^(-2/nu) - 1) where the prediction
    claims a Student law with nu = ``tail``; one without an inside holds no endpoint. The score is the mean
    of both axes.
    """
    out[:] = np.nan
    for k in range(len(offsets) - 1):
        first, last = offsets[k] - offsets[0], offsets[k + 1] - offsets[0] - 1
        all_s, claimed_s, ranked = 0.0, 0.0, 0.0
        inside = np.zeros(len(LEVELS))
        for i in range(first, arrivals[k] - offsets[0]):
            weight = min(rows[i + 1, 0] - rows[i, 0], WEIGHT_S)
            all_s += weight
            sxx, sxy, syy, tail = answers[i, 3], answers[i, 4], answers[i, 5], answers[i, 8]
            if sxx != sxx:
                continue
            claimed_s += weight
            dx, dy = rows[last, 1] - answers[i, 1], rows[last, 2] - answers[i, 2]
            far = surprise(dx, dy, sxx, sxy, syy)
            for j in range(len(LEVELS)):
                if 0.0 <= far <= reach(LEVELS[j], tail):
                    inside[j] += weight
            ranked += weight * 0.5 * (axis_score(dx, sxx, tail) + axis_score(dy, syy, tail))
        out[k, CLAIMED] = claimed_s / all_s
        if claimed_s > 0.0:
            for j in range(len(LEVELS)):
                out[k, INSIDE + j] = inside[j] / claimed_s
            out[k, RANKED] = ranked / claimed_s


@law
def inside_by_time(
    rows: FloatTable,
    answers: FloatTable,
    offsets: IntArray,
    arrivals: IntArray,
    shares: FloatArray,
    out: FloatTable,
) -> None:
    """A row a trial: for each share of the time and level 1 where the region holds the endpoint, else 0.

    NaN where no region is claimed at that moment.
    """
    out[:] = np.nan
    at = np.empty(len(shares), dtype=np.int64)
    for k in range(len(offsets) - 1):
        first, last = offsets[k] - offsets[0], offsets[k + 1] - offsets[0] - 1
        moments(rows, first, arrivals[k] - offsets[0], last, shares, at)
        for m in range(len(shares)):
            i = at[m]
            sxx, sxy, syy = answers[i, 3], answers[i, 4], answers[i, 5]
            if sxx != sxx:
                continue
            dx, dy = rows[last, 1] - answers[i, 1], rows[last, 2] - answers[i, 2]
            far = surprise(dx, dy, sxx, sxy, syy)
            for j in range(len(LEVELS)):
                out[k, m * len(LEVELS) + j] = 1.0 if 0.0 <= far <= reach(LEVELS[j], answers[i, 8]) else 0.0
