"""Bootstrap intervals against scipy's, against the normal law, and against what they promise."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from pointpred.scoring.summary import bootstrap
from pointpred.scoring.summary.bootstrap import ratio_intervals


def test_one_trial_a_person_agrees_with_scipy() -> None:
    random = np.random.default_rng(5)
    below = random.gamma(4.0, 30.0, 40)
    above = below * random.uniform(0.5, 1.1, 40)
    users = [f"u{i}" for i in range(40)]
    ours = ratio_intervals(above[:, None], below[:, None], users, seed=1, draws=40_000)
    theirs = stats.bootstrap(
        (above, below),
        lambda a, b, axis: a.mean(axis) / b.mean(axis),
        paired=True,
        vectorized=True,
        method="percentile",
        n_resamples=40_000,
        random_state=np.random.default_rng(2),
    ).confidence_interval
    width = theirs.high - theirs.low
    assert ours.low[0] == pytest.approx(theirs.low, abs=0.02 * width)
    assert ours.high[0] == pytest.approx(theirs.high, abs=0.02 * width)
    assert (ours.resampled, ours.units) == ("users", 40)


def test_people_are_drawn_with_all_their_trials() -> None:
    random = np.random.default_rng(6)
    counts = random.integers(1, 30, 25)
    users = np.repeat([f"u{i}" for i in range(25)], counts)
    above, below = random.gamma(2.0, 10.0, len(users)), random.gamma(3.0, 10.0, len(users))
    sums = [np.bincount(np.repeat(np.arange(25), counts), weights=w) for w in (above, below)]
    theirs = stats.bootstrap(
        tuple(sums),
        lambda a, b, axis: a.sum(axis) / b.sum(axis),
        paired=True,
        vectorized=True,
        method="percentile",
        n_resamples=40_000,
        random_state=np.random.default_rng(2),
    ).confidence_interval
    ours = ratio_intervals(above[:, None], below[:, None], users.tolist(), draws=40_000)
    width = theirs.high - theirs.low
    assert ours.low[0] == pytest.approx(theirs.low, abs=0.02 * width)
    assert ours.high[0] == pytest.approx(theirs.high, abs=0.02 * width)


def test_the_mean_of_many_follows_the_normal_law() -> None:
    errors = np.random.default_rng(7).normal(10.0, 2.0, 400)
    ours = ratio_intervals(
        errors[:, None], np.ones((400, 1)), [str(i) for i in range(400)], draws=40_000, level=0.9
    )
    reach = stats.norm.ppf(0.95) * errors.std() / np.sqrt(400)
    assert ours.low[0] == pytest.approx(errors.mean() - reach, abs=0.03 * reach)
    assert ours.high[0] == pytest.approx(errors.mean() + reach, abs=0.03 * reach)


def test_the_interval_covers_the_truth_as_often_as_it_says_when_people_differ() -> None:
    random = np.random.default_rng(8)
    users = np.repeat([str(i) for i in range(30)], 20).tolist()
    covered = by_trials = 0
    for seed in range(300):
        above = np.repeat(random.normal(1.0, 0.3, 30), 20) + random.normal(0.0, 0.1, 600)
        ones = np.ones((600, 1))
        people = ratio_intervals(above[:, None], ones, users, seed=seed, draws=400)
        trials = ratio_intervals(above[:, None], ones, [str(i) for i in range(600)], seed=seed, draws=400)
        covered += people.low[0] <= 1.0 <= people.high[0]
        by_trials += trials.low[0] <= 1.0 <= trials.high[0]
    assert 0.90 <= covered / 300 <= 0.98
    assert by_trials / 300 < 0.5


def test_one_person_s_trials_are_drawn_and_the_answer_says_so() -> None:
    random = np.random.default_rng(9)
    above, below = random.gamma(2.0, 10.0, (50, 2)), random.gamma(3.0, 10.0, (50, 2))
    alone = ratio_intervals(above, below, ["ann"] * 50, seed=3)
    apart = ratio_intervals(above, below, [f"{i:02d}" for i in range(50)], seed=3)
    assert (alone.resampled, alone.units) == ("trials", 50)
    assert np.array_equal(alone.low, apart.low)
    assert np.array_equal(alone.high, apart.high)
    assert (alone.low < alone.high).all()


def test_two_people_are_drawn_not_their_trials() -> None:
    """Of two people the draws are one of them alone or both: the interval reaches from one to the other."""
    ratio = np.repeat([0.5, 2.0], 20)[:, None]
    two = ratio_intervals(ratio, np.ones((40, 1)), ["ann"] * 20 + ["bob"] * 20)
    assert (two.resampled, two.units) == ("users", 2)
    assert (two.low[0], two.high[0]) == (0.5, 2.0)


def test_the_seed_decides_and_equal_errors_give_exactly_one() -> None:
    random = np.random.default_rng(10)
    above, below = random.gamma(2.0, 10.0, (60, 1)), random.gamma(3.0, 10.0, (60, 1))
    users = [str(i % 7) for i in range(60)]
    first, again, other = (ratio_intervals(above, below, users, seed=seed) for seed in (1, 1, 2))
    assert first.low[0] == again.low[0]
    assert first.low[0] != other.low[0]
    floor = ratio_intervals(below, below, users)
    assert (floor.low[0], floor.high[0]) == (1.0, 1.0)


def test_blocks_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    random = np.random.default_rng(11)
    above, below = random.gamma(2.0, 10.0, (60, 1)), random.gamma(3.0, 10.0, (60, 1))
    whole = ratio_intervals(above, below, ["ann"] * 60)
    monkeypatch.setattr(bootstrap, "BLOCK", 500)
    parts = ratio_intervals(above, below, ["ann"] * 60)
    assert np.array_equal(whole.low, parts.low)
    assert np.array_equal(whole.high, parts.high)


def test_nothing_to_draw_and_nothing_to_divide_by_give_no_interval() -> None:
    empty = ratio_intervals(np.empty((0, 2)), np.empty((0, 2)), [])
    assert empty.units == 0
    assert np.isnan(empty.low).all()
    zero = ratio_intervals(np.ones((3, 1)), np.zeros((3, 1)), ["a", "b", "c"])
    assert np.isnan(zero.high).all()


def test_one_trial_has_no_interval() -> None:
    alone = ratio_intervals(np.array([[3.0]]), np.array([[4.0]]), ["ann"])
    assert np.isnan([alone.low, alone.high]).all()
    assert alone.units == 1
    two = ratio_intervals(np.array([[3.0], [1.0]]), np.array([[4.0], [4.0]]), ["ann", "ann"])
    assert two.low < two.high
