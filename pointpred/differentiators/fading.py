"""The fading-memory parabola: least squares with exponentially fading weights, by recursive moments."""

from __future__ import annotations

from math import exp

from pointpred.compiled import law
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import Differentiator, loop_over_events
from pointpred.parameter import parameter
from pointpred.records import REFUSED, EventRow, FloatArray, TenFloats
from pointpred.stage import offsets

UNDETERMINED = 1e-9
"""Share of a pivot's diagonal below which the samples do not determine the coefficient."""
LEAST_WEIGHT = 1e-30
"""Weights never fade further in one step, so that two samples far apart still give a line."""

# The parameters: those of sampling, the memory in s. The state: that of sampling; S0 ... S4, sums of w s^k
# with s = (t_i - t) / memory_s of each sample, not positive; R0 R1 R2 of x, then of y, sums of w s^k
# (u_i - u); velocity of x and y, acceleration of x and y.
_, MEMORY_S, AT, TIME, WAY, FIT, LENGTH = offsets(sampling.SETTINGS, 1, sampling.STATES, 5, 6, 4)


@law
def shift(memory: FloatArray, first: int, count: int, s: float, fade: float) -> None:
    """Moments of order 0 to ``count - 1`` seen from ``s`` later, their weights faded.

    Every term has the sign of the sum it enters when s_i <= 0, so nothing cancels.
    """
    for i in range(count - 1):
        for j in range(count - 1, i, -1):
            memory[first + j] -= s * memory[first + j - 1]
    for j in range(count):
        memory[first + j] *= fade


@law
def absorb(memory: FloatArray, s: float, moved_u: float, moved_v: float) -> None:
    """Move time's and both axes' origin to the newest sample, which thereby adds to S0 only."""
    fade = max(exp(-s), LEAST_WEIGHT)
    shift(memory, TIME, 5, s, fade)
    for axis in range(2):
        way = WAY + 3 * axis
        shift(memory, way, 3, s, fade)
        moved = moved_v if axis else moved_u
        for k in range(3):
            memory[way + k] -= moved * memory[TIME + k]
    memory[TIME] += 1.0


@law
def fit(memory: FloatArray) -> None:
    """Solve the normal equations of both axes: slope and curvature at the newest sample."""
    s0, s1, s2, s3, s4 = memory[TIME], memory[TIME + 1], memory[TIME + 2], memory[TIME + 3], memory[TIME + 4]
    l10, l20 = s1 / s0, s2 / s0
    d1 = s2 - l10 * s1
    if not d1 > UNDETERMINED * s2:
        return
    l21 = (s3 - l20 * s1) / d1
    d2 = s4 - l20 * s2 - l21 * l21 * d1
    curved = d2 > UNDETERMINED * s4
    unit = memory[MEMORY_S]
    for axis in range(2):
        way = WAY + 3 * axis
        r1 = memory[way + 1] - l10 * memory[way]
        r2 = memory[way + 2] - l20 * memory[way] - l21 * r1
        curvature = r2 / d2 if curved else 0.0
        memory[FIT + axis] = (r1 / d1 - l21 * curvature) / unit
        memory[FIT + 2 + axis] = 2.0 * curvature / (unit * unit)


@law
def step(memory: FloatArray, event: EventRow) -> TenFloats:
    """One event through the fits of both axes."""
    verdict, dt, before_u, before_v, start = sampling.accept(memory, AT, event)
    if verdict == sampling.REFUSED:
        return REFUSED
    if verdict == sampling.RESTARTED:
        memory[TIME : FIT + 4] = 0.0
        memory[TIME] = 1.0
    elif verdict == sampling.MOVED:
        moved_u, moved_v = memory[AT + sampling.U] - before_u, memory[AT + sampling.V] - before_v
        absorb(memory, dt / memory[MEMORY_S], moved_u, moved_v)
        fit(memory)
    velocity = memory[FIT], memory[FIT + 1]
    acceleration = memory[FIT + 2], memory[FIT + 3]
    settled = sampling.settled(memory, AT, 3.0, memory[MEMORY_S])
    return sampling.motion(memory, AT, event, (velocity, acceleration), settled, start)


loop = loop_over_events(step)


class FadingMemoryDifferentiator(Differentiator):
    """Parabola fitted to all samples since the restart, their weights fading exponentially, for each axis.

    Assumes a hand whose acceleration hardly changes within ``memory_s``; exact on parabolas however
    irregular the sampling. The newest sample is at the edge of the fit, where noise counts most: at equal
    smoothness a Kalman filter that knows the noise is quieter. A sample's weight does not depend on the
    interval before it, so a rate that changes changes the weighting.

    Minimises sum_i exp(-(t - t_i) / memory_s) (u_i - c0 - c1 (t_i - t) - c2 (t_i - t)^2)^2; velocity is c1,
    acceleration 2 c2. The moments are moved to the newest sample at each event, which cancels nothing.

    Parameters: ``memory_s`` s, [1e-3, 1], the time in which a weight falls to 1/e; ``cpi``, ``dpi``,
    ``gap_s``, ``pause_s`` as for all differentiators.
    Memory: 32 floats. Settled after 3 samples and ``memory_s``; two samples give a line, one gives rest.
    Returns a Motion from ``update``.
    Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Morrison 1969 (fading-memory polynomial filter), here for unequal intervals.

    >>> from pointpred import PointerEvent
    >>> differentiator = FadingMemoryDifferentiator(dpi=25.4)  # 1 px is 1 mm
    >>> for i in range(100):
    ...     t = i / 125
    ...     motion = differentiator.update(PointerEvent(t, 100 * t - 300 * t * t, 0.0))
    >>> round(motion.vx, 9), round(motion.ax, 9)  # m/s, m/s^2 at t = 0.792
    (-0.3752, -0.6)
    """

    memory_s: float = parameter(
        "s", 1e-3, 1.0, "time in which the weight of a sample falls to 1/e", default=0.01
    )
    step = staticmethod(step)
    loop = staticmethod(loop)
    at = AT
    states = LENGTH - AT
