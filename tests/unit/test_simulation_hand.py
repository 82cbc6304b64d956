"""The chance of the simulated hand, and a click by it; ``tests/page/test_simulated_hand.py`` has its path."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred.simulation import hand


def test_a_movement_ends_with_a_click_in_the_target() -> None:
    memory = np.zeros(hand.LENGTH)
    for seed in range(20):
        hand.begin(memory, float(seed), seed / 20)
        hand.aim(memory, -300.0, 200.0, 24.0)
        reports = [hand.Report(*hand.report(memory))]
        while reports[-1].phase < hand.RELEASED:
            reports.append(hand.Report(*hand.report(memory)))
        pressed = [one for one in reports if one.pressed]
        assert pressed
        assert all(np.hypot(one.x + 300.0, one.y - 200.0) < 13.0 for one in pressed)
        assert np.allclose(np.diff([one.t for one in reports]), hand.PERIOD_S)


@pytest.mark.parametrize(("count", "draw"), [(20_000, hand.uniform), (20_000, hand.normal)])
def test_its_chance_is_even(count: int, draw: Any) -> None:
    stream = np.zeros(hand.Stream.length)
    hand.sow(stream, 1.0)
    drawn = np.array([draw(stream) for _ in range(count)])
    mean, deviation = (0.5, 12**-0.5) if draw is hand.uniform else (0.0, 1.0)
    assert abs(drawn.mean() - mean) < 4.0 * deviation / count**0.5
    assert abs(drawn.std() / deviation - 1.0) < 0.02
    assert abs(np.corrcoef(drawn[1:], drawn[:-1])[0, 1]) < 0.03


def test_the_generator_is_mrg32k3a() -> None:
    """The first number of L'Ecuyer's RngStreams, which begin with 12345 everywhere."""
    stream = np.full(hand.Stream.length, 12345.0)
    assert hand.uniform(stream) == pytest.approx(0.127011122046577, abs=1e-14)


def test_neighbouring_seeds_have_nothing_in_common() -> None:
    first = []
    for seed in range(2000):
        stream = np.zeros(hand.Stream.length)
        hand.sow(stream, float(seed))
        first.append(hand.uniform(stream))
    assert abs(np.corrcoef(first[1:], first[:-1])[0, 1]) < 0.07
    assert np.histogram(first, 10, (0.0, 1.0))[0].min() > 150
