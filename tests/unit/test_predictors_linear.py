"""Constant velocity over a fixed horizon."""

from __future__ import annotations

from collections import deque

import numpy as np
import pytest

from pointpred import Motion, PointerEvent, build
from pointpred.predictors import LinearPredictor


def at(t: float, x: float, y: float = 0.0, *, start: bool = False) -> Motion:
    """A motion whose velocity is wrong on purpose: it must not matter."""
    return Motion(t, x, y, 9.0, -9.0, 0.0, 0.0, True, start=start)


@pytest.mark.parametrize("rate_hz", [20.0, 60.0, 125.0, 1000.0, 8000.0])
def test_a_ramp_is_continued_exactly_at_any_rate(rate_hz: float) -> None:
    """From the first sample an eighth of the window (15 ms) after the start on."""
    random = np.random.default_rng(1)
    t = 5.0 + np.cumsum(random.uniform(0.5, 1.5, 2000) / rate_hz)
    predictor = LinearPredictor(horizon_s=0.2)
    for i in range(2000):
        prediction = predictor.update(at(t[i], 300.0 * t[i], -40.0 * t[i], start=i == 0))
        if i == 0:
            assert prediction is None
        elif t[i] - t[0] >= 0.015:
            assert prediction is not None
            assert prediction.x == pytest.approx(300.0 * (t[i] + 0.2), rel=1e-9)
            assert prediction.y == pytest.approx(-40.0 * (t[i] + 0.2), rel=1e-9)


def test_at_60_hz_it_is_the_mean_velocity_of_the_last_eight_positions() -> None:
    random = np.random.default_rng(2)
    place = np.cumsum(random.integers(-9, 30, 100)).astype(float)
    history: deque[tuple[float, float]] = deque(maxlen=8)
    predictor = LinearPredictor()
    for i in range(100):
        t, x = i / 60.0, place[i]
        history.append((t, x))
        prediction = predictor.update(at(t, x))
        if i > 0:
            velocity = (x - history[0][1]) / (t - history[0][0])
            assert prediction is not None
            assert prediction.x == pytest.approx(x + 0.12 * velocity, rel=1e-12)


def test_at_a_high_rate_the_window_is_nearly_full() -> None:
    """A step in velocity reaches the mean linearly over the window, not over eight samples."""
    predictor = LinearPredictor(horizon_s=1.0, window_s=0.12)
    velocity = []
    for i in range(1000):
        t = i / 1000.0
        x = 0.0 if t < 0.5 else 400.0 * (t - 0.5)
        prediction = predictor.update(at(t, x))
        velocity.append(0.0 if prediction is None else prediction.x - x)
    # The oldest kept sample lies 105 to 120 ms back.
    assert 400.0 * 60 / 120 - 1e-9 <= velocity[560] <= 400.0 * 60 / 105 + 1e-9
    assert velocity[499] == 0.0
    assert velocity[620] == pytest.approx(400.0)


def test_the_later_of_two_motions_of_one_time_replaces_the_earlier() -> None:
    one, other = LinearPredictor(), LinearPredictor()
    for i in range(30):
        t = i / 50.0
        if i % 3 == 0:
            one.update(at(t, -77.0 * i, 5.0))
        assert one.update(at(t, 4.0 * i)) == other.update(at(t, 4.0 * i))


def test_after_a_gap_the_displacement_over_the_gap_counts() -> None:
    predictor = LinearPredictor(horizon_s=0.1)
    for i in range(20):
        predictor.update(at(i / 100.0, 10.0 * i))
    prediction = predictor.update(at(0.19 + 0.25, 215.0))
    assert prediction is not None
    # The newest kept sample, at 0.18 s and 180 px, is the last before the window.
    assert prediction.x == pytest.approx(215.0 + 0.1 * 35.0 / 0.26)


def test_a_burst_at_the_start_is_bounded_by_the_way_done() -> None:
    predictor = LinearPredictor()
    predictor.update(at(0.0, 0.0, start=True))
    prediction = predictor.update(at(1e-9, 3.0))
    assert prediction is not None
    assert prediction.x == pytest.approx(3.0 + 8.0 * 3.0)


def test_a_reversal_shows_after_half_the_window() -> None:
    predictor = LinearPredictor(window_s=0.12)
    signs = []
    for i in range(100):
        x = 5.0 * i if i <= 50 else 5.0 * (100 - i)
        prediction = predictor.update(at(i / 100.0, x))
        signs.append(0.0 if prediction is None else np.sign(prediction.x - x))
    turned = next(i for i in range(51, 100) if signs[i] < 0.0)
    assert 5 <= turned - 50 <= 7


def test_the_pipeline_needs_no_knowledge_of_the_device() -> None:
    """Counts and resolution change what the hand did, not where the cursor goes."""
    plain, counted = build("linear"), build("linear", cpi=400.0, dpi=220.0)
    for i in range(50):
        event = at(i / 125.0, 3.0 * i)
        one = plain.update(_event(event.t, event.x, None))
        other = counted.update(_event(event.t, event.x, 12.0))
        assert (one is None) == (other is None)
        if one is not None and other is not None:
            assert (one.x, one.y) == (other.x, other.y)


def _event(t: float, x: float, counts: float | None) -> PointerEvent:

    return PointerEvent(t, x, 0.0, counts, None if counts is None else 0.0)
