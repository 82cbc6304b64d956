"""The Kalman filter of a hand with nearly constant acceleration."""

from __future__ import annotations

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.differentiators import constant_acceleration, sampling
from pointpred.differentiators.differentiator import REFUSED_ROW, Differentiator
from pointpred.stage import Parameter, check

START_SPEED_M_S = 0.3
START_ACCELERATION_M_S2 = 5.0
"""Standard deviations of what the hand may be doing at a restart."""
SETTLED_RADIANS = 4.0

JERK_DENSITY, NOISE = sampling.SETTINGS, sampling.SETTINGS + 1  # m^2/s^5, m^2
AT = NOISE + 1  # sampling state
X = AT + sampling.STATES  # position, velocity, acceleration of x, then of y
COVARIANCE = X + 6  # p00 p01 p02 p11 p12 p22, the same for both axes
STATES = sampling.STATES + 12


@law
def settle_s(memory: FloatArray) -> float:
    """Time that the stationary filter takes at the mean rate so far: 4 / (q / (r T))^(1/6)."""
    intervals = max(memory[AT + sampling.SEEN] - 1.0, 1.0)
    period = (memory[AT + sampling.T] - memory[AT + sampling.SINCE]) / intervals
    response_s: float = (memory[NOISE] * period / memory[JERK_DENSITY]) ** (1.0 / 6.0)
    return SETTLED_RADIANS * response_s


@law
def step(
    memory: FloatArray, t: float, x: float, y: float, dx: float, dy: float, buttons: float
) -> tuple[float, float, float, float, float, float, float, float, float, float]:
    """One event through the filter of both axes."""
    verdict, dt, _, _, start = sampling.accept(memory, AT, t, x, y, dx, dy, buttons)
    if verdict == sampling.REFUSED:
        return REFUSED_ROW
    if verdict == sampling.RESTARTED:
        memory[X : COVARIANCE + 6] = 0.0
        memory[COVARIANCE] = memory[NOISE]
        memory[COVARIANCE + 3] = START_SPEED_M_S**2
        memory[COVARIANCE + 5] = START_ACCELERATION_M_S2**2
    elif verdict == sampling.MOVED:
        constant_acceleration.predict(memory, X, dt)
        constant_acceleration.predict(memory, X + 3, dt)
        constant_acceleration.spread(memory, COVARIANCE, memory[JERK_DENSITY], dt)
        constant_acceleration.correct(memory, X, COVARIANCE, memory[NOISE], memory[AT + sampling.U])
        constant_acceleration.correct(memory, X + 3, COVARIANCE, memory[NOISE], memory[AT + sampling.V])
        constant_acceleration.narrow(memory, COVARIANCE, memory[NOISE])
    return (
        t,
        x,
        y,
        memory[X + 1],
        memory[X + 4],
        memory[X + 2],
        memory[X + 5],
        sampling.settled(memory, AT, 4.0, settle_s(memory)),
        1.0 if start else 0.0,
        memory[AT + sampling.COUNTS],
    )


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        motion = step(memory, rows[i, 0], rows[i, 1], rows[i, 2], rows[i, 3], rows[i, 4], rows[i, 5])
        for j in range(len(motion)):
            out[i, j] = motion[j]


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

    parameters = (
        *sampling.PARAMETERS,
        Parameter("jerk_density", "m^2/s^5", 1e-3, 1e9, "spectral density of the jerk"),
        Parameter("noise_m", "m", 1e-8, 1e-1, "standard deviation of a measured position"),
    )
    step = staticmethod(step)
    loop = staticmethod(loop)
    at = AT

    def __init__(
        self,
        *,
        jerk_density: float = 30.0,
        noise_m: float = 1e-4,
        cpi: float | None = None,
        dpi: float = 96.0,
        gap_s: float = 0.1,
        pause_s: float = 0.3,
    ) -> None:
        own = {"jerk_density": jerk_density, "noise_m": noise_m}
        check(self.parameters, {**own, **sampling.named(cpi, dpi, gap_s, pause_s)})
        shared = sampling.settings(cpi, dpi, gap_s, pause_s)
        super().__init__([*shared, float(jerk_density), float(noise_m) ** 2], STATES)
