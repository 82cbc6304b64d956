"""Trajectories: two integrators against each other and against closed forms; seeded signals are functions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from pointpred.errors import DivergenceError, ParameterError
from pointpred_observers import trajectories, trajectory
from pointpred_observers.trajectories import SeededSignal


@pytest.mark.parametrize("integrator", ["rk4", "scipy"])
def test_a_linear_system_follows_its_exponential(integrator: str) -> None:
    a = np.array([[0.0, 1.0], [-4.0, -0.4]])
    times = np.array([0.0, 0.13, 0.7, 2.0])
    states = trajectory(lambda t, x: a @ x, [1.0, -1.0], times, integrator=integrator)
    expected = [expm(a * t) @ [1.0, -1.0] for t in times]
    assert np.allclose(states, expected, atol=1e-10)


def test_rk4_has_its_order() -> None:
    def error(step_s: float) -> float:
        found = trajectory(lambda t, x: np.cos(x) * np.cos(t), [0.2], [0.0, 2.0], step_s=step_s)
        fine = trajectory(lambda t, x: np.cos(x) * np.cos(t), [0.2], [0.0, 2.0], step_s=1e-3)
        return abs(float(found[-1, 0] - fine[-1, 0]))

    assert 12.0 < error(0.2) / error(0.1) < 24.0


@given(st.integers(0, 100), st.sampled_from(["uniform", "normal"]))
@settings(max_examples=10)
def test_a_jumping_disturbance_is_integrated_alike_by_both(seed: int, kind: str) -> None:
    noise = SeededSignal(seed, 1, 0.5, kind=kind, period_s=0.1)

    def field(t: float, x: Any) -> Any:
        return -x + noise(t)

    times = np.arange(0.0, 2.05, 0.1)
    expected, x = [1.0], 1.0
    for t in times[:-1]:
        held = noise(t + 0.05)[0]
        x = held + (x - held) * np.exp(-0.1)
        expected.append(x)
    assert np.allclose(trajectory(field, [1.0], times, step_s=0.01)[:, 0], expected, atol=1e-6)
    adaptive = trajectory(field, [1.0], times, integrator="scipy", step_s=1e-4, tolerance=1e-8)
    assert np.allclose(adaptive[:, 0], expected, atol=1e-6)


def test_a_seeded_signal_is_a_function_of_time() -> None:
    noise, twin = SeededSignal(3, 2, 0.2), SeededSignal(3, 2, 0.2)
    forward = [noise(t) for t in np.arange(0.0, 30.0, 0.01)]
    backward = [twin(t) for t in np.arange(0.0, 30.0, 0.01)[::-1]][::-1]
    assert np.array_equal(forward, backward)
    assert np.abs(forward).max() <= 0.2
    assert np.std(forward) == pytest.approx(0.2 / np.sqrt(3.0), rel=0.03)
    assert not np.array_equal(SeededSignal(4, 2, 0.2)(0.0), noise(0.0))
    assert np.std(
        [SeededSignal(4, 1, 0.3, kind="normal")(t) for t in np.arange(0.0, 9.0, 0.01)]
    ) == pytest.approx(0.3, rel=0.1)


def test_what_blows_up_is_said_with_its_time() -> None:
    with pytest.raises(DivergenceError, match=r"before t = 1\."):
        trajectory(lambda t, x: x * x, [1.0], np.arange(0.0, 3.0, 0.25))
    with pytest.raises(DivergenceError, match="leaves every bound"):
        trajectory(lambda t, x: x * x, [1.0], np.arange(0.0, 3.0, 0.25), integrator="scipy")


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"integrator": "euler"}, "integrator must be one of rk4, scipy, stiff, discrete, received 'euler'"),
        ({"step_s": 0.0}, "step_s must be finite and above 0, received 0"),
        ({"times": [0.0, 0.0]}, "times must increase"),
        ({"start": [np.nan]}, "start must be finite"),
    ],
)
def test_what_cannot_be_simulated(given: dict[str, Any], told: str) -> None:
    asked = {"start": [1.0], "times": [0.0, 1.0], **given}
    with pytest.raises(ParameterError, match=told):
        trajectory(lambda t, x: -x, **asked)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"kind": "pink"}, "kind must be"),
        ({"amplitude": -1.0}, "amplitude must be finite"),
        ({"period_s": 0.0}, "period_s must be finite"),
    ],
)
def test_signals_that_are_none(given: dict[str, Any], told: str) -> None:
    with pytest.raises(ParameterError, match=told):
        SeededSignal(**{"seed": 1, "size": 1, "amplitude": 1.0, **given})


@pytest.mark.parametrize("integrator", ["scipy", "stiff"])
def test_a_start_beyond_what_can_be_computed_ends_at_once(integrator: str) -> None:
    with pytest.raises(DivergenceError, match=r"leaves every bound (near|after) t = 0"):
        trajectory(lambda t, x: -5e3 * x, [1e308], [0.0, 0.5, 1.0], integrator=integrator)


def test_a_field_that_turns_too_fast_ends_after_so_many_values(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trajectories, "CALLS_MOST", 5000)
    with pytest.raises(
        DivergenceError, match="needs more than 7000 values of the field and has reached t = "
    ):
        trajectory(
            lambda t, x: 1e9 * np.array([x[1], -x[0]]), [1.0, 0.0], [0.0, 1.0], integrator="stiff", step_s=1.0
        )
