"""Random interlaced systems with zero dynamics: what is found holds along trajectories."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from pointpred_observers import SymbolicGenerator, SymbolicSystem, interlaced

sp = pytest.importorskip("sympy")
W1, W2, U, Z = sp.symbols("w1 w2 u z")
X1, X2, X3, X4 = X = sp.symbols("x1:5")
PART = st.fractions(min_value=-1, max_value=1, max_denominator=6)
RATE = st.fractions(min_value=1, max_value=2, max_denominator=4)


@st.composite
def systems(draw: st.DrawFn) -> tuple[SymbolicSystem, SymbolicGenerator, Any]:
    """Two states above, two below, one of zero dynamics; every series of the upper part ends at degree 4."""
    field = (
        -draw(RATE) * X1 + draw(PART) * X2 * X3 + draw(PART) * Z**2 + draw(PART) * X2**2,
        -draw(RATE) * X2 + draw(PART) * X3 + draw(PART) * X3**2 + draw(PART) * Z,
        draw(PART) * X3 + draw(PART) * X1 + draw(PART) * Z + X4 / 2,
        draw(PART) * X4 + draw(PART) * X2 + draw(PART) * X1 * X3 + (1 + draw(PART) ** 2 * X3**2) * U,
    )
    system = SymbolicSystem(X, field, U, zero=(Z,), zero_field=(-draw(RATE) * Z + draw(PART) * X3,))
    turn = draw(st.fractions(min_value="1/2", max_value=2, max_denominator=4))
    return system, SymbolicGenerator((W1, W2), (turn * W2, -turn * W1)), draw(PART) * W1 + W2


@given(systems(), st.floats(-0.8, 0.8), st.floats(-0.8, 0.8))
@settings(max_examples=10)
def test_the_plant_stays_where_it_is_put(drawn: Any, w1: float, w2: float) -> None:
    system, generator, first = drawn
    steady = interlaced(system, generator, 2, first, degree=4)
    assert steady.exact
    at, start = steady.function(), np.array([w1, w2])
    plant = sp.lambdify((*X, Z, U), (*system.field, *system.zero_field), modules="math")
    drive = sp.lambdify((W1, W2), generator.field, modules="math")
    push = sp.lambdify((W1, W2), steady.input, modules="math")

    def motion(_: float, v: np.ndarray) -> list[float]:
        a, b, *x = v.tolist()
        return [*drive(a, b), *plant(*x, push(a, b))]

    put = np.concatenate([start, at(start)[:-1]])
    answer = solve_ivp(motion, (0.0, 1.0), put, method="DOP853", rtol=1e-13, atol=1e-14)
    assert np.abs(answer.y[2:] - at(answer.y[:2])[:-1]).max() < 1e-9
    assert np.abs(put[2:]).max() > 0.0 or not start.any()


def test_a_series_cut_too_early_says_so_and_leaves() -> None:
    field = (-X1 + X2 * X3, -X2 + X3**2, X4, U)
    system = SymbolicSystem(X, field, U)
    generator = SymbolicGenerator((W1, W2), (W2, -W1))
    whole, part = (interlaced(system, generator, 2, W1, degree=k) for k in (3, 2))
    assert whole.exact
    assert not part.exact
    assert part.residuals[0] != 0
    assert part.residuals[1:] == (0, 0, 0)
