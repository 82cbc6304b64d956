"""A target has its choice when the cursor enters it at the latest, and loses it when the cursor leaves."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import PointerEvent, Prediction, build
from pointpred.targets import Choice, Chooser, Target, around
from tests.aimed import Told

Row = tuple[float, float, float, int]
"""t s, x and y px, buttons."""
CARD = Target("card", 100.0, 0.0, 200.0, 142.0)
BUTTON = Target("button", 120.0, 80.0, 60.0, 24.0)
MENU = [Target(f"row {i}", 0.0, 24.0 * i, 180.0, 24.0) for i in range(20)]


class Page:
    """A chooser of a precision that nothing reaches: without predictions only entries are proposed."""

    def __init__(self, *targets: Target) -> None:
        self.pipeline = Told(targets)
        self.chooser = Chooser(self.pipeline, precision=0.999, least_lead_s=10.0)

    def says(self, *rows: Row) -> list[tuple[str, str, str | None]]:
        """What a chooser says while a cursor moves so."""
        found: list[Choice] = []
        for t, x, y, buttons in rows:
            self.pipeline.take(None, PointerEvent(t, x, y, buttons=buttons))
            found += self.chooser.update()
        return [(one.action, str(one.id), one.reason) for one in found]

    def replace(self, *targets: Target) -> list[tuple[str, str]]:
        """Other targets; what ends."""
        self.pipeline.aim.register(targets)
        return [(one.action, str(one.id)) for one in self.chooser.follow_targets()]

    def reset(self) -> None:
        self.pipeline.aim.reset()
        self.chooser.reset()


def taken(
    chooser: Chooser, pipeline: Told, prediction: Prediction, event: PointerEvent
) -> tuple[Choice, ...]:
    pipeline.take(prediction, event)
    return chooser.update()


def test_entered_and_left() -> None:
    page = Page(CARD)
    assert page.says((0.0, 0.0, 50.0, 0), (0.1, 99.9, 50.0, 0)) == []
    assert page.says((0.2, 100.0, 50.0, 0)) == [("propose", "card", "entered")]
    assert page.says((0.3, 250.0, 50.0, 0), (9.0, 260.0, 50.0, 0)) == []
    assert (page.chooser.entered, page.chooser.standing) == ("card", None)
    assert page.says((9.1, 301.0, 50.0, 0)) == [("retract", "card", None)]
    assert page.says((9.2, 299.0, 50.0, 0)) == [("propose", "card", "entered")]


@pytest.mark.parametrize("order", [(CARD, BUTTON), (BUTTON, CARD)])
def test_of_overlapping_targets_the_smallest_is_entered(order: tuple[Target, Target]) -> None:
    page = Page(*order)
    said = page.says((0.0, 150.0, 20.0, 0), (0.1, 150.0, 90.0, 0), (0.2, 150.0, 120.0, 0))
    assert said == [
        ("propose", "card", "entered"),
        ("retract", "card", None),
        ("propose", "button", "entered"),
        ("retract", "button", None),
        ("propose", "card", "entered"),
    ]


def test_of_equally_large_ones_the_last_is_entered() -> None:
    page = Page(Target("a", 0.0, 0.0, 40.0, 40.0), Target("b", 20.0, 0.0, 40.0, 40.0))
    assert page.says((0.0, 30.0, 10.0, 0)) == [("propose", "b", "entered")]


def test_a_target_of_weight_0_is_not_entered() -> None:
    assert Page(Target("a", 0.0, 0.0, 9.0, 9.0, 0.0)).says((0.0, 3.0, 3.0, 0)) == []


def test_a_release_ends_it_until_the_cursor_has_left() -> None:
    page = Page(CARD)
    rows = [(0.0, 150.0, 50.0, 0), (0.1, 150.0, 50.0, 1), (0.2, 150.0, 50.0, 0)]
    assert page.says(*rows) == [("propose", "card", "entered"), ("retract", "card", None)]
    assert page.says((0.3, 160.0, 50.0, 0), (0.4, 170.0, 50.0, 1), (0.5, 170.0, 50.0, 0)) == []
    page.replace(BUTTON, CARD)  # a page that has moved its elements says them again
    assert page.says((0.55, 170.0, 50.0, 0)) == []
    assert page.says((0.6, 0.0, 0.0, 0), (0.7, 150.0, 50.0, 0)) == [("propose", "card", "entered")]


def test_what_goes_away_is_retracted_and_what_stays_is_not_entered_again() -> None:
    page = Page(CARD, BUTTON)
    page.says((0.0, 150.0, 50.0, 0))
    assert page.replace(BUTTON, CARD) == []
    assert page.says((0.1, 151.0, 50.0, 0)) == []
    assert page.replace(BUTTON) == [("retract", "card")]
    assert page.replace(BUTTON, CARD) == []
    assert page.says((0.2, 152.0, 50.0, 0)) == [("propose", "card", "entered")]


@pytest.mark.parametrize("buttons", [(0,), (0, 1), (0, 1, 0)], ids=["inside", "pressed", "released"])
def test_a_reset_ends_it_until_the_cursor_has_left(buttons: tuple[int, ...]) -> None:
    page = Page(CARD)
    page.says(*((0.1 * i, 150.0, 50.0, down) for i, down in enumerate(buttons)))
    page.reset()
    assert page.chooser.entered is None
    assert page.says((0.0, 150.0, 50.0, 0), (0.1, 160.0, 50.0, 0)) == []
    assert page.says((0.2, 0.0, 0.0, 0), (0.3, 150.0, 50.0, 0)) == [("propose", "card", "entered")]


def test_a_reset_far_from_a_target_takes_nothing_from_its_next_entry() -> None:
    page = Page(CARD, Target("other", 400.0, 0.0, 200.0, 142.0))
    page.says((0.0, 150.0, 50.0, 0))
    page.reset()
    assert page.says((0.0, 450.0, 50.0, 0)) == [("propose", "other", "entered")]
    assert page.says((0.1, 150.0, 50.0, 0)) == [
        ("retract", "other", None),
        ("propose", "card", "entered"),
    ]


def test_a_pass_through_a_menu_proposes_a_row_at_a_time_and_predicts_none() -> None:
    page = Page(*MENU)
    rows = [(0.01 * i, 90.0, 20.0 * i, 0) for i in range(24)]  # 2000 px/s
    said = page.says(*rows)
    assert [id for action, id, _ in said if action == "propose"] == [one.id for one in MENU]
    assert {reason for action, _, reason in said if action == "propose"} == {"entered"}


def test_what_is_predicted_is_not_said_again_at_entry() -> None:
    pipeline, law = Told([around("goal", 400.0, 0.0, 40.0)]), (90.0, 0.0, 90.0)
    chooser = Chooser(pipeline, precision=0.5)
    found: list[Choice] = []
    for i in range(61):
        u = i / 60
        event = PointerEvent(i / 100, 400.0 * u**3 * (10 - 15 * u + 6 * u * u), 0.0)
        claim = Prediction(event.t, 400.0, 0.0, law, "ballistic", None, None)
        found += taken(chooser, pipeline, claim, event)
    assert [(one.action, one.reason) for one in found] == [("propose", "predicted")]


def test_another_that_is_predicted_stands_beside_the_one_that_is_passed() -> None:
    """Passing over a target on the way takes nothing from the prediction of the one behind it."""
    places = [around("goal", 400.0, 0.0, 40.0), around("on the way", 300.0, 0.0, 30.0)]
    pipeline, law = Told(places), (9.0, 0.0, 9.0)
    chooser = Chooser(pipeline, precision=0.5)
    found: list[Choice] = []
    for i in range(61):
        u = i / 60
        event = PointerEvent(i / 100, 400.0 * u**3 * (10 - 15 * u + 6 * u * u), 0.0)
        claim = Prediction(event.t, 400.0, 0.0, law, "ballistic", None, None)
        found += taken(chooser, pipeline, claim, event)
    assert [(one.action, one.id, one.reason) for one in found] == [
        ("propose", "goal", "predicted"),
        ("propose", "on the way", "entered"),
        ("retract", "on the way", None),
    ]
    assert chooser.finish("goal").hit


places = st.lists(
    st.tuples(st.integers(-4, 4), st.integers(-4, 4), st.integers(1, 5), st.integers(1, 5)),
    min_size=1, max_size=5,
)  # fmt: skip
way = st.lists(
    st.tuples(st.integers(1, 40), st.integers(-6, 6), st.integers(-6, 6), st.sampled_from([0, 0, 0, 1])),
    min_size=1, max_size=40,
)  # fmt: skip


@given(places, way, st.sampled_from([0.05, 0.3, 0.999]))
def test_at_entry_at_the_latest_and_never_twice(
    laid: Sequence[tuple[int, int, int, int]], steps: Sequence[tuple[int, int, int, int]], precision: float
) -> None:
    """Whoever follows the choices knows after every event that the target entered last is proposed."""
    targets = [Target(i, 10.0 * x, 10.0 * y, 10.0 * w, 10.0 * h) for i, (x, y, w, h) in enumerate(laid)]
    pipeline = build("hold", targets=targets)
    chooser, t = Chooser(pipeline, precision=precision), 0.0
    stand: set[object] = set()
    before: set[int] = set()
    for gap, x, y, buttons in steps:
        t += 0.01 * gap
        event = PointerEvent(t, 10.0 * x + 5.0, 10.0 * y + 5.0, buttons=buttons)
        pipeline.update(event)
        for one in chooser.update():
            assert (one.id in stand) == (one.action == "retract")
            assert (one.reason is None) == (one.action == "retract")
            stand ^= {one.id}
        assert len(stand) <= 2
        inside = {
            i for i, one in enumerate(targets)
            if one.x <= event.x <= one.x + one.width and one.y <= event.y <= one.y + one.height
        }  # fmt: skip
        smallest = min(inside, key=lambda i: (targets[i].width * targets[i].height, -i), default=None)
        if smallest is not None and smallest not in before:
            assert smallest in stand
        before = inside


@given(st.integers(0, 2**32 - 1))
def test_one_event_never_ends_and_begins_a_proposal_of_one_target(seed: int) -> None:
    """A reason that changes is no news: the target stays proposed."""
    noise = np.random.default_rng(seed)
    pipeline = Told([around(str(i), 90.0 * i, 0.0, 70.0) for i in range(5)])
    chooser = Chooser(pipeline, precision=0.3)
    x, proposed = 0.0, set()
    for i in range(120):
        x += float(noise.normal(0.0, 12.0)) + (4.0 if i % 60 < 30 else -4.0)
        aim = Prediction(
            i / 50, x + float(noise.normal(0.0, 120.0)), 0.0, (400.0, 0.0, 400.0), "ballistic", 0.2
        )
        changes = taken(chooser, pipeline, aim, PointerEvent(i / 50, x, 0.0))
        assert len({one.id for one in changes}) == len(changes)
        for one in changes:
            assert (one.id in proposed) == (one.action == "retract")
            (proposed.discard if one.action == "retract" else proposed.add)(one.id)
        assert proposed == {one for one in (chooser.standing, chooser.entered) if one is not None}
