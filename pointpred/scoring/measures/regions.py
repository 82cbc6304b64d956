"""Calibration of predicted regions: shares of endpoints inside, and a score of the whole region."""

from __future__ import annotations

from math import erf, exp, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.regions import reach as plain_reach
from pointpred.scoring.measures import student
from pointpred.scoring.measures.endpoint import WEIGHT_S, moments

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
    return ranked_score(error, scale) if tail != tail else student.ranked_score(error, scale, tail)


@law
def calibrate(
    rows: FloatArray,
    answers: FloatArray,
    offsets: NDArray[np.int64],
    arrivals: NDArray[np.int64],
    out: FloatArray,
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
    rows: FloatArray,
    answers: FloatArray,
    offsets: NDArray[np.int64],
    arrivals: NDArray[np.int64],
    shares: FloatArray,
    out: FloatArray,
) -> None:
    """For each trial, share of the time and level: 1 where the region holds the endpoint, else 0.

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
                out[k, m, j] = 1.0 if 0.0 <= far <= reach(LEVELS[j], answers[i, 8]) else 0.0
