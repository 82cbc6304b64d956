"""A reduced-order observer of a hand with nearly constant acceleration, as a differentiator."""

from __future__ import annotations

from math import cos, exp, sin, sqrt

from pointpred.compiled import law, layout
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import Differentiator, loop_over_events
from pointpred.parameter import parameter
from pointpred.records import REFUSED, EventRow, FloatArray, TenFloats
from pointpred.stage import offsets

SETTLED_RADIANS = 5.0

# The parameters: those of sampling, decay and frequency of the observer's error, the time it takes to settle.
# The state: that of sampling; velocity and acceleration of x, then of y.
_, DECAY, FREQUENCY, SETTLE_S, AT, X, LENGTH = offsets(sampling.SETTINGS, 1, 1, 1, sampling.STATES, 4)


@layout
def fill(values: FloatArray, memory: FloatArray) -> None:
    """The error's decay in 1/s and frequency in rad/s, of bandwidth and damping; the settling time in s."""
    sampling.fill(values, memory)
    bandwidth, damping = values[sampling.SETTINGS], values[sampling.SETTINGS + 1]
    memory[DECAY] = damping * bandwidth
    memory[FREQUENCY] = bandwidth * sqrt(max(1.0 - damping * damping, 0.0))
    memory[SETTLE_S] = SETTLED_RADIANS / memory[DECAY]


@law
def follow(memory: FloatArray, x: int, slope: float, dt: float) -> None:
    """One axis after ``dt`` s on a line of that slope: the error of (velocity, acceleration) decays exactly.

    On a line the velocity is the slope and the acceleration zero, which is a trajectory of the hand's
    model; the observer's error e' = S0 e with S0 = ((-2 d, 1), (-(d^2 + f^2), 0)) is solved in closed form.
    """
    d, f = memory[DECAY], memory[FREQUENCY]
    fade = exp(-d * dt)
    along, across = fade * cos(f * dt), fade * dt
    if f * dt > 1e-8:
        across = fade * sin(f * dt) / f
    velocity, acceleration = memory[x] - slope, memory[x + 1]
    memory[x] = slope + (along - d * across) * velocity + across * acceleration
    memory[x + 1] = (along + d * across) * acceleration - (d * d + f * f) * across * velocity


@law
def step(memory: FloatArray, event: EventRow) -> TenFloats:
    """One event through the observers of both axes."""
    verdict, dt, before_u, before_v, start = sampling.accept(memory, AT, event)
    if verdict == sampling.REFUSED:
        return REFUSED
    if verdict == sampling.RESTARTED:
        memory[X : X + 4] = 0.0
    elif verdict == sampling.MOVED:
        follow(memory, X, (memory[AT + sampling.U] - before_u) / dt, dt)
        follow(memory, X + 2, (memory[AT + sampling.V] - before_v) / dt, dt)
    velocity = memory[X], memory[X + 2]
    acceleration = memory[X + 1], memory[X + 3]
    settled = sampling.settled(memory, AT, 3.0, memory[SETTLE_S])
    return sampling.motion(memory, AT, event, (velocity, acceleration), settled, start)


loop = loop_over_events(step)


class ReducedOrderDifferentiator(Differentiator):
    """Reduced-order observer of velocity and acceleration, the position taken as measured, for each axis.

    Assumes a position without noise: what a sample is off goes straight into velocity (2 z w) and
    acceleration (w^2), where an observer that also estimates the position would smooth it. A changing
    acceleration is followed with a lag of some 2 z / w. Irregular sampling is exact for positions on a
    line between samples.

    For u' = v, v' = a, a' = 0, y = u, Proposition 3.3.1 with Pi = (0 1 0; 0 0 1) and Upsilon = (-2 z
    w, -w^2)' gives o' = S0 o + B y, S0 = (-2 z w, 1; -w^2, 0), and (v, a) = o - Upsilon y, whose error
    e' = S0 e has the poles s^2 + 2 z w s + w^2 = 0. The law carries e over each interval in closed
    form: o is not needed.

    Parameters: ``bandwidth`` w in rad/s, [1, 1e4]; ``damping`` z, [0.1, 1]; ``cpi``, ``dpi``, ``gap_s``,
    ``pause_s`` as for all differentiators.
    Memory: 23 floats. Settled after 3 samples and 5 / (z w) s. Returns a Motion from ``update``.
    Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, section 3.3.3, (3.28)-(3.32); Luenberger 1964.

    >>> from pointpred import PointerEvent
    >>> differentiator = ReducedOrderDifferentiator()
    >>> for i in range(300):
    ...     motion = differentiator.update(PointerEvent(i / 1000, 2.0 * i, 0.0))
    >>> round(motion.vx, 3)  # 2000 px/s at 96 dpi
    0.529
    """

    bandwidth: float = parameter(
        "rad/s", 1.0, 1e4, "distance of the observer's poles from the origin", default=60.0
    )
    damping: float = parameter("", 0.1, 1.0, "cosine of their angle from the negative real axis", default=0.5)
    step = staticmethod(step)
    loop = staticmethod(loop)
    at = AT
    states = LENGTH - AT
    fill = staticmethod(fill)
