"""The chooser of the page: the proposals, shares and accounts of the one in Python."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred import build
from tests.page import node
from tests.page.choosing import assert_alike, compare, in_page, in_python
from tests.page.movements import movements

pytestmark = node.needed


def targets(step: int, weight: float = 0.0) -> list[dict[str, Any]]:
    """Squares that overlap somewhat, the first of another weight, so that some are in others."""
    return [
        {"id": f"{i},{j}", "x": 150.0 * i, "y": 150.0 * j, "width": 90.0, "height": 60.0 + 20.0 * (i % 3)}
        | ({"weight": weight} if i == j else {})
        for i in range(-3, 9, step)
        for j in range(-3, 9, step)
    ]


def scene(predictor: str, *, buttons: bool = True) -> tuple[list[dict[str, Any]], list[list[Any]], list[int]]:
    """Targets where movements end or close by, an update for each event, and the places of the presses."""
    table = movements(31, count=8)
    pressed = np.flatnonzero(np.diff(table[:, 5]) > 0.0) + 1
    ends = [
        {
            "id": f"end {k}",
            "x": table[i, 1] + (8.0 if k % 2 else -25.0),
            "y": table[i, 2] - 25.0,
            "width": 50.0,
            "height": 50.0,
        }
        for k, i in enumerate(pressed.tolist())
    ]
    if not buttons:
        table[:, 5] = 0.0
    pipeline, updates = build(predictor), []
    for event in table.tolist():
        answer = pipeline.advance(tuple(event))
        updates.append(["update", answer if answer[1] == answer[1] else None, event])
    return [*targets(2), *ends], updates, pressed.tolist()


@pytest.mark.parametrize("predictor", ["kinematic", "switched", "ktm"])
@pytest.mark.parametrize("settings", [{}, {"precision": 0.2, "least_lead_s": 0.1, "elsewhere": 0.1}])
def test_it_proposes_what_python_proposes(predictor: str, settings: dict[str, float]) -> None:
    listed, updates, pressed = scene(predictor)
    steps = []
    for i, update in enumerate(updates):
        steps.append(update)
        if i % 20 == 0:
            steps += [["shares"], ["likeliest", 7], ["proposed"], ["headingTo", listed[7], 0.4]]
        if i == 150:
            steps += [["replace", listed[10:]], ["shares"]]
        if i == 300:
            steps += [
                ["configure", {"precision": 0.3}],
                ["replace", targets(1, weight=3.0)],
                ["replace", listed],
            ]
        at_release = i - 1 in pressed and pressed.index(i - 1) % 2 == 1
        if at_release or (i in pressed and pressed.index(i) % 2 == 0):
            steps.append(["finish", f"end {pressed.index(i - at_release)}"])
    *_, summary = compare([*steps, ["finish", None], ["summary"]], settings, listed)
    assert summary["hit"] > 2


@pytest.mark.parametrize("more", [["finish", "end 0"], ["reset"], ["replace", None]])
@pytest.mark.parametrize("buttons", [True, False])
def test_calls_between_events_change_what_python_changes(more: list[Any], buttons: bool) -> None:
    listed, updates, pressed = scene("kinematic", buttons=buttons)
    call = [listed if one is None else one for one in more]
    often = range(len(updates)) if more[0] == "replace" else {*pressed, *range(0, len(updates), 37)}
    steps = [
        step for i, update in enumerate(updates) for step in ([update, call] if i in often else [update])
    ]
    compare([*steps, ["summary"], ["proposed"], ["shares"]], {"precision": 0.3}, listed)


def test_what_it_refuses_changes_nothing() -> None:
    event = [1.0, 10.0, 10.0, np.nan, np.nan, 0.0]
    one = targets(4)[0]
    steps = [
        ["update", None, event],
        *(["replace", [{**one, **wrong}]] for wrong in ({"width": 0.0}, {"x": 2e9}, {"weight": -1.0})),
        ["replace", [one, one]],
        ["replace", [{**one, "id": str(i)} for i in range(1001)]],
        ["configure", {"precision": 2.0}],
        ["configure", {"elsewhere": "much"}],
        ["configure", {"precision": 0.3, "least_way_px": -1.0}],
        ["update", None, [0.5, *event[1:]]],
        ["update", None, [2.0, 2e9, *event[2:]]],
        ["headingTo", {**one, "height": 0.0}, 0.5],
        ["headingTo", one, 1.5],
        ["shares"],
        ["proposed"],
    ]
    found, expected = in_page(steps, {}, targets(3)), in_python(steps, {}, targets(3))
    assert sum(isinstance(one, dict) and "error" in one for one in expected) == 12
    for one in (*found, *expected):
        if isinstance(one, dict) and one.get("field") == "t":
            one["field"] = ""  # Python's chooser names no field of an event
    assert_alike(found, expected)


def test_targets_that_the_person_went_to_weigh_more() -> None:
    listed, updates, _ = scene("switched")
    middle = listed[-2]["x"] + 20.0, listed[-2]["y"] + 20.0
    places = [
        {"x": x, "y": y, "p": 0.1, "before": before, "visits": 3.0, "id": id, "spread": 15.0}
        for id, (x, y, before) in enumerate([(*middle, 0.3), (-900.0, -900.0, 0.2), (140.0, 20.0, 0.25)])
    ]
    steps = [
        ["expect", places],
        *updates[:40],
        ["shares"],
        ["replace", listed[::2]],
        *updates[40:60],
        ["shares"],
        ["expect", []],
        *updates[60:80],
        ["shares"],
    ]
    expected, plain = compare(steps, {}, listed), in_python(steps[1:], {}, listed)
    assert expected[41] != pytest.approx(plain[40])
