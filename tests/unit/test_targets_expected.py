"""Registered targets take their weights from where the person went before."""

from __future__ import annotations

from itertools import count
from math import nan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import Place, PointerEvent
from pointpred.errors import ParameterError
from pointpred.targets import Chooser, Target
from pointpred.targets.rectangles import LOG_WEIGHT

A, B, C = (Target(id, x, 0.0, 40.0, 40.0) for id, x in (("a", 0.0), ("b", 100.0), ("c", 200.0)))
PAST = st.tuples(*[st.floats(-200.0, 400.0)] * 2, st.floats(0.0, 0.2), st.floats(0.0, 80.0))
"""x, y, share before the movement and scatter of a place."""
NUMBERS = count()


def at(x: float, y: float, before: float, spread: float = 10.0) -> Place:
    return Place(x, y, 0.0, before, 1.0, next(NUMBERS), spread)


def weights(chooser: Chooser) -> list[float]:
    """The share of each target before anything is seen."""
    return np.exp(chooser._table[:, LOG_WEIGHT]).tolist()


def test_a_place_adds_its_share_to_the_weight_of_its_target() -> None:
    """Three targets: 1, 1 + 3 * 0.2 and 1, over their sum."""
    chooser = Chooser([A, B, C])
    chooser.expect([at(120.0, 20.0, 0.2)])
    assert weights(chooser) == pytest.approx([1.0 / 3.6, 1.6 / 3.6, 1.0 / 3.6])


def test_weights_of_the_caller_are_multiplied() -> None:
    chooser = Chooser([A, Target("b", 100.0, 0.0, 40.0, 40.0, 3.0)])
    chooser.expect([at(120.0, 20.0, 0.1), at(110.0, 30.0, 0.15), at(20.0, 20.0, 0.1)])
    assert weights(chooser) == pytest.approx([1.2 / 5.7, 4.5 / 5.7])


def test_a_place_beside_counts_within_its_scatter() -> None:
    near, far = Chooser([A, B]), Chooser([A, B])
    near.expect([at(149.0, 20.0, 0.5)])
    far.expect([at(151.0, 20.0, 0.5)])
    assert weights(near) == pytest.approx([1.0 / 3.0, 2.0 / 3.0])
    assert weights(far) == pytest.approx([0.5, 0.5])


def test_a_place_between_two_counts_for_the_nearer() -> None:
    chooser = Chooser([A, B])
    chooser.expect([at(75.0, 20.0, 0.5, spread=50.0)])
    assert weights(chooser) == pytest.approx([1.0 / 3.0, 2.0 / 3.0])


@pytest.mark.parametrize("turned", [False, True])
def test_a_place_in_two_counts_for_the_smaller(turned: bool) -> None:
    chooser = Chooser([A, Target("page", -500.0, -500.0, 1000.0, 1000.0)][:: -1 if turned else 1])
    chooser.expect([at(20.0, 20.0, 0.5)])
    assert max(weights(chooser)) == pytest.approx(2.0 / 3.0)
    assert weights(chooser).index(max(weights(chooser))) == int(turned)


def test_a_target_of_weight_0_stays_that() -> None:
    chooser = Chooser([A, Target("b", 100.0, 0.0, 40.0, 40.0, 0.0)])
    chooser.expect([at(120.0, 20.0, 0.5)])
    assert weights(chooser) == [1.0, 0.0]
    nobody = Chooser([Target("b", 100.0, 0.0, 40.0, 40.0, 0.0)])
    nobody.expect([at(120.0, 20.0, 0.5)])
    assert weights(nobody) == [0.0]


def test_nobody_known_changes_nothing() -> None:
    events = [PointerEvent(i / 100, 3.0 * i, 20.0) for i in range(40)]
    plain, expecting = Chooser([A, B, C]), Chooser([A, B, C])
    expecting.expect([])
    for event in events:
        assert plain.update(None, event) == expecting.update(None, event)
        assert plain.shares.tolist() == expecting.shares.tolist()


def test_it_holds_for_targets_that_come_later_until_it_is_taken_back() -> None:
    chooser = Chooser([A])
    chooser.expect([at(120.0, 20.0, 0.5)])
    chooser.replace([A, B])
    assert weights(chooser) == pytest.approx([1.0 / 3.0, 2.0 / 3.0])
    chooser.expect([])
    assert weights(chooser) == [0.5, 0.5]


def test_the_likelier_target_is_proposed_earlier() -> None:
    """Two targets on the way, equally near to the line: the one that the person goes to."""
    left, right = Target("left", 300.0, -70.0, 40.0, 40.0), Target("right", 300.0, 30.0, 40.0, 40.0)
    shares = []
    for places in ([], [at(320.0, 50.0, 0.6)]):
        chooser = Chooser([left, right])
        chooser.expect(places)
        for i in range(20):
            chooser.update(None, PointerEvent(i / 100, 8.0 * i, 0.0))
        shares.append(chooser.shares)
    assert shares[0][0] == pytest.approx(shares[0][1])
    assert shares[1][1] / shares[1][0] == pytest.approx(2.2)


@given(st.lists(PAST, max_size=5))
def test_shares_sum_to_one(rows: list[tuple[float, float, float, float]]) -> None:
    chooser = Chooser([A, B, C])
    chooser.expect([at(*row) for row in rows])
    assert sum(weights(chooser)) == pytest.approx(1.0)
    assert min(weights(chooser)) >= 1.0 / (3.0 * (1.0 + sum(before for _, _, before, _ in rows))) - 1e-12


@pytest.mark.parametrize(
    ("wrong", "field"),
    [
        ({"id": 4}, "id"),
        ({"p": nan}, "p"),
        ({"p": 1.1}, "p"),
        ({"p": -0.1}, "p"),
        ({"before": nan}, "before"),
        ({"before": -0.1}, "before"),
        ({"x": nan}, "x"),
        ({"spread": -1.0}, "spread"),
    ],
)
def test_places_that_are_not_usable_are_refused(wrong: dict[str, float], field: str) -> None:
    good = Place(120.0, 20.0, 0.1, 0.2, 1.0, 4, 10.0)
    chooser = Chooser([A, B, C])
    chooser.expect([good])
    before = weights(chooser)
    with pytest.raises(ParameterError) as refused:
        chooser.expect([good, good._replace(**{"id": 5, **wrong})])
    assert refused.value.field == field
    chooser.replace([A, B, C])
    assert weights(chooser) == before
