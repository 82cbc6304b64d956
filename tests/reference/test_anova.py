"""The analysis of variance against a textbook's table, t-tests and sums of squares written out by hand."""

import itertools

import numpy as np
import pytest
from scipy import stats

from pointpred.errors import ParameterError
from pointpred.scoring.statistics import anova, balance, cell_means

DRUGS = np.array([[30, 28, 16, 34], [14, 18, 10, 22], [24, 20, 18, 30], [38, 34, 20, 44], [26, 28, 14, 30.0]])
"""Reaction times of five people under four drugs: Winer 1971, Statistical Principles, table 4.3-1."""


def test_winer_s_table():
    (effect,) = anova(DRUGS, ["drug"])
    assert (effect.df1, effect.df2) == (3, 12)
    assert effect.f == pytest.approx(24.76, abs=0.005)
    assert effect.eta2 == pytest.approx(698.2 / (698.2 + 112.8), abs=1e-4)  # printed sums of squares
    assert effect.epsilon == pytest.approx(0.6049, abs=5e-5)
    assert effect.p_corrected == pytest.approx(0.0006, abs=5e-5)


def test_two_levels_are_a_paired_t_test():
    table = np.random.default_rng(3).normal(size=(9, 2)) + np.array([0.0, 0.8])
    (effect,) = anova(table, ["model"])
    t = stats.ttest_rel(table[:, 0], table[:, 1])
    assert effect.f == pytest.approx(t.statistic**2)
    assert effect.p == pytest.approx(t.pvalue)
    assert (effect.epsilon, effect.p_corrected) == pytest.approx((1.0, effect.p))


def sums_of_squares(table):
    """Effect and error sums of squares of every term, from means of means."""
    axes = range(table.ndim)
    means = {kept: table.mean(axis=tuple(a for a in axes if a not in kept), keepdims=True)
             for size in range(table.ndim + 1) for kept in itertools.combinations(axes, size)}  # fmt: skip

    def interaction(term):
        parts = [means[s] * (-1) ** (len(term) - len(s)) for s in means if set(s) <= set(term)]
        return float(np.sum(np.broadcast_to(sum(parts), table.shape) ** 2))

    return {term: (interaction(term), interaction((0, *term))) for term in means if term and 0 not in term}


def test_three_factors_against_sums_of_squares():
    table = np.random.default_rng(5).normal(40.0, 6.0, size=(7, 2, 3, 2))
    table[:, 1] += 5.0
    table[:, :, 2] += np.arange(7)[:, None, None]
    names = ["model", "distance", "width"]
    effects = {effect.factors: effect for effect in anova(table, names)}
    expected = sums_of_squares(table)
    assert len(effects) == len(expected) == 7
    for term, (between, error) in expected.items():
        effect = effects[tuple(names[axis - 1] for axis in term)]
        df1 = int(np.prod([table.shape[axis] - 1 for axis in term]))
        assert (effect.df1, effect.df2) == (df1, 6 * df1)
        assert effect.f == pytest.approx((between / df1) / (error / effect.df2), rel=1e-8)
        assert effect.eta2 == pytest.approx(between / (between + error), rel=1e-8)


def test_epsilon_of_a_factor_whose_differences_share_one_cause():
    slope = np.random.default_rng(8).normal(size=(20, 1))
    one_cause = slope * np.array([0.0, 1.0, 2.0, 3.0]) + np.array([0.0, 1.0, 0.0, 1.0])
    (effect,) = anova(one_cause + 1e-9 * np.random.default_rng(9).normal(size=(20, 4)), ["model"])
    assert effect.epsilon == pytest.approx(1 / 3, rel=1e-6)  # the lower bound, 1 / df1


def test_shift_and_scale_change_nothing():
    one, other = anova(DRUGS, ["drug"])[0], anova(1e6 + 1e-3 * DRUGS, ["drug"])[0]
    assert (one.f, one.epsilon) == pytest.approx((other.f, other.epsilon), rel=1e-6)


def test_a_term_that_no_one_varies_in_has_no_f():
    people = np.arange(5.0)[:, None]
    assert anova(people + np.zeros((5, 3)), ["model"]) == ()
    assert anova(people + np.array([0.0, 1.0, 2.0]), ["model"]) == ()  # F would be a division by zero
    assert anova(np.full((5, 3), 7.0), ["model"]) == ()


@pytest.mark.parametrize(
    ("table", "factors"),
    [(DRUGS[:2], ["drug"]), (DRUGS[:, :1], ["drug"]), (DRUGS, ["a", "b"]), (DRUGS * np.nan, ["drug"])],
)
def test_what_cannot_be_analysed_is_refused(table, factors):
    with pytest.raises(ParameterError):
        anova(table, factors)


def crossed(people, **factors):
    rows = list(itertools.product(people, *factors.values()))
    columns = {name: [str(row[i + 1]) for row in rows] for i, name in enumerate(factors)}
    return [row[0] for row in rows], columns


def test_balance_keeps_what_everyone_did():
    users, factors = crossed("abcd", distance=[200, 400], width=[10, 20, 40])
    design = balance(users, factors)
    assert (design.users, design.factors, design.notes) == (tuple("abcd"), ("distance", "width"), ())
    values = np.arange(len(users), dtype=float)[:, None]
    assert cell_means(design, values).shape == (4, 1, 2, 3)
    assert cell_means(design, values)[2, 0, 1, 0] == values[2 * 6 + 3, 0]


def test_cells_are_means_of_their_trials():
    design = balance(["a", "a", "a", "b", "b", "c", "c"], {"width": ["1", "1", "2", "1", "2", "2", "1"]})
    table = cell_means(design, np.array([[1.0], [3.0], [9.0], [4.0], [5.0], [6.0], [7.0]]))
    assert table[:, 0].tolist() == [[2.0, 9.0], [4.0, 5.0], [7.0, 6.0]]


def test_a_factor_between_people_is_left_out_and_said():
    users, factors = crossed("abcd", width=[10, 20])
    factors["hand"] = ["left" if user in "ab" else "right" for user in users]
    factors["unique"] = [f"{i}" for i in range(len(users))]
    factors["screen"] = ["one"] * len(users)
    design = balance(users, factors)
    assert design.factors == ("width",)
    assert len(design.users) == 4
    assert design.notes == (
        "hand, unique: not a factor, only 0 of 4 people did every combination, at least 3 are needed",
        "screen: not a factor, it is the same in every trial",
    )


def test_one_of_many_people_with_a_missing_cell_is_left_out_and_said():
    users, factors = crossed([f"p{i:02}" for i in range(20)], width=[10, 20])
    design = balance(users[1:], {"width": factors["width"][1:]})
    assert len(design.users) == 19
    assert "p00" not in design.users
    assert design.notes == ("1 of 20 people not counted: they miss a combination",)
    assert design.cell[0] == -1
    assert cell_means(design, np.ones((39, 1))).shape == (19, 1, 2)
