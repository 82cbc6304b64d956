"""The backward difference: the floor every differentiator is compared with."""

from __future__ import annotations

from typing import Annotated

from pointpred.compiled import law
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import Differentiator
from pointpred.layout import Layout, clear
from pointpred.parameter import parameter
from pointpred.records import EventRow, FloatArray, TenFloats, refused


class Settings(Layout):
    """The parameters."""

    sampling: sampling.Settings
    shortest_s: float


class Differences(Layout):
    """Time and position of the last difference; velocity, acceleration; the time over which it was taken."""

    t: float
    u: Annotated[FloatArray, 2]
    v: Annotated[FloatArray, 2]
    a: Annotated[FloatArray, 2]
    span_s: float


class State(Layout):
    """What is remembered of the samples."""

    sampling: sampling.State
    last: Differences


class Memory(Layout):
    """The settings, then the state."""

    settings: Settings
    state: State


@law
def advance(last: Differences, axis: int, u: float, dt: float) -> None:
    """Velocity over the last interval, acceleration between the middles of the last two."""
    velocity = (u - last.u[axis]) / dt
    if last.span_s > 0.0:
        last.a[axis] = (velocity - last.v[axis]) / (0.5 * (dt + last.span_s))
    last.v[axis] = velocity
    last.u[axis] = u


@law
def step(memory: Memory, event: EventRow) -> TenFloats:
    """One event through the differences of both axes."""
    settings, samples, last = memory.settings, memory.state.sampling, memory.state.last
    verdict, _, _, _, start = sampling.accept(settings.sampling, samples, event)
    if verdict < 0:
        return refused(-verdict, samples.t)
    if verdict == sampling.RESTARTED:
        clear(last)
        last.t = samples.t
    dt = samples.t - last.t
    if verdict == sampling.MOVED and dt >= settings.shortest_s:
        advance(last, 0, samples.u, dt)
        advance(last, 1, samples.v, dt)
        last.t = samples.t
        last.span_s = dt
    velocity = last.v[0], last.v[1]
    acceleration = last.a[0], last.a[1]
    settled = sampling.settled(samples, 3.0, 2.0 * settings.shortest_s)
    return sampling.motion(samples, event, (velocity, acceleration), settled, start)


class BackwardDifferentiator(Differentiator):
    """Backward differences of position and of velocity, one for each axis.

    Assumes nothing about the movement and smooths nothing: a count or pixel more or less becomes a velocity
    error of its length over the interval, and an acceleration error of that over the interval again. The
    velocity is half an interval late, the acceleration a whole one. Nothing is lost when reports come close
    together: the velocity's integral is the displacement.

    v_k = (u_k - u_(k-1)) / (t_k - t_(k-1)), a_k = (v_k - v_(k-1)) / ((t_k - t_(k-2)) / 2).

    Parameters: ``shortest_s`` s, [1e-6, 0.1], the shortest interval differenced: what comes sooner waits for
    the next event; ``cpi``, ``dpi``, ``gap_s``, ``pause_s`` as for all differentiators.
    Memory: 25 floats. Settled from the third sample. Returns a Motion from ``update``.
    Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: the second-order backward difference of any textbook, for unequal intervals.

    >>> from pointpred import PointerEvent
    >>> differentiator = BackwardDifferentiator(dpi=25.4)  # 1 px is 1 mm
    >>> for t, x in ((0.0, 0.0), (0.01, 1.0), (0.02, 4.0)):
    ...     motion = differentiator.update(PointerEvent(t, x, 0.0))
    >>> round(motion.vx, 9), round(motion.ax, 9)
    (0.3, 20.0)
    """

    shortest_s: float = parameter("s", 1e-6, 1e-1, "shortest interval differenced", default=1e-4)
    step = staticmethod(step)
    states = State.length
