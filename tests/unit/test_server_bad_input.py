"""Every row of the protocol's table of bad input, without a socket."""

from __future__ import annotations

import json
from math import inf, nan
from typing import Any

import pytest

from pointpred import REGISTRY
from pointpred.errors import EventError
from tests.unit.talking import GOOD, Talk, events, hello, packed

ROW = [0.5, 3.0, 4.0, None, None, 0]
CLIENT = ("hello", "events", "targets", "trial", "configure", "reset", "bye")
TARGET = {"id": "a", "x": 0, "y": 0, "width": 1, "height": 1}


def told(conditions: dict[str, Any]) -> dict[str, Any]:
    return {"type": "trial", "action": "start", "conditions": conditions}


def row(place: int, value: Any) -> list[Any]:
    changed: list[Any] = list(ROW)
    changed[place] = value
    return changed


@pytest.mark.parametrize(
    "text", ["", "{", "events", '{"type": "events", "events": [}', "{'type': 1}", "\ufeff"]
)
def test_what_is_not_json(text: str) -> None:
    talk = Talk()
    error = talk.error(text)
    assert (error["code"], error["path"], error["recoverable"]) == ("bad_json", None, True)
    assert talk.goes_on()


@pytest.mark.parametrize(
    ("frame", "path", "word"),
    [
        ([], "$", "object"),
        ({"type": "events"}, "$.events", "required"),
        ({"type": "events", "events": [], "more": 1}, "$.more", "unknown field"),
        ({"type": "events", "events": 5}, "$.events", "array"),
        (events(ROW, ROW, ROW, row(0, "0.1")), "$.events[3][0]", "str"),
        (events(ROW, ROW[:5]), "$.events[1]", "received 5"),
        (events([*ROW, 0]), "$.events[0]", "received 7"),
        (events(row(0, None)), "$.events[0][0]", "null"),
        (events(row(1, 1.1e9)), "$.events[0][1]", "1100000000"),
        (events(ROW, row(2, -1.1e9)), "$.events[1][2]", "-1100000000"),
        (events(row(3, 1)), "$.events[0][4]", "both"),
        (events(ROW, row(4, 1)), "$.events[1][3]", "both"),
        (events(row(5, -1)), "$.events[0][5]", "-1"),
        (events(row(5, 65536)), "$.events[0][5]", "65536"),
        (events(row(5, 0.5)), "$.events[0][5]", "float"),
        (events(row(5, None)), "$.events[0][5]", "null"),
        ({"type": "targets"}, "$.targets", "required"),
        (
            {"type": "targets", "targets": [TARGET, {**TARGET, "width": 0}]},
            "$.targets[1].width",
            "received 0",
        ),
        ({"type": "targets", "targets": [{**TARGET, "height": -1}]}, "$.targets[0].height", "received -1"),
        ({"type": "targets", "targets": [{**TARGET, "x": 1e10}]}, "$.targets[0].x", "received 10000000000"),
        ({"type": "targets", "targets": [{**TARGET, "id": ""}]}, "$.targets[0].id", "length"),
        ({"type": "targets", "targets": [{**TARGET, "id": 5}]}, "$.targets[0].id", "int"),
        ({"type": "targets", "targets": [{**TARGET, "type": "b"}]}, "$.targets[0].type", "unknown field"),
        ({"type": "targets", "targets": [TARGET, TARGET]}, "$.targets[1].id", "twice"),
        ({"type": "trial"}, "$.action", "required"),
        ({"type": "trial", "action": "go"}, "$.action", "go"),
        ({"type": "trial", "action": "start", "target": {"x": 1, "y": 2}}, "$.target.width", "required"),
        (told({"block": None}), "$.conditions.block", "null"),
        (told({"block": 1, "at": [2]}), "$.conditions.at", "array"),
        (told({"at": "a\n"}), "$.conditions.at", "regex"),
        (told({"at": "a" * 257}), "$.conditions.at", "256"),
        (told({"a,b": 1}), "$.conditions", "name of an entry"),
        (told({"a\n": 1}), "$.conditions", "name of an entry"),
        (told({"a" * 65: 1}), "$.conditions", "length <= 64"),
        (told({str(i): i for i in range(33)}), "$.conditions", "32"),
        (told({"user": "p"}), "$.conditions.user", "is a column of every table of trials; taken: dataset,"),
        ({"type": "configure", "precision": 1.1}, "$.precision", "received 1.1"),
        ({"type": "configure", "precision": -0.1}, "$.precision", "received -0.1"),
        ({"type": "configure", "reply": "both"}, "$.reply", "both"),
        ({"type": "configure", "encoding": "binary"}, "$.encoding", "unknown field"),
        ({"type": "reset", "at": 5}, "$.at", "unknown field"),
        (b"x" * 29, "$", "29"),
        (packed(ROW, ROW) + b"x", "$", "61"),
        (packed(ROW, row(0, nan)), "$.events[1][0]", "nan"),
        (packed(ROW, ROW, row(1, inf)), "$.events[2][1]", "inf"),
        (packed(row(2, -2e9)), "$.events[0][2]", "-2000000000"),
    ],
)
def test_a_wrong_field_is_told_with_its_path(frame: Any, path: str, word: str) -> None:
    talk = Talk()
    error = talk.error(json.dumps(frame) if isinstance(frame, list) else frame)
    assert (error["code"], error["path"], error["recoverable"]) == ("bad_field", path, True)
    assert word in error["message"]
    assert talk.goes_on()


@pytest.mark.parametrize("value", ["NaN", "Infinity", "-Infinity", "1e999", "1" * 400])
def test_a_number_that_is_not_finite_is_told_with_its_path(value: str) -> None:
    talk = Talk()
    error = talk.error(f'{{"type":"events","events":[[0,1,1,null,null,0],[0,1,{value},null,null,0]]}}')
    assert (error["code"], error["path"]) == ("bad_field", "$.events[1][2]")
    assert talk.goes_on()


@pytest.mark.parametrize("frame", [events(ROW, row(1, 1e10)), packed(ROW, row(1, 1e10)), packed(row(1, nan))])
def test_a_frame_with_a_wrong_number_is_dropped_whole(frame: Any) -> None:
    talk, other = Talk(greet=hello("switched")), Talk(greet=hello("switched"))
    talk.say(frame)
    next_one = events([0.1, 5.0, 5.0, None, None, 0])  # before the dropped ROW: still in order
    assert talk.say(next_one) == other.say(next_one)
    assert talk.session.stream is not None
    assert talk.session.stream.events == 1


@pytest.mark.parametrize(
    ("frame", "code"),
    [
        ('{"type": "evnets"}', "unknown_type"),
        ("{}", "unknown_type"),
        ('{"type": 5}', "bad_field"),
        ('{"type": null, "events": []}', "bad_field"),
    ],
)
def test_an_unknown_message_is_told_the_known_ones(frame: str, code: str) -> None:
    talk = Talk()
    error = talk.error(frame)
    assert (error["code"], error["path"], error["recoverable"]) == (code, "$.type", True)
    assert all(name in error["message"] for name in CLIENT)
    assert talk.goes_on()


@pytest.mark.parametrize("name", ["", "swtiched", "hold ", "\u202e"])
def test_an_unknown_predictor_is_told_the_known_ones(name: str) -> None:
    for talk, frame in (
        (Talk(greet=False), hello(name)),
        (Talk(), {"type": "configure", "predictor": name}),
    ):
        before = talk.session.state
        error = talk.error(frame)
        assert (error["code"], error["path"]) == ("unknown_predictor", "$.predictor")
        assert all(known in error["message"] for known in REGISTRY)
        assert talk.session.state == before


@pytest.mark.parametrize("form", [events, packed])
def test_time_backwards_drops_the_event_and_keeps_the_rest(form: Any) -> None:
    good = [[0.1, 1.0, 1.0, None, None, 0], [0.2, 4.0, 2.0, None, None, 0], [0.3, 9.0, 3.0, None, None, 0]]
    late = [[0.15, 900.0, 0.0, None, None, 0], [0.19, 900.0, 0.0, None, None, 0]]
    talk, other = Talk(greet=hello("switched")), Talk(greet=hello("switched"))
    error, prediction = talk.say(form(good[0], good[1], *late, good[2])), other.say(form(*good))
    said = next(answer for answer in error if answer["type"] == "error")
    assert (said["code"], said["path"], said["recoverable"]) == ("out_of_order", "$.events[2][0]", True)
    assert "0.15" in said["message"]
    assert "0.2" in said["message"]
    assert "1 more" in said["message"]
    assert talk.session.refusals == {"out_of_order": 2}
    assert [answer for answer in error if answer["type"] == "prediction"] == prediction


@pytest.mark.parametrize("form", [events, packed])
def test_one_late_event_changes_nothing(form: Any) -> None:
    talk, other = Talk(greet=hello("switched")), Talk(greet=hello("switched"))
    for one in (talk, other):
        one.say(form([0.5, 3.0, 4.0, None, None, 0]))
    error = talk.error(form([0.4, 900.0, 4.0, None, None, 0]))
    assert (error["code"], error["path"]) == ("out_of_order", "$.events[0][0]")
    after = form([0.5, 5.0, 5.0, None, None, 0], [0.6, 9.0, 9.0, None, None, 0])
    assert talk.say(after) == other.say(after)


def test_equal_times_bursts_gaps_and_any_rate_are_no_error() -> None:
    talk = Talk(greet=hello("switched", reply="event"))
    times = [0.0, 0.0, 0.0, 1e-4, 1.25e-4, 2.5e-4, 1.0, 2.0, 3.0, 3.05, 500.0]
    answers = talk.say(events(*([t, 5.0 * t, 1.0, None, None, 0] for t in times)))
    assert [answer["type"] for answer in answers] == ["prediction"] * len(times)
    assert [answer["t"] for answer in answers] == times


@pytest.mark.parametrize(
    "frame",
    [
        events(ROW),
        packed(ROW),
        {"type": "targets", "targets": []},
        {"type": "trial", "action": "start"},
        {"type": "configure"},
        {"type": "reset"},
    ],
)
def test_before_hello_only_hello_is_in_place(frame: Any) -> None:
    talk = Talk(greet=False)
    error = talk.error(frame)
    assert (error["code"], error["recoverable"]) == ("out_of_place", True)
    assert "expected 'hello' first" in error["message"]
    assert talk.session.state == "connecting"


@pytest.mark.parametrize("state", ["greeted", "streaming"])
def test_hello_is_said_once(state: str) -> None:
    talk = Talk()
    if state == "streaming":
        talk.say(events(ROW))
    error = talk.error(hello("linear"))
    assert (error["code"], error["message"]) == (
        "out_of_place",
        f"expected 'hello' once, the session is {state}",
    )
    assert talk.goes_on()
    assert talk.session.stream is not None
    assert talk.session.stream.hello.predictor == "hold"


@pytest.mark.parametrize("version", [0, 3, -1])
def test_another_version_is_refused(version: int) -> None:
    talk = Talk(greet=False)
    error = talk.error(hello() | {"version": version})
    assert (error["code"], error["path"]) == ("bad_field", "$.version")
    assert str(version) in error["message"]
    assert talk.say(hello())[0]["type"] == "welcome"


def test_a_good_event_is_answered_after_everything_bad_at_once() -> None:
    talk = Talk()
    for frame in ("", "{", "[]", b"x", events(row(0, None)), '{"type":"x"}', packed(row(0, nan))):
        talk.say(frame)
    assert talk.say(events(GOOD))[0]["t"] == 1e6
    assert sum(talk.session.refusals.values()) == 7


@pytest.mark.parametrize("form", [events, packed])
def test_an_event_that_a_stage_refuses_by_an_error_is_answered(form: Any) -> None:
    talk = Talk()

    def refuse(row: tuple[float, ...]) -> None:
        raise EventError("motion must be finite", field="x", value=1.0)

    talk.session.stream.pipeline.advance = refuse
    error = talk.error(form([0.5, 1.0, 2.0, None, None, 0]))
    assert (error["code"], error["path"], error["field"], error["value"]) == (
        "bad_field",
        "$.events",
        "x",
        1.0,
    )
    assert talk.session.refusals == {"bad_field": 1}
    assert talk.closed is None
