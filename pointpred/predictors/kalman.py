"""A constant-acceleration Kalman filter of the cursor, extrapolated over a fixed horizon."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.differentiators import kalman
from pointpred.parameter import parameter
from pointpred.predictors import movement
from pointpred.predictors.predictor import Predictor
from pointpred.records import FINE, ROUNDING_S, FloatArray, MotionRow, TenFloats, endpoint
from pointpred.stage import offsets

PRIOR_SPEED = 100.0
"""Standard deviation (px/s) of the velocity before a movement's first sample."""
PRIOR_ACCELERATION = 1000.0
"""Standard deviation (px/s^2) of the acceleration before a movement's first sample."""

# The parameters; the movement; what was expected at the last time, before its position came, relative to the
# movement's start: position, velocity, acceleration of x, of y, the covariance (pp pv pa vv va aa) of both.
HORIZON_S, JERK_DENSITY, NOISE_PX, GAP_S, AT, MEAN_X, MEAN_Y, SPREAD, END = offsets(
    1, 1, 1, 1, movement.State.length, 3, 3, 6
)


@law
def expect_rest(memory: FloatArray, x: float, y: float) -> None:
    """Expect a cursor that rests at (x, y)."""
    memory[MEAN_X:END] = 0.0
    memory[MEAN_X], memory[MEAN_Y] = x, y
    memory[SPREAD] = memory[NOISE_PX] ** 2
    memory[SPREAD + 3] = PRIOR_SPEED**2
    memory[SPREAD + 5] = PRIOR_ACCELERATION**2


@law
def correct(memory: FloatArray, mean: int, measured: float) -> tuple[float, float, float]:
    """Position, velocity and acceleration of one axis after its position was measured."""
    total = memory[SPREAD] + memory[NOISE_PX] ** 2
    share = (measured - memory[mean]) / total
    return (
        memory[mean] + memory[SPREAD] * share,
        memory[mean + 1] + memory[SPREAD + 1] * share,
        memory[mean + 2] + memory[SPREAD + 2] * share,
    )


@law
def expect(memory: FloatArray, dt: float, x: float, y: float) -> None:
    """Take the last position (x, y) in and expect the state ``dt`` later."""
    noise = memory[NOISE_PX] ** 2
    plane = kalman.Plane(memory, MEAN_X)
    kalman.correct(plane.x, plane.covariance, noise, x)
    kalman.predict(plane.x, dt)
    kalman.correct(plane.y, plane.covariance, noise, y)
    kalman.predict(plane.y, dt)
    kalman.narrow(plane.covariance, noise)
    kalman.spread(plane.covariance, memory[JERK_DENSITY], dt)


@law
def step(memory: FloatArray, motion: TenFloats) -> TenFloats:
    """One position through the filter of both axes, and its state carried over the horizon."""
    m = MotionRow(*motion)
    last_x, last_y = movement.State(memory, AT).x, movement.State(memory, AT).y
    fault, new, dt = movement.follow(movement.State(memory, AT), m)
    if fault != FINE:
        return movement.refuse(movement.State(memory, AT), m, fault)
    x0, y0 = movement.State(memory, AT).x0, movement.State(memory, AT).y0
    if new or dt > memory[GAP_S] + ROUNDING_S:
        expect_rest(memory, m.x - x0, m.y - y0)
    elif dt > 0.0:
        expect(memory, dt, last_x - x0, last_y - y0)
    h = memory[HORIZON_S]
    px, vx_px, ax_px = correct(memory, MEAN_X, m.x - x0)
    py, vy_px, ay_px = correct(memory, MEAN_Y, m.y - y0)
    return endpoint(
        m.t,
        x0 + px + h * (vx_px + 0.5 * h * ax_px),
        y0 + py + h * (vy_px + 0.5 * h * ay_px),
        movement.phase(movement.State(memory, AT), m),
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
    states = END - AT
