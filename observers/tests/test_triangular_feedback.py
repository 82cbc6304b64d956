"""Proposition 4.3.1 on random systems, and what a system of another form gets."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers.triangular.forms import interlaced
from pointpred_observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem

sp = pytest.importorskip("sympy")
W1, W2, U = sp.symbols("w1 w2 u")
X = sp.symbols("x1:5")


def feedback(system: Any, generator: Any, first: Any, **more: Any) -> SymbolicSteadyState:
    return interlaced(system, generator, 0, first, **more)


OSCILLATOR = SymbolicGenerator((W1, W2), (W2, -W1))


def departure(steady: SymbolicSteadyState, start: np.ndarray, end_s: float = 1.0) -> float:
    """How far the plant leaves pi(w) within ``end_s`` when it starts on it: nothing of the solution is used
    but its value at the start and the input on the way."""
    system, generator = steady.system, steady.generator
    states = (*system.states, *system.zero)
    plant = sp.lambdify((*states, system.input), (*system.field, *system.zero_field))
    drive = sp.lambdify(generator.states, generator.field)
    at = steady.function()
    q = len(generator.states)

    def motion(_: float, y: np.ndarray) -> np.ndarray:
        return np.array([*drive(*y[:q]), *plant(*y[q:], at(y[:q])[-1])])

    answer = solve_ivp(
        motion, (0.0, end_s), [*start, *at(start)[:-1]], method="DOP853", rtol=3e-14, atol=1e-14
    )
    return float(np.abs(answer.y[q:] - at(answer.y[:q])[:-1]).max())


COEFFICIENT = st.fractions(min_value=-1, max_value=1, max_denominator=8)


@st.composite
def lower_triangular(draw: st.DrawFn) -> tuple[SymbolicSystem, Any]:
    """A system of 1 to 3 states; gains are 1/2 or more everywhere."""
    n = draw(st.integers(1, 3))
    xs, field = X[:n], []
    for i in range(n):
        seen = xs[: i + 1]
        drift = sum((draw(COEFFICIENT) * x for x in seen), sp.Integer(0))
        drift += draw(COEFFICIENT) * (sp.sin(seen[0]) if n == i + 1 < 3 else seen[-1] ** 2)
        gain = sp.Rational(1, 2) + abs(draw(COEFFICIENT)) * draw(st.sampled_from(seen)) ** 2
        field.append(drift + gain * (xs[i + 1] if i + 1 < n else U))
    first = draw(COEFFICIENT) * W1 + draw(COEFFICIENT) * W2 + draw(COEFFICIENT) * W1**2
    return SymbolicSystem(xs, field, U), first


@given(lower_triangular(), st.floats(-0.5, 0.5), st.floats(-0.5, 0.5))
@settings(max_examples=10)
def test_random_systems_stay_on_what_was_found(drawn: Any, w1: float, w2: float) -> None:
    system, first = drawn
    steady = feedback(system, OSCILLATOR, first)
    assert steady.maps[0] == sp.expand(first) or sp.simplify(steady.maps[0] - first) == 0
    assert departure(steady, np.array([w1, w2]), 0.5) < 1e-9


def test_zero_dynamics_follow_a_given_map_or_a_series() -> None:
    x, z = sp.symbols("x z")
    system = SymbolicSystem((x,), (z + x + U,), U, zero=(z,), zero_field=(-z + x,))
    given_map = feedback(system, OSCILLATOR, W1, zero=((W1 - W2) / 2,))
    series = feedback(system, OSCILLATOR, W1, degree=1)
    assert given_map.zero_maps == series.zero_maps == (W1 / 2 - W2 / 2,)
    assert given_map.exact
    assert given_map.degree is None
    assert series.exact
    assert departure(series, np.array([0.3, 0.4])) < 1e-9


def test_a_wrong_map_of_the_zero_dynamics_shows_in_the_residuals() -> None:
    x, z = sp.symbols("x z")
    system = SymbolicSystem((x,), (x + U,), U, zero=(z,), zero_field=(-z + x,))
    with pytest.raises(ParameterError, match=r"z' is not satisfied by z = w1: the residual is w2"):
        feedback(system, OSCILLATOR, W1, zero=(W1,))


@pytest.mark.parametrize(
    ("row", "place"),
    [
        (X[0] * U, "vanishes at w1 = 0, w2 = 0"),
        ((1 - 2 * X[0]) * U, "vanishes at w1 = 0.5, w2 = 0"),
        (U / X[0], "has no value at w1 = 0, w2 = 0"),
        (U * (X[0] - X[0]) + X[0], "vanishes everywhere"),
    ],
)
def test_a_vanishing_gain_names_its_row_and_the_place(row: Any, place: str) -> None:
    with pytest.raises(InfeasibleError, match=f"g of x1' {place}"):
        feedback(SymbolicSystem((X[0],), (row,), U), OSCILLATOR, W1)


def test_a_gain_may_vanish_outside_the_region() -> None:
    system = SymbolicSystem((X[0],), ((1 - 2 * X[0]) * U,), U)
    steady = feedback(system, OSCILLATOR, W1, region=[(-0.4, 0.4), (-0.4, 0.4)])
    assert sp.simplify(steady.input - W2 / (1 - 2 * W1)) == 0


@pytest.mark.parametrize(
    ("field", "message"),
    [
        ((X[1] ** 2, U), "x1' must be affine in x2"),
        ((X[2] + X[1], X[2], U), r"x1' may contain x2, .*, received \['x3'\]"),
        ((X[1] + U, U), r"x1' may contain x2, .*, received \['u'\]"),
    ],
)
def test_rows_of_another_form_are_named(field: Any, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        feedback(SymbolicSystem(X[: len(field)], field, U), OSCILLATOR, W1)


def test_what_is_no_system_is_refused() -> None:
    with pytest.raises(ParameterError, match="system needs an equation a state: 2, received 1"):
        SymbolicSystem(X[:2], (X[1],), U)
    with pytest.raises(ParameterError, match="needs symbols as states, received 'x'"):
        SymbolicSystem(("x",), (X[1],), U)
    with pytest.raises(ParameterError, match="system needs different symbols"):
        SymbolicSystem((X[0], X[0]), (X[0], X[0]), U)
    with pytest.raises(ParameterError, match="the input must be a symbol, received 'u'"):
        SymbolicSystem((X[0],), (X[0],), "u")
    with pytest.raises(ParameterError, match="input need different symbols"):
        SymbolicSystem((X[0],), (X[0],), X[0])
    with pytest.raises(ParameterError, match="w1' must be zero at the origin, received 1"):
        SymbolicGenerator((W1,), (1 + W1,))
    with pytest.raises(ParameterError, match="generator must be linear"):
        SymbolicGenerator((W1,), (W1**2,)).matrix()
    for field, grows in (
        ((W1 + W2, W2 - W1), "the eigenvalue 1[+-]1j grows"),
        ((W2, W1**3), None),  # the linear part alone proves nothing
        ((W2, 0 * W1), "the eigenvalue 0 is multiple, and a motion of it grows with t"),
    ):
        if grows is None:
            SymbolicGenerator((W1, W2), field)
            continue
        with pytest.raises(ParameterError, match=rf"neutrally stable \(Assumption 1\.3\.1\): .*{grows}"):
            SymbolicGenerator((W1, W2), field)
    for wrong in (sp.nan, sp.oo, sp.I, "3 +", [1], float("nan")):
        with pytest.raises(ParameterError, match=r"needs a(n| finite real) expression, received"):
            SymbolicSystem((X[0],), (wrong,), U)
    with pytest.raises(ParameterError, match="x1 must be a function of the generator, received"):
        feedback(SymbolicSystem(X[:2], (X[1], U), U), OSCILLATOR, X[1])


def test_parameters_get_their_values_later() -> None:
    k = sp.Symbol("k")
    system = SymbolicSystem((X[0],), (-k * X[0] + U,), U)
    steady = feedback(system, OSCILLATOR, W1)
    assert sp.expand(steady.input - k * W1 - W2) == 0
    with pytest.raises(ParameterError, match=r"parameters without value: \['k'\]"):
        steady.function()
    valued = feedback(system.with_values({k: 0.1}), OSCILLATOR, W1)
    assert valued.input == W1 / 10 + W2
    with pytest.raises(ParameterError, match="are no parameters of the system"):
        system.with_values({X[0]: 1})
