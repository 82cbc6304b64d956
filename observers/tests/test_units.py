"""Units of states, outputs and time change neither whether a design exists nor, scaled back, the design."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred.errors import InfeasibleError
from pointpred_observers import Generator, Persidskii, invariant_observer
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.plants.boxes import Box
from pointpred_observers.plants.varying import ParameterVaryingSystem
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_convergence
from pointpred_observers.unknown_input.observer import UnknownInputObserver

ARM = ([[0.0, 1.0], [0.0, -0.1]], [0.0, -2.0], [1.0, 0.0])


def arm() -> Persidskii:
    """The arm of observers/docs: angle measured, speed to be estimated."""
    a0, a1, h = ARM
    return Persidskii(a0, a1, h, "sin", [0.0, 1.0], None, [1.0, 0.0])


def rescaled(plant: Persidskii, states: Any, outputs: Any, seconds: float) -> Persidskii:
    """The plant in other units: x = ``states`` x~, y = ``outputs`` y~, and t = ``seconds`` t~."""
    d, e = np.asarray(states, np.float64), np.asarray(outputs, np.float64)
    return Persidskii(
        seconds * plant.A0 * d / d[:, None],
        seconds * plant.A1 / d[:, None],
        plant.H * d,
        plant.f,
        seconds * plant.B / d[:, None],
        seconds * plant.Q / d[:, None],
        plant.C0 * d / e[:, None],
        plant.C1 / e[:, None],
    )


def oscillator() -> Persidskii:
    """A mass on a hardening spring with friction, in metres and metres per second; its place is measured."""
    return Persidskii(
        [[0.0, 1.0], [-4.0, -0.4]], [0.0, -1.0], [1.0, 0.0], "tanh", [0.0, 1.0], None, [1.0, 0.0]
    )


def tanks() -> Persidskii:
    """Three tanks in a row, in seconds: the time constants are some minutes, the last level is measured."""
    k = 1.0 / 600.0
    a0 = [[-k, k, 0.0], [k, -2.0 * k, k], [0.0, k, -2.0 * k]]
    return Persidskii(a0, None, None, "tanh", [k, 0.0, 0.0], None, [0.0, 0.0, 1.0])


@pytest.mark.parametrize("decay", [60.0, 70.0, 100.0, 300.0, 1000.0])
def test_a_fast_observer_of_the_arm_is_designed(decay: float) -> None:
    design = ReducedOrderObserver.design(arm(), Pi=[[0.0, 1.0]], decay=decay)
    assert design.certificate.bound.decay >= decay
    assert design.Upsilon[0, 0] == pytest.approx(-(1.5 * decay - 0.1), rel=0.01)


@pytest.mark.parametrize("scale", [1e-2, 1e2, 1e4])
def test_the_unit_of_a_velocity_does_not_matter(scale: float) -> None:
    plant = oscillator()
    other = rescaled(plant, [1.0, 1.0 / scale], [1.0], 1.0)
    pi, other_pi = [[0.0, 1.0]], [[0.0, 1.0]]
    one = ReducedOrderObserver.design(plant, Pi=pi, decay=2.0)
    two = ReducedOrderObserver.design(other, Pi=other_pi, decay=2.0)
    assert two.Upsilon / scale == pytest.approx(one.Upsilon, rel=1e-4)
    assert two.certificate.bound.decay == pytest.approx(one.certificate.bound.decay, rel=1e-3)


@pytest.mark.parametrize("scale", [1e-2, 1e2, 1e4])
def test_the_unit_of_a_velocity_does_not_matter_for_a_full_observer(scale: float) -> None:
    plant = oscillator()
    other = rescaled(plant, [1.0, 1.0 / scale], [1.0], 1.0)
    gains = []
    for one, units in ((plant, np.ones(2)), (other, np.array([1.0, scale]))):
        model = Generator(one.A0, one.A1, one.H, L0=np.zeros((1, 2)))
        gains.append(
            DrivenObserver.design(one, generator=model, Pi=np.eye(2), decay=1.0).gain / units[:, None]
        )
    assert gains[1] == pytest.approx(gains[0], rel=1e-3)


def test_seconds_are_as_good_as_hours() -> None:
    in_seconds = ReducedOrderObserver.design(tanks(), decay=5e-4)
    in_hours = ReducedOrderObserver.design(rescaled(tanks(), np.ones(3), [1.0], 3600.0), decay=1.8)
    assert in_seconds.certificate.bound.decay >= 5e-4
    assert in_seconds.Upsilon == pytest.approx(in_hours.Upsilon, rel=1e-3)


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


def test_a_rate_that_cannot_be_reached_is_named() -> None:
    plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", C0=[1.0, 0.0])
    observer = invariant_observer(plant, [[0.0, 1.0]], [[-3.0]])
    with pytest.raises(InfeasibleError, match=r"decay = 5\b.*gamma = 2\b"):
        certify_convergence(observer, decay=5.0, gamma=2.0)


@pytest.mark.parametrize("seconds", [1e5, 1e-5])
def test_the_unit_of_time_does_not_matter_beside_unknown_inputs(seconds: float) -> None:
    """The rate of the outputs' errors is left to the design."""
    a = np.array([[-0.5, 1.0, 0.0], [-1.0, -2.0, 0.3], [0.0, 0.4, -1.0]])
    moving = np.array([[0.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]])

    def design(unit: float) -> Any:
        system = ParameterVaryingSystem(
            lambda p: unit * (a + p["k"] * moving),
            [[1.0], [0.0], [0.0]],
            [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        )
        observer = UnknownInputObserver.design(system, Box({"k": (0.0, 1.0)}), 0.5 * unit)
        return observer.gains / unit, observer.fastest / unit

    (wanted, rate), (gains, other) = design(1.0), design(seconds)
    assert other == pytest.approx(rate, rel=1e-2)
    assert gains == pytest.approx(wanted, rel=1e-3, abs=1e-4)


def forced(scale: float) -> ParameterVaryingSystem:
    """Three states, an unknown input at the measured one; the unit of the last state is ``scale``."""
    d = np.array([1.0, 1.0, scale])

    def a(p: Any) -> Any:
        now = np.array([[-1.0, 0.0, 1.0], [0.0, p["k"], 0.5], [0.0, 1.0, -2.0]])
        return now * d / d[:, None]

    return ParameterVaryingSystem(a, lambda p: np.array([[1.0], [0.0], [0.0]]), np.eye(1, 3))


@pytest.mark.parametrize("scale", [1e-6, 1e-3, 1e3, 1e6])
def test_the_unit_of_a_state_does_not_matter_beside_unknown_inputs(scale: float) -> None:
    box, d = Box({"k": (-3.0, -1.0)}), np.array([1.0, 1.0, scale])
    one = UnknownInputObserver.design(forced(1.0), box, 0.25)
    two = UnknownInputObserver.design(forced(scale), box, 0.25)
    back = (two.certificate.p / d / d[:, None])[1:, 1:]
    wanted = one.certificate.p[1:, 1:]
    assert back / back[0, 0] == pytest.approx(wanted / wanted[0, 0], rel=1e-3, abs=1e-6)
    assert two.gains * d[:, None] == pytest.approx(one.gains, rel=1e-3, abs=1e-6)
