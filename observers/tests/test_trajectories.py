"""Trajectories against closed forms, jumps and what blows up; seeded signals are functions of time."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from pointpred.errors import DivergenceError
from pointpred_observers import trajectory
from pointpred_observers.simulations import trajectories
from pointpred_observers.simulations.trajectories import SeededSignal


def test_a_linear_system_follows_its_exponential() -> None:
    a = np.array([[0.0, 1.0], [-4.0, -0.4]])
    times = np.array([0.0, 0.13, 0.7, 2.0])
    states = trajectory(lambda t, x: a @ x, [1.0, -1.0], times)
    expected = [expm(a * t) @ [1.0, -1.0] for t in times]
    assert np.allclose(states, expected, atol=1e-8)


@given(st.integers(0, 100))
@settings(max_examples=10)
def test_no_jump_of_a_disturbance_is_stepped_over(seed: int) -> None:
    noise = SeededSignal(seed, 1, 0.5, period_s=0.1)
    times = np.arange(0.0, 2.05, 0.1)
    expected, x = [1.0], 1.0
    for t in times[:-1]:
        held = noise(t + 0.05)[0]
        x = held + (x - held) * np.exp(-0.1)
        expected.append(x)
    found = trajectory(lambda t, x: -x + noise(t), [1.0], times)
    assert np.allclose(found[:, 0], expected, atol=1e-8)


def test_a_seeded_signal_is_a_function_of_time() -> None:
    noise, twin = SeededSignal(3, 2, 0.2), SeededSignal(3, 2, 0.2)
    forward = [noise(t) for t in np.arange(0.0, 30.0, 0.01)]
    backward = [twin(t) for t in np.arange(0.0, 30.0, 0.01)[::-1]][::-1]
    assert np.array_equal(forward, backward)
    assert np.abs(forward).max() <= 0.2
    assert np.std(forward) == pytest.approx(0.2 / np.sqrt(3.0), rel=0.03)
    assert not np.array_equal(SeededSignal(4, 2, 0.2)(0.0), noise(0.0))


def test_what_blows_up_is_said_with_its_time() -> None:
    with pytest.raises(DivergenceError, match=r"near t = 1\b"):
        trajectory(lambda t, x: x * x, [1.0], np.arange(0.0, 3.0, 0.25))


def test_a_start_beyond_what_can_be_computed_ends_at_once() -> None:
    with pytest.raises(DivergenceError, match=r"leaves every bound (near|after) t = 0"):
        trajectory(lambda t, x: -5e3 * x, [1e308], [0.0, 0.5, 1.0])


def test_a_field_that_turns_too_fast_ends_after_so_many_values(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trajectories, "CALLS_MOST", 5000)
    with pytest.raises(
        DivergenceError, match="needs more than 7000 values of the field and has reached t = "
    ):
        trajectory(lambda t, x: 1e9 * np.array([x[1], -x[0]]), [1.0, 0.0], [0.0, 1.0])
