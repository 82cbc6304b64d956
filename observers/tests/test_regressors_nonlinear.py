"""The nonlinear regressor against its equation, and the condition of Theorem 3.3.3 against closed forms."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from scipy import integrate, linalg

from pointpred.errors import EventError, EventOrderError, ParameterError, UndecidedError
from pointpred_observers import GradientRegressor, NonlinearRegressor
from pointpred_observers.thesis import regression_margin

TRUTH = np.array([3.0, 5.0])


def sample(t: float) -> tuple[np.ndarray, float, float]:
    j, weight = np.array([1.0, np.sin(t)]), float(np.sin(5.0 * t) ** 2)
    s = float(j @ TRUTH)
    return j, weight, (1.0 - weight) * s + weight * np.arctan(s) + 0.3 * np.cos(t)


@pytest.mark.parametrize("gain", [0.75, 60.0])
def test_it_follows_its_differential_equation_to_second_order(gain: float) -> None:
    def slope(t: float, theta: np.ndarray) -> np.ndarray:
        j, weight, y = sample(t)
        s = j @ theta
        return np.asarray(gain * j * (y - (1.0 - weight) * s - weight * np.arctan(s)))

    wanted = integrate.solve_ivp(slope, (0.0, 2.0), [1.0, 1.0], rtol=1e-10, atol=1e-10, max_step=0.02).y[
        :, -1
    ]
    errors = []
    for steps in (100, 200):
        stage = NonlinearRegressor(2, gain=gain, start=[1.0, 1.0])
        for t in np.linspace(0.0, 2.0, steps + 1):
            found = stage.update(*sample(t), t)
        errors.append(float(np.abs(found - wanted).max()))
    assert errors[1] < 2e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.25)


def test_without_the_nonlinear_sensor_it_is_the_gradient_estimator() -> None:
    """Remark 3.3.3: D1 = 0 is linear regression."""
    one, other = NonlinearRegressor(2, gain=2.0), GradientRegressor(2, gain=2.0)
    for t in np.arange(0.0, 3.0, 0.005):
        j = np.array([1.0, np.sin(t)])
        found, wanted = one.update(j, 0.0, j @ TRUTH, t), other.update(j, j @ TRUTH, t)
    assert found == pytest.approx(wanted, abs=2e-3)


def test_a_table_gives_what_single_samples_give_and_refusals_change_nothing() -> None:
    t = np.cumsum(np.random.default_rng(2).uniform(0.0, 0.1, 40))
    parts = [sample(one) for one in t]
    rows = np.array([[one, *j, y, weight] for one, (j, weight, y) in zip(t, parts, strict=True)])
    begin = np.zeros(40, np.bool_)
    begin[25] = True
    stage, single = NonlinearRegressor(2, gain=3.0), NonlinearRegressor(2, gain=3.0)
    table = stage.walk(begin, rows)
    for i in range(40):
        if begin[i]:
            single.reset()
        assert single.update(*parts[i], t[i]).tobytes() == table[i].tobytes()
    spoiled = rows.copy()
    spoiled[10, 1], spoiled[12, 4] = np.inf, 1.5
    answers = NonlinearRegressor(2, gain=3.0).walk(begin, spoiled)
    assert np.isnan(answers).any(axis=1).nonzero()[0].tolist() == [10, 12]
    kept = pickle.dumps(single)
    wrong: list[tuple[Any, Any, Any, Any, type[EventError], str]] = [
        ([1.0], 0.5, 1.0, 99.0, EventError, "regressor"),
        ([1.0, 1.0], 1.5, 1.0, 99.0, EventError, "weight"),
        ([1.0, 1.0], np.nan, 1.0, 99.0, EventError, "weight"),
        ([1.0, 1.0], "half", 1.0, 99.0, EventError, "weight"),
        ([1.0, 1.0], 0.5, 1.0, 0.0, EventOrderError, "t"),
        ([1.0, 1.0], 0.5, 1.0, 1e9, EventError, "t"),
        ([1.0, 1e200], 0.5, 1.0, 99.0, EventError, "t"),
    ]
    for regressor, weight, output, moment, kind, field in wrong:
        with np.errstate(over="ignore"), pytest.raises(kind) as refused:
            single.update(regressor, weight, output, moment)
        assert refused.value.field == field
        assert pickle.dumps(single) == kept


@pytest.mark.parametrize(
    ("field", "value"), [("f", "sin"), ("f", "cube"), ("gain", 0.0), ("start", [1.0]), ("outputs", 1.5)]
)
def test_the_constructor_names_the_wrong_parameter(field: str, value: Any) -> None:
    with pytest.raises(ParameterError) as refused:
        NonlinearRegressor(2, **{field: value})
    assert (refused.value.field, refused.value.value) == (field, value)


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


@pytest.mark.parametrize(
    ("given", "field"),
    [
        ({"weight": np.full(50, 1.5)}, "weight"),
        ({"weight": np.full(49, 0.5)}, "weight"),
        ({"weight": ["much"] * 50}, "weight"),
        ({"gain": -1.0}, "gain"),
        ({"gain": "high"}, "gain"),
        ({"flattest": 1.5}, "flattest"),
        ({"flattest": "flat"}, "flattest"),
        ({"t": ["early", "late"]}, "t"),
        ({"regressor": [["a"]] * 50}, "signal"),
        ({"regressor": [[1.0], [1.0, 2.0]]}, "signal"),
    ],
)
def test_records_that_are_no_numbers_are_refused(given: dict[str, Any], field: str) -> None:
    record = {"t": np.linspace(0.0, 1.0, 50), "regressor": np.ones((50, 2)), "weight": np.full(50, 0.5)}
    with pytest.raises(ParameterError) as refused:
        regression_margin(**{**record, "gain": 1.0, **given})
    assert refused.value.field == field
