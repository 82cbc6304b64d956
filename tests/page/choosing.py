"""Choosers of the page and of Python, called alike: steps are calls by name, with what they take."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest

from pointpred import Place
from pointpred.errors import PointpredError
from pointpred.records import event_of, prediction_of
from pointpred.targets import Choice, Chooser, PlaceChoice, PlaceChooser, Target
from tests.page import node

Steps = list[list[Any]]
Listed = list[dict[str, Any]] | None
"""Targets; ``None`` for a chooser of places."""


def compare(steps: Steps, settings: dict[str, float], targets: Listed = None) -> list[Any]:
    """Compare both on these steps, with targets or with places; Python's answers."""
    found = in_page(steps, settings, targets)
    expected = in_python(steps, settings, targets)
    assert_alike(found, expected)
    return expected


def in_page(steps: Steps, settings: dict[str, float], targets: Listed = None) -> list[Any]:
    """What the chooser of the page answers."""
    answers: list[Any] = node.run("choose.mjs", {"targets": targets, "settings": settings, "steps": steps})
    return answers


def in_python(steps: Steps, settings: dict[str, float], targets: Listed = None) -> list[Any]:
    """What ``choose.mjs`` does, in Python."""
    chooser: Any
    if targets is None:
        chooser = PlaceChooser(**settings)
    else:
        chooser = Chooser([Target(**one) for one in targets], **settings)

    def update(*given: Any) -> list[dict[str, Any]]:
        *places, row, event = given
        known = [[Place(**one) for one in listed] for listed in places]
        prediction = None if row is None else prediction_of(row)
        return [shown(one) for one in chooser.update(*known, prediction, event_of(event))]

    calls: dict[str, Any] = {
        "update": update,
        "replace": lambda given: [shown(one) for one in chooser.replace([Target(**one) for one in given])],
        "expect": lambda places: chooser.expect([Place(**one) for one in places]),
        "configure": lambda more: chooser.configure(**more),
        "finish": lambda *id: msgspec.to_builtins(chooser.finish(*id)),
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


def shown(choice: Choice | PlaceChoice) -> dict[str, Any]:
    """A choice as the page has it."""
    fields: dict[str, Any] = choice._asdict()
    if isinstance(choice, PlaceChoice):
        size = choice.place.width
        fields["place"] = {"x": choice.place.x + size / 2.0, "y": choice.place.y + size / 2.0, "size": size}
    return fields


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
