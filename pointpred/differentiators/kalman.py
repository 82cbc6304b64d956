"""The Kalman filter of a hand with nearly constant acceleration, as compiled laws in a flat array.

Both axes share a covariance, because both are measured at the same times with the same noise. The
covariance lies at ``p`` as p00 p01 p02 p11 p12 p22, a state at ``x`` as position, velocity, acceleration.
"""

from __future__ import annotations

from pointpred.compiled import law, layout
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import Differentiator
from pointpred.parameter import parameter
from pointpred.records import EventRow, FloatArray, TenFloats, refused
from pointpred.stage import offsets

SETTLED_RADIANS = 4.0
START_SPEED_M_S = 0.3
START_ACCELERATION_M_S2 = 5.0
"""Standard deviations of what the hand may be doing at a restart."""
AXIS, PLANE = 3, 12
"""Floats of an axis; of two axes with their covariance behind them."""

# The parameters: those of sampling, the density in m^2/s^5, the noise in m^2. The state: that of sampling;
# position, velocity, acceleration of x, then of y; p00 p01 p02 p11 p12 p22, the same for both axes.
_, JERK_DENSITY, NOISE, AT, X, COVARIANCE, LENGTH = offsets(sampling.SETTINGS, 1, 1, sampling.STATES, 6, 6)


@layout
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The settings; of the noise in m its variance."""
    sampling.fill(values, memory)
    memory[NOISE] = values[NOISE] * values[NOISE]


@law
def predict(memory: FloatArray, x: int, dt: float) -> None:
    """One axis after ``dt`` s of constant acceleration."""
    memory[x] += dt * (memory[x + 1] + 0.5 * dt * memory[x + 2])
    memory[x + 1] += dt * memory[x + 2]


@law
def spread(memory: FloatArray, p: int, jerk_density: float, dt: float) -> None:
    """Covariance after ``dt`` s: P <- F P F' + Q, Q that of white jerk integrated exactly."""
    p00, p01, p02 = memory[p], memory[p + 1], memory[p + 2]
    p11, p12, p22 = memory[p + 3], memory[p + 4], memory[p + 5]
    half = 0.5 * dt * dt
    q = jerk_density * dt
    # F P, row by row, then times F'.
    f00, f01, f02 = p00 + dt * p01 + half * p02, p01 + dt * p11 + half * p12, p02 + dt * p12 + half * p22
    g11, g12 = p11 + dt * p12, p12 + dt * p22
    memory[p] = f00 + dt * f01 + half * f02 + q * dt**4 / 20.0
    memory[p + 1] = f01 + dt * f02 + q * dt**3 / 8.0
    memory[p + 2] = f02 + q * dt * dt / 6.0
    memory[p + 3] = g11 + dt * g12 + q * dt * dt / 3.0
    memory[p + 4] = g12 + q * dt / 2.0
    memory[p + 5] = p22 + q


@law
def correct(memory: FloatArray, x: int, p: int, noise: float, measured: float) -> None:
    """One axis after its position was measured with variance ``noise``; the covariance stays."""
    share = (measured - memory[x]) / (memory[p] + noise)
    memory[x] += memory[p] * share
    memory[x + 1] += memory[p + 1] * share
    memory[x + 2] += memory[p + 2] * share


@law
def narrow(memory: FloatArray, p: int, noise: float) -> None:
    """Covariance after a position was measured with variance ``noise``."""
    p00, p01, p02 = memory[p], memory[p + 1], memory[p + 2]
    total = p00 + noise
    # Rounding must not make a variance negative, whatever the parameters.
    memory[p + 3] = max(memory[p + 3] - p01 * p01 / total, 0.0)
    memory[p + 4] -= p01 * p02 / total
    memory[p + 5] = max(memory[p + 5] - p02 * p02 / total, 0.0)
    memory[p], memory[p + 1], memory[p + 2] = p00 * noise / total, p01 * noise / total, p02 * noise / total


@law
def restart(memory: FloatArray, x: int, noise: float) -> None:
    """Both axes at the origin of the path, at a speed that nobody knows."""
    memory[x : x + PLANE] = 0.0
    p = x + 2 * AXIS
    memory[p] = noise
    memory[p + 3] = START_SPEED_M_S**2
    memory[p + 5] = START_ACCELERATION_M_S2**2


@law
def follow(
    memory: FloatArray, x: int, jerk_density: float, noise: float, dt: float, place: tuple[float, float]
) -> None:
    """Both axes and their covariance after ``dt`` s, and after their positions were measured."""
    u, v = place
    p = x + 2 * AXIS
    predict(memory, x, dt)
    predict(memory, x + AXIS, dt)
    spread(memory, p, jerk_density, dt)
    correct(memory, x, p, noise, u)
    correct(memory, x + AXIS, p, noise, v)
    narrow(memory, p, noise)


@law
def settle_s(memory: FloatArray) -> float:
    """Time that the stationary filter takes at the mean rate so far: 4 / (q / (r T))^(1/6)."""
    intervals = max(memory[AT + sampling.SAMPLES] - 1.0, 1.0)
    period = (memory[AT + sampling.T] - memory[AT + sampling.SINCE]) / intervals
    return float(SETTLED_RADIANS * (memory[NOISE] * period / memory[JERK_DENSITY]) ** (1.0 / 6.0))


@law
def step(memory: FloatArray, event: EventRow) -> TenFloats:
    """One event through the filter of both axes."""
    verdict, dt, _, _, start = sampling.accept(memory, AT, event)
    if verdict < 0:
        return refused(-verdict, memory[AT + sampling.T])
    if verdict == sampling.RESTARTED:
        restart(memory, X, memory[NOISE])
    elif verdict == sampling.MOVED:
        place = memory[AT + sampling.U], memory[AT + sampling.V]
        follow(memory, X, memory[JERK_DENSITY], memory[NOISE], dt, place)
    velocity = memory[X + 1], memory[X + 4]
    acceleration = memory[X + 2], memory[X + 5]
    settled = sampling.settled(memory, AT, 4.0, settle_s(memory))
    return sampling.motion(memory, AT, event, (velocity, acceleration), settled, start)


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
    at = AT
    states = LENGTH - AT
    fill = staticmethod(fill)
