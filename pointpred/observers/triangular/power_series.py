"""The steady state of a system driven by a generator, as a power series found degree by degree.

The response x = pi(w) of x' = F(x, w) to w' = s(w) near the origin satisfies
Dpi(w) s(w) = F(pi(w), w). Its terms of degree k solve a linear equation whose matrix depends on the linear
parts A of F and S of s only: it is singular where an eigenvalue of A is a sum of k eigenvalues of S, which is
called a resonance.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations_with_replacement
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers.triangular.polynomials import composed, part, powers_of_degree, symbolic

COINCIDENCE = 1e-9
"""Distance below which an eigenvalue and a sum of eigenvalues count as a resonance."""


class Free(msgspec.Struct, frozen=True):
    """Terms that may be added to the series: at a solvable resonance the solution is not unique."""

    degree: int
    terms: dict[str, Any]


class PowerSeries(msgspec.Struct, frozen=True):
    """The steady state up to a degree, and its free terms (set to zero)."""

    terms: dict[Any, Any]
    free: tuple[Free, ...]


def power_series(
    unknowns: Sequence[Any],
    fields: Sequence[Any],
    inputs: Mapping[Any, Any],
    over: Sequence[Any],
    motion: Sequence[Any],
    degree: int,
) -> PowerSeries:
    """Solve Dpi s = F(pi, w) for the terms of degree 1 to ``degree``.

    Assumes analytic F and s with F(0, 0) = 0 and s(0) = 0. A resonance whose equation is still solvable
    leaves terms free: they are set to zero and returned. Parameters without value are treated as generic:
    resonances at particular values are not detected.

    Parameters: ``unknowns`` x and ``fields`` F, ``inputs`` other symbols of F as expressions in w, ``over``
    the states w of the generator and ``motion`` s. Raises ParameterError, and InfeasibleError at a resonance
    that has no solution. Reference: Carr 1981, section 1.4; Isidori 1995, section 8.3.

    >>> import sympy as sp
    >>> x, w = sp.symbols("x w")
    >>> power_series([x], [-x + w**2], {}, [w], [-w / 4], 2).terms[x]
    2*w**2
    """
    sp = symbolic()
    zero = sp.Poly(0, *over)
    states = {w: sp.Poly(w, *over) for w in over}
    values = {**states, **{s: composed(e, states, over, degree) for s, e in inputs.items()}}
    s = [composed(e, states, over, degree) for e in motion]
    series = dict.fromkeys(unknowns, zero)
    _check_origin(unknowns, fields, {**values, **series}, over)
    slopes = [
        [composed(sp.diff(f, x), {**values, **series}, over, 0).as_expr() for x in unknowns] for f in fields
    ]
    turn = [[_linear(one, j) for j in range(len(over))] for one in s]
    free: list[Free] = []
    for k in range(1, degree + 1):
        rest = []
        for x, field in zip(unknowns, fields, strict=True):
            moved = sum((series[x].diff(w) * one for w, one in zip(over, s, strict=True)), zero)
            rest.append(part(composed(field, {**values, **series}, over, k) - moved, k))
        terms, left = _degree(unknowns, slopes, turn, rest, k)
        for x, coefficients in zip(unknowns, terms, strict=True):
            if coefficients:
                series[x] = series[x] + sp.Poly.from_dict(coefficients, *over)
        for one in left:
            named = zip(unknowns, one, strict=True)
            free.append(Free(k, {str(x): _shown(c, over) for x, c in named if c}))
    return PowerSeries({x: series[x].as_expr() for x in unknowns}, tuple(free))


def _check_origin(
    unknowns: Sequence[Any], fields: Sequence[Any], values: Mapping[Any, Any], over: Any
) -> None:
    for x, field in zip(unknowns, fields, strict=True):
        rest = composed(field, values, over, 0).as_expr()
        if rest != 0:
            raise ParameterError(f"{x}' must be zero at the origin, received {rest}")


def _linear(series: Any, j: int) -> Any:
    return series.nth(*(int(i == j) for i in range(len(series.gens))))


def _shown(coefficients: Mapping[tuple[int, ...], Any], over: Sequence[Any]) -> Any:
    sp = symbolic()
    return sp.Poly.from_dict(dict(coefficients), *over).as_expr()


def _degree(
    unknowns: Sequence[Any], slopes: Any, turn: Any, rest: Sequence[Mapping[Any, Any]], k: int
) -> tuple[list[dict[Any, Any]], list[list[dict[Any, Any]]]]:
    """The terms of degree k, and a basis of the free terms."""
    sp = symbolic()
    monomials = powers_of_degree(len(turn), k)
    place = {(i, m): n for n, (i, m) in enumerate((i, m) for i in range(len(unknowns)) for m in monomials)}
    matrix = sp.zeros(len(place))
    for (i, m), column in place.items():
        for powers, c in _turned(m, turn).items():
            matrix[place[i, powers], column] += c
        for other in range(len(unknowns)):
            matrix[place[other, m], column] -= slopes[other][i]
    right = sp.Matrix([rest[i].get(m, 0) for i, m in place])
    symbols = sp.symbols(f"c0:{len(place)}", cls=sp.Dummy)
    answers = list(sp.linsolve((matrix, right), *symbols))
    if not answers:
        raise InfeasibleError(_resonance(unknowns, slopes, turn, rest, k))
    answer, at_zero = answers[0], dict.fromkeys(symbols, 0)
    open_symbols = [c for c in symbols if any(entry.has(c) for entry in answer)]

    def terms(entries: Sequence[Any]) -> list[dict[Any, Any]]:
        split: list[dict[Any, Any]] = [{} for _ in unknowns]
        for ((i, m), _), entry in zip(place.items(), entries, strict=True):
            if entry != 0:
                split[i][m] = sp.cancel(entry)
        return split

    basis = [terms([sp.diff(entry, c) for entry in answer]) for c in open_symbols]
    return terms([sp.sympify(entry).subs(at_zero) for entry in answer]), basis


def _turned(powers: tuple[int, ...], turn: Any) -> dict[tuple[int, ...], Any]:
    """The derivative of a monomial along w' = S w."""
    moved: dict[tuple[int, ...], Any] = {}
    for j, exponent in enumerate(powers):
        for other, slope in enumerate(turn[j]):
            if exponent and slope != 0:
                target = list(powers)
                target[j] -= 1
                target[other] += 1
                moved[tuple(target)] = moved.get(tuple(target), 0) + exponent * slope
    return moved


def _resonance(
    unknowns: Sequence[Any], slopes: Any, turn: Any, rest: Sequence[Mapping[Any, Any]], k: int
) -> str:
    """The error message if no series exists: the degree, the equations and the coinciding eigenvalues."""
    names = ", ".join(f"{x}'" for x, one in zip(unknowns, rest, strict=True) if one)
    message = f"resonance at degree {k} in {names}: no power series satisfies the equation"
    try:
        own = np.linalg.eigvals(np.array(slopes, np.float64))
        driving = np.linalg.eigvals(np.array(turn, np.float64))
    except TypeError:  # parameters without value
        return message
    places = []
    for value in own:
        for chosen in combinations_with_replacement(range(len(driving)), k):
            total = complex(sum(driving[i] for i in chosen))
            if abs(total - value) < COINCIDENCE * max(1.0, float(np.abs(driving).max())):
                terms = " + ".join(f"({_number(driving[i])})" for i in chosen)
                places.append(f"eigenvalue {_number(value)} = {terms}")
    return f"{message} ({places[0]})" if places else message


def _number(value: complex) -> str:
    return f"{value.real:.4g}" if value.imag == 0.0 else f"{complex(value):.4g}"
