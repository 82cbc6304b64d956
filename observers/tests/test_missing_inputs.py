"""Samples without some of their inputs: what replaces them, against other integrators."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pointpred.errors import EventError, ParameterError
from pointpred_observers import Generator, Persidskii, invariant_observer
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage
from pointpred_observers.interconnected.realisation import MissingInputs
from pointpred_observers.thesis import regulator_stage

NAN = np.nan


def exactly(field: Any, start: Any, span: tuple[float, float]) -> Any:
    return solve_ivp(field, span, start, method="DOP853", rtol=1e-11, atol=1e-13).y[:, -1]


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


def test_the_first_output_may_be_missing() -> None:
    plant = plant_with_input()
    observer = invariant_observer(plant, np.eye(3)[1:], [[-3.0], [1.0]], injection=True)
    stage = observer.stage(start=[0.4, -0.3, 0.2], step_s=1e-3)
    assert stage.update(5.0, None) == pytest.approx([0.4, -0.3, 0.2])
    wanted = exactly(lambda t, x: plant.field(t, x, [0.0]), [0.4, -0.3, 0.2], (5.0, 5.8))
    assert stage.update(5.8, [NAN, 0.0]) == pytest.approx(wanted, abs=1e-9)


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
    with pytest.raises(EventError, match="NaN only for a missing input"):
        stage.update(0.0, np.inf)
    with pytest.raises(EventError, match="must be finite"):
        stage.update(NAN, 0.0)


@pytest.mark.parametrize(
    ("missing", "told"),
    [
        (MissingInputs.held(2, 1, 1), "missing needs 1 inputs, received 2"),
        (MissingInputs.held(1, 2, 1), "V0 has shape"),
        (MissingInputs.expected([[1.0]], [[1.0]], 1), "cannot be replaced by a value of f"),
    ],
)
def test_what_cannot_replace_an_input_is_named(missing: MissingInputs, told: str) -> None:
    with pytest.raises(ParameterError, match=told):
        PersidskiiStage([[-1.0]], [[1.0]], [[1.0]], [[1.0]], "sin", R=[[1.0]], missing=missing)
