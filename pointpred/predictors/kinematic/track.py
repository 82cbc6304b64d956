"""The movement's track for the learned predictor: peaks, sub-movements, time since it became slow.

Places are px relative to the movement's start, times seconds since it, speeds the hand's.
"""

from __future__ import annotations

from math import hypot

from pointpred.compiled import law
from pointpred.predictors.kinematic import submovements
from pointpred.predictors.kinematic.history import Point
from pointpred.records import FloatArray, MotionRow
from pointpred.stage import offsets

SLOW, SLOWER = 0.2, 0.05
"""Shares of the peak speed below which a movement is slow."""
SPAN_S = 0.05
"""Over how long the cursor's own speed is taken."""

# State, relative to `at`: the last sample, the hand's way in m, farthest from the start, the cursor's peak;
# the hand's speed peak: how fast, when, how far from the start, after which path; accelerations; the
# sub-movement; when the speed was last above a fifth and a twentieth of the peak, and the cursor last moved.
PEAK_STATES = 13
T, X, Y, WAY, FAR, CURSOR_PEAK, PEAK, PEAK_T, PEAK_D, PEAK_PATH, PUSH, PUSH_T, BRAKE = range(PEAK_STATES)
_, SUBMOVEMENT, FAST_T, MOVING_T, MOVED_T, STATES = offsets(PEAK_STATES, submovements.STATES, 1, 1, 1)


@law
def advance(memory: FloatArray, at: int, point: Point, hand: MotionRow, cursor_speed: float) -> None:
    """Take one sample in: where the cursor is, the hand's motion, the cursor's speed in px/s."""
    t, x, y, path = point
    speed, d = hypot(hand.vx, hand.vy), hypot(x, y)
    if x != memory[at + X] or y != memory[at + Y]:
        memory[at + MOVED_T] = t
    memory[at + WAY] += speed * (t - memory[at + T])
    memory[at + T], memory[at + X], memory[at + Y] = t, x, y
    memory[at + FAR] = max(memory[at + FAR], d)
    memory[at + CURSOR_PEAK] = max(memory[at + CURSOR_PEAK], cursor_speed)
    if speed > memory[at + PEAK]:
        memory[at + PEAK], memory[at + PEAK_T] = speed, t
        memory[at + PEAK_D], memory[at + PEAK_PATH] = d, path
    push = (hand.ax * x + hand.ay * y) / d if d > 0.0 else 0.0
    if push > memory[at + PUSH]:
        memory[at + PUSH], memory[at + PUSH_T] = push, t
    memory[at + BRAKE] = min(memory[at + BRAKE], push)
    if speed >= SLOW * memory[at + PEAK]:
        memory[at + FAST_T] = t
    if speed >= SLOWER * memory[at + PEAK]:
        memory[at + MOVING_T] = t
    submovements.divide(memory, at + SUBMOVEMENT, point, speed, memory[at + PEAK])
