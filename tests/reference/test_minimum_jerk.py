"""Minimum-jerk inversion against the law it inverts."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from pointpred import EventColumns, Motion, build, run
from pointpred.predictors import MinimumJerkPredictor, minimum_jerk
from pointpred.records import FloatArray, MotionColumns


def way(tau: FloatArray) -> FloatArray:
    """Share of the way at a share of the time, Flash and Hogan 1985."""
    return 10 * tau**3 - 15 * tau**4 + 6 * tau**5


def speed(tau: FloatArray) -> FloatArray:
    """Its derivative."""
    return 30 * tau**2 - 60 * tau**3 + 30 * tau**4


def reach(start: FloatArray, end: FloatArray, seconds: float, t0: float, count: int = 401) -> MotionColumns:
    """Exact motions of a hand that makes 2500 px a metre; an odd count puts a sample on the peak."""
    tau = np.linspace(0.0, 1.0, count)
    table = np.zeros((count, 10))
    table[:, 0] = t0 + seconds * tau
    table[:, 1:3] = start + np.outer(way(tau), end - start)
    table[:, 3:5] = np.outer(speed(tau), end - start) / seconds / 2500.0
    table[:, 7] = 1.0
    table[0, 8] = 1.0
    return MotionColumns(table)


def answers(motions: MotionColumns) -> FloatArray:
    return MinimumJerkPredictor().run(motions, np.zeros(len(motions), np.bool_)).table


PLACE = st.floats(-3000.0, 3000.0)


@given(x=PLACE, y=PLACE, dx=PLACE, dy=PLACE, seconds=st.floats(0.1, 3.0), t0=st.floats(-100.0, 100.0))
@settings(max_examples=40, deadline=None, derandomize=True)
def test_exact_from_the_peak_on_and_doubling_before(
    x: float, y: float, dx: float, dy: float, seconds: float, t0: float
) -> None:
    start = np.array([x, y])
    away = np.array([dx, dy]) + 100.0 * np.sign([dx or 1.0, dy or 1.0])
    motions = reach(start, start + away, seconds, t0)
    table = answers(motions)
    np.testing.assert_allclose(table[200:, 1:3] - start, np.tile(away, (201, 1)), rtol=2e-4, atol=1e-3)
    left = t0 + seconds - motions.t
    np.testing.assert_allclose(table[200:, 6], left[200:], atol=2e-4 * seconds)
    given_rows = ~np.isnan(table[:200, 1])
    assert given_rows[40:].all()
    np.testing.assert_allclose(
        table[:200, 1:3][given_rows],
        (start + 2 * (motions.table[:200, 1:3] - start))[given_rows],
        rtol=1e-9,
        atol=1e-9,
    )
    np.testing.assert_allclose(table[:200, 6][given_rows], (motions.t - t0)[:200][given_rows], atol=1e-9)


def test_at_the_peak_itself_it_is_exact_to_rounding() -> None:
    """Figure 2.11: the peak is half way in time and in space."""
    table = answers(reach(np.array([100.0, 50.0]), np.array([500.0, -250.0]), 0.5, 2.0))
    assert table[200, 1:3] == pytest.approx([500.0, -250.0], rel=1e-12)
    assert table[200, 6] == pytest.approx(0.25, rel=1e-12)
    assert table[200, 7] == 1.0


@given(ratio=st.floats(1e-6, 1.0))
@settings(deadline=None)
def test_progress_inverts_the_speed_profile(ratio: float) -> None:
    """tau against a numerical solution of v(tau) = r v_peak on the falling half."""
    tau, done = minimum_jerk.progress(ratio)
    expected = brentq(lambda s: speed(np.float64(s)) - ratio * 1.875, 0.5, 1.0, xtol=1e-14)
    assert tau == pytest.approx(expected, abs=1e-7)
    assert done == pytest.approx(way(np.float64(tau)), abs=1e-12)


@pytest.mark.parametrize("ratio", [0.0, -1.0, 1.0, 1.0 + 1e-12, 2.0])
def test_progress_is_bounded(ratio: float) -> None:
    """The ends of the profile, and what lies beyond them by rounding."""
    assert minimum_jerk.progress(ratio) == ((1.0, 1.0) if ratio <= 0.0 else (0.5, 0.5))


def test_nothing_is_said_before_the_hand_moves() -> None:
    predictor = MinimumJerkPredictor()
    assert predictor.update(Motion(0.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.0, True, start=True)) is None
    assert predictor.update(Motion(0.1, 5.0, 5.0, 0.0019, 0.0, 0.0, 0.0, True)) is None
    moving = predictor.update(Motion(0.2, 6.0, 5.0, 0.01, 0.0, 0.0, 0.0, True))
    assert moving is not None
    assert (moving.x, moving.y, moving.remaining_s) == (7.0, 5.0, 0.2)


def test_a_stop_is_an_arrival_and_a_weaker_second_movement_a_late_part_of_the_first() -> None:
    predictor = MinimumJerkPredictor()
    predictor.update(Motion(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, True, start=True))
    predictor.update(Motion(0.2, 100.0, 0.0, 0.5, 0.0, 0.0, 0.0, True))
    stopped = predictor.update(Motion(0.4, 200.0, 0.0, 0.0, 0.0, 0.0, 0.0, True))
    again = predictor.update(Motion(0.5, 210.0, 0.0, 0.125, 0.0, 0.0, 0.0, True))
    stronger = predictor.update(Motion(0.6, 260.0, 0.0, 0.6, 0.0, 0.0, 0.0, True))
    assert stopped is not None
    assert again is not None
    assert stronger is not None
    assert (stopped.x, stopped.remaining_s, stopped.phase) == (200.0, 0.0, "still")
    tau = 0.5 * (1 + np.sqrt(0.5))  # r = 1/4
    assert again.x == pytest.approx(210.0 / way(tau))
    assert again.remaining_s == pytest.approx(0.5 / tau - 0.5)
    assert stronger.x == 520.0


def test_an_overshoot_is_never_answered_by_pointing_back() -> None:
    """The cursor turns back at 300 px; the endpoint stays beyond it, seen from the start."""
    motions = reach(np.zeros(2), np.array([300.0, 0.0]), 0.5, 0.0)
    back = reach(np.array([300.0, 0.0]), np.array([280.0, 0.0]), 0.2, 0.5)
    back.table[0, 8] = 0.0
    table = answers(MotionColumns(np.concatenate([motions.table, back.table])))
    assert (table[401:, 1] >= back.x).all()
    assert (table[401:, 1] <= 2.0 * back.x).all()
    assert table[-1, 1] == pytest.approx(280.0, abs=1e-3)


@pytest.mark.parametrize("rate_hz", [1000.0, 125.0, 60.0])
def test_the_whole_pipeline_leaves_a_small_share_of_the_error_after_the_peak(rate_hz: float) -> None:
    """Whole pixels through the differentiator with its printed gains, against no prediction.

    At the peak itself the inversion is as steep as a square root: a speed 2 % below the peak already reads as
    59 % of the way instead of 50 %.
    """
    t = np.arange(0.0, 0.7, 1.0 / rate_hz)
    events = EventColumns.of(t, np.round(560 * way(t / 0.7)), np.round(-420 * way(t / 0.7)))
    late = (t > 0.36) & (t < 0.6)
    errors = [
        np.hypot(table[late, 1] - 560.0, table[late, 2] + 420.0).mean()
        for table in (run(build(name), events).table for name in ("minimum-jerk", "hold"))
    ]
    assert errors[0] < 0.25 * errors[1]
