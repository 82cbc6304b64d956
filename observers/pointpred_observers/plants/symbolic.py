"""Systems written as expressions, driven by a generator, and their steady state, also a printed one."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Self

import msgspec
import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.eigenvalues import number_text, unsettled
from pointpred_observers.numerics.matrices import instance, listed, wrong
from pointpred_observers.plants.polynomials import Free, composed, cut, exact, shortened, symbolic

HIGHEST_DEGREE = 15
"""Highest degree of a series; the number of terms sets this limit."""


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
        return type(self)(
            self.states,
            [e.subs(numbers) for e in self.field],
            self.input,
            zero=self.zero,
            zero_field=[e.subs(numbers) for e in self.zero_field],
            outputs=[e.subs(numbers) for e in self.outputs],
        )

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
