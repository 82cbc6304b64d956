"""Where one sub-movement ends and the next begins: at the valleys of the hand's speed."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.predictors.kinematic.history import Point

FALLEN, RISEN = 0.7, 1.4
"""A sub-movement ends where the speed has fallen below this share of its peak and rises by this factor."""
RISE_SHARE, RISE_M_S = 0.02, 0.005
"""That rise is more than this share of the movement's peak and this speed: noise is no sub-movement."""
REST_M_S = 1e-6
"""Speeds that differ by less are equal: a hand at rest has one valley, wherever rounding puts its zero."""


class State(Layout):
    """How many sub-movements ended; where this one began, and its peak; its lowest speed since it falls."""

    count: float
    t: float
    x: float
    y: float
    path: float
    peak: float
    peak_t: float
    falling: float
    low: float
    low_t: float
    low_x: float
    low_y: float
    low_path: float


@law
def divide(s: State, point: Point, speed: float, movement_peak: float) -> None:
    """Divide the movement at the valleys of its speed."""
    if s.falling == 0.0:
        if speed > s.peak:
            s.peak, s.peak_t = speed, point.t
        elif speed < FALLEN * s.peak:
            s.falling = 1.0
            s.low = 2.0 * speed
    if s.falling == 0.0:
        return
    if speed < s.low - REST_M_S:
        s.low, s.low_t = speed, point.t
        s.low_x, s.low_y, s.low_path = point.x, point.y, point.path
    elif speed > RISEN * s.low + RISE_SHARE * movement_peak + RISE_M_S:
        s.falling = 0.0
        s.count += 1.0
        s.t, s.path = s.low_t, s.low_path
        s.x, s.y = s.low_x, s.low_y
        s.peak, s.peak_t = speed, point.t
