"""A constant-acceleration Kalman filter of the cursor, extrapolated over a fixed horizon."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.differentiators import kalman
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, ROUNDING_S, FloatArray, MotionRow, TenFloats, endpoint

PRIOR_SPEED = 100.0
"""Standard deviation (px/s) of the velocity before a movement's first sample."""
PRIOR_ACCELERATION = 1000.0
"""Standard deviation (px/s^2) of the acceleration before a movement's first sample."""


class Settings(Layout):
    """The parameters."""

    horizon_s: float
    jerk_density: float
    noise_px: float
    gap_s: float


class State(Layout):
    """The movement; what was expected at its last time, before the position came, relative to its start."""

    movement: movement.State
    expected: kalman.Plane


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def expect_rest(plane: kalman.Plane, noise: float, x: float, y: float) -> None:
    """Expect a cursor that rests at (x, y)."""
    clear(plane)
    plane.x[0], plane.y[0] = x, y
    plane.covariance.p00 = noise
    plane.covariance.p11 = PRIOR_SPEED**2
    plane.covariance.p22 = PRIOR_ACCELERATION**2


@law
def corrected(
    axis: FloatArray, p: kalman.Covariance, noise: float, measured: float
) -> tuple[float, float, float]:
    """Position, velocity and acceleration of one axis after its position was measured."""
    share = (measured - axis[0]) / (p.p00 + noise)
    return axis[0] + p.p00 * share, axis[1] + p.p01 * share, axis[2] + p.p02 * share


@law
def expect(plane: kalman.Plane, noise: float, jerk_density: float, dt: float, x: float, y: float) -> None:
    """Take the last position (x, y) in and expect the state ``dt`` later."""
    kalman.correct(plane.x, plane.covariance, noise, x)
    kalman.predict(plane.x, dt)
    kalman.correct(plane.y, plane.covariance, noise, y)
    kalman.predict(plane.y, dt)
    kalman.narrow(plane.covariance, noise)
    kalman.spread(plane.covariance, jerk_density, dt)


@law
def step(memory: Memory, motion: TenFloats) -> TenFloats:
    """One position through the filter of both axes, and its state carried over the horizon."""
    m = MotionRow(*motion)
    settings, s, plane = memory.settings, memory.state.movement, memory.state.expected
    last_x, last_y = s.x, s.y
    fault, new, dt = movement.follow(s, m)
    if fault != FINE:
        return movement.refuse(s, m, fault)
    noise = settings.noise_px**2
    if new or dt > settings.gap_s + ROUNDING_S:
        expect_rest(plane, noise, m.x - s.x0, m.y - s.y0)
    elif dt > 0.0:
        expect(plane, noise, settings.jerk_density, dt, last_x - s.x0, last_y - s.y0)
    px, vx_px, ax_px = corrected(plane.x, plane.covariance, noise, m.x - s.x0)
    py, vy_px, ay_px = corrected(plane.y, plane.covariance, noise, m.y - s.y0)
    h = settings.horizon_s
    return endpoint(
        m.t,
        s.x0 + px + h * (vx_px + 0.5 * h * ax_px),
        s.y0 + py + h * (vy_px + 0.5 * h * ay_px),
        movement.phase(s, m),
    )


class KalmanPredictor(Predictor):
    """Constant-acceleration Kalman filter of the cursor, carried over a fixed horizon.

    Assumes that the acceleration changes as a random walk (white jerk) and that positions carry independent
    noise. Like ``linear`` it predicts a position soon, not the endpoint: right while the movement brakes,
    useless far ahead, where the acceleration throws it past any target.

    State s = (p, v, a) of each axis in px relative to the movement's start, s' = F s with F = [[1, h, h^2/2],
    [0, 1, h], [0, 0, 1]], jerk noise of density q over h, position noise of variance noise_px^2; both axes
    share one covariance. Endpoint = p + v horizon + a horizon^2 / 2.

    It claims no region: its covariance would be that of the position at the horizon, not of the endpoint. Nor
    a time of arrival. The filter begins at rest at every start and after a longer gap than ``gap_s``. What is
    remembered is the expectation before the last position, so a second motion of the same time replaces it
    exactly. Always answers.

    Parameters: ``horizon_s`` s; ``cursor_jerk_density`` px^2/s^5; ``cursor_noise_px`` px; ``gap_s`` s, the
    differentiator's too. Memory: 25 floats. Raises ParameterError, and EventError from ``update``.

    Reference: Bar-Shalom, Li, Kirubarajan 2001, section 6.2 (white jerk); browsers predict pointer events at
    most 25 ms ahead in this way.

    >>> from pointpred import PointerEvent, build
    >>> pipeline = build("kalman", horizon_s=0.05)
    >>> for i in range(200):
    ...     prediction = pipeline.update(PointerEvent(i / 100, 5.0 * i, 0.0))
    >>> round(prediction.x, 3)  # 995 px, 500 px/s
    1020.0
    """

    horizon_s: float = parameter("s", 0.0, 1.0, "how far ahead the filter's state is carried", default=0.025)
    cursor_jerk_density: float = parameter(
        "px^2/s^5", 1.0, 1e18, "spectral density of the cursor's jerk", default=1e10
    )
    cursor_noise_px: float = parameter(
        "px", 1e-3, 1e3, "standard deviation of a cursor position", default=1.0
    )
    gap_s: float = parameter(
        "s", 1e-3, 1e3, "a longer gap between events means that the device was still", default=0.1
    )
    step = staticmethod(step)
    claims_time = False
    states = State.length
