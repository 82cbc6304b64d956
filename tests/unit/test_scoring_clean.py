"""The rule for clean trials, by hand and against sets that judge for themselves."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pointpred.recording import Recording, Trial
from pointpred.recordings import read
from pointpred.records import EventColumns
from pointpred.scoring import prepare
from pointpred.scoring.trials import clean_trials


def verdict(t: list[float], x: list[float], y: list[float]) -> bool:
    return bool(clean_trials(EventColumns.of(t, x, y), np.array([0, len(t)]))[0])


def test_a_straight_reach_is_clean() -> None:
    assert verdict([0.0, 0.1, 0.2], [0, 50, 100], [0, 0, 0])


def test_a_short_one_is_not() -> None:
    assert verdict([0.0, 0.1], [0, 80], [0, 0])
    assert not verdict([0.0, 0.1], [0, 79], [0, 0])


def test_a_detour_is_not() -> None:
    assert verdict([0.0, 0.05, 0.1], [0, 50, 100], [0, 55, 0])  # 1.49 times the distance
    assert not verdict([0.0, 0.05, 0.1], [0, 50, 100], [0, 56, 0])  # 1.50 and more


def test_a_stop_counts_on_the_way_only() -> None:
    times = [0.0, 0.05, 0.1, 0.3, 0.35]
    assert not verdict(times, [0, 50, 50, 51, 100], [0] * 5)
    assert verdict(times, [0, 4, 4, 50, 100], [0] * 5)
    assert verdict(times, [0, 50, 96, 96, 100], [0] * 5)


def test_the_recording_judges_first() -> None:
    path = EventColumns.of([0.0, 0.1, 0.2], [0, 50, 100], [0, 0, 0])
    said = [Trial("ann", "1", clean=False), Trial("ann", "2")]
    assert [one.clean for one in prepare(Recording.of("two", [path, path], said)).trials] == [False, True]


@pytest.mark.recordings
@pytest.mark.parametrize(
    ("name", "agree"), [("freihaut2021", 0.95), ("kh2017", 0.97), ("gofitts_demo", 0.95)]
)
def test_sets_that_judge_for_themselves_agree(recordings: Path, name: str, agree: float) -> None:
    prepared = prepare(read(recordings / f"{name}_samples.parquet"))
    own = np.array([one.trial.clean for one in prepared.trials])
    assert (clean_trials(prepared.events, prepared.offsets) == own).mean() >= agree
