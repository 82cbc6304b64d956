"""The switched predictor of the thesis: doubling while the hand accelerates, DREM while it corrects."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, FloatArray, MotionRow, TenFloats, endpoint
from pointpred.regression import drem
from pointpred.stage import offsets

UNKNOWNS = 3  # theta = (1/b2, b1/b2, T)

# State of an axis, relative to its place: largest speed in m/s, displacement and endpoint in px; then DREM.
PEAK, PLACE, ENDPOINT, DREM, AXIS_STATES = offsets(1, 1, 1, drem.states(UNKNOWNS))
# The parameters; the movement; both axes.
THRESHOLD, BOUND, DELAY_S, GAMMA, AT, X_AXIS, Y_AXIS, END = offsets(
    1, 1, 1, 1, movement.State.length, AXIS_STATES, AXIS_STATES
)


@law
def advance(memory: FloatArray, axis: int, t: float, place: float, v: float, a: float) -> float:
    """One sample of one axis (figure 2.4); returns the endpoint in px from the movement's start.

    The regression remembers every phase, because its delayed copies reach back into the phase before; it
    learns, and has a say, in the corrective phase only.
    """
    moved = place - memory[axis + PLACE]
    memory[axis + PLACE] = place
    memory[axis + PEAK] = max(memory[axis + PEAK], abs(v))
    before = memory[axis + ENDPOINT]
    regression = axis + DREM
    memory[regression + drem.REGRESSOR] = -a
    memory[regression + drem.REGRESSOR + 1] = -v
    memory[regression + drem.REGRESSOR + 2] = 1.0
    if abs(v) < memory[THRESHOLD] * memory[axis + PEAK]:
        third = drem.estimates(regression, UNKNOWNS) + 2
        memory[third] = before
        solved = drem.advance(memory, regression, UNKNOWNS, memory[DELAY_S], memory[GAMMA], (t, place))
        if solved and abs(memory[third] - before) < memory[BOUND] * abs(place):
            memory[axis + ENDPOINT] = memory[third]
    else:
        drem.remember(memory, regression, UNKNOWNS, memory[DELAY_S], t, place)
        if a * v >= 0.0:
            memory[axis + ENDPOINT] = before + 2.0 * moved
    return float(memory[axis + ENDPOINT])


@law
def step(memory: FloatArray, motion: TenFloats) -> TenFloats:
    """Both axes, each in its own phase (Remark 2.5.1)."""
    m = MotionRow(*motion)
    fault, new, _ = movement.follow(movement.State(memory, AT), m)
    if fault != FINE:
        return movement.refuse(movement.State(memory, AT), m, fault)
    if new:
        memory[X_AXIS:] = 0.0
    x0, y0 = movement.State(memory, AT).x0, movement.State(memory, AT).y0
    since = m.t - movement.State(memory, AT).t0  # so that the clock's origin leaves no trace in the delays
    end_x = x0 + advance(memory, X_AXIS, since, m.x - x0, m.vx, m.ax)
    end_y = y0 + advance(memory, Y_AXIS, since, m.y - y0, m.vy, m.ay)
    return endpoint(m.t, end_x, end_y, movement.phase(movement.State(memory, AT), m))


class SwitchedPredictor(Predictor):
    """Switched ballistic and corrective endpoint predictor, one law for each axis.

    Assumes a reach whose first half mirrors its second, then a damped approach V' = -b1 V - b2 (x - T).
    While hand and acceleration agree (a V >= 0) the endpoint gains twice what the cursor moves; while the
    hand slows it holds; below ``threshold`` of the axis' largest speed the endpoint follows the regression
    x = -a/b2 - V b1/b2 + T by DREM, and a step is taken only if it is smaller than ``bound`` times the
    displacement. Good up to the speed peak; after it, it holds a wrong value while the cursor walks to the
    truth, and doubles the noise of the shorter axis.

    Parameters: ``threshold`` (share of the peak speed), ``bound`` (share of the displacement), ``delay_s``
    s between the delayed copies, ``gamma`` 1/s rate of the regression at full excitation.
    Always answers; claims no region. Memory: two rings of 132 samples, about 11 kB in all.
    Raises ParameterError, and EventError from ``update``.

    Reference: Khalin 2022, sections 2.4.2-2.5.6, equation (2.3), figure 2.4, with the corrections listed in
    docs/equations.md.

    >>> from pointpred import PointerEvent, build
    >>> pipeline = build("switched-printed")
    >>> for i in range(200):  # an accelerating hand: the endpoint is twice the way done
    ...     prediction = pipeline.update(PointerEvent(i / 1000, i * i / 100, 0.0))
    >>> round(prediction.x)
    792
    """

    threshold: float = parameter(
        "share of peak speed", 0.0, 10.0, "below it an axis is corrective; above 1: always", default=0.2
    )
    bound: float = parameter(
        "share of displacement", 0.0, 10.0, "largest step of the corrective estimate", default=0.1
    )
    delay_s: float = parameter("s", 1e-3, 1.0, "delay between the copies of the regression", default=0.1)
    gamma: float = parameter("1/s", 0.0, 1e9, "rate of the regression at full excitation", default=1e4)
    step = staticmethod(step)
    claims_time = False
    states = END - AT
