"""Where one sub-movement ends and the next begins: at the valleys of the hand's speed."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.predictors.kinematic.history import Point
from pointpred.records import FloatArray

FALLEN, RISEN = 0.7, 1.4
"""A sub-movement ends where the speed has fallen below this share of its peak and rises by this factor."""
RISE_SHARE, RISE_M_S = 0.02, 0.005
"""That rise is more than this share of the movement's peak and this speed: noise is no sub-movement."""
REST_M_S = 1e-6
"""Speeds that differ by less are equal: a hand at rest has one valley, wherever rounding puts its zero."""

# State, relative to `at`: how many sub-movements ended; where this one began, and its peak; whether its speed
# falls, and its lowest speed since then: how much, when, where.
COUNT, T, X, Y, PATH, PEAK, PEAK_T, FALLING, LOW, LOW_T, LOW_X, LOW_Y, LOW_PATH, STATES = range(14)


@law
def divide(memory: FloatArray, at: int, point: Point, speed: float, movement_peak: float) -> None:
    """Divide the movement at the valleys of its speed."""
    if memory[at + FALLING] == 0.0:
        if speed > memory[at + PEAK]:
            memory[at + PEAK], memory[at + PEAK_T] = speed, point.t
        elif speed < FALLEN * memory[at + PEAK]:
            memory[at + FALLING] = 1.0
            memory[at + LOW] = 2.0 * speed
    if memory[at + FALLING] == 0.0:
        return
    if speed < memory[at + LOW] - REST_M_S:
        memory[at + LOW], memory[at + LOW_T] = speed, point.t
        memory[at + LOW_X], memory[at + LOW_Y], memory[at + LOW_PATH] = point.x, point.y, point.path
    elif speed > RISEN * memory[at + LOW] + RISE_SHARE * movement_peak + RISE_M_S:
        memory[at + FALLING] = 0.0
        memory[at + COUNT] += 1.0
        memory[at + T], memory[at + PATH] = memory[at + LOW_T], memory[at + LOW_PATH]
        memory[at + X], memory[at + Y] = memory[at + LOW_X], memory[at + LOW_Y]
        memory[at + PEAK], memory[at + PEAK_T] = speed, point.t
