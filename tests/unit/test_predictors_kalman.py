"""The constant-acceleration Kalman filter against the textbook in matrices and against parabolas."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

from pointpred import Motion, build
from pointpred.predictors import KalmanPredictor, kalman
from pointpred.records import FloatArray


def at(t: float, x: float, y: float = 0.0, *, start: bool = False) -> Motion:
    """A motion of which only time and place matter."""
    return Motion(t, x, y, 0.1, 0.0, 0.0, 0.0, True, start=start)


def transition(dt: float, density: float) -> tuple[FloatArray, FloatArray]:
    """Transition and noise of x''' = white noise over dt, by Van Loan's matrix exponential."""
    drift = np.diag([1.0, 1.0], 1)
    block = np.zeros((6, 6))
    block[:3, :3], block[:3, 3:], block[3:, 3:] = -drift, np.diag([0.0, 0.0, density]), drift.T
    whole = expm(block * dt)
    moves = whole[3:, 3:].T
    return moves, moves @ whole[:3, 3:]


def textbook(t: FloatArray, x: FloatArray, horizon: float, density: float, noise: float) -> FloatArray:
    """Predict and correct with matrices, Joseph's form."""
    mean = np.array([x[0], 0.0, 0.0])
    spread = np.diag([noise**2, kalman.PRIOR_SPEED**2, kalman.PRIOR_ACCELERATION**2])
    seen = np.array([[1.0, 0.0, 0.0]])
    ends = []
    for i in range(len(t)):
        if i > 0:
            moves, jerk = transition(t[i] - t[i - 1], density)
            mean, spread = moves @ mean, moves @ spread @ moves.T + jerk
        gain = spread @ seen.T / (seen @ spread @ seen.T + noise**2)
        mean = mean + gain[:, 0] * (x[i] - mean[0])
        left = np.eye(3) - gain @ seen
        spread = left @ spread @ left.T + gain @ gain.T * noise**2
        ends.append(mean[0] + horizon * mean[1] + 0.5 * horizon**2 * mean[2])
    return np.array(ends)


@pytest.mark.parametrize("rate_hz", [60.0, 1000.0])
@pytest.mark.parametrize(("density", "noise"), [(1e10, 1.0), (1e6, 0.3)])
def test_it_is_the_textbook_filter(rate_hz: float, density: float, noise: float) -> None:
    random = np.random.default_rng(3)
    t = np.cumsum(random.uniform(0.5, 1.5, 120) / rate_hz)
    x, y = np.cumsum(random.integers(-5, 9, (2, 120)), axis=1).astype(float)
    predictor = KalmanPredictor(horizon_s=0.04, cursor_jerk_density=density, cursor_noise_px=noise)
    ends = [predictor.update(at(*row)) for row in zip(t, x, y, strict=True)]
    found = np.array([(end.x, end.y) for end in ends if end is not None])
    for column, place in enumerate((x, y)):
        expected = textbook(t, place, 0.04, density, noise)
        np.testing.assert_allclose(found[:, column], expected, rtol=1e-6, atol=1e-6)


def test_a_parabola_is_continued_exactly_once_the_prior_is_forgotten() -> None:
    predictor = KalmanPredictor(horizon_s=0.1, cursor_jerk_density=1e4, cursor_noise_px=0.01)
    prediction = None
    for i in range(400):
        t = i / 500.0
        prediction = predictor.update(at(t, 400.0 * t - 900.0 * t**2, 50.0 + 100.0 * t**2))
    assert prediction is not None
    t = 399 / 500.0 + 0.1
    assert prediction.x == pytest.approx(400.0 * t - 900.0 * t**2, abs=1e-2)
    assert prediction.y == pytest.approx(50.0 + 100.0 * t**2, abs=1e-2)


def test_a_horizon_of_zero_is_the_filtered_position() -> None:
    random = np.random.default_rng(4)
    predictor = KalmanPredictor(horizon_s=0.0, cursor_jerk_density=1e7, cursor_noise_px=3.0)
    raw, filtered = [], []
    for i in range(500):
        x = 200.0 * np.sin(i / 50.0)
        noisy = x + 3.0 * random.standard_normal()
        prediction = predictor.update(at(i / 125.0, noisy))
        assert prediction is not None
        raw.append(noisy - x)
        filtered.append(prediction.x - x)
    assert np.std(filtered[50:]) < 0.7 * np.std(raw[50:])


def test_the_later_of_two_motions_of_one_time_replaces_the_earlier() -> None:
    one, other = KalmanPredictor(), KalmanPredictor()
    one.update(at(0.0, -3.0, start=True))
    assert one.update(at(0.0, -3.0)) == other.update(at(0.0, -3.0, start=True))
    for i in range(1, 30):
        one.update(at(i / 50.0, 999.0 - i, 5.0))
        assert one.update(at(i / 50.0, 4.0 * i)) == other.update(at(i / 50.0, 4.0 * i))


@pytest.mark.parametrize("why", ["gap", "start"])
def test_it_begins_at_rest(why: str) -> None:
    predictor = KalmanPredictor(horizon_s=0.1)
    prediction = None
    for i in range(50):
        prediction = predictor.update(at(i / 100.0, 8.0 * i))
    assert prediction is not None
    assert prediction.x > 8.0 * 49 + 60.0
    later = predictor.update(at(0.49 + 0.15, 420.0) if why == "gap" else at(0.5, 420.0, start=True))
    assert later is not None
    assert later.x == 420.0


def test_neither_region_nor_arrival_is_claimed() -> None:
    predictor = KalmanPredictor()
    for i in range(20):
        prediction = predictor.update(at(i / 100.0, 3.0 * i))
        assert prediction is not None
        assert prediction.scale is None
        assert prediction.remaining_s is None


def test_the_gap_is_one_parameter_of_the_whole_pipeline() -> None:
    pipeline = build("kalman", gap_s=0.02)
    predictor = pipeline.predictor
    assert isinstance(predictor, KalmanPredictor)
    assert kalman.Memory(predictor._memory).settings.gap_s == 0.02
    assert pipeline.differentiator._memory[2] == 0.02
