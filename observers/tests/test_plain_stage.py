"""Stages whose f or matrices are functions, and the step that a fast stage takes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from pointpred.errors import EventError, ParameterError
from pointpred_observers import Generator, Persidskii, invariant_observer
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.interconnected.persidskii_stage import MissingInputs, PersidskiiStage
from pointpred_observers.plants.nonlinearity import nonlinearity
from pointpred_observers.thesis import regulator_stage


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


def test_an_f_of_several_arguments() -> None:
    """Predators and prey: the product of two states, which no name has."""

    def f(s: Any) -> Any:
        return np.array([s[0] * s[1]])

    stage = PersidskiiStage(np.diag([1.0, -1.0]), [[-1.0], [1.0]], np.eye(2), None, f, start=[2.0, 1.0])
    stage.update(0.0)
    wanted = exactly(lambda t, x: [x[0] - x[0] * x[1], x[0] * x[1] - x[1]], [2.0, 1.0], (0.0, 0.9))
    assert stage.update(0.9) == pytest.approx(wanted, abs=1e-7)


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
        back = np.linalg.inv(d)
        j = np.array([[1.0, 2.0]]) @ back
        stage = PersidskiiStage(d @ n @ back, d @ [[30.0], [1.0]], j, None, "tanh")
        assert stage.step_s == pytest.approx(0.0035, rel=0.1)


def test_a_gap_that_a_very_fast_stage_cannot_bridge_is_named() -> None:
    with pytest.raises(ParameterError, match=r"at most 0\.1 s.* give a shorter gap_s") as refused:
        PersidskiiStage([[-1e6]], None, None, None, "sin", gap_s=1.0)
    assert refused.value.field == "gap_s"
    stage = PersidskiiStage([[-1e6]], None, None, None, "sin", start=[1.0], gap_s=0.05)
    stage.update(0.0)
    assert stage.update(1e-6) == pytest.approx(np.exp(-1.0), abs=0.01)


NAN = np.nan


def driven() -> tuple[Persidskii, Generator, Any]:
    """An output that holds f as well, and a generator with an input of its own."""
    plant = Persidskii(
        np.diag([-1.0, -2.0]), [[0.3], [0.0]], [[1.0, 0.0]], "tanh", np.eye(2), None, [[1.0, 0.5]], [[0.2]]
    )
    s0 = np.array([[0.0, 1.0], [-1.0, 0.0]])
    l0 = s0 - plant.A0
    return plant, Generator(s0, [[0.3], [0.0]], [[1.0, 0.0]], L0=l0, L1=[[0.0], [0.0]]), np.eye(2)


def test_without_an_output_the_generator_runs_alone() -> None:
    plant, generator, pi = driven()
    stage = DrivenObserver.design(plant, generator=generator, Pi=pi, decay=0.5).stage(
        start=[1.0, 0.0], step_s=1e-3
    )
    stage.update(0.0, 1.3)
    before = stage.update(0.1, 1.2)[:2]
    found = [stage.update(0.1 + h, None)[:2] for h in (0.2, 0.7, 1.6)]
    found.append(stage.update(1.8, 0.4)[:2])  # the interval before it has no measurement at its begin

    def alone(t: float, w: Any) -> Any:
        return generator.S0 @ w + np.array([0.3 * np.tanh(w[0]), 0.0])

    for h, w in zip((0.2, 0.7, 1.6, 1.7), found, strict=True):
        assert w == pytest.approx(exactly(alone, before, (0.0, h)), abs=1e-9)
    assert stage.update(1.9, 0.4)[:2] != pytest.approx(exactly(alone, before, (0.0, 1.8)), abs=1e-3)


def test_in_discrete_time_too() -> None:
    stage = PersidskiiStage(
        [[0.5]], [[1.0]], [[1.0]], [[0.25]], "tanh", start=[1.0], time="discrete",
        missing=MissingInputs.expected([[2.0]], [[4.0]], 1, "discrete"),
    )  # fmt: skip
    first = stage.update(0, 3.0)[0]
    second = stage.update(1, None)[0]
    assert second == pytest.approx(0.5 * first + np.tanh(first) + 0.75)
    third = stage.update(2, 8.0)[0]  # N + K V0 = 1, L + K V1 = 2
    assert third == pytest.approx(second + 2.0 * np.tanh(second))
    assert stage.update(3, 0.0)[0] == pytest.approx(0.5 * third + np.tanh(third) + 2.0)


def plant_with_input() -> Persidskii:
    return Persidskii(
        [[0.0, 1.0, 0.0], [-3.0, -0.2, 1.0], [0.0, -1.0, -0.5]], [0.0, -2.0, 0.5], [1.0, 0.0, 0.0], "tanh",
        [0.0, 1.0, 0.0], None, [[1.0, 0.0, 0.0]],
    )  # fmt: skip


@pytest.mark.parametrize("injection", [True, False])
def test_a_reduced_order_observer_follows_the_plant_through_a_gap(injection: bool) -> None:
    """From the exact state it stays exact without a measurement, and goes on so when they return."""
    plant = plant_with_input()
    pi, upsilon = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [[-3.0], [1.0]]
    if not injection:
        plant = Persidskii(plant.A0, None, None, "sin", plant.B, None, plant.C0)
    stage = invariant_observer(plant, pi, upsilon, injection=injection).stage(
        start=[0.4, -0.3, 0.2], step_s=1e-3
    )

    def u(t: float) -> float:
        return 0.7 * t

    x, last = np.array([0.4, -0.3, 0.2]), 0.0
    for i, t in enumerate(np.concatenate([[0.0], np.cumsum(np.full(60, 0.01)), [0.65, 1.2, 2.0, 2.01]])):
        if t > last:
            x = exactly(lambda s, x: plant.field(s, x, [u(s)]), x, (last, t))
        last = t
        y = NAN if 20 <= i < 64 else x[0]
        assert stage.update(t, [y, u(t)]) == pytest.approx(x, abs=3e-4)


def test_one_of_several_inputs_is_replaced_and_the_others_count() -> None:
    n, k = np.array([[-1.0, 0.4], [0.0, -2.0]]), np.array([[1.0, 0.0, 0.5], [0.0, 1.0, -0.3]])
    v0 = np.array([[0.5, 1.0], [0.0, 0.0], [0.2, -0.4]])
    v2 = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.3, 0.1, -0.2]])
    missing = MissingInputs((True, False, False), v0, np.zeros((3, 0)), v2, np.zeros(3))
    stage = PersidskiiStage(n, None, None, k, "sin", start=[1.0, 2.0], missing=missing, step_s=1e-3)
    stage.update(0.0, [1.0, -1.0, 2.0])
    found = stage.update(0.5, [NAN, 3.0, NAN])

    def field(t: float, v: Any) -> Any:
        w, last = v[:2], v[2]
        inputs = np.array([v0[0] @ w, -1.0 + 8.0 * t, last])
        return [*(n @ w + k @ inputs), v0[2] @ w + v2[2] @ inputs]

    assert found == pytest.approx(exactly(field, [1.0, 2.0, 2.0], (0.0, 0.5))[:2], abs=1e-9)


def test_an_input_that_nothing_predicts_keeps_its_last_value() -> None:
    stage = PersidskiiStage([[-1.0]], None, None, [[1.0]], "sin", step_s=1e-3)
    assert stage.update(0.0, None)[0] == 0.0
    assert stage.update(0.5, None)[0] == 0.0  # zero before the first
    assert stage.update(0.6, 2.0)[0] == 0.0
    assert stage.update(0.9, NAN)[0] == pytest.approx(2.0 * (1.0 - np.exp(-0.3)))
    assert stage.update(1.0, 5.0)[0] == pytest.approx(2.0 * (1.0 - np.exp(-0.4)))
    regulator = regulator_stage(Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0]), Generator(
        [[-1.0]], J=np.zeros((0, 1)), G=[[1.0]], L0=[[1.0]]
    ))  # fmt: skip
    regulator.update(0.0, 2.0)
    assert regulator.update(0.4, None)[0] == pytest.approx(2.0 * (1.0 - np.exp(-0.4)))


def test_samples_of_two_sensors_at_one_time_join() -> None:
    apart = PersidskiiStage(-np.eye(2), None, None, np.eye(2), "sin")
    joined = apart.fresh()
    for i in range(5):
        apart.update(0.1 * i, [1.0 + i, NAN])
        apart.update(0.1 * i, [NAN, 2.0 - i])
        found = joined.update(0.1 * i, [1.0 + i, 2.0 - i])
    # The first of the two samples saw an interval without the other's input at its end.
    assert apart.update(0.4, [NAN, NAN])[0] == pytest.approx(found[0], abs=1e-12)


def test_only_nan_is_missing() -> None:
    stage = PersidskiiStage([[-1.0]], None, None, [[1.0]], "sin")
    with pytest.raises(EventError, match="NaN for those that are missing"):
        stage.update(0.0, np.inf)
    with pytest.raises(EventError, match="t must be a finite number"):
        stage.update(NAN, 0.0)
