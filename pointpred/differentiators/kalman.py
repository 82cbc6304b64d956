"""The Kalman filter of a hand with nearly constant acceleration.

Both axes share a covariance, because both are measured at the same times with the same noise.
"""

from __future__ import annotations

from typing import Annotated

from pointpred.compiled import law
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import Differentiator
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.records import EventRow, FloatArray, TenFloats, refused

SETTLED_RADIANS = 4.0
START_SPEED_M_S = 0.3
START_ACCELERATION_M_S2 = 5.0
"""Standard deviations of what the hand may be doing at a restart."""


class Covariance(Layout):
    """Of position, velocity and acceleration."""

    p00: float
    p01: float
    p02: float
    p11: float
    p12: float
    p22: float


class Plane(Layout):
    """Position, velocity and acceleration of x, then of y; the covariance of either."""

    x: Annotated[FloatArray, 3]
    y: Annotated[FloatArray, 3]
    covariance: Covariance


class Settings(Layout):
    """The parameters: the density in m^2/s^5, the noise as a variance in m^2."""

    sampling: sampling.Settings
    jerk_density: float
    noise: float


class State(Layout):
    """What is remembered of the samples."""

    sampling: sampling.State
    plane: Plane


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def fill(values: FloatArray, settings: Settings) -> None:
    """The settings; of the noise in m its variance."""
    sampling.fill(values, settings.memory)
    settings.noise = settings.noise * settings.noise


@law
def predict(axis: FloatArray, dt: float) -> None:
    """One axis after ``dt`` s of constant acceleration."""
    axis[0] += dt * (axis[1] + 0.5 * dt * axis[2])
    axis[1] += dt * axis[2]


@law
def spread(p: Covariance, jerk_density: float, dt: float) -> None:
    """Covariance after ``dt`` s: P <- F P F' + Q, Q that of white jerk integrated exactly."""
    half = 0.5 * dt * dt
    q = jerk_density * dt
    # F P, row by row, then times F'.
    f00 = p.p00 + dt * p.p01 + half * p.p02
    f01 = p.p01 + dt * p.p11 + half * p.p12
    f02 = p.p02 + dt * p.p12 + half * p.p22
    g11, g12 = p.p11 + dt * p.p12, p.p12 + dt * p.p22
    p.p00 = f00 + dt * f01 + half * f02 + q * dt**4 / 20.0
    p.p01 = f01 + dt * f02 + q * dt**3 / 8.0
    p.p02 = f02 + q * dt * dt / 6.0
    p.p11 = g11 + dt * g12 + q * dt * dt / 3.0
    p.p12 = g12 + q * dt / 2.0
    p.p22 = p.p22 + q


@law
def correct(axis: FloatArray, p: Covariance, noise: float, measured: float) -> None:
    """One axis after its position was measured with variance ``noise``; the covariance stays."""
    share = (measured - axis[0]) / (p.p00 + noise)
    axis[0] += p.p00 * share
    axis[1] += p.p01 * share
    axis[2] += p.p02 * share


@law
def narrow(p: Covariance, noise: float) -> None:
    """Covariance after a position was measured with variance ``noise``."""
    p00, p01, p02 = p.p00, p.p01, p.p02
    total = p00 + noise
    # Rounding must not make a variance negative, whatever the parameters.
    p.p11 = max(p.p11 - p01 * p01 / total, 0.0)
    p.p12 -= p01 * p02 / total
    p.p22 = max(p.p22 - p02 * p02 / total, 0.0)
    p.p00, p.p01, p.p02 = p00 * noise / total, p01 * noise / total, p02 * noise / total


@law
def restart(plane: Plane, noise: float) -> None:
    """Both axes at the origin of the path, at a speed that nobody knows."""
    clear(plane)
    plane.covariance.p00 = noise
    plane.covariance.p11 = START_SPEED_M_S**2
    plane.covariance.p22 = START_ACCELERATION_M_S2**2


@law
def follow(plane: Plane, jerk_density: float, noise: float, dt: float, place: tuple[float, float]) -> None:
    """Both axes and their covariance after ``dt`` s, and after their positions were measured."""
    u, v = place
    predict(plane.x, dt)
    predict(plane.y, dt)
    spread(plane.covariance, jerk_density, dt)
    correct(plane.x, plane.covariance, noise, u)
    correct(plane.y, plane.covariance, noise, v)
    narrow(plane.covariance, noise)


@law
def settle_s(settings: Settings, samples: sampling.State) -> float:
    """Time that the stationary filter takes at the mean rate so far: 4 / (q / (r T))^(1/6)."""
    intervals = max(samples.samples - 1.0, 1.0)
    period = (samples.t - samples.since) / intervals
    return float(SETTLED_RADIANS * (settings.noise * period / settings.jerk_density) ** (1.0 / 6.0))


@law
def step(memory: Memory, event: EventRow) -> TenFloats:
    """One event through the filter of both axes."""
    settings, samples, plane = memory.settings, memory.state.sampling, memory.state.plane
    verdict, dt, _, _, start = sampling.accept(settings.sampling, samples, event)
    if verdict < 0:
        return refused(-verdict, samples.t)
    if verdict == sampling.RESTARTED:
        restart(plane, settings.noise)
    elif verdict == sampling.MOVED:
        follow(plane, settings.jerk_density, settings.noise, dt, (samples.u, samples.v))
    velocity = plane.x[1], plane.y[1]
    acceleration = plane.x[2], plane.y[2]
    settled = sampling.settled(samples, 4.0, settle_s(settings, samples))
    return sampling.motion(samples, event, (velocity, acceleration), settled, start)


class KalmanDifferentiator(Differentiator):
    """Kalman filter whose acceleration is driven by white jerk, one for each axis.

    Assumes independent position errors of one size and a jerk without memory, so a reach is smoothed with the
    same stiffness at its start, where the jerk is largest, as at its peak. Irregular sampling is exact.
    Quantisation is not white noise: while the hand rests the estimate is better than its covariance says.

    With x = (u, u', u''): x <- F x, P <- F P F' + Q, K = P H' / (H P H' + r), x <- x + K (y - H x),
    F = exp(A dt), A the triple integrator, Q_ij = q dt^(5-i-j) / ((2-i)! (2-j)! (5-i-j)) for i, j = 0, 1, 2.
    The stationary filter has the poles of a third-order Butterworth filter at w = (q / (r T))^(1/6) rad/s.

    Parameters: ``jerk_density`` q in m^2/s^5, [1e-3, 1e9], the spectral density of the jerk;
    ``noise_m`` sqrt(r) in m, [1e-8, 1e-1], the standard deviation of a position: the
    default suits a cursor of 96 px per inch, 3e-5 suits counts at 2000 CPI; ``cpi``, ``dpi``, ``gap_s``,
    ``pause_s`` as for all differentiators.
    Memory: 30 floats. Settled after 4 samples and 4 / w s. Returns a Motion from ``update``.
    Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Bar-Shalom, Li, Kirubarajan 2001, section 6.2.3 (continuous Wiener process acceleration).

    >>> from pointpred import PointerEvent
    >>> differentiator = KalmanDifferentiator()
    >>> for i in range(300):
    ...     motion = differentiator.update(PointerEvent(i / 1000, 2.0 * i, 0.0))
    >>> round(motion.vx, 3)  # 2000 px/s at 96 dpi
    0.529
    """

    jerk_density: float = parameter("m^2/s^5", 1e-3, 1e9, "spectral density of the jerk", default=30.0)
    noise_m: float = parameter("m", 1e-8, 1e-1, "standard deviation of a measured position", default=1e-4)
    step = staticmethod(step)
    states = State.length
    fill = staticmethod(fill)
