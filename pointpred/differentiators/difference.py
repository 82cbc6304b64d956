"""The backward difference: the floor every differentiator is compared with."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import Differentiator
from pointpred.parameter import parameter
from pointpred.records import EventRow, FloatArray, TenFloats, refused
from pointpred.stage import offsets

# The parameters: those of sampling, the shortest interval. The state: that of sampling; time and position of
# the last difference; velocity, acceleration; the time over which that velocity was taken.
_, SHORTEST_S, AT, TIME, UX, VX, AX, SPAN_S, LENGTH = offsets(
    sampling.SETTINGS, 1, sampling.STATES, 1, 2, 2, 2, 1
)


@law
def advance(memory: FloatArray, axis: int, u: float, dt: float) -> None:
    """Velocity over the last interval, acceleration between the middles of the last two."""
    velocity = (u - memory[UX + axis]) / dt
    if memory[SPAN_S] > 0.0:
        memory[AX + axis] = (velocity - memory[VX + axis]) / (0.5 * (dt + memory[SPAN_S]))
    memory[VX + axis] = velocity
    memory[UX + axis] = u


@law
def step(memory: FloatArray, event: EventRow) -> TenFloats:
    """One event through the differences of both axes."""
    verdict, _, _, _, start = sampling.accept(memory, AT, event)
    if verdict < 0:
        return refused(-verdict, memory[AT + sampling.T])
    if verdict == sampling.RESTARTED:
        memory[TIME : SPAN_S + 1] = 0.0
        memory[TIME] = memory[AT + sampling.T]
    dt = memory[AT + sampling.T] - memory[TIME]
    if verdict == sampling.MOVED and dt >= memory[SHORTEST_S]:
        advance(memory, 0, memory[AT + sampling.U], dt)
        advance(memory, 1, memory[AT + sampling.V], dt)
        memory[TIME] = memory[AT + sampling.T]
        memory[SPAN_S] = dt
    velocity = memory[VX], memory[VX + 1]
    acceleration = memory[AX], memory[AX + 1]
    settled = sampling.settled(memory, AT, 3.0, 2.0 * memory[SHORTEST_S])
    return sampling.motion(memory, AT, event, (velocity, acceleration), settled, start)


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
    at = AT
    states = LENGTH - AT
