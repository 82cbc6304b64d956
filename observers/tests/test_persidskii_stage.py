"""Compiled observers against other integrators, and the laws that every stage obeys."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from pointpred.errors import DivergenceError, EventError, EventOrderError
from pointpred_observers import trajectory
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage
from pointpred_observers.plants.nonlinearity import KNOWN, nonlinearity

NAMES = ["sin", "tanh", "atan", "saturation", "cube", "identity"]


def random_stage(seed: int, **given: Any) -> tuple[PersidskiiStage, dict[str, Any]]:
    rng = np.random.default_rng(seed)
    q, k, inputs = int(rng.integers(1, 5)), int(rng.integers(0, 3)), int(rng.integers(1, 3))
    parts: dict[str, Any] = {
        "N": rng.normal(size=(q, q)) - 2.0 * np.eye(q),
        "L": 0.3 * rng.normal(size=(q, k)),
        "J": 0.3 * rng.normal(size=(k, q)),
        "K": rng.normal(size=(q, inputs)),
        "R1": rng.normal(size=(q, k)),
        "f": [NAMES[i] for i in rng.integers(0, 4, k)],
        "start": rng.normal(size=q),
    }
    return PersidskiiStage(**parts, **given), parts


def irregular(seed: int, inputs: int, rows: int = 12) -> Any:
    rng = np.random.default_rng(seed + 1)
    return np.column_stack([np.cumsum(rng.uniform(0.001, 0.2, rows)), rng.normal(size=(rows, inputs))])


@given(st.integers(0, 2**31))
@settings(max_examples=15)
def test_the_stage_follows_its_differential_equation(seed: int) -> None:
    stage, parts = random_stage(seed, step_s=1e-3)
    rows = irregular(seed, stage.inputs)
    f = nonlinearity(parts["f"], len(parts["J"]))

    def field(t: float, w: Any) -> Any:
        now = [np.interp(t, rows[:, 0], rows[:, 1 + j]) for j in range(stage.inputs)]
        return parts["N"] @ w + parts["L"] @ f(parts["J"] @ w) + parts["K"] @ now

    found = np.array([stage.update(row[0], row[1:]) for row in rows])
    w = [parts["start"]]
    for pair in zip(rows[:-1, 0], rows[1:, 0], strict=True):  # the inputs have a kink at each sample
        w.append(trajectory(field, w[-1], pair, step_s=1.0, tolerance=1e-10)[-1])
    assert np.allclose(found, [one + parts["R1"] @ f(parts["J"] @ one) for one in w], atol=1e-6)


def test_a_discrete_stage_is_the_recursion() -> None:
    stage, parts = random_stage(5, time="discrete")
    rows = irregular(5, stage.inputs)
    rows[:, 0] = np.arange(len(rows))
    f = nonlinearity(parts["f"], len(parts["J"]))
    w = parts["start"]
    for row in rows:
        assert np.allclose(stage.update(row[0], row[1:]), w + parts["R1"] @ f(parts["J"] @ w), atol=1e-12)
        w = parts["N"] @ w + parts["L"] @ f(parts["J"] @ w) + parts["K"] @ row[1:]


@pytest.mark.parametrize("f", ["tanh", np.tanh])
def test_a_discrete_stage_refuses_an_index_that_is_not_the_next(f: Any) -> None:
    """A sample is one step: an index that was skipped would leave the estimate behind the plant."""

    def stage() -> PersidskiiStage:
        return PersidskiiStage([[0.5]], [[1.0]], [[1.0]], [[1.0]], f, start=[1.0], time="discrete")

    live, rows = stage(), np.column_stack([[0.0, 1.0, 1.0, 2.0], [0.3, 0.1, 0.2, np.nan]])
    found = np.array([live.update(row[0], row[1:]) for row in rows])
    for t in (5.0, 2.5, 4.0):
        before = pickle.dumps(live)
        with pytest.raises(
            EventError, match=r"after index 2, .* update\(3, None\), for each missing"
        ) as failure:
            live.update(t, 1.0)
        assert failure.value.field == "t"
        if f == "tanh":
            assert pickle.dumps(live) == before
    with pytest.raises(EventOrderError):
        live.update(1.0, 1.0)
    table = stage()
    assert np.array_equal(table.walk(np.zeros(4, dtype=np.bool_), rows), found)
    skipping = np.array([[3.0, 0.1], [5.0, 0.1]])
    with pytest.raises(EventError, match="index 5 comes after index 3"):
        table.walk(np.zeros(2, dtype=np.bool_), skipping)
    assert np.array_equal(table.update(3, None), live.update(3, None))  # the refused rows changed nothing
    assert np.array_equal(table.walk(np.array([False, True]), np.array([[4.0, 0.1], [9.0, 0.1]]))[-1], [1.0])


def test_the_integration_is_of_fourth_order() -> None:
    n = np.array([[0.0, 1.0], [-4.0, -0.4]])

    def error(step_s: float) -> float:
        stage = PersidskiiStage(n, None, None, None, "sin", start=[1.0, 0.0], step_s=step_s, gap_s=10.0)
        stage.update(0.0)
        return float(np.abs(stage.update(2.0) - expm(2.0 * n) @ [1.0, 0.0]).max())

    assert 13.0 < error(0.1) / error(0.05) < 19.0


@pytest.mark.parametrize("name", NAMES)
def test_named_nonlinearities_are_what_their_names_say(name: str) -> None:
    s = np.linspace(-3.0, 3.0, 61)
    other = {
        "sin": np.sin, "tanh": np.tanh, "atan": np.arctan, "saturation": lambda s: np.clip(s, -1.0, 1.0),
        "cube": lambda s: s**3, "identity": lambda s: s,
    }[name]  # fmt: skip
    found = np.array([nonlinearity(name, 1)([one])[0] for one in s])
    assert np.allclose(found, other(s), atol=1e-14)
    slopes = np.diff(found) / np.diff(s)
    assert KNOWN[name].low - 1e-9 <= slopes.min()
    assert slopes.max() <= KNOWN[name].high + 1e-9


def varying(t: float) -> Any:
    return [[-1.0 - 0.5 * np.sin(t)]]


@pytest.mark.parametrize("plain", [False, True])
@given(st.integers(0, 2**31), st.integers(1, 11))
@settings(max_examples=10)
def test_stage_laws(plain: bool, seed: int, cut: int) -> None:
    """Compiled, and in numpy where matrices or f are functions."""
    stage, _ = random_stage(seed)
    if plain:
        stage = PersidskiiStage(varying, [[1.0]], [[1.0]], [[1.0, 2.0]], np.tanh, start=[0.5])
    rows = irregular(seed, stage.inputs)
    rows[7, 1] = np.nan
    begin = np.zeros(len(rows), dtype=np.bool_)
    whole = stage.fresh().walk(begin, rows)
    one_by_one = np.array([stage.update(row[0], row[1:]) for row in rows])
    assert np.array_equal(whole, one_by_one)
    stage.reset()
    chunks = [stage.walk(begin[:cut], rows[:cut])]
    twin = pickle.loads(pickle.dumps(stage))
    chunks.append(twin.walk(begin[cut:], rows[cut:]))
    assert np.array_equal(np.concatenate(chunks), whole)
    begin[cut] = True
    restarted = stage.fresh().walk(begin, rows)
    assert np.array_equal(restarted[cut:], stage.fresh().walk(begin[cut:], rows[cut:]))
    if plain:
        return  # its matrices depend upon the time
    later = rows + np.eye(1, rows.shape[1]) * 5.0
    assert np.allclose(stage.fresh().walk(np.zeros(len(rows), dtype=np.bool_), later), whole, atol=1e-9)


def test_a_refused_sample_changes_nothing() -> None:
    stage, _ = random_stage(3)
    rows = irregular(3, stage.inputs)
    for row in rows[:6]:
        stage.update(row[0], row[1:])
    before = stage.remembered()
    nothing = np.zeros(stage.inputs)
    for t, inputs, error, field in [
        (rows[5, 0] - 1.0, nothing, EventOrderError, "t"),
        (np.nan, nothing, EventError, "t"),
        (9.0, nothing + np.inf, EventError, "inputs"),
        (9.0, [0.0] * 7, EventError, "inputs"),
        (9.0, "some", EventError, "inputs"),
        (9.0, nothing + 1j, EventError, "inputs"),
        ("now", nothing, EventError, "t"),
        (10**400, nothing, EventError, "t"),
        (np.timedelta64(9, "s"), nothing, EventError, "t"),
    ]:
        with pytest.raises(error) as refused:
            stage.update(t, inputs)
        assert refused.value.field == field
        assert stage.remembered() == before


@pytest.mark.parametrize("f", ["cube", lambda s: s**3])
def test_a_state_that_leaves_every_bound_is_said(f: Any) -> None:
    stage = PersidskiiStage([[0.0]], [[1.0]], [[1.0]], [[1.0]], f, gap_s=100.0)
    stage.update(0.0, 1.0)
    before = stage.remembered()
    with (
        np.errstate(over="ignore", invalid="ignore"),
        pytest.raises(DivergenceError, match="leaves every bound"),
    ):
        stage.update(60.0, 1.0)
    assert stage.remembered() == before


def test_a_long_gap_begins_anew_and_equal_times_replace() -> None:
    lag = PersidskiiStage([[-1.0]], None, None, [[1.0]], "sin", start=[3.0], gap_s=0.5)
    lag.update(0.0, 0.0)
    assert lag.update(0.4, 0.0)[0] == pytest.approx(3.0 * np.exp(-0.4))
    assert lag.update(1.0, 0.0)[0] == 3.0
    assert lag.update(1.0, 8.0)[0] == 3.0
    replaced = lag.update(1.1, 8.0)[0]
    assert replaced == pytest.approx(3.0 * np.exp(-0.1) + 8.0 * (1.0 - np.exp(-0.1)))
