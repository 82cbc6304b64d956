"""Simulated cameras: what the truth obeys, what the sensors add, and what is refused."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from evidence.observers import printed
from evidence.observers.camera_measure import consistent, cramer_rao
from pointpred.errors import EventError, EventOrderError, ParameterError
from pointpred_observers import camera
from pointpred_observers.camera.point_filter import PointTrack
from pointpred_observers.camera.scenario import Scenario, Trajectory, observed, trajectory

FOCAL, NOISE = 800.0, 2.0


def test_the_papers_scenario_is_45() -> None:
    truth = trajectory(camera.SCENARIOS["paper"], np.array([0.0, 2.5, 10.0]))
    assert truth.p[0].tolist() == [0.0, 0.0, 1.0]
    np.testing.assert_allclose(truth.v[0], [0.0, 0.2, -0.3], atol=1e-15)
    expected = [0.05, 1.0 / 7.5, -0.3 * np.exp(-0.05) - 0.1 * np.sin(np.pi * 2.5 / 6.0)]
    np.testing.assert_allclose(truth.v[1], expected, rtol=1e-14)
    np.testing.assert_allclose(truth.w[1], [0.05 * np.cos(np.pi * 2.5 / 4.0), 0.06 / np.sqrt(2.0), 0.0])


@pytest.mark.parametrize("name", list(camera.SCENARIOS))
def test_the_acceleration_is_the_rate_of_the_velocity_in_a_frame_that_stands_still(name: str) -> None:
    h = 1e-4
    truth = trajectory(camera.SCENARIOS[name], np.arange(0, 30001) * h)
    middle = np.arange(1000, 29000, 1000)
    rate = (truth.v[middle + 1] - truth.v[middle - 1]) / (2.0 * h)
    expected = rate + np.cross(truth.w[middle], truth.v[middle])
    np.testing.assert_allclose(truth.a[middle], expected, atol=1e-8)


def test_a_camera_that_reaches_the_point_is_refused() -> None:
    crash = Scenario("crash", lambda t: (0.0, 0.0, 1.0), lambda t: (0.0, 0.0, 0.0))
    with pytest.raises(ParameterError, match="crash: the camera reaches the point before 2 s"):
        trajectory(crash, np.linspace(0.0, 2.0, 21))
    with pytest.raises(ParameterError, match="times must increase from 0"):
        trajectory(crash, np.array([0.1, 0.2]))


def test_noise_bias_and_dropped_images_are_what_was_asked_for() -> None:
    truth = trajectory(camera.SCENARIOS["paper"], np.arange(4001) / 400.0)
    noise = camera.Noise(
        noise_px=4.0,
        gyro_noise=1e-3,
        accel_noise=1e-2,
        gyro_bias=(0.01, 0.0, -0.02),
        accel_bias=(0.1, 0.2, 0.3),
        dropped=0.25,
    )
    samples = observed(truth, focal_px=FOCAL, readings=4, noise=noise, seed=8)
    seen = samples.x == samples.x
    assert seen[0]
    assert not seen[np.arange(4001) % 4 != 0].any()
    assert 0.72 < seen[::4].mean() < 0.78
    pixels = samples.table[seen, 1:3] - FOCAL * truth.image[seen]
    assert np.abs(pixels).max() <= 4.0
    assert pixels.std() == pytest.approx(4.0 / np.sqrt(3.0), rel=0.05)
    gyro, accel = samples.table[:, 3:6] - truth.w, samples.table[:, 6:9] - truth.a
    np.testing.assert_allclose(gyro.mean(axis=0), noise.gyro_bias, atol=2e-3)
    np.testing.assert_allclose(accel.mean(axis=0), noise.accel_bias, atol=2e-2)
    np.testing.assert_allclose(gyro.std(axis=0), 1e-3 * 20.0, rtol=0.05)
    np.testing.assert_allclose(accel.std(axis=0), 1e-2 * 20.0, rtol=0.05)
    normal = observed(truth, focal_px=FOCAL, noise=camera.Noise(noise_px=4.0, normal=True))
    spread = (normal.table[:, 1:3] - FOCAL * truth.image).std()
    assert spread == pytest.approx(4.0 / np.sqrt(3.0), rel=0.05)


def test_the_same_seed_gives_the_same_samples() -> None:
    noise = camera.Noise(noise_px=1.0, dropped=0.5)
    one, _ = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0, noise=noise, seed=3)
    same, _ = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0, noise=noise, seed=3)
    other, _ = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0, noise=noise, seed=4)
    assert np.array_equal(one.table, same.table, equal_nan=True)
    assert not np.array_equal(one.table, other.table, equal_nan=True)


@pytest.fixture(scope="module")
def truth() -> Trajectory:
    return trajectory(camera.SCENARIOS["paper"], np.arange(100) / 33.0)


def images_from_the_end(truth: Trajectory, end: np.ndarray) -> np.ndarray:
    """All images in px that lead to a state at the end: the equations of motion backwards in time."""
    w, a = CubicSpline(truth.t, truth.w), CubicSpline(truth.t, truth.a)

    def rate(t: float, s: np.ndarray) -> np.ndarray:
        return np.concatenate([-s[3:] - np.cross(w(t), s[:3]), a(t) - np.cross(w(t), s[3:])])

    last = truth.t[-1]
    back = solve_ivp(rate, (last, 0.0), end, t_eval=truth.t[::-1], rtol=1e-11, atol=1e-12)
    p = back.y[:3, ::-1]
    return FOCAL * (p[:2] / p[2]).ravel()


def test_the_bound_is_the_inverse_of_fishers_information(truth: Trajectory) -> None:
    end, h = np.concatenate([truth.p[-1], truth.v[-1]]), 1e-5
    slopes = [
        (images_from_the_end(truth, end + h * unit) - images_from_the_end(truth, end - h * unit)) / (2 * h)
        for unit in np.eye(6)
    ]
    expected = np.linalg.inv(np.array(slopes) @ np.array(slopes).T / NOISE**2)
    found = cramer_rao(truth, focal_px=FOCAL, noise_px=NOISE)[-1]
    scale = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    assert np.abs((found - expected) / scale).max() < 2e-3


def test_the_interval_of_consistency_is_that_of_chi_squared() -> None:
    random = np.random.default_rng(0)
    inside = 0
    for _ in range(400):
        mean, (low, high) = consistent((random.normal(size=(20, 6)) ** 2).sum(axis=1))
        inside += low < mean < high
    assert 0.92 < inside / 400 < 0.98


def test_the_chain_rule_agrees_with_differences_of_the_trajectory() -> None:
    """What everything else is held against: fourth-order differences of the integrated path."""
    fine = trajectory(camera.SCENARIOS["paper"], np.arange(1001) / 1000.0)
    states = np.column_stack([fine.image, fine.chi, fine.eta])
    slope = (-states[4:] + 8 * states[3:-1] - 8 * states[1:-3] + states[:-4]) / (12 * 0.001)
    assert np.abs(slope - printed.derivatives(fine)[2:-2]).max() < 1e-8


def observer(chi: float = 4.0, eta: float = -1.6) -> camera.DepthObserver:
    return camera.DepthObserver(focal_px=FOCAL, start_chi=chi, start_eta=eta)


GOOD = camera.CameraSample(0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("change", "kind", "said"),
    [
        ({"t": -1.0}, EventOrderError, r"t must increase: received -1.0 s after 0.0 s"),
        ({"t": 5.0}, EventError, "the inertial sensor was silent from 0.0 s to 5.0 s, at most 1 s"),
        ({"t": 0.1, "y": float("nan")}, EventError, "x and y come together or not at all"),
        ({"t": 0.1, "wx": float("inf")}, EventError, r"wx must lie in \[-1000, 1000\], received inf"),
        ({"t": 0.1, "x": 1e9}, EventError, "x must lie in"),
        ({"t": 0.1, "ay": "0"}, EventError, "ay must be a number"),
    ],
)
def test_bad_samples_are_refused_and_change_nothing(change: dict, kind: type[Exception], said: str) -> None:
    stage = observer()
    stage.update(GOOD)
    kept = stage.remembered()
    values = {name: getattr(GOOD, name) for name in camera.CameraColumns.names} | change
    with pytest.raises(kind, match=said):
        stage.update(camera.CameraSample(**values))
    assert stage.remembered() == kept


def test_a_bad_row_is_named_and_nothing_is_consumed() -> None:
    samples, _ = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0)
    table = samples.table.copy()
    table[7, 4] = np.nan
    stage = observer()
    kept = stage.remembered()
    with pytest.raises(EventError, match="row 7: wy must lie in"):
        stage.run(camera.CameraColumns(table))
    assert stage.remembered() == kept
    with pytest.raises(EventError, match="must be a CameraSample"):
        stage.update(3.0)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "made",
    [
        observer,
        lambda: camera.PointFilter(focal_px=FOCAL, noise_px=1.7),
        lambda: camera.Gravity(up=(0.0, -1.0, 0.1)),
    ],
    ids=["observer", "filter", "gravity"],
)
def test_rows_chunks_pickles_and_fresh_agree(made: Any) -> None:
    noise = camera.Noise(noise_px=3.0, dropped=0.2)
    samples, _ = camera.simulate(camera.SCENARIOS["paper"], focal_px=FOCAL, readings=2, noise=noise)
    whole = made().run(samples)
    stage = made()
    parts = [stage.run(camera.CameraColumns(samples.table[:200]))]
    stage = pickle.loads(pickle.dumps(stage))
    parts.append(stage.run(camera.CameraColumns(samples.table[200:])))
    assert np.array_equal(np.vstack([numbers(one) for one in parts]), numbers(whole), equal_nan=True)
    stage.reset()
    assert stage.remembered() == stage.fresh().remembered() == made().remembered()
    for row, sample in zip(numbers(whole), samples, strict=True):
        one = stage.update(sample)
        if isinstance(one, camera.PointEstimate):
            one = (*one.state, *one.covariance.ravel())
        assert np.array_equal(np.full(len(row), np.nan) if one is None else one, row, equal_nan=True)


def numbers(found: Any) -> Any:
    if isinstance(found, PointTrack):
        return np.hstack([found.state, found.covariance.reshape(-1, 36)])
    return found.table


@pytest.mark.parametrize("seed", range(4))
def test_wild_samples_within_the_bounds_leave_a_memory_of_finite_numbers(seed: int) -> None:
    random = np.random.default_rng(seed)
    rows = 3000
    table = np.zeros((rows, 9))
    table[:, 0] = np.cumsum(random.choice([1e-6, 0.01, 0.9], rows))
    table[:, 1:3] = random.choice([0.0, 1.0, -300.0, 1e6], (rows, 2)) * random.normal(size=(rows, 2)).clip(
        -1, 1
    )
    table[random.uniform(size=rows) < 0.2, 1:3] = np.nan
    table[:, 3:6] = random.choice([0.0, 0.1, 1e3], (rows, 3)) * random.uniform(-1.0, 1.0, (rows, 3))
    table[:, 6:9] = random.choice([0.0, 0.1, 1e4], (rows, 3)) * random.uniform(-1.0, 1.0, (rows, 3))
    for stage in (observer(), camera.PointFilter(focal_px=FOCAL, gyro_noise=1.0, accel_noise=10.0)):
        out = stage.run(camera.CameraColumns(table))
        memory = np.frombuffer(stage.remembered())
        assert np.isfinite(memory).all()
        answers = out.table if hasattr(out, "table") else out.state
        assert not np.isinf(answers).any()
