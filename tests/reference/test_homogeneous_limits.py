"""The two ends of alpha and the homogeneity between them."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import signal

from pointpred import EventColumns
from pointpred.differentiators import HomogeneousDifferentiator

H = 0.001
GAINS = {2: [10.0, 25.0], 3: [60.0, 1100.0, 6000.0], 4: [75.0, 1750.0, 15000.0, 40000.0]}
PX_PER_M = 96.0 / 0.0254


def wave(count: int = 1500) -> tuple[np.ndarray, np.ndarray]:
    t = np.arange(count) * H
    return t, 0.04 * np.sin(5.0 * t) + 0.01 * np.sin(23.0 * t)


def motions_of(t: np.ndarray, u: np.ndarray, **parameters: object):  # type: ignore[no-untyped-def]
    return HomogeneousDifferentiator(**parameters).run(EventColumns.of(t, u * PX_PER_M, np.zeros_like(u)))


@pytest.mark.parametrize("order", range(2, 9))
def test_alpha_0_is_the_linear_observer(order: int) -> None:
    """Against scipy's simulation of the discretised observer z' = A z - k (z_1 - y)."""
    t, u = wave()
    gains = np.poly(-10.0 * 1.2 ** np.arange(order))[1:]
    a = np.diag(np.ones(order - 1), 1) - np.outer(gains, np.eye(order)[0])
    system = (np.eye(order) + H * a, H * gains[:, None], np.eye(order), np.zeros((order, 1)), H)
    _, states, _ = signal.dlsim(system, u[:-1], t[:-1])
    after = states @ (np.eye(order) + H * a).T + H * np.outer(u[:-1], gains)
    got = motions_of(t, u, order=order, alpha=0.0, gain_lambda=10.0, gain_xi=1.2)
    np.testing.assert_allclose(got.vx[1:], after[:, 1], atol=1e-10)
    if order > 2:
        np.testing.assert_allclose(got.ax[1:], after[:, 2], atol=1e-8)
    else:
        np.testing.assert_allclose(got.ax[1:], gains[1] * (u[:-1] - states[:, 0]), atol=1e-8)


@pytest.mark.parametrize("order", [2, 3, 4])
def test_alpha_minus_one_nth_is_levants_differentiator(order: int) -> None:
    """z_i' = z_(i+1) - k_i |e|^((n-i)/n) sign e, with a pure switch in the last line."""
    t, u = wave(800)
    z = np.zeros(order)
    velocity = [0.0]
    for measured in u[:-1]:
        error = z[0] - measured
        pushes = [
            k * np.abs(error) ** ((order - i) / order) * np.sign(error)
            for i, k in enumerate(GAINS[order][:-1], start=1)
        ]
        pushes.append(GAINS[order][-1] * np.sign(error))
        z = z + H * (np.append(z[1:], 0.0) - np.array(pushes))
        velocity.append(z[1])
    got = motions_of(t, u, order=order, alpha=-1.0 / order, gains=GAINS[order])
    # The switch turns rounding into a step of another sign now and then.
    np.testing.assert_allclose(got.vx, velocity, atol=2e-4)
    assert np.sqrt(np.mean((got.vx - velocity) ** 2)) < 2e-5


@pytest.mark.parametrize("alpha", [-0.25, -0.2, -0.1])
def test_the_law_is_homogeneous(alpha: float) -> None:
    """Time c times faster and positions c^(-1/alpha) times smaller: the same curve, scaled.

    With e -> L e every power L^(1 + j alpha) must equal L c^j, so c = L^alpha.
    """
    t, u = wave(600)
    c = 2.0
    size = c ** (1.0 / alpha)
    slow = motions_of(t, u, alpha=alpha, step_s=0.004)
    fast = motions_of(t / c, u * size, alpha=alpha, step_s=0.004 / c)
    np.testing.assert_allclose(fast.vx / (size * c), slow.vx, atol=2e-5)
    np.testing.assert_allclose(fast.ax / (size * c**2), slow.ax, atol=2e-2)


def convergence(alpha: float) -> tuple[float, float]:
    """Velocity error on a ramp of 0.3 m/s after 0.15 s and after 0.6 s."""
    t = np.arange(800) * 1e-4 * 10
    got = motions_of(t, 0.3 * t, alpha=alpha, step_s=1e-4)
    error = np.abs(got.vx - 0.3)
    return float(error[150:170].max()), float(error[600:620].max())


def test_negative_alpha_converges_in_finite_time_where_the_linear_law_still_creeps() -> None:
    linear_early, linear_late = convergence(0.0)
    early, late = convergence(-0.2)
    assert early < 1e-4 < 1e-2 < linear_early
    assert late < 2e-6 < 1e-3 < linear_late


@pytest.mark.parametrize("alpha", [0.0, -0.1, -0.2, -0.25])
def test_velocity_noise_grows_with_the_power_that_homogeneity_demands(alpha: float) -> None:
    """White noise of size n through a filter of bandwidth w leaves e^2 ~ n^2 w; the law's bandwidth is

    w ~ e^alpha, so e ~ n^(1 / (1 - alpha/2)) and the velocity e w ~ n^((1 + alpha) / (1 - alpha/2)).
    """
    t = np.arange(4000) * H
    noise = np.random.default_rng(5).uniform(-1.0, 1.0, len(t))
    spread = []
    for size in (1e-2, 1e-3, 1e-4):
        got = motions_of(t, size * noise, alpha=alpha, between="hold", step_s=1e-4)
        spread.append(np.sqrt(np.mean(got.vx[1000:] ** 2)))
    powers = np.log10(np.array(spread[:-1]) / np.array(spread[1:]))
    np.testing.assert_allclose(powers, (1.0 + alpha) / (1.0 - alpha / 2.0), atol=0.04)
