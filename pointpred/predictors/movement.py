"""The state of the movement so far, common to most predictors."""

from __future__ import annotations

from math import hypot

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import (
    FINE,
    MOTION_FIELD,
    MOTION_MOST,
    ORDER,
    MotionRow,
    TenFloats,
    refused,
)

STILL_M_S = 0.002
"""Below this speed of the hand nothing moves: some thirty counts a second of a mouse with 400 CPI."""
CORRECTIVE_FRACTION = 0.2
"""A movement slower than this share of its peak is corrective (thesis 2.5.6: a fifth)."""

NUMBERS = 7
"""So many fields of a motion are numbers; the others are marks."""

STILL, BALLISTIC, CORRECTIVE = 0.0, 1.0, 2.0


class State(Layout):
    """The last sample, the first one of the movement, the peak speed (m/s) and the way (px) since."""

    known: float
    t: float
    x: float
    y: float
    t0: float
    x0: float
    y0: float
    peak: float
    path: float


@law
def fault_of(s: State, m: MotionRow) -> int:
    """FINE; ORDER before the last time; MOTION_FIELD plus the place of the first value out of its bounds."""
    for i in range(NUMBERS):
        if not abs(m[i]) <= MOTION_MOST:
            return MOTION_FIELD + i
    return ORDER if s.known == 1.0 and m.t < s.t else FINE


@law
def refuse(s: State, m: MotionRow, fault: int) -> TenFloats:
    """The answer to a motion with a fault."""
    return refused(fault, s.t if fault == ORDER else m[fault - MOTION_FIELD])


@law
def follow(s: State, m: MotionRow) -> tuple[int, bool, float]:
    """Take one motion in: (its fault, a movement starts here, dt in s since the motion before).

    With a fault other than FINE the memory is unchanged.
    """
    t, x, y = m.t, m.x, m.y
    fault = fault_of(s, m)
    if fault != FINE:
        return fault, False, 0.0
    new = m.start == 1.0 or s.known == 0.0
    dt = 0.0 if new else t - s.t
    if new or t == s.t0:  # of events at one time, the later position replaces
        s.t0, s.x0, s.y0 = t, x, y
        s.path = 0.0
    else:
        s.path += hypot(x - s.x, y - s.y)
    if new:
        s.peak = 0.0
    s.known = 1.0
    s.t, s.x, s.y = t, x, y
    s.peak = max(s.peak, hypot(m.vx, m.vy))
    return FINE, new, dt


@law
def phase(s: State, m: MotionRow) -> float:
    """The phase by speed alone: still, ballistic above a fifth of the peak, corrective below."""
    speed = hypot(m.vx, m.vy)
    if speed < STILL_M_S:
        return STILL
    return BALLISTIC if speed >= CORRECTIVE_FRACTION * s.peak else CORRECTIVE
