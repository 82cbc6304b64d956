"""Rounding, far-off clocks and screens, extreme rates, long runs."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.differentiators import DIFFERENTIATORS, HomogeneousDifferentiator

TICK = 2.0**-13
NAMES = list(DIFFERENTIATORS)


def reach(period: float = 8 * TICK, count: int = 900) -> EventColumns:
    t = np.arange(count) * period
    s = np.clip(t / 0.7, 0.0, 1.0)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    return EventColumns.of(t, np.round(500 * way), np.round(-300 * way))


def moved(events: EventColumns, seconds: float = 0.0, px: float = 0.0) -> EventColumns:
    table = events.table.copy()
    table[:, 0] += seconds
    table[:, 1:3] += px
    return EventColumns(table)


@pytest.mark.parametrize("name", NAMES)
def test_whole_pixels_and_ticks_may_lie_anywhere(name: str) -> None:
    """Where sums are exact nothing changes at all."""
    here = DIFFERENTIATORS[name]().run(reach())
    there = DIFFERENTIATORS[name]().run(moved(reach(), 2.0**20, 1e6))
    assert np.array_equal(there.table[:, 3:], here.table[:, 3:])


@pytest.mark.parametrize("name", NAMES)
def test_a_far_clock_and_a_far_screen_change_no_more_than_rounding(name: str) -> None:
    events = reach()
    events.table[:, 1:3] += 0.3
    here = DIFFERENTIATORS[name]().run(events)
    there = DIFFERENTIATORS[name]().run(moved(events, 1e6 + 0.1, 1e6 + 0.1))
    # Stamps are rounded to 1e-10 s, positions to 1e-10 px: a millionth of the speed at most.
    np.testing.assert_allclose(there.vx, here.vx, atol=1e-6)
    np.testing.assert_allclose(there.vy, here.vy, atol=1e-6)
    np.testing.assert_allclose(there.ax, here.ax, atol=2e-3)


@pytest.mark.parametrize("name", NAMES)
def test_tiny_intervals_keep_everything_finite(name: str) -> None:
    random = np.random.default_rng(6)
    t = np.cumsum(random.choice([0.0, 5e-324, 1e-300, 1e-160, 1e-30, 1e-9], 600))
    t[300:] += np.arange(300) * 1e-9
    x = random.choice([-1e9, 0.0, 1.0, 1e9], 600)
    assert np.isfinite(DIFFERENTIATORS[name]().run(EventColumns.of(t, x, -x)).table).all()


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("period", [TICK, 1e-3, 1 / 60])
def test_a_hundred_thousand_samples(name: str, period: float) -> None:
    """Finite, of one size, and as good at the end as a differentiator that has just begun."""
    t = np.arange(100_000) * period
    random = np.random.default_rng(9)
    x = np.round(400 * np.sin(3.0 * t) + random.normal(0.0, 0.3, len(t)))
    events = EventColumns.of(t, x, np.round(1e6 + 0.5 * x))
    differentiator = DIFFERENTIATORS[name]()
    size = differentiator._memory.size
    motions = differentiator.run(events)
    assert np.isfinite(motions.table).all()
    assert differentiator._memory.size == size
    young = differentiator.fresh().run(events.rows(95_000, 100_000))
    np.testing.assert_allclose(motions.vx[-500:], young.vx[-500:], atol=2e-6)
    np.testing.assert_allclose(motions.vy[-500:], young.vy[-500:], atol=2e-6)


@pytest.mark.parametrize(("alpha", "step_s"), [(0.0, 0.0499), (-0.02, 0.04), (-0.1, 0.022), (-0.25, 0.0045)])
@pytest.mark.parametrize("between", ["line", "hold"])
def test_homogeneous_law_stays_bounded_at_the_longest_step_allowed(
    alpha: float, step_s: float, between: str
) -> None:
    random = np.random.default_rng(3)
    t = np.cumsum(random.uniform(0.02, 0.09, 20_000))
    x = random.choice([-1e9, 1e9, 0.0], len(t))
    differentiator = HomogeneousDifferentiator(alpha=alpha, step_s=step_s, between=between)
    assert np.isfinite(differentiator.run(EventColumns.of(t, x, x)).table).all()
