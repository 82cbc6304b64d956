"""Trials small enough to cut by hand."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.errors import ParameterError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.scoring import prepare, score

NAN = float("nan")


def recording(*paths: EventColumns, users: str = "", **fields: object) -> Recording:
    trials = [Trial(users[i] if users else "ann", str(i)) for i in range(len(paths))]
    return Recording.of("set", list(paths), trials, **fields)


def along_x(x: list[float], period: float = 0.1, buttons: list[int] | None = None) -> EventColumns:
    return EventColumns.of(np.arange(len(x)) * period, x, np.zeros(len(x)), buttons=buttons)


def test_onset_is_the_last_sample_within_three_pixels_of_the_start() -> None:
    prepared = prepare(recording(along_x([0, 2, 5, -3, 4, 60, 100])))
    trial = prepared.trials[0]
    assert prepared.events.x.tolist() == [-3, 4, 60, 100]
    assert prepared.events.begin.tolist() == [True, False, False, False]
    assert trial.onset_s == pytest.approx(0.3)
    assert trial.distance_px == 103.0
    assert trial.events == 4


def test_a_movement_that_passes_its_start_again_begins_there() -> None:
    prepared = prepare(recording(along_x([0, -50, -20, 1, 60, 100])))
    assert prepared.events.x.tolist() == [1, 60, 100]


@pytest.mark.parametrize(
    ("x", "arrival_s"),
    [
        ([0, 50, 91, 100], 0.3),
        ([0, 50, 92, 100], 0.2),
        ([0, 50, 95, 80, 108, 100], 0.4),
        ([0, 500, 969, 1000], 0.3),
        ([0, 500, 970, 1000], 0.2),
        ([0, 100, 100, 100], 0.1),
    ],
)
def test_arrival_is_where_the_cursor_stays_near_the_endpoint(x: list[float], arrival_s: float) -> None:
    elsewhere = along_x([-4000, -3000])
    assert prepare(recording(elsewhere, along_x(x))).trials[1].arrival_s == pytest.approx(arrival_s)


def test_the_trial_ends_with_the_selecting_click() -> None:
    path = along_x([0, 0, 50, 100, 100, 40, 0], buttons=[0, 1, 0, 1, 0, 0, 0])
    assert prepare(recording(path)).events.x.tolist() == [0, 50, 100]


@pytest.mark.parametrize("buttons", [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 1, 1], [0, 0, 2, 0]])
def test_only_a_primary_press_away_from_the_start_selects(buttons: list[int]) -> None:
    prepared = prepare(recording(along_x([0, 1, 60, 100], buttons=buttons)))
    assert prepared.events.x.tolist() == [1, 60, 100]


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        (along_x([]), "has no events"),
        (along_x([7]), "has one sample, a movement needs two"),
        (along_x([0, 50, 2]), "ends within 3 px of its start"),
        (along_x([5, 5, 5]), "ends within 3 px of its start"),
        (along_x([0, 7, 8]), "never leaves the 8 px (or 3%) around its endpoint after the onset"),
        (along_x([0, 50, 100], period=0.0), "takes no time from onset to arrival"),
        (
            along_x([0, NAN, 100]),
            "event 1 of the trial: a value is not finite or out of range (t 0.1, x nan, y 0, dx nan, dy nan, "
            "buttons 0)",
        ),
        (
            EventColumns.of([0.0, 0.2, 0.1], [0, 50, 100], [0, 0, 0], [1, 2, 3], [0, 0, 0]),
            "event 2 of the trial: time runs backwards (t 0.1, x 100, y 0, dx 3, dy 0, buttons 0)",
        ),
        (
            EventColumns.of([0.0, 0.1], [0, 50], [0, 0], [0, np.inf], [0, 0]),
            "event 1 of the trial: a value is not finite or out of range (t 0.1, x 50, y 0, dx inf, dy 0, "
            "buttons 0)",
        ),
    ],
)
def test_a_trial_that_cannot_be_scored_is_skipped_with_its_reason(path: EventColumns, reason: str) -> None:
    good = along_x([0, 50, 100])
    prepared = prepare(recording(good, path, good))
    assert prepared.skipped == (Skip("1", reason, user="ann"),)
    assert [scored.trial.trial for scored in prepared.trials] == ["0", "2"]


def test_skips_of_the_reader_come_first_and_name_the_user_when_there_are_several() -> None:
    before = Skip("9", "two clocks", 77)
    prepared = prepare(recording(along_x([0, 50, 100]), along_x([1]), users="ab", skipped=[before]))
    assert prepared.skipped == (before, Skip("1", "has one sample, a movement needs two", user="b"))


def test_a_recording_without_trials_prepares_to_nothing() -> None:
    prepared = prepare(recording())
    assert len(prepared.events) == len(prepared.trials) == len(prepared.skipped) == 0


def reach(x0: float, length: float, duration: float) -> np.ndarray:
    s = np.linspace(0.0, 1.0, round(duration * 1000))
    return x0 + length * (10 * s**3 - 15 * s**4 + 6 * s**5)


def test_submovements_are_told_by_the_ratio_of_speed_peaks() -> None:
    smooth = reach(0.0, 600.0, 0.8)
    large = np.concatenate([reach(0.0, 400.0, 0.6), reach(400.0, 200.0, 0.4)])
    small = np.concatenate([reach(0.0, 580.0, 0.6), reach(580.0, 20.0, 0.4)])
    prepared = prepare(recording(*(along_x(list(path), 0.001) for path in (smooth, large, small))))
    assert [trial.submovements for trial in prepared.trials] == [False, True, False]


def test_resolution_comes_from_the_recording_unless_given() -> None:
    counts = np.diff(reach(0.0, 4000.0, 0.8), prepend=0.0)
    still = np.zeros(len(counts))
    x = np.concatenate([reach(0.0, 400.0, 0.4), reach(400.0, 200.0, 0.4)])
    path = EventColumns.of(np.arange(len(x)) * 0.001, x, still, counts, still)
    counted = recording(path, provenance=Provenance("own", cpi=800.0))
    assert [t.submovements for t in prepare(recording(path)).trials] == [True]
    assert [t.submovements for t in prepare(counted).trials] == [False]
    assert [t.submovements for t in prepare(recording(path), cpi=800.0).trials] == [False]


def test_half_counts_are_named_and_the_rest_is_scored() -> None:
    good = along_x([0, 2, 5, 60, 100])
    half = good.table.copy()
    half[3, 3] = 7.0
    prepared = prepare(recording(EventColumns(half), good))
    assert [trial.trial.trial for trial in prepared.trials] == ["1"]
    (skip,) = prepared.skipped
    assert skip.trial == "0"
    assert skip.reason.startswith("event 3 of the trial: a value is not finite or out of range")


def test_a_recording_that_cannot_be_scored_does_not_lose_the_others() -> None:
    good = recording(along_x([0, 2, 5, 60, 100]))
    bad = recording(along_x([0, 2, 5, 60, 100]), provenance=Provenance("csv", dpi=0.0))
    lost: list[tuple[Recording, Exception]] = []
    scores = score([bad, good], ["hold"], failed=lambda *told: lost.append(told))
    assert len(scores) == 1
    assert len(scores[0].trials) == 1
    ((where, why),) = lost
    assert where is bad
    assert "dpi must lie in" in str(why)
    with pytest.raises(ParameterError, match="dpi must lie in"):
        score([bad, good], ["hold"])
    with pytest.raises(ParameterError, match="cpi must lie in"):
        score([], ["hold"], cpi=0.0, failed=lambda *told: lost.append(told))
