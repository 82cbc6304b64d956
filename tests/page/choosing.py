"""Choosers of the page and of Python, called alike: steps are calls by name, with what they take."""

from __future__ import annotations

import json
from typing import Any

import msgspec
import pytest

from pointpred import build
from pointpred.errors import PointpredError
from pointpred.predictors.mixture import Mixture, Part
from pointpred.targets import Choice, Chooser, PlaceChooser, Target
from tests.page import node

Steps = list[list[Any]]
COUNTS = ("movements", "proposed", "right", "hit", "wasted", "retracted", "entered")
Listed = list[dict[str, Any]] | None
"""Targets; ``None`` for a chooser of places."""


def compare(name: str, steps: Steps, settings: dict[str, float], targets: Listed = None) -> list[Any]:
    """Compare both on these steps of a predictor, with targets or with places; Python's answers."""
    given = {"name": name, "targets": targets, "settings": settings, "steps": steps}
    found = node.run("choose.mjs", given)
    expected = in_python(name, steps, settings, targets)
    assert_alike(found, expected)
    return expected


def in_python(name: str, steps: Steps, settings: dict[str, float], targets: Listed = None) -> list[Any]:
    """What ``choose.mjs`` does, in Python."""
    pipeline = build(name, targets=[Target(**one) for one in targets or []])
    chooser: Any = (PlaceChooser if targets is None else Chooser)(pipeline, **settings)

    def update(event: list[float]) -> list[dict[str, Any]] | None:
        answer = pipeline.advance(tuple(event))
        return [shown(one) for one in chooser.update()] if answer[0] == answer[0] else None

    def register(listed: list[dict[str, Any]]) -> list[dict[str, Any]]:
        pipeline.register([Target(**one) for one in listed])
        return [shown(one) for one in chooser.follow_targets()]

    def reset() -> None:
        pipeline.reset()
        chooser.reset()

    calls: dict[str, Any] = {
        "update": update,
        "register": register,
        "finish": lambda *id: msgspec.to_builtins(chooser.finish(*id)),
        "configure": lambda more: chooser.configure(**more),
        "reset": reset,
        "shares": lambda: [list(one) for one in pipeline.shares.items()],
        "likeliest": lambda most: [{"id": id, "p": p} for id, p in pipeline.aim.likeliest(most)],
        "mixture": lambda: json.loads(msgspec.json.encode(pipeline.mixture)),
        "outlines": outlines,
        "proposed": lambda: [chooser.standing, chooser.entered],
        "summary": lambda: {name: chooser.ledger.summary()[name] for name in COUNTS},
    }
    answers = []
    for call, *given in steps:
        try:
            answers.append(calls[call](*given))
        except PointpredError as error:
            answers.append({"error": error.code, "field": error.field})
    return answers


def outlines(rows: list[list[float]], level: float) -> list[Any]:
    """The outlines of the region of a mixture of these parts."""
    parts = [Part(share, x, y, (sxx, sxy, syy), tail or None) for share, x, y, sxx, sxy, syy, tail in rows]
    return [one.tolist() for one in Mixture(tuple(parts)).region(level).outlines]


def shown(choice: Choice) -> dict[str, Any]:
    """A choice as the page has it."""
    fields: dict[str, Any] = choice._asdict()
    square = fields.pop("place")
    if square is not None:
        size = square.width
        fields["place"] = {"x": square.x + size / 2.0, "y": square.y + size / 2.0, "size": size}
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
