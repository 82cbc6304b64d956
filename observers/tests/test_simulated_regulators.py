"""A plant under its regulator: the stage of a program, whose input is held between samples."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import pointpred_observers as o
from observers.tests import kept_designs as kept
from observers.tests.test_simulate import solved
from pointpred.errors import DivergenceError
from pointpred_observers.interconnected.tracking import closed_loop

pytest.importorskip("cvxpy")


def test_a_plant_under_its_regulator_whose_input_is_held() -> None:
    """y between samples is a line for the regulator, u is a step for the plant."""
    design = kept.design("regulator")
    g, h = design.regulator, 0.05
    times = h * np.arange(40)
    x, w, expected = np.array([1.0, 0.0]), np.zeros(2), []
    for _ in times:
        u = (g.L0 @ w + g.L1[:, 0] * np.sin(w[0]))[0]
        expected.append([*x, *w, u])

        def plant(t: float, x: Any, u: float = u) -> Any:
            return [x[1], -0.3 * x[1] - 9.81 * np.sin(x[0]) + u]

        onward = solved(plant, x, [0.0, h])[-1]

        def regulator(t: float, w: Any, y: float = x[0], change: float = onward[0] - x[0]) -> Any:
            return g.S0 @ w + g.S1[:, 0] * np.sin(w[0]) + g.G[:, 0] * (y + change * t / h)

        x, w = onward, solved(regulator, w, [0.0, h])[-1]
    result = o.simulate(kept.PENDULUM, design, times=times, start=[1.0, 0.0])
    expected = np.array(expected)
    assert np.allclose(np.hstack([result.state, result.estimate]), expected[:, :4], atol=1e-5)
    assert np.allclose(result.input[:, 0], expected[:, 4], atol=1e-4)
    same = o.simulate(kept.PENDULUM, g, times=times, start=[1.0, 0.0])
    assert np.allclose(same.state, result.state, atol=1e-9)


def test_a_regulator_that_is_sampled_too_seldom_shows_it() -> None:
    """x grows by e^h in a sample, and u = -6 x moves it by 6 (e^h - 1): beyond ln(4/3) or so it swings up."""
    plant = o.Persidskii([[1.0]], None, None, "sin", [1.0], None, [1.0])
    design = o.design(plant, "regulator", decay=5.0)
    fine, coarse = (o.simulate(plant, design, times=h * np.arange(30), start=[1.0]) for h in (0.1, 1.0))
    assert abs(fine.state[-1, 0]) < 1e-5
    assert abs(coarse.state[-1, 0]) > 1e6
    with pytest.raises(DivergenceError, match="leaves every bound"):
        o.simulate(plant, design, times=np.arange(900.0))


def test_a_discrete_plant_under_its_regulator_is_the_closed_loop() -> None:
    sampled = o.c2d(kept.PENDULUM, 0.02)
    design = o.design(sampled, "regulator", decay=0.02)
    both, expected = np.array([1.0, 0.0, 0.0, 0.0]), []
    for k in range(50):
        expected.append(both)
        both = closed_loop(sampled, design.regulator, float(k), both)
    result = o.simulate(sampled, design, times=np.arange(50.0), start=[1.0, 0.0])
    assert np.allclose(np.hstack([result.state, result.estimate]), expected, atol=1e-12)


def test_a_reference_is_followed() -> None:
    """A held input comes half a sample late, and the error is proportional to that."""
    design = kept.design("servo")
    left = []
    for h in (0.04, 0.01):
        times = np.arange(0.0, 12.0, h)
        result = o.simulate(
            design.plant, design, times=times, start=[1.0, 0.5], estimate=[0.0, 0.0, 0.0, 1.0]
        )
        left.append(np.abs(result.state[:, 0] - np.sin(2.0 * times))[times > 9.0].max())
    assert left[1] < 0.025
    assert left[0] == pytest.approx(4.0 * left[1], rel=0.2)
