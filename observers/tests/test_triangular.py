"""Propositions 4.3.1 and 4.3.2, the second corrected: random systems of both forms, and interlaced ones."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import solve_sylvester

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers import SymbolicGenerator, SymbolicSystem, interlaced
from pointpred_observers.examples import oscillator
from pointpred_observers.plants.symbolic import SymbolicSteadyState, composed
from pointpred_observers.triangular.forms import prove_nonzero

sp = pytest.importorskip("sympy")
W1, W2, U, Z, Z1, Z2, K = sp.symbols("w1 w2 u z z1 z2 k")
X1, X2, X3, X4 = X = sp.symbols("x1:5")
OSCILLATOR = oscillator()
PART = st.fractions(min_value=-1, max_value=1, max_denominator=6)
RATE = st.fractions(min_value=1, max_value=3, max_denominator=4)
PLACE = st.floats(-0.5, 0.5)


def plant(*field: Any, **more: Any) -> SymbolicSystem:
    return SymbolicSystem(X[: len(field)], field, U, **more)


def feedback(system: SymbolicSystem, first: Any = W1, **more: Any) -> SymbolicSteadyState:
    return interlaced(system, OSCILLATOR, 0, first, **more)


def feedforward(
    system: SymbolicSystem, degree: Any, push: Any = W1, generator: Any = OSCILLATOR, **more: Any
) -> SymbolicSteadyState:
    return interlaced(system, generator, len(system.states), push, degree, **more)


def moved(steady: SymbolicSteadyState, w: Any, x: Any, seconds: float) -> np.ndarray:
    """Generator and plant after some seconds: nothing of the solution is used but its input on the way."""
    system, generator, q = steady.system, steady.generator, len(w)
    rows = sp.lambdify((*system.states, *system.zero, U), (*system.field, *system.zero_field), modules="math")
    drive = sp.lambdify(generator.states, generator.field, modules="math")
    push = sp.lambdify(generator.states, steady.input, modules="math")

    def motion(_: float, y: np.ndarray) -> list[float]:
        at = y.tolist()
        return [*drive(*at[:q]), *rows(*at[q:], push(*at[:q]))]

    return solve_ivp(motion, (0, seconds), [*w, *x], method="DOP853", rtol=1e-13, atol=1e-15).y[:, -1]


def departure(steady: SymbolicSteadyState, w: Any, seconds: float = 0.5) -> float:
    """How far the plant leaves pi(w) when it starts on it."""
    at, q = steady.function(), len(w)
    end = moved(steady, w, at(w)[:-1], seconds)
    return float(np.abs(end[q:] - at(end[:q])[:-1]).max())


def settled(steady: SymbolicSteadyState, w: Any, seconds: float = 25.0) -> np.ndarray:
    """Where the plant is at w, started at rest long before."""
    drive, q = sp.lambdify(steady.generator.states, steady.generator.field, modules="math"), len(w)
    back = solve_ivp(
        lambda _, v: np.negative(drive(*v)), (0, seconds), w, method="DOP853", rtol=1e-13, atol=1e-15
    ).y[:, -1]
    return moved(steady, back, np.zeros(len(steady.maps) + len(steady.zero_maps)), seconds)[q:]


@st.composite
def lower(draw: st.DrawFn) -> SymbolicSteadyState:
    """A system of 1 to 3 states that feed back; gains are 1/2 or more everywhere."""
    n = draw(st.integers(1, 3))
    field = []
    for i in range(n):
        seen = X[: i + 1]
        drift = sum((draw(PART) * x for x in seen), sp.Integer(0))
        drift += draw(PART) * (sp.sin(seen[0]) if n == i + 1 < 3 else seen[-1] ** 2)
        gain = sp.Rational(1, 2) + abs(draw(PART)) * draw(st.sampled_from(seen)) ** 2
        field.append(drift + gain * (X[i + 1] if i + 1 < n else U))
    steady = feedback(plant(*field), first := draw(PART) * W1 + draw(PART) * W2 + draw(PART) * W1**2)
    assert sp.simplify(steady.maps[0] - first) == 0
    return steady


@st.composite
def upper(draw: st.DrawFn) -> SymbolicSteadyState:
    """Two states that feed forward; their series end: linear in their own, quadratic in what follows."""
    last = -draw(RATE) * X2 + draw(PART) * U + draw(PART) * U**2
    first = -draw(RATE) * X1 + draw(PART) * X2 + draw(PART) * X2 * U + draw(PART) * U**2
    return feedforward(plant(first, last), 3, draw(PART) * W1 + draw(PART) * W2)


@st.composite
def both(draw: st.DrawFn) -> SymbolicSteadyState:
    """Two states above, two below, one of zero dynamics; every series of the upper part ends at degree 4."""
    field = (
        -draw(RATE) * X1 + draw(PART) * X2 * X3 + draw(PART) * Z**2 + draw(PART) * X2**2,
        -draw(RATE) * X2 + draw(PART) * X3 + draw(PART) * X3**2 + draw(PART) * Z,
        draw(PART) * X3 + draw(PART) * X1 + draw(PART) * Z + X4 / 2,
        draw(PART) * X4 + draw(PART) * X2 + draw(PART) * X1 * X3 + (1 + draw(PART) ** 2 * X3**2) * U,
    )
    system = plant(*field, zero=(Z,), zero_field=(-draw(RATE) * Z + draw(PART) * X3,))
    turn = draw(st.fractions(min_value="1/2", max_value=2, max_denominator=4))
    generator = SymbolicGenerator((W1, W2), (turn * W2, -turn * W1))
    return interlaced(system, generator, 2, draw(PART) * W1 + draw(PART) * W2, degree=4)


@given(st.one_of(lower(), upper(), both()), PLACE, PLACE)
@settings(max_examples=25)
def test_random_plants_stay_where_they_are_put(steady: SymbolicSteadyState, w1: float, w2: float) -> None:
    assert steady.exact
    assert departure(steady, [w1, w2]) < 1e-9


@given(upper(), PLACE, PLACE)
@settings(max_examples=8)
def test_series_that_end_are_where_the_plant_comes_to(
    steady: SymbolicSteadyState, w1: float, w2: float
) -> None:
    assert steady.function()([w1, w2])[:-1] == pytest.approx(settled(steady, [w1, w2]), abs=1e-9)


def test_the_linear_part_solves_the_sylvester_equation() -> None:
    a, b = np.array([[-1.0, 0.4], [0.0, -2.0]]), np.array([[0.3], [1.0]])
    s = np.array([[0.0, 1.0], [-3.0, 0.0]])
    system = plant(-X1 + 0.4 * X2 + 0.3 * U, -2 * X2 + U)
    steady = feedforward(system, 1, generator=SymbolicGenerator((W1, W2), (W2, -3 * W1)))
    found = np.array([[float(sp.diff(m, w)) for w in (W1, W2)] for m in steady.maps])
    assert found == pytest.approx(solve_sylvester(-a, s, b @ [[1.0, 0.0]]), abs=1e-14)


@pytest.mark.parametrize(
    ("field", "push", "generator", "degree", "order"),
    [
        ((-X1 - X1**3 + U,), W1, OSCILLATOR, 3, 5),
        ((-X1 - X1**3 + U,), W1, OSCILLATOR, 5, 7),
        ((-sp.sin(X1) + U + U**2,), W1, OSCILLATOR, 3, 4),
        ((-X1 + sp.exp(X2) - 1, -2 * X2 + X2**2 + U), W1, OSCILLATOR, 2, 3),
        ((-X1 / (1 + X1) + U,), W1 + W2, SymbolicGenerator((W1, W2), (W2, -W1 - W1**3)), 3, 4),
    ],
)
def test_the_error_of_a_truncated_series_has_the_order_it_says(
    field: Any, push: Any, generator: SymbolicGenerator, degree: int, order: int
) -> None:
    """Against integration from far in the past, at amplitudes that halve."""
    steady = feedforward(plant(*field), degree, push, generator)
    assert not steady.exact
    assert steady.degree == degree
    sizes = np.array([0.24, 0.17, 0.12])
    errors = []
    for size in sizes:
        w = size * np.array([0.8, 0.6])
        errors.append(np.abs(settled(steady, w) - steady.function()(w)[:-1]).max())
    assert abs(np.polyfit(np.log(sizes), np.log(errors), 1)[0] - order) < 0.3
    residual = composed(steady.residuals[0], {w: sp.Poly(w, W1, W2) for w in (W1, W2)}, (W1, W2), order)
    assert {sum(powers) for powers, c in residual.terms() if c != 0} == {order}


def test_a_series_cut_too_early_says_so() -> None:
    system = plant(-X1 + X2 * X3, -X2 + X3**2, X4, U)
    whole, part = (interlaced(system, OSCILLATOR, 2, W1, degree=k) for k in (3, 2))
    assert whole.exact
    assert not part.exact
    assert part.residuals[0] != 0
    assert part.residuals[1:] == (0, 0, 0)


def test_zero_dynamics_are_solved_together_or_follow_a_given_map() -> None:
    system = plant(-X1 + U, zero=(Z1, Z2), zero_field=(Z2, -2 * Z1 - Z2 + X1**2))
    steady, w = feedforward(system, 2), np.array([0.4, -0.7])
    assert steady.exact
    assert steady.function()(w)[:-1] == pytest.approx(settled(steady, w, 60.0), abs=1e-9)
    system = plant(Z + X1 + U, zero=(Z,), zero_field=(-Z + X1,))
    given_map, series = feedback(system, zero=((W1 - W2) / 2,)), feedback(system, degree=1)
    assert given_map.zero_maps == series.zero_maps == (W1 / 2 - W2 / 2,)
    assert given_map.exact
    assert series.exact
    assert given_map.degree is None
    assert departure(series, [0.3, 0.4]) < 1e-9
    with pytest.raises(ParameterError, match=r"z' is not satisfied by z = w1: the residual is w2"):
        feedback(system, zero=(W1,))


def test_a_resonance_without_solution_names_degree_equation_and_eigenvalues() -> None:
    said = r"resonance at degree 2 in x1': .* \(eigenvalue 0 = \(0\+1j\) \+ \(0-1j\)\)"
    with pytest.raises(InfeasibleError, match=said):
        feedforward(plant(U**2), 3)
    with pytest.raises(InfeasibleError, match=r"degree 1 in x1': .* \(eigenvalue -1 = \(-1\)\)"):
        feedforward(plant(-X1 + U), 3, generator=SymbolicGenerator((W1,), (-W1,)))
    with pytest.raises(InfeasibleError, match=r"degree 2 in z1': no power series satisfies the equation$"):
        feedforward(plant(-X1 + U, zero=(Z1, Z2), zero_field=(U**2, -K * Z2 + U)), 3)


def test_a_resonance_that_can_be_solved_leaves_its_terms_free() -> None:
    steady = feedforward(plant(U**3), 3)
    assert steady.exact
    assert [(free.degree, free.terms) for free in steady.free] == [(2, {"x1": W1**2 + W2**2})]
    other = steady.maps[0] + 7 * steady.free[0].terms["x1"]
    assert sp.expand(OSCILLATOR.along(other) - W1**3) == 0


def test_the_cauchy_problem_of_the_print_gives_no_steady_state() -> None:
    """x' = -x + w1 with pi = 0 where w2 = 0: a turn later the place is the same, pi is not."""
    steady = feedforward(plant(-X1 + U), 1)
    true = float(steady.function()([1.0, 0.0])[0])
    end = moved(steady, [1.0, 0.0], [0.0], 2 * np.pi)[2]
    assert end == pytest.approx(true * (1.0 - np.exp(-2 * np.pi)), abs=1e-9)
    assert end > 0.49
    assert true == 0.5


@pytest.mark.parametrize(
    ("row", "place"),
    [
        (X1 * U, "vanishes at w1 = 0, w2 = 0"),
        ((1 - 2 * X1) * U, "vanishes at w1 = 0.5, w2 = 0"),
        (U / X1, "has no value at w1 = 0, w2 = 0"),
        (U * (X1 - X1) + X1, "vanishes everywhere"),
    ],
)
def test_a_vanishing_gain_names_its_row_and_the_place(row: Any, place: str) -> None:
    with pytest.raises(InfeasibleError, match=f"g of x1' {place}"):
        feedback(plant(row))


def test_a_gain_may_vanish_outside_the_region() -> None:
    steady = feedback(plant((1 - 2 * X1) * U), region=[(-0.4, 0.4), (-0.4, 0.4)])
    assert sp.simplify(steady.input - W2 / (1 - 2 * W1)) == 0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: feedback(plant(X2**2, U)), "x1' must be affine in x2"),
        (lambda: feedback(plant(X3 + X2, X3, U)), r"x1' may contain x2, .*, received \['x3'\]"),
        (lambda: feedforward(plant(X2, X1 + U), 2), r"x2' may contain itself, .*, received \['x1'\]"),
        (lambda: feedforward(plant(1 - X1 + U), 2), "x1' must be zero at the origin, received 1"),
        (lambda: feedforward(plant(-X1 + U), 2.5), r"degree must be a whole number .*, received 2\.5"),
        (lambda: feedforward(plant(-X1 + sp.Abs(U)), 2), "has no power series that is known here"),
        (
            lambda: interlaced(plant(-X1 + X2, U), OSCILLATOR, 1, W1),
            "x1' needs a power series: give its degree",
        ),
        (
            lambda: interlaced(plant(-X1 + X3, X1 + X3, U), OSCILLATOR, 1, W1, degree=2),
            r"no order of solving leads to .*: x1' needs \[x3\]; x2' needs",
        ),
        (lambda: SymbolicSystem(X[:2], (X2,), U), "system needs an equation a state: 2, received 1"),
        (lambda: SymbolicSystem((X1,), (X1,), X1), "input need different symbols"),
        (lambda: SymbolicGenerator((W1,), (W1**2,)).matrix(), "generator must be linear"),
        (
            lambda: SymbolicGenerator((W1, W2), (W1 + W2, W2 - W1)),
            r"neutrally stable \(Assumption 1\.3\.1\): .*the eigenvalue 1[+-]1j grows",
        ),
        (
            lambda: SymbolicGenerator((W1, W2), (W2, 0 * W1)),
            r"neutrally stable .*the eigenvalue 0 is multiple, and a motion of it grows with t",
        ),
        (lambda: plant("3 +"), "needs an expression, received"),
        (lambda: plant(sp.oo), "needs a finite real expression, received"),
    ],
)
def test_what_has_another_form_is_refused_with_a_reason(call: Any, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        call()


def test_a_linear_part_alone_does_not_prove_that_a_generator_grows() -> None:
    assert SymbolicGenerator((W1, W2), (W2, W1**3)).field == (W2, W1**3)


def test_parameters_get_their_values_later() -> None:
    system = plant(-K * X1 + U)
    steady = feedback(system)
    assert sp.expand(steady.input - K * W1 - W2) == 0
    with pytest.raises(ParameterError, match=r"parameters without value: \['k'\]"):
        steady.function()
    assert feedback(system.with_values({K: 0.1})).input == W1 / 10 + W2
    with pytest.raises(ParameterError, match="are no parameters of the system"):
        system.with_values({X1: 1})


W = (W1, W2)


@pytest.mark.parametrize(
    ("e", "region"),
    [
        (1 + W1**2, None), (sp.exp(W1 * W2), None), (2 + sp.sin(W1), None), (sp.Integer(-3), None),
        (sp.Symbol("k"), None), (1 + W1**2 + W1 * W2 + W2**2, [(-3, 3), (-3, 3)]),
        (W1 - 2, [(-1, 1), (0, 0)]), (sp.Rational(1, 3) - W1, [(-1, 0.333), (0, 1)]),
    ],
)  # fmt: skip
def test_what_vanishes_nowhere_is_proved(e: Any, region: Any) -> None:
    prove_nonzero("g", e, W, region)


@pytest.mark.parametrize(
    ("e", "region", "place"),
    [
        (W1**2 - 2, None, r"vanishes at w1 = -?1\.41421"),
        (W1 * W2 + 1, None, r"vanishes at w1 = -1, w2 = 1"),
        (W1**2 + W2**2, [(-1, 1), (-2, 2)], "vanishes at w1 = 0, w2 = 0"),
        (sp.sin(W1), [(3.0, 4.0), (0, 1)], r"vanishes at w1 = 3\.14159"),
        (1 / (W1 - 1), [(0.0, 1.5), (0, 1)], "has no value at w1 = 1,"),
        ((W1 + 1) ** 2 - W1**2 - 2 * W1 - 1, None, "vanishes everywhere"),
    ],
)
def test_a_place_where_it_vanishes_is_named_and_true(e: Any, region: Any, place: str) -> None:
    with pytest.raises(InfeasibleError, match=f"^g {place}"):
        prove_nonzero("g", e, W, region)


def test_what_is_neither_is_undecided() -> None:
    with pytest.raises(UndecidedError, match=r"neither shown to vanish nowhere nor found .* give a region"):
        prove_nonzero("g", (W1 - sp.pi) ** 2, W, None)
    with pytest.raises(ParameterError, match=r"g = k\*w1 \+ 1 needs values for \['k'\]"):
        prove_nonzero("g", 1 + sp.Symbol("k") * W1, W, None)
