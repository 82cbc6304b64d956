"""What a chooser is given and cannot use: nonsense predicted, targets of a wrong kind."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import EventColumns, PointerEvent, Prediction, PredictionColumns
from pointpred.errors import ParameterError
from pointpred.records import prediction_row
from pointpred.targets import Chooser, Target, around
from pointpred.targets.posterior import Coefficients

inf, nan = np.inf, np.nan
PLACES = [around("a", 300.0, -120.0, 60.0), around("b", -300.0, 0.0, 60.0), around("c", 300.0, 200.0, 9.0)]
LAW = (1600.0, -500.0, 900.0)
WILD = (
    st.sampled_from([0.0, -0.0, 1.0, -2.0, 1e-300, 1e-9, 1e9, 1e18, 1e154, 1e300, inf, -inf, nan])
    | st.floats()
)


def reach() -> list[PointerEvent]:
    s = np.linspace(0.0, 0.6, 20)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    return [PointerEvent(0.02 * i, 300.0 * w, -120.0 * w) for i, w in enumerate(way.tolist())]


def both(prediction: Prediction) -> list[float]:
    """The shares after a reach, one by one; those of many at once must be the same."""
    one, many = Chooser(PLACES), Chooser(PLACES)
    for event in reach():
        one.update(prediction, event)
    events = EventColumns.of_events(reach())
    answers = np.full((len(events.table), len(PredictionColumns.names)), nan)
    for row in answers:
        row[:] = prediction_row(prediction)
    many.follow(events.table, answers)
    assert one.shares.tolist() == many.shares.tolist()
    return [float(share) for share in one.shares]


def said(x: float, y: float, scale: Any, tail: float | None) -> Prediction:
    return Prediction(0.0, x, y, scale, "ballistic", 0.2, tail)


@pytest.mark.parametrize("point", [(1e300, 0.0), (0.0, -inf), (inf, inf), (nan, 0.0), (0.0, nan), (2e9, 0.0)])
def test_a_point_beyond_all_bounds_is_not_claimed(point: tuple[float, float]) -> None:
    assert both(said(*point, LAW, 5.0)) == both(said(nan, nan, None, None))


@pytest.mark.parametrize(
    "covariance", [(inf, 0.0, 1.0), (1.0, 0.0, 1e300), (1e200, 0.0, 1e200), (1.0, nan, 1.0)]
)
@pytest.mark.parametrize("tail", [None, 5.0])
def test_a_region_beyond_all_bounds_is_not_claimed(covariance: Any, tail: float | None) -> None:
    assert both(said(280.0, -100.0, covariance, tail)) == both(said(280.0, -100.0, None, None))


@pytest.mark.parametrize("tail", [0.0, -2.0, inf, -inf, 1e-300])
def test_a_law_of_no_possible_tail_is_not_claimed(tail: float) -> None:
    assert both(said(280.0, -100.0, LAW, tail)) == both(said(280.0, -100.0, None, None))


@given(WILD, WILD, st.tuples(WILD, WILD, WILD), WILD)
def test_whatever_is_predicted_shares_are_shares(x: float, y: float, law: Any, tail: float) -> None:
    for point in ((x, y), (280.0, -100.0)):
        shares = np.array(both(said(*point, law, tail)))
        assert (shares >= 0.0).all()
        assert shares.sum() == pytest.approx(1.0)


@pytest.mark.parametrize("name", ["x", "y", "width", "height", "weight"])
@pytest.mark.parametrize("value", ["1", None, True, 1j, [1.0], nan, 10**400])
def test_a_target_of_wrong_kind_is_refused(name: str, value: Any) -> None:
    given: dict[str, Any] = {"id": "a", "x": 1.0, "y": 1.0, "width": 2.0, "height": 2.0, "weight": 1.0}
    chooser = Chooser(PLACES)
    with pytest.raises(ParameterError, match=f"{name} of target 'a'"):
        chooser.replace([Target(**(given | {name: value}))])
    with pytest.raises(ParameterError):
        chooser.heading_to(Target(**(given | {name: value})))


@pytest.mark.parametrize(
    "wrong",
    [
        [Target(cast(Any, []), 0.0, 0.0, 1.0, 1.0)], [Target(([],), 0.0, 0.0, 1.0, 1.0)], [None], ["a"],
        [Target("a", 0.0, 0.0, 0.0, 5.0)], [Target("a", nan, 0.0, 5.0, 5.0)],
        [Target("a", 0.0, 0.0, 5.0, 5.0, -1.0)], [*PLACES, PLACES[0]],
        [around(i, 10.0 * i, 0.0, 5.0) for i in range(1001)],
    ],
)  # fmt: skip
def test_targets_that_are_not_usable_are_refused_and_the_old_ones_kept(wrong: list[Any]) -> None:
    chooser = Chooser(PLACES)
    with pytest.raises(ParameterError, match="target"):
        chooser.replace(wrong)
    assert len(chooser.shares) == len(PLACES) + 1


@pytest.mark.parametrize("number", [1, np.float32(1.0), np.int64(1)])
def test_numbers_of_any_kind_are_taken(number: Any) -> None:
    assert Chooser([Target("a", number, number, number, number, number)]).shares.tolist() == [0.0, 1.0]


@pytest.mark.parametrize(
    "wrong",
    [
        ["1.0"] * Coefficients.length, "abc", None, [[1.0], [1.0, 2.0]], [True] * Coefficients.length,
        [0.0] * 3, [1j] * Coefficients.length, [nan] * Coefficients.length, [1e300] * Coefficients.length,
    ],
)  # fmt: skip
def test_coefficients_that_are_no_numbers_are_refused(wrong: Any) -> None:
    with pytest.raises(ParameterError, match=f"{Coefficients.length} finite numbers"):
        Chooser(coefficients=wrong)


@pytest.mark.parametrize("name", [one.name for one in Chooser.parameters])
def test_a_setting_that_is_none_is_refused_when_a_chooser_is_made(name: str) -> None:
    wrong: dict[str, Any] = {name: None}
    with pytest.raises(ParameterError, match=name):
        Chooser(**wrong)
    Chooser().configure(**wrong)  # there it says: as it is
