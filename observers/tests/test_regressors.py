"""Gradient regressors against differential equations and literal recursions; what bad input gets."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import integrate, linalg

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.regression import gradient
from pointpred_observers import GradientRegressor

SEEDS = st.integers(0, 2**32 - 1)


def definite(random: np.random.Generator, count: int) -> np.ndarray:
    root = random.standard_normal((count, count))
    return np.asarray(root @ root.T + 0.3 * np.eye(count))


def data(t: np.ndarray, outputs: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """A regressor of 3 unknowns and outputs that no constants explain."""
    waves = np.sin(np.multiply.outer(t, np.arange(1.0, 3.0 * outputs + 1.0)))
    return waves.reshape(len(t), outputs, 3), np.cos(np.multiply.outer(t, np.arange(2.0, outputs + 2.0)))


@settings(max_examples=25)
@given(seed=SEEDS, h=st.floats(0.0, 3.0))
def test_one_held_sample_is_followed_exactly(seed: int, h: float) -> None:
    random = np.random.default_rng(seed)
    w, start, gain = random.standard_normal(3), random.standard_normal(3), definite(random, 3)
    theta = start.copy()
    gradient.descend_along(theta, w, gain, 0.7, h)
    flow = np.zeros((4, 4))
    flow[:3, :3], flow[:3, 3] = -np.outer(gain @ w, w), 0.7 * gain @ w
    wanted = linalg.expm(flow * h) @ [*start, 1.0]
    assert theta == pytest.approx(wanted[:3], abs=1e-9)


@pytest.mark.parametrize("outputs", [1, 2])
def test_it_follows_its_differential_equation_to_second_order(outputs: int) -> None:
    gain = definite(np.random.default_rng(3), 3)
    start = np.array([1.0, -2.0, 0.5])

    def slope(t: float, theta: np.ndarray) -> np.ndarray:
        d, y = data(np.array([t]), outputs)
        return np.asarray(gain @ d[0].T @ (y[0] - d[0] @ theta))

    wanted = integrate.solve_ivp(slope, (0.0, 2.0), start, rtol=1e-11, atol=1e-12).y[:, -1]
    errors = []
    for steps in (40, 80, 160):
        t = np.linspace(0.0, 2.0, steps + 1)
        stage = GradientRegressor(3, outputs=outputs, gain=gain, start=start)
        for moment, d, y in zip(t, *data(t, outputs), strict=True):
            found = stage.update(d, y, moment)
        errors.append(float(np.abs(found - wanted).max()))
    assert errors[2] < 1e-2
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


@settings(max_examples=40)
@given(seed=SEEDS, exponent=st.floats(-3.0, 12.0))
def test_without_noise_no_gain_makes_the_error_grow(seed: int, exponent: float) -> None:
    random = np.random.default_rng(seed)
    gain, truth = definite(random, 3) * 10.0**exponent, random.standard_normal(3)
    weight = np.linalg.inv(gain) * 10.0**exponent
    stage = GradientRegressor(3, outputs=2, gain=gain)
    size = float(truth @ weight @ truth)
    for t in np.cumsum(random.uniform(0.0, 0.4, 25)):
        d = random.standard_normal((2, 3))
        error = stage.update(d, d @ truth, t) - truth
        assert error @ weight @ error <= size * (1.0 + 1e-9) + 1e-9
        size = float(error @ weight @ error)


@settings(max_examples=40)
@given(seed=SEEDS, outputs=st.integers(1, 3))
def test_the_discrete_law_is_the_printed_recursion(seed: int, outputs: int) -> None:
    random = np.random.default_rng(seed)
    gain = definite(random, 3)
    rows = random.standard_normal((12, outputs, 3))
    gain *= 1.9 / max(np.trace(d @ gain @ d.T) for d in rows)
    stage = GradientRegressor(3, outputs=outputs, gain=gain, time="discrete")
    estimate = np.zeros(3)
    for d in rows:
        y = random.standard_normal(outputs)
        estimate = estimate + gain @ d.T @ (y - d @ estimate)
        assert stage.update(d, y) == pytest.approx(estimate, abs=1e-12)


def test_a_step_too_steep_is_refused_and_would_diverge() -> None:
    stage = GradientRegressor(1, gain=0.55, time="discrete")
    assert stage.update([1.0], 1.0) == pytest.approx([0.55])
    kept = pickle.dumps(stage)
    with pytest.raises(EventError, match=r"trace of D G D' must lie below 2.*normalised=True"):
        stage.update([2.0], 2.0)
    assert pickle.dumps(stage) == kept
    error = 1.0
    for _ in range(20):
        error -= 0.55 * 2.0 * 2.0 * error
    assert abs(error) > 10.0
    normalised = GradientRegressor(1, gain=0.55, time="discrete", normalised=True)
    for _ in range(20):
        found = normalised.update([2.0], 2.0)
    assert found == pytest.approx([1.0], abs=1e-6)


def test_a_gain_that_is_only_nonsingular_is_refused_and_would_diverge() -> None:
    """The print asks for a nonsingular gain before (3.46); the sign decides."""
    with pytest.raises(ParameterError, match="positive definite, its least eigenvalue is -1"):
        GradientRegressor(2, gain=[[1.0, 0.0], [0.0, -1.0]])

    def slope(t: float, theta: np.ndarray) -> np.ndarray:
        d = np.array([1.0, np.sin(t)])
        return np.asarray(np.diag([1.0, -1.0]) @ d * (d @ (np.array([3.0, 5.0]) - theta)))

    assert np.abs(integrate.solve_ivp(slope, (0.0, 30.0), [0.0, 0.0]).y[:, -1]).max() > 1e3


def test_a_table_gives_what_single_samples_give() -> None:
    t = np.cumsum(np.random.default_rng(5).uniform(0.0, 0.05, 60))
    d, y = data(t, 2)
    rows = np.concatenate([t[:, None], d.reshape(60, -1), y], axis=1)
    begin = np.zeros(60, np.bool_)
    begin[40] = True
    stage, single = GradientRegressor(3, outputs=2, gain=2.0), GradientRegressor(3, outputs=2, gain=2.0)
    table = stage.walk(begin, rows)
    for i in range(60):
        if begin[i]:
            single.reset()
        assert single.update(d[i], y[i], t[i]).tobytes() == table[i].tobytes()
    twin = pickle.loads(pickle.dumps(single))
    assert twin.update(d[0], y[0], 9.0).tobytes() == single.update(d[0], y[0], 9.0).tobytes()
    spoiled = rows.copy()
    spoiled[30, 3], spoiled[33, 0] = np.nan, -1.0
    answers = GradientRegressor(3, outputs=2, gain=2.0).walk(begin, spoiled)
    assert np.isnan(answers).any(axis=1).nonzero()[0].tolist() == [30, 33]
    left = GradientRegressor(3, outputs=2, gain=2.0).walk(
        np.delete(begin, [30, 33]), np.delete(rows, [30, 33], 0)
    )
    assert answers[39].tobytes() == left[37].tobytes()
    fresh = single.fresh()
    assert fresh.update(d[0], y[0], t[0]).tolist() == [0.0, 0.0, 0.0]


def test_what_is_refused_changes_nothing() -> None:
    stage = GradientRegressor(2)
    stage.update([1.0, 2.0], 3.0, 1.0)
    stage.update([1.0, 1.0], 3.0, 1.5)
    kept = pickle.dumps(stage)
    wrong: list[tuple[Any, Any, Any, type[EventError], str]] = [
        ([1.0], 1.0, 2.0, EventError, "regressor"),
        ([1.0, 2.0], [1.0, 2.0], 2.0, EventError, "output"),
        ([1.0, np.nan], 1.0, 2.0, EventError, "regressor"),
        (["a", 1.0], 1.0, 2.0, EventError, "regressor"),
        ([1.0, 2.0], 1.0, 1.0, EventOrderError, "t"),
        ([1.0, 2.0], 1.0, np.inf, EventError, "t"),
        ([1.0, 2.0], 1.0, None, EventError, "t"),
    ]
    for regressor, output, t, kind, field in wrong:
        with pytest.raises(kind) as refused:
            stage.update(regressor, output, t)
        assert refused.value.field == field
        assert pickle.dumps(stage) == kept


REFUSED: list[dict[str, Any]] = [
    {"count": 0},
    {"count": 2.5},
    {"count": 2, "outputs": 33},
    {"count": 2, "gain": 0.0},
    {"count": 2, "gain": [1.0, 2.0, 3.0]},
    {"count": 2, "gain": [[1.0, 2.0], [0.0, 1.0]]},
    {"count": 2, "gain": "much"},
    {"count": 2, "time": "both"},
    {"count": 2, "normalised": True},
    {"count": 2, "start": [1.0]},
    {"count": 2, "start": "here"},
]


@pytest.mark.parametrize("parameters", REFUSED)
def test_the_constructor_names_the_wrong_parameter(parameters: dict[str, Any]) -> None:
    with pytest.raises(ParameterError) as refused:
        GradientRegressor(**parameters)
    assert refused.value.field == list(parameters)[-1]
    assert refused.value.value == parameters[refused.value.field]
