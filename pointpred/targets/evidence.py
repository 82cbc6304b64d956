"""The evidence for each target, as features: a predicted law and the cursor's own way.

Every feature is free of scale and of the screen's orientation, so the same coefficients serve all screens.
"""

from __future__ import annotations

from math import atan2, hypot, log, sqrt
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.records import FloatArray, SixFloats
from pointpred.targets import cursor
from pointpred.targets.rectangle_mass import log_mass
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, WIDTH

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
def unclaimed(memory: FloatArray, x: float, y: float) -> tuple[float, float, float]:
    """The scale matrix of a law for which the predictor claims none: long along the way left, px^2.

    The way left is that to the predicted endpoint, and at least a tenth of the way done.
    """
    gx, gy = x - memory[cursor.X], y - memory[cursor.Y]
    done_x, done_y = memory[cursor.X] - memory[cursor.X0], memory[cursor.Y] - memory[cursor.Y0]
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
def situation(memory: FloatArray) -> Situation:
    """What the features of all targets share."""
    x, y = memory[cursor.X], memory[cursor.Y]
    way = hypot(x - memory[cursor.X0], y - memory[cursor.Y0])
    sweep = memory[cursor.SPEED] * (memory[cursor.T] - memory[cursor.T0])
    trail_x, trail_y = x - memory[cursor.TRAIL_X], y - memory[cursor.TRAIL_Y]
    vx, vy = memory[cursor.VX], memory[cursor.VY]
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
def features(memory: FloatArray, table: FloatArray, predicted: Law, out: FloatArray) -> None:
    """A row of features for each target and a predicted law."""
    now = situation(memory)
    for i in range(len(table)):
        f = out[i]
        f[MASS], f[TRAIL], f[HEADING], f[PER_WAY], f[PER_SPEED], f[NEAR] = feature(
            table[i], now, predicted, True
        )
