"""Proposition 4.3.2, corrected: series that end, truncated ones and their order, resonance, and the print."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import solve_sylvester

from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers.triangular.forms import interlaced
from pointpred_observers.triangular.polynomials import composed
from pointpred_observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem

sp = pytest.importorskip("sympy")
W1, W2, U = sp.symbols("w1 w2 u")
X1, X2, X3 = X = sp.symbols("x1:4")
OSCILLATOR = SymbolicGenerator((W1, W2), (W2, -W1))


def feedforward(system: Any, generator: Any, ell: Any, degree: Any, **more: Any) -> SymbolicSteadyState:
    return interlaced(system, generator, len(system.states), ell, degree, **more)


FRACTION = st.fractions(min_value=-1, max_value=1, max_denominator=6)
RATE = st.fractions(min_value=1, max_value=3, max_denominator=4)


def settled(steady: SymbolicSteadyState, w: np.ndarray, before_s: float = 25.0) -> np.ndarray:
    """Where the plant is at w after ``before_s``, started at rest: integration, and nothing of the series."""
    system, generator = steady.system, steady.generator
    symbols = (*system.states, *system.zero, system.input)
    plant = sp.lambdify(symbols, (*system.field, *system.zero_field), modules="math")
    drive = sp.lambdify(generator.states, generator.field, modules="math")
    push = sp.lambdify(generator.states, steady.input, modules="math")
    q, n = len(w), len(system.states) + len(system.zero)
    back = solve_ivp(
        lambda _, v: np.negative(drive(*v)), (0, before_s), w, method="DOP853", rtol=1e-13, atol=1e-15
    )
    start = np.concatenate([back.y[:, -1], np.zeros(n)])

    def motion(_: float, y: np.ndarray) -> np.ndarray:
        at = y.tolist()
        return np.array([*drive(*at[:q]), *plant(*at[q:], push(*at[:q]))])

    return solve_ivp(motion, (0, before_s), start, method="DOP853", rtol=1e-13, atol=1e-15).y[q:, -1]


@st.composite
def upper_triangular(draw: st.DrawFn) -> tuple[SymbolicSystem, Any]:
    """Two states whose series end: linear in their own state, quadratic in what follows."""
    last = -draw(RATE) * X2 + draw(FRACTION) * U + draw(FRACTION) * U**2
    first = -draw(RATE) * X1 + draw(FRACTION) * X2 + draw(FRACTION) * X2 * U + draw(FRACTION) * U**2
    return SymbolicSystem((X1, X2), (first, last), U), draw(FRACTION) * W1 + draw(FRACTION) * W2


@given(upper_triangular(), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
@settings(max_examples=8)
def test_series_that_end_are_exact_and_hold_along_trajectories(drawn: Any, w1: float, w2: float) -> None:
    system, ell = drawn
    steady = feedforward(system, OSCILLATOR, ell, degree=3)
    assert steady.exact
    assert steady.residuals == (0, 0)
    w = np.array([w1, w2])
    assert steady.function()(w)[:-1] == pytest.approx(settled(steady, w), abs=1e-9)


def test_the_linear_part_solves_the_sylvester_equation() -> None:
    a, b, s = (
        np.array([[-1.0, 0.4], [0.0, -2.0]]),
        np.array([[0.3], [1.0]]),
        np.array([[0.0, 1.0], [-3.0, 0.0]]),
    )
    system = SymbolicSystem((X1, X2), (-X1 + 0.4 * X2 + 0.3 * U, -2 * X2 + U), U)
    steady = feedforward(system, SymbolicGenerator((W1, W2), (W2, -3 * W1)), W1, degree=1)
    found = np.array([[float(sp.diff(m, w)) for w in (W1, W2)] for m in steady.maps])
    assert found == pytest.approx(solve_sylvester(-a, s, b @ [[1.0, 0.0]]), abs=1e-14)


@pytest.mark.parametrize(
    ("field", "ell", "generator", "degree", "order"),
    [
        ((-X1 - X1**3 + U,), W1, OSCILLATOR, 3, 5),
        ((-X1 - X1**3 + U,), W1, OSCILLATOR, 5, 7),
        ((-sp.sin(X1) + U + U**2,), W1, OSCILLATOR, 3, 4),
        ((-X1 + sp.exp(X2) - 1, -2 * X2 + X2**2 + U), W1, OSCILLATOR, 2, 3),
        ((-X1 / (1 + X1) + U,), W1 + W2, SymbolicGenerator((W1, W2), (W2, -W1 - W1**3)), 3, 4),
    ],
)
def test_the_error_of_a_truncated_series_has_the_order_it_says(
    field: Any, ell: Any, generator: SymbolicGenerator, degree: int, order: int
) -> None:
    """Against integration from far in the past, at amplitudes that halve."""
    steady = feedforward(SymbolicSystem(X[: len(field)], field, U), generator, ell, degree=degree)
    assert not steady.exact
    assert steady.degree == degree
    sizes = np.array([0.24, 0.17, 0.12])
    errors = []
    for size in sizes:
        w = size * np.array([0.8, 0.6])
        errors.append(np.abs(settled(steady, w) - steady.function()(w)[:-1]).max())
    slope = np.polyfit(np.log(sizes), np.log(errors), 1)[0]
    assert abs(slope - order) < 0.3
    residual = composed(steady.residuals[0], {w: sp.Poly(w, W1, W2) for w in (W1, W2)}, (W1, W2), order)
    assert {sum(powers) for powers, c in residual.terms() if c != 0} == {order}


def test_zero_dynamics_are_solved_together() -> None:
    z1, z2 = sp.symbols("z1 z2")
    system = SymbolicSystem((X1,), (-X1 + U,), U, zero=(z1, z2), zero_field=(z2, -2 * z1 - z2 + X1**2))
    steady = feedforward(system, OSCILLATOR, W1, degree=2)
    w = np.array([0.4, -0.7])
    assert steady.exact
    assert steady.function()(w)[:-1] == pytest.approx(settled(steady, w, 60.0), abs=1e-9)


def test_a_resonance_without_solution_names_degree_equation_and_eigenvalues() -> None:
    said = r"resonance at degree 2 in x1': .* \(eigenvalue 0 = \(0\+1j\) \+ \(0-1j\)\)"
    with pytest.raises(InfeasibleError, match=said):
        feedforward(SymbolicSystem((X1,), (U**2,), U), OSCILLATOR, W1, degree=3)
    real = SymbolicGenerator((W1,), (-W1,))
    with pytest.raises(InfeasibleError, match=r"degree 1 in x1': .* \(eigenvalue -1 = \(-1\)\)"):
        feedforward(SymbolicSystem((X1,), (-X1 + U,), U), real, W1, degree=3)
    k = sp.Symbol("k")
    z1, z2 = sp.symbols("z1 z2")
    open_system = SymbolicSystem((X1,), (-X1 + U,), U, zero=(z1, z2), zero_field=(U**2, -k * z2 + U))
    with pytest.raises(InfeasibleError, match=r"degree 2 in z1': no power series satisfies the equation$"):
        feedforward(open_system, OSCILLATOR, W1, degree=3)


def test_a_resonance_that_can_be_solved_leaves_its_terms_free() -> None:
    steady = feedforward(SymbolicSystem((X1,), (U**3,), U), OSCILLATOR, W1, degree=3)
    assert steady.exact
    assert [(free.degree, free.terms) for free in steady.free] == [(2, {"x1": W1**2 + W2**2})]
    moved = steady.maps[0] + 7 * steady.free[0].terms["x1"]
    assert sp.expand(OSCILLATOR.along(moved) - W1**3) == 0


def test_the_cauchy_problem_of_the_print_gives_no_steady_state() -> None:
    """x' = -x + w1 with pi = 0 where w2 = 0: a turn later the place is the same, pi is not."""
    motion = solve_ivp(
        lambda t, x: -x + np.cos(t), (0.0, 2 * np.pi), [0.0], method="DOP853", rtol=1e-12, atol=1e-14
    )
    steady = feedforward(SymbolicSystem((X1,), (-X1 + U,), U), OSCILLATOR, W1, degree=1)
    true = float(steady.function()([1.0, 0.0])[0])
    assert motion.y[0, -1] == pytest.approx(true * (1.0 - np.exp(-2 * np.pi)), abs=1e-9)
    assert abs(motion.y[0, -1] - motion.y[0, 0]) > 0.49
    assert true == 0.5


@pytest.mark.parametrize(
    ("function", "at"),
    [
        (sp.sin, 0),
        (sp.cos, 0),
        (sp.exp, 0),
        (sp.tanh, 0),
        (sp.atan, 0),
        (sp.log, 2),
        (sp.sqrt, 3),
        (sp.cosh, 1),
    ],
)
def test_composition_agrees_with_the_library(function: Any, at: int) -> None:
    e = function(at + W1 + W1**2 / 3) / (2 - W1)
    found = composed(e, {W1: sp.Poly(W1, W1)}, (W1,), 5).as_expr()
    assert sp.simplify(found - sp.series(e, W1, 0, 6).removeO()) == 0


@pytest.mark.parametrize("e", [1 / W1, sp.log(W1), sp.sqrt(W1), sp.log(W1 - 1)])
def test_what_is_not_analytic_at_the_origin_is_refused(e: Any) -> None:
    with pytest.raises(ParameterError, match="is not analytic at the origin"):
        composed(e, {W1: sp.Poly(W1, W1)}, (W1,), 2)


def test_what_the_form_does_not_allow_is_refused() -> None:
    with pytest.raises(ParameterError, match=r"x2' may contain itself, later states .*, received \['x1'\]"):
        feedforward(SymbolicSystem((X1, X2), (X2, X1 + U), U), OSCILLATOR, W1, degree=2)
    with pytest.raises(ParameterError, match="x1' must be zero at the origin, received 1"):
        feedforward(SymbolicSystem((X1,), (1 - X1 + U,), U), OSCILLATOR, W1, degree=2)
    with pytest.raises(ParameterError, match=r"degree must be a whole number in \[1, 15\], received 0"):
        feedforward(SymbolicSystem((X1,), (-X1 + U,), U), OSCILLATOR, W1, degree=0)
    with pytest.raises(ParameterError, match=r"degree must be a whole number in \[1, 15\], received 2\.5"):
        feedforward(SymbolicSystem((X1,), (-X1 + U,), U), OSCILLATOR, W1, degree=2.5)
    with pytest.raises(ParameterError, match="has no power series that is known here"):
        feedforward(SymbolicSystem((X1,), (-X1 + sp.Abs(U),), U), OSCILLATOR, W1, degree=2)
    with pytest.raises(ParameterError, match="zero must hold 0 maps, received 1"):
        feedforward(SymbolicSystem((X1,), (-X1 + U,), U), OSCILLATOR, W1, degree=2, zero=(W1,))
