"""The features against a second computation: whole signals at once, numpy, nothing streamed."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns, build
from pointpred.predictors.kinematic import features, history
from pointpred.records import FloatArray

LAGS = np.array(features.LAGS_S)


def curved(rate: float, seed: int = 4) -> EventColumns:
    """A bent reach with a correction and a pause, at uneven times."""
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.5, 1.5, int(1.2 * rate)) / rate)
    s = np.clip(t / 0.7, 0.0, 1.0)
    r = np.clip((t - 0.8) / 0.3, 0.0, 1.0)
    way, back = 10 * s**3 - 15 * s**4 + 6 * s**5, 10 * r**3 - 15 * r**4 + 6 * r**5
    return EventColumns.of(t, 500 * way - 60 * back + 3.0, 200 * way**2 + 35 * back - 8.0)


def seen(events: EventColumns) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Motions, features and frames."""
    motions = build("hold").differentiator.run(events).table
    found, frames = np.zeros((len(motions), features.Values.length)), np.zeros((len(motions), 3))
    begin = np.zeros(len(motions), np.bool_)
    begin[0] = True
    features.observe_all(features.State(np.zeros(features.State.length)), begin, motions, found, frames)
    return motions, found, frames


class Slow:
    """What is known at row ``i``, from the start of the signal anew."""

    def __init__(self, motions: FloatArray, i: int) -> None:
        self.t = motions[: i + 1, 0] - motions[0, 0]
        self.place = motions[: i + 1, 1:3] - motions[0, 1:3]
        self.speed = np.hypot(*motions[: i + 1, 3:5].T)
        now = self.t[-1]
        ticks = np.arange(0, int(np.floor(now / history.TICK_S)) + 1) * history.TICK_S
        self.grid = np.append(ticks, now)
        self.on_grid = np.stack([np.interp(self.grid, self.t, axis) for axis in self.place.T], axis=1)
        self.paths = np.append(0.0, np.cumsum(np.hypot(*np.diff(self.on_grid, axis=0).T)))

    def back(self, lag: float) -> FloatArray:
        then = max(self.t[-1] - lag, 0.0)
        return np.array([np.interp(then, self.grid, axis) for axis in self.on_grid.T])

    def path_at(self, then: float) -> float:
        return float(np.interp(max(then, 0.0), self.grid, self.paths))


@pytest.mark.parametrize("rate", [60.0, 125.0, 900.0])
def test_features_agree_with_a_slow_computation(rate: float) -> None:
    motions, found, frames = seen(curved(rate))
    cursor_peak = np.zeros(len(motions))
    for i in range(1, len(motions)):
        slow = Slow(motions, i)
        now = slow.t[-1]
        speed = (slow.paths[-1] - slow.path_at(now - 0.05)) / 0.05
        cursor_peak[i] = max(cursor_peak[i - 1], speed)
        reach = slow.paths[-1] + 0.06 * cursor_peak[i]
        assert frames[i, 0] == pytest.approx(reach, rel=1e-9, abs=1e-9)
        if i % 5 or reach == 0.0:
            continue
        d = np.hypot(*slow.place[-1])
        u = slow.place[-1] / d
        n = np.array([-u[1], u[0]])
        assert frames[i, 1:] == pytest.approx(u, rel=1e-9)
        lags = np.array([slow.place[-1] - slow.back(lag) for lag in LAGS]) / reach
        row = features.Values(found[i])
        np.testing.assert_allclose(row.lag_along, lags @ u, rtol=1e-7, atol=1e-9)
        np.testing.assert_allclose(row.across.lag, lags @ n, rtol=1e-7, atol=1e-9)
        way = float(slow.speed[1:] @ np.diff(slow.t))
        peak, at = slow.speed.max(), int(slow.speed.argmax())
        hand = way + 0.06 * peak + 1e-4
        wanted = {
            "log_reach": np.log(hand),
            "time": now,
            "distance": d / reach,
            "straightness": d / slow.paths[-1],
            "of_farthest": d / np.hypot(*slow.place.T).max(),
            "log_peak": np.log(peak + 3e-4),
            "speed_of_peak": slow.speed[-1] / (peak + 1e-9),
            "since_peak": now - slow.t[at],
            "peak_distance": np.hypot(*slow.place[at]) / reach,
            "mean_of_peak": way / (now + 1e-3) / (peak + 1e-9),
            "v_along": motions[i, 3:5] @ u * 0.1 / hand,
            "a_along": motions[i, 5:7] @ u * 0.01 / hand,
            "slow_for": now - slow.t[_last(slow, 0.2)],
            "slower_for": now - slow.t[_last(slow, 0.05)],
        }
        for name, value in wanted.items():
            assert getattr(row, name) == pytest.approx(value, rel=1e-6, abs=1e-7), name
        v_across = motions[i, 3:5] @ n * 0.1 / hand
        assert row.across.v == pytest.approx(v_across, rel=1e-6, abs=1e-9)


def _last(slow: Slow, share: float) -> int:
    """The last sample at which the speed was at least a share of the peak up to then."""
    return int(np.flatnonzero(slow.speed >= share * np.maximum.accumulate(slow.speed))[-1])


def test_a_sub_movement_begins_in_the_valley_between_two_peaks() -> None:
    t = np.arange(0.0, 1.6, 0.005)
    first, second = np.clip(t / 0.6, 0.0, 1.0), np.clip((t - 0.7) / 0.5, 0.0, 1.0)
    way = sum(a * (10 * s**3 - 15 * s**4 + 6 * s**5) for a, s in ((400.0, first), (80.0, second)))
    motions, found, _ = seen(EventColumns.of(t, way, np.zeros(len(t))))
    subs = found[:, features.PLACE["subs"]]
    assert set(subs.tolist()) == {0.0, 1.0}
    known = int(np.flatnonzero(subs)[0])
    began = motions[known, 0] - features.Values(found[known]).since_sub
    assert 0.6 <= began <= 0.75  # HOMD lags a little behind the valley at 0.6 to 0.7 s
    assert 0.7 < motions[known, 0] < 0.85


@pytest.mark.parametrize(("gap", "x"), [(0.09, 50.0), (0.11, 0.0), (0.3, 0.0)])
def test_between_events_far_apart_the_cursor_stood_and_then_jumped(gap: float, x: float) -> None:
    memory = history.State(np.zeros(history.State.length))
    history.begin(memory)
    now = history.extend(memory, (0.0, 0.0, 0.0), (gap, 100.0, 0.0))
    assert now[1:] == (100.0, 0.0, 100.0)
    assert history.past(memory, now, gap / 2) == pytest.approx((x, 0.0, x))


@pytest.mark.parametrize("gap", [0.05, 0.3, 5.0])
def test_an_event_that_comes_again_at_its_time_is_one_event(gap: float) -> None:
    """However many ticks lie between it and the last."""
    motions = build("hold").differentiator.run(curved(125.0)).table[:80]
    motions[60:, 0] += gap
    motions[:, 8] = 0.0
    twice = np.insert(motions, 60, motions[60], axis=0)
    twice[60, 1:3] += [400.0, -300.0]
    twice[60, 3:7] *= 9.0
    found = []
    for table in (motions, twice):
        out = np.zeros((len(table), features.Values.length))
        begin = np.arange(len(table)) == 0
        features.observe_all(
            features.State(np.zeros(features.State.length)), begin, table, out, np.zeros((len(table), 3))
        )
        found.append(out[-20:])
    assert found[0].tobytes() == found[1].tobytes()
