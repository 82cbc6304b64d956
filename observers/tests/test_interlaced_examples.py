"""Examples 8 and 9: what is true to the last digit, and what the print says instead."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from pointpred.errors import CertificateError
from pointpred_observers import SymbolicSystem, interlaced, trajectory
from pointpred_observers.examples import SPRINGS, interlaced_masses, interlaced_states
from pointpred_observers.plants.symbolic import SymbolicSteadyState
from pointpred_observers.thesis import check_steady_state

sp = pytest.importorskip("sympy")
W1, W2, U = sp.symbols("w1 w2 u")
X1, X2, X3, X4 = sp.symbols("x1:5")
Y1, Y2, Y3, Y4 = sp.symbols("y1:5")
K1, K2, K3, A1, A2 = sp.symbols("k1 k2 k3 a1 a2")
STATES, OSCILLATOR = interlaced_states()
MASSES = interlaced_masses()[0]
SPRING = K1 * Y3 + K2 * Y3**3 + A1 * Y4


@cache
def eight() -> SymbolicSteadyState:
    return interlaced(STATES, OSCILLATOR, 2, W1, degree=3)


@cache
def nine() -> SymbolicSteadyState:
    return interlaced(MASSES, OSCILLATOR, 2, W1 + W2, degree=3)


def residuals(system: SymbolicSystem, maps: Any, ell: Any) -> list[Any]:
    values = {**dict(zip(system.states, maps, strict=True)), U: ell}
    return [
        sp.simplify(sp.diff(m, W1) * W2 - sp.diff(m, W2) * W1 - f.subs(values, simultaneous=True))
        for m, f in zip(maps, system.field, strict=True)
    ]


def test_example_8_as_corrected() -> None:
    steady = eight()
    pi1 = sp.Rational(1, 40) * (W1**3 - 7 * W2**3 - 9 * W1**2 * W2 + 7 * W1 * W2**2)
    assert sp.expand(steady.maps[0] - pi1) == 0
    assert steady.maps[1:] == (W1 / 2 - W2 / 2, W1, W1**3 + W2)
    assert sp.simplify(steady.input - (W1**3 + 3 * W1**2 * W2 - W1 + W2) / (1 + W1**2)) == 0
    assert steady.exact
    assert residuals(STATES, steady.maps, steady.input) == [0, 0, 0, 0]
    assert steady.outputs() == (W1,)


def test_example_8_as_printed_is_no_steady_state() -> None:
    maps, printed_input = eight().maps, (-W1 + 3 * W1**2 * W2) / (1 + W1**2)
    assert residuals(STATES, (*maps[:3], W2 + W1**2), eight().input)[2] != 0
    assert sp.expand(residuals(STATES, maps, printed_input)[3] - W1**3 - W2) == 0


def test_the_coefficient_equation_of_example_8_has_four_different_monomials() -> None:
    a1, a2, a3, a4 = sp.symbols("a1:5")
    pi1 = a1 * W1**3 + a2 * W2**3 + a3 * W1**2 * W2 + a4 * W2**2 * W1
    row = STATES.field[0].subs({X2: (W1 - W2) / 2, X3: W1})
    equation = sp.Poly(residuals(SymbolicSystem((X1,), (row,), U), (pi1,), 0)[0], W1, W2)
    assert sp.expand(equation.coeff_monomial(W1 * W2**2) - (2 * a3 - 3 * a2 + a4 - sp.Rational(1, 4))) == 0
    assert {powers for powers, _ in equation.terms()} == {(3, 0), (0, 3), (2, 1), (1, 2)}


def test_example_9_as_corrected() -> None:
    steady = nine()
    tau1 = -sp.Rational(13, 9) * (W1**3 + W2**3) - sp.Rational(5, 3) * (W1**2 * W2 + W1 * W2**2)
    tau2 = -sp.Rational(5, 3) * (W1**3 - W2**3) + W1**2 * W2 - W1 * W2**2
    linear = [m.subs(K2, 0) for m in steady.maps]
    assert sp.expand(steady.maps[0] - linear[0] + K2 * tau1) == 0
    assert sp.expand(steady.maps[1] - linear[1] - K2 * tau2) == 0
    printed = (
        (W1 + W2) * (1 - K1 * (2 - K3) - A1 * A2 - K3)
        - 2 * K2 * (W1 + W2) ** 3
        + (W1 - W2) * (A1 * (2 - K3) + A2 * (1 - K1))
    )
    assert sp.expand(steady.input - printed - (-K2 * K3 * tau1 + K2 * A2 * tau2)) == 0
    assert steady.exact
    assert residuals(MASSES, steady.maps, steady.input) == [0, 0, 0, 0]
    assert steady.outputs() == (W1 + W2,)


def test_example_9_as_printed_is_no_steady_state() -> None:
    steady = nine()
    tau1 = sp.Rational(4, 3) * (W2 * W1**2 - W1 * W2**2) - sp.Rational(11, 9) * (W1**3 + W2**3)
    tau2 = sp.Rational(4, 3) * (W1**3 + W2**3) + W2 * W1**2 + W1 * W2**2
    linear = [m.subs(K2, 0) for m in steady.maps]
    printed = (linear[0] - K2 * tau1, linear[1] + K2 * tau2, *steady.maps[2:])
    wrong = residuals(MASSES, printed, steady.input)
    assert wrong[0] != 0
    assert wrong[1] != 0


def test_the_printed_fourth_row_of_example_9_is_not_that_of_the_masses() -> None:
    """y4 = x2 - x4 has the derivative x2' - x4'."""
    force = K1 * (X1 - X3) + K2 * (X1 - X3) ** 3 + A1 * (X2 - X4)
    masses = (X2, -force, X4, force - K3 * X3 - A2 * X4 + U)
    back = {Y1: X1, Y2: X2, Y3: X1 - X3, Y4: X2 - X4}
    true = masses[1] - masses[3]
    assert sp.expand(MASSES.field[3].subs(back, simultaneous=True) - true) == 0
    printed = SPRING - K3 * (Y1 - Y3) - A2 * (Y2 - Y4) + U
    assert sp.expand(printed.subs(back, simultaneous=True) - true) != 0


def test_example_9_is_not_in_the_form_it_is_said_to_be_in() -> None:
    """y2' contains y4, the second state of the lower part; with y2 + a1 y3 for y2 it is in the form."""
    steady = nine()
    assert MASSES.field[1].has(Y4)
    v = sp.Symbol("v")
    shifted = (v - A1 * Y3, -K1 * Y3 - K2 * Y3**3, Y4, MASSES.field[3].subs(Y2, v - A1 * Y3))
    other = interlaced(SymbolicSystem((Y1, v, Y3, Y4), shifted, U), OSCILLATOR, 2, W1 + W2, degree=3)
    assert not shifted[1].has(Y4)
    assert sp.expand(other.maps[0] - steady.maps[0]) == 0
    assert sp.expand(other.maps[1] - A1 * (W1 + W2) - steady.maps[1]) == 0
    assert sp.expand(other.input - steady.input) == 0


def test_the_masses_converge_to_the_corrected_steady_state() -> None:
    system = MASSES.with_values({one: SPRINGS[str(one)] for one in MASSES.parameters()})
    steady = interlaced(system, OSCILLATOR, 2, W1 + W2, degree=3)
    at, push = steady.function(), sp.lambdify((W1, W2), steady.input, modules="math")

    def masses(_: float, v: np.ndarray) -> list[float]:
        w1, w2, x1, x2, x3, x4 = v.tolist()
        force = 3 * (x1 - x3) + 3 * (x1 - x3) ** 3 + 0.6 * (x2 - x4)
        return [w2, -w1, x2, -force, x4, force - 0.6 * x3 - 2 * x4 + push(w1, w2)]

    rows = trajectory(masses, [0.1, 0, 0, 0, 0, 0], [0.0, 10.0, 30.0])
    y1, y2, y3, y4, _ = at(rows[:, :2].T)
    errors = np.abs(rows[:, 2:] - np.array([y1, y2, y1 - y3, y2 - y4]).T).max(axis=1)
    assert errors[0] > 0.3
    assert 1e-3 < errors[1] < 1e-2
    assert errors[2] < 1e-7


EIGHT, CIRCLE = interlaced_states()


PI1 = sp.Rational(1, 40) * (W1**3 - 7 * W2**3 - 9 * W1**2 * W2 + 7 * W1 * W2**2)


MAPS = (PI1, W1 / 2 - W2 / 2, W1, W2 + W1**3)


INPUT = (W1**3 + 3 * W1**2 * W2 - W1 + W2) / (1 + W1**2)


def test_example_8_as_corrected_and_as_printed() -> None:
    assert check_steady_state(EIGHT, CIRCLE, MAPS, INPUT).exact
    with pytest.raises(CertificateError, match=r"x3' leaves .*; x4' leaves"):
        check_steady_state(EIGHT, CIRCLE, (*MAPS[:3], W2 + W1**2), INPUT)
    with pytest.raises(CertificateError, match=r"fails: x4' leaves w1\*\*3 \+ w2$"):
        check_steady_state(EIGHT, CIRCLE, MAPS, (-W1 + 3 * W1**2 * W2) / (1 + W1**2))


def test_a_truncated_series_holds_up_to_its_degree() -> None:
    series = sp.series(INPUT.subs(W2, 0), W1, 0, 4).removeO() + W2 + 3 * W1**2 * W2 - W1**2 * W2
    found = check_steady_state(EIGHT, CIRCLE, MAPS, series, degree=3)
    assert not found.exact
    assert found.degree == 3
    with pytest.raises(CertificateError, match="x4' leaves"):
        check_steady_state(EIGHT, CIRCLE, MAPS, series, degree=5)
