"""What a person took before: against a model of lists and dictionaries."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from math import exp, inf, log
from typing import NamedTuple

import numpy as np
import pytest

from pointpred.records import FloatArray
from pointpred.targets import past
from pointpred.targets.rectangles import FIELDS, LOG_WEIGHT

RULES = ("given", "often", "lately", "after", "alike")


class Key(NamedTuple):
    """What a target is known by: numbers for its id, and for its kind and size."""

    id: float
    kind: float


class Model:
    """The past as it is described: what was taken, the last one first, and visits by rule."""

    def __init__(self) -> None:
        self.taken: list[Key | None] = []
        self.visits = dict.fromkeys(RULES, 0.0)
        self.to = self.none = 0.0

    def shares(self, given: dict[Key, float]) -> dict[str, dict[Key, float]]:
        """The share of each target by each rule."""
        counts = {rule: dict.fromkeys(given, 0.0) for rule in RULES}
        for ago, key in enumerate(self.taken):
            if key is None:
                continue
            by_id = {one.id: one for one in given}
            late, often = exp(-ago / past.LATE_AGE), exp(-ago / past.OFTEN_AGE)
            if key.id in by_id:
                here = by_id[key.id]
                counts["often"][here] += often
                counts["lately"][here] += late
                before = self.taken[ago + 1] if ago + 1 < len(self.taken) else None
                if self.taken[0] is not None and before is not None and before.id == self.taken[0].id:
                    counts["after"][here] += often
            alike = [one for one in given if one.kind == key.kind]
            total = sum(given[one] for one in alike)
            for one in alike if total > 0.0 else ():
                counts["alike"][one] += often * given[one] / total
        found = {"given": given}
        for rule in RULES[1:]:
            counted = {one: counts[rule][one] if given[one] > 0.0 else 0.0 for one in given}
            total = past.GIVEN_OF + sum(counted.values())
            found[rule] = {one: (counted[one] + past.GIVEN_OF * given[one]) / total for one in given}
        return found

    def belief(self) -> dict[str, float]:
        fading = past.FADING_OF / (past.FADING_OF + self.to)
        visits = {rule: self.visits[rule] + fading * past.FIRST_RULES[i] for i, rule in enumerate(RULES)}
        return {rule: value / sum(visits.values()) for rule, value in visits.items()}

    def weights(self, given: dict[Key, float]) -> dict[Key, float]:
        """How likely each target is before a movement."""
        if self.to == 0.0:
            return given
        shares, belief = self.shares(given), self.belief()
        return {one: sum(belief[rule] * shares[rule][one] for rule in RULES) for one in given}

    def learn(self, given: dict[Key, float], taken: Key | None) -> None:
        self.to, self.none = past.KEEP * self.to, past.KEEP * self.none
        if taken is None:
            self.none += 1.0
        else:
            self.to += 1.0
            shares, belief = self.shares(given), self.belief()
            made = {rule: belief[rule] * shares[rule][taken] for rule in RULES}
            for rule in RULES:
                part = made[rule] / sum(made.values()) if sum(made.values()) > 0.0 else 0.0
                self.visits[rule] = past.KEEP * self.visits[rule] + part
        self.taken = [taken, *self.taken][: past.CAPACITY]


class Page:
    """Targets as laws take them, and what is known of a person."""

    def __init__(self, state: past.Past, keys: Sequence[Key], weights: Sequence[float] | None = None) -> None:
        given = np.ones(len(keys)) if weights is None else np.array(weights, dtype=float)
        self.state, self.keys = state, np.array(keys).reshape(-1, past.KEYS)
        self.given = dict(zip(keys, (given / given.sum()).tolist(), strict=True))
        self.own = np.array([log(share) if share > 0.0 else -inf for share in self.given.values()])

    def weights(self) -> FloatArray:
        """How likely each target is before a movement."""
        rows = np.zeros((len(self.keys), FIELDS))
        past.weigh(self.state.memory, self.own, self.keys, rows)
        return np.exp(rows[:, LOG_WEIGHT])

    def take(self, place: int) -> None:
        past.learn(self.state.memory, self.own, self.keys, place)


def nobody() -> past.Past:
    return past.Past(np.zeros(past.Past.length))


A, B, C, D = Key(11.0, 1.0), Key(12.0, 1.0), Key(13.0, 2.0), Key(14.0, 2.0)
PAGES = [([A, B, C], [1.0, 2.0, 1.0]), ([D, A], [1.0, 1.0]), ([B, D, C, A], [0.0, 1.0, 3.0, 1.0])]


@pytest.mark.parametrize("seed", range(5))
def test_weights_are_those_of_a_model_of_lists(seed: int) -> None:
    """Over movements to targets of three pages by turns, and to none; more than are remembered."""
    random, state, model = np.random.default_rng(seed), nobody(), Model()
    for number in range(150):
        keys, weights = PAGES[int(random.integers(3)) if number % 7 == 0 else 0]
        page = Page(state, keys, weights)
        found = page.weights()
        assert found == pytest.approx(list(model.weights(page.given).values()), rel=1e-9, abs=1e-12)
        assert found.sum() == pytest.approx(1.0)
        assert (found[np.array(weights) == 0.0] == 0.0).all()
        taken = int(random.choice([-1, *range(len(keys))], p=None))
        page.take(taken)
        model.learn(page.given, keys[taken] if taken >= 0 else None)
        share = past.elsewhere(state.memory, 0.02)
        assert share == pytest.approx(max(0.02, (0.02 + model.none) / (1.0 + model.to + model.none)))
    assert state.count == past.CAPACITY
    assert list(state.rules) == pytest.approx([model.visits[rule] for rule in RULES])


def test_where_nobody_went_weights_are_the_callers_exactly() -> None:
    state = nobody()
    page = Page(state, [A, B, C], [1.0, 2.0, 4.0])
    rows = np.zeros((3, FIELDS))
    for _ in range(3):
        past.weigh(state.memory, page.own, page.keys, rows)
        assert rows[:, LOG_WEIGHT].tolist() == page.own.tolist()
        page.take(-1)  # nor do movements to none of them tell them apart
    assert past.elsewhere(nobody().memory, 0.3) == pytest.approx(0.3)


def test_an_order_is_learned() -> None:
    """A, B, A, B and so on, among eight: each is expected after the other."""
    page, likeliest, shares = Page(nobody(), [Key(1.0 + i, 1.0 + i) for i in range(8)]), [], []
    for number in range(80):
        weights = page.weights()
        likeliest.append(weights.argmax() == number % 2)
        shares.append(weights[number % 2])
        page.take(number % 2)
    assert all(likeliest[6:])
    assert shares[20] > 0.35
    assert shares[79] > 0.6


def test_what_is_taken_most_is_likeliest_and_another_that_is_alike_is_likelier_than_the_rest() -> None:
    random, page = np.random.default_rng(3), Page(nobody(), [A, B, C, D])
    counts: Counter[int] = Counter()
    for place in random.choice(4, 60, p=[0.1, 0.0, 0.7, 0.2]).tolist():
        page.take(place)
        counts[place] += 1
    weights = page.weights()
    assert np.argsort(-weights).tolist() == [2, 3, 0, 1]
    new = Page(page.state, [Key(20.0, A.kind), Key(21.0, C.kind), Key(22.0, 9.0)]).weights()
    assert new[1] > new[0] > new[2]


def test_a_target_of_weight_0_stays_that() -> None:
    page = Page(nobody(), [A, B], [1.0, 0.0])
    for _ in range(10):
        page.take(1)
        assert page.weights().tolist() == [pytest.approx(1.0, abs=1e-12), 0.0]


def test_movements_to_none_of_the_targets_raise_its_share_and_it_stays_below_one() -> None:
    page, shares = Page(nobody(), [A, B]), []
    for _ in range(500):
        page.take(-1)
        shares.append(float(past.elsewhere(page.state.memory, 0.02)))
    assert shares == sorted(shares)
    assert shares[9] > 0.8
    assert shares[-1] <= past.NONE_MOST
    for _ in range(200):
        page.take(0)
    assert past.elsewhere(page.state.memory, 0.02) < 0.05
    assert past.elsewhere(page.state.memory, 0.4) == 0.4
