"""The state of the movement so far, common to most predictors."""

from __future__ import annotations

from math import hypot, inf

from pointpred.compiled import law
from pointpred.records import FloatArray, MotionRow

STILL_M_S = 0.002
"""Below this speed of the hand nothing moves: two counts a second of a coarse mouse."""
CORRECTIVE_FRACTION = 0.2
"""A movement slower than this share of its peak is corrective (thesis 2.5.6: a fifth)."""

# State, relative to `at`: known, last sample, first sample of the movement, peak speed, px travelled.
KNOWN, T, X, Y, T0, X0, Y0, PEAK, PATH, STATES = range(10)

STILL, BALLISTIC, CORRECTIVE = 0.0, 1.0, 2.0


@law
def follow(memory: FloatArray, at: int, m: MotionRow) -> tuple[bool, bool, float]:
    """Take one motion in: (accepted, a movement starts here, dt in s since the motion before).

    Not accepted, and the memory unchanged: a value that is not finite, or a time before the last one.
    """
    t, x, y = m.t, m.x, m.y
    size = abs(t) + abs(x) + abs(y) + abs(m.vx) + abs(m.vy) + abs(m.ax) + abs(m.ay)
    if not size < inf or (memory[at + KNOWN] == 1.0 and t < memory[at + T]):
        return False, False, 0.0
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
    return True, new, dt


@law
def phase(memory: FloatArray, at: int, m: MotionRow) -> float:
    """The phase by speed alone: still, ballistic above a fifth of the peak, corrective below."""
    speed = hypot(m.vx, m.vy)
    if speed < STILL_M_S:
        return STILL
    return BALLISTIC if speed >= CORRECTIVE_FRACTION * memory[at + PEAK] else CORRECTIVE
