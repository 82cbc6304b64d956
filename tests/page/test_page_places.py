"""Places in the page: where they are, how likely, which is proposed, in which window; as in Python."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred import build
from pointpred.errors import ParameterError
from tests.page import node
from tests.page.choosing import assert_alike as assert_close
from tests.page.choosing import compare
from tests.page.test_page_pipeline import answers, assert_equal
from tests.page.test_page_session import SCREEN, both, frames_of
from tests.page.test_page_session import assert_alike as assert_same_session
from tests.unit.talking import hello

pytestmark = node.needed

NAME = "kinematic-adaptive"
CORNERS = ((300.0, 300.0), (900.0, 300.0), (620.0, 700.0))


def rounds(seed: int, count: int, *, start_s: float = 0.0) -> list[list[list[float | None]]]:
    """Movements from corner to corner of a triangle, with some scatter, as rows of events."""
    random, made = np.random.default_rng(seed), []
    for number in range(count):
        begin, end = (np.array(CORNERS[k % 3]) for k in (number, number + 1))
        end = end + random.normal(0.0, 4.0, 2)
        rows: list[list[float | None]] = []
        for i in range(66):
            s = min(i / 55, 1.0)
            x, y = begin + (end - begin) * (10 * s**3 - 15 * s**4 + 6 * s**5)
            rows.append([start_s + 2.0 * number + i / 100, float(x), float(y), None, None, 0])
        made.append(rows)
    return made


def steps_of(movements: list[list[list[float | None]]]) -> list[Any]:
    """Steps for a pipeline: the places at some events, and after each movement."""
    steps: list[Any] = []
    for rows in movements:
        for i, row in enumerate(rows):
            steps.append([np.nan if value is None else value for value in row])
            steps += ["places"] if i % 9 == 0 else []
        steps += ["reset", "places"]
    return steps


def listing(answer: Any) -> bool:
    """Whether this lists places."""
    return isinstance(answer, list | tuple) and all(isinstance(one, dict) for one in answer)


def test_places_are_those_of_python_in_each_window() -> None:
    first, second, third = rounds(1, 9), rounds(2, 4, start_s=100.0), rounds(3, 2, start_s=200.0)
    steps = [
        "places",
        *steps_of(first),
        {"enter": ["Müller & Söhne", 120.0, -40.5]},
        "places",
        *steps_of(second),
        {"enter": ["", 0.0, 0.0]},
        "places",
        *steps_of(third),
        {"enter": ["Müller & Söhne", 0.0, 0.0]},
        "places",
        "forget",
        "places",
        *steps_of(third),
        {"enter": ["", 0.0, 0.0]},
        "places",
        "person",
    ]
    found = node.run("predict.mjs", {"name": NAME, "options": {}, "steps": steps})
    expected = answers(build(NAME), steps)
    listed = [one for one, step in zip(expected, steps, strict=True) if step == "places"]
    assert max(map(len, listed)) == 3
    assert max(place["p"] for one in listed for place in one) > 0.8
    for step, one, other in zip(steps, found, expected, strict=True):
        if step == "places":
            order = [sorted(side, key=lambda place: place["id"]) for side in (one, other)]
            assert_close(*order)
    assert_equal(*([one for one in side[:-1] if not listing(one)] for side in (found, expected)))
    taught = [build(NAME, person=side[-1]).predictor.known for side in (found, expected)]
    assert np.allclose(*taught, rtol=1e-9, atol=1e-9)


def test_a_window_has_the_same_number_in_the_page() -> None:
    """A person who was taught in the page is at home in the windows of Python."""
    steps = [{"enter": ["Müller & Söhne", 120.0, -40.5]}, *steps_of(rounds(7, 4)), "person"]
    found = node.run("predict.mjs", {"name": NAME, "options": {}, "steps": steps})
    again = build(NAME, person=found[-1])
    assert again.places == ()
    again.enter("Müller & Söhne", 120.0, -40.5)
    assert [place._asdict() for place in again.places] == [pytest.approx(place) for place in found[-2]]


@pytest.mark.parametrize("window", [[3], ["", "1"], ["key", 0.0, 1e10], ["key", True]])
def test_a_wrong_window_is_refused_as_in_python(window: list[Any]) -> None:
    with pytest.raises(ParameterError) as refused:
        build(NAME).enter(*window)
    found = node.run("predict.mjs", {"name": NAME, "options": {}, "steps": [{"enter": window}]})
    assert (found["error"], found["field"]) == ("ParameterError", refused.value.field)


def test_the_chooser_proposes_the_places_of_python() -> None:
    steps = list[list[Any]]()
    for number, rows in enumerate(rounds(4, 12)):
        steps += [["update", [np.nan if value is None else value for value in row]] for row in rows]
        steps += [["proposed"], ["finish"], ["reset"]]
        steps += [["configure", {"precision": 0.3}]] if number == 6 else []
    steps += [["summary"], ["configure", {"precision": 2.0}]]
    expected = compare(NAME, steps, {"precision": 0.6})
    reasons = {
        one["reason"] for made in expected if isinstance(made, list) for one in made if isinstance(one, dict)
    }
    assert reasons == {"predicted", "entered", None}


def test_targets_weigh_alike_however_events_are_framed() -> None:
    """Frames span movements that start elsewhere than where the last one ended."""
    learned, later = rounds(8, 8), [row for rows in rounds(9, 7, start_s=100.0)[::2] for row in rows]
    listed = [
        {"id": str(i), "x": x - 10.0, "y": y - 10.0 + 20.0 * (i % 2), "width": 20.0, "height": 20.0}
        for i, (x, y) in enumerate([*CORNERS, *CORNERS])
    ]
    heard: list[list[Any]] = []
    for size in (1, 7, 64):
        frames = [
            hello(NAME, places=True, reply="event", screen=SCREEN),
            *(one for rows in learned for one in [*frames_of(rows, 20), {"type": "reset"}]),
            {"type": "targets", "targets": listed},
            *frames_of(later, size),
        ]
        found, expected = both(frames)
        assert_same_session(found, expected)
        said = [one for answers in found for one in answers]
        heard.append([[one for one in said if one["type"] == kind] for kind in ("choice", "prediction")])
    assert heard[0] == heard[1] == heard[2]
    assert len(heard[0][0]) > 4


@pytest.mark.parametrize(("size", "reply"), [(1, "frame"), (7, "event")])
def test_a_session_with_places_is_answered_alike(size: int, reply: str) -> None:
    learned, later = rounds(5, 8), rounds(6, 6, start_s=100.0)
    target = {"id": "near", "x": 600.0, "y": 680.0, "width": 40.0, "height": 40.0}
    other = {"id": "other", "x": 100.0, "y": 900.0, "width": 300.0, "height": 300.0}

    def moved(rows: list[Any]) -> list[Any]:
        return [*frames_of(rows, size), {"type": "reset"}]

    frames = [
        hello(NAME, places=True, reply=reply, screen=SCREEN),
        *(frame for rows in learned for frame in moved(rows)),
        *frames_of(later[0][:30], size),
        {"type": "targets", "targets": [target, other]},
        *frames_of(later[0][30:], size),
        {"type": "targets", "targets": []},
        *moved(later[1]),
        {"type": "configure", "precision": 0.9},
        *moved(later[2]),
        {"type": "configure", "parameters": {"sequence": 0}},
        *frames_of(later[3][:30], size),
        {"type": "configure", "places": False},
        *frames_of(later[3][30:], size),
        {"type": "configure", "places": True},
        {"type": "enter", "key": "editor", "x": 100.0},
        *moved(later[4]),
        {"type": "enter", "key": ""},
        *frames_of(later[5][:30], size),
        {"type": "forget"},
        *frames_of(later[5][30:], size),
        {"type": "enter", "key": 7},
        {"type": "enter", "key": "k", "x": 1e10},
        {"type": "forget", "all": True},
        {"type": "configure", "places": 1},
    ]
    found, expected = both(frames)
    heard = [one for said in expected for one in said]
    assert {one["reason"] for one in heard if one["type"] == "choice"} == {"predicted", "entered", None}
    assert sum(one["type"] == "choice" and "place" in one for one in heard) > 8
    assert [one["person"] for one in heard if one["type"] == "person"] == [""]
    assert_same_session(found, expected)


def test_an_assisted_session_with_places_is_answered_alike() -> None:
    frames: list[Any] = [
        hello(NAME, places=True, assist={"strength": 0.3}, device={"cpi": 1000.0}, screen=SCREEN)
    ]
    for number in range(9):
        counts = [(4 if number % 2 == 0 else -4) if 0 < i < 40 else 0 for i in range(60)]
        rows = [[2.0 * number + i / 100, 300.0, 300.0, dx, 1, 0] for i, dx in enumerate(counts)]
        frames += [*frames_of(rows, 3), {"type": "reset"}]
    found, expected = both(frames)
    assert any(one["type"] == "choice" for said in expected for one in said)
    assert_same_session(found, expected)
