"""The switched predictor along the direction of movement, one sub-movement after the other."""

from __future__ import annotations

from math import hypot

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.predictors import movement, submovement
from pointpred.predictors.predictor import NONE, REFUSED, Predictor
from pointpred.stage import Parameter, check

RISE, TYPICAL_S, OWN, TURN, WATCHED, BRAKING, AT = 0, 1, 2, 3, 4, 5, 6
UNIT = AT + movement.STATES
# The hand: its last velocity, its displacement in m since the movement's start; the gain's two sums.
VX, VY, HAND_X, HAND_Y, CROSS, SQUARE = (UNIT + submovement.STATES + i for i in range(6))
STATES = SQUARE + 1 - AT


@law
def gain(memory: FloatArray, dt: float, away_x: float, away_y: float, vx: float, vy: float) -> float:
    """Averaged gain in px/m: the least-squares g of displacement = g times hand displacement; 0 if unknown."""
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
    """Time constant in s at the peak: between the sub-movement's own, way done / peak speed, and a typical."""
    if own == 0.0:
        return typical_s
    return float((done / peak) ** own * typical_s ** (1.0 - own))


@law
def decay(
    memory: FloatArray, px_m: float, x: float, y: float, vx: float, vy: float, ax: float, ay: float
) -> float:
    """Rate k in 1/s of the approach V = k (T - x), from its three signs; 0 where nothing is justified."""
    speed, peak = hypot(vx, vy), memory[UNIT + submovement.PEAK]
    peak_x, peak_y = memory[UNIT + submovement.PEAK_X], memory[UNIT + submovement.PEAK_Y]
    done = hypot(peak_x - memory[UNIT + submovement.START_X], peak_y - memory[UNIT + submovement.START_Y])
    if done == 0.0:
        return 0.0
    switched = 1.0 / time_constant(memory[OWN], memory[TYPICAL_S], done, peak * px_m)
    since = hypot(x - peak_x, y - peak_y)
    watched = (peak - speed) * px_m / since if since > 0.0 else 0.0
    braking = max(0.0, -(ax * vx + ay * vy) / (speed * speed))
    share = (speed / peak) ** memory[TURN]
    return float(share * switched + (1.0 - share) * memory[WATCHED] * watched + memory[BRAKING] * braking)


@law
def step(
    memory: FloatArray,
    t: float,
    x: float,
    y: float,
    vx: float,
    vy: float,
    ax: float,
    ay: float,
    settled: float,
    start: float,
) -> tuple[float, float, float, float, float, float, float]:
    """Follow the sub-movement and add what is left of it in the direction of the hand."""
    accepted, new, dt = movement.follow(memory, AT, t, x, y, vx, vy, ax, ay, start)
    if not accepted:
        return REFUSED
    if new:
        memory[VX : SQUARE + 1] = 0.0
    if new or t == memory[AT + movement.T0]:
        submovement.begin(memory, UNIT, x, y)
    speed = hypot(vx, vy)
    submovement.follow(memory, UNIT, memory[RISE], x, y, speed)
    phase = movement.phase(memory, AT, vx, vy)
    px_m = gain(memory, dt, x - memory[AT + movement.X0], y - memory[AT + movement.Y0], vx, vy)
    rate = decay(memory, px_m, x, y, vx, vy, ax, ay) if px_m > 0.0 and speed > movement.STILL_M_S else 0.0
    ahead_s = 1.0 / rate if rate > 0.0 else 0.0
    return x + ahead_s * px_m * vx, y + ahead_s * px_m * vy, NONE, NONE, NONE, NONE, phase


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        r = rows[i]
        answer = step(memory, r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8])
        out[i, 0] = r[0]
        for j in range(len(answer)):
            out[i, j + 1] = answer[j]


class SwitchedDirectionPredictor(Predictor):
    """Switched predictor along the direction of movement, one sub-movement after the other.

    The thesis's physics, otherwise arranged. Assumes that a sub-movement rises from rest or from a valley of
    the speed to a peak with half its way done, and then approaches its end T as V = k (T - x). At the switch
    doubling is right, T = 2x, so the rate k there is the peak's speed over the way done. After it two
    more signs of k are at hand: the regression of speed on place since the peak, and the deceleration.

    With v the speed, v_p its peak, s the way done at the peak, l the way since, all of this sub-movement, in
    px: k = q v_p^a / (s^a typical_s^(1-a)) + (1 - q) watched (v_p - v) / l + braking max(0, -v'/v), where
    a = ``own`` and q = (v / v_p)^turn; endpoint = cursor + velocity / k. With a = 1 no time and no length is
    built in. As v goes to 0, q k stays above v^turn, so the way left goes to 0 with the speed: the
    corrective phase converges, and a still cursor has arrived.

    A sub-movement begins where the speed rises out of a valley by ``rise`` of the peak before. Each sees only
    itself: a correction that is yet to come is not foretold, and before the peak too little is said. The
    hand's velocity becomes the cursor's by the averaged gain, least squares of the cursor's
    displacement on the hand's.

    Parameters: ``rise`` (share of the peak speed), ``typical_s`` s, ``own``, ``turn``, ``watched``, ``braking``
    (no unit). Always answers, at first with the cursor. Memory: 29 floats. Claims no region and no time of
    arrival: an exponential never arrives. Raises ParameterError, and EventError from ``update``.

    Reference: Khalin 2022, sections 2.4.2, 2.4.3 and 2.5.6, changed as docs/switched.md tells.

    >>> from math import exp
    >>> from pointpred import Motion
    >>> predictor = SwitchedDirectionPredictor(own=1.0, watched=1.0, braking=0.0)
    >>> for i in range(4):  # 10 px a mm; the speed peaks at 0.1 s, half way
    ...     motion = Motion(i / 20, 100.0 * i / 2, 0.0, 0.05 * i, 0.0, 0.0, 0.0, True, start=i == 0)
    ...     prediction = predictor.update(motion)
    >>> prediction.x > 150.0
    True
    """

    parameters = (
        Parameter(
            "rise", "share of peak speed", 0.0, 10.0, "a rise out of a valley by more is a sub-movement"
        ),
        Parameter("typical_s", "s", 1e-4, 10.0, "time constant of a typical approach at its peak"),
        Parameter("own", "", 0.0, 1.0, "share of the sub-movement's own time in its time constant"),
        Parameter("turn", "", 0.0, 1.0, "power of speed over peak speed that says how much the peak counts"),
        Parameter("watched", "", 0.0, 10.0, "weight of the rate seen since the peak"),
        Parameter("braking", "", 0.0, 10.0, "weight of the rate seen now"),
    )
    step = staticmethod(step)
    loop = staticmethod(loop)

    def __init__(
        self,
        *,
        rise: float = 0.35,
        typical_s: float = 0.05,
        own: float = 0.45,
        turn: float = 0.45,
        watched: float = 0.45,
        braking: float = 0.05,
    ) -> None:
        values = {
            "rise": rise,
            "typical_s": typical_s,
            "own": own,
            "turn": turn,
            "watched": watched,
            "braking": braking,
        }
        check(self.parameters, values)
        super().__init__([float(value) for value in values.values()], STATES)
