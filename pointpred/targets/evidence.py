"""What speaks for each target: a predicted law and the cursor's own way, as features in columns.

Every feature is free of scale and of the screen's orientation, so the same coefficients serve all screens.
"""

from __future__ import annotations

from math import atan2, hypot, log

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


@law
def bend(ux: float, uy: float, gx: float, gy: float, size: float) -> float:
    """How little a direction u speaks for a goal at g: logarithm of 1 + (angle / what is straight)^2.

    What is straight: 0.15 rad, and more where the goal is so near that its own size fills an angle.
    """
    if (ux == 0.0 and uy == 0.0) or (gx == 0.0 and gy == 0.0):
        return 0.0
    angle = atan2(ux * gy - uy * gx, ux * gx + uy * gy)
    return log(1.0 + angle * angle / (ANGLE * ANGLE + 0.0625 * size * size / (gx * gx + gy * gy)))


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
    """A row of features for each target, for a law centred at (x, y) px with a scale matrix in px^2.

    MASS: logarithm of the law's mass in the rectangle. TRAIL, HEADING: how far the target lies off the way of
    late and off the velocity. PER_WAY, PER_SPEED: logarithm of the way left over the way done, and over the
    speed times the time since the start. NEAR: logarithm of 1 + the way left over half the target's size.
    """
    cx, cy = memory[cursor.X], memory[cursor.Y]
    done_x, done_y = cx - memory[cursor.X0], cy - memory[cursor.Y0]
    done = max(hypot(done_x, done_y), 1.0)
    swept = max(memory[cursor.SPEED] * (memory[cursor.T] - memory[cursor.T0]), 1.0)
    for i in range(len(table)):
        row, f = table[i], out[i]
        gx, gy = row[0] - cx, row[1] - cy
        left, size = max(hypot(gx, gy), 1.0), 0.5 * (row[2] + row[3])
        f[MASS] = log_mass(row[0] - x, row[1] - y, row[2], row[3], sxx, sxy, syy, tail)
        f[TRAIL] = bend(cx - memory[cursor.TRAIL_X], cy - memory[cursor.TRAIL_Y], gx, gy, size)
        f[HEADING] = bend(memory[cursor.VX], memory[cursor.VY], gx, gy, size)
        f[PER_WAY] = log(left / done)
        f[PER_SPEED] = log(left / swept)
        f[NEAR] = log(1.0 + 2.0 * left / size)
