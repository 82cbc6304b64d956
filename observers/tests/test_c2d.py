"""Sampled plants beside scipy, simulations and the steady-state map."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import signal

from pointpred.errors import ParameterError
from pointpred_observers import Generator, Persidskii, c2d, steady_state_map, trajectory
from pointpred_observers.files import decoded, encoded
from pointpred_observers.thesis import residuals

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


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((c2d(PLANT, 0.1), 0.1), "needs a continuous plant"),
        ((PLANT, 0.0), "step_s must be finite and above 0"),
        ((PLANT, "fast"), "step_s must be finite and above 0"),
        ((Persidskii(lambda t: [[-1.0]], None, None, "sin"), 0.1), "constant matrices; A0 vary"),
        ((3.0, 0.1), "a plant must be a Persidskii system or a linear one"),
    ],
)
def test_what_cannot_be_sampled_is_named(arguments: tuple, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        c2d(*arguments)
    with pytest.raises(ParameterError, match="method must be 'zoh' or 'euler'"):
        c2d(PLANT, 0.1, method="tustin")


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
