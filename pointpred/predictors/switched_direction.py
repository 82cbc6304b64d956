"""The switched predictor along the direction of movement, one sub-movement after the other."""

from __future__ import annotations

from math import hypot

from pointpred.compiled import law
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, MotionRow, TenFloats, endpoint


class Settings(Layout):
    """The parameters."""

    rise: float
    typical_s: float
    own: float
    turn: float
    watched: float
    stopping: float


class Submovement(Layout):
    """The highest speed in m/s and where it was; the lowest since then, where that was; where it started."""

    peak: float
    peak_x: float
    peak_y: float
    valley: float
    valley_x: float
    valley_y: float
    start_x: float
    start_y: float


class Hand(Layout):
    """The hand's last velocity, its displacement in m since the movement's start; the gain's two sums."""

    vx: float
    vy: float
    x: float
    y: float
    cross: float
    square: float


class State(Layout):
    """What is remembered of the movement."""

    movement: movement.State
    submovement: Submovement
    hand: Hand


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def begin_submovement(s: Submovement, x: float, y: float) -> None:
    """A movement starts at rest at (x, y)."""
    s.peak, s.valley = 0.0, 0.0
    s.peak_x, s.peak_y = x, y
    s.valley_x, s.valley_y = x, y
    s.start_x, s.start_y = x, y


@law
def follow_submovement(s: Submovement, rise: float, x: float, y: float, speed: float) -> None:
    """Take one sample in; a rise of the speed by ``rise`` of the peak out of a valley is a new sub-movement.

    It started in the valley. Two samples of one time are one: the later place replaces.
    """
    if speed < s.peak and speed <= s.valley + rise * s.peak:
        if speed <= s.valley:
            s.valley, s.valley_x, s.valley_y = speed, x, y
        return
    if speed < s.peak:
        s.start_x, s.start_y = s.valley_x, s.valley_y
    s.peak, s.peak_x, s.peak_y = speed, x, y
    s.valley, s.valley_x, s.valley_y = speed, x, y


@law
def gain(hand: Hand, dt: float, away_x: float, away_y: float, vx: float, vy: float) -> float:
    """Averaged gain g in px/m by least squares, displacement = g times the hand's; 0 where unknown."""
    hand.x += 0.5 * dt * (vx + hand.vx)
    hand.y += 0.5 * dt * (vy + hand.vy)
    hand.vx, hand.vy = vx, vy
    hand.cross += dt * (away_x * hand.x + away_y * hand.y)
    hand.square += dt * (hand.x * hand.x + hand.y * hand.y)
    if not (hand.cross > 0.0 and hand.square > 0.0):
        return 0.0
    return hand.cross / hand.square


@law
def time_constant(own: float, typical_s: float, done: float, peak: float) -> float:
    """Time constant at the peak in s, from the sub-movement's own, way done / peak speed, and a typical."""
    if own == 0.0:
        return typical_s
    return float((done / peak) ** own * typical_s ** (1.0 - own))


@law
def approach(settings: Settings, s: Submovement, px_m: float, x: float, y: float, speed: float) -> float:
    """Rate k in 1/s of the approach V = k (T - x): from the switch and the slope since; 0 where unknown."""
    done = hypot(s.peak_x - s.start_x, s.peak_y - s.start_y)
    if done == 0.0:
        return 0.0
    at_switch = 1.0 / time_constant(settings.own, settings.typical_s, done, s.peak * px_m)
    since = hypot(x - s.peak_x, y - s.peak_y)
    slope = (s.peak - speed) * px_m / since if since > 0.0 else 0.0
    share = (speed / s.peak) ** settings.turn
    return float(share * at_switch + (1.0 - share) * settings.watched * slope)


@law
def step(memory: Memory, motion: TenFloats) -> TenFloats:
    """Follow the sub-movement and add what is left of it in the direction of the hand."""
    m = MotionRow(*motion)
    settings, s = memory.settings, memory.state.movement
    submovement, hand = memory.state.submovement, memory.state.hand
    fault, new, dt = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    if new:
        clear(hand)
    if new or m.t == s.t0:
        begin_submovement(submovement, m.x, m.y)
    speed = hypot(m.vx, m.vy)
    follow_submovement(submovement, settings.rise, m.x, m.y, speed)
    px_m = gain(hand, dt, m.x - s.x0, m.y - s.y0, m.vx, m.vy)
    known = px_m > 0.0 and speed > movement.STILL_M_S
    rate = approach(settings, submovement, px_m, m.x, m.y, speed) if known else 0.0
    ahead_s = 1.0 / rate if rate > 0.0 else 0.0
    braking = -(m.ax * m.vx + m.ay * m.vy)
    if braking > 0.0 and ahead_s * braking > settings.stopping * speed * speed:
        ahead_s = settings.stopping * speed * speed / braking
    end_x, end_y = m.x + ahead_s * px_m * m.vx, m.y + ahead_s * px_m * m.vy
    return endpoint(m.t, end_x, end_y, movement.phase(s, m))


class SwitchedDirectionPredictor(Predictor):
    """Switched predictor along the direction of movement, one sub-movement after the other.

    The thesis's physics, arranged otherwise. Assumes that a sub-movement rises from rest, or from a valley of
    the speed, to a peak with half its way done, and then approaches its end T as V = k (T - x). At the switch
    doubling holds, T = 2x, which fixes the rate k: the peak's speed over the way done. After it the slope of
    the speed over the place shows k once more. And no hand goes farther than it would under the deceleration
    it has: a speed v that falls by b m/s^2 is gone after v^2 / (2b).

    With v the speed, v_p its peak, s the way done at the peak and l the way since, in px and all of this
    sub-movement: k = q v_p^a / (s^a typical_s^(1-a)) + (1 - q) watched (v_p - v) / l with a = ``own`` and
    q = (v / v_p)^turn; the way left is min(v / k, stopping v^2 / b) in the direction of the velocity. With
    a = 1 neither a time nor a length is built in. As the hand slows v / k goes to 0 at least like
    v^(1-turn): the corrective phase converges. Below 2 mm/s the cursor has arrived.

    A sub-movement begins where the speed rises out of a valley by ``rise`` of the peak before. Each sees only
    itself: a later correction is not predicted. The hand's velocity becomes the cursor's by the averaged
    gain, least squares of the cursor's displacement on the hand's.

    Parameters: ``rise`` (share of the peak speed), ``typical_s`` s, ``own``, ``turn``, ``watched``,
    ``stopping`` (no unit). Always answers, at first with the cursor. Memory: 29 floats. Claims no region and
    no time of arrival: an exponential never arrives. Raises ParameterError, and EventError from ``update``.

    Reference: Khalin 2022, sections 2.4.2, 2.4.3 and 2.5.6, changed as docs/evidence/reproduce.md tells.

    >>> from pointpred import Motion
    >>> predictor = SwitchedDirectionPredictor(own=1.0)
    >>> for i in range(5):  # 1000 px a metre; 0.4 m/s after 80 px, the most so far
    ...     motion = Motion(i / 10, 5.0 * i * i, 0.0, i / 10, 0.0, 1.0, 0.0, True, start=i == 0)
    ...     prediction = predictor.update(motion)
    >>> round(prediction.x, 6)  # doubled
    160.0
    """

    rise: float = parameter(
        "share of peak speed", 0.0, 10.0, "a rise out of a valley by more is a sub-movement", default=0.6
    )
    typical_s: float = parameter(
        "s", 1e-4, 10.0, "time constant of a typical approach at its peak", default=0.045
    )
    own: float = parameter(
        "", 0.0, 1.0, "share of the sub-movement's own time in its time constant", default=0.4
    )
    turn: float = parameter(
        "", 0.0, 1.0, "power of speed over peak speed that says how much the peak counts", default=0.6
    )
    watched: float = parameter("", 0.0, 10.0, "weight of the rate seen since the peak", default=0.65)
    stopping: float = parameter("", 0.0, 1e6, "way left at most, in speed^2 / deceleration", default=0.5)
    step = staticmethod(step)
    claims_time = False
    states = State.length
