"""Units of states, outputs and time change neither whether a design exists nor, scaled back, the design."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.linalg import expm, solve_continuous_are, solve_continuous_lyapunov

import pointpred_observers as o
from evidence.observers.designs import gap
from evidence.observers.plants import DOORS, Problem
from pointpred.errors import InfeasibleError, UndecidedError
from pointpred_observers import Persidskii, invariant_observer
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_convergence
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.observer import UnknownInputObserver

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
    a0, a1, h = [[0.0, 1.0, 0.0], [-1.0, -0.02, 0.1], [0.0, 0.0, 0.0]], [0.0, 0.0097, 0.0], [0.0, 1.0, 0.0]
    plant = Persidskii(a0, a1, h, "tanh", C0=[0.0, 0.0, 1.0], slopes=(-1.0, 1.0))
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
    plain = ((seed, answer(door, problem(seed, False))) for seed in range(20))
    seed, first = next((seed, one) for seed, one in plain if not isinstance(one, type | str))
    second = answer(door, problem(seed, True))
    assert second == pytest.approx(first, rel=1e-2, abs=1e-3 * float(np.abs(first).max()))


COUPLINGS = (1e-9, 1e-6, 1e-3, 0.1, 1.0)


SPEEDS = [1, 3]


def axes(coupling: float, **more: Any) -> o.Persidskii:
    """Two axes, place and speed of each; the second place pushes the first axis."""
    a = np.diag([1.0, coupling, 1.0], 1)
    inputs = np.eye(4)[:, SPEEDS]
    return o.Persidskii(a, None, None, "sin", inputs, None, np.eye(4)[[0, 2]], **more)


def closed(coupling: float) -> o.ErrorSystem:
    a = np.diag([1.0, coupling, 1.0], 1) - np.kron(np.eye(2), [[0.0, 0.0], [9.0, 6.0]])
    return o.ErrorSystem(a[None], np.eye(4)[None], np.eye(4), ("",), {"d": 4}, "continuous")


def noise(plant: o.Persidskii, gain: Any) -> float:
    """The RMS error of a speed with white noise of the outputs of density 1."""
    rest = plant.A0 - gain @ plant.C0
    return float(np.sqrt(np.diag(solve_continuous_lyapunov(rest, -gain @ gain.T))[SPEEDS].max()))


def of_full_order(coupling: float) -> dict[str, float]:
    plant = axes(coupling)
    design = o.design(plant, "full", decay=2.0)
    sizes = {"gain": float(np.abs(design.gain).max()), "noise": noise(plant, design.gain)}
    return {**sizes, "overshoot": design.bound.overshoot, "gain of v": design.bound.gains[0]}


def of_reduced_order(coupling: float) -> dict[str, float]:
    design = o.design(axes(coupling), "reduced", decay=2.0)
    bound = design.certificate.bound
    return {
        "gain": float(np.abs(design.Upsilon).max()),
        "overshoot": bound.overshoot,
        "delta": bound.gains[0],
    }


def of_regulator(coupling: float) -> dict[str, float]:
    design = o.design(axes(coupling), "regulator", decay=2.0)
    feedback = design.feedback
    return {
        "G": float(np.abs(design.observer.gain).max()),
        "L0": float(np.abs(feedback.L0).max()),
        "observer": design.observer.bound.overshoot,
        "feedback": feedback.certificate.bound.overshoot,
    }


def of_interlaced(coupling: float) -> dict[str, float]:
    plant = axes(coupling)
    found = certify_interlaced(plant.A0, plant.C0, decay=1.0)
    sizes = {"overshoot": found.bound.overshoot, "noise": found.bound.gains[0]}
    return {"gain": float(np.abs(found.L).max()), **sizes, "speed": noise(plant, found.L)}


def of_unknown_input(coupling: float) -> dict[str, float]:
    """A force on a third mass is not known."""
    a = np.zeros((5, 5))
    a[:4, :4], a[4, 4], a[4, 0] = axes(coupling).A0, -1.0, 0.3

    def moved(p: Any) -> Any:
        now = a.copy()
        now[1, 1] = p["k"]
        return now

    c, f = np.eye(5)[[0, 2, 4]], np.eye(5)[:, 4:]
    system = o.ParameterVaryingSystem(moved, f, c)
    design = UnknownInputObserver.design(system, o.Box({"k": (-1.0, 0.0)}), 1.0)
    condition = float(np.sqrt(np.linalg.cond(design.certificate.P)))
    return {"gain": float(np.abs(design.gains).max()), "overshoot": condition}


def of_decay(coupling: float) -> dict[str, float]:
    bound = o.certify_decay(closed(coupling), decay=1.0).bound
    return {"overshoot": bound.overshoot, "gain": bound.gains[0]}


def of_l2_gain(coupling: float) -> dict[str, float]:
    found = o.l2_gain(closed(coupling))
    assert found.upper < 1.01 * found.lower
    return {"gain": found.upper}


@pytest.mark.parametrize(
    "sizes",
    [of_full_order, of_reduced_order, of_regulator, of_interlaced, of_unknown_input, of_decay, of_l2_gain],
)
def test_a_weak_coupling_changes_a_design_by_less_than_a_factor_of_two(sizes: Any) -> None:
    alone = sizes(0.0)
    for coupling in COUPLINGS:
        for name, size in sizes(coupling).items():
            assert 0.5 * alone[name] < size < 2.0 * alone[name], (coupling, name)


@pytest.mark.parametrize("coupling", [0.0, *COUPLINGS])
def test_a_design_is_within_a_factor_of_two_of_one_by_riccati(coupling: float) -> None:
    plant = axes(coupling)
    shifted = plant.A0 + 2.0 * np.eye(4)
    filtered = solve_continuous_are(shifted.T, plant.C0.T, np.eye(4), np.eye(2)) @ plant.C0.T
    gain = o.design(plant, "full", decay=2.0).gain
    assert np.abs(gain).max() < 2.0 * np.abs(filtered).max()
    assert noise(plant, gain) < 2.0 * noise(plant, filtered)


@pytest.mark.parametrize(("mass", "length", "friction"), [(0.1, 0.5, 0.0), (0.2, 0.3, 0.0), (0.1, 0.5, 0.1)])
def test_the_overshoot_of_a_cart_with_a_pole(mass: float, length: float, friction: float) -> None:
    """Place and angle measured, the speeds by a reduced-order observer: up to 1.4e11 if balanced."""
    a = np.zeros((4, 4))
    a[0, 1] = a[2, 3] = 1.0
    a[1, 1:3] = -friction, -9.81 * mass
    a[3, 1:3] = friction / length, 9.81 * (1.0 + mass) / length
    plant = o.Persidskii(a, None, None, "sin", [0.0, 1.0, 0.0, -1.0 / length], None, np.eye(4)[[0, 2]])
    design = o.design(plant, "reduced", decay=2.0)
    s0 = design.observer.at(0.0).S0
    true = max(np.linalg.norm(expm(s0 * t) * np.exp(2.0 * t), 2) for t in np.linspace(0.0, 5.0, 200))
    assert design.certificate.bound.overshoot < 3.0 * true


@pytest.mark.parametrize("kind", ["full", "reduced"])
@pytest.mark.parametrize("coupling", [1e-12, 1e-9, 1e-7, 1e-6, 1e-3])
def test_a_weak_coupling_seen_by_one_output_leaves_the_design_as_it_is(kind: str, coupling: float) -> None:
    """Units that are balanced for it would show one of the oscillators by 1e-7 only."""
    a = np.zeros((4, 4))
    a[:2, :2], a[2:, 2:] = [[0.0, 1.0], [-1.0, 0.0]], [[0.0, 3.0], [-3.0, 0.0]]
    alone = o.design(o.Persidskii(a, C0=[1.0, 1.0, 1.0, 1.0]), kind, decay=0.2).bound
    a[:2, 2:] = coupling
    bound = o.design(o.Persidskii(a, C0=[1.0, 1.0, 1.0, 1.0]), kind, decay=0.2).bound
    assert bound.overshoot < 2.0 * alone.overshoot
    assert max(bound.gains) < 2.0 * max(alone.gains)


@pytest.mark.parametrize("unit", [1e-10, 1e10])
def test_a_reduced_order_design_in_units_that_hide_the_rank(unit: float) -> None:
    """In them the rows of Pi and C0 look dependent; the design of balanced units stands."""
    plant = Persidskii([[0.0, 1.0], [-1.0, -1.0]], C0=[[unit, 0.0]])
    design = ReducedOrderObserver.design(plant, decay=2.0)
    upsilon, pi = design.observer.at(0.0).Z[0]
    assert upsilon / pi == pytest.approx(-2.0, rel=1e-3)
