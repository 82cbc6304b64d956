"""The backward difference: the floor every differentiator is compared with."""

from __future__ import annotations

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.differentiators import sampling
from pointpred.differentiators.differentiator import REFUSED_ROW, Differentiator
from pointpred.stage import Parameter, check

SHORTEST_S = sampling.SETTINGS
AT = SHORTEST_S + 1  # sampling state
TIME = AT + sampling.STATES  # of the position differenced last
UX = TIME + 1  # that position
VX = UX + 2
AX = VX + 2
SPAN_S = AX + 2  # the time over which the last velocity was taken
STATES = sampling.STATES + 8


@law
def advance(memory: FloatArray, axis: int, u: float, dt: float) -> None:
    """Velocity over the last interval, acceleration between the middles of the last two."""
    velocity = (u - memory[UX + axis]) / dt
    if memory[SPAN_S] > 0.0:
        memory[AX + axis] = (velocity - memory[VX + axis]) / (0.5 * (dt + memory[SPAN_S]))
    memory[VX + axis] = velocity
    memory[UX + axis] = u


@law
def step(
    memory: FloatArray, t: float, x: float, y: float, dx: float, dy: float, buttons: float
) -> tuple[float, float, float, float, float, float, float, float, float, float]:
    """One event through the differences of both axes."""
    verdict, _, _, _, start = sampling.accept(memory, AT, t, x, y, dx, dy, buttons)
    if verdict == sampling.REFUSED:
        return REFUSED_ROW
    if verdict == sampling.RESTARTED:
        memory[TIME : SPAN_S + 1] = 0.0
        memory[TIME] = t
    dt = t - memory[TIME]
    if verdict == sampling.MOVED and dt >= memory[SHORTEST_S]:
        advance(memory, 0, memory[AT + sampling.U], dt)
        advance(memory, 1, memory[AT + sampling.V], dt)
        memory[TIME] = t
        memory[SPAN_S] = dt
    return (
        t,
        x,
        y,
        memory[VX],
        memory[VX + 1],
        memory[AX],
        memory[AX + 1],
        sampling.settled(memory, AT, 3.0, 2.0 * memory[SHORTEST_S]),
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

    parameters = (
        *sampling.PARAMETERS,
        Parameter("shortest_s", "s", 1e-6, 1e-1, "shortest interval differenced"),
    )
    step = staticmethod(step)
    loop = staticmethod(loop)
    at = AT

    def __init__(
        self,
        *,
        shortest_s: float = 1e-4,
        cpi: float | None = None,
        dpi: float = 96.0,
        gap_s: float = 0.1,
        pause_s: float = 0.3,
    ) -> None:
        check(self.parameters, {"shortest_s": shortest_s, **sampling.named(cpi, dpi, gap_s, pause_s)})
        super().__init__([*sampling.settings(cpi, dpi, gap_s, pause_s), float(shortest_s)], STATES)
