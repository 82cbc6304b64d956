"""Plants that are weakly coupled one way: their designs are those of the plants without the coupling."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm, solve_continuous_are, solve_continuous_lyapunov

import pointpred_observers as o
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.observer import UnknownInputObserver

COUPLINGS = (1e-9, 1e-6, 1e-3, 0.1, 1.0)
SPEEDS = [1, 3]


def axes(coupling: float, **more: Any) -> o.Persidskii:
    """Two axes, place and speed of each; the second place pushes the first axis."""
    a = np.diag([1.0, coupling, 1.0], 1)
    inputs = np.eye(4)[:, SPEEDS]
    return o.Persidskii(a, None, None, "sin", inputs, None, np.eye(4)[[0, 2]], **more)


def closed(coupling: float) -> o.ErrorSystem:
    """The axes, each with a feedback of its own."""
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
    condition = float(np.sqrt(np.linalg.cond(design.certificate.p)))
    return {"gain": float(np.abs(design.gains).max()), "overshoot": condition}


def of_decay(coupling: float) -> dict[str, float]:
    bound = o.certify_decay(closed(coupling), decay=1.0).bound
    return {"overshoot": bound.overshoot, "gain": bound.gains[0]}


def of_l2_gain(coupling: float) -> dict[str, float]:
    found = o.l2_gain(closed(coupling))
    assert found.upper < 1.01 * found.lower
    return {"gain": found.upper}


DESIGNS = {
    one.__name__.removeprefix("of_"): one
    for one in (
        of_full_order,
        of_reduced_order,
        of_regulator,
        of_interlaced,
        of_unknown_input,
        of_decay,
        of_l2_gain,
    )
}


@pytest.mark.parametrize("kind", DESIGNS)
def test_a_weak_coupling_changes_a_design_by_less_than_a_factor_of_two(kind: str) -> None:
    alone = DESIGNS[kind](0.0)
    for coupling in COUPLINGS:
        for name, size in DESIGNS[kind](coupling).items():
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


def test_a_closed_loop_is_certified_in_the_users_units_where_these_are_better() -> None:
    """In balanced units the overshoot is 45,000; it reaches at most 3.4."""
    found = o.certify_decay(closed(1e-3), decay=1.0)
    assert found.bound.overshoot < 4.0
