"""The Cramer-Rao bound against the information computed by differences of whole trajectories."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from evidence.observers.camera_measure import consistent, cramer_rao
from pointpred.errors import ParameterError
from pointpred_observers.camera import SCENARIOS
from pointpred_observers.camera.scenario import Trajectory, trajectory

FOCAL, NOISE = 800.0, 2.0


@pytest.fixture(scope="module")
def truth() -> Trajectory:
    return trajectory(SCENARIOS["paper"], np.arange(100) / 33.0)


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


def test_nothing_is_bounded_before_it_is_determined(truth: Trajectory) -> None:
    bound = cramer_rao(truth, focal_px=FOCAL, noise_px=NOISE)
    assert np.isnan(bound[:2]).all()
    assert np.isfinite(bound[10:]).all()
    still = trajectory(SCENARIOS["axial"], truth.t)
    assert np.isnan(cramer_rao(still, focal_px=FOCAL, noise_px=NOISE)).all()


def test_less_noise_and_more_images_tell_more(truth: Trajectory) -> None:
    def depth(**more: object) -> float:
        options = {"focal_px": FOCAL, "noise_px": NOISE} | more
        return float(np.sqrt(cramer_rao(truth, **options)[-1, 2, 2]))  # type: ignore[arg-type]

    usual = depth()
    assert depth(noise_px=2.0 * NOISE) == pytest.approx(2.0 * usual, rel=1e-6)
    assert depth(focal_px=2.0 * FOCAL) == pytest.approx(0.5 * usual, rel=1e-6)
    assert depth(images=np.arange(100) % 2 == 0) > usual
    assert depth(accel_noise=1e-9) == pytest.approx(usual, rel=1e-6)
    assert depth(accel_noise=1e-2) > 2.0 * usual
    assert depth(gyro_noise=1e-3, accel_noise=1e-3) > depth(accel_noise=1e-3)


def test_noise_must_be_positive(truth: Trajectory) -> None:
    with pytest.raises(ParameterError, match="noise_px and focal_px must be positive"):
        cramer_rao(truth, focal_px=FOCAL, noise_px=0.0)


def test_the_interval_of_consistency_is_that_of_chi_squared() -> None:
    random = np.random.default_rng(0)
    inside = 0
    for _ in range(400):
        mean, (low, high) = consistent((random.normal(size=(20, 6)) ** 2).sum(axis=1))
        inside += low < mean < high
    assert 0.92 < inside / 400 < 0.98
