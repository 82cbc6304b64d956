"""The fading parabola against numpy's weighted least squares over all samples."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, PointerEvent
from pointpred.differentiators import FadingMemoryDifferentiator

PX_PER_M = 96.0 / 0.0254


def polyfit(t: np.ndarray, u: np.ndarray, memory_s: float) -> tuple[float, float]:
    """Velocity and acceleration at the last sample; numpy weighs residuals, hence the root."""
    s = t - t[-1]
    curvature, slope, _ = np.polyfit(s, u, 2, w=np.exp(0.5 * s / memory_s))
    return float(slope), float(2.0 * curvature)


@pytest.mark.parametrize("memory_s", [0.005, 0.02, 0.2])
def test_agrees_with_polyfit_at_every_sample(memory_s: float) -> None:
    random = np.random.default_rng(11)
    t = np.cumsum(random.choice([0.001, 0.004, 0.008, 0.017], 150))
    u = 0.1 * np.sin(5.0 * t) + 1e-4 * random.standard_normal(150)
    v = 0.02 * np.cos(9.0 * t)
    motions = FadingMemoryDifferentiator(memory_s=memory_s).run(
        EventColumns.of(t, u * PX_PER_M, v * PX_PER_M)
    )
    for k in range(3, 150, 7):
        recent = slice(max(0, k - 300), k + 1)
        for path, velocity, acceleration in ((u, motions.vx, motions.ax), (v, motions.vy, motions.ay)):
            slope, bend = polyfit(t[recent], path[recent], memory_s)
            assert velocity[k] == pytest.approx(slope, rel=1e-6, abs=1e-8)
            assert acceleration[k] == pytest.approx(bend, rel=1e-6, abs=1e-6)


def test_exact_on_parabolas_however_irregular_and_long() -> None:
    random = np.random.default_rng(4)
    t = np.cumsum(random.uniform(1e-4, 0.02, 20_000))
    # The cursor may go far: 400 px/s^2 over 200 s.
    motions = FadingMemoryDifferentiator(dpi=25.4).run(EventColumns.of(t, 200.0 * t**2, 50.0 - 90.0 * t))
    np.testing.assert_allclose(motions.vx[3:], 0.4 * t[3:], rtol=1e-5, atol=1e-5)
    np.testing.assert_allclose(motions.vy[3:], -0.09, rtol=1e-8)
    np.testing.assert_allclose(motions.ax[50:], 0.4, rtol=2e-3)


def test_two_samples_give_a_line_and_three_a_parabola() -> None:
    differentiator = FadingMemoryDifferentiator(dpi=25.4)
    one = differentiator.update(PointerEvent(0.0, 0.0, 0.0))
    two = differentiator.update(PointerEvent(0.01, 1.0, 0.0))
    three = differentiator.update(PointerEvent(0.02, 4.0, 0.0))
    assert (one.vx, one.ax, one.settled) == (0.0, 0.0, False)
    assert (two.vx, two.ax, two.settled) == (pytest.approx(0.1), 0.0, False)
    assert (three.vx, three.ax, three.settled) == (pytest.approx(0.4), pytest.approx(20.0), True)


def test_samples_far_apart_for_the_memory_still_give_a_line() -> None:
    differentiator = FadingMemoryDifferentiator(memory_s=0.001, gap_s=100.0, pause_s=100.0, dpi=25.4)
    differentiator.update(PointerEvent(0.0, 0.0, 0.0))
    differentiator.update(PointerEvent(50.0, 1e3, 0.0))
    assert differentiator.update(PointerEvent(100.0, 3e3, 0.0)).vx == pytest.approx(0.04, rel=1e-6)
