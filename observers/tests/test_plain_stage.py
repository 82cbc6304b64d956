"""Stages whose f or matrices are functions, and the step that a fast stage takes."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from pointpred.errors import DivergenceError, EventError, ParameterError
from pointpred_observers import Generator, Persidskii, invariant_observer
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage
from pointpred_observers.interconnected.realisation import MissingInputs
from pointpred_observers.plants.nonlinearity import nonlinearity
from pointpred_observers.reduced_order.design import ReducedOrderObserver


def exactly(field: Any, start: Any, span: tuple[float, float], at: Any = None) -> Any:
    answer = solve_ivp(field, span, start, method="DOP853", t_eval=at, rtol=1e-11, atol=1e-12)
    return answer.y.T if at is not None else answer.y[:, -1]


def random_parts(rng: np.random.Generator) -> dict[str, Any]:
    q, k, inputs, outputs = (int(n) for n in rng.integers((1, 1, 1, 1), (4, 3, 4, 3)))
    return {
        "N": rng.normal(size=(q, q)) - 2.0 * np.eye(q),
        "L": 0.3 * rng.normal(size=(q, k)),
        "J": rng.normal(size=(k, q)),
        "K": rng.normal(size=(q, inputs)),
        "R0": rng.normal(size=(outputs, q)),
        "R1": rng.normal(size=(outputs, k)),
        "R": rng.normal(size=(k, inputs)),
        "R2": rng.normal(size=(outputs, inputs)),
        "start": rng.normal(size=q),
    }


def random_missing(rng: np.random.Generator, parts: dict[str, Any]) -> MissingInputs:
    (q, k), inputs = parts["L"].shape, parts["K"].shape[1]
    value = rng.uniform(size=inputs) < 0.5
    v1 = rng.normal(size=(inputs, k))
    v1[value] = 0.0
    v0, v2 = rng.normal(size=(inputs, q)), 0.3 * rng.normal(size=(inputs, inputs))
    return MissingInputs(tuple(map(bool, value)), v0, v1, v2, rng.normal(size=inputs))


@given(st.integers(0, 2**31), st.sampled_from(["continuous", "discrete"]))
@settings(max_examples=20, deadline=None)
def test_the_plain_law_is_the_compiled_one(seed: int, time: str) -> None:
    """A named f given as a function runs in numpy, with the same answers, also where inputs are missing."""
    rng = np.random.default_rng(seed)
    parts = random_parts(rng)
    names = ["sin", "tanh", "atan", "saturation"]
    f = nonlinearity([names[i] for i in rng.integers(0, 4, parts["L"].shape[1])], parts["L"].shape[1])
    more: dict[str, Any] = {"missing": random_missing(rng, parts), "time": time, "step_s": 0.02}
    named = PersidskiiStage(f=f, **parts, **more)
    plain = PersidskiiStage(f=lambda s: f(s), **parts, **more)
    rows = rng.normal(size=(25, 1 + named.inputs))
    steps = [0.0, 0.01, 0.3, 1.5] if time == "continuous" else [0.0, 1.0, 1.0, 1.0]
    rows[:, 0] = np.cumsum(rng.choice(steps, 25, p=[0.1, 0.4, 0.4, 0.1]))
    rows[:, 1:][rng.uniform(size=rows[:, 1:].shape) < 0.2] = np.nan
    begin = rng.uniform(size=25) < 0.05
    found = plain.walk(begin, rows)
    assert np.isfinite(found).all()
    assert np.allclose(found, named.walk(begin, rows), rtol=1e-9, atol=1e-9)


def test_varying_matrices_follow_their_differential_equation() -> None:
    def n(t: float) -> Any:
        return np.array([[-1.0 + np.sin(t), 2.0], [-2.0, -1.0 - 0.5 * np.cos(3.0 * t)]])

    def k(t: float) -> Any:
        return np.array([[np.cos(t)], [1.0]])

    stage = PersidskiiStage(
        n, [[0.0], [1.0]], lambda t: [[1.0, t]], k, "sin", R0=lambda t: [[t, 1.0]], start=[1.0, -1.0]
    )
    times = np.array([0.0, 0.1, 0.15, 0.6, 1.4])
    inputs = np.array([1.0, -1.0, 2.0, 0.5, 0.0])
    found = [float(stage.update(t, one)[0]) for t, one in zip(times, inputs, strict=True)]

    def field(t: float, w: Any) -> Any:
        change = n(t) @ w + k(t)[:, 0] * np.interp(t, times, inputs)
        return change + np.array([0.0, np.sin(w[0] + t * w[1])])

    w, wanted = np.array([1.0, -1.0]), [-1.0]
    for i in range(1, 5):
        w = exactly(field, w, (times[i - 1], times[i]))
        wanted.append(float(times[i] * w[0] + w[1]))
    assert found == pytest.approx(wanted, abs=1e-7)


def test_an_f_of_several_arguments() -> None:
    """Predators and prey: the product of two states, which no name has."""
    stage = PersidskiiStage(
        np.diag([1.0, -1.0]),
        [[-1.0], [1.0]],
        np.eye(2),
        None,
        lambda s: np.array([s[0] * s[1]]),
        start=[2.0, 1.0],
    )
    stage.update(0.0)
    wanted = exactly(lambda t, x: [x[0] - x[0] * x[1], x[0] * x[1] - x[1]], [2.0, 1.0], (0.0, 0.9))
    assert stage.update(0.9) == pytest.approx(wanted, abs=1e-7)


def test_a_discrete_stage_takes_the_matrices_of_its_index() -> None:
    stage = PersidskiiStage(lambda k: [[1.0 + k]], None, None, [[1.0]], "sin", start=[1.0], time="discrete")
    found = [float(stage.update(k, 10.0)[0]) for k in range(4)]
    assert found == [1.0, 11.0, 32.0, 106.0]  # w+ = (1 + k) w + 10


def test_plain_stages_keep_the_laws_of_stages() -> None:
    def stage() -> PersidskiiStage:
        return PersidskiiStage(varying, [[1.0]], [[1.0]], [[1.0, 2.0]], np.tanh, start=[0.5])

    rng = np.random.default_rng(4)
    rows = np.column_stack([np.cumsum(rng.uniform(0.01, 0.2, 20)), rng.normal(size=(20, 2))])
    rows[7, 1] = np.nan
    begin = np.zeros(20, np.bool_)
    whole = stage().walk(begin, rows)
    one_by_one, parts = stage(), stage()
    for i, row in enumerate(rows):
        assert np.array_equal(one_by_one.update(row[0], row[1:]), whole[i])
    head = parts.walk(begin[:9], rows[:9])
    tail = pickle.loads(pickle.dumps(parts)).walk(begin[9:], rows[9:])
    assert np.array_equal(np.concatenate([head, tail]), whole)
    assert np.array_equal(one_by_one.fresh().walk(begin, rows), whole)
    one_by_one.reset()
    assert np.array_equal(one_by_one.walk(begin, rows), whole)


def varying(t: float) -> Any:
    return [[-1.0 - 0.5 * np.sin(t)]]


def test_a_plain_stage_that_diverges_is_unchanged() -> None:
    stage = PersidskiiStage([[0.0]], [[1.0]], [[1.0]], None, lambda s: s**3, start=[1.0], gap_s=10.0)
    stage.update(0.0)
    before = stage.remembered()
    with np.errstate(over="ignore", invalid="ignore"), pytest.raises(DivergenceError, match="every bound"):
        stage.update(3.0)
    assert stage.remembered() == before


@pytest.mark.parametrize("wrong", [{"N": lambda t: [[1.0, 2.0]]}, {"K": lambda t: [[1.0], [1.0]]}])
def test_a_function_of_the_wrong_shape_is_named(wrong: dict[str, Any]) -> None:
    right: dict[str, Any] = {"N": [[-1.0]], "L": [[1.0]], "J": [[1.0]], "K": [[1.0]], "f": np.sin}
    with pytest.raises(ParameterError) as refused:
        PersidskiiStage(**{**right, **wrong})
    assert refused.value.field == next(iter(wrong))


def test_an_observer_of_varying_matrices_runs_as_it_is_designed() -> None:
    """A Mathieu oscillator with a dead zone for f: from its exact start the state stays exact."""

    def a0(t: float) -> Any:
        return np.array([[0.0, 1.0], [-2.0 - np.cos(3.0 * t), -0.1]])

    def f(s: Any) -> Any:
        return s - np.tanh(s)

    plant = Persidskii(
        a0, [0.0, -2.0], [1.0, 0.0], f, [0.0, 1.0], None, lambda t: [[1.0 + 0.2 * np.sin(t), 0.0]],
        slopes=(0.0, 1.0),
    )  # fmt: skip
    observer = invariant_observer(
        plant,
        [[0.0, 1.0]],
        lambda t: [[-3.0 - np.sin(t)]],
        injection=True,
        rates={"Upsilon": lambda t: [[-np.cos(t)]], "C0": lambda t: [[0.2 * np.cos(t), 0.0]]},
    )
    times = np.arange(0.0, 2.0, 0.02)

    def u(t: float) -> float:
        return float(np.sin(2.0 * t))

    truth = exactly(lambda t, x: plant.field(t, x, [u(t)]), [0.7, -0.2], (0.0, 2.0), times)
    stage = observer.stage(start=[0.7, -0.2])
    other = observer.stage(start=[0.7, 1.8])
    for t, x in zip(times, truth, strict=True):
        inputs = [float(plant.output(t, x)[0]), u(t)]
        # Between two samples the inputs are linear, which they are not in truth.
        assert stage.update(t, inputs) == pytest.approx(x, abs=2e-3)
        error = abs(other.update(t, inputs)[1] - x[1])
    assert error < 0.02


def test_a_discrete_observer_of_varying_matrices_runs() -> None:
    plant = Persidskii(
        lambda k: [[0.9, 0.5 + 0.1 * (k % 3)], [-0.2, 0.8]], None, None, "sin", [0.0, 1.0], None, [1.0, 0.0],
        time="discrete",
    )  # fmt: skip
    observer = invariant_observer(plant, [[0.0, 1.0]], [[-0.5]])
    stage, x = observer.stage(start=[1.0, 2.0]), np.array([1.0, 2.0])
    for k in range(12):
        inputs = [x[0] if k not in (5, 6, 9) else np.nan, np.cos(k)]
        assert stage.update(k, inputs) == pytest.approx(x, abs=1e-12)
        x = plant.field(k, x, [np.cos(k)])


def test_designs_for_a_function_run_like_those_for_its_name() -> None:
    def plant(f: Any) -> Persidskii:
        return Persidskii(
            [[-1.0, 0.5], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.0], f, [0.0, 1.0], None, [1.0, 0.0],
            slopes=(0.0, 1.0),
        )  # fmt: skip

    generator = Generator([[0.0]], [[0.0]], L0=[[4.0]], L1=[[1.0]])
    found = []
    for f in ("tanh", np.tanh):
        stage = DrivenObserver.design(plant(f), generator=generator, Pi=[[1.0], [2.0]], decay=1.0).stage()
        reduced = ReducedOrderObserver.design(plant(f), Pi=[[0.0, 1.0]]).observer.stage()
        found.append(
            [[*stage.update(i / 20, np.sin(i)), *reduced.update(i / 20, [np.sin(i), 1.0])] for i in range(30)]
        )
    assert np.allclose(found[0], found[1], rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize("pole", [-300.0, -3e4])
def test_a_fast_stage_takes_short_steps_by_default(pole: float) -> None:
    stage = PersidskiiStage([[pole]], None, None, [[-pole]], "sin", start=[1.0])
    slow = PersidskiiStage([[-300.0]], None, None, [[300.0]], "sin", start=[1.0], step_s=0.0101)
    for i in range(60):
        found, grown = stage.update(0.03 * i, 0.0)[0], slow.update(0.03 * i, 0.0)[0]
    assert abs(found) < 1e-12
    assert abs(grown) > 1e3
    assert PersidskiiStage([[-30.0]], None, None, None, "sin").step_s == 0.01


def test_the_default_step_does_not_depend_on_units() -> None:
    n = np.array([[-200.0, 1e4], [-1.0, -50.0]])
    for scale in (1e-6, 1.0, 1e6):
        d = np.diag([scale, 1.0])
        stage = PersidskiiStage(
            d @ n @ np.linalg.inv(d),
            d @ [[30.0], [1.0]],
            np.array([[1.0, 2.0]]) @ np.linalg.inv(d),
            None,
            "tanh",
        )
        assert stage.step_s == pytest.approx(0.0035, rel=0.1)


def test_a_stage_whose_rate_grows_takes_shorter_steps() -> None:
    stage = PersidskiiStage(lambda t: [[-1.0 - 1e3 * t]], None, None, None, "sin", start=[1.0])
    for i in range(20):
        found = stage.update(0.1 * i)[0]
    assert abs(found) < 1e-9


def test_a_fast_reduced_order_observer_runs_with_defaults() -> None:
    plant = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0])
    stage = invariant_observer(plant, [[0.0, 1.0]], [[-300.0]]).stage()
    for i in range(50):
        state = stage.update(0.05 * i, 0.015 * i)
    assert state == pytest.approx([0.735, 0.3], abs=1e-9)


def test_a_gap_that_a_very_fast_stage_cannot_bridge_is_named() -> None:
    with pytest.raises(ParameterError, match=r"at most 0\.1 s.* give a shorter gap_s") as refused:
        PersidskiiStage([[-1e6]], None, None, None, "sin", gap_s=1.0)
    assert refused.value.field == "gap_s"
    stage = PersidskiiStage([[-1e6]], None, None, None, "sin", start=[1.0], gap_s=0.05)
    stage.update(0.0)
    assert stage.update(1e-6) == pytest.approx(np.exp(-1.0), abs=0.01)


def test_a_plain_stage_refuses_more_steps_than_it_takes() -> None:
    stage = PersidskiiStage([[-1.0]], [[1.0]], [[1.0]], [[1.0]], lambda s: np.sin(s))
    stage.update(0.0, 1.0)
    before = stage.remembered()
    for inputs in (1.0, None):
        with pytest.raises(EventError, match=r"comes 1001 s after the last one, .* at most 1000 s"):
            stage.update(1001.0, inputs)
        assert stage.remembered() == before
    with pytest.raises(EventError, match="sample more often, or give gap_s"):
        stage.walk(np.zeros(1, np.bool_), np.array([[1001.0, 1.0]]))
