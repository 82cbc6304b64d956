"""Probabilities over rectangles: the evidence for each target as features, scores and shares.

Every feature is free of scale and of the screen's orientation, so the same coefficients serve all screens.
"""

from __future__ import annotations

from math import exp, hypot, inf, log, nan, pi, sqrt
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import LARGEST, FloatArray, FloatTable, SixFloats, TenFloats
from pointpred.targets import coefficients as fitted
from pointpred.targets import cursor
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, WIDTH

EFFECTIVE = 4.133
"""Endpoints scatter about a target's centre with a standard deviation of its width over this number."""
ANGLE = 0.15
"""Chords of angles, on a circle of radius 1, below this are as good as straight."""
ALONG, ACROSS, LEAST = 0.5, 0.2, 0.1
"""Deviations of a default law, as shares of the way left, and the least way."""

MASS, TRAIL, HEADING, PER_WAY, PER_SPEED, NEAR, FEATURES = range(7)


class Law(NamedTuple):
    """A predicted law of the endpoint: centre in px, scale matrix in px^2, degrees of freedom or NaN."""

    x: float
    y: float
    sxx: float
    sxy: float
    syy: float
    tail: float


class Situation(NamedTuple):
    """What the features of all targets share: the cursor, two directions, how far it went.

    The directions of its way of late and of its velocity are (0, 0) where it has none.
    """

    x: float
    y: float
    trail_x: float
    trail_y: float
    ux: float
    uy: float
    log_way: float
    log_sweep: float


@law
def unclaimed(s: cursor.State, x: float, y: float) -> tuple[float, float, float]:
    """The scale matrix of a law for which the predictor claims none: long along the way left, px^2.

    The way left is that to the predicted endpoint, and at least a tenth of the way done.
    """
    gx, gy = x - s.x, y - s.y
    done_x, done_y = s.x - s.x0, s.y - s.y0
    left, done = hypot(gx, gy), hypot(done_x, done_y)
    if left == 0.0:
        gx, gy = done_x, done_y
    size = hypot(gx, gy)
    reach = max(left + LEAST * done, 1.0)
    across = (ACROSS * reach) ** 2
    if size == 0.0:
        return across, 0.0, across
    more = (ALONG * reach) ** 2 - across
    ux, uy = gx / size, gy / size
    return across + more * ux * ux, more * ux * uy, across + more * uy * uy


@law
def direction(x: float, y: float) -> tuple[float, float]:
    """A vector of length 1; (0, 0) where it has none."""
    size = hypot(x, y)
    return (x / size, y / size) if size > 0.0 else (0.0, 0.0)


@law
def situation(s: cursor.State) -> Situation:
    """What the features of all targets share."""
    x, y = s.x, s.y
    way = hypot(x - s.x0, y - s.y0)
    sweep = s.speed * (s.t - s.t0)
    trail_x, trail_y = direction(x - s.trail_x, y - s.trail_y)
    ux, uy = direction(s.vx, s.vy)
    return Situation(x, y, trail_x, trail_y, ux, uy, log(max(way, 1.0)), log(max(sweep, 1.0)))


@law
def log_mass(predicted: Law, dx: float, dy: float, width: float, height: float) -> float:
    """Logarithm of how much of a law falls to a rectangle with its centre at (dx, dy) from the law's, px.

    People aim at centres and scatter in proportion to the width (MacKenzie 1992, section 2.3): an endpoint
    predicted exactly is still known only to (width / 4.133, height / 4.133). These variances are added to the
    scale matrix; the density at the centre of the rectangle, times its area, is the answer.
    """
    sxx, sxy = predicted.sxx + (width / EFFECTIVE) ** 2, predicted.sxy
    syy = predicted.syy + (height / EFFECTIVE) ** 2
    det, area = sxx * syy - sxy * sxy, width * height / (2.0 * pi)
    far = max((syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / det, 0.0)
    flat = 0.5 * log(area * area / det)
    if predicted.tail != predicted.tail:
        return flat - 0.5 * far
    return flat - (0.5 * predicted.tail + 1.0) * log(1.0 + far / predicted.tail)


@law
def feature(row: FloatArray, now: Situation, predicted: Law) -> SixFloats:
    """The features of one target, a row of a table.

    MASS: ``log_mass``. TRAIL, HEADING: how far the target lies off the way of late and off the velocity, the
    logarithm of 1 + (chord of the angle / what is straight)^2. Straight is 0.15, and more where the target is
    so near that its own size fills an angle. PER_WAY, PER_SPEED: logarithm of the way left over the way done,
    and over the speed times the time since the start. NEAR: logarithm of 1 + the way left over half the
    target's size.
    """
    x, y, width, height = row[CENTRE_X], row[CENTRE_Y], row[WIDTH], row[HEIGHT]
    gx, gy, size = x - now.x, y - now.y, 0.5 * (width + height)
    far2 = gx * gx + gy * gy
    far = sqrt(far2)
    straight, trail, heading = ANGLE * ANGLE * far2 + 0.0625 * size * size, 0.0, 0.0
    if now.trail_x != 0.0 or now.trail_y != 0.0:
        off = max(far - now.trail_x * gx - now.trail_y * gy, 0.0)
        trail = log(1.0 + 2.0 * far * off / straight)
    if now.ux != 0.0 or now.uy != 0.0:
        off = max(far - now.ux * gx - now.uy * gy, 0.0)
        heading = log(1.0 + 2.0 * far * off / straight)
    left = max(far, 1.0)
    log_left = log(left)
    return (
        log_mass(predicted, x - predicted.x, y - predicted.y, width, height),
        trail,
        heading,
        log_left - now.log_way,
        log_left - now.log_sweep,
        log(1.0 + 2.0 * left / size),
    )


@law
def features(s: cursor.State, table: FloatTable, predicted: Law, out: FloatTable) -> None:
    """A row of features for each target and a predicted law."""
    now = situation(s)
    for i in range(len(table)):
        f = out[i]
        f[MASS], f[TRAIL], f[HEADING], f[PER_WAY], f[PER_SPEED], f[NEAR] = feature(table[i], now, predicted)


class Weights(Layout):
    """Of each feature standing, of each at the peak of the speed, and of two more at both.

    None of them, and the logarithm of how much of the law falls to all targets.
    """

    slow: Annotated[FloatArray, FEATURES]
    fast: Annotated[FloatArray, FEATURES]
    none: Annotated[FloatArray, 2]
    around: Annotated[FloatArray, 2]


class Coefficients(Layout):
    """Weights for a law that the predictor claims, and for a law that stands in for it."""

    claimed: Weights
    unclaimed: Weights


FITTED: FloatArray = np.array(
    [
        *(*fitted.SLOW, *fitted.FAST, *fitted.NONE, *fitted.AROUND),
        *(*fitted.UNCLAIMED_SLOW, *fitted.UNCLAIMED_FAST),
        *(*fitted.UNCLAIMED_NONE, *fitted.UNCLAIMED_AROUND),
    ]
)
"""The coefficients that come with pointpred."""
FITTED_PAGES: FloatArray = np.array(
    [
        *(*fitted.PAGES_SLOW, *fitted.PAGES_FAST, *fitted.PAGES_NONE, *fitted.PAGES_AROUND),
        *(*fitted.PAGES_UNCLAIMED_SLOW, *fitted.PAGES_UNCLAIMED_FAST),
        *(*fitted.PAGES_UNCLAIMED_NONE, *fitted.PAGES_UNCLAIMED_AROUND),
    ]
)
"""Those for a prefetch: sharpest early in a movement over cards, links and menus."""
FITTED_NEAREST: FloatArray = np.zeros(Coefficients.length)
"""Coefficients of the distance from the cursor alone: the nearest target, as something to compare with."""
for _weights in (Coefficients(FITTED_NEAREST).claimed, Coefficients(FITTED_NEAREST).unclaimed):
    _weights.slow[NEAR], _weights.fast[NEAR] = fitted.NEAREST
    _weights.none[:] = fitted.NEAREST_NONE


FITTED_NONE, FITTED_TARGETS = 0.25, 16.0
"""Values in the fit: the share of movements to none of the targets, and the number of targets."""
LEAST_MASS = 1e-3
"""Less of a law than this in all targets is as good as none."""

FLATTEST = 1e-12
"""The least determinant of a region over that of one with axes along x and y: below it, it is a line."""
TAILS = (1e-3, LARGEST)
"""Bounds on the degrees of freedom of a law."""


@law
def lawful(predicted: Law) -> bool:
    """Whether a predicted law can be used: a region of finite size, and a tail that is one, or none."""
    _, _, sxx, sxy, syy, tail = predicted
    if not (
        0.0 < sxx <= LARGEST * LARGEST and 0.0 < syy <= LARGEST * LARGEST and abs(sxy) <= LARGEST * LARGEST
    ):
        return False
    return sxx * syy - sxy * sxy > FLATTEST * sxx * syy and (tail != tail or TAILS[0] <= tail <= TAILS[1])


@law
def log_total(mean: float) -> float:
    """Logarithm of how much of a law falls to FITTED_TARGETS targets, from the mean by weight."""
    return log(max(FITTED_TARGETS * mean, LEAST_MASS))


@law
def scores(
    s: cursor.State,
    table: FloatTable,
    answer: TenFloats,
    coefficients: Coefficients,
    elsewhere: float,
    out: FloatArray,
) -> None:
    """The logarithm of each target's share, up to a constant; behind them that of none of them.

    ``answer`` is a ``PredictionRow``; a point beyond the bounds of positions, and a law that is
    not ``lawful``, are as if not claimed. A target of weight 0 is not looked at. None of them is weighed
    against how much of the law falls to all targets, as if these were FITTED_TARGETS: early in a movement
    that says how close they lie, not that it is for one of them.
    """
    _, x, y, sxx, sxy, syy, _, _, tail, _ = answer
    claimed = abs(x) <= LARGEST and abs(y) <= LARGEST
    if not claimed:  # no prediction: the cursor itself
        x, y = s.x, s.y
    fit, predicted = coefficients.claimed, Law(x, y, sxx, sxy, syy, tail)
    if not claimed or not lawful(predicted):
        sxx, sxy, syy = unclaimed(s, x, y)
        fit, predicted = coefficients.unclaimed, Law(x, y, sxx, sxy, syy, nan)
    now, weight = situation(s), np.empty(FEATURES)
    fast = min(s.speed / s.peak, 1.0) if s.peak > 0.0 else 0.0
    for j in range(FEATURES):
        weight[j] = (1.0 - fast) * fit.slow[j] + fast * fit.fast[j]
    count, total = len(table), 0.0
    usual = log(FITTED_TARGETS * (1.0 - elsewhere) / (1.0 - FITTED_NONE))
    for i in range(count):
        if table[i, LOG_WEIGHT] == -inf:
            out[i] = -inf
            continue
        f0, f1, f2, f3, f4, f5 = feature(table[i], now, predicted)
        score = weight[0] * f0 + weight[1] * f1 + weight[2] * f2
        out[i] = table[i, LOG_WEIGHT] + usual + score + weight[3] * f3 + weight[4] * f4 + weight[5] * f5
        total += exp(table[i, LOG_WEIGHT] + f0)
    none = (1.0 - fast) * fit.none[0] + fast * fit.none[1]
    around = (1.0 - fast) * fit.around[0] + fast * fit.around[1]
    out[count] = none + around * log_total(total) + log(elsewhere / FITTED_NONE)


@law
def normalise(out: FloatArray) -> None:
    """Scores become shares of one; the last score is finite."""
    most = -inf
    for i in range(len(out)):
        most = max(most, out[i])
    total = 0.0
    for i in range(len(out)):
        out[i] = exp(out[i] - most)
        total += out[i]
    for i in range(len(out)):
        out[i] /= total
