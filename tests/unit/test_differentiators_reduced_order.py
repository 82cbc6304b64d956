"""The reduced-order differentiator is the observer that Proposition 3.3.1 makes of a hand, solved exactly."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import linalg

from pointpred import EventColumns
from pointpred.differentiators import ReducedOrderDifferentiator
from pointpred.differentiators import reduced_order as law
from pointpred_observers import Persidskii, certify_convergence, invariant_observer, invariant_stage

PX_M = 0.0254 / 96.0
HAND = Persidskii([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0, 0.0])
PI = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]


def wandering() -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(6)
    t = np.cumsum(random.choice([0.001, 0.004, 0.008, 0.0167], 150))
    return t, np.round(np.cumsum(random.standard_normal(150) * 5.0))


@pytest.mark.parametrize(("bandwidth", "damping"), [(60.0, 0.5), (20.0, 1.0), (150.0, 0.1)])
def test_it_is_the_observer_of_proposition_3_3_1(bandwidth: float, damping: float) -> None:
    """Designed in one room, run in another: the compiled observer of the same plant says the same."""
    gains = [[-2.0 * damping * bandwidth], [-(bandwidth**2)]]
    observer = invariant_observer(HAND, PI, gains)
    now = observer.at(0.0)
    s0, poles = now.S0, np.poly(now.S0)
    assert s0 == pytest.approx(np.array([[gains[0][0], 1.0], [gains[1][0], 0.0]]), abs=1e-9)
    assert poles == pytest.approx([1.0, 2.0 * damping * bandwidth, bandwidth**2], abs=1e-9)
    t, x = wandering()
    u = (x - x[0]) * PX_M
    differentiator = ReducedOrderDifferentiator(bandwidth=bandwidth, damping=damping)
    motions = differentiator.run(EventColumns.of(t, x, -2.0 * x))
    stage = invariant_stage(observer, step_s=2e-5)
    states = stage.walk(np.zeros(len(t), np.bool_), np.column_stack([t, u]))
    assert motions.vx == pytest.approx(states[:, 1], abs=1e-6 * np.abs(states[:, 1]).max())
    assert motions.ax == pytest.approx(states[:, 2], abs=1e-6 * np.abs(states[:, 2]).max())
    assert motions.vy == pytest.approx(-2.0 * motions.vx, rel=1e-9)


@pytest.mark.parametrize("damping", [0.1, 0.5, 0.999999999, 1.0])
@pytest.mark.parametrize("dt", [1e-6, 1e-3, 0.05, 3.0])
def test_an_interval_is_solved_exactly(damping: float, dt: float) -> None:
    differentiator = ReducedOrderDifferentiator(damping=damping, bandwidth=37.0)
    memory = differentiator._memory
    memory[law.X], memory[law.X + 1] = 0.4, -3.0
    law.follow(memory, law.X, 0.25, dt)
    s0 = np.array([[-2.0 * damping * 37.0, 1.0], [-(37.0**2), 0.0]])
    wanted = linalg.expm(s0 * dt) @ [0.4 - 0.25, -3.0] + [0.25, 0.0]
    assert memory[law.X : law.X + 2] == pytest.approx(wanted, rel=1e-9, abs=1e-9)


def test_its_gains_have_a_certificate() -> None:
    found = certify_convergence(invariant_observer(HAND, PI, [[-60.0], [-3600.0]]), kappa=1e6)
    assert min(found.margins.values()) > 0.0
    assert found.bound.rate > 0.05 * 30.0


def test_settles_when_it_says() -> None:
    """From a start in mid-movement the velocity is right to 5 % once settled, and not before."""
    t = np.arange(600) * 0.001
    motions = ReducedOrderDifferentiator().run(EventColumns.of(t, 0.3 * t / PX_M, t))
    off = np.abs(motions.vx / 0.3 - 1.0)
    settled = motions.settled == 1.0
    assert off[settled].max() < 0.05 < off[~settled].max()
