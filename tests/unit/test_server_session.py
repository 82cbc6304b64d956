from __future__ import annotations

import math
from typing import Any

import pytest

from pointpred import REGISTRY
from pointpred.clock import Instant
from pointpred.protocol.client_messages import CLIENT_MESSAGES, Events
from pointpred.protocol.server_messages import Limits
from pointpred_server.sessions.lifecycle import HELLO_S
from pointpred_server.sessions.pointing import PointingSession
from tests.unit.talking import PREDICTION, Talk, events, hello, packed

ROW = [0.5, 3.0, 4.0, None, None, 0]
NULLS = {"region": None, "remaining_s": None, "remaining_spread": None}


def test_hello_is_welcomed_with_the_limits() -> None:
    talk = Talk(greet=False)
    assert talk.session.state == "connecting"
    assert talk.say(hello("linear")) == [
        {
            "type": "welcome",
            "version": 1,
            "session": "name",
            "predictor": "linear",
            "limits": {
                "max_frame_bytes": 65536,
                "max_events_per_frame": 64,
                "max_events_per_s": 20000,
                "max_targets": 256,
                "max_sessions": 64,
                "idle_s": 60.0,
            },
        }
    ]
    assert talk.session.state == "greeted"


@pytest.mark.parametrize("name", REGISTRY)
def test_every_registry_name_is_welcome(name: str) -> None:
    (answer,) = Talk(greet=False).say(hello(name))
    assert (answer["type"], answer["predictor"]) == ("welcome", name)


def test_reply_and_encoding_unless_said_otherwise_are_frame_and_json() -> None:
    talk = Talk()
    rows = ([0.0, 1.0, 1.0, None, None, 0], [0.1, 3.0, 4.0, None, None, 0])
    assert talk.say(events(*rows)) == [
        {"type": "prediction", "t": 0.1, "x": 3.0, "y": 4.0, "phase": "ballistic", **NULLS}
    ]
    assert talk.session.state == "streaming"


def test_reply_event_answers_every_event() -> None:
    talk = Talk(greet=hello(reply="event"))
    answers = talk.say(events(ROW, [0.6, 5.0, 6.0, None, None, 0]))
    assert [(a["type"], a["t"], a["x"], a["y"]) for a in answers] == [
        ("prediction", 0.5, 3.0, 4.0),
        ("prediction", 0.6, 5.0, 6.0),
    ]


def test_binary_predictions_are_packed_and_every_other_message_stays_text() -> None:
    talk = Talk(greet=hello(encoding="binary"))
    (answer,) = talk.say(packed(ROW))
    t, x, y, *nothing, phase, tail = PREDICTION.unpack(answer)
    assert (t, x, y, phase) == (0.5, 3.0, 4.0, 0)
    assert all(math.isnan(value) for value in (*nothing, tail))
    (answer,) = talk.say({"type": "targets", "targets": []})
    assert answer == {"type": "targets", "count": 0}


def test_binary_reply_event_is_one_frame_of_a_record_an_event() -> None:
    talk = Talk(greet=hello(encoding="binary", reply="event"))
    (answer,) = talk.say(packed(ROW, [0.6, 5.0, 6.0, 1, 1, 1], [0.7, 7.0, 8.0, None, None, 0]))
    assert [record[:3] for record in PREDICTION.iter_unpack(answer)] == [
        (0.5, 3.0, 4.0),
        (0.6, 5.0, 6.0),
        (0.7, 7.0, 8.0),
    ]


def test_no_prediction_is_all_null_but_t() -> None:
    greet = hello("kep-quartic")
    first, second = [0.0, 1.0, 1.0, None, None, 0], [0.1, 1.0, 1.0, None, None, 0]
    nothing = {"x": None, "y": None, "phase": None, **NULLS}
    assert Talk(greet=greet).say(events(first)) == [{"type": "prediction", "t": 0.0, **nothing}]
    for frame in (packed(first), packed(first, second)):
        (answer,) = Talk(greet={**greet, "encoding": "binary"}).say(frame)
        _, *numbers, phase, tail = PREDICTION.unpack(answer)
        assert all(math.isnan(value) for value in (*numbers, tail))
        assert phase == 0


def test_an_empty_frame_is_answered_by_silence() -> None:
    talk = Talk()
    assert talk.say(events()) == []
    assert talk.say(b"") == []
    assert talk.session.state == "greeted"


def test_binary_events_are_taken_from_a_client_that_reads_json() -> None:
    assert Talk().say(packed(ROW)) == Talk().say(events(ROW))


def test_reset_forgets_even_the_time() -> None:
    talk = Talk()
    talk.say(events(ROW))
    assert talk.say({"type": "reset"}) == []
    (answer,) = talk.say(events([0.0, 9.0, 9.0, None, None, 0]))
    assert (answer["t"], answer["x"]) == (0.0, 9.0)


def test_bye_closes_with_its_reason() -> None:
    talk = Talk()
    assert talk.say({"type": "bye", "reason": "done"}) == []
    assert (talk.session.state, talk.closed) == ("closed", 1000)
    assert talk.session.close is not None
    assert talk.session.close.reason == "done"


def test_bye_before_hello_is_in_place() -> None:
    talk = Talk(greet=False)
    assert talk.say({"type": "bye"}) == []
    assert talk.closed == 1000


@pytest.mark.parametrize("frame", [events(ROW), packed(ROW), "{", {"type": "bye"}])
def test_a_closed_session_says_nothing_more(frame: Any) -> None:
    talk = Talk()
    talk.say({"type": "bye", "reason": "first"})
    close = talk.session.close
    assert talk.say(frame) == []
    talk.session.tick(Instant(1e9))
    talk.session.stop("stop")
    talk.session.fail()
    assert talk.hear() == []
    assert talk.session.close is close


def test_stop_says_bye_with_a_reason_after_the_prediction_in_flight() -> None:
    talk = Talk()
    talk.session.receive('{"type":"events","events":[[0,1,1,null,null,0]]}', Instant(0.0))
    talk.session.stop("the server stops")
    answers = talk.hear()
    assert sorted(answer["type"] for answer in answers) == ["bye", "prediction"]
    assert {"type": "bye", "reason": "the server stops"} in answers
    assert talk.closed == 1001


def test_a_failure_of_the_server_ends_with_internal() -> None:
    talk = Talk()
    talk.session.fail()
    (answer,) = talk.hear()
    assert (answer["code"], answer["recoverable"], talk.closed) == ("internal", False, 1011)


def test_the_close_reason_fits_a_close_frame() -> None:
    talk = Talk()
    talk.say({"type": "bye", "reason": "ä" * 500})
    assert talk.session.close is not None
    assert 100 < len(talk.session.close.reason.encode()) <= 123


@pytest.mark.parametrize(("after", "closed"), [(HELLO_S, None), (HELLO_S + 0.1, 1008)])
def test_hello_is_awaited_ten_seconds(after: float, closed: int | None) -> None:
    talk = Talk(greet=False)
    talk.say(events(ROW), 9.0)  # an error: chatter is no hello
    talk.session.tick(Instant(after))
    assert talk.closed == closed
    if closed:
        (answer,) = talk.hear()
        assert (answer["code"], answer["recoverable"]) == ("idle", False)
        assert "hello" in answer["message"]


@pytest.mark.parametrize(("after", "closed"), [(65.0, None), (65.1, 1008)])
def test_a_silent_client_is_given_up(after: float, closed: int | None) -> None:
    talk = Talk()
    talk.say(events(ROW), 5.0)
    talk.session.tick(Instant(after))
    assert talk.closed == closed
    assert [answer["code"] for answer in talk.hear()] == (["idle"] if closed else [])


@pytest.mark.parametrize(("late_s", "closed"), [(0.5, 1008), (30.0, None), (29.8, 1008)])
def test_time_in_which_the_process_stood_still_is_no_silence(late_s: float, closed: int | None) -> None:
    talk = Talk()
    talk.say(events(ROW), 5.0)
    talk.session.tick(Instant(94.9), late_s=late_s)
    assert talk.closed == closed


def test_after_a_standstill_tcp_may_need_as_long_again() -> None:
    talk = Talk(idle_s=10.0)
    talk.session.tick(Instant(50.0), late_s=50.0)
    talk.say(events(ROW), 50.1)
    talk.session.tick(Instant(110.0))
    assert talk.closed is None
    talk.session.tick(Instant(110.1))
    assert talk.closed == 1008


def test_a_frame_that_is_refused_is_a_sign_of_life() -> None:
    talk = Talk(idle_s=1.0)
    talk.say("{", 1.5)
    talk.session.tick(Instant(2.0))
    assert talk.closed is None


def test_idle_counts_from_hello() -> None:
    talk = Talk(greet=False, idle_s=5.0)
    talk.say(hello(), 9.0)
    talk.session.tick(Instant(13.0))
    assert talk.closed is None


def test_hello_must_not_wait_for_the_idle_time() -> None:
    talk = Talk(greet=False, idle_s=1e6)
    talk.session.tick(Instant(10.5))
    assert talk.closed == 1008


def test_limits_are_those_of_the_session() -> None:
    talk = Talk(greet=False, max_events_per_frame=7)
    (answer,) = talk.say(hello())
    assert answer["limits"]["max_events_per_frame"] == 7
    assert answer["limits"].keys() == set(Limits.__struct_fields__)


def test_every_message_has_a_handler() -> None:
    assert PointingSession.handlers.keys() == set(CLIENT_MESSAGES) - {Events}
