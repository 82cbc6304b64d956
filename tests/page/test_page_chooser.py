"""The chooser of the page: the proposals, shares and accounts of the one in Python."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred import build
from pointpred.errors import ParameterError
from pointpred.targets import Target
from tests.page import node
from tests.page.choosing import compare
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


def scene(*, buttons: bool = True) -> tuple[list[dict[str, Any]], list[list[Any]], list[int]]:
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
            "kind": "button" if k % 3 else "",
        }
        for k, i in enumerate(pressed.tolist())
    ]
    if not buttons:
        table[:, 5] = 0.0
    return [*targets(2), *ends], [["update", event] for event in table.tolist()], pressed.tolist()


def test_the_region_of_many_parts_has_every_outline() -> None:
    parts = [[0.005, 95.0 * (i % 20), 90.0 * (i // 20), 30.0, 0.0, 20.0, 0.0] for i in range(200)]
    expected = compare("kinematic", [["outlines", parts, 0.8]], {})
    assert len(expected[0]) == 200
    assert sum(map(len, expected[0])) > 4000, "more than once had room"


@pytest.mark.parametrize("predictor", ["kinematic", "switched", "ktm"])
@pytest.mark.parametrize("settings", [{}, {"precision": 0.2, "least_lead_s": 0.1}])
def test_it_proposes_what_python_proposes(predictor: str, settings: dict[str, float]) -> None:
    listed, updates, pressed = scene()
    steps = []
    for i, update in enumerate(updates):
        steps.append(update)
        if i % 20 == 0:
            steps += [["shares"], ["likeliest", 7], ["proposed"], ["mixture"]]
        if i == 150:
            steps += [["register", listed[10:]], ["shares"]]
        if i == 300:
            steps += [
                ["configure", {"precision": 0.3}],
                ["register", targets(1, weight=3.0)],
                ["register", listed],
            ]
        at_release = i - 1 in pressed and pressed.index(i - 1) % 2 == 1
        if at_release or (i in pressed and pressed.index(i) % 2 == 0):
            steps.append(["finish", f"end {pressed.index(i - at_release)}"])
    *_, summary = compare(predictor, [*steps, ["finish", None], ["summary"]], settings, listed)
    assert summary["hit"] > 2


@pytest.mark.parametrize("more", [["finish", "end 0"], ["reset"], ["register", None]])
@pytest.mark.parametrize("buttons", [True, False])
def test_calls_between_events_change_what_python_changes(more: list[Any], buttons: bool) -> None:
    listed, updates, pressed = scene(buttons=buttons)
    call = [listed if one is None else one for one in more]
    often = range(len(updates)) if more[0] == "register" else {*pressed, *range(0, len(updates), 37)}
    steps = [
        step for i, update in enumerate(updates) for step in ([update, call] if i in often else [update])
    ]
    steps += [["summary"], ["proposed"], ["shares"], ["mixture"]]
    compare("kinematic", steps, {"precision": 0.3}, listed)


def test_what_it_refuses_changes_nothing() -> None:
    event = [1.0, 10.0, 10.0, np.nan, np.nan, 0.0]
    one = targets(4)[0]
    steps: list[list[Any]] = [
        ["update", event],
        *(["register", [{**one, **wrong}]] for wrong in ({"width": 0.0}, {"x": 2e9}, {"weight": -1.0})),
        ["register", [one, one]],
        ["register", [{**one, "id": str(i)} for i in range(1001)]],
        ["configure", {"precision": 2.0}],
        ["configure", {"precision": 0.3, "least_way_px": -1.0}],
        ["update", [0.5, *event[1:]]],
        ["shares"],
        ["proposed"],
    ]
    expected = compare("minimum-jerk", steps, {}, targets(3))
    assert sum(isinstance(one, dict) and "error" in one for one in expected) == 7


def test_places_of_the_person_are_parts_of_what_is_elsewhere() -> None:
    listed, updates, _ = scene()
    again = [["update", [event[0] + 100.0, *event[1:]]] for _, event in updates]
    steps = [*updates, ["reset"], *(one for step in again for one in (step, ["mixture"]))]
    expected = compare("kinematic-adaptive", steps, {}, listed)
    assert max(len(one["parts"]) for one in expected if isinstance(one, dict) and "parts" in one) > 4


def test_a_person_who_took_targets_in_the_page_is_known_in_python() -> None:
    listed, updates, _ = scene()
    steps = [*updates, ["reset"], ["person"]]
    given = {"name": "kinematic-adaptive", "targets": listed, "settings": {}, "steps": steps}
    *_, found = node.run("choose.mjs", given)
    taught = build("kinematic-adaptive", targets=[Target(**one) for one in listed])
    for _, event in updates:
        taught.advance(tuple(event))
    taught.reset()
    again = build("kinematic-adaptive", person=found)
    assert np.count_nonzero(again.aim.known) > 20
    assert np.allclose(again.aim.known, taught.aim.known, rtol=1e-9, atol=1e-9)
    told = node.run("predict.mjs", {"name": again.name, "options": {"person": found}, "steps": ["person"]})
    assert told == [again.person] == [found]


@pytest.mark.parametrize("wrong", ["+1.x", "1.x+", "+", "a+b+c"])
def test_a_person_with_wrong_targets_is_refused_as_in_python(wrong: str) -> None:
    found = node.run("predict.mjs", {"name": "kinematic", "options": {"person": wrong}, "steps": ["person"]})
    with pytest.raises(ParameterError) as refused:
        build("kinematic", person=wrong)
    assert (found["error"], found["field"]) == ("ParameterError", refused.value.field)


def test_targets_that_cannot_be_used_are_refused_and_the_old_ones_kept() -> None:
    """As ``test_targets_given`` has it for Python; the page also refuses NaN for an id."""
    found = node.run("register.mjs", {})
    assert len(found["told"]) == 50
    for name, errors in found["told"].items():
        for error in errors:
            assert error is not None, name
            assert (error["error"], error["code"]) == ("ParameterError", "bad_parameter"), name
            assert "target" in error["message"], name
    assert found["left"] == ["before", None]
