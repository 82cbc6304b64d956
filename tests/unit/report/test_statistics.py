import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib import cbook
from scipy import stats

from pointpred.errors import ParameterError
from pointpred.recording import Trial
from pointpred.scoring.results import AXIS_FRACTIONS, ScoredTrial, SetScore
from pointpred.scoring.statistics import axis_anova, axis_profile, box, factors_of, replace_outliers
from pointpred.scoring.summary import summarise
from pointpred.scoring.summary.sums import groups_of

samples = st.lists(st.floats(0.0, 1e4), min_size=1, max_size=60).map(np.array)


@given(samples)
def test_a_box_is_the_one_that_matplotlib_draws(values):
    ours, (theirs,) = box(values), cbook.boxplot_stats(values)
    expected = (theirs["q1"], theirs["med"], theirs["q3"], theirs["mean"])
    assert (ours.q1, ours.median, ours.q3, ours.mean) == pytest.approx(expected)
    reach = 1.5 * (ours.q3 - ours.q1)
    inside = [v for v in values if ours.q1 - reach <= v <= ours.q3 + reach]
    assert (ours.low, ours.high) == (min(inside), max(inside))
    assert len(inside) + len(ours.outliers) == ours.count == len(values)


def test_whiskers_and_outliers():
    one = box(np.array([1.0, 2.0, 3.0, 4.0, 5.0, 30.0, np.nan]))
    assert (one.count, one.low, one.high, one.outliers) == (6, 1.0, 5.0, (30.0,))
    assert one.mean_replaced == pytest.approx((1 + 2 + 3 + 4 + 5 + 4.75) / 6)  # the third quartile is 4.75


@given(samples)
def test_replaced_values_are_values_or_quartiles(values):
    kept = replace_outliers(values)
    q1, q3 = np.quantile(values, [0.25, 0.75])
    changed = kept != values
    assert np.isin(kept[changed], [q1, q3]).all()
    assert (np.sign(values - kept)[changed] == np.where(kept[changed] == q3, 1, -1)).all() or q1 == q3
    assert kept.min() >= values.min()
    assert kept.max() <= values.max()


def test_outliers_are_replaced_column_by_column_and_nan_stays():
    column = np.array([0.0, 1.0, 2.0, 3.0, -100.0, np.nan])
    table = np.stack([column, 1000.0 * column, np.full(6, np.nan)], axis=1)
    kept = replace_outliers(table)
    assert kept[4].tolist()[:2] == [0.0, 0.0]
    assert np.array_equal(kept[:, 1], 1000.0 * kept[:, 0], equal_nan=True)
    assert np.isnan(kept[5]).all()
    assert np.isnan(kept[:, 2]).all()
    assert replace_outliers(np.empty((0, 3))).shape == (0, 3)


def test_an_empty_box_is_refused():
    with pytest.raises(ParameterError, match="at least one finite value"):
        box(np.array([np.nan]))


def test_profile_agrees_with_the_summary(score):
    described = {p.name: p for p in summarise(score, draws=20).predictors}
    for predictor in score.predictors:
        px = [cell.px for cell in described[predictor.name].single_axis.values()]
        assert axis_profile(predictor).mae == pytest.approx(px)


def test_anova_of_a_score_is_the_paired_t_test_of_people_s_means(make_score):
    score = make_score(names=("hold", "linear", "ktm"))
    plain = SetScore(score.name, tuple(_plain(t) for t in score.trials), (), score.predictors)
    series = axis_anova(plain, ["linear", "ktm"])
    assert series.factors == ("model",)
    users = np.array([t.trial.user for t in score.trials])
    for i in range(len(AXIS_FRACTIONS)):
        people = [
            [predictor.single_axis[users == user, i].mean() for user in np.unique(users)]
            for predictor in score.predictors[1:]
        ]
        t = stats.ttest_rel(*people)
        (effect,) = series.effects[i]
        assert (effect.f, effect.p) == pytest.approx((t.statistic**2, t.pvalue))


def _plain(scored):
    return ScoredTrial(Trial(scored.trial.user, scored.trial.trial), 300.0, 0.0, 1.0, False, 9)


def test_factors_come_from_conditions_and_the_target_s_width(score):
    series = axis_anova(score, ["switched-printed", "kep-quartic-gated"])
    assert series.factors == ("model", "distance", "width")
    assert series.levels[1:] == (("200", "600"), ("20", "60"))
    assert series.users == 6
    assert [len(at) for at in series.effects] == [7] * len(AXIS_FRACTIONS)
    plain, replaced = (
        next(e for e in effects[4] if e.factors == ("distance",))
        for effects in (series.effects, series.effects_replaced)
    )
    assert replaced.p < 0.01  # errors grow with the distance by construction
    assert plain.f < replaced.f  # and outliers hide it


def test_outcomes_and_partly_known_conditions_are_no_factors():
    known = {"hit": 1.0, "block": 2.0, "ptf": "x"}
    trials = [
        ScoredTrial(Trial("a", str(i), condition=condition), 300.0, 0.0, 1.0, False, 9)
        for i, condition in enumerate((known, known | {"side": 1.0}))
    ]
    assert list(factors_of(trials)) == ["ptf", "block"]


def test_what_was_measured_is_no_factor():
    def trial(i):
        said = {"end_x": 7.0, "duration_s": 1.0, "t_onset_s": 0.2, "room": 20.0 + 0.1 * i}
        known = {"distance": 100.0 + i, "name": f"n{i}"}
        return ScoredTrial(Trial("a", str(i), condition=said | known), 300.0, 0.0, 1.0, False, 9)

    assert list(factors_of([trial(i) for i in range(13)])) == ["distance", "name"]
    assert "room" in factors_of([trial(i) for i in range(12)])


def test_two_people_are_too_few_and_it_is_said(make_score):
    series = axis_anova(make_score(people=2), ["linear", "ktm"])
    assert series.effects == series.effects_replaced == ((),) * len(AXIS_FRACTIONS)
    assert series.notes == ("not run: only 2 people, at least 3 are needed",)


def test_a_factor_that_too_few_people_completed_is_named_once(make_score):
    score = make_score(people=5, names=("hold", "linear"))
    few = tuple(
        one for one in score.trials if one.trial.user < "user 2" or one.trial.condition["distance"] == 200.0
    )
    kept = np.array([one in few for one in score.trials])
    rows = tuple(
        p.__class__(p.name, *(a[kept] for a in (
            p.time_averaged, p.by_time, p.by_path, p.single_axis, p.coverage)), 0.1)
        for p in score.predictors
    )  # fmt: skip
    series = axis_anova(SetScore("few", few, (), rows), ["linear"])
    assert series.factors == ("width",)
    assert series.notes == (
        "distance: not a factor, only 2 of 5 people did every combination, at least 3 are needed",
    )


def test_an_unknown_predictor_is_refused(score):
    with pytest.raises(ParameterError, match="oracle not scored"):
        axis_anova(score, ["oracle"])


def test_groups_partition_the_trials(score):
    groups = {group.label: group.mask for group in groups_of(score)}
    assert groups["all trials"].all()
    assert (groups["with sub-movements"] ^ groups["without sub-movements"]).all()
    assert (groups["experienced people"] ^ groups["novice people"]).all()
    users = np.array([t.trial.user for t in score.trials])
    assert not set(users[groups["experienced people"]]) & set(users[groups["novice people"]])
    share = {name: np.mean([t.submovements for t, m in zip(score.trials, groups[name], strict=True) if m])
             for name in ("experienced people", "novice people")}  # fmt: skip
    assert share["experienced people"] < share["novice people"]
    basis = {group.label: group.basis for group in groups_of(score)}
    assert basis["with sub-movements"] == "highest speed peak less than 5 times the next"
    assert basis["without sub-movements"] == "highest speed peak at least 5 times the next"
    assert "Khalin 2022, remark 2.3.1" in basis["novice people"]


def test_the_recording_s_own_word_on_experience_counts_more():
    trials = tuple(
        ScoredTrial(Trial(u, u, condition={"experience": e}), 300.0, 0.0, 1.0, e == "experienced", 9)
        for u, e in (("a", "novice"), ("b", "experienced"), ("c", "novice"))
    )
    groups = {group.label: group.mask.tolist() for group in groups_of(SetScore("s", trials, (), ()))}
    assert groups["experienced people"] == [False, True, False]
    assert groups["novice people"] == [True, False, True]
