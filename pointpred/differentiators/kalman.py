"""The Kalman filter of a hand with nearly constant acceleration."""

from __future__ import annotations

from pointpred.compiled import law, layout
from pointpred.differentiators import constant_acceleration, sampling
from pointpred.differentiators.differentiator import Differentiator, loop_over_events
from pointpred.parameter import parameter
from pointpred.records import REFUSED, EventRow, FloatArray, TenFloats
from pointpred.stage import offsets

SETTLED_RADIANS = 4.0

# The parameters: those of sampling, the density in m^2/s^5, the noise in m^2. The state: that of sampling;
# position, velocity, acceleration of x, then of y; p00 p01 p02 p11 p12 p22, the same for both axes.
_, JERK_DENSITY, NOISE, AT, X, COVARIANCE, LENGTH = offsets(sampling.SETTINGS, 1, 1, sampling.STATES, 6, 6)


@layout
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The settings; of the noise in m its variance."""
    sampling.fill(values, memory)
    memory[NOISE] = values[NOISE] * values[NOISE]


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
    if verdict == sampling.REFUSED:
        return REFUSED
    if verdict == sampling.RESTARTED:
        constant_acceleration.restart(memory, X, memory[NOISE])
    elif verdict == sampling.MOVED:
        place = memory[AT + sampling.U], memory[AT + sampling.V]
        constant_acceleration.follow(memory, X, memory[JERK_DENSITY], memory[NOISE], dt, place)
    velocity = memory[X + 1], memory[X + 4]
    acceleration = memory[X + 2], memory[X + 5]
    settled = sampling.settled(memory, AT, 4.0, settle_s(memory))
    return sampling.motion(memory, AT, event, (velocity, acceleration), settled, start)


loop = loop_over_events(step)


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
    loop = staticmethod(loop)
    at = AT
    states = LENGTH - AT
    fill = staticmethod(fill)
