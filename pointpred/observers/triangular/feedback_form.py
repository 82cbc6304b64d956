"""The steady state of a system in feedback (lower-triangular) form: Proposition 4.3.1."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pointpred.observers.triangular.nonzero import Region
from pointpred.observers.triangular.order import Solving
from pointpred.observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem


def feedback(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    first: Any,
    *,
    zero: Sequence[Any] | None = None,
    degree: int | None = None,
    region: Region = None,
) -> SymbolicSteadyState:
    """The input that makes the first state follow a chosen function of the generator, and all states with it.

    Assumes xi_i' = f_i + g_i xi_(i+1) with f_i, g_i of xi_1 ... xi_i and z, the last row with the input in
    place of the next state. Says nothing about attraction. f_i and g_i are read off the rows.

    pi_(i+1) = (Dpi_i s - f_i) / g_i, l = (Dpi_n s - f_n) / g_n

    Parameters: ``first`` pi_1; ``zero`` rho where it is known, else the zero dynamics are solved as a power
    series up to ``degree``; ``region`` bounds of each state of the generator, in which g_i must vanish
    nowhere, ``None`` the whole space. Raises ParameterError for a row of another form, InfeasibleError with
    the place where a g_i vanishes and at a resonance of the zero dynamics, UndecidedError where neither is
    shown.
    Reference: Khalin 2022, Proposition 4.3.1.

    >>> import sympy as sp
    >>> x3, x4, u, w1, w2 = sp.symbols("x3 x4 u w1 w2")
    >>> plant = SymbolicSystem((x3, x4), (-x3**3 + x4, -x4 + (1 + x3**2) * u), u)
    >>> steady = feedback(plant, SymbolicGenerator((w1, w2), (w2, -w1)), w1)
    >>> steady.maps, steady.input, steady.exact
    ((w1, w1**3 + w2), (w1**3 + 3*w1**2*w2 - w1 + w2)/(w1**2 + 1), True)
    """
    known = {system.states[0]: first}
    return Solving(system, generator, known, upper=0, zero=zero, degree=degree, region=region).solve()
