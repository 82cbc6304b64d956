"""Gravity removed by the attitude: closed forms, an integrated attitude, and what cannot be known."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred_observers.camera import SCENARIOS, CameraColumns, CameraSample, DepthObserver, Gravity
from pointpred_observers.camera.scenario import Trajectory, observed, trajectory

G, FOCAL = 9.80665, 800.0


def felt(truth: Trajectory, up: np.ndarray) -> CameraColumns:
    """Samples of a trajectory whose accelerometer measures (9)."""
    table = observed(truth, focal_px=FOCAL).table.copy()
    table[:, 6:] += G * up
    return CameraColumns(table)


def attitude(truth: Trajectory, first: tuple[float, float, float]) -> np.ndarray:
    """up' = -w x up, integrated by scipy along the scenario's own angular velocity."""
    angular = SCENARIOS["paper"].angular

    def rate(t: float, up: np.ndarray) -> np.ndarray:
        return -np.cross(np.array([value + 0.0 * t for value in angular(t)]), up)

    span = truth.t[0], truth.t[-1]
    return solve_ivp(rate, span, first, t_eval=truth.t, rtol=1e-11, atol=1e-12, max_step=0.05).y.T


@pytest.fixture(scope="module")
def truth() -> Trajectory:
    return trajectory(SCENARIOS["paper"], np.arange(1001) / 100.0)


def nodding(t: np.ndarray) -> np.ndarray:
    """Samples of a camera that nods in one place: turned by 0.4 sin 0.7 t about x from a level start."""
    angle = 0.4 * np.sin(0.7 * t)
    table = np.zeros((len(t), 9))
    table[:, 0], table[:, 3] = t, 0.28 * np.cos(0.7 * t)
    # x right, y down, z forward: R'(0, -1, 0), R a turn by the angle about x.
    table[:, 7], table[:, 8] = -G * np.cos(angle), G * np.sin(angle)
    return table


@pytest.mark.parametrize("up", [(0.0, -1.0, 0.0), (0, -30, 0), None])
def test_a_camera_that_nods_in_one_place_does_not_accelerate(up: object) -> None:
    found = Gravity(up=up).run(CameraColumns(nodding(np.arange(901) / 100.0)))
    assert np.abs(found.table[:, 6:]).max() < 1e-4
    wrong = Gravity(up=(0.0, 1.0, 0.0)).run(CameraColumns(nodding(np.arange(9) / 100.0)))
    assert np.abs(wrong.table[:, 6:]).max() > 1.9 * G  # upwards is against gravity


def test_the_gyroscope_carries_the_attitude_and_the_depth_follows(truth: Trajectory) -> None:
    first = (0.1, -0.9, 0.2)
    up = attitude(truth, first)
    size = float(np.linalg.norm(first))
    motion = Gravity(up=first).run(felt(truth, up / size))
    np.testing.assert_allclose(motion.table[:, 6:], truth.a, atol=2e-4)
    depth = DepthObserver(focal_px=FOCAL, start_chi=1.0, start_eta=-0.3)
    assert np.abs(depth.run(motion).chi - truth.chi).max() < 1e-3
    raw = depth.fresh().run(felt(truth, up / size))
    assert not np.abs(raw.chi - truth.chi).max() < 0.5  # g in a_z


def test_a_given_attitude_is_taken_and_carried_on_from(truth: Trajectory) -> None:
    up = attitude(truth, (0.0, -1.0, 0.0))
    samples, known = felt(truth, up), up.copy()
    np.testing.assert_allclose(Gravity().run(samples, known).table[:, 6:], truth.a, atol=1e-9)
    known[1:] = np.nan  # only the first
    with pytest.raises(ParameterError, match="up must be finite"):
        Gravity().run(samples, known)
    one, other = Gravity(up=(1.0, 0.0, 0.0)), Gravity(up=up[0])
    rows = [one.update(sample, up=up[i] if i % 50 == 0 else None) for i, sample in enumerate(samples)]
    np.testing.assert_allclose(np.array(rows)[:, 6:], truth.a, atol=2e-4)
    assert np.array_equal([other.update(sample) for sample in samples], other.fresh().run(samples).table)


def test_what_cannot_be_known_is_refused_and_changes_nothing() -> None:
    table = nodding(np.arange(10) / 100.0)
    stage, kept = Gravity(), Gravity().remembered()
    with pytest.raises(EventError, match="must rest at the first sample, where 3 m/s"):
        stage.update(CameraSample(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -3.0, 0.0))
    table[4, 0] = table[3, 0]
    with pytest.raises(EventOrderError, match="row 4: t must increase"):
        stage.run(CameraColumns(table))
    table[0, 4] = np.nan
    with pytest.raises(EventError, match="row 0: wy must lie in"):
        stage.run(CameraColumns(table))
    assert stage.remembered() == kept
    for up in ((0.0, 0.0, 0.0), (1.0, 0.0), (np.inf, 0.0, 0.0), "down"):
        with pytest.raises(ParameterError, match="up "):
            Gravity(up=up)
