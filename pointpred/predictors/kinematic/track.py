"""What a learned predictor follows through a movement: peaks, sub-movements, how long it has been slow.

Places are px relative to the movement's start, times seconds since it, speeds the hand's.
"""

from __future__ import annotations

from math import hypot

from pointpred.columns import FloatArray
from pointpred.compiled import law

FALLEN, RISEN = 0.7, 1.4
"""A sub-movement ends where the speed has fallen below this share of its peak and rises by this factor."""
RISE_SHARE, RISE_M_S = 0.02, 0.005
"""That rise is more than this share of the movement's peak and this speed: noise is no sub-movement."""
REST_M_S = 1e-6
"""Speeds that differ by less are equal: a hand at rest has one valley, wherever rounding puts its zero."""
SLOW, SLOWER = 0.2, 0.05
"""Shares of the peak speed below which a movement is slow."""
SPAN_S = 0.05
"""Over how long the cursor's own speed is taken."""

# State, relative to `at`: the last sample, the hand's way in m, farthest from the start, the cursor's peak.
T, X, Y, WAY, FAR, CURSOR_PEAK = 0, 1, 2, 3, 4, 5
# The hand's speed peak: how fast, when, how far from the start, after which path; accelerations.
PEAK, PEAK_T, PEAK_D, PEAK_PATH, PUSH, PUSH_T, BRAKE = 6, 7, 8, 9, 10, 11, 12
# The sub-movement: how many before, where it began, its peak, whether it still rises, and its last valley.
SUBS, SUB_T, SUB_X, SUB_Y, SUB_PATH, SUB_PEAK, SUB_PEAK_T, FALLING = 13, 14, 15, 16, 17, 18, 19, 20
LOW, LOW_T, LOW_X, LOW_Y, LOW_PATH = 21, 22, 23, 24, 25
# When the speed was last above a fifth and a twentieth of the peak, and when the cursor last moved.
FAST_T, MOVING_T, MOVED_T = 26, 27, 28
STATES = 29


@law
def divide(memory: FloatArray, at: int, t: float, x: float, y: float, path: float, speed: float) -> None:
    """Part the movement into sub-movements at the valleys of its speed."""
    if memory[at + FALLING] == 0.0:
        if speed > memory[at + SUB_PEAK]:
            memory[at + SUB_PEAK], memory[at + SUB_PEAK_T] = speed, t
        elif speed < FALLEN * memory[at + SUB_PEAK]:
            memory[at + FALLING] = 1.0
            memory[at + LOW] = 2.0 * speed
    if memory[at + FALLING] == 0.0:
        return
    if speed < memory[at + LOW] - REST_M_S:
        memory[at + LOW], memory[at + LOW_T] = speed, t
        memory[at + LOW_X], memory[at + LOW_Y], memory[at + LOW_PATH] = x, y, path
    elif speed > RISEN * memory[at + LOW] + RISE_SHARE * memory[at + PEAK] + RISE_M_S:
        memory[at + FALLING] = 0.0
        memory[at + SUBS] += 1.0
        memory[at + SUB_T], memory[at + SUB_PATH] = memory[at + LOW_T], memory[at + LOW_PATH]
        memory[at + SUB_X], memory[at + SUB_Y] = memory[at + LOW_X], memory[at + LOW_Y]
        memory[at + SUB_PEAK], memory[at + SUB_PEAK_T] = speed, t


@law
def advance(
    memory: FloatArray,
    at: int,
    t: float,
    x: float,
    y: float,
    path: float,
    cursor_speed: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
) -> None:
    """Take one sample in."""
    speed, d = hypot(vx, vy), hypot(x, y)
    if x != memory[at + X] or y != memory[at + Y]:
        memory[at + MOVED_T] = t
    memory[at + WAY] += speed * (t - memory[at + T])
    memory[at + T], memory[at + X], memory[at + Y] = t, x, y
    memory[at + FAR] = max(memory[at + FAR], d)
    memory[at + CURSOR_PEAK] = max(memory[at + CURSOR_PEAK], cursor_speed)
    if speed > memory[at + PEAK]:
        memory[at + PEAK], memory[at + PEAK_T] = speed, t
        memory[at + PEAK_D], memory[at + PEAK_PATH] = d, path
    push = (ax * x + ay * y) / d if d > 0.0 else 0.0
    if push > memory[at + PUSH]:
        memory[at + PUSH], memory[at + PUSH_T] = push, t
    memory[at + BRAKE] = min(memory[at + BRAKE], push)
    if speed >= SLOW * memory[at + PEAK]:
        memory[at + FAST_T] = t
    if speed >= SLOWER * memory[at + PEAK]:
        memory[at + MOVING_T] = t
    divide(memory, at, t, x, y, path, speed)
