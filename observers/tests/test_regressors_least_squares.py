"""The start rule of recursive least squares (3.62): exact, or a ridge; nothing else is least squares."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred_observers import RecursiveLeastSquares

SEEDS = st.integers(0, 2**32 - 1)


def problem(seed: int, rows: int = 20) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    return random.standard_normal((rows, 4)) * [1.0, 5.0, 0.2, 2.0], random.standard_normal(rows)


def printed(w: np.ndarray, y: np.ndarray, first: np.ndarray, theta: np.ndarray) -> np.ndarray:
    """The recursion (3.62) as it stands, from a matrix ``first`` that stands for the samples before."""
    total = first.copy()
    for row, output in zip(w, y, strict=True):
        total = total + np.outer(row, row)
        theta = theta + np.linalg.solve(total, row) * (output - row @ theta)
    return theta


def ordinary(w: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.asarray(np.linalg.lstsq(w, y, rcond=None)[0])


def test_the_printed_matrix_is_singular_for_the_first_three_samples() -> None:
    w, _ = problem(1)
    for k in range(1, 4):
        assert np.linalg.matrix_rank(w[:k].T @ w[:k]) == k < 4


@given(seed=SEEDS)
def test_only_the_exact_start_ends_in_ordinary_least_squares(seed: int) -> None:
    """A_k (theta_k - ols_k) = A_0 (theta_0 - ols_k): the start is never forgotten."""
    w, y = problem(seed)
    random = np.random.default_rng(seed + 1)
    first, theta = 0.5 * np.eye(4), random.standard_normal(4)
    wanted, total = ordinary(w, y), w.T @ w
    found = printed(w, y, first, theta)
    assert (total + first) @ (found - wanted) == pytest.approx(first @ (theta - wanted), abs=1e-8)
    # Started from the batch solution of the first four samples, the recursion is ordinary least squares.
    batch = printed(w[4:], y[4:], w[:4].T @ w[:4], np.linalg.solve(w[:4], y[:4]))
    assert batch == pytest.approx(wanted, rel=1e-5, abs=1e-5)
    # Waiting until the matrix can be inverted, and starting from zero then, is not.
    late = printed(w[3:], y[3:], w[:3].T @ w[:3], np.zeros(4))
    assert np.abs(late - wanted).max() > 1e-3 * np.abs(np.linalg.solve(total, w[:3].T @ w[:3] @ wanted)).max()


@settings(max_examples=25)
@given(seed=SEEDS)
def test_the_default_start_is_exact_at_every_sample(seed: int) -> None:
    w, y = problem(seed)
    stage = RecursiveLeastSquares(4, least_excitation=1e-13)
    for k in range(len(w)):
        stage.update(w[k], float(y[k]))
        if k < 3:
            assert stage.fit().values is None
        else:
            wanted = ordinary(w[: k + 1], y[: k + 1])
            assert stage.fit().values == pytest.approx(wanted, rel=1e-5, abs=1e-5 * np.abs(wanted).max())


@settings(max_examples=25)
@given(seed=SEEDS, ridge=st.floats(1e-3, 1e3))
def test_a_ridge_is_ridge_regression_at_every_sample(seed: int, ridge: float) -> None:
    w, y = problem(seed)
    start = np.random.default_rng(seed).standard_normal(4)
    stage = RecursiveLeastSquares(4, ridge=ridge, start=start)
    for k in range(len(w)):
        stage.update(w[k], float(y[k]))
        seen, said = w[: k + 1], y[: k + 1]
        wanted = start + np.linalg.solve(seen.T @ seen + ridge * np.eye(4), seen.T @ (said - seen @ start))
        assert stage.fit().values == pytest.approx(wanted, rel=1e-6, abs=1e-8)
        rest = said - seen @ wanted
        square = rest @ rest + ridge * (wanted - start) @ (wanted - start)
        assert stage.fit().residual ** 2 * (k + 1) == pytest.approx(square, rel=1e-6, abs=1e-9)
    assert stage.fit().values == pytest.approx(printed(w, y, ridge * np.eye(4), start), rel=1e-5, abs=1e-7)


def test_a_ridge_fades_like_a_sample_and_comes_back_after_reset() -> None:
    w, y = problem(4)
    stage = RecursiveLeastSquares(4, ridge=2.0, start=[1.0, 2.0, 3.0, 4.0], forgetting=0.8)
    runs = []
    for _ in range(2):
        for row, output in zip(w, y, strict=True):
            stage.update(row, float(output))
        runs.append(stage.fit().values)
        stage.reset()
    assert runs[0] == runs[1]
    weights = 0.8 ** np.arange(19, -1, -1.0)
    left = 2.0 * 0.8**20
    normal = (w.T * weights) @ w + left * np.eye(4)
    wanted = np.linalg.solve(normal, (w.T * weights) @ y + left * np.array([1.0, 2.0, 3.0, 4.0]))
    assert runs[0] == pytest.approx(wanted, rel=1e-7)
