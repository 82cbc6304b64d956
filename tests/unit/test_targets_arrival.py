"""What the time left given a target is a sum of, by hand; and the mean duration."""

from __future__ import annotations

from math import log2

import numpy as np
import pytest

from pointpred.targets import arrival


def test_the_terms_by_hand() -> None:
    """Mean durations of 0.8 s: 0.2 s are said to be left and 0.4 have passed; 60 px to a target of 20."""
    own, one, clock, difficulty, both, near, with_clock = arrival.terms(0.2, 0.4, 0.8, 60.0, 20.0)
    assert (own, one, clock) == pytest.approx((0.25, 1.0, 0.5))
    assert difficulty == pytest.approx(log2(1.0 + 60.0 / 20.0) / 4.0) == pytest.approx(0.5)
    assert (both, with_clock) == pytest.approx((0.25 * 0.5, 0.5 * 0.5))
    assert near == pytest.approx(400.0 / (400.0 + 3600.0))


def test_terms_stay_within_their_bounds() -> None:
    for predicted, since, usual, left, size in (
        (0.0, 0.0, 1e-3, 0.0, 1.0), (1e9, 1e9, 1e-6, 1e9, 1.0), (0.1, 5.0, 0.5, 1e9, 1.0),
    ):  # fmt: skip
        found = np.array(arrival.terms(predicted, since, usual, left, size))
        assert np.isfinite(found).all()
        assert (found >= 0.0).all()
        assert (found <= arrival.LONGEST).all()
    assert arrival.terms(0.1, 5.0, 0.5, 9.0, 9.0)[2] == 0.0  # longer than usual: the clock says now


def test_the_mean_forgets_slowly_and_counts_no_movement_as_longer_than_three_of_it() -> None:
    state = arrival.Durations(np.zeros(arrival.Durations.length))
    assert arrival.mean(state.memory) == 0.0
    taken, durations = [], np.random.default_rng(2).uniform(0.4, 1.2, 40).tolist()
    durations[20] = 60.0
    for duration in durations:
        known = float(arrival.mean(state.memory))
        taken.append(min(duration, arrival.LONGER * known) if taken else duration)
        arrival.remember(state.memory, duration)
        weights = arrival.KEEP ** np.arange(len(taken))[::-1]
        assert arrival.mean(state.memory) == pytest.approx(np.average(taken, weights=weights))
    assert arrival.mean(state.memory) < 1.0
