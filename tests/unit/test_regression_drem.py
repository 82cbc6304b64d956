"""DREM: the identity it rests on, its exact integration, its account of itself."""

import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.regression import DynamicRegressorExtension, drem, gradient


@settings(max_examples=40, deadline=None)
@given(st.integers(2, 6), st.integers(0, 10**6), st.integers(-6, 6))
def test_mixed_output_is_phi_times_theta(n: int, seed: int, exponent: int) -> None:
    """Y~ = phi theta for any regressor, whatever the units; and |phi| <= 1."""
    rng = np.random.default_rng(seed)
    theta, units = rng.standard_normal(n), 10.0 ** (exponent * rng.uniform(-1.0, 1.0, n))
    s, r = drem.State(np.zeros(drem.State.length)), drem.parts(np.zeros(drem.numbers(n)), n)
    told = 0
    for t in np.cumsum(rng.uniform(0.002, 0.02, 60)):
        r.w[:] = rng.standard_normal(n) * units
        if not drem.advance(s, r, 0.05, 1.0, t, float(r.w @ theta)):
            continue
        told += 1
        assert abs(s.phi) <= 1.0 + 1e-12
        wanted = s.phi * theta * r.largest
        assert np.abs(r.mixed - wanted).max() <= 1e-11 * max(1.0, float(np.abs(theta * r.largest).max()))
    assert told > 0


@pytest.mark.parametrize("gamma", [3.0, 400.0, 1e5])
def test_the_scalar_step_is_the_solution_of_the_scalar_equation(gamma: float) -> None:
    phi, mixed, theta, h = 0.3, 0.9, -2.0, 0.02
    answer = solve_ivp(
        lambda _, s: gamma * phi * (mixed - phi * s),
        (0.0, h),
        [theta],
        rtol=1e-10,
        atol=1e-12,
        method="LSODA",
    )
    assert gradient.descend(theta, mixed, phi, gamma, h) == pytest.approx(answer.y[0, -1], rel=1e-7)


def test_the_scalar_step_never_overshoots_and_survives_no_excitation() -> None:
    assert gradient.descend(-2.0, 0.9, 0.3, 1e300, 1.0) == pytest.approx(3.0)
    assert gradient.descend(5.0, 1e9, 0.0, 1e9, 1.0) == 5.0
    assert gradient.descend(5.0, 1.0, 1e-200, 1e9, 1.0) == 5.0
    halves = gradient.descend(gradient.descend(1.0, 0.4, 0.2, 50.0, 0.01), 0.4, 0.2, 50.0, 0.01)
    assert halves == pytest.approx(gradient.descend(1.0, 0.4, 0.2, 50.0, 0.02), rel=1e-13)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_any_number_of_parameters_is_recovered(n: int) -> None:
    rng = np.random.default_rng(n)
    theta = rng.uniform(-5.0, 5.0, n)
    stage = DynamicRegressorExtension(n, delay_s=0.07, gamma=1e9)
    for i in range(1500):
        w = np.array([np.sin((1.0 + 1.7 * j) * i / 100 + j) for j in range(n)])
        estimate = stage.update(w, float(w @ theta), i / 1000)
    assert estimate is not None
    assert estimate.values == pytest.approx(theta, rel=1e-6)
    assert estimate.learnt == pytest.approx(1.0)


def test_nothing_is_said_before_the_history_is_long_enough() -> None:
    stage = DynamicRegressorExtension(3, delay_s=0.1, gamma=1e6)
    first = next(i for i in range(1000) if stage.update((np.sin(i / 9), i / 100, 1.0), 1.0, i / 1000))
    assert first == pytest.approx(200, abs=1)


def test_a_column_that_never_moves_excites_nothing() -> None:
    stage = DynamicRegressorExtension(2, delay_s=0.05, gamma=1e6)
    for i in range(300):
        estimate = stage.update((0.0, 1.0 + np.sin(i / 9)), 2.0, i / 1000)
    assert estimate is not None
    assert (estimate.phi, estimate.learnt, estimate.values) == (0.0, 0.0, (0.0, 0.0))


def test_nothing_is_learnt_before_every_delayed_row_has_moved() -> None:
    stage = DynamicRegressorExtension(2, delay_s=0.05, gamma=1e9)
    for i in range(1200):
        w = (np.sin(i / 9), np.cos(i / 9)) if i >= 200 else (0.0, 0.0)
        estimate = stage.update(w, 3.0 * w[0] - 2.0 * w[1], i / 1000)
        assert (estimate is None) == (i < 250), i
    assert estimate is not None
    assert estimate.values == pytest.approx((3.0, -2.0), rel=1e-6)


def test_units_and_rate_leave_the_excitation_alone() -> None:
    """The same movement in other units, and eight times as fast reports: the same learning."""
    learnt = []
    for unit, rate in ((1.0, 1000.0), (1e4, 1000.0), (1.0, 8000.0)):
        stage = DynamicRegressorExtension(3, delay_s=0.1, gamma=200.0)
        for t in np.arange(0.0, 0.8, 1.0 / rate):
            w = (unit * np.sin(6.0 * t), unit * np.cos(6.0 * t), 1.0)
            estimate = stage.update(w, w[0] + 3.0, t)
        assert estimate is not None
        learnt.append(estimate.learnt)
    assert 0.1 < learnt[0] < 0.95
    assert learnt[1] == pytest.approx(learnt[0], rel=1e-9)
    assert learnt[2] == pytest.approx(learnt[0], rel=0.02)


def test_excitation_falls_with_the_third_power_of_the_delay() -> None:
    """n (n - 1) / 2 = 3: rows a short while apart look alike, and half the delay means an eighth of phi."""
    phi = []
    for delay_s in (0.01, 0.005):
        stage = DynamicRegressorExtension(3, delay_s=delay_s)
        for t in np.arange(0.0, 2.0, 1e-4):
            estimate = stage.update((np.sin(5.0 * t), np.cos(5.0 * t), 1.0), 1.0, t)
        assert estimate is not None
        phi.append(estimate.phi)
    assert phi[0] / phi[1] == pytest.approx(8.0, rel=0.02)


def test_a_law_writes_nothing_beside_its_own_floats() -> None:
    n, at = 3, 5
    end = at + drem.State.length + drem.numbers(n)
    memory = np.full(end + 4, 7.0)
    memory[at:end] = 0.0
    s, r = drem.State(memory, at), drem.parts(memory[at + drem.State.length : end], n)
    rng = np.random.default_rng(1)
    for t in np.arange(0.0, 0.5, 0.002):
        r.w[:] = rng.standard_normal(n)
        drem.advance(s, r, 0.05, 10.0, t, 1.0)
    assert memory[at:end].any()
    assert (memory[:at] == 7.0).all()
    assert (memory[end:] == 7.0).all()


def test_a_refused_sample_changes_nothing_and_a_pickle_goes_on() -> None:
    stage = DynamicRegressorExtension(2, delay_s=0.01, gamma=10.0)
    for i in range(50):
        stage.update((np.sin(i), 1.0), 2.0, i / 1000)
    before = stage._memory.copy()
    with pytest.raises(EventError):
        stage.update((np.nan, 1.0), 2.0, 1.0)
    with pytest.raises(EventOrderError):
        stage.update((0.0, 1.0), 2.0, 0.001)
    assert np.array_equal(before, stage._memory)
    twin = pickle.loads(pickle.dumps(stage))
    assert twin.update((0.5, 1.0), 2.0, 0.06) == stage.update((0.5, 1.0), 2.0, 0.06)
    assert stage.fresh().update((0.5, 1.0), 2.0, 0.0) is None


def test_bounds_are_named() -> None:
    with pytest.raises(ParameterError, match=r"count must lie in \[2, 6\]"):
        DynamicRegressorExtension(7)
    with pytest.raises(ParameterError, match="delay_s"):
        DynamicRegressorExtension(3, delay_s=0.0)
