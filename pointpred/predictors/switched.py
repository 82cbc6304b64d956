"""The switched predictor of the thesis: doubling while the hand accelerates, DREM while it corrects."""

from __future__ import annotations

from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, FloatArray, MotionRow, TenFloats, endpoint
from pointpred.regression import drem

UNKNOWNS, T = 3, 2
"""theta = (1/b2, b1/b2, T); where T is in it."""


class Settings(Layout):
    """The parameters."""

    threshold: float
    bound: float
    delay_s: float
    gamma: float


class Axis(Layout):
    """One axis of the movement."""

    peak: float
    """The largest speed so far, m/s."""
    x: float
    """The displacement, px."""
    endpoint: float
    """The estimate of T, px from the movement's start."""
    regression: drem.State
    numbers: Annotated[FloatArray, drem.numbers(UNKNOWNS)]


class State(Layout):
    """What is remembered of the movement."""

    movement: movement.State
    x: Axis
    y: Axis


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def advance(settings: Settings, axis: Axis, t: float, x: float, v: float, a: float) -> float:
    """One sample of one axis (figure 2.4); returns the endpoint in px from the movement's start.

    The regression remembers every phase, because its delayed copies reach back into the phase before; it
    learns, and has a say, in the corrective phase only.
    """
    dx, before = x - axis.x, axis.endpoint
    axis.x = x
    axis.peak = max(axis.peak, abs(v))
    regression = drem.parts(axis.numbers, UNKNOWNS)
    w, theta = regression.w, regression.theta
    w[0], w[1], w[2] = -a, -v, 1.0
    if abs(v) < settings.threshold * axis.peak:
        theta[T] = before
        solved = drem.advance(axis.regression, regression, settings.delay_s, settings.gamma, t, x)
        if solved and abs(theta[T] - before) < settings.bound * abs(x):
            axis.endpoint = theta[T]
    else:
        drem.remember(axis.regression, regression, settings.delay_s, t, x)
        if a * v >= 0.0:
            axis.endpoint = before + 2.0 * dx
    return axis.endpoint


@law
def step(memory: Memory, motion: TenFloats) -> TenFloats:
    """Both axes, each in its own phase (Remark 2.5.1)."""
    m = MotionRow(*motion)
    settings, s, x, y = memory.settings, memory.state.movement, memory.state.x, memory.state.y
    fault, new, _ = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    if new:
        clear(x)
        clear(y)
    since = m.t - s.t0  # so that the clock's origin leaves no trace in the delays
    end_x = s.x0 + advance(settings, x, since, m.x - s.x0, m.vx, m.ax)
    end_y = s.y0 + advance(settings, y, since, m.y - s.y0, m.vy, m.ay)
    return endpoint(m.t, end_x, end_y, movement.phase(s, m))


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
    states = State.length
