"""The switched predictor along the direction of movement, one sub-movement after the other."""

from __future__ import annotations

from math import hypot

from pointpred.compiled import law
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, FloatArray, MotionRow, TenFloats, endpoint
from pointpred.stage import offsets

# State, relative to `at`: highest speed in m/s; where it was; lowest speed since then; where that was; where
# the sub-movement started.
PEAK, PEAK_X, PEAK_Y, VALLEY, VALLEY_X, VALLEY_Y, START_X, START_Y, SUBMOVEMENT = range(9)


@law
def begin_submovement(memory: FloatArray, at: int, x: float, y: float) -> None:
    """A movement starts at rest at (x, y)."""
    memory[at + PEAK], memory[at + VALLEY] = 0.0, 0.0
    memory[at + PEAK_X], memory[at + PEAK_Y] = x, y
    memory[at + VALLEY_X], memory[at + VALLEY_Y] = x, y
    memory[at + START_X], memory[at + START_Y] = x, y


@law
def follow_submovement(memory: FloatArray, at: int, rise: float, x: float, y: float, speed: float) -> None:
    """Take one sample in; a rise of the speed by ``rise`` of the peak out of a valley is a new sub-movement.

    It started in the valley. Two samples of one time are one: the later place replaces.
    """
    peak, valley = memory[at + PEAK], memory[at + VALLEY]
    if speed < peak and speed <= valley + rise * peak:
        if speed <= valley:
            memory[at + VALLEY] = speed
            memory[at + VALLEY_X], memory[at + VALLEY_Y] = x, y
        return
    if speed < peak:
        memory[at + START_X], memory[at + START_Y] = memory[at + VALLEY_X], memory[at + VALLEY_Y]
    memory[at + PEAK], memory[at + VALLEY] = speed, speed
    memory[at + PEAK_X], memory[at + PEAK_Y] = x, y
    memory[at + VALLEY_X], memory[at + VALLEY_Y] = x, y


# The parameters.
RISE, TYPICAL_S, OWN, TURN, WATCHED, STOPPING, AT = range(7)
# The movement; its sub-movement; the hand's last velocity, its displacement in m since the movement's start;
# the gain's two sums.
_, UNIT, VX, VY, HAND_X, HAND_Y, CROSS, SQUARE, END = offsets(
    AT + movement.State.length, SUBMOVEMENT, 1, 1, 1, 1, 1, 1
)


@law
def gain(memory: FloatArray, dt: float, away_x: float, away_y: float, vx: float, vy: float) -> float:
    """Averaged gain g in px/m by least squares, displacement = g times the hand's; 0 where unknown."""
    memory[HAND_X] += 0.5 * dt * (vx + memory[VX])
    memory[HAND_Y] += 0.5 * dt * (vy + memory[VY])
    memory[VX], memory[VY] = vx, vy
    hand_x, hand_y = memory[HAND_X], memory[HAND_Y]
    memory[CROSS] += dt * (away_x * hand_x + away_y * hand_y)
    memory[SQUARE] += dt * (hand_x * hand_x + hand_y * hand_y)
    if not (memory[CROSS] > 0.0 and memory[SQUARE] > 0.0):
        return 0.0
    return float(memory[CROSS] / memory[SQUARE])


@law
def time_constant(own: float, typical_s: float, done: float, peak: float) -> float:
    """Time constant at the peak in s, from the sub-movement's own, way done / peak speed, and a typical."""
    if own == 0.0:
        return typical_s
    return float((done / peak) ** own * typical_s ** (1.0 - own))


@law
def approach(memory: FloatArray, px_m: float, x: float, y: float, speed: float) -> float:
    """Rate k in 1/s of the approach V = k (T - x): from the switch and the slope since; 0 where unknown."""
    peak = memory[UNIT + PEAK]
    peak_x, peak_y = memory[UNIT + PEAK_X], memory[UNIT + PEAK_Y]
    done = hypot(peak_x - memory[UNIT + START_X], peak_y - memory[UNIT + START_Y])
    if done == 0.0:
        return 0.0
    at_switch = 1.0 / time_constant(memory[OWN], memory[TYPICAL_S], done, peak * px_m)
    since = hypot(x - peak_x, y - peak_y)
    slope = (peak - speed) * px_m / since if since > 0.0 else 0.0
    share = (speed / peak) ** memory[TURN]
    return float(share * at_switch + (1.0 - share) * memory[WATCHED] * slope)


@law
def step(memory: FloatArray, motion: TenFloats) -> TenFloats:
    """Follow the sub-movement and add what is left of it in the direction of the hand."""
    m = MotionRow(*motion)
    fault, new, dt = movement.follow(movement.State(memory, AT), m)
    if fault != FINE:
        return movement.refuse(movement.State(memory, AT), m, fault)
    if new:
        memory[VX:END] = 0.0
    if new or m.t == movement.State(memory, AT).t0:
        begin_submovement(memory, UNIT, m.x, m.y)
    speed = hypot(m.vx, m.vy)
    follow_submovement(memory, UNIT, memory[RISE], m.x, m.y, speed)
    phase = movement.phase(movement.State(memory, AT), m)
    px_m = gain(
        memory, dt, m.x - movement.State(memory, AT).x0, m.y - movement.State(memory, AT).y0, m.vx, m.vy
    )
    rate = approach(memory, px_m, m.x, m.y, speed) if px_m > 0.0 and speed > movement.STILL_M_S else 0.0
    ahead_s = 1.0 / rate if rate > 0.0 else 0.0
    braking = -(m.ax * m.vx + m.ay * m.vy)
    if braking > 0.0 and ahead_s * braking > memory[STOPPING] * speed * speed:
        ahead_s = memory[STOPPING] * speed * speed / braking
    return endpoint(m.t, m.x + ahead_s * px_m * m.vx, m.y + ahead_s * px_m * m.vy, phase)


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
    states = END - AT
