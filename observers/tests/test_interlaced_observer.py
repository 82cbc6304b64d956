"""The observer (4.16) on irregular samples, with gaps, and what it refuses."""

from __future__ import annotations

import copy
import pickle
from runpy import run_path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from pointpred.compiled import with_names
from pointpred.errors import (
    EventError,
    EventOrderError,
    ParameterError,
)
from pointpred_observers.triangular import interlaced_observer
from pointpred_observers.triangular.forms import interlaced
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver, output_matrix
from pointpred_observers.triangular.system import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem

sp = pytest.importorskip("sympy")
pytest.importorskip("cvxpy")
W1, W2, U = sp.symbols("w1 w2 u")
X = X1, X2, X3, X4 = sp.symbols("x1:5")
A = np.array([[0.0, 1.0], [-1.0, 0.0]])
C = np.array([[1.0, 0.0]])
EIGHT = (-X1 + X2**2 * X3, -X2 + X3, -(X3**3) + X4, -X4 + (1 + X3**2) * U)


def eight(outputs: tuple[Any, ...] = (X3,)) -> SymbolicSteadyState:
    system = SymbolicSystem(X, EIGHT, U, outputs=outputs)
    return interlaced(system, SymbolicGenerator((W1, W2), (W2, -W1)), 2, W1, degree=3)


@pytest.fixture(scope="module")
def observer() -> InterlacedObserver:
    return InterlacedObserver.design(eight(), decay=0.25, gap_s=0.5)


def irregular(count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.001, 0.3, count))
    return t, np.cos(t) + random.normal(0.0, 0.1, count)


def test_it_follows_the_differential_equation_between_irregular_samples(observer: InterlacedObserver) -> None:
    t, y = irregular(60, 1)
    stage = observer.fresh()
    rows = np.array([stage.update(value, time).w for value, time in zip(y, t, strict=True)])
    gain = observer.certificate.L[:, 0]

    def motion(now: float, w: np.ndarray) -> np.ndarray:
        return A @ w + gain * (np.interp(now, t, y) - w[0])

    for i in range(1, len(t)):
        span = (t[i - 1], t[i])
        answer = solve_ivp(motion, span, rows[i - 1], method="DOP853", rtol=1e-12, atol=1e-13)
        assert rows[i] == pytest.approx(answer.y[:, -1], abs=1e-10)


def test_a_rise_from_nothing_is_seen_at_once(observer: InterlacedObserver) -> None:
    """At rest with y = 0 the first derivative is zero, the second is not."""
    stage, h = observer.fresh(), 0.01
    stage.update(0.0, 0.0)
    expected = observer.certificate.L[:, 0] * h / 2
    assert np.array(stage.update(1.0, h).w) == pytest.approx(expected, rel=2 * h)


def test_the_maps_are_those_of_sympy(observer: InterlacedObserver) -> None:
    stage = observer.fresh()
    for value, time in zip(*irregular(20, 2)[::-1], strict=True):
        found = stage.update(value, time)
        expected = observer.steady.function()(np.array(found.w))
        assert np.array([*found.x, *found.z, found.input]) == pytest.approx(expected, rel=1e-13, abs=1e-14)


def test_it_converges_where_the_plant_is_on_its_steady_state(observer: InterlacedObserver) -> None:
    stage = observer.fresh()
    for t in np.arange(0.0, 60.0, 0.01):
        found = stage.update(np.cos(t), float(t))
    assert np.array(found.w) == pytest.approx([np.cos(t), -np.sin(t)], abs=5e-5)


def test_columns_samples_and_chunks_agree(observer: InterlacedObserver) -> None:
    t, y = irregular(50, 3)
    y[7], begin = np.nan, np.zeros(50, dtype=bool)
    begin[30] = True
    rows = np.column_stack([t, y])
    whole = observer.fresh().walk(begin, rows)
    stage, parts = observer.fresh(), observer.fresh()
    halves = np.vstack([parts.walk(begin[:13], rows[:13]), parts.walk(begin[13:], rows[13:])])
    assert np.array_equal(whole, halves)
    for i in range(50):
        if begin[i]:
            stage.reset()
        if i == 20:
            stage = pickle.loads(pickle.dumps(copy.copy(stage)))
        found = stage.update(None if np.isnan(y[i]) else y[i], float(t[i]))
        assert [*found.w, *found.x, *found.z, found.input] == whole[i].tolist()


def test_plain_python_agrees(observer: InterlacedObserver, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred.compiled.law", with_names)
    step = run_path(interlaced_observer.__file__)["step"]
    memory, compiled = observer.fresh()._memory, observer.fresh()._memory
    out, other = np.empty(7), np.empty(7)
    for time, value in zip(*irregular(10, 4), strict=True):
        step(memory, np.array([time, value]), out)
        interlaced_observer.step(compiled, np.array([time, value]), other)
        assert out == pytest.approx(other, rel=1e-13, abs=1e-15)


def test_over_gaps_and_without_outputs_the_generator_runs_alone(observer: InterlacedObserver) -> None:
    start = [1.0, 0.5]
    stage = InterlacedObserver(eight(), observer.certificate, start=start, gap_s=0.5)
    assert stage.update(9.0, 10.0).w == (1.0, 0.5)
    assert stage.update(-3.0, 13.0).w == pytest.approx(expm(A * 3.0) @ start, abs=1e-13)
    before = stage.update(None, 13.1).w
    assert before == pytest.approx(expm(A * 3.1) @ start, abs=1e-13)
    assert stage.update(5.0, 13.2).w == pytest.approx(expm(A * 3.2) @ start, abs=1e-13)
    assert stage.update(5.0, 13.3).w != pytest.approx(expm(A * 3.3) @ start, abs=1e-3)
    assert stage.update(5.0, 1e5).w == (1.0, 0.5)


def test_samples_far_apart_are_followed_without_a_gap_of_ones_own(observer: InterlacedObserver) -> None:
    stage = InterlacedObserver(eight(), observer.certificate)
    for k in range(12):
        estimate = stage.update(np.cos(2.0 * k), 2.0 * k)
    generator = InterlacedObserver(eight(), observer.certificate, gap_s=0.5)
    for k in range(12):
        alone = generator.update(np.cos(2.0 * k), 2.0 * k)
    assert np.abs(estimate.w).max() > 0.1
    assert alone.w == (0.0, 0.0)
    before = stage.remembered()
    with pytest.raises(EventError, match=r"the observer follows at most .* sample more often, or give gap_s"):
        stage.update(1.0, 1e5)
    with pytest.raises(EventError, match="sample more often, or give gap_s"):
        stage.walk(np.zeros(1, np.bool_), np.array([[1e5, 1.0]]))
    assert stage.remembered() == before


def test_what_cannot_be_taken_in_changes_nothing(observer: InterlacedObserver) -> None:
    stage = observer.fresh()
    stage.update(1.0, 1.0)
    before = stage.remembered()
    with pytest.raises(EventOrderError, match="t must not run backwards"):
        stage.update(1.0, 0.5)
    for wrong in (np.nan, [1.0, 2.0], np.inf):
        with pytest.raises(EventError, match="needs 1 finite outputs, received"):
            stage.update(wrong, 2.0)
    with pytest.raises(EventError, match="outputs must be numbers, received 'far'"):
        stage.update("far", 2.0)
    assert stage.remembered() == before


def test_an_observer_needs_linear_outputs_and_numbers(observer: InterlacedObserver) -> None:
    assert output_matrix(eight()).tolist() == [[1.0, 0.0]]
    with pytest.raises(ParameterError, match="needs outputs of the system, received none"):
        output_matrix(eight(()))
    with pytest.raises(ParameterError, match=r"output 1 must be C w with numbers C, received w1\*\*3 \+ w2"):
        output_matrix(eight((X4,)))
    with pytest.raises(ParameterError, match=r"gap_s must lie in \[1e-12, 1e\+12\] s, received 0"):
        InterlacedObserver(eight(), observer.certificate, gap_s=0.0)
    with pytest.raises(ParameterError, match="start has shape"):
        InterlacedObserver(eight(), observer.certificate, start=[1.0])
