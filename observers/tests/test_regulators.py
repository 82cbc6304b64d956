"""Designed regulators: closed loops simulated, eigenvalues, regulator equations beside closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import solve_sylvester

import pointpred_observers as o
from observers.tests import kept_designs as kept
from observers.tests.test_simulate import solved
from pointpred.errors import DivergenceError, InfeasibleError, ParameterError
from pointpred_observers import Generator, Persidskii, thesis, trajectory
from pointpred_observers.examples import robotic_arm
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.interconnected.tracking import closed_loop

MASS = Persidskii([[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0], [1.0, 0.0], "sin", [0.0, 1.0], None, [1.0, 0.0])
"""An inverted pendulum: x'' = sin x + u."""


def random_plant(seed: int, *, time: str = "continuous") -> Persidskii:
    rng = np.random.default_rng(seed)
    a0, a1, h, b, c = (rng.normal(size=shape) for shape in ((3, 3), (3, 1), (1, 3), (3, 1), (1, 3)))
    scale = 0.3 if time == "discrete" else 1.0
    return Persidskii(scale * a0, 0.1 * a1, h, "tanh", b, None, c, time=time)


@given(st.integers(0, 2**31), st.booleans())
@settings(max_examples=4)
def test_the_feedback_decays_as_proved_for_every_constant_slope(seed: int, discrete: bool) -> None:
    plant = random_plant(seed, time="discrete" if discrete else "continuous")
    try:
        feedback = thesis.design_state_feedback(plant, decay=0.3)
    except ArithmeticError:
        return
    assert min(feedback.certificate.margins.values()) > 0.0
    for slope in np.linspace(0.0, 1.0, 11):
        a = plant.A0 + plant.B @ feedback.L0 + (plant.A1 + plant.B @ feedback.L1) * slope @ plant.H
        values = np.linalg.eigvals(a)
        rate = -np.log(np.abs(values).max()) if discrete else -values.real.max()
        assert rate >= 0.3


def test_the_feedback_of_a_double_integrator_is_small_where_it_may_be() -> None:
    """Placed poles at -1, -1 need a gain of 1 and 2; the least gain for the decay 1 lies near them."""
    plant = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", [0.0, 1.0])
    feedback = thesis.design_state_feedback(plant, decay=1.0)
    assert np.linalg.eigvals(plant.A0 + plant.B @ feedback.L0).real.max() < -1.0
    assert np.abs(feedback.L0).max() < 6.0
    assert feedback.L1.shape == (1, 0)


def test_a_feedback_does_not_depend_on_units() -> None:
    units, seconds = np.array([1e-3, 1e2]), 1e3
    plant = Persidskii(
        seconds * MASS.A0 * units / units[:, None], seconds * MASS.A1 / units[:, None], MASS.H * units, "sin",
        1e4 * seconds * MASS.B / units[:, None],
    )  # fmt: skip
    first = thesis.design_state_feedback(MASS, decay=1.0)
    other = thesis.design_state_feedback(plant, decay=seconds)
    assert 1e4 * other.L0 / units == pytest.approx(first.L0, rel=1e-2)
    assert pytest.approx(first.L1, rel=1e-2) == 1e4 * other.L1


def test_a_given_l1_is_kept_and_a_cancelled_f_needs_no_slopes() -> None:
    assert thesis.design_state_feedback(MASS, L1=[[0.0]]).L1.tolist() == [[0.0]]
    steep = Persidskii(MASS.A0, MASS.A1, MASS.H, "cube", MASS.B)
    with pytest.raises(ParameterError, match="needs bounded slopes"):
        thesis.design_state_feedback(steep)
    feedback = thesis.design_state_feedback(steep, decay=1.0, L1=[[-1.0]])
    assert feedback.certificate.domain == np.inf
    end = trajectory(
        lambda t, x: steep.field(t, x, feedback.L0 @ x + feedback.L1 @ steep.f(steep.H @ x)),
        [3.0, 0.0], [0.0, 12.0], step_s=0.01,
    )[-1]  # fmt: skip
    assert np.abs(end).max() < 1e-3


def test_the_pendulum_is_held_upright_from_its_angle_alone() -> None:
    design = Regulator.design(MASS, decay=1.0)
    for name, left in thesis.residuals(design.plant, design.regulator, design.Pi).items():
        assert np.abs(left).max() < 1e-9, name
    times = np.arange(0.0, 12.0, 0.5)
    start = [2.0, -1.0, 0.0, 0.0]
    both = trajectory(lambda t, one: closed_loop(MASS, design.regulator, t, one), start, times, step_s=0.01)
    for t, one in zip(times, both, strict=True):
        z = np.linalg.norm(one[:2] - one[2:])
        assert z <= design.observer.bound(float(t), float(np.hypot(2.0, 1.0))) + 1e-12
    assert np.abs(both[-1]).max() < 1e-3


def test_what_is_designed_passes_the_theorems_of_the_thesis_where_their_premise_holds() -> None:
    """J S~ < 0 is needed: the damping force tanh acts on the state that it depends on."""
    plant = Persidskii(
        [[-0.2, 1.0], [-1.0, -0.3]], [-0.5, 0.0], [1.0, 0.0], "tanh", [1.0, 0.0], None, [1.0, 0.0]
    )
    design = Regulator.design(plant, decay=0.4, L1=[[-0.5]])
    certificate = thesis.certify_tracking(plant, design.regulator, design.Pi)
    assert min(certificate.margins.values()) > 0.0


@pytest.mark.slow
def test_the_arm_has_a_regulator_though_assumption_3_2_3_fails() -> None:
    """Example 3: no input drives the link, J S~ = 0; the proof at the corners of the slopes needs no such."""
    plant, _ = robotic_arm(reach=1.0)
    design = Regulator.design(plant, decay=0.5, L1=[[0.0]])
    assert min(design.feedback.certificate.margins.values()) > 0.0
    with pytest.raises(ArithmeticError, match=r"3\.2\.3"):
        thesis.certify_tracking(plant, design.regulator, design.Pi)
    start = np.array([0.1, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0])
    both = trajectory(
        lambda t, one: closed_loop(plant, design.regulator, t, one), start, [0.0, 15.0], step_s=0.002
    )
    assert np.abs(both[-1]).max() < 1e-2


def test_a_reference_is_followed_from_the_angle_alone() -> None:
    """sin is cancelled by the input; the angle is to follow the first state of an oscillator."""
    circle = Generator([[0.0, 2.0], [-2.0, 0.0]])
    design = Regulator.design(MASS, decay=1.0, reference=circle, following=([[1.0, 0.0]], [[1.0, 0.0]]))
    assert design.equations is not None
    assert design.equations.Pi == pytest.approx(np.array([[1.0, 0.0], [0.0, 2.0]]), abs=1e-9)
    assert pytest.approx(np.array([[-1.0]])) == design.feedback.L1
    for name, left in thesis.residuals(design.plant, design.regulator, design.Pi).items():
        assert np.abs(left).max() < 1e-9, name
    start = [1.0, 0.5, 0.0, 0.0, 0.0, 1.0]
    times = np.arange(0.0, 15.0, 0.25)
    both = trajectory(lambda t, one: closed_loop(MASS, design.regulator, t, one), start, times, step_s=0.01)
    assert np.abs(both[-20:, 0] - np.sin(2.0 * times[-20:])).max() < 1e-3
    assert np.abs(both[:4, 0] - np.sin(2.0 * times[:4])).max() > 0.1


def test_the_regulator_equations_of_a_square_plant_are_a_sylvester_equation() -> None:
    """With L0 known, A0 Pi - Pi S0 = -B L0 has one solution; its R Pi is what L0 follows."""
    rng = np.random.default_rng(6)
    a, b, r = rng.normal(size=(4, 4)), rng.normal(size=(4, 1)), rng.normal(size=(1, 4))
    s = np.array([[0.0, 1.5], [-1.5, 0.0]])
    l0 = rng.normal(size=(1, 2))
    pi = solve_sylvester(a, -s, -b @ l0)
    found = thesis.regulator_equations(
        Persidskii(a, None, None, "sin", b), Generator(s), following=(r, r @ pi)
    )
    assert found.Pi == pytest.approx(pi, abs=1e-8)
    assert pytest.approx(l0, abs=1e-8) == found.L0
    assert found.nullity == 0


def test_a_zero_at_an_eigenvalue_of_the_reference_is_named() -> None:
    """(s^2 + 4) / (s + 1)^3 lets no oscillation at 2 rad/s through."""
    plant = Persidskii(
        [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, -3.0, -3.0]], None, None, "sin", [0.0, 0.0, 1.0]
    )
    row = [[4.0, 0.0, 1.0]]
    with pytest.raises(
        InfeasibleError, match=r"leaves .* in .*; the plant has a zero .* at the eigenvalue .*2j of S0"
    ):
        thesis.regulator_equations(plant, Generator([[0.0, 2.0], [-2.0, 0.0]]), following=(row, [[1.0, 0.0]]))
    found = thesis.regulator_equations(
        plant, Generator([[0.0, 1.9], [-1.9, 0.0]]), following=(row, [[1.0, 0.0]])
    )
    assert max(found.residuals.values()) < 1e-9


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
