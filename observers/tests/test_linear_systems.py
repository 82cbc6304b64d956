"""Plants of scipy and python-control, taken by every door as their Persidskii systems are."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy import signal

from pointpred.errors import ParameterError
from pointpred_observers import Generator, Persidskii, c2d, invariant_observer, steady_state_map, trajectory
from pointpred_observers.files import decoded, encoded
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.interconnected.tracking import closed_loop
from pointpred_observers.plants.linear_systems import as_plant
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import (
    assumption_3_2_2,
    assumption_3_2_3,
    certify_convergence,
    certify_tracking,
    design_state_feedback,
    regulator_equations,
    regulator_stage,
    residuals,
    sector_bounds,
    theorem_3_2_1,
    theorem_3_2_2,
    theorem_3_2_3,
)

A, B, C, D = [[0.0, 1.0], [-2.0, -0.5]], [[0.0], [1.0]], [[1.0, 0.0]], [[0.0]]
OWN = Persidskii(A, None, None, "identity", B, C0=C)
CIRCLE = Generator([[0.0, 1.0], [-1.0, 0.0]], L0=[[1.0, 0.0]])
REGULATOR = Regulator.design(OWN)
PI = steady_state_map(OWN, CIRCLE).Pi

DOORS: dict[str, Callable[[Any], Any]] = {
    "steady_state_map": lambda p: steady_state_map(p, CIRCLE).Pi,
    "residuals": lambda p: residuals(p, CIRCLE, PI)["A0 Pi - Pi G C0 Pi - Pi S0 + B L0"],
    "design_observer": lambda p: DrivenObserver.design(p, generator=CIRCLE, Pi=PI, decay=0.5).gain,
    "theorem_3_2_1": lambda p: [sorted(theorem_3_2_1(p, CIRCLE, PI).blocks)],
    "theorem_3_2_2": lambda p: [sorted(theorem_3_2_2(p, REGULATOR.regulator, REGULATOR.Pi).blocks)],
    "theorem_3_2_3": lambda p: [sorted(theorem_3_2_3(p, REGULATOR.regulator, REGULATOR.Pi).blocks)],
    "assumption_3_2_2": lambda p: assumption_3_2_2(p, decay=0.1).P,
    "assumption_3_2_3": lambda p: [sorted(assumption_3_2_3(p, REGULATOR.regulator, REGULATOR.Pi).blocks)],
    "certify_tracking": lambda p: certify_tracking(p, REGULATOR.regulator, REGULATOR.Pi).regulator.values[
        "P"
    ],
    "closed_loop": lambda p: closed_loop(p, REGULATOR.regulator, 0.0, [1.0, 2.0, 3.0, 4.0]),
    "regulator_stage": lambda p: regulator_stage(p, REGULATOR.regulator, start=[1.0, 2.0]).update(0.0, [1.0]),
    "sector_bounds": lambda p: sector_bounds(p).Sigma1,
    "design_reduced_order": lambda p: ReducedOrderObserver.design(p, decay=2.0).Upsilon,
    "invariant_observer": lambda p: invariant_observer(p, [[0.0, 1.0]], [[-3.0]]).at(0.0).S0,
    "certify_convergence": lambda p: certify_convergence(
        invariant_observer(p, [[0.0, 1.0]], [[-3.0]])
    ).values["P"],
    "design_state_feedback": lambda p: design_state_feedback(p).L0,
    "design_regulator": lambda p: Regulator.design(p).regulator.S0,
    "regulator_equations": lambda p: regulator_equations(p, CIRCLE).Pi,
    "c2d": lambda p: c2d(p, 0.1).A0,
    "beside": lambda p: CIRCLE.beside(p).L0,
}


@pytest.mark.parametrize("door", DOORS)
def test_every_door_takes_a_state_space_system(door: str) -> None:
    expected = DOORS[door](OWN)
    assert np.array_equal(DOORS[door](signal.StateSpace(A, B, C, D)), expected)


def test_systems_of_python_control() -> None:
    control = pytest.importorskip("control", reason="python-control is a tool of the tests only")
    for system in (control.ss(A, B, C, D), control.ss(control.tf([1.0], [1.0, 0.5, 2.0]))):
        design = ReducedOrderObserver.design(system, decay=2.0)
        assert design.certificate.bound.decay >= 2.0 - 1e-9
    sampled = control.c2d(control.ss(A, B, C, D), 0.1)
    assert as_plant(sampled).time == "discrete"
    assert np.array_equal(as_plant(sampled).A0, sampled.A)
    plant = as_plant(control.tf([1.0], [1.0, 0.5, 2.0]))
    assert np.poly(plant.A0) == pytest.approx([1.0, 0.5, 2.0])
    for one in (control.frd([1.0, 2.0], [1.0, 2.0]), control.tf([1.0, 1.0, 1.0], [1.0, 1.0])):
        with pytest.raises(ParameterError, match="must have a state-space form, received a"):
            as_plant(one)
    assert as_plant(control.ss(A, B, C, D, None)).time == "continuous"
    assert as_plant(control.ss(A, B, C, D, True)).time == "discrete"
    own = control.poles(control.ss(A, B, C, D))
    assert np.sort_complex(np.linalg.eigvals(as_plant(control.ss(A, B, C, D)).A0)) == pytest.approx(
        np.sort_complex(own)
    )


def test_systems_of_scipy() -> None:
    assert as_plant(signal.lti(A, B, C, D)).time == "continuous"
    assert as_plant(signal.dlti(A, B, C, D, dt=0.1)).time == "discrete"
    for one in (
        signal.TransferFunction([1.0], [1.0, 0.5, 2.0]),
        signal.ZerosPolesGain([], [-1.0, -2.0], 3.0),
    ):
        plant = as_plant(one)
        w, response = signal.freqresp(one, [0.7])
        inside = plant.C0 @ np.linalg.solve(1j * w[0] * np.eye(2) - plant.A0, plant.B)
        assert complex(inside[0, 0]) == pytest.approx(complex(response[0]))


def test_tracking_without_a_nonlinearity() -> None:
    certificate = certify_tracking(OWN, REGULATOR.regulator, REGULATOR.Pi)
    for values, a in (
        (certificate.regulator.values, OWN.A0 + OWN.B @ REGULATOR.feedback.L0),
        (certificate.error.values, OWN.A0 - REGULATOR.observer.gain @ OWN.C0),
    ):
        assert np.linalg.eigvalsh(a.T @ values["P"] + values["P"] @ a).max() < 0.0


def test_a_linear_plant_needs_no_f() -> None:
    cart = Persidskii([[0.0, 1.0], [0.0, -1.0]], B=[0.0, 1.0], C0=[1.0, 0.0])
    assert (cart.k, cart.r, cart.field(0.0, [1.0, 2.0], u=3.0).tolist()) == (0, 0, [2.0, 1.0])


A0 = np.array([[0.0, 1.0], [-2.0, -0.3]])


PLANT = Persidskii(A0, [0.0, -0.5], [1.0, 0.0], "sin", [0.0, 1.0], [1.0, 0.0], [1.0, 0.0])


def test_the_linear_part_is_that_of_scipy() -> None:
    held = c2d(PLANT, 0.2)
    drive = np.hstack([PLANT.A1, PLANT.B, PLANT.Q])
    ad, bd, *_ = signal.cont2discrete((A0, drive, PLANT.C0, np.zeros((1, 3))), 0.2)
    assert pytest.approx(ad, abs=1e-14) == held.A0
    assert np.hstack([held.A1, held.B, held.Q]) == pytest.approx(bd, abs=1e-14)
    assert (held.time, held.slopes, held.C0.tolist()) == ("discrete", PLANT.slopes, PLANT.C0.tolist())


def test_a_linear_plant_under_held_inputs_is_exact() -> None:
    plant = Persidskii(A0, None, None, "sin", [0.0, 1.0])
    held, rng, x = c2d(plant, 0.3), np.random.default_rng(1), np.array([1.0, 0.0])
    for k in range(8):
        u = rng.normal(size=1)
        true = trajectory(lambda t, one: plant.field(t, one, u), x, [0.0, 0.3])[-1]  # noqa: B023
        x = held.field(k, x, u)
        assert x == pytest.approx(true, abs=1e-9)


@pytest.mark.parametrize("method", ["zoh", "euler"])
def test_half_the_step_is_half_the_error(method: str) -> None:
    true = trajectory(PLANT.field, [1.0, 0.0], [0.0, 2.0])[-1]
    errors = []
    for count in (100, 200, 400):
        sampled = c2d(PLANT, 2.0 / count, method=method)
        end = trajectory(sampled.field, [1.0, 0.0], np.arange(count + 1), time="discrete")[-1]
        errors.append(np.abs(end - true).max())
    assert np.array(errors[:-1]) / errors[1:] == pytest.approx(2.0, rel=0.05)


def test_euler_keeps_the_steady_state_map() -> None:
    plant = Persidskii(
        [[-1.0, 0.5], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.0], "tanh", [0.0, 1.0], None, [1.0, 0.0]
    )
    generator = Generator([[0.0]], [[0.0]], L0=[[4.0]], L1=[[1.0]])
    pi = steady_state_map(plant, generator).Pi
    left = residuals(c2d(plant, 0.1, method="euler"), c2d(generator, 0.1, method="euler"), pi)
    assert max(np.abs(one).max() for one in left.values()) < 1e-14
    assert steady_state_map(
        c2d(plant, 0.1, method="euler"), c2d(generator, 0.1, method="euler")
    ).Pi == pytest.approx(pi)


def test_python_control_samples_alike() -> None:
    control = pytest.importorskip("control", reason="python-control is a tool of the tests only")
    system = control.ss(A0, [[0.0], [1.0]], [[1.0, 0.0]], [[0.0]])
    other = control.c2d(system, 0.1, "zoh")
    held = c2d(system, 0.1)
    assert pytest.approx(other.A, abs=1e-12) == held.A0
    assert pytest.approx(other.B, abs=1e-12) == held.B


def test_a_generator_of_another_time_is_refused() -> None:
    generator = Generator([[0.0]], [[0.0]], L0=[[4.0]], L1=[[1.0]])
    sampled = c2d(generator, 0.1)
    assert sampled.time == "discrete"
    with pytest.raises(ParameterError, match="a continuous generator, received a discrete one"):
        c2d(sampled, 0.1)
    with pytest.raises(ParameterError, match="the generator is discrete and the plant continuous"):
        steady_state_map(PLANT, sampled)
    with pytest.raises(ParameterError, match="the generator is continuous and the plant discrete"):
        steady_state_map(c2d(PLANT, 0.1), Generator([[0.0]], time="continuous"))
    assert decoded(encoded(sampled)).time == "discrete"
    assert decoded(encoded(generator)).time is None
