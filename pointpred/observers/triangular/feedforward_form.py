"""The steady state of a system in feedforward (upper-triangular) form: Proposition 4.3.2, corrected."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pointpred.observers.triangular.order import Solving
from pointpred.observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem


def feedforward(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    input: Any,
    degree: int,
    *,
    zero: Sequence[Any] | None = None,
) -> SymbolicSteadyState:
    """The steady state under a given input as a power series in the generator's states.

    Assumes zeta_i' = f_i(zeta_i) + g_i(zeta_(i+1) ... zeta_n, z, u), analytic and zero at the origin; the row
    of zeta_i may also mix zeta_i with what follows it. Good near the origin only, unless ``exact``.

    The series is the centre manifold, found degree by degree. The print solves a Cauchy problem with
    pi = 0 where w_q = 0 instead; its solution takes another value after each turn of the generator and is no
    steady state.

    Parameters: ``input`` l(w); ``degree`` of the series, 1 to 15; ``zero`` rho where it is known. Raises
    ParameterError for a row of another form, InfeasibleError at a resonance without solution, naming degree
    and equation. Reference: Khalin 2022, Proposition 4.3.2; Carr 1981, section 1.4.

    >>> import sympy as sp
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2**2 * u, -x2 + u), u)
    >>> steady = feedforward(plant, SymbolicGenerator((w1, w2), (w2, -w1)), w1, degree=3)
    >>> steady.maps[1], steady.maps[0].coeff(w1, 3), steady.exact
    (w1/2 - w2/2, 1/40, True)
    """
    known = {system.input: input}
    upper = len(system.states)
    return Solving(system, generator, known, upper=upper, zero=zero, degree=degree, region=None).solve()
