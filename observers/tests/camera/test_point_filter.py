"""The peer: its prediction, its start, its consistency, and its silence where the images tell nothing."""

from __future__ import annotations

import numpy as np
import pytest

from evidence.observers.camera_measure import consistent, cramer_rao, normalised_errors
from pointpred_observers import camera
from pointpred_observers.camera.scenario import Scenario, observed, trajectory

FOCAL = 800.0


def peer(noise_px: float, **more: float) -> camera.PointFilter:
    return camera.PointFilter(focal_px=FOCAL, noise_px=max(noise_px, 0.1) / np.sqrt(3.0), **more)


def test_prediction_is_exact_to_the_line_between_two_samples() -> None:
    truth = trajectory(camera.SCENARIOS["paper"], np.arange(331) / 33.0)
    state = np.concatenate([truth.p[0], truth.v[0]])
    for k in range(330):
        h = truth.t[k + 1] - truth.t[k]
        turn = 0.5 * h * (truth.w[k] + truth.w[k + 1])
        camera.kinematics.carry(state, h, tuple(turn))
        camera.kinematics.push(state, h, tuple(turn), tuple(truth.a[k]), tuple(truth.a[k + 1]))
    np.testing.assert_allclose(state, np.concatenate([truth.p[-1], truth.v[-1]]), atol=2e-5)


@pytest.mark.parametrize("size", [0.0, 1e-6, 1e-4, 0.9e-4, 0.3, 3.0])
def test_turns_are_those_of_a_library(size: float) -> None:
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    turn = size * np.array([0.48, -0.6, 0.64])
    expected = rotation.from_rotvec(turn).inv().apply([1.0, 2.0, 3.0])
    np.testing.assert_allclose(camera.kinematics.back(tuple(turn), (1.0, 2.0, 3.0)), expected, atol=1e-14)


def test_a_covariance_is_carried_and_shaken_as_its_samples_are() -> None:
    random = np.random.default_rng(1)
    root = random.normal(size=(6, 6))
    state = np.array([0.3, -0.2, 2.0, 0.1, 0.2, -0.4])
    covariance, phi = (root @ root.T).ravel(), np.eye(6).ravel()
    turn, h = np.array([0.1, -0.2, 0.05]), 0.3
    for i in range(6):
        camera.kinematics.carry_column(phi, i, h, tuple(turn))
    phi = phi.reshape(6, 6)
    camera.kinematics.turn_covariance(covariance, h, tuple(turn))
    np.testing.assert_allclose(covariance.reshape(6, 6), phi @ root @ root.T @ phi.T, atol=1e-12)
    before = covariance.copy()
    camera.kinematics.add_noise(covariance, state, 0.01, 0.2)
    moved = np.vstack([-np.cross(np.eye(3), state[:3]).T, -np.cross(np.eye(3), state[3:]).T])
    expected = 0.01 * moved @ moved.T + np.diag([0.0] * 3 + [0.2] * 3)
    np.testing.assert_allclose((covariance - before).reshape(6, 6), expected, atol=1e-14)


def test_clean_images_find_the_depth_within_a_second() -> None:
    samples, truth = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL)
    track = peer(0.0).run(samples)
    assert track.t[track.running][0] < 1.0
    assert abs(track.state[-1, 2] - truth.p[-1, 2]) < 0.002
    assert track.restarts == 0


@pytest.fixture(scope="module", params=[2.0, 4.0, 8.0])
def runs(request: pytest.FixtureRequest) -> tuple[np.ndarray, np.ndarray, float]:
    """Depth errors and NEES of 40 runs with normal noise after 10 s, and the bound on the depth."""
    errors, squares, truth = [], [], trajectory(camera.SCENARIOS["paper"], np.arange(331) / 33.0)
    for seed in range(40):
        noise = camera.Noise(noise_px=request.param, normal=True)
        samples = observed(truth, focal_px=FOCAL, noise=noise, seed=seed)
        track = peer(request.param).run(samples)
        errors.append(track.state[-1, 2] - truth.p[-1, 2])
        squares.append(normalised_errors(track, truth)[-1])
    bound = cramer_rao(truth, focal_px=FOCAL, noise_px=request.param / np.sqrt(3.0))
    return np.array(errors), np.array(squares), float(np.sqrt(bound[-1, 2, 2]))


def test_depth_is_within_one_and_a_half_of_the_bound(runs: tuple[np.ndarray, np.ndarray, float]) -> None:
    errors, _, bound = runs
    assert 0.7 * bound < np.sqrt(np.mean(errors**2)) < 1.5 * bound


def test_the_filter_believes_the_right_thing(runs: tuple[np.ndarray, np.ndarray, float]) -> None:
    _, squares, _ = runs
    mean, (low, high) = consistent(squares, 0.9999)
    assert low < mean < high


def test_a_filter_told_too_little_noise_fails_the_same_check() -> None:
    squares, truth = [], trajectory(camera.SCENARIOS["paper"], np.arange(331) / 33.0)
    for seed in range(10):
        noise = camera.Noise(noise_px=4.0, normal=True)
        samples = observed(truth, focal_px=FOCAL, noise=noise, seed=seed)
        squares.append(normalised_errors(peer(1.5).run(samples), truth)[-1])
    mean, (_, high) = consistent(np.array(squares), 0.9999)
    assert mean > high


def test_sensor_noise_is_believed_too() -> None:
    squares, truth = [], trajectory(camera.SCENARIOS["paper"], np.arange(991) / 99.0)
    told = {"gyro_noise": 2e-4, "accel_noise": 2e-3}
    for seed in range(30):
        noise = camera.Noise(noise_px=2.0, normal=True, dropped=0.2, **told)
        samples = observed(truth, focal_px=FOCAL, readings=3, noise=noise, seed=seed)
        squares.append(normalised_errors(peer(2.0, **told).run(samples), truth)[-1])
    mean, (low, high) = consistent(np.array(squares), 0.9999)
    assert low < mean < high


@pytest.mark.parametrize("noise_px", [0.0, 2.0, 8.0])
@pytest.mark.parametrize("name", ["stationary", "rotating", "axial"])
def test_nothing_is_claimed_where_no_image_tells_the_depth(name: str, noise_px: float) -> None:
    truth = trajectory(camera.SCENARIOS[name], np.arange(331) / 33.0)
    for seed in range(3):
        samples = observed(truth, focal_px=FOCAL, noise=camera.Noise(noise_px=noise_px), seed=seed)
        assert not peer(noise_px).run(samples).running.any()


def test_a_point_that_passes_the_camera_makes_it_begin_anew() -> None:
    def velocity(t: object) -> tuple[object, object, object]:
        return 0.3 * np.sin(2.0 * t), 0.3 * np.cos(3.0 * t), 0.4  # type: ignore[call-overload, operator]

    scenario = Scenario("meets", velocity, lambda t: (0.0, 0.0, 0.0), (0.0, 0.0, 4.0))
    samples, _ = camera.simulate(scenario, focal_px=FOCAL, duration_s=9.9)
    stage = peer(0.0)
    assert stage.run(samples).restarts == 0
    table = samples.table[-1:].repeat(40, axis=0)
    table[:, 0] += np.arange(1, 41) / 33.0
    table[:, 1:3] = np.nan  # past the point nothing is seen
    track = stage.run(camera.CameraColumns(table))
    assert track.restarts == 1
    assert not track.running[-1]


@pytest.mark.parametrize("seed", range(5))
def test_an_image_is_the_matrix_update_of_both_coordinates_at_once(seed: int) -> None:
    random = np.random.default_rng(seed)
    root = 0.3 * random.normal(size=(6, 6))
    state = np.array([0.3, -0.2, 2.0, 0.1, 0.2, -0.4]) + 0.1 * random.normal(size=6)
    seen, noise = np.array([0.1, -0.3]), 1e-2
    memory = camera.point_filter.Memory(np.zeros(camera.point_filter.Memory.length))
    memory.settings.noise, memory.state.mode = noise, camera.point_filter.RUNNING
    memory.state.state[:] = state
    memory.state.spread.m[:] = root @ root.T
    camera.point_filter.look(memory.memory, *seen)

    x, y, z = state[:3]
    h = np.array([[1.0, 0.0, -x / z, 0.0, 0.0, 0.0], [0.0, 1.0, -y / z, 0.0, 0.0, 0.0]]) / z
    p = root @ root.T
    gain = p @ h.T @ np.linalg.inv(h @ p @ h.T + noise * np.eye(2))
    expected = state + gain @ (seen - state[:2] / z)
    np.testing.assert_allclose(memory.state.state, expected, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(memory.state.spread.m, (np.eye(6) - gain @ h) @ p, rtol=1e-8, atol=1e-12)
