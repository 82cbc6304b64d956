"""Velocities by every way of having (x, y)', and what stands where nothing is known."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from evidence.observers.camera_measure import unknown_inputs
from pointpred.errors import EventError, EventOrderError
from pointpred_observers import camera
from pointpred_observers.camera.depth import DepthColumns
from pointpred_observers.camera.scenario import Trajectory, observed, trajectory
from pointpred_observers.camera.velocity import UnknownInputFilter, flow, velocities
from pointpred_observers.unknown_input.observer import UnknownInputObserver

FOCAL = 800.0


@pytest.fixture(scope="module")
def truth() -> Trajectory:
    return trajectory(camera.SCENARIOS["paper"], np.arange(331) / 33.0)


def errors(truth: Trajectory, way: str, noise_px: float) -> float:
    """RMSE of v_x and v_y after 2 s, m/s, with depth and eta nearly right."""
    samples = observed(truth, focal_px=FOCAL, noise=camera.Noise(noise_px=noise_px), seed=1)
    depth = camera.DepthObserver(focal_px=FOCAL, start_chi=1.0, start_eta=-0.3).run(samples)
    told = max(noise_px, 0.1) / np.sqrt(3.0)
    v = velocities(unknown_inputs(way, samples, depth.eta, FOCAL, told), depth)
    return float(np.sqrt(np.mean((v - truth.v)[66:, :2] ** 2)))


@pytest.mark.parametrize(
    ("way", "most"), [("difference", 0.004), ("kalman, calm", 0.02), ("kalman-two-state", 0.015)]
)
def test_a_way_finds_the_velocity_without_noise(truth: Trajectory, way: str, most: float) -> None:
    assert errors(truth, way, 0.0) < most


def test_the_two_state_filter_is_ten_times_better_than_differences(truth: Trajectory) -> None:
    for noise_px in (2.0, 4.0, 8.0):
        raw = errors(truth, "difference", noise_px)
        assert raw > 10.0 * errors(truth, "kalman-two-state", noise_px)
        assert raw > 3.0 * errors(truth, "kalman, calm", noise_px)


def test_raw_differences_are_as_bad_as_theory_says(truth: Trajectory) -> None:
    """Noise of n px uniform: sqrt(2) n / sqrt(3) px between two images, over their interval and chi."""
    depth = np.sqrt(np.mean(truth.p[66:, 2] ** 2))
    expected = np.sqrt(2.0 / 3.0) * 4.0 / FOCAL * 33.0 * depth
    assert errors(truth, "difference", 4.0) == pytest.approx(expected, rel=0.15)


def test_the_known_flow_and_d_make_the_motion_of_the_image(truth: Trajectory) -> None:
    from evidence.observers import printed

    expected = printed.derivatives(truth)
    for k in range(0, 331, 30):
        known = np.array(flow(*truth.image[k], truth.eta[k], *truth.w[k]))
        rate = known - truth.chi[k] * truth.v[k, :2]
        np.testing.assert_allclose(rate, expected[k, :2], atol=1e-15)


def test_the_two_state_filter_settles_at_the_riccati_solution() -> None:
    from scipy.linalg import solve_discrete_are

    h, q, r = 0.02, 1e-3, 1e-6
    stage = UnknownInputFilter(focal_px=1e3, noise_px=1e3 * np.sqrt(r), density=q)
    for i in range(3000):
        spread = stage.update(camera.CameraSample(i * h, *[0.0] * 8), 0.0)[2]
    f = np.array([[1.0, -h], [0.0, 1.0]])
    noise = q * np.array([[h**3 / 3.0, -(h**2) / 2.0], [-(h**2) / 2.0, h]])
    c = np.array([[1.0, 0.0]])
    before = solve_discrete_are(f.T, c.T, noise, np.array([[r]]))
    after = before - before @ c.T @ c @ before / (before[0, 0] + r)
    assert spread == pytest.approx(np.sqrt(after[1, 1]), rel=1e-6)
    with pytest.raises(EventError, match="t must increase"):
        stage.update(camera.CameraSample(*[0.0] * 9), 0.0)


def test_depth_at_its_floor_makes_the_velocity_unknown() -> None:
    row = [0.0, 1e-4, -0.1, -0.1, 1.0, 1.0, 1.0]
    assert np.isnan(velocities(np.zeros((1, 2)), DepthColumns([row]))).all()
    row[1] = 1.01e-4
    assert np.isfinite(velocities(np.zeros((1, 2)), DepthColumns([row]))).all()


def test_without_images_a_derivative_is_held_and_the_filter_predicts(truth: Trajectory) -> None:
    table = observed(truth, focal_px=FOCAL).table.copy()
    table[200:210, 1:3] = np.nan
    samples = camera.CameraColumns(table)
    raw = unknown_inputs("difference", samples, truth.eta, FOCAL)
    assert (raw[200:210] == raw[199]).all()
    filtered = UnknownInputFilter(focal_px=FOCAL, noise_px=0.1).run(samples, truth.eta)
    v = filtered[200:215] / truth.chi[200:215, None]
    assert np.abs(v - truth.v[200:215, :2]).max() < 0.05


@cache
def design() -> UnknownInputObserver:
    bounds = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (-0.07, 0.07), "dw": (0.0, 0.0)}
    return UnknownInputObserver.design(
        camera.camera_system(), camera.camera_box((-2.0, -0.03), **bounds), 0.005
    )


def pipeline(eta: float) -> camera.CameraPipeline:
    observer = camera.DepthObserver(focal_px=FOCAL, start_chi=0.3, start_eta=eta, observer=design())
    return camera.CameraPipeline(observer, camera.PointFilter(focal_px=FOCAL, noise_px=1.0), noise_px=1.0)


def test_a_wrong_start_on_an_approaching_camera_is_not_silently_wrong() -> None:
    """The observer believes that the camera recedes, until the images have told otherwise."""
    truth = trajectory(camera.SCENARIOS["approaching"], np.arange(331) / 33.0)
    samples = observed(truth, focal_px=FOCAL, noise=camera.Noise(noise_px=np.sqrt(3.0)), seed=4)
    stage = pipeline(-0.3)
    alone = stage.observer.fresh().run(samples)
    assert alone.detectable.mean() > 0.9  # by itself it does not notice
    found = stage.run(samples)
    told = ~np.isnan(found.peer_eta)
    assert told[66:].all()
    assert not found.detectable[99:].any()
    assert abs(found.peer_chi[-1] - truth.chi[-1]) < 0.01 * truth.chi[-1]


def test_the_images_do_not_speak_against_a_camera_that_recedes(truth: Trajectory) -> None:
    samples = observed(truth, focal_px=FOCAL, noise=camera.Noise(noise_px=np.sqrt(3.0)), seed=4)
    found = pipeline(-0.3).run(samples)
    assert found.detectable.mean() > 0.95


def test_the_pipeline_refuses_as_a_whole(truth: Trajectory) -> None:
    samples = observed(truth, focal_px=FOCAL)
    stage = pipeline(-0.3)
    table = samples.table[:50].copy()
    table[20, 0] = 0.0
    with pytest.raises(EventOrderError, match="row 20: t must increase"):
        stage.run(camera.CameraColumns(table))
    whole = stage.run(samples).table
    assert np.array_equal(stage.fresh().run(samples).table, whole, equal_nan=True)
    stage.reset()
    assert np.array_equal(stage.run(samples).table, whole, equal_nan=True)
    kept = stage.observer.remembered(), stage.peer.remembered()
    with pytest.raises(EventOrderError):
        stage.update(camera.CameraSample(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert (stage.observer.remembered(), stage.peer.remembered()) == kept


def test_a_sample_that_the_filter_refuses_leaves_the_observer_unchanged(truth: Trajectory) -> None:
    samples = list(observed(truth, focal_px=FOCAL))
    stage = pipeline(-0.3)
    stage.update(samples[0])
    stage.peer.update(samples[2])
    kept = stage.observer.remembered(), stage.peer.remembered()
    with pytest.raises(EventOrderError):
        stage.update(samples[1])
    assert (stage.observer.remembered(), stage.peer.remembered()) == kept
