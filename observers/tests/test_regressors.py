"""Regressors against differential equations and literal recursions; what bad input gets."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import integrate, linalg

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred.regression import gradient
from pointpred_observers import GradientRegressor, NonlinearRegressor

SEEDS = st.integers(0, 2**32 - 1)
TRUTH = np.array([3.0, 5.0])


def definite(random: np.random.Generator, count: int) -> np.ndarray:
    root = random.standard_normal((count, count))
    return np.asarray(root @ root.T + 0.3 * np.eye(count))


def data(t: np.ndarray, outputs: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """A regressor of 3 unknowns and outputs that no constants explain."""
    waves = np.sin(np.multiply.outer(t, np.arange(1.0, 3.0 * outputs + 1.0)))
    return waves.reshape(len(t), outputs, 3), np.cos(np.multiply.outer(t, np.arange(2.0, outputs + 2.0)))


def saturating(t: float) -> tuple[np.ndarray, float, float]:
    """J, D1 and y of a sensor that saturates, with a disturbance."""
    j, weight = np.array([1.0, np.sin(t)]), float(np.sin(5.0 * t) ** 2)
    s = float(j @ TRUTH)
    return j, weight, (1.0 - weight) * s + weight * np.arctan(s) + 0.3 * np.cos(t)


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


def errors_of(make: Callable[[], Any], sample: Any, slope: Any, start: Any, steps: Any) -> list[float]:
    """How far a regressor ends from the solution of its equation, for so many steps over 2 s."""
    wanted = integrate.solve_ivp(slope, (0.0, 2.0), start, rtol=1e-11, atol=1e-12, max_step=0.02).y[:, -1]
    errors = []
    for count in steps:
        stage = make()
        for t in np.linspace(0.0, 2.0, count + 1):
            found = stage.update(*sample(t), t)
        errors.append(float(np.abs(found - wanted).max()))
    return errors


@pytest.mark.parametrize("outputs", [1, 2])
def test_it_follows_its_differential_equation_to_second_order(outputs: int) -> None:
    gain, start = definite(np.random.default_rng(3), 3), np.array([1.0, -2.0, 0.5])

    def sample(t: float) -> tuple[np.ndarray, np.ndarray]:
        d, y = data(np.array([t]), outputs)
        return d[0], y[0]

    def slope(t: float, theta: np.ndarray) -> np.ndarray:
        d, y = sample(t)
        return np.asarray(gain @ d.T @ (y - d @ theta))

    def make() -> GradientRegressor:
        return GradientRegressor(3, outputs=outputs, gain=gain, start=start)

    errors = errors_of(make, sample, slope, start, (40, 80, 160))
    assert errors[2] < 1e-2
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize("gain", [0.75, 60.0])
def test_the_nonlinear_one_follows_its_differential_equation_to_second_order(gain: float) -> None:
    def slope(t: float, theta: np.ndarray) -> np.ndarray:
        j, weight, y = saturating(t)
        s = j @ theta
        return np.asarray(gain * j * (y - (1.0 - weight) * s - weight * np.arctan(s)))

    start = [1.0, 1.0]
    errors = errors_of(
        lambda: NonlinearRegressor(2, gain=gain, start=start), saturating, slope, start, (100, 200)
    )
    assert errors[1] < 2e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.25)


def test_without_the_nonlinear_sensor_it_is_the_gradient_estimator() -> None:
    """Remark 3.3.3: D1 = 0 is linear regression."""
    one, other = NonlinearRegressor(2, gain=2.0), GradientRegressor(2, gain=2.0)
    for t in np.arange(0.0, 3.0, 0.005):
        j = np.array([1.0, np.sin(t)])
        found, wanted = one.update(j, 0.0, j @ TRUTH, t), other.update(j, j @ TRUTH, t)
    assert found == pytest.approx(wanted, abs=2e-3)


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
    with pytest.raises(EventError, match=r"trace of D G D' must lie below 2.*smaller gain"):
        stage.update([2.0], 2.0)
    assert pickle.dumps(stage) == kept
    error = 1.0
    for _ in range(20):
        error -= 0.55 * 2.0 * 2.0 * error
    assert abs(error) > 10.0


def test_a_gain_that_is_only_nonsingular_is_refused_and_would_diverge() -> None:
    """The print asks for a nonsingular gain before (3.46); the sign decides."""
    with pytest.raises(ParameterError, match="positive definite, its least eigenvalue is -1"):
        GradientRegressor(2, gain=[[1.0, 0.0], [0.0, -1.0]])

    def slope(t: float, theta: np.ndarray) -> np.ndarray:
        d = np.array([1.0, np.sin(t)])
        return np.asarray(np.diag([1.0, -1.0]) @ d * (d @ (TRUTH - theta)))

    assert np.abs(integrate.solve_ivp(slope, (0.0, 30.0), [0.0, 0.0]).y[:, -1]).max() > 1e3


STAGES: dict[str, tuple[Callable[[], Any], int]] = {
    "gradient": (lambda: GradientRegressor(3, outputs=2, gain=2.0), 2),
    "nonlinear": (lambda: NonlinearRegressor(2, gain=3.0), 1),
}


@pytest.mark.parametrize("name", STAGES)
def test_a_table_gives_what_single_samples_give(name: str) -> None:
    make, outputs = STAGES[name]
    t = np.cumsum(np.random.default_rng(5).uniform(0.0, 0.05, 60))
    if name == "gradient":
        d, y = data(t, outputs)
        parts: list[Any] = list(zip(d, y, strict=True))
        rows = np.concatenate([t[:, None], d.reshape(60, -1), y], axis=1)
    else:
        parts = [saturating(one) for one in t]
        rows = np.array([[one, *j, y, weight] for one, (j, weight, y) in zip(t, parts, strict=True)])
    begin = np.arange(60) == 40
    single, table = make(), make().walk(begin, rows)
    for i in range(60):
        if begin[i]:
            single.reset()
        assert single.update(*parts[i], t[i]).tobytes() == table[i].tobytes()
    twin = pickle.loads(pickle.dumps(single))
    assert twin.update(*parts[0], 9.0).tobytes() == single.update(*parts[0], 9.0).tobytes()
    assert not single.fresh().update(*parts[0], t[0]).any()
    spoiled, wrong = rows.copy(), [30, 33]
    spoiled[30, 1], spoiled[33, 0] = np.nan, -1.0
    if name == "nonlinear":
        spoiled[36, -1], wrong = 1.5, [30, 33, 36]  # no weight
    answers = make().walk(begin, spoiled)
    assert np.isnan(answers).any(axis=1).nonzero()[0].tolist() == wrong
    left = make().walk(np.delete(begin, wrong), np.delete(rows, wrong, 0))
    assert answers[39].tobytes() == left[39 - len(wrong)].tobytes()


@pytest.mark.parametrize(
    ("name", "sample", "kind", "field"),
    [
        ("gradient", ([1.0], 1.0, 2.0), EventError, "regressor"),
        ("gradient", ([1.0, 2.0], [1.0, 2.0], 2.0), EventError, "output"),
        ("gradient", ([1.0, np.nan], 1.0, 2.0), EventError, "regressor"),
        ("gradient", ([1.0, 2.0], 1.0, 1.0), EventOrderError, "t"),
        ("nonlinear", ([1.0, 1.0], 1.5, 1.0, 99.0), EventError, "weight"),
        ("nonlinear", ([1.0, 1.0], 0.5, 1.0, 0.0), EventOrderError, "t"),
        ("nonlinear", ([1.0, 1.0], 0.5, 1.0, 1e9), EventError, "t"),
        ("nonlinear", ([1.0, 1e200], 0.5, 1.0, 99.0), EventError, "t"),
    ],
)
def test_what_is_refused_changes_nothing(name: str, sample: Any, kind: type[EventError], field: str) -> None:
    stage: Any = GradientRegressor(2) if name == "gradient" else NonlinearRegressor(2, gain=3.0)
    for t in (1.0, 1.5):
        stage.update([1.0, t], *([] if name == "gradient" else [0.5]), 3.0, t)
    kept = pickle.dumps(stage)
    with np.errstate(over="ignore"), pytest.raises(kind) as refused:
        stage.update(*sample)
    assert refused.value.field == field
    assert pickle.dumps(stage) == kept
