"""Systems written as expressions, driven by a generator; their steady state, printed or a power series.

A series is a ``sympy.Poly`` in the states of the generator; its coefficients are rational numbers, or
expressions in the parameters of the system.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from itertools import combinations_with_replacement
from typing import Any, Self

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.eigenvalues import number_text, unsettled
from pointpred_observers.numerics.matrices import instance, listed, wrong

ANALYTIC = frozenset(
    ("exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "atanh")
)
"""Functions of one argument that are analytic wherever they are finite."""
COINCIDENCE = 1e-9
"""Distance below which an eigenvalue and a sum of eigenvalues count as a resonance."""
SHORTENED_MOST = 400
"""Most operations in an expression that is simplified; a longer one stays as it is."""
HIGHEST_DEGREE = 15
"""Highest degree of a series; the number of terms sets this limit."""


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


class SymbolicGenerator:
    """The generator that drives a system: w' = s(w), (1.7).

    Assumption 1.3.1 needs it neutrally stable. Refused is what the linear part of s at 0 shows to be
    unstable, where it has numbers: an eigenvalue right of 0, or, for a linear s, a motion that grows with t.
    That motions return, so that none decays, is not checked.

    Parameters: ``states`` w as symbols, ``field`` s as expressions in them with s(0) = 0; floats are read as
    the decimals they print. Raises ParameterError.

    >>> import sympy as sp
    >>> w1, w2 = sp.symbols("w1 w2")
    >>> SymbolicGenerator((w1, w2), (w2, -w1)).matrix().tolist()
    [[0.0, 1.0], [-1.0, 0.0]]
    """

    def __init__(self, states: Sequence[Any], field: Sequence[Any]) -> None:
        self.states, self.field = _fields("generator", states, field)
        at_rest = dict.fromkeys(self.states, 0)
        for w, s in zip(self.states, self.field, strict=True):
            if (rest := symbolic().simplify(s.subs(at_rest))) != 0:
                raise ParameterError(f"{w}' must be zero at the origin, received {rest}")
        jacobian = symbolic().Matrix(self.field).jacobian(self.states)
        rest, linear = jacobian.subs(at_rest), not jacobian.free_symbols
        if rest.is_symbolic() or not all(one.is_finite for one in rest):
            return
        for value, motion in unsettled(np.array(rest.tolist(), np.float64)):
            if motion.endswith("grows") or (linear and motion.endswith("with t")):
                words = "a generator must be neutrally stable (Assumption 1.3.1): "
                raise ParameterError(words + motion.format(number_text(value)), field="field")

    def along(self, expression: Any) -> Any:
        """The derivative of a function of w along w' = s(w)."""
        pairs = zip(self.states, self.field, strict=True)
        return sum((symbolic().diff(expression, w) * s for w, s in pairs), symbolic().Integer(0))

    def matrix(self) -> FloatArray:
        """A of a linear generator w' = A w; raises ParameterError for a nonlinear one."""
        jacobian = symbolic().Matrix(self.field).jacobian(self.states)
        if jacobian.free_symbols:
            raise ParameterError(f"the generator must be linear with numbers, received {self.field}")
        return np.array(jacobian.tolist(), np.float64)


class SymbolicSystem:
    """A plant with one input: x' = F(x, z, u), z' = eta(z, x, u), y = h(z, x), (4.1).

    Parameters: ``states`` x and ``field`` F in the order of their triangular form; ``input`` u; ``zero`` z
    and ``zero_field`` eta, the zero dynamics, none by default; ``outputs`` h. Other symbols are parameters.
    Floats are read as the decimals they print. Raises ParameterError.
    """

    def __init__(
        self,
        states: Sequence[Any],
        field: Sequence[Any],
        input: Any,
        *,
        zero: Sequence[Any] = (),
        zero_field: Sequence[Any] = (),
        outputs: Sequence[Any] = (),
    ) -> None:
        self.states, self.field = _fields("system", states, field)
        self.zero, self.zero_field = _fields("zero dynamics", zero, zero_field)
        if not isinstance(input, symbolic().Symbol):
            raise wrong("input", "must be a symbol", input)
        self.input = input
        self.outputs = tuple(exact(h) for h in listed("outputs", outputs))
        named = (*self.states, *self.zero, self.input)
        if len(set(named)) != len(named):
            raise ParameterError(f"states, zero dynamics and input need different symbols, received {named}")

    def parameters(self) -> frozenset[Any]:
        """Symbols without value."""
        free = set().union(*(e.free_symbols for e in (*self.field, *self.zero_field, *self.outputs)))
        return frozenset(free - {*self.states, *self.zero, self.input})

    def with_values(self, values: Mapping[Any, Any]) -> Self:
        """The same system with numbers for some of its parameters."""
        numbers = {symbol: exact(value) for symbol, value in values.items()}
        if foreign := numbers.keys() - self.parameters():
            raise ParameterError(f"{sorted(map(str, foreign))} are no parameters of the system")
        parts = (self.field, self.zero_field, self.outputs)
        field, eta, h = ([e.subs(numbers) for e in part] for part in parts)
        return type(self)(self.states, field, self.input, zero=self.zero, zero_field=eta, outputs=h)

    def functions(self, given: Mapping[Any, Any]) -> dict[Any, Any]:
        """Maps as functions of the generator; raises ParameterError for one of the system's symbols."""
        found = {symbol: exact(e) for symbol, e in given.items()}
        for symbol, one in found.items():
            if foreign := one.free_symbols & {*self.states, *self.zero, self.input}:
                raise wrong(str(symbol), "must be a function of the generator", sorted(map(str, foreign)))
        return found

    def residuals(
        self, generator: SymbolicGenerator, values: Mapping[Any, Any], kept: Sequence[Any] = ()
    ) -> dict[Any, Any]:
        """Dpi s - F(pi, rho, l) of each state, simplified; 0 for those ``kept``, which hold by division."""
        rows = zip((*self.states, *self.zero), (*self.field, *self.zero_field), strict=True)
        return {
            x: symbolic().Integer(0)
            if x in kept
            else shortened(generator.along(values[x]) - row.subs(values, simultaneous=True))
            for x, row in rows
        }


class SymbolicSteadyState(msgspec.Struct, frozen=True):
    """x = pi(w), z = rho(w) and the input u = l(w) that keeps the system there.

    ``residuals`` are the differences Dpi s - F(pi, rho, l), of order ``degree`` + 1 at the origin; the steady
    state is ``exact`` where they vanish. ``free``: terms that may be added. The steady state need not
    attract; Propositions 4.3.1 and 4.3.2 do not prove that either.
    """

    system: SymbolicSystem
    generator: SymbolicGenerator
    maps: tuple[Any, ...]
    zero_maps: tuple[Any, ...]
    input: Any
    residuals: tuple[Any, ...]
    degree: int | None
    free: tuple[Free, ...] = ()

    @property
    def exact(self) -> bool:
        """Whether every equation holds identically."""
        return all(one == 0 for one in self.residuals)

    def outputs(self) -> tuple[Any, ...]:
        """h(rho(w), pi(w))."""
        symbols = (*self.system.states, *self.system.zero)
        values = dict(zip(symbols, (*self.maps, *self.zero_maps), strict=True))
        return tuple(symbolic().cancel(h.subs(values, simultaneous=True)) for h in self.system.outputs)

    def function(self) -> Callable[[Any], FloatArray]:
        """A numpy function of w, (q,) or (q, n): rows pi, rho and l."""
        wanted = (*self.maps, *self.zero_maps, self.input)
        if missing := set().union(*(e.free_symbols for e in wanted)) - {*self.generator.states}:
            raise ParameterError(f"parameters without value: {sorted(map(str, missing))}")
        plain = symbolic().lambdify(self.generator.states, wanted, modules=["scipy", "numpy"], cse=True)

        def evaluate(w: Any) -> FloatArray:
            columns = np.asarray(w, np.float64)
            rows = np.empty((len(wanted), *columns.shape[1:]))
            for i, row in enumerate(plain(*columns)):
                rows[i] = row
            return rows

        return evaluate


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
    maps, zero = listed("maps", maps), listed("zero", zero)
    if len(maps) != len(system.states) or len(zero) != len(system.zero):
        wanted = f"{len(system.states)} maps and {len(system.zero)} of the zero dynamics"
        raise ParameterError(f"needs {wanted}, received {len(maps)} and {len(zero)}", field="maps")
    degree = known_degree(degree)
    symbols = (*system.states, *system.zero, system.input)
    values = system.functions(dict(zip(symbols, (*maps, *zero, input), strict=True)))
    residuals, failed, w = system.residuals(generator, values), [], generator.states
    for state, left in residuals.items():
        if degree is None:
            shown = symbolic().factor_terms(symbolic().simplify(left)) if left != 0 else left
        else:
            series = {one: symbolic().Poly(one, *w) for one in w}
            shown = cut(composed(left, series, w, degree), degree).as_expr()
        if shown != 0:
            failed.append(f"{state}' leaves {shown}")
    if failed:
        raise CertificateError(f"the printed steady state fails: {'; '.join(failed)}", field="maps")
    left, n = tuple(residuals.values()), len(system.states)
    *found, ell = values.values()
    found_degree = degree if any(one != 0 for one in left) else None
    return SymbolicSteadyState(system, generator, tuple(found[:n]), tuple(found[n:]), ell, left, found_degree)


def known_degree(degree: Any) -> int | None:
    """The degree of a series, or ``None``; raises ParameterError."""
    if degree is not None and (not isinstance(degree, int) or not 1 <= degree <= HIGHEST_DEGREE):
        raise wrong("degree", f"must be a whole number in [1, {HIGHEST_DEGREE}]", degree)
    return degree


def _fields(name: str, states: Sequence[Any], field: Sequence[Any]) -> tuple[Any, Any]:
    states = tuple(listed(f"the states of the {name}", states))
    field = listed(f"the field of the {name}", field)
    for one in states:
        if not isinstance(one, symbolic().Symbol):
            raise wrong(name, "needs symbols as states", one)
    if len(set(states)) != len(states):
        raise wrong(name, "needs different symbols", states)
    if len(states) != len(field):
        raise wrong(name, f"needs an equation a state: {len(states)}", len(field))
    return states, tuple(exact(one) for one in field)
