"""KEP where its model holds, and what the stability check and the bounds make of it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred import EventColumns, Motion, build, run
from pointpred.predictors import KinematicEndpointPredictor
from pointpred.records import FloatArray, Prediction

DIRECTION = np.array([0.6, -0.8])


def feed(
    predictor: KinematicEndpointPredictor,
    distances: FloatArray,
    speeds: FloatArray,
    *,
    rate_hz: float = 100.0,
) -> list[Prediction | None]:
    """Motions along one line from (40, 30) px."""
    found = []
    for i in range(len(distances)):
        x, y = np.array([40.0, 30.0]) + distances[i] * DIRECTION
        vx, vy = speeds[i] * DIRECTION
        motion = Motion(i / rate_hz, x, y, vx, vy, 0.0, 0.0, True, start=i == 0)
        found.append(predictor.update(motion))
    return found


def lengths(predictions: list[Prediction | None]) -> FloatArray:
    """Predicted length of the whole movement, NaN without a prediction."""
    none = float("nan")
    return np.array([none if p is None else np.hypot(p.x - 40.0, p.y - 30.0) for p in predictions])


@given(length=st.floats(20.0, 3000.0), peak=st.floats(0.01, 2.0), seed=st.integers(0, 999))
@settings(max_examples=30, deadline=None)
def test_exact_when_speed_over_distance_is_a_quadratic(length: float, peak: float, seed: int) -> None:
    random = np.random.default_rng(seed)
    distances = length * np.concatenate([[0.0], np.sort(random.uniform(0.1, 0.95, 40))])
    speeds = 4.0 * peak * distances * (length - distances) / length**2
    ends = lengths(feed(KinematicEndpointPredictor(degree=2), distances, speeds))
    np.testing.assert_allclose(ends[8:], length, rtol=1e-6)


@given(length=st.floats(20.0, 3000.0), skew=st.floats(-0.8, 2.0), seed=st.integers(0, 999))
@settings(max_examples=30, deadline=None)
def test_exact_when_speed_over_distance_is_a_quartic(length: float, skew: float, seed: int) -> None:
    random = np.random.default_rng(seed)
    s = np.concatenate([[0.0], np.sort(random.uniform(0.1, 0.95, 60))])
    speeds = s * (1.0 - s) * (1.0 + skew * s + 0.7 * s**2)
    ends = lengths(feed(KinematicEndpointPredictor(), length * s, speeds))
    np.testing.assert_allclose(ends[20:], length, rtol=1e-6)


def test_a_quadratic_does_not_fit_a_minimum_jerk_movement_and_a_quartic_does_better() -> None:
    """Their speed over distance rises as d^(2/3): late, both ends are near; the quartic's is nearer."""
    tau = np.linspace(0.0, 0.7, 200)
    s, v = 10 * tau**3 - 15 * tau**4 + 6 * tau**5, 30 * tau**2 * (1 - tau) ** 2
    errors = [
        abs(lengths(feed(KinematicEndpointPredictor(degree=n), 500.0 * s, v))[-1] / 500.0 - 1.0)
        for n in (2, 4)
    ]
    assert errors[1] < errors[0] < 0.1


def test_the_endpoint_lies_on_the_line_from_the_start_through_the_cursor() -> None:
    predictor = KinematicEndpointPredictor(degree=2)
    prediction = None
    for i, angle in enumerate(np.linspace(0.0, 1.0, 30)):
        x, y = 300.0 * np.sin(angle), 300.0 * (1.0 - np.cos(angle))
        speed = angle * (1.5 - angle)
        motion = Motion(i / 50, x, y, speed * np.cos(angle), speed * np.sin(angle), 0.0, 0.0, True)
        prediction = predictor.update(motion)
        if prediction is not None:
            assert np.arctan2(prediction.y, prediction.x) == pytest.approx(np.arctan2(y, x))
    assert prediction is not None
    path = 2 * 300.0 * np.sin(1.0 / 58) * 29  # chords
    ahead = np.hypot(prediction.x, prediction.y) - np.hypot(x, y)
    assert ahead == pytest.approx(1.5 * path - path, rel=1e-6)


def test_without_a_zero_within_reach_nothing_is_said() -> None:
    distances = np.arange(20.0)
    assert np.isnan(lengths(feed(KinematicEndpointPredictor(degree=2), distances, 1.0 + distances))).all()
    speeds = 1.0 - distances / 300.0 - (distances / 300.0) ** 2 * 1e-6
    near = lengths(feed(KinematicEndpointPredictor(degree=2), distances, speeds))
    far = lengths(feed(KinematicEndpointPredictor(degree=2, reach=100.0), distances, speeds))
    assert np.isnan(near).all()
    assert far[-1] == pytest.approx(300.0, rel=1e-4)


def test_too_few_distances_or_none_say_nothing() -> None:
    for degree in (2, 3, 4):
        d = np.linspace(0.0, 50.0, degree)
        assert np.isnan(lengths(feed(KinematicEndpointPredictor(degree=degree), d, d * (90.0 - d)))).all()
        still = np.zeros(100)
        assert feed(KinematicEndpointPredictor(degree=degree), still, still) == [None] * 100


def test_a_cursor_back_at_its_start_has_no_direction() -> None:
    d = np.array([0.0, 20.0, 50.0, 70.0, 50.0, 20.0, 0.0])
    path = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(d)))])
    found = feed(KinematicEndpointPredictor(degree=2), d, path * (300.0 - path))
    assert found[-1] is None
    assert found[-2] is not None
    # After the turn the path still grows: 100 px ahead of 20 px, on the far side of the start.
    assert lengths(found)[-2] == pytest.approx(20.0 + (300.0 - 120.0), rel=1e-6)


def test_the_check_accepts_what_changed_little_and_holds_it() -> None:
    random = np.random.default_rng(5)
    t = np.arange(0.0, 0.5, 1 / 125.0)
    s = t / 0.7
    distances = 500.0 * (10 * s**3 - 15 * s**4 + 6 * s**5)
    speeds = 30 * s**2 * (1 - s) ** 2 * (1.0 + 0.03 * random.standard_normal(len(t)))
    free = lengths(feed(KinematicEndpointPredictor(degree=2), distances, speeds))
    gated = lengths(feed(KinematicEndpointPredictor(degree=2, change_most=0.02), distances, speeds))
    held = np.nan
    expected = []
    for before, now in zip(np.concatenate([[np.nan], free]), free, strict=False):
        if abs(now - before) < 0.02 * before:
            held = now
        expected.append(held)
    np.testing.assert_allclose(gated, expected, rtol=1e-9)
    accepted = np.abs(np.diff(free)) < 0.02 * free[:-1]
    assert 5 < accepted.sum() < len(free) - 5


@pytest.mark.parametrize("change_most", [None, 0.02])
def test_a_second_motion_of_the_same_time_changes_neither_fit_nor_check(change_most: float | None) -> None:
    d = np.linspace(0.0, 70.0, 30)
    v = d * (110.0 - d) * (1.0 + 1e-3 * np.cos(d))
    one = KinematicEndpointPredictor(degree=2, change_most=change_most)
    other = KinematicEndpointPredictor(degree=2, change_most=change_most)
    feed(one, d, v)
    feed(other, d, v)
    again = one.update(
        Motion(29 / 100.0, *(np.array([40.0, 30.0]) + 70.0 * DIRECTION), 9.0, 9.0, 0.0, 0.0, True)
    )
    assert again is not None
    later = Motion(0.3, *(np.array([40.0, 30.0]) + 72.0 * DIRECTION), 1.6, -2.1, 0.0, 0.0, True)
    assert one.update(later) == other.update(later)


def test_a_repeated_time_does_not_count_as_stable() -> None:
    """Predictions that jump are never accepted, however often the same sample is reported."""
    d = np.linspace(0.0, 60.0, 13)
    v = d * (110.0 - d) * (1.0 + 0.3 * np.cos(40.0 * d))
    free = lengths(feed(KinematicEndpointPredictor(degree=2), d, v))
    change = 0.5 * np.nanmin(np.abs(np.diff(free)) / free[:-1])
    assert np.isfinite(free).sum() > 5
    assert change > 1e-3
    predictor = KinematicEndpointPredictor(degree=2, change_most=change)
    for i in range(len(d)):
        x, y = np.array([40.0, 30.0]) + d[i] * DIRECTION
        motion = Motion(i / 100.0, x, y, v[i] * 0.6, v[i] * -0.8, 0.0, 0.0, True, start=i == 0)
        again = Motion(i / 100.0, x, y, v[i] * 0.6, v[i] * -0.8, 0.0, 0.0, True)
        assert predictor.update(motion) is None
        assert predictor.update(again) is None


@pytest.mark.parametrize("name", ["kep-quadratic", "kep-quadratic-gated", "kep-quartic", "kep-quartic-gated"])
def test_a_second_movement_is_predicted_as_if_it_were_the_first(name: str) -> None:
    """After a pause a new fit begins, whatever was before."""
    t = np.arange(0.0, 0.75, 0.0078125)
    s = np.clip(t / 0.625, 0.0, 1.0)
    x = np.round(600 * (10 * s**3 - 15 * s**4 + 6 * s**5))
    alone = run(build(name), EventColumns.of(t, x, 0.5 * x)).table
    both = EventColumns.of(
        np.concatenate([t, t + 4.0]), np.concatenate([-x, x - 600]), np.concatenate([x, 0.5 * x + 600])
    )
    second = run(build(name), both).table[len(t) :]
    np.testing.assert_allclose(second[:, 1] + 600, alone[:, 1], rtol=1e-6)
    np.testing.assert_allclose(second[:, 2] - 600, alone[:, 2], rtol=1e-6)
    assert np.isfinite(alone[:, 1]).any()
