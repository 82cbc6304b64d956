"""The JSON document and the table are views of the same numbers."""

from __future__ import annotations

import json
from pathlib import Path

import msgspec
import numpy as np
import pytest

from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.predictors import KinematicPredictor
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recording import Recording, Skip, Trial
from pointpred.records import EventColumns
from pointpred.scoring import (
    HEADINGS,
    Document,
    PredictorErrors,
    ScoredTrial,
    SetScore,
    document,
    footnotes,
    rows,
    score,
    summarise,
)
from pointpred.scoring.summary import Measure

USERS = ["ann", "ann", "bob", "bob", "eve"]
CLEAN = [True, False, True, True, False]
DIVIDED = [True, True, False, True, False]


def errors(name: str, scale: float, seed: int = 4) -> PredictorErrors:
    random = np.random.default_rng(seed)
    return PredictorErrors(
        name,
        time_averaged=scale * random.uniform(50, 150, 5),
        by_time=scale * random.uniform(50, 150, (5, 8)),
        by_path=scale * random.uniform(50, 150, (5, 7)),
        single_axis=scale * random.uniform(50, 150, (5, 20)),
        coverage=np.array([1.0, 0.5, 0.75, 1.0, 0.0]),
        us_per_event=0.25,
        failed=(Skip("3", "RuntimeError: lost its way"),) if name != "hold" else (),
    )


def scored(*predictors: PredictorErrors, trials: int = 5) -> SetScore:
    listed = [
        ScoredTrial(
            Trial(USERS[i], str(i), clean=CLEAN[i]), 300.0, 0.1, 0.8, DIVIDED[i], 40, CLEAN[i] is True
        )
        for i in range(trials)
    ]
    return SetScore("set", tuple(listed), (Skip("7", "two clocks", 12),), predictors, seed=3)


HOLD, HALF = errors("hold", 1.0), errors("half", 0.5)


def test_hold_has_ratio_one_and_no_skill() -> None:
    hold = summarise(scored(HOLD, HALF)).predictors[0]
    cells = [hold.time_averaged, *hold.by_time.values(), *hold.by_path.values()]
    assert [(c.of_hold, c.skill, c.interval) for c in cells] == [(1.0, 0.0, (1.0, 1.0))] * 16


def test_half_the_error_is_half_whoever_is_drawn() -> None:
    half = summarise(scored(HOLD, HALF)).predictors[1]
    for cell in [half.time_averaged, *half.by_time.values(), *half.by_path.values()]:
        assert cell.of_hold == pytest.approx(0.5)
        assert cell.skill == pytest.approx(0.5)
        assert cell.interval == pytest.approx([0.5, 0.5])


def test_the_ratio_is_of_means_over_trials_not_the_mean_of_ratios() -> None:
    other = errors("other", 1.0, seed=5)
    cell = summarise(scored(HOLD, other)).predictors[1].by_path[0.75]
    assert cell.px == pytest.approx(other.by_path[:, 3].mean())
    assert cell.of_hold == pytest.approx(other.by_path[:, 3].mean() / HOLD.by_path[:, 3].mean())
    low, high = cell.interval
    assert low < cell.of_hold < high


def test_names_of_the_public_document() -> None:
    data = msgspec.json.encode(document([scored(HOLD, HALF)]))
    assert msgspec.json.encode(msgspec.json.decode(data, type=Document)) == data
    written = json.loads(data)
    assert list(written) == ["version", "sets", "unread"]
    assert (written["version"], written["unread"]) == (1, [])
    one = written["sets"][0]
    assert [one[key] for key in ("name", "trials", "users", "events")] == ["set", 5, 3, 200]
    assert one["skipped"] == [{"trial": "7", "reason": "two clocks", "row": 12, "user": None}]
    half = one["predictors"][1]
    assert half["failed"] == [
        {"trial": "3", "reason": "RuntimeError: lost its way", "row": None, "user": None}
    ]
    assert (half["name"], half["coverage"], half["us_per_event"]) == ("half", 0.65, 0.25)
    assert list(half["by_time"]) == ["0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9"]
    assert list(half["by_path"]) == ["0.1", "0.25", "0.5", "0.75", "0.9", "0.95", "1.0"]


def test_groups_stand_beside_all_trials() -> None:
    other = errors("other", 1.0, seed=5)
    one = summarise(scored(HOLD, other))
    groups = one.predictors[1].groups
    for name, mask in {
        "clean_trials": np.array(CLEAN),
        "with_submovements": np.array(DIVIDED),
        "without_submovements": ~np.array(DIVIDED),
    }.items():
        assert one.groups[name].trials == mask.sum()
        assert groups[name].time_averaged.px == pytest.approx(other.time_averaged[mask].mean())
        ratio = other.time_averaged[mask].mean() / HOLD.time_averaged[mask].mean()
        assert groups[name].time_averaged.of_hold == pytest.approx(ratio)


def test_every_person_has_a_line() -> None:
    other = errors("other", 1.0, seed=5)
    by_user = summarise(scored(HOLD, other)).predictors[1].by_user
    assert {user: cell.trials for user, cell in by_user.items()} == {"ann": 2, "bob": 2, "eve": 1}
    assert by_user["eve"].of_hold == pytest.approx(other.time_averaged[4] / HOLD.time_averaged[4])


def test_what_is_resampled_is_said() -> None:
    several = summarise(scored(HOLD)).interval
    assert msgspec.structs.asdict(several) == {
        "level": 0.95, "resampled": "users", "draws": 2000, "seed": 3
    }  # fmt: skip
    alone = scored(HOLD)
    alone = SetScore("set", (alone.trials[0],) * 5, (), (HOLD,))
    assert summarise(alone).interval.resampled == "trials"


def test_rows_show_what_the_summary_holds() -> None:
    table = rows(summarise(scored(HOLD, HALF)))
    assert [len(row) for row in table] == [len(HEADINGS)] * 2
    assert table[0][:4] == ("hold", "1.00", "1.00 to 1.00", "1.00")
    assert table[1] == ("half", "0.50", "0.50 to 0.50", *["0.50"] * 8, "65%", "0.25")


def test_a_set_without_trials_has_numbers_nowhere_and_no_warning() -> None:
    nothing = PredictorErrors(
        "hold", *(np.empty(s) for s in (0, (0, 8), (0, 7), (0, 20), 0)), us_per_event=np.nan
    )
    one = summarise(SetScore("none", (), (Skip("1", "has no events"),), (nothing,)))
    assert one.predictors[0].time_averaged == Measure(None, None, None, None)
    assert rows(one) == [("hold", *["-"] * 12)]


def test_without_hold_nothing_can_be_said() -> None:
    with pytest.raises(ParameterError, match="needs the predictor 'hold'"):
        summarise(scored(HALF))


def test_what_has_learned_from_the_set_is_called_so() -> None:
    """The package's own coefficients saw the sets of their card, whatever folder stands before the name."""
    path = EventColumns.of(t=[0.0, 0.1, 0.2, 0.3], x=[0, 1, 60, 101], y=[0, 0, 0, 0])

    def seen(name: str, *pipelines: str | Pipeline) -> list[bool]:
        one = Recording.of(name, [path], [Trial("ann", "1")])
        return [p.seen for p in summarise(score([one], pipelines)[0]).predictors]

    learned = ("kalman", "kinematic", "kinematic-adaptive")
    for known in coefficient_file.card()["sets"]:
        assert seen(known["name"], *learned) == [False, False, True, True]
    assert seen("folder/kh2017", *learned) == [False, False, True, True]
    assert seen("kh2017 of another day", *learned) == [False] * 4


def test_other_coefficients_saw_what_their_own_card_says(tmp_path: Path) -> None:
    with np.load(coefficient_file.OWN) as file:
        held = dict(file)
    held["card"] = np.frombuffer(json.dumps({"sets": [{"name": "elsewhere"}]}).encode(), np.uint8)
    np.savez(tmp_path / "other.npz", **held)
    held["card"] = np.frombuffer(b"{}", np.uint8)
    np.savez(tmp_path / "nameless.npz", **held)
    other = KinematicPredictor(coefficients=tmp_path / "other.npz")
    (tmp_path / "other.npz").unlink()
    assert (other.saw("elsewhere"), other.saw("kh2017")) == (True, False)
    assert not KinematicPredictor(coefficients=tmp_path / "nameless.npz").saw("kh2017")


def test_a_footnote_names_who_has_learned_from_the_set() -> None:
    learned = msgspec.structs.replace(HALF, name="learned", seen=True)
    described = summarise(scored(HOLD, HALF, learned))
    assert footnotes(described)[:-1] == [
        "learned: fitted to people of this set: too good; see docs/evidence/results.md",
    ]
    assert footnotes(described)[-1:] == footnotes(summarise(scored(HOLD, HALF)))
