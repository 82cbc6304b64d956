"""The Kalman filter against textbook matrices, scipy's Riccati solution and its promised poles."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import linalg

from pointpred import EventColumns
from pointpred.differentiators import KalmanDifferentiator
from pointpred.differentiators import kalman as law
from pointpred.differentiators.kalman import START_ACCELERATION_M_S2, START_SPEED_M_S
from tests.signals import exact, parabola

PX_PER_M = 96.0 / 0.0254


def transition(dt: float, density: float) -> tuple[np.ndarray, np.ndarray]:
    """F and Q by Van Loan's matrix exponential."""
    a = np.diag([1.0, 1.0], 1)
    noise = np.zeros((3, 3))
    noise[2, 2] = density
    block = linalg.expm(np.block([[-a, noise], [np.zeros((3, 3)), a.T]]) * dt)
    f = block[3:, 3:].T
    return f, f @ block[:3, 3:]


def textbook(t: np.ndarray, u: np.ndarray, density: float, noise_m: float) -> tuple[np.ndarray, np.ndarray]:
    """States and last covariance; Joseph's form, full matrices."""
    h = np.array([[1.0, 0.0, 0.0]])
    state = np.array([u[0], 0.0, 0.0])
    p = np.diag([noise_m**2, START_SPEED_M_S**2, START_ACCELERATION_M_S2**2])
    states = [state]
    for before, now, measured in zip(t[:-1], t[1:], u[1:], strict=True):
        f, q = transition(now - before, density)
        state, p = f @ state, f @ p @ f.T + q
        gain = p @ h.T / (h @ p @ h.T + noise_m**2)
        state = state + gain[:, 0] * (measured - state[0])
        keep = np.eye(3) - gain @ h
        p = keep @ p @ keep.T + gain @ gain.T * noise_m**2
        states.append(state)
    return np.array(states), p


@pytest.mark.parametrize(("density", "noise_m"), [(30.0, 1e-4), (1e4, 1e-5), (1.0, 1e-3)])
def test_agrees_with_full_matrices_under_irregular_sampling(density: float, noise_m: float) -> None:
    random = np.random.default_rng(3)
    t = np.cumsum(random.choice([0.0005, 0.001, 0.008, 0.017, 0.09], 400))
    u = 0.1 * np.sin(4.0 * t) + noise_m * random.standard_normal(400)
    v = 0.03 * np.cos(7.0 * t)
    differentiator = KalmanDifferentiator(jerk_density=density, noise_m=noise_m)
    motions = differentiator.run(EventColumns.of(t, u * PX_PER_M, v * PX_PER_M))
    states, p = textbook(t, u - u[0], density, noise_m)
    np.testing.assert_allclose(motions.vx, states[:, 1], rtol=1e-8, atol=1e-10)
    np.testing.assert_allclose(motions.ax, states[:, 2], rtol=1e-7, atol=1e-8)
    across, _ = textbook(t, v - v[0], density, noise_m)
    np.testing.assert_allclose(motions.vy, across[:, 1], rtol=1e-8, atol=1e-10)
    np.testing.assert_allclose(motions.ay, across[:, 2], rtol=1e-7, atol=1e-8)
    kept = law.Memory(differentiator._memory).state.plane.covariance.memory
    np.testing.assert_allclose(kept, p[np.triu_indices(3)], rtol=1e-8)


@pytest.mark.parametrize("rate_hz", [60.0, 125.0, 1000.0, 8000.0])
def test_stationary_covariance_solves_the_riccati_equation(rate_hz: float) -> None:
    density, noise_m = 30.0, 1e-4
    f, q = transition(1.0 / rate_hz, density)
    h = np.array([[1.0], [0.0], [0.0]])
    before = linalg.solve_discrete_are(f.T, h, q, np.array([[noise_m**2]]))
    after = before - np.outer(before[:, 0], before[:, 0]) / (before[0, 0] + noise_m**2)
    differentiator = KalmanDifferentiator(jerk_density=density, noise_m=noise_m)
    t = np.arange(round(2 * rate_hz)) / rate_hz
    differentiator.run(EventColumns.of(t, t, t))
    kept = law.Memory(differentiator._memory).state.plane.covariance.memory
    np.testing.assert_allclose(kept, after[np.triu_indices(3)], rtol=1e-6)


def test_the_stationary_poles_are_a_butterworth_filters() -> None:
    density, noise_m, rate_hz = 30.0, 1e-4, 8000.0
    f, q = transition(1.0 / rate_hz, density)
    h = np.array([[1.0], [0.0], [0.0]])
    before = linalg.solve_discrete_are(f.T, h, q, np.array([[noise_m**2]]))
    gain = before[:, 0] / (before[0, 0] + noise_m**2)
    poles = np.log(np.linalg.eigvals((np.eye(3) - np.outer(gain, h)) @ f)) * rate_hz
    cutoff = (density * rate_hz / noise_m**2) ** (1.0 / 6.0)
    wanted = cutoff * np.array([-1.0, np.exp(2j * np.pi / 3), np.exp(-2j * np.pi / 3)])
    for pole in wanted:
        assert np.abs(poles - pole).min() < 0.03 * cutoff


def test_settles_when_it_says() -> None:
    """From a start in mid-movement the velocity is right to 3 % once settled, and not before."""

    def moving(t: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        position, velocity, acceleration = parabola(t)
        return position + 0.3 * t, velocity + 0.3, acceleration

    signal = exact(moving, 125.0)
    motions = KalmanDifferentiator().run(signal.events)
    share = np.abs(motions.vx / signal.velocity - 1.0)
    settled = motions.settled == 1.0
    assert share[settled].max() < 0.03
    assert share[~settled].max() > 0.03
    assert 0.02 < signal.events.t[settled][0] < 0.1


@pytest.mark.parametrize(("density", "noise_m"), [(1e-3, 1e-8), (1e-3, 1e-1), (1e9, 1e-8), (1e9, 1e-1)])
@pytest.mark.parametrize("interval", [1e-9, 1e-4, 0.1, 900.0])
def test_extreme_parameters_stay_finite_with_variances_not_negative(
    density: float, noise_m: float, interval: float
) -> None:
    t = np.arange(3000) * interval
    x = np.random.default_rng(1).uniform(-1e3, 1e3, 3000)
    differentiator = KalmanDifferentiator(jerk_density=density, noise_m=noise_m, gap_s=1e3, pause_s=1e3)
    motions = differentiator.run(EventColumns.of(t, x, -x))
    assert np.isfinite(motions.table).all()
    kept = law.Memory(differentiator._memory).state.plane.covariance.memory
    assert (kept[[0, 3, 5]] >= 0.0).all()
