"""The features of a movement, independent of rotation and of the screen's scale.

Lengths on the screen count in ``reach``, the px travelled and what the cursor's peak speed adds; lengths of
the hand in the hand's own reach. How large a movement is stands only in what is measured in metres. Events of
one time are one event: the state goes back to where it was before that time.
"""

from __future__ import annotations

from math import hypot, log
from typing import Annotated, NamedTuple

from pointpred.compiled import law
from pointpred.layout import Layout, clear, places
from pointpred.predictors import minimum_jerk, movement
from pointpred.predictors.kinematic import history, track
from pointpred.predictors.kinematic.history import Point
from pointpred.records import FINE, BoolArray, FloatArray, FloatTable, MotionRow, row_at

LAGS_S = (0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5)


class Across(Layout):
    """The features that change their sign in a mirror: across the direction instead of along it."""

    v: float
    a: float
    sub: float
    lag: Annotated[FloatArray, len(LAGS_S)]


class Values(Layout):
    """The features, which the coefficients follow; a mirror leaves those before ``across`` as they are."""

    log_reach: float
    log_time: float
    time: float
    distance: float
    straightness: float
    of_farthest: float
    cursor_peak: float
    log_peak: float
    log_speed: float
    v_along: float
    a_along: float
    speed_of_peak: float
    v_aligned: float
    since_peak: float
    peak_share: float
    peak_time: float
    peak_distance: float
    peak_path: float
    mean_of_peak: float
    push: float
    brake: float
    since_push: float
    subs: float
    since_sub: float
    sub_peak: float
    speed_of_sub: float
    since_sub_peak: float
    falling: float
    sub_along: float
    sub_path: float
    jerk_ahead: float
    sub_jerk_ahead: float
    slow_for: float
    slower_for: float
    still_for: float
    log_mean: float
    stop_time: float
    stop_way: float
    lag_along: Annotated[FloatArray, len(LAGS_S)]
    across: Across


PLACE = dict(places(Values))
"""Where a feature stands, by its name."""
ODD = Values.length - Across.length
"""From here on they change their sign in a mirror."""

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
def frame_of(s: track.State, point: Point, m: MotionRow) -> Frame:
    """The frame of the movement so far."""
    ux, uy = direction(point.x, point.y, m.vx, m.vy)
    if not point.path > 0.0:
        return Frame(0.0, 0.0, ux, uy)
    reach = point.path + REACH_S * s.cursor_peak
    return Frame(reach, s.way + REACH_S * s.peak + 1e-4, ux, uy)


@law
def fill_shape(s: track.State, point: Point, frame: Frame, out: Values) -> None:
    """Features of the way so far: its length, its peak, its sub-movements."""
    t, x, y, path = point
    reach, hand, _, _ = frame
    sub = s.submovement
    d, peak = hypot(x, y), s.peak + 1e-9
    out.log_reach = log(hand)
    out.log_time = log(t + 0.02)
    out.time = t
    out.distance = d / reach
    out.straightness = d / path
    out.of_farthest = d / max(s.far, 1e-9)
    out.cursor_peak = s.cursor_peak * SOON_S / reach
    out.log_peak = log(s.peak + 3e-4)
    out.since_peak = t - s.peak_t
    out.peak_share = s.peak_t / (t + 1e-3)
    out.peak_time = s.peak_t
    out.peak_distance = s.peak_d / reach
    out.peak_path = s.peak_path / path
    out.mean_of_peak = s.way / (t + 1e-3) / peak
    out.push = s.push * SOON_S * 0.1 / hand
    out.brake = s.brake * SOON_S * 0.1 / hand
    out.since_push = t - s.push_t
    out.subs = min(sub.count, 6.0)
    out.since_sub = t - sub.t
    out.sub_peak = sub.peak / peak
    out.since_sub_peak = t - sub.peak_t
    out.falling = sub.falling
    out.sub_path = (path - sub.path) / reach
    out.slow_for = t - s.fast_t
    out.slower_for = t - s.moving_t
    out.still_for = t - s.moved_t
    out.log_mean = log(s.way / (t + 0.01) + 3e-4)


@law
def fill_pace(s: track.State, point: Point, m: MotionRow, frame: Frame, out: Values) -> None:
    """Features of the present motion: against its peaks, across the direction, and what it says is left."""
    reach, hand, ux, uy = frame
    sub = s.submovement
    sub_x, sub_y = point.x - sub.x, point.y - sub.y
    peak, sub_peak = s.peak + 1e-9, sub.peak + 1e-9
    v, v_along, a_along = hypot(m.vx, m.vy), m.vx * ux + m.vy * uy, m.ax * ux + m.ay * uy
    out.log_speed = log(v + 3e-3)
    out.v_along = v_along * SOON_S / hand
    out.a_along = a_along * SOON_S * 0.1 / hand
    out.speed_of_peak = v / peak
    out.v_aligned = v_along / (v + 1e-6)
    out.speed_of_sub = v / sub_peak
    of_peak = v / peak if point.t > s.peak_t else 1.0
    of_sub = v / sub_peak if point.t > sub.peak_t else 1.0
    out.jerk_ahead = ahead(of_peak) * hypot(point.x, point.y) / reach
    out.sub_jerk_ahead = ahead(of_sub) * hypot(sub_x, sub_y) / reach
    braking = max(-a_along, 1e-3)
    out.stop_time = min(1.0, max(-1.0, v_along / braking))
    out.stop_way = min(4.0, v_along * v_along / (2.0 * braking) / hand)
    out.sub_along = (sub_x * ux + sub_y * uy) / reach
    out.across.sub = (sub_y * ux - sub_x * uy) / reach
    out.across.v = (m.vy * ux - m.vx * uy) * SOON_S / hand
    out.across.a = (m.ay * ux - m.ax * uy) * SOON_S * 0.1 / hand


@law
def fill_lags(s: history.State, point: Point, frame: Frame, out: Values) -> None:
    """Features of the way of the last moments."""
    reach, _, ux, uy = frame
    for i in range(len(LAGS_S)):
        past_x, past_y, _ = history.past(s, point, LAGS_S[i])
        lag_x, lag_y = point.x - past_x, point.y - past_y
        out.lag_along[i] = (lag_x * ux + lag_y * uy) / reach
        out.across.lag[i] = (lag_y * ux - lag_x * uy) / reach


class Before(Layout):
    """The track and the head of the history as they were before the last time."""

    track: track.State
    head: history.Head


class State(Layout):
    """What is remembered of the movement, and what of that before its last time."""

    movement: movement.State
    track: track.State
    before: Before
    history: history.State


@law
def rewind(s: State, again: bool) -> None:
    """Copy the track before a new time; go back to the copy where a sample of the same time comes again."""
    now, before = s.track, s.before.track
    for i in range(track.State.length):
        if again:
            now.memory[i] = before.memory[i]
        else:
            before.memory[i] = now.memory[i]
    head, head_before = s.history.head, s.before.head
    for i in range(history.Head.length):
        if again:
            head.memory[i] = head_before.memory[i]
        else:
            head_before.memory[i] = head.memory[i]


@law
def follow(s: State, m: MotionRow) -> tuple[int, Point]:
    """Take one motion in: its fault, and where the cursor is."""
    started, last_t = s.movement.known, s.movement.t
    fault, new, _ = movement.follow(s.movement, m)
    if fault != FINE:
        return fault, Point(0.0, 0.0, 0.0, 0.0)
    if new or m.t == s.movement.t0:
        clear(s.track)
        clear(s.before)
        history.begin(s.history)
    else:
        rewind(s, started == 1.0 and m.t == last_t)
    last = s.track.t, s.track.x, s.track.y
    now = m.t - s.movement.t0, m.x - s.movement.x0, m.y - s.movement.y0
    point = history.extend(s.history, last, now)
    _, _, path_before = history.past(s.history, point, track.SPAN_S)
    track.advance(s.track, point, m, (point.path - path_before) / track.SPAN_S)
    return FINE, point


@law
def observe(s: State, m: MotionRow, out: Values) -> tuple[int, Frame]:
    """Take one motion in and compute the features: its fault, and their frame."""
    fault, point = follow(s, m)
    if fault != FINE:
        return fault, Frame(0.0, 0.0, 0.0, 0.0)
    frame = frame_of(s.track, point, m)
    if frame.reach > 0.0:
        fill_shape(s.track, point, frame, out)
        fill_pace(s.track, point, m, frame, out)
        fill_lags(s.history, point, frame, out)
    return FINE, frame


@law
def observe_all(s: State, begin: BoolArray, rows: FloatTable, out: FloatTable, frames: FloatTable) -> None:
    """The features of a whole table of motions, as training needs them; frames: reach and direction."""
    for i in range(len(rows)):
        if begin[i]:
            clear(s)
        _, frame = observe(s, MotionRow(*row_at(rows, i)), Values(out[i]))
        frames[i, 0], frames[i, 1], frames[i, 2] = frame.reach, frame.ux, frame.uy
