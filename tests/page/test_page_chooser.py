"""The chooser of the page: the proposals, shares and accounts of the one in Python."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pytest

from pointpred import Place, build
from pointpred.errors import PointpredError
from pointpred.records import event_of, prediction_of
from pointpred.targets import Chooser, Target
from tests.page import node
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


def in_python(listed: list[dict[str, Any]], settings: dict[str, float], steps: list[list[Any]]) -> list[Any]:
    """What ``choose.mjs`` does, in Python."""
    chooser = Chooser([Target(**one) for one in listed], **settings)

    def update(row: Any, event: list[float]) -> list[dict[str, Any]]:
        prediction = None if row is None else prediction_of(row)
        return [one._asdict() for one in chooser.update(prediction, event_of(event))]

    calls: dict[str, Any] = {
        "update": update,
        "replace": lambda given: [one._asdict() for one in chooser.replace([Target(**one) for one in given])],
        "expect": lambda places: chooser.expect([Place(**one) for one in places]),
        "configure": lambda more: chooser.configure(**more),
        "finish": lambda id: msgspec.to_builtins(chooser.finish(id)),
        "reset": chooser.reset,
        "shares": lambda: chooser.shares.tolist(),
        "likeliest": lambda most: [{"id": id, "p": p} for id, p in chooser.likeliest(most)],
        "headingTo": lambda one, elsewhere: chooser.heading_to(Target(**one), elsewhere=elsewhere),
        "proposed": lambda: [chooser.standing, chooser.entered],
        "summary": lambda: chooser.ledger.summary(),
    }
    answers = []
    for name, *given in steps:
        try:
            answers.append(calls[name](*given))
        except PointpredError as error:
            answers.append({"error": error.code, "field": error.field})
    return answers


def assert_alike(found: Any, expected: Any) -> None:
    if isinstance(expected, dict) and "error" in expected:
        assert {"error": found["code"], "field": found["field"]} == expected
    elif isinstance(expected, dict):
        assert found.keys() == expected.keys()
        for name in expected:
            assert_alike(found[name], expected[name])
    elif isinstance(expected, list):
        assert len(found) == len(expected)
        for one, other in zip(found, expected, strict=True):
            assert_alike(one, other)
    elif isinstance(expected, float) and not isinstance(found, bool):
        assert found == pytest.approx(expected, rel=1e-7, abs=1e-9)
    else:
        assert found == expected


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
        updates.append(["update", None if answer is None or answer[1] != answer[1] else answer, event])
    return [*targets(2), *ends], updates, pressed.tolist()


def compare(listed: list[dict[str, Any]], settings: dict[str, float], steps: list[list[Any]]) -> list[Any]:
    """Compare both on these steps; the answers."""
    found = node.run("choose.mjs", {"targets": listed, "settings": settings, "steps": steps})
    expected = in_python(listed, settings, steps)
    assert_alike(found, expected)
    return expected


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
    *_, summary = compare(listed, settings, [*steps, ["finish", None], ["summary"]])
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
    compare(listed, {"precision": 0.3}, [*steps, ["summary"], ["proposed"], ["shares"]])


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
    found = node.run("choose.mjs", {"targets": targets(3), "settings": {}, "steps": steps})
    expected = in_python(targets(3), {}, steps)
    assert sum(isinstance(one, dict) and "error" in one for one in expected) == 12
    for one in (*found, *expected):
        if isinstance(one, dict) and one.get("field") == "t":
            one["field"] = ""  # Python's chooser names no field of an event
    assert_alike(found, expected)


def test_settings_have_the_bounds_and_defaults_of_python() -> None:
    for bound in Chooser.parameters:
        for value, wrong in ((bound.low, False), (bound.high, False), (bound.high * 1.01 + 1e-9, True)):
            given = {"targets": [], "settings": {}, "steps": [["configure", {bound.name: value}]]}
            assert isinstance(node.run("choose.mjs", given)[0], dict) == wrong


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
    found = node.run("choose.mjs", {"targets": listed, "settings": {}, "steps": steps})
    expected = in_python(listed, {}, steps)
    plain = in_python(listed, {}, steps[1:])
    assert expected[41] != pytest.approx(plain[40])
    assert_alike(found, expected)
