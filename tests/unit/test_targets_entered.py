"""A target has its choice when the cursor enters it at the latest, and loses it when the cursor leaves."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred import EventColumns, PointerEvent, Prediction, build
from pointpred.pipeline import run
from pointpred.targets import Choice, Chooser, Target, around

Row = tuple[float, float, float, int]
"""t s, x and y px, buttons."""
CARD = Target("card", 100.0, 0.0, 200.0, 142.0)
BUTTON = Target("button", 120.0, 80.0, 60.0, 24.0)
MENU = [Target(f"row {i}", 0.0, 24.0 * i, 180.0, 24.0) for i in range(20)]


def told(chooser: Chooser, rows: Iterable[Row]) -> list[tuple[str, str, str | None]]:
    """Without predictions and with a precision that nothing reaches, only entries are proposed."""
    found: list[Choice] = []
    for t, x, y, buttons in rows:
        found += chooser.update(None, PointerEvent(t, x, y, buttons=buttons))
    return [(one.action, str(one.id), one.reason) for one in found]


def still(*targets: Target) -> Chooser:
    return Chooser(targets, precision=0.999, least_lead_s=10.0)


def test_entered_and_left() -> None:
    chooser = still(CARD)
    assert told(chooser, [(0.0, 0.0, 50.0, 0), (0.1, 99.9, 50.0, 0)]) == []
    assert told(chooser, [(0.2, 100.0, 50.0, 0)]) == [("propose", "card", "entered")]
    assert told(chooser, [(0.3, 250.0, 50.0, 0), (9.0, 260.0, 50.0, 0)]) == []
    assert (chooser.entered, chooser.standing) == ("card", None)
    assert told(chooser, [(9.1, 301.0, 50.0, 0)]) == [("retract", "card", None)]
    assert told(chooser, [(9.2, 299.0, 50.0, 0)]) == [("propose", "card", "entered")]


@pytest.mark.parametrize("order", [(CARD, BUTTON), (BUTTON, CARD)])
def test_of_overlapping_targets_the_smallest_is_entered(order: tuple[Target, Target]) -> None:
    chooser = still(*order)
    said = told(chooser, [(0.0, 150.0, 20.0, 0), (0.1, 150.0, 90.0, 0), (0.2, 150.0, 120.0, 0)])
    assert said == [
        ("propose", "card", "entered"),
        ("retract", "card", None),
        ("propose", "button", "entered"),
        ("retract", "button", None),
        ("propose", "card", "entered"),
    ]


def test_of_equally_large_ones_the_last_is_entered() -> None:
    chooser = still(Target("a", 0.0, 0.0, 40.0, 40.0), Target("b", 20.0, 0.0, 40.0, 40.0))
    assert told(chooser, [(0.0, 30.0, 10.0, 0)]) == [("propose", "b", "entered")]


def test_a_target_of_weight_0_is_not_entered() -> None:
    assert told(still(Target("a", 0.0, 0.0, 9.0, 9.0, 0.0)), [(0.0, 3.0, 3.0, 0)]) == []


def test_a_release_ends_it_until_the_cursor_has_left() -> None:
    chooser = still(CARD)
    rows = [(0.0, 150.0, 50.0, 0), (0.1, 150.0, 50.0, 1), (0.2, 150.0, 50.0, 0)]
    assert told(chooser, rows) == [("propose", "card", "entered"), ("retract", "card", None)]
    assert told(chooser, [(0.3, 160.0, 50.0, 0), (0.4, 170.0, 50.0, 1), (0.5, 170.0, 50.0, 0)]) == []
    chooser.replace([BUTTON, CARD])  # a page that has moved its elements says them again
    assert told(chooser, [(0.55, 170.0, 50.0, 0)]) == []
    assert told(chooser, [(0.6, 0.0, 0.0, 0), (0.7, 150.0, 50.0, 0)]) == [("propose", "card", "entered")]


def test_what_goes_away_is_retracted_and_what_stays_is_not_entered_again() -> None:
    chooser = still(CARD, BUTTON)
    told(chooser, [(0.0, 150.0, 50.0, 0)])
    assert chooser.replace([BUTTON, CARD]) == ()
    assert told(chooser, [(0.1, 151.0, 50.0, 0)]) == []
    assert [(one.id, one.action) for one in chooser.replace([BUTTON])] == [("card", "retract")]
    assert chooser.replace([BUTTON, CARD]) == ()
    assert told(chooser, [(0.2, 152.0, 50.0, 0)]) == [("propose", "card", "entered")]


@pytest.mark.parametrize("buttons", [(0,), (0, 1), (0, 1, 0)], ids=["inside", "pressed", "released"])
def test_a_reset_ends_it_until_the_cursor_has_left(buttons: tuple[int, ...]) -> None:
    chooser = still(CARD)
    told(chooser, [(0.1 * i, 150.0, 50.0, down) for i, down in enumerate(buttons)])
    chooser.reset()
    assert chooser.entered is None
    assert told(chooser, [(0.0, 150.0, 50.0, 0), (0.1, 160.0, 50.0, 0)]) == []
    assert told(chooser, [(0.2, 0.0, 0.0, 0), (0.3, 150.0, 50.0, 0)]) == [("propose", "card", "entered")]


def test_a_reset_far_from_a_target_takes_nothing_from_its_next_entry() -> None:
    chooser = still(CARD, Target("other", 400.0, 0.0, 200.0, 142.0))
    told(chooser, [(0.0, 150.0, 50.0, 0)])
    chooser.reset()
    assert told(chooser, [(0.0, 450.0, 50.0, 0)]) == [("propose", "other", "entered")]
    assert told(chooser, [(0.1, 150.0, 50.0, 0)]) == [
        ("retract", "other", None),
        ("propose", "card", "entered"),
    ]


def test_a_pass_through_a_menu_proposes_a_row_at_a_time_and_predicts_none() -> None:
    chooser = still(*MENU)
    rows = [(0.01 * i, 90.0, 20.0 * i, 0) for i in range(24)]  # 2000 px/s
    said = told(chooser, rows)
    assert [id for action, id, _ in said if action == "propose"] == [one.id for one in MENU]
    assert {reason for action, _, reason in said if action == "propose"} == {"entered"}


def test_what_is_predicted_is_not_said_again_at_entry() -> None:
    chooser, law = Chooser([around("goal", 400.0, 0.0, 40.0)], precision=0.5), (90.0, 0.0, 90.0)
    found: list[Choice] = []
    for i in range(61):
        u = i / 60
        event = PointerEvent(i / 100, 400.0 * u**3 * (10 - 15 * u + 6 * u * u), 0.0)
        found += chooser.update(Prediction(event.t, 400.0, 0.0, law, "ballistic", None, None), event)
    assert [(one.action, one.reason) for one in found] == [("propose", "predicted")]


def test_another_that_is_predicted_stands_beside_the_one_that_is_passed() -> None:
    """Passing over a target on the way takes nothing from the prediction of the one behind it."""
    places = [around("goal", 400.0, 0.0, 40.0), around("on the way", 300.0, 0.0, 30.0)]
    chooser, law = Chooser(places, precision=0.5), (9.0, 0.0, 9.0)
    found: list[Choice] = []
    for i in range(61):
        u = i / 60
        event = PointerEvent(i / 100, 400.0 * u**3 * (10 - 15 * u + 6 * u * u), 0.0)
        found += chooser.update(Prediction(event.t, 400.0, 0.0, law, "ballistic", None, None), event)
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
    chooser, pipeline = Chooser(targets, precision=precision), build("hold")
    rows, t = [], 0.0
    for gap, x, y, buttons in steps:
        t += 0.01 * gap
        rows.append((t, 10.0 * x + 5.0, 10.0 * y + 5.0, buttons))
    times, x, y, buttons_held = np.array(rows).T
    events = EventColumns.of(times, x, y, buttons=buttons_held)
    stand: set[object] = set()
    before: set[int] = set()
    for event, prediction in zip(events.events(), run(pipeline, events).predictions(), strict=True):
        for one in chooser.update(prediction, event):
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
    chooser = Chooser([around(str(i), 90.0 * i, 0.0, 70.0) for i in range(5)], precision=0.3)
    x, proposed = 0.0, set()
    for i in range(120):
        x += float(noise.normal(0.0, 12.0)) + (4.0 if i % 60 < 30 else -4.0)
        aim = Prediction(
            i / 50, x + float(noise.normal(0.0, 120.0)), 0.0, (400.0, 0.0, 400.0), "ballistic", 0.2
        )
        changes = chooser.update(aim, PointerEvent(i / 50, x, 0.0))
        assert len({one.id for one in changes}) == len(changes)
        for one in changes:
            assert (one.id in proposed) == (one.action == "retract")
            (proposed.discard if one.action == "retract" else proposed.add)(one.id)
        assert proposed == {one for one in (chooser.standing, chooser.entered) if one is not None}
