"""Measures of excitation and Theorem 3.3.3 against quadrature, brute force and closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import integrate, linalg

from pointpred.errors import UndecidedError
from pointpred_observers import persistent_excitation
from pointpred_observers.regressors.excitation import Excitation
from pointpred_observers.thesis import linear_independence, regression_margin

SEEDS = st.integers(0, 2**32 - 1)


def discrete(signal: Any, window: Any) -> Excitation:
    return persistent_excitation(None, signal, window, time="discrete")


def test_the_level_is_the_least_eigenvalue_of_the_integral() -> None:
    def phi(s: float) -> np.ndarray:
        return np.array([np.sin(s), np.cos(2.0 * s), np.exp(-0.2 * s)])

    window = 1.7
    t = np.linspace(0.0, 6.0, 6001)
    found = persistent_excitation(t, np.array([phi(s) for s in t]), window)

    def least(start: float) -> float:
        entries = [
            [integrate.quad(lambda s: phi(s)[i] * phi(s)[j], start, start + window)[0] for j in range(3)]  # noqa: B023
            for i in range(3)
        ]
        return float(np.linalg.eigvalsh(np.array(entries))[0])

    assert found.level == pytest.approx(least(found.at), rel=1e-4)
    assert found.level <= min(least(start) for start in np.linspace(0.0, 4.3, 44)) * (1.0 + 1e-4)


@settings(max_examples=25)
@given(seed=SEEDS, outputs=st.integers(1, 2))
def test_a_signal_on_lines_is_integrated_exactly_however_it_is_sampled(seed: int, outputs: int) -> None:
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.05, 0.5, 12))
    signal = random.standard_normal((12, outputs, 3))
    window = 0.6 * (t[-1] - t[0])
    whole = persistent_excitation(t, signal, window)
    start = whole.at
    fine = np.unique(np.concatenate([t, np.linspace(start, start + window, 601)]))
    fine = fine[(fine >= start) & (fine <= start + window)]
    between = np.array(
        [[[np.interp(s, t, signal[:, p, i]) for i in range(3)] for p in range(outputs)] for s in fine]
    )
    total = integrate.simpson(np.einsum("kpi,kpj->kij", between, between), x=fine, axis=0)
    assert whole.level == pytest.approx(max(float(np.linalg.eigvalsh(total)[0]), 0.0), rel=1e-3, abs=1e-6)


@settings(max_examples=40)
@given(seed=SEEDS, count=st.integers(1, 30), window=st.integers(1, 30))
def test_the_discrete_level_is_that_of_brute_force(seed: int, count: int, window: int) -> None:
    random = np.random.default_rng(seed)
    signal = random.standard_normal((count + window - 1, 2, 3))
    sums = [sum(d.T @ d for d in signal[k : k + window]) for k in range(count)]
    least = np.array([np.linalg.eigvalsh(one)[0] for one in sums])
    found = discrete(signal, window)
    assert found.level == pytest.approx(max(float(least.min()), 0.0), abs=1e-12)
    assert least[int(found.at)] == pytest.approx(least.min(), abs=1e-12)
    weakest = np.array(found.direction)
    assert weakest @ sums[int(found.at)] @ weakest == pytest.approx(least.min(), abs=1e-12)


@settings(max_examples=25)
@given(seed=SEEDS)
def test_what_stays_in_a_plane_is_not_excited_and_the_direction_says_where(seed: int) -> None:
    random = np.random.default_rng(seed)
    normal = random.standard_normal(3)
    normal /= np.linalg.norm(normal)
    t = np.linspace(0.0, 5.0, 301)
    signal = np.sin(np.outer(t, [1.0, 2.3, 3.1]) + random.uniform(0.0, 6.0, 3))
    flat = signal - np.outer(signal @ normal, normal)
    found = persistent_excitation(t, flat, 2.0)
    assert found.level < 1e-12 < persistent_excitation(t, signal, 2.0).level
    assert abs(float(np.array(found.direction) @ normal)) == pytest.approx(1.0, abs=1e-6)


@settings(max_examples=25)
@given(seed=SEEDS)
def test_a_fixed_combination_is_not_independent_and_another_frequency_is(seed: int) -> None:
    random = np.random.default_rng(seed)
    t = np.linspace(0.0, 12.0, 1201)
    both = np.stack([np.sin(t), np.cos(t)], axis=1)
    mixed = both @ random.uniform(0.5, 2.0, (2, 2))[:, :1]
    assert linear_independence(t, both, mixed, 1.5) < 1e-9
    assert linear_independence(t, mixed, both, 1.5) < 1e-9
    other = np.sin(2.0 * t + random.uniform(0.0, 6.0))[:, None]
    assert linear_independence(t, both, other, 1.5) > 0.1


def test_a_window_of_whole_periods_hides_independence() -> None:
    """Why the definition asks for some window: over whole periods these regressions stand still."""
    t = np.linspace(0.0, 8.0 * np.pi, 8001)
    sine, cosine = np.sin(t)[:, None], np.cos(t)[:, None]
    assert linear_independence(t, sine, 1.0 + cosine, 2.0 * np.pi) < 1e-3
    assert linear_independence(t, sine, 1.0 + cosine, 1.0) > 0.5


def test_p_solves_its_equation() -> None:
    """J that rotates at 1 rad/s: in its frame P is constant, (E - W) P + P (E + W) = I."""
    t = np.linspace(0.0, 2.0 * np.pi, 1001)
    j = np.stack([np.cos(t), np.sin(t)], axis=1)
    found = regression_margin(t, j, np.full(1001, 0.2), 1.0)
    turn, along = np.array([[0.0, -1.0], [1.0, 0.0]]), np.diag([1.0, 0.0])
    p = linalg.solve_continuous_lyapunov(along - turn, np.eye(2))
    assert np.linalg.eigvalsh(found.P) == pytest.approx(np.linalg.eigvalsh(p), rel=1e-3)
    worst = np.linalg.eigvalsh(0.5 * (p @ along + along @ p))[-1]
    assert found.margin == pytest.approx(0.5 - 0.2 * worst, abs=1e-3)
    assert regression_margin(t, j, np.full(1001, 0.2), 1.0, flattest=1.0).margin == pytest.approx(0.5)


def test_the_lyapunov_function_falls_as_the_margin_says() -> None:
    """Where the margin is positive, e'Pe falls along the error's equation by twice it; here D1 is 0.2."""
    t = np.linspace(0.0, 2.0 * np.pi, 1001)
    j = np.stack([np.cos(t), np.sin(t)], axis=1)
    margin = regression_margin(t, j, np.full(1001, 0.2), 1.0).margin
    turn = np.array([[0.0, -1.0], [1.0, 0.0]])
    still = linalg.solve_continuous_lyapunov(np.diag([1.0, 0.0]) - turn, np.eye(2))
    random = np.random.default_rng(1)
    for _ in range(200):
        at, e, x = random.uniform(0.0, 6.0), random.standard_normal(2), 2.0 * random.standard_normal(2)
        frame = linalg.expm(turn * at)
        row, p = frame[:, 0], frame @ still @ frame.T
        fall = 0.8 * row @ e + 0.2 * (np.arctan(row @ x) - np.arctan(row @ (x - e)))
        slope = e @ (turn @ p - p @ turn) @ e - 2.0 * fall * (row @ p @ e)
        assert slope <= -2.0 * margin * (e @ e) + 1e-9


def test_without_excitation_p_does_not_settle() -> None:
    t = np.linspace(0.0, 1.0, 50)
    with pytest.raises(UndecidedError, match="no excitation"):
        regression_margin(t, np.ones((50, 2)), np.full(50, 0.5), 1.0)
