"""The features of a movement, independent of rotation and of the screen's scale.

Lengths on the screen count in ``reach``, the px travelled and what the cursor's peak speed adds; lengths of
the hand in the hand's own reach. How large a movement is stands only in what is measured in metres. Events of
one time are one event: the state goes back to where it was before that time.
"""

from __future__ import annotations

from math import hypot, log
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.predictors import minimum_jerk, movement
from pointpred.predictors.kinematic import history, submovements, track
from pointpred.predictors.kinematic.history import Point
from pointpred.records import FINE, BoolArray, FloatArray, FloatTable, MotionRow, row_at
from pointpred.stage import offsets

LAGS_S = (0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5)

# The places of the features, which the coefficients follow. First those that a mirror leaves as they are:
LOG_REACH, LOG_TIME, TIME, DISTANCE, STRAIGHTNESS, RETURN, CURSOR_PEAK, LOG_PEAK = range(8)
LOG_SPEED, V_ALONG, A_ALONG, SPEED_OF_PEAK, V_ALIGNED = range(8, 13)
SINCE_PEAK, PEAK_SHARE, PEAK_TIME, PEAK_DISTANCE, PEAK_PATH, MEAN_OF_PEAK = range(13, 19)
PUSH, BRAKE, SINCE_PUSH = range(19, 22)
SUBS, SINCE_SUB, SUB_PEAK, SPEED_OF_SUB, SINCE_SUB_PEAK, FALLING, SUB_ALONG, SUB_PATH = range(22, 30)
JERK_AHEAD, SUB_JERK_AHEAD = range(30, 32)
SLOW_FOR, SLOWER_FOR, STILL_FOR, LOG_MEAN = range(32, 36)
STOP_TIME, STOP_WAY = range(36, 38)
_, LAG_ALONG, ODD = offsets(STOP_WAY + 1, len(LAGS_S))
"""From ODD on they change their sign in a mirror: across the direction instead of along it."""
_, V_ACROSS, A_ACROSS, SUB_ACROSS, LAG_ACROSS, FEATURES = offsets(ODD, 1, 1, 1, len(LAGS_S))

REACH_S = 0.06
"""Seconds of the peak speed that count as reach."""
SOON_S = 0.1
"""Velocities count as the way of so long, accelerations as the change of velocity within a tenth of it."""


class Frame(NamedTuple):
    """What lengths are measured in, px on the screen and m of the hand, and the direction from the start.

    ``reach`` is 0 before the cursor has moved; there are no features then.
    """

    reach: float
    hand: float
    ux: float
    uy: float


@law
def ahead(ratio: float) -> float:
    """What a minimum-jerk movement has ahead as a share of its way done, from speed over peak."""
    _, done = minimum_jerk.progress(ratio)
    return float((1.0 - done) / done)


@law
def direction(x: float, y: float, vx: float, vy: float) -> tuple[float, float]:
    """From the start to the cursor; at the start the hand's, without one along x."""
    d = hypot(x, y)
    if d > 0.0:
        return x / d, y / d
    speed = hypot(vx, vy)
    if speed > 0.0:
        return vx / speed, vy / speed
    return 1.0, 0.0


@law
def frame_of(memory: FloatArray, at: int, point: Point, m: MotionRow) -> Frame:
    """The frame of the movement so far; ``at``: its track."""
    ux, uy = direction(point.x, point.y, m.vx, m.vy)
    if not point.path > 0.0:
        return Frame(0.0, 0.0, ux, uy)
    reach = point.path + REACH_S * memory[at + track.CURSOR_PEAK]
    return Frame(reach, memory[at + track.WAY] + REACH_S * memory[at + track.PEAK] + 1e-4, ux, uy)


@law
def fill_shape(memory: FloatArray, at: int, point: Point, frame: Frame, out: FloatArray) -> None:
    """Features of the way so far: its length, its peak, its sub-movements."""
    t, x, y, path = point
    reach, hand, _, _ = frame
    sub = at + track.SUBMOVEMENT
    d, peak = hypot(x, y), memory[at + track.PEAK] + 1e-9
    out[LOG_REACH] = log(hand)
    out[LOG_TIME] = log(t + 0.02)
    out[TIME] = t
    out[DISTANCE] = d / reach
    out[STRAIGHTNESS] = d / path
    out[RETURN] = d / max(memory[at + track.FAR], 1e-9)
    out[CURSOR_PEAK] = memory[at + track.CURSOR_PEAK] * SOON_S / reach
    out[LOG_PEAK] = log(memory[at + track.PEAK] + 3e-4)
    out[SINCE_PEAK] = t - memory[at + track.PEAK_T]
    out[PEAK_SHARE] = memory[at + track.PEAK_T] / (t + 1e-3)
    out[PEAK_TIME] = memory[at + track.PEAK_T]
    out[PEAK_DISTANCE] = memory[at + track.PEAK_D] / reach
    out[PEAK_PATH] = memory[at + track.PEAK_PATH] / path
    out[MEAN_OF_PEAK] = memory[at + track.WAY] / (t + 1e-3) / peak
    out[PUSH] = memory[at + track.PUSH] * SOON_S * 0.1 / hand
    out[BRAKE] = memory[at + track.BRAKE] * SOON_S * 0.1 / hand
    out[SINCE_PUSH] = t - memory[at + track.PUSH_T]
    out[SUBS] = min(memory[sub + submovements.COUNT], 6.0)
    out[SINCE_SUB] = t - memory[sub + submovements.T]
    out[SUB_PEAK] = memory[sub + submovements.PEAK] / peak
    out[SINCE_SUB_PEAK] = t - memory[sub + submovements.PEAK_T]
    out[FALLING] = memory[sub + submovements.FALLING]
    out[SUB_PATH] = (path - memory[sub + submovements.PATH]) / reach
    out[SLOW_FOR] = t - memory[at + track.FAST_T]
    out[SLOWER_FOR] = t - memory[at + track.MOVING_T]
    out[STILL_FOR] = t - memory[at + track.MOVED_T]
    out[LOG_MEAN] = log(memory[at + track.WAY] / (t + 0.01) + 3e-4)


@law
def fill_pace(memory: FloatArray, at: int, point: Point, m: MotionRow, frame: Frame, out: FloatArray) -> None:
    """Features of the present motion: against its peaks, across the direction, and what it says is left."""
    reach, hand, ux, uy = frame
    sub = at + track.SUBMOVEMENT
    sub_x, sub_y = point.x - memory[sub + submovements.X], point.y - memory[sub + submovements.Y]
    peak, sub_peak = memory[at + track.PEAK] + 1e-9, memory[sub + submovements.PEAK] + 1e-9
    v, v_along, a_along = hypot(m.vx, m.vy), m.vx * ux + m.vy * uy, m.ax * ux + m.ay * uy
    out[LOG_SPEED] = log(v + 3e-3)
    out[V_ALONG] = v_along * SOON_S / hand
    out[A_ALONG] = a_along * SOON_S * 0.1 / hand
    out[SPEED_OF_PEAK] = v / peak
    out[V_ALIGNED] = v_along / (v + 1e-6)
    out[SPEED_OF_SUB] = v / sub_peak
    of_peak = v / peak if point.t > memory[at + track.PEAK_T] else 1.0
    of_sub = v / sub_peak if point.t > memory[sub + submovements.PEAK_T] else 1.0
    out[JERK_AHEAD] = ahead(of_peak) * hypot(point.x, point.y) / reach
    out[SUB_JERK_AHEAD] = ahead(of_sub) * hypot(sub_x, sub_y) / reach
    braking = max(-a_along, 1e-3)
    out[STOP_TIME] = min(1.0, max(-1.0, v_along / braking))
    out[STOP_WAY] = min(4.0, v_along * v_along / (2.0 * braking) / hand)
    out[SUB_ALONG] = (sub_x * ux + sub_y * uy) / reach
    out[SUB_ACROSS] = (sub_y * ux - sub_x * uy) / reach
    out[V_ACROSS] = (m.vy * ux - m.vx * uy) * SOON_S / hand
    out[A_ACROSS] = (m.ay * ux - m.ax * uy) * SOON_S * 0.1 / hand


@law
def fill_lags(memory: FloatArray, at: int, point: Point, frame: Frame, out: FloatArray) -> None:
    """Features of the way of the last moments, from the history at ``at``."""
    reach, _, ux, uy = frame
    for i in range(len(LAGS_S)):
        past_x, past_y, _ = history.past(memory, at, point, LAGS_S[i])
        lag_x, lag_y = point.x - past_x, point.y - past_y
        out[LAG_ALONG + i] = (lag_x * ux + lag_y * uy) / reach
        out[LAG_ACROSS + i] = (lag_y * ux - lag_x * uy) / reach


# State, relative to `at`: the movement; the track and the head of the history, and both as they were before
# the last time; the history.
_, TRACK, TRACK_BEFORE, HEAD_BEFORE, HISTORY, STATES = offsets(
    movement.State.length, track.STATES, track.STATES, history.HEAD, history.STATES
)


@law
def rewind(memory: FloatArray, at: int, again: bool) -> None:
    """Copy the track before a new time; go back to the copy where a sample of the same time comes again."""
    source, head = (TRACK_BEFORE, HEAD_BEFORE) if again else (TRACK, HISTORY)
    target, head_target = (TRACK, HISTORY) if again else (TRACK_BEFORE, HEAD_BEFORE)
    for i in range(track.STATES):
        memory[at + target + i] = memory[at + source + i]
    for i in range(history.HEAD):
        memory[at + head_target + i] = memory[at + head + i]


@law
def follow(memory: FloatArray, at: int, m: MotionRow) -> tuple[int, Point]:
    """Take one motion in: its fault, and where the cursor is."""
    started, last_t = movement.State(memory, at).known, movement.State(memory, at).t
    fault, new, _ = movement.follow(movement.State(memory, at), m)
    if fault != FINE:
        return fault, Point(0.0, 0.0, 0.0, 0.0)
    if new or m.t == movement.State(memory, at).t0:
        memory[at + TRACK : at + HISTORY] = 0.0
        history.begin(memory, at + HISTORY)
    else:
        rewind(memory, at, started == 1.0 and m.t == last_t)
    here = at + TRACK
    last = memory[here + track.T], memory[here + track.X], memory[here + track.Y]
    t0, x0, y0 = movement.State(memory, at).t0, movement.State(memory, at).x0, movement.State(memory, at).y0
    point = history.extend(memory, at + HISTORY, last, (m.t - t0, m.x - x0, m.y - y0))
    _, _, path_before = history.past(memory, at + HISTORY, point, track.SPAN_S)
    track.advance(memory, here, point, m, (point.path - path_before) / track.SPAN_S)
    return FINE, point


@law
def observe(memory: FloatArray, at: int, m: MotionRow, out: FloatArray) -> tuple[int, Frame]:
    """Take one motion in and compute the features: its fault, and their frame."""
    fault, point = follow(memory, at, m)
    if fault != FINE:
        return fault, Frame(0.0, 0.0, 0.0, 0.0)
    here = at + TRACK
    frame = frame_of(memory, here, point, m)
    if frame.reach > 0.0:
        fill_shape(memory, here, point, frame, out)
        fill_pace(memory, here, point, m, frame, out)
        fill_lags(memory, at + HISTORY, point, frame, out)
    return FINE, frame


@law
def observe_all(
    memory: FloatArray, begin: BoolArray, rows: FloatTable, out: FloatTable, frames: FloatTable
) -> None:
    """The features of a whole table of motions, as training needs them; frames: reach and direction."""
    for i in range(len(rows)):
        if begin[i]:
            memory[:] = 0.0
        _, frame = observe(memory, 0, MotionRow(*row_at(rows, i)), out[i])
        frames[i, 0], frames[i, 1], frames[i, 2] = frame.reach, frame.ux, frame.uy
