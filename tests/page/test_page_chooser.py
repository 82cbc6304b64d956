"""The chooser of the page: the proposals, shares and accounts of the one in Python."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pytest

from pointpred import build
from pointpred.errors import PointpredError
from pointpred.rows import event_of, prediction_of
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


@pytest.mark.parametrize("predictor", ["kinematic", "switched", "ktm"])
@pytest.mark.parametrize("settings", [{}, {"precision": 0.2, "least_lead_s": 0.1, "elsewhere": 0.1}])
def test_it_proposes_what_python_proposes(predictor: str, settings: dict[str, float]) -> None:
    pipeline, steps = build(predictor), []
    rows = movements(31, count=8).tolist()
    for i, event in enumerate(rows):
        answer = pipeline.advance(tuple(event))
        steps.append(["update", None if answer is None or answer[1] != answer[1] else answer, event])
        if i % 20 == 0:
            steps += [["shares"], ["likeliest", 7], ["proposed"]]
        if i % 50 == 25:
            steps += [["headingTo", targets(2)[7], 0.4]]
        if i > 0 and event[5] > rows[i - 1][5]:
            steps.append(["finish", "2,2" if i % 2 else None])
        if i == 150:
            steps += [["replace", targets(2)], ["shares"]]
        if i == 300:
            steps += [["configure", {"precision": 0.3}], ["replace", targets(1, weight=3.0)]]
        if i == 450:
            steps += [["reset"], ["proposed"]]
    steps += [["finish", "0,0"], ["summary"]]
    listed = targets(1)
    found, expected = (
        node.run("choose.mjs", {"targets": listed, "settings": settings, "steps": steps}),
        in_python(listed, settings, steps),
    )
    assert sum(len(one) for one, step in zip(expected, steps, strict=True) if step[0] == "update") > 10
    assert_alike(found, expected)


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
