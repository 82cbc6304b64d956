"""Rules that pick trials, columns whose levels are shown apart, the table of trials, pairs of predictors."""

from __future__ import annotations

import json
from math import sqrt
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from pointpred.datasets import sample
from pointpred.errors import ParameterError, RecordingError
from pointpred.recording import Recording, Trial
from pointpred.recordings import write
from pointpred.scoring import score, summarise
from pointpred.scoring.report.tables import tables_of
from pointpred.scoring.results import ScoredTrial
from pointpred.scoring.selection import names_of, where_of
from pointpred.scoring.statistics import axis_anova, contrasts

LEARNS = "kinematic-adaptive"
SHORT = sample().part(0, 48)
"""Two people, all conditions."""


def scored(user: str, clean: bool, **condition: str | float) -> ScoredTrial:
    return ScoredTrial(Trial(user, "1", target_w=7.0, condition=condition), 300.0, 0.1, 0.9, True, 90, clean)


TRIALS = [
    scored("p1", True, phase="practice", width=20.0, device="no mouse"),
    scored("p2", False, phase="main", width=8.0, events=3.0),
    scored("p3", True, phase="main"),
]
RULES = {
    "phase != practice": [False, True, True],
    "practice == phase": [True, False, False],
    'width >= 20 and user == "p1"': [True, False, False],
    "8 <= width < 20 or user == p3": [False, True, True],
    "width == '8'": [False, True, False],
    "width != 8": [True, False, True],  # what is not known equals nothing
    "not width < 100": [False, False, True],
    "user in (p1, p3)": [True, False, True],
    "width not in [20, -1]": [False, True, True],
    "clean and submovements": [True, False, True],
    "`device` == 'no mouse'": [True, False, False],
    "events == 90 and events_condition == 3": [False, True, False],
    "target_w > 6.5 and distance_px == 3e2": [True, True, True],
}


@pytest.mark.parametrize("text", RULES)
def test_a_rule_picks_trials(text: str) -> None:
    assert where_of(text).mask(TRIALS, names_of(TRIALS)).tolist() == RULES[text]


WRONG = {
    "phas != practice": "know no 'phas'; did you mean phase.*They know user, trial,",
    "phase > 3": "the size of the word 'practice'",
    "1 < 2": "without a column",
    "'main'": "where a comparison should stand",
    "phase is main": "by 'is'",
    "phase == in": r"cannot be read \(invalid syntax\)",
    "phase in main": "needs a list",
    "user.upper() == P1": "where a name",
    "user == __import__('os').sep": "where a name, a number or a word should stand",
    "(lambda: 1)() == user": "where a name",
    "user == f'{1}'": "where a name",
    "(" * 400 + "user" + ")" * 400: "cannot be read",
    "x" * 1001: "at most 1000",
}


@pytest.mark.parametrize("text", WRONG, ids=lambda text: text[:20])
def test_a_rule_that_is_none_says_what_was_expected(text: str) -> None:
    with pytest.raises(ParameterError, match=WRONG[text]):
        where_of(text).mask(TRIALS, names_of(TRIALS))


def test_trials_that_do_not_count_still_teach_and_a_level_is_the_same_trials() -> None:
    (whole,) = score([SHORT], [LEARNS], by=["transfer", "width_mm"])
    (some,) = score([SHORT], [LEARNS], where="transfer == sigmoid", worst=2)
    kept = np.array([one.trial.condition["transfer"] == "sigmoid" for one in whole.trials])
    assert 0 < kept.sum() < len(kept)
    assert np.array_equal(some.predictors[1].time_averaged, whole.predictors[1].time_averaged[kept])
    assert some.notes == (f"{kept.sum()} of {len(kept)} trials count: where transfer == sigmoid",)
    assert all(one.trial.trial.condition["transfer"] == "sigmoid" for one in some.worst.trials)
    apart, alone = summarise(whole), summarise(some)
    group = apart.groups["transfer = sigmoid"]
    assert (group.trials, group.column, group.level) == (kept.sum(), "transfer", "sigmoid")
    assert apart.predictors[1].groups["transfer = sigmoid"].by_time == alone.predictors[1].by_time
    levels = [(one.column, one.level) for one in apart.groups.values() if one.column]
    assert levels == [("transfer", "constant"), ("transfer", "sigmoid"), ("width_mm", "2"), ("width_mm", "7")]
    for name, more in (("nobody", {"where": "user == nobody"}), ("widht_mm", {"by": ["widht_mm"]})):
        with pytest.raises((RecordingError, ParameterError), match=name):
            score([SHORT], ["hold"], **more)
    (many,) = score([sample().part(0, 60)], ["hold"], by=["distance_px"])
    with pytest.raises(ParameterError, match=r"at most 50.* is distance_px_condition\)"):
        summarise(many)


def test_what_is_set_behind_a_name_is_what_build_is_given() -> None:
    names = [f"{LEARNS}:places=0:distances=0", "switched:differentiator=kalman:delay_s=0.02"]
    (spelled,) = score([SHORT], names)
    settings = {
        LEARNS: {"places": 0, "distances": 0},
        "switched": {"differentiator": "kalman", "delay_s": 0.02},
    }
    (given,) = score([SHORT], list(settings), parameters=settings)
    assert [one.name for one in spelled.predictors] == ["hold", *names]
    for one, other in zip(spelled.predictors, given.predictors, strict=True):
        assert np.array_equal(one.by_time, other.by_time)
    with pytest.raises(ParameterError, match="places must lie in"):
        score([SHORT], [f"{LEARNS}:places=2"])


def test_pairs_are_compared_by_paired_t_and_holms_steps() -> None:
    random = np.random.default_rng(3)
    errors = {name: random.normal(100.0 + 4 * k, 10.0, 12) for k, name in enumerate("abcd")}
    found = {(one.first, one.second): one for one in contrasts(errors)}
    assert len(found) == 6
    for (first, second), one in found.items():
        d = errors[first] - errors[second]
        assert one.px == pytest.approx(d.mean(), abs=1e-12)
        assert one.t == pytest.approx(d.mean() / (d.std(ddof=1) / sqrt(12)), rel=1e-12)
    # Holm 1979: the k-th smallest of m is multiplied by m - k + 1, none is smaller than the one before.
    ordered, largest = sorted(found.values(), key=lambda one: one.p), 0.0
    for k, one in enumerate(ordered):
        largest = max(largest, min(1.0, (6 - k) * one.p))
        assert one.p_holm == pytest.approx(largest, rel=1e-12)
    (alone,) = contrasts(errors, ("d", "a"))
    assert (alone.first, alone.p_holm) == ("d", alone.p) == ("d", found["a", "d"].p)
    (same,) = contrasts({"a": errors["a"], "b": errors["a"]})
    assert (same.px, same.p, same.p_holm) == (0.0, None, None)


def test_who_was_asked_for_is_compared_and_nobody_else() -> None:
    names = ["switched", "kep-quadratic", "linear"]
    (one,) = score([sample().part(0, 240)], names, contrast=["linear", "switched"])
    (pair,) = summarise(one).contrasts
    assert (pair.first, pair.second, pair.people, pair.df) == ("linear", "switched", 10, 9)
    people = np.array([each.trial.user for each in one.trials])
    by_name = {each.name: each.time_averaged for each in one.predictors}
    means = [
        np.mean(by_name["linear"][people == who]) - np.mean(by_name["switched"][people == who])
        for who in np.unique(people)
    ]
    assert pair.px == pytest.approx(np.mean(means), rel=1e-9)
    _, table = tables_of(summarise(one), axis_anova(one, one.contrast))["contrasts"]
    assert table[["first", "second", "difference [px]"]].values.tolist() == [["linear", "switched", pair.px]]
    (few,) = score([SHORT], names, contrast=["all"])
    assert "at least 3 people" in summarise(few).notes[-1]
    for wrong in (["linear"], ["linear", "linear"], ["linear", "kalman"]):
        with pytest.raises(ParameterError, match="contrast needs two of the predictors scored"):
            score([SHORT], names, contrast=wrong)


@pytest.fixture
def two_sets(tmp_path: Path) -> list[Path]:
    """A condition is a number in one of them and a word in the other."""
    files = []
    for name, block in (("one", 1.0), ("two", "last")):
        part = SHORT.part(0, 6)
        trials = [
            Trial(t.user, t.trial, condition={"block": block, "phase": "ab"[k % 2]})
            for k, t in enumerate(part.trials)
        ]
        parts = [part.rows(k) for k in range(len(trials))]
        files.append(write(Recording.of(name, parts, trials), tmp_path / f"{name}_samples.parquet")[0])
    return files


@pytest.mark.parametrize("ending", ["csv", "parquet"])
def test_the_table_of_trials_holds_what_the_document_is_made_of(
    command, two_sets: list[Path], tmp_path: Path, ending: str
) -> None:
    out, numbers = tmp_path / f"out.{ending}", tmp_path / "out.json"
    words = ("score", *two_sets, "--predictors", "linear", "--trials", out, "--json", numbers, "--force")
    assert command(*words, "--where", "phase == a").code == 0
    assert command(*words, "--by", "phase,user").code == 0  # its own table may be replaced
    frame = pd.read_csv(out, dtype={"trial": str}) if ending == "csv" else pd.read_parquet(out)
    assert len(frame) == 24
    assert set(frame["block"]) == {"1", "last"}
    sets = json.loads(numbers.read_text())["sets"]
    for one in sets:
        rows = frame[frame["set"] == one["name"]]
        for predictor in one["predictors"]:
            own = rows[rows["predictor"] == predictor["name"]]
            assert own["time_30_px"].mean() == pytest.approx(predictor["by_time"]["0.3"]["px"], rel=1e-12)
            group = own[own["phase"] == "a"]["time_averaged_px"].mean()
            found = predictor["groups"]["phase = a"]["time_averaged"]["px"]
            assert group == pytest.approx(found, rel=1e-12)
        assert one["groups"]["user = p01"]["level"] == "p01"


def test_options_of_selection_are_refused_before_anything_is_scored(command, two_sets: list[Path]) -> None:
    def said(*words: str) -> tuple[int, str]:
        left = command("score", *two_sets, "--predictors", "linear", *words)
        return left.code, left.err

    assert said("--trials", "out.xlsx") == (
        2,
        "pointpred: --trials out.xlsx: expected a name that ends in .csv or .parquet\n",
    )
    assert said("--where", "1 +")[0] == 2
    code, words = said("--where", "phas == a")
    assert (code, "did you mean phase" in words, "no trial could be scored" in words) == (1, True, True)
    assert "linear, hold" in said("--contrast", "hold,ktm")[1].replace("hold, linear", "linear, hold")
    shown = command("score", two_sets[0], "--predictors", "linear", "--by", "phase", "--contrast", "all")
    assert "phase = b: 3 trials" in shown.out
    assert "no contrasts" in shown.err
