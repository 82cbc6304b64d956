"""What targets are given and cannot use: nonsense predicted, targets of a wrong kind."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import EventColumns, PointerEvent, Prediction, PredictionColumns, build
from pointpred.errors import ParameterError
from pointpred.records import FloatArray, prediction_row
from pointpred.targets import Chooser, Target, around
from pointpred.targets.aim import Aim
from pointpred.targets.posterior import Coefficients
from tests.aimed import Told

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


def both(prediction: Prediction) -> tuple[list[float], FloatArray]:
    """The shares after a reach and the predictions given the targets; those of tables must be the same."""
    one, many = Told(PLACES), Told(PLACES)
    singly = np.array([one.take(prediction, event) for event in reach()])
    events = EventColumns.of_events(reach()).table
    answers = np.full((len(events), len(PredictionColumns.names)), nan)
    for row in answers:
        row[:] = prediction_row(prediction)
    many.aim.follow(np.zeros(len(events), np.bool_), events, answers)
    singly[:, 0] = answers[:, 0] = 0.0
    assert one.aim.shares.tolist() == many.aim.shares.tolist()
    assert singly.tobytes() == answers.tobytes()
    return one.aim.shares.tolist(), answers


def shares_of(prediction: Prediction) -> list[float]:
    return both(prediction)[0]


def said(x: float, y: float, scale: Any, tail: float | None) -> Prediction:
    return Prediction(0.0, x, y, scale, "ballistic", 0.2, tail)


@pytest.mark.parametrize("point", [(1e300, 0.0), (0.0, -inf), (inf, inf), (nan, 0.0), (0.0, nan), (2e9, 0.0)])
def test_a_point_beyond_all_bounds_is_not_claimed(point: tuple[float, float]) -> None:
    assert shares_of(said(*point, LAW, 5.0)) == shares_of(said(nan, nan, None, None))


@pytest.mark.parametrize(
    "covariance", [(inf, 0.0, 1.0), (1.0, 0.0, 1e300), (1e200, 0.0, 1e200), (1.0, nan, 1.0)]
)
@pytest.mark.parametrize("tail", [None, 5.0])
def test_a_region_beyond_all_bounds_is_not_claimed(covariance: Any, tail: float | None) -> None:
    assert shares_of(said(280.0, -100.0, covariance, tail)) == shares_of(said(280.0, -100.0, None, None))


@pytest.mark.parametrize("tail", [0.0, -2.0, inf, -inf, 1e-300])
def test_a_law_of_no_possible_tail_is_not_claimed(tail: float) -> None:
    assert shares_of(said(280.0, -100.0, LAW, tail)) == shares_of(said(280.0, -100.0, None, None))


@given(WILD, WILD, st.tuples(WILD, WILD, WILD), WILD)
def test_whatever_is_predicted_shares_are_shares(x: float, y: float, law: Any, tail: float) -> None:
    for point in ((x, y), (280.0, -100.0)):
        shares, answers = both(said(*point, law, tail))
        assert min(shares) >= 0.0
        assert sum(shares) == pytest.approx(1.0)
        if abs(point[0]) <= 1e9 and abs(point[1]) <= 1e9:
            assert np.isfinite(answers[:, 1:6]).all()
            assert (answers[:, [3, 5]] > 0.0).all()


@pytest.mark.parametrize("name", ["x", "y", "width", "height", "weight"])
@pytest.mark.parametrize("value", ["1", None, True, 1j, [1.0], nan, 10**400])
def test_a_target_of_wrong_kind_is_refused(name: str, value: Any) -> None:
    given: dict[str, Any] = {"id": "a", "x": 1.0, "y": 1.0, "width": 2.0, "height": 2.0, "weight": 1.0}
    pipeline = build("hold", targets=PLACES)
    with pytest.raises(ParameterError, match=f"{name} of target 'a'"):
        pipeline.register([Target(**(given | {name: value}))])
    assert list(pipeline.shares) == ["a", "b", "c", None]


@pytest.mark.parametrize(
    "wrong",
    [
        [Target(cast(Any, []), 0.0, 0.0, 1.0, 1.0)], [Target(([],), 0.0, 0.0, 1.0, 1.0)], [None], ["a"],
        [Target("a", 0.0, 0.0, 0.0, 5.0)], [Target("a", nan, 0.0, 5.0, 5.0)],
        [Target("a", 0.0, 0.0, 5.0, 5.0, -1.0)], [*PLACES, PLACES[0]], [Target(None, 0.0, 0.0, 5.0, 5.0)],
        [around(i, 10.0 * i, 0.0, 5.0) for i in range(1001)],
    ],
)  # fmt: skip
def test_targets_that_are_not_usable_are_refused_and_the_old_ones_kept(wrong: list[Any]) -> None:
    pipeline = build("hold", targets=PLACES)
    before = pipeline.shares
    with pytest.raises(ParameterError, match="target"):
        pipeline.register(wrong)
    assert pipeline.shares == before


@pytest.mark.parametrize("number", [1, np.float32(1.0), np.int64(1)])
def test_numbers_of_any_kind_are_taken(number: Any) -> None:
    pipeline = build("hold", targets=[Target("a", number, number, number, number, number)])
    assert pipeline.shares == pytest.approx({"a": 0.98, None: 0.02})


@pytest.mark.parametrize(
    "wrong",
    [
        np.zeros(3),
        np.zeros((2, Coefficients.length)),
        *(np.full(Coefficients.length, v) for v in (nan, -inf)),
    ],
)
def test_coefficients_that_are_not_usable_are_refused(wrong: FloatArray) -> None:
    with pytest.raises(ParameterError, match=f"{Coefficients.length} finite numbers"):
        Aim(coefficients=wrong)


@pytest.mark.parametrize("name", [one.name for one in Chooser.parameters])
def test_a_setting_that_is_none_is_refused_when_a_chooser_is_made(name: str) -> None:
    wrong: dict[str, Any] = {name: None}
    with pytest.raises(ParameterError, match=name):
        Chooser(Told(), **wrong)
    Chooser(Told()).configure(**wrong)  # there it says: as it is
