"""Audits of printed steady states: whether pi, rho and u satisfy the equations of a symbolic system."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pointpred.errors import CertificateError, ParameterError
from pointpred_observers.matrices import instance, listed
from pointpred_observers.triangular.polynomials import composed, cut, exact, symbolic
from pointpred_observers.triangular.system import (
    HIGHEST_DEGREE,
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    vanishes,
)


def check_steady_state(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    maps: Sequence[Any],
    input: Any,
    *,
    zero: Sequence[Any] = (),
    degree: int | None = None,
) -> SymbolicSteadyState:
    """The steady state x = pi(w), z = rho(w), u = l(w) that somebody printed, if every equation holds.

    Substitutes into Dpi s = F(pi, rho, l) and Drho s = eta(rho, pi, l); nothing is solved.

    Parameters: ``maps`` pi and ``zero`` rho in the order of the system's states, ``input`` l; ``degree`` up
    to which a truncated series has to hold, ``None`` for identically. Raises CertificateError naming each
    equation that fails and what it leaves; ParameterError for a wrong number of maps.

    Reference: Khalin 2022, (1.9), Propositions 4.3.1 and 4.3.2.

    >>> import sympy as sp
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2, x1 + u), u)
    >>> circle = SymbolicGenerator((w1, w2), (w2, -w1))
    >>> check_steady_state(plant, circle, (w1 / 2 - w2 / 2, w1), (-w1 + 3 * w2) / 2).exact
    True
    >>> check_steady_state(plant, circle, (w1 / 2 - w2 / 2, w1), -w1 / 2)
    Traceback (most recent call last):
    pointpred.errors.CertificateError: the printed steady state fails: x2' leaves 3*w2/2
    """
    instance("system", system, SymbolicSystem)
    instance("generator", generator, SymbolicGenerator)
    states, rows = (*system.states, *system.zero), (*system.field, *system.zero_field)
    given = tuple(exact(one) for one in (*listed("maps", maps), *listed("zero", zero)))
    if len(maps) != len(system.states) or len(zero) != len(system.zero):
        raise ParameterError(
            f"needs {len(system.states)} maps and {len(system.zero)} of the zero dynamics, "
            f"received {len(maps)} and {len(zero)}",
            field="maps",
        )
    if degree is not None and (not isinstance(degree, int) or not 1 <= degree <= HIGHEST_DEGREE):
        raise ParameterError(
            f"degree must be a whole number in [1, {HIGHEST_DEGREE}], received {degree!r}",
            field="degree",
            value=degree,
        )
    ell = exact(input)
    for name, one in zip((*states, system.input), (*given, ell), strict=True):
        if foreign := one.free_symbols & {*states, system.input}:
            raise ParameterError(
                f"{name} must be a function of the generator, received {sorted(map(str, foreign))}"
            )
    values = {**dict(zip(states, given, strict=True)), system.input: ell}
    left = []
    for one, row in zip(given, rows, strict=True):
        left.append(vanishes(generator.along(one) - row.subs(values, simultaneous=True))[1])
    failed = [
        f"{state}' leaves {shown}"
        for state, residual in zip(states, left, strict=True)
        if (shown := _remaining(residual, generator, degree)) != 0
    ]
    if failed:
        raise CertificateError(
            f"the printed steady state fails: {'; '.join(failed)}", field="maps", value=left
        )
    count = len(system.states)
    holds = all(residual == 0 for residual in left)
    return SymbolicSteadyState(
        system,
        generator,
        given[:count],
        given[count:],
        ell,
        tuple(left),
        holds,
        None if holds else degree,
        (),
    )


def _remaining(residual: Any, generator: SymbolicGenerator, degree: int | None) -> Any:
    """What is left of an equation, up to a degree if one is given."""
    sp = symbolic()
    if residual == 0 or degree is None:
        return residual if degree is not None or residual == 0 else sp.factor_terms(sp.simplify(residual))
    w = generator.states
    series = composed(residual, {one: sp.Poly(one, *w) for one in w}, w, degree)
    return cut(series, degree).as_expr()
