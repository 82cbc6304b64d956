"""What is too large, too fast, too much or too slow, and how the session ends."""

from __future__ import annotations

import json
from typing import Any

import pytest

from pointpred.protocol.token_bucket import TokenBucket
from pointpred_server.sessions.quota import MESSAGES_PER_S
from tests.unit.talking import Talk, events, hello, packed

ROW = [0.5, 3.0, 4.0, None, None, 0]


def padded(size: int, letter: str = "x") -> str:
    """A good message of so many bytes."""
    empty = '{"type":"bye","reason":""}'
    return empty.replace('""', f'"{letter * ((size - len(empty)) // len(letter.encode()))}"')


@pytest.mark.parametrize("letter", ["x", "é", "€", "😀"])
def test_a_text_frame_holds_at_most_64_kib_as_bytes(letter: str) -> None:
    talk = Talk()
    talk.say(padded(65536, letter))
    assert talk.closed == 1000
    talk = Talk()
    error = talk.error(padded(65536 + 2 * len(letter.encode()), letter))
    assert (error["code"], error["recoverable"], talk.closed) == ("too_large", False, 1009)
    assert "65536" in error["message"]


def test_a_binary_frame_holds_at_most_64_kib() -> None:
    talk = Talk(max_events_per_frame=10**6)
    assert len(talk.say(packed(*[ROW] * 2184))) == 1  # 65,520 bytes
    error = talk.error(packed(*[ROW] * 2185))
    assert (error["code"], talk.closed) == ("too_large", 1009)


@pytest.mark.parametrize("greet", [True, False])
def test_too_large_ends_the_session_in_every_state(greet: bool) -> None:
    talk = Talk(greet=greet)
    talk.say("[" * 65537)
    assert talk.closed == 1009


@pytest.mark.parametrize("form", [events, packed])
def test_a_frame_holds_at_most_1024_events(form: Any) -> None:
    talk = Talk()
    assert len(talk.say(form(*[ROW] * 1024))) == 1
    error = talk.error(form(*[ROW] * 1025))
    assert (error["code"], error["path"], talk.closed) == ("too_large", "$.events", 1009)
    assert "1024" in error["message"]
    assert "1025" in error["message"]


@pytest.mark.parametrize("form", [events, packed])
@pytest.mark.parametrize("frame", [1, 10])
def test_the_budget_is_one_second_of_events_and_refills(form: Any, frame: int) -> None:
    talk = Talk(max_events_per_s=100)
    for _ in range(100 // frame):
        assert len(talk.say(form(*[ROW] * frame), 1.0)) == 1
    assert len(talk.say(form(*[ROW] * frame), 1.0 + frame / 100)) == 1
    error = talk.error(form(*[ROW] * frame), 1.0 + 1.9 * frame / 100)
    assert (error["code"], error["recoverable"], talk.closed) == ("too_fast", False, 1008)
    assert "100 events a second" in error["message"]


FLOODS = {
    "reset": '{"type":"reset"}',
    "configure": '{"type":"configure","predictor":"linear"}',
    "targets": '{"type":"targets","targets":[]}',
    "trial": '{"type":"trial","action":"start"}',
    "hello again": json.dumps(hello()),
    "no JSON": "{oops",
    "no message": '{"type":"dance"}',
    "no events": '{"type":"events","events":[]}',
    "no packed events": b"",
    "a torn record": b"12345",
}


@pytest.mark.parametrize("kind", list(FLOODS))
@pytest.mark.parametrize("greet", [True, False])
def test_a_flood_of_whatever_it_is_ends_as_too_fast(kind: str, greet: bool) -> None:
    talk = Talk(greet=greet, max_events_per_s=1000)
    heard: list[Any] = []
    for _ in range(1001):
        heard += talk.say(FLOODS[kind], 1.0)
    assert talk.closed == 1008
    assert (heard[-1]["code"], heard[-1]["recoverable"]) == ("too_fast", False)
    assert "a second" in heard[-1]["message"]


def test_messages_have_a_limit_apart_from_events() -> None:
    talk = Talk(max_events_per_s=100)
    for k in range(3 * MESSAGES_PER_S):
        talk.say('{"type":"reset"}', 1.0 + k / MESSAGES_PER_S)
        assert talk.closed is None
    assert len(talk.say(packed(*[ROW] * 100), 5.0)) == 1
    for k in range(MESSAGES_PER_S):
        talk.say('{"type":"reset"}', 5.0)
        assert talk.closed is None, k
    error = talk.error('{"type":"reset"}', 5.0)
    assert (error["code"], talk.closed) == ("too_fast", 1008)
    assert f"{MESSAGES_PER_S} messages" in error["message"]


def test_long_frames_that_cannot_be_used_count_for_more() -> None:
    talk = Talk()
    long = "[" * 60_000
    count = 0
    while talk.closed is None:
        talk.say(long, 1.0)
        count += 1
    assert talk.closed == 1008
    assert 10 < count < MESSAGES_PER_S / 10


def test_a_goodbye_is_heard_however_much_came_before() -> None:
    talk = Talk()
    for _ in range(MESSAGES_PER_S - 1):
        talk.say('{"type":"reset"}', 0.0)
    talk.say('{"type":"bye"}', 0.0)
    assert talk.closed == 1000


def test_a_session_may_send_its_rate_for_ever() -> None:
    talk = Talk(max_events_per_s=1000)
    for second in range(5):
        for frame in range(125):
            now = second + (frame + 1) / 125
            assert len(talk.say(packed(*[ROW] * 8), now)) == 1


def test_the_budget_holds_no_more_than_one_second() -> None:
    rate = TokenBucket(100, 0.0)
    assert rate.take(100, 0.0)
    assert not rate.take(1, 0.005)
    assert rate.take(100, 50.0)
    assert not rate.take(1, 50.0)
    assert rate.take(50, 50.5)


def test_a_refusal_takes_nothing_and_a_clock_that_stands_gives_nothing() -> None:
    rate = TokenBucket(10, 0.0)
    assert not rate.take(11, 0.0)
    assert rate.take(10, 0.0)
    assert not rate.take(1, -5.0)
    assert not rate.take(6, -4.5)
    assert rate.take(5, -4.5)


def test_what_comes_after_the_process_stood_still_is_within_the_budget() -> None:
    rate = TokenBucket(10, 0.0)
    assert rate.take(10, 0.0)
    rate.extend(3.0)
    assert rate.take(40, 4.0)
    assert not rate.take(1, 4.0)
    rate.extend(1e6)
    assert rate.take(610, 5.0)
    assert not rate.take(1, 5.0)
    assert not rate.take(11, 6.0)


def targets(count: int) -> dict[str, Any]:
    one = {"x": 0, "y": 0, "width": 1, "height": 1}
    return {"type": "targets", "targets": [{"id": str(i), **one} for i in range(count)]}


def test_targets_replace_the_set_and_are_at_most_1000() -> None:
    talk = Talk()
    assert talk.say(targets(1000)) == [{"type": "targets", "count": 1000}]
    assert talk.say(targets(2)) == [{"type": "targets", "count": 2}]
    error = talk.error(targets(1001))
    assert (error["code"], error["path"], error["recoverable"]) == ("too_many", "$.targets", True)
    assert talk.goes_on()
    assert [one["id"] for one in talk.say(events([1e6 + 1.0, 0.0, 0.0, None, None, 0]))[-1]["targets"]] == [
        "0",
        "1",
    ]


def test_predictions_that_are_not_read_give_way_and_are_counted() -> None:
    talk = Talk()
    for t in range(100):
        talk.session.receive(json.dumps(events([t, t, 0, None, None, 0])), t)
    slow, newest = talk.hear()
    assert (slow["code"], slow["recoverable"]) == ("slow", True)
    assert slow["message"].startswith("99 ")
    assert newest["t"] == 99
    assert talk.session.outbox.dropped_total == 99
    assert talk.hear() == []


@pytest.mark.parametrize("greet", [hello(reply="event"), hello(reply="event", encoding="binary")])
def test_predictions_that_nobody_reads_leave_the_memory_flat(greet: dict[str, Any]) -> None:
    """How long nobody reads is for the connection to notice: how many gave way says nothing of it."""
    talk = Talk(greet=greet, max_events_per_s=10**9)
    frame = packed(*[ROW] * 100)
    for _ in range(1000):
        talk.session.receive(frame, 0.0)
        assert talk.closed is None
    slow, *newest = talk.hear()
    assert slow["message"].startswith("99900 ")
    assert len(newest) <= 100
    assert len(talk.say(events(ROW))) == 1


def test_other_answers_that_are_not_read_end_the_session_too() -> None:
    talk = Talk()
    for k in range(1024):
        talk.session.receive("{", k / 100)
    assert talk.closed is None
    talk.session.receive("{", 10.24)
    assert talk.closed == 1013
    assert len(talk.hear()) == 1026


def test_what_an_error_quotes_is_bounded() -> None:
    talk = Talk()
    for frame in (
        {"type": "x" * 60000},
        {"type": "configure", "predictor": "x" * 60000},
        {"type": "configure", "parameters": {"x" * 60000: 1}},
        {"type": "configure", "x" * 60000: 1},
        {"type": "trial", "action": "x" * 60000},
    ):
        assert len(json.dumps(talk.error(frame))) < 2500
