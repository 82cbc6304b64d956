"""Steady states of systems in triangular form: feedback, feedforward, and one driven by the other.

Propositions 4.3.1 and 4.3.2, the second corrected, and the interlaced form (4.12), (4.13).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pointpred.errors import ParameterError
from pointpred_observers.matrices import instance
from pointpred_observers.triangular.order import Solving
from pointpred_observers.triangular.regions import Region
from pointpred_observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem


def feedback(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    first: Any,
    *,
    zero: Sequence[Any] | None = None,
    degree: int | None = None,
    region: Region = None,
) -> SymbolicSteadyState:
    """The input that makes the first state follow a chosen function of the generator, and the other states.

    Assumes xi_i' = f_i + g_i xi_(i+1) with f_i, g_i of xi_1 ... xi_i and z, the last row with the input in
    place of the next state. Does not prove attraction. f_i and g_i are taken from the rows.

    pi_(i+1) = (Dpi_i s - f_i) / g_i, l = (Dpi_n s - f_n) / g_n

    Parameters: ``first`` pi_1; ``zero`` rho if known, else the zero dynamics are solved as a power series up
    to ``degree``; ``region`` in which g_i must vanish nowhere, (low, high) of each state of the generator by
    symbol or in order, ``None`` the whole space. Raises ParameterError for a row of another form,
    InfeasibleError with the place where a g_i vanishes and at a resonance of the zero dynamics,
    UndecidedError if neither is shown.
    Reference: Khalin 2022, Proposition 4.3.1.

    >>> import sympy as sp
    >>> x3, x4, u, w1, w2 = sp.symbols("x3 x4 u w1 w2")
    >>> plant = SymbolicSystem((x3, x4), (-x3**3 + x4, -x4 + (1 + x3**2) * u), u)
    >>> steady = feedback(plant, SymbolicGenerator((w1, w2), (w2, -w1)), w1)
    >>> steady.maps, steady.input, steady.exact
    ((w1, w1**3 + w2), (w1**3 + 3*w1**2*w2 - w1 + w2)/(w1**2 + 1), True)
    """
    maps = {instance("system", system, SymbolicSystem).states[0]: first}
    return Solving(system, generator, maps, upper=0, zero=zero, degree=degree, region=region).solve()


def feedforward(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    input: Any,
    degree: int,
    *,
    zero: Sequence[Any] | None = None,
) -> SymbolicSteadyState:
    """The steady state under an input as a power series in the generator's states.

    Assumes zeta_i' = f_i(zeta_i) + g_i(zeta_(i+1) ... zeta_n, z, u), analytic and zero at the origin; the row
    of zeta_i may also mix zeta_i with what follows it. Accurate near the origin only, unless ``exact``.

    The series is the centre manifold, found degree by degree. The print solves a Cauchy problem with
    pi = 0 where w_q = 0 instead; its solution changes with each revolution of the generator and is not a
    steady state.

    Parameters: ``input`` l(w); ``degree`` of the series, 1 to 15; ``zero`` rho if known. Raises
    ParameterError for a row of another form, InfeasibleError at a resonance without solution, naming degree
    and equation. Reference: Khalin 2022, Proposition 4.3.2; Carr 1981, section 1.4.

    >>> import sympy as sp
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2**2 * u, -x2 + u), u)
    >>> steady = feedforward(plant, SymbolicGenerator((w1, w2), (w2, -w1)), w1, degree=3)
    >>> steady.maps[1], steady.maps[0].coeff(w1, 3), steady.exact
    (w1/2 - w2/2, 1/40, True)
    """
    maps = {instance("system", system, SymbolicSystem).input: input}
    upper = len(system.states)
    return Solving(system, generator, maps, upper=upper, zero=zero, degree=degree, region=None).solve()


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
    the upper part may also contain later states of the lower part if these can be solved without it (Example
    9). Exact if the series of the upper part are finite, else accurate near the origin.

    Parameters: as in ``feedback`` and ``feedforward``; ``upper`` mu, 0 to the number of states less one;
    ``first`` pi_(mu+1); ``degree`` is needed for a series. Raises as they do.
    Reference: Khalin 2022, section 4.4.

    >>> import sympy as sp
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2, x1 + u), u)
    >>> steady = interlaced(plant, SymbolicGenerator((w1, w2), (w2, -w1)), 1, w1, 1)
    >>> steady.maps, steady.input
    ((w1/2 - w2/2, w1), -w1/2 + 3*w2/2)
    """
    instance("system", system, SymbolicSystem)
    if not isinstance(upper, int) or not 0 <= upper < len(system.states):
        most = len(system.states) - 1
        raise ParameterError(
            f"upper must be a whole number in [0, {most}], received {upper!r}", field="upper", value=upper
        )
    maps = {system.states[upper]: first}
    return Solving(system, generator, maps, upper=upper, zero=zero, degree=degree, region=region).solve()
