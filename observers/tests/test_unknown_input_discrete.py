"""Discrete unknown input observers: certificates against closed forms, errors against matrix powers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred.errors import EventError, InfeasibleError, UndecidedError
from pointpred_observers import Box, ParameterVaryingSystem, UnknownInputSample
from pointpred_observers.unknown_input.certificate import discrete_gain
from pointpred_observers.unknown_input.observer import UnknownInputObserver

NAN = np.nan


def constant(a: Any, f: Any, c: Any) -> ParameterVaryingSystem:
    return ParameterVaryingSystem(
        lambda p: np.asarray(a) + 0.0 * p["k"], lambda p: np.asarray(f), np.asarray(c), time="discrete"
    )


def design(a: Any, f: Any, c: Any, decay: float) -> UnknownInputObserver:
    return UnknownInputObserver.design(constant(a, f, c), Box({"k": (0.0, 0.0)}), decay)


def constantly(point: Any) -> Any:
    return lambda _: point


TWO = ([[0.5, 1.0], [0.0, 0.6]], [[1.0], [0.0]], [[1.0, 0.0]])


def test_a_certificate_in_closed_form() -> None:
    """The hidden state decays by 0.6 a step: gamma = P (1 + 0.36 / (e^-0.4 - 0.36)) for its disturbance."""
    one = design(*TWO, decay=0.2).certificate
    left = np.exp(-0.4)
    assert one.gamma / one.P[1, 1] == pytest.approx(1.001 * left / (left - 0.36), rel=1e-6)
    assert one.phi2**2 == pytest.approx(one.gamma / ((1.0 - left) * np.linalg.eigvalsh(one.P)[0]))
    assert one.largest_decay == pytest.approx(-np.log(0.6))
    assert one.zeros.tolist() == [[0.6]]
    assert one.bound(3.0, 1.0) == pytest.approx(one.phi1 * np.exp(-0.6))


def test_zeros_decide_before_any_solver() -> None:
    with pytest.raises(
        InfeasibleError, match=r"invariant zero 0\.6 at .* exp\(-decay\) = 0\.548812: the larg"
    ):
        design(*TWO, decay=0.6)
    growing = ([[0.5, 1.0], [0.0, -1.1]], *TWO[1:])
    with pytest.raises(InfeasibleError, match="no decay above 0 is feasible in this box"):
        design(*growing, decay=0.05)


def test_an_index_that_is_not_the_next_is_refused() -> None:
    """A sample is one step; one without outputs stands for an index that nobody measured at."""
    stage = design(*TWO, decay=0.2).stage([0.0, 1.0])

    def sample(index: float, y: Any) -> UnknownInputSample:
        return UnknownInputSample(index, y, np.zeros(2), constantly({"k": 0.0}))

    stage.update(sample(0, np.zeros(1)))
    with pytest.raises(EventError, match=r"index 3 comes after index 0, .* y=None, for each") as failure:
        stage.update(sample(3, np.zeros(1)))
    assert failure.value.field == "t"
    found = [stage.update(sample(i, None)) for i in (1, 2)]
    found.append(stage.update(sample(3, np.zeros(1))))
    assert found[-1].x[1] == pytest.approx(0.6**3)


def test_vertices_that_decay_one_by_one_but_not_in_turns_have_no_design() -> None:
    """Two nilpotent hidden parts whose product grows: no zero forbids it, no constant P proves it."""
    system = ParameterVaryingSystem(
        lambda p: np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 4.0 * p["k"]], [0.0, 4.0 * (1.0 - p["k"]), 0.0]]),
        lambda p: np.array([[1.0], [0.0], [0.0]]),
        np.eye(1, 3),
        time="discrete",
    )
    with pytest.raises(
        (InfeasibleError, UndecidedError), match=r"the invariant zeros allow a decay of 0\.05, but"
    ):
        UnknownInputObserver.design(system, Box({"k": (0.0, 1.0)}), 0.05)


@given(st.integers(0, 2**31))
@settings(max_examples=12, deadline=None)
def test_no_gain_has_a_larger_margin(seed: int) -> None:
    """The closed form of the gain beside gains round it: it decouples what the outputs hide."""
    rng = np.random.default_rng(seed)
    a, c = rng.normal(size=(4, 4)), rng.normal(size=(2, 4))
    root = rng.normal(size=(4, 4))
    p = root @ root.T + np.eye(4)
    k = discrete_gain(a, c, p)

    def energy(k: Any) -> Any:
        n = a - k @ c
        return n.T @ p @ n

    best = energy(k)
    blind = np.linalg.svd(c)[2][2:].T
    for _ in range(5):
        other = energy(k + 0.3 * rng.normal(size=k.shape))
        # The same on the kernel of C, and never less anywhere than what the kernel alone needs.
        assert np.allclose(blind.T @ other @ blind, blind.T @ best @ blind)
        room = blind.T @ p @ blind
        first = np.linalg.solve(room, blind.T @ a.T @ p @ a @ blind)
        hidden = p @ blind @ first @ np.linalg.solve(room, blind.T @ p)
        assert np.allclose(best, hidden)
        assert np.trace(other @ np.linalg.inv(p)) >= np.trace(best @ np.linalg.inv(p)) - 1e-9


@given(st.integers(0, 2**31))
@settings(max_examples=10, deadline=None)
def test_errors_are_powers_of_a_matrix_whatever_the_input_is(seed: int) -> None:
    """e+ = (T A - K C) e exactly, with jumps of the unknown input of any size, and within the bound."""
    rng = np.random.default_rng(seed)
    n, p, m = 5, int(rng.integers(2, 6)), int(rng.integers(1, 3))
    a, f, c = rng.normal(size=(n, n)), rng.normal(size=(n, m)), rng.normal(size=(p, n))
    a *= 0.6 / np.abs(np.linalg.eigvals(a)).max()
    try:
        observer = design(a, f, c, 0.025)
    except InfeasibleError:  # a zero outside
        return
    one = observer.certificate
    system, point = observer.system, {"k": 0.0}
    onward = system.ta(point) - observer.gains[0] @ c
    x, start = rng.normal(size=n), rng.normal(size=n)
    stage = observer.stage(start)
    errors, inputs = [], rng.normal(size=(12, m)) * 10.0 ** rng.uniform(-3, 3, (12, 1))
    for k in range(12):
        known = np.arange(n) * np.sin(k)
        estimate = stage.update(UnknownInputSample(k, c @ x, known, lambda _: point))
        errors.append(x - estimate.x)
        size = 1.0 + np.abs(inputs[max(0, k - 2) : k + 1]).max() + np.abs(x).max()
        if k:
            assert errors[k] == pytest.approx(onward @ errors[k - 1], abs=1e-8 * size)
        assert np.linalg.norm(errors[k]) <= one.bound(k, float(np.linalg.norm(errors[0]))) + 1e-8 * size
        x = a @ x + known + f @ inputs[k]


@pytest.mark.parametrize("time_varying_f", [False, True])
def test_a_varying_system_is_followed_and_its_input_reconstructed(time_varying_f: bool) -> None:
    """F may vary with a scheduling variable without its rate: T is that of the step."""

    def a(p: Any) -> Any:
        return np.array([[0.9, 0.3, 0.0], [-0.2, 0.7, p["k"]], [0.1, 0.0, 0.5]])

    def f(p: Any) -> Any:
        return np.array([[1.0], [0.4 * p["k"] if time_varying_f else 0.4], [0.0]])

    c = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    system = ParameterVaryingSystem(a, f, c, time="discrete")
    observer = UnknownInputObserver.design(system, Box({"k": (-0.5, 0.5)}), 0.05)
    rng, x = np.random.default_rng(2), np.array([1.0, -2.0, 0.5])
    stage = observer.stage(np.zeros(3))
    before: Any = None
    for i in range(120):
        p = {"k": 0.5 * np.sin(0.3 * i)}
        d = np.array([np.sign(np.sin(0.2 * i)) + rng.normal()])
        estimate = stage.update(UnknownInputSample(i, c @ x, np.zeros(3), constantly(p)))
        if i == 119:
            assert estimate.x == pytest.approx(x, abs=1e-3)
            assert estimate.d == pytest.approx(before, abs=1e-3)
            assert estimate.certified
        x, before = a(p) @ x + f(p) @ d, d


def test_missing_outputs_follow_the_model_and_the_rest_corrects() -> None:
    a, f = np.array([[0.9, 0.3], [-0.2, 0.7]]), np.array([[1.0], [0.5]])
    observer = design(a, f, np.eye(2), 0.05)
    x = np.array([1.0, 2.0])
    stage = observer.stage(x)
    for k in range(20):
        y = np.full(2, NAN) if 8 <= k < 12 else np.array([x[0], NAN if 15 <= k < 17 else x[1]])
        estimate = stage.update(UnknownInputSample(k, y, np.zeros(2), lambda _: {"k": 0.0}))
        assert estimate.x == pytest.approx(x, abs=1e-9)  # d is constant, so the model is right
        assert estimate.certified == (k < 8 or k in (13, 14) or k > 17)
        if k:
            assert estimate.d == pytest.approx([0.25], abs=1e-9)
        x = a @ x + f[:, 0] * 0.25
    # A jump of d while the second output is missing: the first one shows it, along F.
    x += f[:, 0] * 3.0
    estimate = stage.update(UnknownInputSample(20, np.array([x[0], NAN]), np.zeros(2), lambda _: {"k": 0.0}))
    assert estimate.x == pytest.approx(x, abs=1e-9)


def test_the_filter_of_a_discrete_input_is_the_scalar_one() -> None:
    """With C F = 1 it is the Kalman filter of a random walk: its gain solves g^2 = (1 - g) q / r."""
    stage = design(*TWO, decay=0.2).stage(np.zeros(2), noise=0.5, density=0.02)
    for k in range(200):
        estimate = stage.update(UnknownInputSample(k, np.zeros(1), np.zeros(2), lambda _: {"k": 0.0}))
    ratio = 0.02 / 0.25
    g = 0.5 * (-ratio + np.sqrt(ratio**2 + 4.0 * ratio))
    assert estimate.spread[0] == pytest.approx(0.5 * np.sqrt(g), rel=1e-9)
