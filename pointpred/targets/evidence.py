"""What speaks for each target: a predicted law and the cursor's own way, as features in columns.

Every feature is free of scale and of the screen's orientation, so the same coefficients serve all screens.
"""

from __future__ import annotations

from math import atan2, hypot, log, sqrt

import numpy as np

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.targets import cursor
from pointpred.targets.law import log_mass

ANGLE = 0.15
"""Angles (rad) below this are as good as straight."""
ALONG, ACROSS, LEAST = 0.5, 0.2, 0.1
"""Deviations of a law that nobody claimed, as shares of the way left, and the least of it."""

MASS, TRAIL, HEADING, PER_WAY, PER_SPEED, NEAR = range(6)
FEATURES = 6

SITUATION = 14
"""Numbers that the features of all targets share."""


@law
def bend(ux: float, uy: float, gx: float, gy: float, far2: float, size: float) -> float:
    """How little a direction u speaks for a goal at g: logarithm of 1 + (angle / what is straight)^2.

    What is straight: 0.15 rad, and more where the goal is so near that its own size fills an angle. ``far2``
    is the square of the distance to the goal.
    """
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
def situation(
    memory: FloatArray, x: float, y: float, sxx: float, sxy: float, syy: float, tail: float, out: FloatArray
) -> None:
    """What the features of all targets share: the cursor, and a law centred at (x, y) px."""
    cx, cy = memory[cursor.X], memory[cursor.Y]
    done = hypot(cx - memory[cursor.X0], cy - memory[cursor.Y0])
    swept = memory[cursor.SPEED] * (memory[cursor.T] - memory[cursor.T0])
    out[0], out[1], out[2], out[3] = cx, cy, cx - memory[cursor.TRAIL_X], cy - memory[cursor.TRAIL_Y]
    out[4], out[5] = memory[cursor.VX], memory[cursor.VY]
    out[6], out[7] = log(max(done, 1.0)), log(max(swept, 1.0))
    out[8], out[9], out[10], out[11], out[12], out[13] = x, y, sxx, sxy, syy, tail


@law
def feature(row: FloatArray, now: FloatArray, mass: bool) -> tuple[float, float, float, float, float, float]:
    """The features of one target, a row of a table, in a ``situation``; MASS only where it is asked for.

    MASS: logarithm of the law's mass in the rectangle. TRAIL, HEADING: how far the target lies off the way of
    late and off the velocity. PER_WAY, PER_SPEED: logarithm of the way left over the way done, and over the
    speed times the time since the start. NEAR: logarithm of 1 + the way left over half the target's size.
    """
    gx, gy, size = row[0] - now[0], row[1] - now[1], 0.5 * (row[2] + row[3])
    far2 = gx * gx + gy * gy
    left = max(sqrt(far2), 1.0)
    log_left, held = log(left), 0.0
    if mass:
        held = log_mass(row[0] - now[8], row[1] - now[9], row[2], row[3], now[10], now[11], now[12], now[13])
    return (
        held,
        bend(now[2], now[3], gx, gy, far2, size),
        bend(now[4], now[5], gx, gy, far2, size),
        log_left - now[6],
        log_left - now[7],
        log(1.0 + 2.0 * left / size),
    )


@law
def features(
    memory: FloatArray,
    table: FloatArray,
    x: float,
    y: float,
    sxx: float,
    sxy: float,
    syy: float,
    tail: float,
    out: FloatArray,
) -> None:
    """A row of features for each target, for a law centred at (x, y) px with a scale matrix in px^2."""
    now = np.empty(SITUATION)
    situation(memory, x, y, sxx, sxy, syy, tail, now)
    for i in range(len(table)):
        f = out[i]
        f[MASS], f[TRAIL], f[HEADING], f[PER_WAY], f[PER_SPEED], f[NEAR] = feature(table[i], now, True)
