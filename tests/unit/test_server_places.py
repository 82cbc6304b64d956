"""Places in a session: proposed where nobody registered targets, kept for each window, and forgotten."""

from __future__ import annotations

from typing import Any

import pytest

from tests.unit.talking import Talk, events, hello, packed

NAME = "kinematic-adaptive"
Rows = list[tuple[float, ...]]


def way(number: int, end: float = 0.7, size: float = 400.0) -> Rows:
    """A movement along x, there and back by turns, every 10 ms, a second after the one before."""
    rows: Rows = []
    for i in range(round(100 * end)):
        s = min(i / 60, 1.0)
        far = size * (10 * s**3 - 15 * s**4 + 6 * s**5)
        rows.append((2.0 * number + i / 100, far if number % 2 == 0 else size - far, 0.0, None, None, 0))
    return rows


def move(talk: Talk, rows: Rows, encoding: str = "json", size: int = 1) -> list[Any]:
    pack = packed if encoding == "binary" else events
    frames = [pack(*rows[i : i + size]) for i in range(0, len(rows), size)]
    return [one for frame in frames for one in talk.say(frame) if isinstance(one, dict)]


def choices(answers: list[Any]) -> list[Any]:
    return [one for one in answers if one["type"] == "choice"]


def standing(answers: list[Any]) -> list[str]:
    """What is proposed in the end."""
    proposed: list[str] = []
    for one in choices(answers):
        (proposed.append if one["action"] == "propose" else proposed.remove)(one["id"])
    return proposed


def somebody(**more: Any) -> Talk:
    """A session after eight movements there and back."""
    talk = Talk(greet=hello(NAME, **more))
    for number in range(8):
        move(talk, way(number))
        talk.say({"type": "reset"})
    return talk


@pytest.mark.parametrize(("encoding", "size"), [("json", 1), ("json", 7), ("binary", 1), ("binary", 30)])
def test_a_place_is_proposed_before_the_cursor_is_there(encoding: str, size: int) -> None:
    talk = somebody(places=True, encoding=encoding)
    answers = move(talk, way(8), encoding, size)
    first = next(one for one in choices(answers) if one["reason"] == "predicted")
    assert first["action"] == "propose"
    assert first["place"]["x"] == pytest.approx(400.0, abs=5.0)
    assert first["place"]["y"] == pytest.approx(0.0, abs=1.0)
    assert first["place"]["size"] >= 16.0
    assert first["t"] < 16.4


def test_frames_of_many_events_bring_the_choices_of_single_ones() -> None:
    alone, together = (choices(move(somebody(places=True), way(8), size=size)) for size in (1, 20))
    assert alone == together != []


@pytest.mark.parametrize("size", [7, 64])
def test_targets_weigh_alike_however_events_are_framed(size: int) -> None:
    """Frames that span two movements, which start elsewhere than where the last one ended."""
    rows = [row for number in range(8, 14) for row in way(number, end=0.5 + 0.1 * (number % 3))]
    targets = [
        {"id": "there", "x": 390.0, "y": -10.0, "width": 20.0, "height": 20.0},
        {"id": "near", "x": 385.0, "y": 30.0, "width": 30.0, "height": 30.0},
        {"id": "here", "x": -10.0, "y": -10.0, "width": 20.0, "height": 20.0},
    ]

    def answers(size: int) -> tuple[list[Any], list[Any]]:
        talk = somebody(places=True, reply="event")
        talk.say({"type": "targets", "targets": targets})
        said = move(talk, rows, size=size)
        return choices(said), [one for one in said if one["type"] == "prediction"]

    alone, framed = answers(1), answers(size)
    assert alone == framed
    assert len(alone[0]) > 4


def test_an_event_counts_more_with_places() -> None:
    limits = {"max_events_per_s": 130}
    for places, most in ((False, 130), (True, 10)):
        talk = Talk(greet=hello(NAME, places=places), **limits)
        talk.feed([(i / 1000, 0.0, 0.0, None, None, 0) for i in range(most)])
        assert talk.closed is None
        talk.say(events((1.0, 0.0, 0.0, None, None, 0)))
        assert talk.closed == 1008
    talk = Talk(greet=hello(NAME), **limits)
    talk.say({"type": "configure", "places": True})
    talk.say(events(*[(i / 1000, 0.0, 0.0, None, None, 0) for i in range(11)]))
    assert talk.closed == 1008


def test_who_did_not_ask_is_told_nothing() -> None:
    assert choices(move(somebody(), way(8))) == []


def test_places_are_asked_for_and_given_up_later() -> None:
    talk = somebody()
    talk.say({"type": "configure", "places": True})
    (proposed,) = standing(move(talk, way(8, end=0.4)))
    (retracted, _) = talk.say({"type": "configure", "places": False})
    assert (retracted["action"], retracted["id"]) == ("retract", proposed)
    assert choices(move(talk, way(9))) == []


def test_targets_take_the_places_of_places() -> None:
    talk = somebody(places=True)
    (proposed,) = standing(move(talk, way(8, end=0.4)))
    target = {"id": "far", "x": 0.0, "y": 900.0, "width": 20.0, "height": 20.0}
    answers = talk.say({"type": "targets", "targets": [target]})
    assert [(one["action"], one["id"]) for one in choices(answers)] == [("retract", proposed)]
    assert "place" not in str(choices(move(talk, way(9))))
    talk.say({"type": "targets", "targets": []})
    talk.say({"type": "reset"})
    assert proposed in standing(move(talk, way(10, end=0.4)))


def test_the_precision_is_that_of_places() -> None:
    talk = somebody(places=True)
    talk.say({"type": "configure", "precision": 1.0})
    assert "predicted" not in [one["reason"] for one in choices(move(talk, way(8, end=0.3)))]


def test_another_window_has_other_places() -> None:
    talk = somebody(places=True)
    assert talk.say({"type": "enter", "key": "editor", "x": 10.0}) == []
    assert choices(move(talk, way(8))) == []
    talk.say({"type": "enter", "key": ""})
    assert choices(move(talk, way(10, end=0.4))) != []


def test_the_window_stays_with_another_person() -> None:
    talk = Talk(greet=hello(NAME))
    talk.say({"type": "enter", "key": "editor", "x": 100.0, "y": 50.0})
    talk.say({"type": "person", "person": ""})
    talk.say({"type": "configure", "parameters": {"sequence": 0}})
    move(talk, way(0))
    talk.say({"type": "reset"})
    (place,) = talk.session.stream.pipeline.places
    assert (place.x, place.y) == pytest.approx((400.0, 0.0), abs=1.0)
    talk.say({"type": "enter", "key": ""})
    assert talk.session.stream.pipeline.places == ()


def test_forget_me() -> None:
    talk = somebody(places=True)
    assert talk.say({"type": "person"})[0]["person"] != ""
    (proposed,) = standing(move(talk, way(8, end=0.4)))
    retracted, answer = talk.say({"type": "forget"})
    assert (retracted["action"], retracted["id"]) == ("retract", proposed)
    assert answer == {"type": "person", "person": ""}
    assert choices(move(talk, way(9))) == []


def test_an_assisted_session_proposes_places() -> None:
    talk = Talk(greet=hello(NAME, places=True, assist={"strength": 0.0}, device={"cpi": 1000.0}))
    heard: list[Any] = []
    for number in range(10):
        rows = [
            (2.0 * number + i / 100, 0.0, 0.0, (3 if number % 2 == 0 else -3) if 0 < i < 40 else 0, 0, 0)
            for i in range(60)
        ]
        heard = choices(move(talk, rows))
        talk.say({"type": "reset"})
    assert [one["action"] for one in heard][:1] == ["propose"]


@pytest.mark.parametrize(
    ("message", "path"),
    [
        ({"type": "enter"}, "$.key"),
        ({"type": "enter", "key": 3}, "$.key"),
        ({"type": "enter", "key": "k" * 1025}, "$.key"),
        ({"type": "enter", "key": "k", "x": 1e10}, "$.x"),
        ({"type": "configure", "places": 1}, "$.places"),
        ({"type": "forget", "all": True}, "$.all"),
    ],
)
def test_what_is_wrong_is_said(message: dict[str, Any], path: str) -> None:
    talk = Talk(greet=hello(NAME))
    answer = talk.error(message)
    assert (answer["code"], answer["path"]) == ("bad_field", path)
    assert talk.goes_on()
