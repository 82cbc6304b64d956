"""The state of the movement so far, common to most predictors."""

from __future__ import annotations

from math import hypot

from pointpred.compiled import law
from pointpred.records import (
    FINE,
    MOTION_FIELD,
    MOTION_MOST,
    ORDER,
    FloatArray,
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

# State, relative to `at`: known, last sample, first sample of the movement, peak speed, px travelled.
KNOWN, T, X, Y, T0, X0, Y0, PEAK, PATH, STATES = range(10)

STILL, BALLISTIC, CORRECTIVE = 0.0, 1.0, 2.0


@law
def fault_of(memory: FloatArray, at: int, m: MotionRow) -> int:
    """FINE; ORDER before the last time; MOTION_FIELD plus the place of the first value out of its bounds."""
    for i in range(NUMBERS):
        if not abs(m[i]) <= MOTION_MOST:
            return MOTION_FIELD + i
    return ORDER if memory[at + KNOWN] == 1.0 and m.t < memory[at + T] else FINE


@law
def refuse(memory: FloatArray, at: int, m: MotionRow, fault: int) -> TenFloats:
    """The answer to a motion with a fault."""
    return refused(fault, memory[at + T] if fault == ORDER else m[fault - MOTION_FIELD])


@law
def follow(memory: FloatArray, at: int, m: MotionRow) -> tuple[int, bool, float]:
    """Take one motion in: (its fault, a movement starts here, dt in s since the motion before).

    With a fault other than FINE the memory is unchanged.
    """
    t, x, y = m.t, m.x, m.y
    fault = fault_of(memory, at, m)
    if fault != FINE:
        return fault, False, 0.0
    new = m.start == 1.0 or memory[at + KNOWN] == 0.0
    dt = 0.0 if new else t - memory[at + T]
    if new or t == memory[at + T0]:  # of events at one time, the later position replaces
        memory[at + T0], memory[at + X0], memory[at + Y0] = t, x, y
        memory[at + PATH] = 0.0
    else:
        memory[at + PATH] += hypot(x - memory[at + X], y - memory[at + Y])
    if new:
        memory[at + PEAK] = 0.0
    memory[at + KNOWN] = 1.0
    memory[at + T], memory[at + X], memory[at + Y] = t, x, y
    memory[at + PEAK] = max(memory[at + PEAK], hypot(m.vx, m.vy))
    return FINE, new, dt


@law
def phase(memory: FloatArray, at: int, m: MotionRow) -> float:
    """The phase by speed alone: still, ballistic above a fifth of the peak, corrective below."""
    speed = hypot(m.vx, m.vy)
    if speed < STILL_M_S:
        return STILL
    return BALLISTIC if speed >= CORRECTIVE_FRACTION * memory[at + PEAK] else CORRECTIVE
