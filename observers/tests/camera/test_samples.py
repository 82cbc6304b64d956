"""Simulated cameras: what the truth obeys, what the sensors add, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.errors import ParameterError
from pointpred_observers.camera import SCENARIOS, Noise, simulate
from pointpred_observers.camera.scenario import Scenario, observed, trajectory

FOCAL = 500.0


def test_the_papers_scenario_is_45() -> None:
    truth = trajectory(SCENARIOS["paper"], np.array([0.0, 2.5, 10.0]))
    assert truth.p[0].tolist() == [0.0, 0.0, 1.0]
    np.testing.assert_allclose(truth.v[0], [0.0, 0.2, -0.3], atol=1e-15)
    expected = [0.05, 1.0 / 7.5, -0.3 * np.exp(-0.05) - 0.1 * np.sin(np.pi * 2.5 / 6.0)]
    np.testing.assert_allclose(truth.v[1], expected, rtol=1e-14)
    np.testing.assert_allclose(truth.w[1], [0.05 * np.cos(np.pi * 2.5 / 4.0), 0.06 / np.sqrt(2.0), 0.0])


@pytest.mark.parametrize("name", list(SCENARIOS))
def test_the_acceleration_is_the_rate_of_the_velocity_in_a_frame_that_stands_still(name: str) -> None:
    h = 1e-4
    truth = trajectory(SCENARIOS[name], np.arange(0, 30001) * h)
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
    truth = trajectory(SCENARIOS["paper"], np.arange(4001) / 400.0)
    noise = Noise(
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
    normal = observed(truth, focal_px=FOCAL, noise=Noise(noise_px=4.0, normal=True))
    spread = (normal.table[:, 1:3] - FOCAL * truth.image).std()
    assert spread == pytest.approx(4.0 / np.sqrt(3.0), rel=0.05)


def test_the_same_seed_gives_the_same_samples() -> None:
    noise = Noise(noise_px=1.0, dropped=0.5)
    one, _ = simulate(SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0, noise=noise, seed=3)
    same, _ = simulate(SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0, noise=noise, seed=3)
    other, _ = simulate(SCENARIOS["paper"], focal_px=FOCAL, duration_s=1.0, noise=noise, seed=4)
    assert np.array_equal(one.table, same.table, equal_nan=True)
    assert not np.array_equal(one.table, other.table, equal_nan=True)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"focal_px": 0.0}, "focal_px must lie in"),
        ({"focal_px": float("nan")}, "focal_px must lie in"),
        ({"duration_s": 0.0}, "duration_s must lie in"),
        ({"image_hz": "fast"}, "image_hz must lie in"),
        ({"readings": 0}, "readings must be a whole number"),
        ({"readings": 1.5}, "readings must be a whole number"),
        ({"noise": Noise(noise_px=-1.0)}, "noise_px must lie in"),
        ({"noise": Noise(dropped=1.5)}, "dropped must lie in"),
    ],
)
def test_bad_settings_are_refused(change: dict, said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        simulate(SCENARIOS["paper"], **({"focal_px": FOCAL, "duration_s": 1.0} | change))


def test_the_focal_length_must_be_stated() -> None:
    with pytest.raises(TypeError, match="focal_px"):
        simulate(SCENARIOS["paper"])  # type: ignore[call-arg]
