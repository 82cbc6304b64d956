"""Units of states, outputs and time change neither whether a design exists nor, scaled back, the design."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from evidence.observers.designs import gap
from evidence.observers.plants import DOORS, Problem
from pointpred.errors import InfeasibleError, UndecidedError
from pointpred_observers import Persidskii, invariant_observer
from pointpred_observers.numerics.balance import balanced, inward
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_convergence

ARM = ([[0.0, 1.0], [0.0, -0.1]], [0.0, -2.0], [1.0, 0.0])


def arm() -> Persidskii:
    """The arm of observers/docs: angle measured, speed to be estimated."""
    a0, a1, h = ARM
    return Persidskii(a0, a1, h, "sin", [0.0, 1.0], None, [1.0, 0.0])


@pytest.mark.parametrize("decay", [60.0, 70.0, 100.0, 300.0, 1000.0])
def test_a_fast_observer_of_the_arm_is_designed(decay: float) -> None:
    design = ReducedOrderObserver.design(arm(), Pi=[[0.0, 1.0]], decay=decay)
    assert design.certificate.bound.decay >= decay
    assert design.Upsilon[0, 0] == pytest.approx(-(1.5 * decay - 0.1), rel=0.01)


@pytest.mark.parametrize(
    ("n", "seed"),
    [
        pytest.param(n, seed, marks=[pytest.mark.slow] if n + seed > 6 else [])
        for n in (6, 8)
        for seed in range(4)
    ],
)
def test_random_linear_plants_with_one_output_are_designed(n: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    plant = Persidskii(random.standard_normal((n, n)), None, None, "sin", C0=random.standard_normal((1, n)))
    design = ReducedOrderObserver.design(plant, decay=0.5)
    assert design.certificate.bound.decay >= 0.5
    assert np.linalg.eigvals(design.observer.at(0.0).S0).real.max() < -0.5


def test_a_slow_observer_is_certified_without_a_decay() -> None:
    """e'' + 0.02 e' + e = 0 with a weak nonlinearity: only rates far below the slowest corner's hold."""
    plant = Persidskii(
        [[0.0, 1.0, 0.0], [-1.0, -0.02, 0.1], [0.0, 0.0, 0.0]],
        [0.0, 0.0097, 0.0],
        [0.0, 1.0, 0.0],
        "tanh",
        C0=[0.0, 0.0, 1.0],
        slopes=(-1.0, 1.0),
    )
    observer = invariant_observer(plant, np.eye(2, 3), np.zeros((2, 1)))
    assert certify_convergence(observer, decay=1e-4, gamma=1e-4).bound.decay >= 1e-4
    assert certify_convergence(observer).bound.decay > 0.0


SEEDS = st.integers(0, 2**32 - 1)


MOVED = {
    "`design_observer`": lambda found, one: found.gain * one.x[:, None] / one.y / one.t,
    "`design_observer`, discrete": lambda found, one: found.gain * one.x[:, None] / one.y,
    "`design_reduced_order`, linear": lambda found, one: rate(found.certificate, one),
    "`design_reduced_order`, `injection=True`": lambda found, one: rate(found.certificate, one),
    "`design_reduced_order`, discrete": lambda found, one: found.certificate.bound.decay,
    "`certify_convergence`": lambda found, one: rate(found, one),
    "`certify_tracking`": lambda found, one: shape(found.error.values["P"] / one.x / one.x[:, None]),
    "`certify_interlaced`": lambda found, one: found.L * one.x[:, None] / one.y[0] / one.t,
    "`UnknownInputObserver.design`": lambda found, one: min(found.certificate.largest_decay / one.t, 1e9),
}
"""Of each answer something that does not depend on the units once it is scaled back."""


def shape(p: Any) -> Any:
    return p / p[0, 0]


def rate(certificate: Any, one: Problem) -> float:
    return float(certificate.bound.decay / one.t)


def problem(seed: int, units: bool) -> Problem:
    one = Problem("random", np.random.default_rng(seed), largest=4)
    if units:
        random = np.random.default_rng(seed + 1)
        one.x = 10.0 ** random.uniform(-6.0, 6.0, one.n)
        one.y = 10.0 ** random.uniform(-6.0, 6.0, one.p)
        one.t = 10.0 ** random.uniform(-5.0, 5.0)
    return one


def answer(door: str, one: Problem) -> Any:
    try:
        found = DOORS[door](one)
        if (gap(found) or 0.0) > 0.1:
            return "no minimum"  # what the answer says itself
        return MOVED[door](found, one)
    except (InfeasibleError, UndecidedError) as refused:
        return type(refused)


@pytest.mark.slow
@pytest.mark.parametrize("door", list(DOORS))
@given(SEEDS)
@example(329)  # a gain of 1e12, with which rounding passed for a design of `design_observer`
@settings(max_examples=15, deadline=None)
def test_units_change_nothing(door: str, seed: int) -> None:
    """States and outputs in units up to 1e6 times larger or smaller, time in units up to 1e5 times."""
    first, second = answer(door, problem(seed, False)), answer(door, problem(seed, True))
    if isinstance(first, str) or isinstance(second, str):
        assert isinstance(first, type) == isinstance(second, type)
    elif isinstance(first, type):
        assert isinstance(second, type)  # refused or undecided, but no design
    else:
        assert second == pytest.approx(first, rel=1e-2, abs=1e-3 * float(np.abs(first).max()))


@pytest.mark.parametrize("door", list(DOORS))
def test_a_design_of_each_door_in_other_units(door: str) -> None:
    """The same on one problem, for every run of the tests."""
    plain = ((seed, answer(door, problem(seed, False))) for seed in range(20))
    seed, first = next((seed, one) for seed, one in plain if not isinstance(one, type | str))
    second = answer(door, problem(seed, True))
    assert second == pytest.approx(first, rel=1e-2, abs=1e-3 * float(np.abs(first).max()))


def system(seed: int, sparse: float) -> dict[str, Any]:
    random = np.random.default_rng(seed)
    n, p, k = int(random.integers(1, 7)), 1, int(random.integers(0, 3))
    shapes = {"drift": (n, n), "seen": (p, n), "driven": (n, k), "shown": (p, k), "inner": (k, n)}
    return {
        name: random.standard_normal(shape) * (random.uniform(size=shape) > sparse)
        for name, shape in shapes.items()
    }


def moved(parts: dict[str, Any], one: Any) -> dict[str, Any]:
    x, y, v, s, t = one.states, one.outputs, one.values, one.arguments, one.seconds
    return {
        "drift": inward(parts["drift"], x, x, t),
        "seen": inward(parts["seen"], y, x),
        "driven": inward(parts["driven"], x, v, t),
        "shown": inward(parts["shown"], y, v),
        "inner": inward(parts["inner"], s, x),
    }


@given(st.integers(0, 2**32 - 1), st.sampled_from([0.0, 0.3, 0.6]))
@settings(max_examples=40, deadline=None)
def test_balanced_entries_do_not_depend_on_the_units(seed: int, sparse: float) -> None:
    """Reducible and disconnected systems too: every unit up to 1e6 larger or smaller, time up to 1e5."""
    parts, random = system(seed, sparse), np.random.default_rng(seed)
    n, p, k = len(parts["drift"]), len(parts["seen"]), len(parts["inner"])
    slopes = tuple((-0.5, 2.0) for _ in range(k))
    x, y, v, s = (10.0 ** random.uniform(-6.0, 6.0, size) for size in (n, p, k, k))
    t = 10.0 ** random.uniform(-5.0, 5.0)
    other = {
        "drift": inward(parts["drift"], x, x, t),
        "seen": inward(parts["seen"], y, x),
        "driven": inward(parts["driven"], x, v, t),
        "shown": inward(parts["shown"], y, v),
        "inner": inward(parts["inner"], s, x),
    }
    one = balanced(**parts, slopes=slopes, rates=(1.5,))
    two = balanced(
        **other,
        slopes=tuple((a * b / c, d * b / c) for (a, d), b, c in zip(slopes, s, v, strict=True)),
        rates=(1.5 * t,),
    )
    first, second = moved(parts, one), moved(other, two)
    for name in first:
        assert second[name] == pytest.approx(first[name], rel=1e-6, abs=1e-12), name
    assert 1.5 * t * two.seconds == pytest.approx(1.5 * one.seconds, rel=1e-6)


def test_a_cascade_is_balanced_although_it_is_reducible() -> None:
    """A chain of integrators, for which the sum of squares has no minimum."""
    chain = np.diag([1e-6, 1e3], 1)
    one = balanced(chain, seen=[[50.0, 0.0, 0.0]], rates=(0.1,))
    assert inward(chain, one.states, one.states, one.seconds)[[0, 1], [1, 2]] == pytest.approx([1.0, 1.0])
    assert inward([[50.0, 0.0, 0.0]], one.outputs, one.states)[0, 0] == pytest.approx(1.0)
