"""Recursive least squares against numpy's least squares with weights."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.regression import DynamicRegressorExtension, RecursiveLeastSquares, least_squares


def weighted(rows: np.ndarray, outputs: np.ndarray, weights: np.ndarray) -> np.ndarray:
    root = np.sqrt(weights)
    return np.asarray(np.linalg.lstsq(rows * root[:, None], outputs * root, rcond=None)[0])


@pytest.mark.parametrize("forgetting", [1.0, 0.99, 0.7])
@pytest.mark.parametrize("count", [1, 2, 5, 8])
def test_it_is_weighted_least_squares(count: int, forgetting: float) -> None:
    rng = np.random.default_rng(count)
    rows, outputs = rng.standard_normal((60, count)), rng.standard_normal(60)
    stage = RecursiveLeastSquares(count, forgetting=forgetting)
    for row, output in zip(rows, outputs, strict=True):
        stage.update(row, output)
    weights = forgetting ** np.arange(59, -1, -1.0)
    wanted = weighted(rows, outputs, weights)
    found = stage.fit()
    assert found.values == pytest.approx(wanted, rel=1e-8)
    left = float(np.sum(weights * (outputs - rows @ wanted) ** 2) / weights.sum())
    assert found.residual == pytest.approx(np.sqrt(left), rel=1e-8)
    assert found.effective_samples == pytest.approx(weights.sum())
    assert found.condition == pytest.approx(
        np.linalg.cond(rows * np.sqrt(weights)[:, None] / np.linalg.norm(rows.T * np.sqrt(weights), axis=1)),
        rel=1e-6,
    )


def test_forgetting_by_time_weighs_by_age() -> None:
    rng = np.random.default_rng(7)
    t = np.cumsum(rng.uniform(0.0, 0.02, 50))
    rows, outputs = rng.standard_normal((50, 3)), rng.standard_normal(50)
    stage = RecursiveLeastSquares(3, forgetting_rate=4.0)
    for i in range(50):
        stage.update(rows[i], outputs[i], t[i])
    assert stage.fit().values == pytest.approx(weighted(rows, outputs, np.exp(-4.0 * (t[-1] - t))), rel=1e-8)


def test_standard_errors_are_those_of_the_textbook() -> None:
    rng = np.random.default_rng(8)
    rows = rng.standard_normal((40, 3))
    outputs = rows @ [1.0, -2.0, 0.5] + rng.standard_normal(40)
    stage = RecursiveLeastSquares(3)
    for row, output in zip(rows, outputs, strict=True):
        stage.update(row, output)
    rest = outputs - rows @ weighted(rows, outputs, np.ones(40))
    wanted = np.sqrt(rest @ rest / 37 * np.diag(np.linalg.inv(rows.T @ rows)))
    assert stage.fit().errors == pytest.approx(wanted, rel=1e-8)


def test_powers_of_small_speeds_keep_digits_that_an_inverse_loses() -> None:
    truth = np.array([2.0, -3.0, 40.0, -500.0, 6000.0])
    rows = np.linspace(0.06, 0.1, 400)[:, None] ** np.arange(1, 6)
    stage = RecursiveLeastSquares(5, least_excitation=1e-10)
    for row in rows:
        stage.update(row, row @ truth)
    inverted = np.linalg.inv(rows.T @ rows) @ (rows.T @ (rows @ truth))
    ours, theirs = (np.abs(v / truth - 1.0).max() for v in (np.array(stage.fit().values), inverted))
    assert ours < 1e-6
    assert theirs > 100.0 * ours


@given(st.integers(0, 1000), st.lists(st.integers(-9, 9), min_size=3, max_size=3))
def test_units_do_not_matter(seed: int, exponents: list[int]) -> None:
    rng = np.random.default_rng(seed)
    rows, outputs = rng.standard_normal((20, 3)), rng.standard_normal(20)
    plain, scaled = RecursiveLeastSquares(3), RecursiveLeastSquares(3)
    unit = 10.0 ** np.array(exponents)
    for row, output in zip(rows, outputs, strict=True):
        plain.update(row, output)
        scaled.update(row * unit, output)
    assert np.array(scaled.fit().values) * unit == pytest.approx(np.array(plain.fit().values), rel=1e-7)
    assert scaled.fit().condition == pytest.approx(plain.fit().condition, rel=1e-7)


def test_what_is_not_excited_is_named_and_not_returned() -> None:
    stage = RecursiveLeastSquares(4)
    assert stage.fit().unexcited == (0, 1, 2, 3)
    for v in (0.1, 0.2):
        for _ in range(100):
            stage.update(v ** np.arange(4), v)
    found = stage.fit()
    assert (found.values, found.errors, found.unexcited) == (None, None, (2, 3))
    assert found.condition == np.inf


def test_the_compiled_solution_is_the_fit() -> None:
    rng = np.random.default_rng(9)
    stage = RecursiveLeastSquares(4)
    for row in rng.standard_normal((30, 4)):
        stage.update(row, row.sum() + rng.standard_normal())
    found = np.zeros(4)
    regression = least_squares.parts(least_squares.Memory(stage._memory).numbers, 4)
    assert least_squares.solve(regression, 1e-6, found)
    assert stage.fit().values == pytest.approx(found, rel=1e-9)
    assert not least_squares.solve(least_squares.parts(np.zeros(24), 4), 1e-6, found)


def test_forgetting_without_excitation_is_said_and_stays_finite() -> None:
    stage = RecursiveLeastSquares(2, forgetting=0.9)
    stage.update((1.0, 2.0), 3.0)
    stage.update((1.0, -1.0), 0.0)
    for _ in range(20000):
        stage.update((1.0, 1.0), 2.0)
    assert stage.fit().unexcited == (1,)
    assert np.isfinite(stage._memory).all()


def test_a_refused_sample_changes_nothing() -> None:
    stage = RecursiveLeastSquares(2)
    stage.update((1.0, 2.0), 3.0, 1.0)
    before = stage._memory.copy()
    for regressor, output, t in (((1.0,), 1.0, 2.0), ((1.0, np.nan), 1.0, 2.0), ((1.0, 1.0), np.inf, 2.0)):
        with pytest.raises(EventError):
            stage.update(regressor, output, t)
    with pytest.raises(EventOrderError, match=r"0\.5 s after 1\.0 s"):
        stage.update((1.0, 2.0), 3.0, 0.5)
    assert np.array_equal(before, stage._memory)


def test_reset_equals_fresh_and_bounds_are_named() -> None:
    stage = RecursiveLeastSquares(2, forgetting=0.5)
    stage.update((1.0, 2.0), 3.0)
    stage.reset()
    assert np.array_equal(stage._memory, stage.fresh()._memory)
    with pytest.raises(ParameterError, match=r"forgetting must lie in .* received 1\.5"):
        RecursiveLeastSquares(2, forgetting=1.5)
    with pytest.raises(ParameterError, match="whole number"):
        RecursiveLeastSquares(2.5)  # type: ignore[arg-type]


def test_a_sample_without_a_time_takes_no_time() -> None:
    timed, twin = RecursiveLeastSquares(2, forgetting_rate=3.0), RecursiveLeastSquares(2, forgetting_rate=3.0)
    for row, output, t in (((1.0, 2.0), 3.0, 5.0), ((1.0, -1.0), 1.0, None), ((1.0, 0.5), 2.0, 5.5)):
        timed.update(row, output, t)
        twin.update(row, output, 5.0 if t is None else t)
    assert np.array_equal(timed._memory, twin._memory)
    first = RecursiveLeastSquares(2, forgetting_rate=3.0)
    first.update((1.0, 2.0), 3.0)
    first.update((1.0, -1.0), 1.0, -7.0)  # no time was told before: nothing runs backwards
    assert first.fit().effective_samples == 2.0


@pytest.mark.parametrize(
    ("regressor", "output", "t"),
    [
        ((1.0, 2.0), "three", 1.0),
        ((1.0, 2.0), None, 1.0),
        ((1.0, 2.0), [1.0, 2.0], 1.0),
        (("a", 2.0), 1.0, 1.0),
        ((1.0, 2.0), 1.0, "late"),
        ((1.0, 2.0), 1.0, np.nan),
    ],
)
def test_what_is_no_number_is_refused(regressor: Any, output: Any, t: Any) -> None:
    for stage in (RecursiveLeastSquares(2), DynamicRegressorExtension(2)):
        stage.update((1.0, 2.0), 3.0, 1.0)
        before = stage._memory.copy()
        with pytest.raises(EventError, match="must be"):
            stage.update(regressor, output, t)
        assert np.array_equal(before, stage._memory)
