"""Power series of analytic expressions, truncated at a degree, with exact coefficients.

A series is a ``sympy.Poly`` in the states of the generator; its coefficients are rational numbers, or
expressions in the parameters of the system.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations_with_replacement
from typing import Any

from pointpred.errors import ParameterError

ANALYTIC = frozenset(
    ("exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh")
)
"""Functions of one argument that are analytic wherever they are finite."""


def symbolic() -> Any:
    """Import sympy, which takes a second, where it is first needed."""
    import sympy

    return sympy


def exact(expression: Any) -> Any:
    """An expression with every float as the decimal it prints.

    >>> exact(0.1) * 3
    3/10
    """
    sp = symbolic()
    try:
        e = sp.sympify(expression)
    except (sp.SympifyError, TypeError, AttributeError) as unusable:
        raise ParameterError(f"needs an expression, received {expression!r}") from unusable
    if not isinstance(e, sp.Expr) or e.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.I):
        raise ParameterError(f"needs a finite real expression, received {expression!r}")
    return sp.nsimplify(e, rational=True) if e.has(sp.Float) else e


def cut(series: Any, degree: int) -> Any:
    """The terms up to a degree."""
    terms = {powers: c for powers, c in series.terms() if sum(powers) <= degree}
    return series.from_dict(terms or {(0,) * len(series.gens): 0}, *series.gens)


def part(series: Any, degree: int) -> dict[tuple[int, ...], Any]:
    """The coefficients of one degree by their powers."""
    return {powers: c for powers, c in series.terms() if sum(powers) == degree and c != 0}


def powers_of_degree(count: int, degree: int) -> list[tuple[int, ...]]:
    """The exponents of every monomial of a degree.

    >>> powers_of_degree(2, 2)
    [(2, 0), (1, 1), (0, 2)]
    """
    chosen = combinations_with_replacement(range(count), degree)
    return [tuple(one.count(i) for i in range(count)) for one in chosen]


def composed(expression: Any, values: Mapping[Any, Any], over: Sequence[Any], degree: int) -> Any:
    """The power series, truncated at ``degree``, of an expression whose symbols are themselves series.

    Symbols that are not keys of ``values`` are constants. Functions of one argument out of ``ANALYTIC``,
    sums, products and powers are expanded; anything else raises ParameterError, and so does a singularity
    at the origin.

    >>> import sympy as sp
    >>> w = sp.Symbol("w")
    >>> composed(sp.exp(w) / (1 - w), {w: sp.Poly(w, w)}, (w,), 3).as_expr()
    8*w**3/3 + 5*w**2/2 + 2*w + 1
    """
    sp = symbolic()

    def walk(e: Any) -> Any:
        if e in values:
            return cut(values[e], degree)
        if not e.free_symbols & values.keys():
            return sp.Poly(e, *over)
        if e.is_Add or e.is_Mul:
            total = walk(e.args[0])
            for term in e.args[1:]:
                total = total + walk(term) if e.is_Add else cut(total * walk(term), degree)
            return total
        if e.is_Pow:
            return _power(e, walk, degree)
        if len(e.args) == 1 and e.func.__name__ in ANALYTIC:
            x = sp.Dummy("x")
            return _outer(e.func(x), x, walk(e.args[0]), degree)
        raise ParameterError(f"{e} has no power series that is known here")

    return walk(expression)


def _power(e: Any, walk: Any, degree: int) -> Any:
    sp = symbolic()
    if e.exp.is_Integer and e.exp >= 0:
        base, total = walk(e.base), walk(sp.Integer(1))
        for _ in range(int(e.exp)):
            total = cut(total * base, degree)
        return total
    x = sp.Dummy("x")
    if e.exp.is_number:
        return _outer(x**e.exp, x, walk(e.base), degree)
    return _outer(sp.exp(x), x, walk(e.exp * sp.log(e.base)), degree)


def _outer(function: Any, x: Any, inner: Any, degree: int) -> Any:
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
