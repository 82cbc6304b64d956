"""Symbolic expressions, and steady states as power series: ``sympy.Poly`` in the states of the generator."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from itertools import combinations_with_replacement
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers.numerics.eigenvalues import number_text

ANALYTIC = frozenset(
    ("exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh")
)
"""Functions of one argument that are analytic wherever they are finite."""
COINCIDENCE = 1e-9
"""Distance below which an eigenvalue and a sum of eigenvalues count as a resonance."""
SHORTENED_MOST = 400
"""Most operations in an expression that is simplified; a longer one stays as it is."""


def symbolic() -> Any:
    """Import sympy, which takes a second, where it is first needed."""
    import sympy

    return sympy


def exact(expression: Any) -> Any:
    """An expression with every float as the decimal it prints."""
    sp = symbolic()
    try:
        e = sp.sympify(expression)
    except (sp.SympifyError, TypeError, AttributeError) as unusable:
        raise ParameterError(f"needs an expression, received {expression!r}") from unusable
    if not isinstance(e, sp.Expr) or e.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I):
        raise ParameterError(f"needs a finite real expression, received {expression!r}")
    return sp.nsimplify(e, rational=True) if e.has(sp.Float) else e


def shortened(expression: Any) -> Any:
    """The expression simplified: 0 where it is found to vanish everywhere."""
    sp = symbolic()
    if expression.is_polynomial(*expression.free_symbols):
        return sp.expand(expression)
    rational = expression.is_rational_function(*expression.free_symbols)
    if sp.count_ops(expression) > (SHORTENED_MOST if rational else SHORTENED_MOST // 8):
        return expression
    return sp.cancel(expression)


def cut(series: Any, degree: int) -> Any:
    """The terms up to a degree."""
    terms = {powers: c for powers, c in series.terms() if sum(powers) <= degree}
    return series.from_dict(terms or {(0,) * len(series.gens): 0}, *series.gens)


def composed(expression: Any, values: Mapping[Any, Any], over: Sequence[Any], degree: int) -> Any:
    """The power series, truncated at ``degree``, of an expression whose symbols are themselves series.

    Symbols that are not keys of ``values`` are constants. Raises ParameterError for what is not made of
    sums, products, powers and ``ANALYTIC`` functions, and at a singularity.
    """
    sp = symbolic()

    def expanded(e: Any) -> Any:
        if e in values:
            return cut(values[e], degree)
        if not e.free_symbols & values.keys():
            return sp.Poly(e, *over)
        if e.is_Add or e.is_Mul:
            total = expanded(e.args[0])
            for term in e.args[1:]:
                total = total + expanded(term) if e.is_Add else cut(total * expanded(term), degree)
            return total
        x = sp.Dummy("x")
        if e.is_Pow:
            if e.exp.is_Integer and e.exp >= 0:
                factors = [expanded(e.base)] * int(e.exp)
                return reduce(lambda total, base: cut(total * base, degree), factors, sp.Poly(1, *over))
            if e.exp.is_number:
                return _taylor(x**e.exp, x, expanded(e.base), degree)
            return _taylor(sp.exp(x), x, expanded(e.exp * sp.log(e.base)), degree)
        if len(e.args) == 1 and e.func.__name__ in ANALYTIC:
            return _taylor(e.func(x), x, expanded(e.args[0]), degree)
        raise ParameterError(f"{e} has no power series that is known here")

    return expanded(expression)


def _taylor(function: Any, x: Any, inner: Any, degree: int) -> Any:
    """A function of one variable of a series: its own Taylor series about the constant term, by Horner."""
    sp = symbolic()
    at = inner.nth(*(0,) * len(inner.gens))
    taylor, derivative = [], function
    for k in range(degree + 1):
        value = sp.simplify(derivative.subs(x, at))
        if value.has(sp.nan, sp.oo, -sp.oo, sp.zoo) or value.is_real is False:
            raise ParameterError(f"{function.subs(x, inner.as_expr())} is not analytic at the origin")
        taylor.append(value / sp.factorial(k))
        derivative = derivative.diff(x)
    without, total = inner - at, sp.Poly(taylor[-1], *inner.gens)
    for coefficient in reversed(taylor[:-1]):
        total = cut(total * without, degree) + coefficient
    return total


class Free(msgspec.Struct, frozen=True):
    """Terms that may be added to the series: at a solvable resonance the solution is not unique."""

    degree: int
    terms: dict[str, Any]


def power_series(
    unknowns: Sequence[Any],
    fields: Sequence[Any],
    inputs: Mapping[Any, Any],
    over: Sequence[Any],
    motion: Sequence[Any],
    degree: int,
) -> tuple[dict[Any, Any], list[Free]]:
    """The response x = pi(w) of x' = F(x, w) to w' = s(w) up to a degree, and its free terms, set to zero.

    The terms of degree k of Dpi(w) s(w) = F(pi(w), w) solve a linear equation in the linear parts A of F
    and S of s, singular where an eigenvalue of A is a sum of k of S: a resonance, which leaves terms free
    or has no solution. Assumes analytic F and s, zero at 0. Parameters without value are generic.

    Parameters: ``unknowns`` x and ``fields`` F, ``inputs`` other symbols of F as expressions in w, ``over``
    the states w and ``motion`` s. Raises ParameterError, and InfeasibleError at a resonance without
    solution.
    Reference: Carr 1981, section 1.4; Isidori 1995, section 8.3.
    """
    sp = symbolic()
    zero = sp.Poly(0, *over)
    states = {w: sp.Poly(w, *over) for w in over}
    values = {**states, **{s: composed(e, states, over, degree) for s, e in inputs.items()}}
    values |= dict.fromkeys(unknowns, zero)
    for x, field in zip(unknowns, fields, strict=True):
        if (rest := composed(field, values, over, 0).as_expr()) != 0:
            raise ParameterError(f"{x}' must be zero at the origin, received {rest}")
    slopes = [[composed(sp.diff(f, x), values, over, 0).as_expr() for x in unknowns] for f in fields]
    s = [composed(e, states, over, degree) for e in motion]
    turn = [cut(one, 1) for one in s]
    free: list[Free] = []
    for k in range(1, degree + 1):
        left = []
        for x, field in zip(unknowns, fields, strict=True):
            moved = sum((values[x].diff(w) * one for w, one in zip(over, s, strict=True)), zero)
            ahead = composed(field, values, over, k) - moved
            left.append(cut(ahead, k) - cut(ahead, k - 1))
        terms, open_terms = _of_degree(unknowns, slopes, turn, left, k)
        for x, term in zip(unknowns, terms, strict=True):
            values[x] += sp.Poly(term, *over)
        for one in open_terms:
            named = zip(unknowns, one, strict=True)
            free.append(Free(k, {str(x): term for x, term in named if term != 0}))
    return {x: values[x].as_expr() for x in unknowns}, free


def _of_degree(
    unknowns: Sequence[Any], slopes: Any, turn: Sequence[Any], left: Sequence[Any], k: int
) -> tuple[list[Any], list[list[Any]]]:
    """The terms of degree k of each unknown that balance what is ``left``, and a basis of free ones."""
    sp, over = symbolic(), turn[0].gens
    monomials = [sp.Mul(*chosen) for chosen in combinations_with_replacement(over, k)]
    names = [sp.symbols(f"c0:{len(monomials)}", cls=sp.Dummy) for _ in unknowns]
    guess = [sp.Poly(np.dot(row, monomials), *over) for row in names]
    equations, zero = [], sp.Poly(0, *over)
    for one, row, rest in zip(guess, slopes, left, strict=True):
        moved = sum((one.diff(w) * linear for w, linear in zip(over, turn, strict=True)), zero)
        equations += (rest + sum((a * g for a, g in zip(row, guess, strict=True)), zero) - moved).coeffs()
    symbols = [c for row in names for c in row]
    answers = list(sp.linsolve(equations, *symbols))
    if not answers:
        raise InfeasibleError(_resonance(unknowns, slopes, turn, left, k))
    known = dict(zip(symbols, answers[0], strict=True))
    solved = [one.as_expr().subs(known) for one in guess]
    chosen = [c for c in symbols if any(entry.has(c) for entry in answers[0])]
    basis = [[sp.expand(sp.diff(one, c)) for one in solved] for c in chosen]
    return [sp.cancel(one.subs(dict.fromkeys(chosen, 0))) for one in solved], basis


def _resonance(unknowns: Sequence[Any], slopes: Any, turn: Sequence[Any], left: Sequence[Any], k: int) -> str:
    """The error message if no series exists: the degree, the equations and the coinciding eigenvalues."""
    names = ", ".join(f"{x}'" for x, one in zip(unknowns, left, strict=True) if not one.is_zero)
    message = f"resonance at degree {k} in {names}: no power series satisfies the equation"
    try:
        own = np.linalg.eigvals(np.array(slopes, np.float64))
        linear = [[one.diff(w).nth(*(0,) * len(one.gens)) for w in one.gens] for one in turn]
        driving = np.linalg.eigvals(np.array(linear, np.float64))
    except TypeError:  # parameters without value
        return message
    for value in own.tolist():
        for chosen in combinations_with_replacement(driving.tolist(), k):
            if abs(sum(chosen) - value) < COINCIDENCE * max(1.0, float(np.abs(driving).max())):
                terms = " + ".join(f"({number_text(one)})" for one in chosen)
                return f"{message} (eigenvalue {number_text(value)} = {terms})"
    return message
