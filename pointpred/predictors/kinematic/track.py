"""The movement's track for the learned predictor: peaks, sub-movements, time since it became slow.

Places are px relative to the movement's start, times seconds since it, speeds the hand's.
"""

from __future__ import annotations

from math import hypot

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.predictors.kinematic import submovements
from pointpred.predictors.kinematic.history import Point
from pointpred.records import MotionRow

SLOW, SLOWER = 0.2, 0.05
"""Shares of the peak speed below which a movement is slow."""
SPAN_S = 0.05
"""Over how long the cursor's own speed is taken."""


class State(Layout):
    """The last sample, and the extremes of the samples so far."""

    t: float
    x: float
    y: float
    way: float
    """The hand's, m."""
    far: float
    """Largest distance from the start, px."""
    cursor_peak: float
    """px/s."""
    peak: float
    """The hand's largest speed, m/s; then when, how far from the start and after which path in px it was."""
    peak_t: float
    peak_d: float
    peak_path: float
    push: float
    """Largest and least acceleration away from the start, m/s^2."""
    push_t: float
    brake: float
    submovement: submovements.State
    fast_t: float
    """When the speed was last above SLOW and above SLOWER of its peak, and when the cursor last moved."""
    moving_t: float
    moved_t: float


@law
def advance(s: State, point: Point, hand: MotionRow, cursor_speed: float) -> None:
    """Take one sample in: where the cursor is, the hand's motion, the cursor's speed in px/s."""
    t, x, y, path = point
    speed, d = hypot(hand.vx, hand.vy), hypot(x, y)
    if x != s.x or y != s.y:
        s.moved_t = t
    s.way += speed * (t - s.t)
    s.t, s.x, s.y = t, x, y
    s.far = max(s.far, d)
    s.cursor_peak = max(s.cursor_peak, cursor_speed)
    if speed > s.peak:
        s.peak, s.peak_t = speed, t
        s.peak_d, s.peak_path = d, path
    push = (hand.ax * x + hand.ay * y) / d if d > 0.0 else 0.0
    if push > s.push:
        s.push, s.push_t = push, t
    s.brake = min(s.brake, push)
    if speed >= SLOW * s.peak:
        s.fast_t = t
    if speed >= SLOWER * s.peak:
        s.moving_t = t
    submovements.divide(s.submovement, point, speed, s.peak)
