"""Places as targets: what is proposed where nobody registered anything."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import pytest

from pointpred import Place, PointerEvent, Prediction, build
from pointpred.errors import ParameterError
from pointpred.targets import Choice, PlaceChooser
from tests.aimed import Told

HERE, THERE = Place(0.0, 0.0, 0.1, 0.1, 3.0, 4, 10.0), Place(400.0, 0.0, 0.1, 0.2, 9.0, 2, 10.0)


def likely(place: Place, p: float) -> Place:
    return place._replace(p=p)


def changes(
    chooser: PlaceChooser, places: Sequence[Place], *rows: tuple[float, float, float, int]
) -> list[Choice]:
    """Choices at events of t, x, y and buttons, without predictions."""
    pipeline, made = chooser.pipeline, []
    assert isinstance(pipeline, Told)
    pipeline.places = tuple(places)
    for t, x, y, buttons in rows:
        pipeline.take(None, PointerEvent(t, x, y, buttons=buttons))
        made += chooser.update()
    assert all(one.place is not None for one in made)
    return made


def corner(choice: Choice) -> tuple[float, float]:
    assert choice.place is not None
    return choice.place.x, choice.place.y


def size(choice: Choice) -> tuple[float, float]:
    assert choice.place is not None
    return choice.place.width, choice.place.height


def test_a_place_is_proposed_from_the_share_that_is_asked_for() -> None:
    chooser = PlaceChooser(Told(), precision=0.6)
    assert changes(chooser, [HERE, likely(THERE, 0.59)], (0.0, 100.0, 0.0, 0), (0.1, 150.0, 0.0, 0)) == []
    (made,) = changes(chooser, [HERE, likely(THERE, 0.61)], (0.2, 200.0, 0.0, 0))
    assert (made.id, made.p, made.action, made.reason) == (2, 0.61, "propose", "predicted")
    assert corner(made) == pytest.approx((400.0 - 2.0665 * 10.0, -2.0665 * 10.0))
    assert size(made) == pytest.approx((41.33, 41.33))
    assert chooser.standing == 2


def test_it_stands_until_its_share_is_two_fifths_of_that() -> None:
    chooser = PlaceChooser(Told(), precision=0.6)
    changes(chooser, [likely(THERE, 0.7)], (0.0, 100.0, 0.0, 0), (0.1, 150.0, 0.0, 0))
    assert changes(chooser, [likely(THERE, 0.25)], (0.2, 160.0, 0.0, 0)) == []
    (made,) = changes(chooser, [likely(THERE, 0.23)], (0.3, 170.0, 0.0, 0))
    assert (made.id, made.action) == (2, "retract")


def test_the_order_of_the_places_changes_nothing() -> None:
    """They come with the likeliest first."""
    chooser = PlaceChooser(Told(), precision=0.6)
    changes(chooser, [likely(THERE, 0.7), HERE], (0.0, 100.0, 0.0, 0), (0.1, 150.0, 0.0, 0))
    assert changes(chooser, [HERE, likely(THERE, 0.7)], (0.2, 160.0, 0.0, 0)) == []
    assert chooser.standing == 2


def test_a_place_is_entered_within_its_square() -> None:
    chooser = PlaceChooser(Told())
    edge = 400.0 - 2.0665 * 10.0
    assert changes(chooser, [THERE], (0.0, edge - 0.1, 20.0, 0)) == []
    (made,) = changes(chooser, [THERE], (0.1, edge + 0.1, 20.0, 0))
    assert (made.id, made.action, made.reason) == (2, "propose", "entered")
    assert chooser.entered == 2
    (left,) = changes(chooser, [THERE], (0.2, edge + 0.1, 21.0, 0))
    assert (left.action, left.place) == ("retract", made.place)


def test_a_small_scatter_is_a_square_of_16_px() -> None:
    chooser = PlaceChooser(Told())
    assert changes(chooser, [THERE._replace(spread=0.0)], (0.0, 391.9, 0.0, 0)) == []
    (made,) = changes(chooser, [THERE._replace(spread=0.0)], (0.1, 392.1, 0.0, 0))
    assert size(made) == (16.0, 16.0)


def test_a_place_that_is_forgotten_is_withdrawn() -> None:
    chooser = PlaceChooser(Told())
    changes(chooser, [likely(THERE, 0.7)], (0.0, 100.0, 0.0, 0), (0.1, 150.0, 0.0, 0))
    (made,) = changes(chooser, [HERE], (0.2, 160.0, 0.0, 0))
    assert (made.id, made.action, made.p) == (2, "retract", 0.0)
    assert corner(made)[0] == pytest.approx(400.0 - 2.0665 * 10.0)


def test_the_ledger_counts_as_for_targets() -> None:
    chooser = PlaceChooser(Told())
    changes(chooser, [likely(THERE, 0.7), HERE], (0.0, 100.0, 0.0, 0), (0.1, 150.0, 0.0, 0))
    changes(chooser, [likely(THERE, 0.7), HERE], (0.3, 390.0, 0.0, 0), (0.4, 400.0, 0.0, 0))
    done = chooser.finish()
    assert (done.proposed, done.hit, done.wasted) == (1, True, 0)
    assert done.lead_entry_s == pytest.approx(0.2)
    chooser.reset()
    changes(chooser, [likely(THERE, 0.7), HERE], (1.0, 300.0, 0.0, 0), (1.1, 150.0, 0.0, 0))
    assert chooser.finish().wasted == 1
    assert (chooser.ledger.movements, chooser.ledger.precision) == (2, 0.5)


def test_a_late_prediction_is_none() -> None:
    rows = [(0.0, 0.0), (0.1, 300.0), (0.2, 350.0)]
    for least_s, standing in ((0.0, 2), (0.5, None)):
        pipeline = Told(places=[likely(THERE, 0.9)])
        chooser = PlaceChooser(pipeline, least_lead_s=least_s)
        for t, x in rows:
            pipeline.take(Prediction(t, 400.0, 0.0, None, "ballistic", 0.1), PointerEvent(t, x, 0.0))
            chooser.update()
        assert chooser.standing == standing


def test_parameters_have_the_bounds_of_targets() -> None:
    with pytest.raises(ParameterError, match="precision"):
        PlaceChooser(Told(), precision=0.0)
    chooser = PlaceChooser(Told())
    with pytest.raises(ParameterError, match="least_way_px"):
        chooser.configure(least_way_px=-1.0)
    assert [one.name for one in PlaceChooser.parameters] == ["precision", "least_lead_s", "least_way_px"]


def test_ids_are_those_of_the_places_that_a_person_keeps() -> None:
    pipeline, ids = build("kinematic-adaptive"), []
    for number, (x0, x) in enumerate([(0.0, 400.0), (400.0, 0.0), (0.0, 250.0), (250.0, 400.0)] * 2):
        for i in range(70):
            s = min(i / 60, 1.0)
            way = x0 + (x - x0) * (10 * s**3 - 15 * s**4 + 6 * s**5)
            pipeline.update(PointerEvent(number + i / 100, way, 0.0))
        pipeline.reset()
        ids.append({place.id: round(place.x / 10.0) for place in pipeline.places})
    for before, after in pairwise(ids):
        assert before.items() <= after.items()
    again = build("kinematic-adaptive", person=pipeline.person)
    assert {place.id: round(place.x / 10.0) for place in again.places} == ids[-1]
    assert all(place.spread > 0.0 for place in again.places if abs(place.x - 400.0) > 50.0)


def test_reading_the_places_does_not_change_the_prediction() -> None:
    read, unread = build("kinematic-adaptive"), build("kinematic-adaptive")
    for number in range(4):
        for i in range(70):
            s = min(i / 60, 1.0)
            way = 400.0 * (10 * s**3 - 15 * s**4 + 6 * s**5)
            event = PointerEvent(number + i / 100, way if number % 2 == 0 else 400.0 - way, 0.0)
            _ = read.places
            assert read.update(event) == unread.update(event)
            _ = read.places
        read.reset()
        unread.reset()
    assert read.person == unread.person
