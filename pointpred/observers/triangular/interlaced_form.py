"""The steady state of an interlaced system: an upper-triangular part driven by a lower-triangular one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pointpred.errors import ParameterError
from pointpred.observers.triangular.nonzero import Region
from pointpred.observers.triangular.order import Solving
from pointpred.observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem


def interlaced(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    upper: int,
    first: Any,
    degree: int | None = None,
    *,
    zero: Sequence[Any] | None = None,
    region: Region = None,
) -> SymbolicSteadyState:
    """The input and the steady state for which the first state of the lower part is a chosen function.

    Assumes the form (4.12), (4.13): the first ``upper`` states feed forward, the others feed back. Rows of
    the upper part may also contain later states of the lower part where these follow without it (Example 9).
    Exact where the series of the upper part end, else good near the origin.

    Parameters: as in ``feedback`` and ``feedforward``; ``upper`` mu, 0 to the number of states less one;
    ``first`` pi_(mu+1); ``degree`` is needed where a series is. Raises as they do.
    Reference: Khalin 2022, section 4.4.

    >>> import sympy as sp
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2, x1 + u), u)
    >>> steady = interlaced(plant, SymbolicGenerator((w1, w2), (w2, -w1)), 1, w1, 1)
    >>> steady.maps, steady.input
    ((w1/2 - w2/2, w1), -w1/2 + 3*w2/2)
    """
    if not isinstance(upper, int) or not 0 <= upper < len(system.states):
        most = len(system.states) - 1
        raise ParameterError(f"upper must be a whole number in [0, {most}], received {upper!r}")
    known = {system.states[upper]: first}
    return Solving(system, generator, known, upper=upper, zero=zero, degree=degree, region=region).solve()
