"""Systems written as expressions, driven by a generator, and their steady state."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Self

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.eigenvalues import number_text
from pointpred_observers.matrices import listed
from pointpred_observers.triangular.polynomials import exact, symbolic
from pointpred_observers.triangular.power_series import Free

BESIDE = 1e-5
"""An eigenvalue within this of another, or of the imaginary axis, relative to the matrix, counts as there."""
HIGHEST_DEGREE = 15
"""Highest degree of a series; the number of terms sets this limit."""
SHORTENED_MOST = 400
"""Most operations in an expression that is simplified; a longer one stays as it is."""


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
        rest = jacobian.subs(at_rest)
        if rest.is_symbolic() or not all(one.is_finite for one in rest):
            return
        self._require_neutral(np.array(rest.tolist(), np.float64), linear=not jacobian.free_symbols)

    def _require_neutral(self, a: FloatArray, *, linear: bool) -> None:
        """Raise ParameterError for a linear part with which w = 0 is not neutrally stable."""
        size = float(np.linalg.norm(a, 2)) or 1.0
        values = np.linalg.eigvals(a)
        for one in values:
            # A defective eigenvalue is computed to a root of its digits only.
            if one.real > BESIDE * size:
                raise ParameterError(
                    "a generator must be neutrally stable (Assumption 1.3.1): a motion of the eigenvalue "
                    f"{number_text(complex(one))} grows",
                    field="field",
                )
            if one.real < -BESIDE * size:
                continue
            pencil = (one * np.eye(len(a)) - a) / size
            alike = int((np.abs(values - one) <= BESIDE * size).sum())
            if linear and len(a) - np.linalg.matrix_rank(pencil, tol=BESIDE) < alike:
                raise ParameterError(
                    "a generator must be neutrally stable (Assumption 1.3.1): the eigenvalue "
                    f"{number_text(complex(one))} is multiple, and a motion of it grows with t",
                    field="field",
                )

    def along(self, expression: Any) -> Any:
        """The derivative of a function of w along w' = s(w)."""
        return sum(
            (symbolic().diff(expression, w) * s for w, s in zip(self.states, self.field, strict=True)),
            symbolic().Integer(0),
        )

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
            raise ParameterError(f"the input must be a symbol, received {input!r}")
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


class SymbolicSteadyState(msgspec.Struct, frozen=True):
    """x = pi(w), z = rho(w) and the input u = l(w) that keeps the system there.

    ``exact``: every equation Dpi s = F(pi, rho, l) holds identically; otherwise ``residuals`` hold the
    differences, of order ``degree`` + 1 at the origin. ``free``: terms that may be added. The steady state
    need not attract; Propositions 4.3.1 and 4.3.2 do not prove that either.
    """

    system: SymbolicSystem
    generator: SymbolicGenerator
    maps: tuple[Any, ...]
    zero_maps: tuple[Any, ...]
    input: Any
    residuals: tuple[Any, ...]
    exact: bool
    degree: int | None
    free: tuple[Free, ...]

    def outputs(self) -> tuple[Any, ...]:
        """h(rho(w), pi(w))."""
        symbols = (*self.system.states, *self.system.zero)
        values = dict(zip(symbols, (*self.maps, *self.zero_maps), strict=True))
        return tuple(symbolic().cancel(h.subs(values, simultaneous=True)) for h in self.system.outputs)

    def function(self) -> Callable[[Any], FloatArray]:
        """A plain numpy function of w: rows pi, rho and l; w of shape (q,) or (q, n)."""
        wanted = (*self.maps, *self.zero_maps, self.input)
        if missing := set().union(*(e.free_symbols for e in wanted)) - {*self.generator.states}:
            raise ParameterError(f"parameters without value: {sorted(map(str, missing))}")
        plain = symbolic().lambdify(self.generator.states, wanted, modules=["scipy", "numpy"], cse=True)

        def evaluate(w: Any) -> FloatArray:
            columns = np.asarray(w, np.float64)
            rows = [np.broadcast_to(row, columns.shape[1:]) for row in plain(*columns)]
            return np.array(rows, np.float64)

        return evaluate


def vanishes(expression: Any) -> tuple[bool, Any]:
    """Whether an expression simplifies to zero, and its simplified form."""
    sp = symbolic()
    if expression.is_polynomial(*expression.free_symbols):
        short = sp.expand(expression)
        return bool(short == 0), short
    rational = expression.is_rational_function(*expression.free_symbols)
    if sp.count_ops(expression) > (SHORTENED_MOST if rational else SHORTENED_MOST // 8):
        return bool(expression == 0), expression
    short = sp.cancel(expression)
    return bool(short == 0), short


def _fields(name: str, states: Sequence[Any], field: Sequence[Any]) -> tuple[Any, Any]:
    states, field = (
        tuple(listed(f"the states of the {name}", states)),
        listed(f"the field of the {name}", field),
    )
    for one in states:
        if not isinstance(one, symbolic().Symbol):
            raise ParameterError(f"{name} needs symbols as states, received {one!r}", field=name, value=one)
    if len(set(states)) != len(states):
        raise ParameterError(f"{name} needs different symbols, received {states}", field=name)
    if len(states) != len(field):
        raise ParameterError(
            f"{name} needs an equation a state: {len(states)}, received {len(field)}", field=name
        )
    return states, tuple(exact(one) for one in field)
