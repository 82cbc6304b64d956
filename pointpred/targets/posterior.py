"""Probabilities over rectangles: the evidence for each target as features, scores and shares.

Every feature is free of scale and of the screen's orientation, so the same coefficients serve all screens.
"""

from __future__ import annotations

from math import atan2, exp, hypot, inf, log, nan, sqrt
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import LARGEST, FloatArray, FloatTable, SixFloats, TenFloats
from pointpred.targets import coefficients as fitted
from pointpred.targets import cursor
from pointpred.targets.rectangle_mass import log_mass
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, WIDTH

ANGLE = 0.15
"""Angles (rad) below this are as good as straight."""
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
    """What the features of all targets share: the cursor, its way of late, its velocity, how far it went."""

    x: float
    y: float
    trail_x: float
    trail_y: float
    vx: float
    vy: float
    log_way: float
    log_sweep: float


@law
def bend(u: tuple[float, float], g: tuple[float, float], far2: float, size: float) -> float:
    """How little a direction u speaks for a goal at g: logarithm of 1 + (angle / what is straight)^2.

    What is straight: 0.15 rad, and more where the goal is so near that its own size fills an angle. ``far2``
    is the square of the distance to the goal.
    """
    ux, uy = u
    gx, gy = g
    if (ux == 0.0 and uy == 0.0) or far2 == 0.0:
        return 0.0
    angle = atan2(ux * gy - uy * gx, ux * gx + uy * gy)
    return log(1.0 + angle * angle / (ANGLE * ANGLE + 0.0625 * size * size / far2))


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
def situation(s: cursor.State) -> Situation:
    """What the features of all targets share."""
    x, y = s.x, s.y
    way = hypot(x - s.x0, y - s.y0)
    sweep = s.speed * (s.t - s.t0)
    trail_x, trail_y = x - s.trail_x, y - s.trail_y
    vx, vy = s.vx, s.vy
    return Situation(x, y, trail_x, trail_y, vx, vy, log(max(way, 1.0)), log(max(sweep, 1.0)))


@law
def feature(row: FloatArray, now: Situation, predicted: Law, mass: bool) -> SixFloats:
    """The features of one target, a row of a table; MASS only where it is asked for.

    MASS: logarithm of the law's mass in the rectangle. TRAIL, HEADING: how far the target lies off the way of
    late and off the velocity. PER_WAY, PER_SPEED: logarithm of the way left over the way done, and over the
    speed times the time since the start. NEAR: logarithm of 1 + the way left over half the target's size.
    """
    x, y, width, height = row[CENTRE_X], row[CENTRE_Y], row[WIDTH], row[HEIGHT]
    gx, gy, size = x - now.x, y - now.y, 0.5 * (width + height)
    far2 = gx * gx + gy * gy
    left = max(sqrt(far2), 1.0)
    log_left, inside = log(left), 0.0
    if mass:
        spread = predicted.sxx, predicted.sxy, predicted.syy, predicted.tail
        inside = log_mass((x - predicted.x, y - predicted.y, width, height), spread)
    return (
        inside,
        bend((now.trail_x, now.trail_y), (gx, gy), far2, size),
        bend((now.vx, now.vy), (gx, gy), far2, size),
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
        f[MASS], f[TRAIL], f[HEADING], f[PER_WAY], f[PER_SPEED], f[NEAR] = feature(
            table[i], now, predicted, True
        )


class Weights(Layout):
    """Of each feature standing, of each at the peak of the speed, and of none of them at both."""

    slow: Annotated[FloatArray, FEATURES]
    fast: Annotated[FloatArray, FEATURES]
    none: Annotated[FloatArray, 2]


class Coefficients(Layout):
    """Weights for a law that the predictor claims, and for a law that stands in for it."""

    claimed: Weights
    unclaimed: Weights


FITTED: FloatArray = np.array(
    [
        *(*fitted.SLOW, *fitted.FAST, *fitted.NONE),
        *(*fitted.UNCLAIMED_SLOW, *fitted.UNCLAIMED_FAST, *fitted.UNCLAIMED_NONE),
    ]
)
"""The coefficients that come with pointpred."""
FITTED_PAGES: FloatArray = np.array(
    [
        *(*fitted.PAGES_SLOW, *fitted.PAGES_FAST, *fitted.PAGES_NONE),
        *(*fitted.PAGES_UNCLAIMED_SLOW, *fitted.PAGES_UNCLAIMED_FAST, *fitted.PAGES_UNCLAIMED_NONE),
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
    not ``lawful``, are as if not claimed. A target of weight 0 is not looked at.
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
    count, mass = len(table), weight[0] != 0.0
    usual = log(FITTED_TARGETS * (1.0 - elsewhere) / (1.0 - FITTED_NONE))
    for i in range(count):
        if table[i, LOG_WEIGHT] == -inf:
            out[i] = -inf
            continue
        f0, f1, f2, f3, f4, f5 = feature(table[i], now, predicted, mass)
        score = weight[0] * f0 + weight[1] * f1 + weight[2] * f2
        out[i] = table[i, LOG_WEIGHT] + usual + score + weight[3] * f3 + weight[4] * f4 + weight[5] * f5
    none = (1.0 - fast) * fit.none[0] + fast * fit.none[1]
    out[count] = none + log(elsewhere / FITTED_NONE)


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
