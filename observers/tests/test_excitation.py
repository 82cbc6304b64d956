"""Measures of excitation against quadrature, brute force, and signals known not to excite."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import integrate

from pointpred.errors import ParameterError
from pointpred_observers import persistent_excitation
from pointpred_observers.regressors.excitation import discrete_excitation
from pointpred_observers.thesis import linear_independence

SEEDS = st.integers(0, 2**32 - 1)


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
    found = discrete_excitation(signal, window)
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


REFUSED: list[tuple[Any, str]] = [
    (lambda: persistent_excitation([0.0, 0.0], [[1.0], [1.0]], 0.1), "finite, increasing times"),
    (lambda: persistent_excitation([0.0], [[1.0]], 0.1), "at least two finite"),
    (lambda: persistent_excitation([0.0, 1.0], [[1.0], [np.nan]], 0.1), "must be finite in every sample"),
    (lambda: persistent_excitation([0.0, 1.0], [[1.0]], 0.1), r"needs shape \(2, n\).*received \(1, 1, 1\)"),
    (lambda: persistent_excitation([0.0, 1.0], [[1.0], [1.0]], 1.5), r"window_s must lie in \(0, 1\].*1.5"),
    (lambda: persistent_excitation([0.0, 1.0], [[1.0], [1.0]], 0.0), "window_s must lie in .*received 0"),
    (lambda: discrete_excitation([[1.0]], 2), r"window must be a whole number in \[1, 1\], received 2"),
    (lambda: discrete_excitation([[1.0]], True), "window must be a whole number"),
    (lambda: discrete_excitation(np.zeros((0, 2)), 1), "needs shape"),
    (
        lambda: linear_independence([0.0, 1.0, 2.0], [[0.0], [0.0], [1.0]], [[1.0], [1.0], [1.0]], 1.0),
        "both signals must be excited over every window of 1 s",
    ),
    (
        lambda: linear_independence([0.0, 1.0], np.ones((2, 1, 2)), np.ones((2, 2, 2)), 1.0),
        "signals need as many outputs, received 1 and 2",
    ),
]


@pytest.mark.parametrize(("call", "message"), REFUSED)
def test_what_is_wrong_is_said(call: Any, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        call()
