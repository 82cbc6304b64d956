"""What is too large, too fast, too much or too slow, and how the session ends."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest

from pointpred.clock import Instant
from pointpred.protocol.server_messages import Limits
from pointpred.protocol.token_bucket import TokenBucket
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.sessions.quota import (
    BUILDING,
    BYTES_A_MESSAGE,
    MESSAGES_PER_S,
    SESSIONS_OF_AN_ADDRESS,
    Address,
    Addresses,
)
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
def test_a_frame_holds_at_most_64_events(form: Any) -> None:
    talk = Talk()
    assert len(talk.say(form(*[ROW] * 64))) == 1
    error = talk.error(form(*[ROW] * 65))
    assert (error["code"], error["path"], talk.closed) == ("too_large", "$.events", 1009)
    assert "at most 64 events, received 65" in error["message"]


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
    talk = Talk(max_events_per_s=64)
    for k in range(3 * MESSAGES_PER_S):
        talk.say('{"type":"reset"}', 1.0 + k / MESSAGES_PER_S)
        assert talk.closed is None
    assert len(talk.say(packed(*[ROW] * 64), 5.0)) == 1
    for k in range(MESSAGES_PER_S):
        talk.say('{"type":"reset"}', 5.0)
        assert talk.closed is None, k
    error = talk.error('{"type":"reset"}', 5.0)
    assert (error["code"], talk.closed) == ("too_fast", 1008)
    assert f"{MESSAGES_PER_S} messages" in error["message"]


@pytest.mark.parametrize(
    ("frame", "count"),
    [
        ("[" * BYTES_A_MESSAGE, 2),
        ("[" * 65_536, 5),
        ('{"type":"reset"}' + " " * (3 * BYTES_A_MESSAGE), 4),
        ('{"type":"configure","reply":"frame"}', 1),
        ('{"type":"configure","predictor":"hold"}', BUILDING),
        ('{"type":"person"}', 1),
        ('{"type":"person","person":""}', BUILDING),
        ('{"type":"trial","action":"start"}', BUILDING),
    ],
)
def test_what_takes_long_counts_for_more(frame: str, count: int) -> None:
    talk = Talk()
    for _ in range(MESSAGES_PER_S // count):
        talk.say(frame, 2.0)
        assert talk.closed is None
    talk.say(frame, 2.0)
    assert talk.closed == 1008


def test_pings_and_pieces_of_messages_count_as_messages() -> None:
    talk = Talk()
    for _ in range(MESSAGES_PER_S):
        talk.session.receive_piece(Instant(2.0))
    assert talk.closed is None
    talk.session.receive_piece(Instant(2.0))
    talk.session.receive_piece(Instant(2.0))
    (error,) = talk.hear()
    assert (error["code"], talk.closed) == ("too_fast", 1008)


def test_a_goodbye_is_heard_however_much_came_before() -> None:
    talk = Talk()
    for _ in range(MESSAGES_PER_S - BUILDING):  # hello was the rest
        talk.say('{"type":"reset"}', 0.0)
    talk.say('{"type":"bye"}', 0.0)
    assert talk.closed == 1000


def test_a_session_may_send_its_rate_for_ever() -> None:
    talk = Talk(max_events_per_s=1000)
    for second in range(5):
        for frame in range(125):
            now = second + (frame + 1) / 125
            assert len(talk.say(packed(*[ROW] * 8), now)) == 1


def taking(most: float) -> Callable[[float, float], bool]:
    """What takes out of a budget, at a time in seconds."""
    rate = TokenBucket(most, Instant(0.0))
    return lambda count, now: rate.take(count, Instant(now))


def test_the_budget_holds_no_more_than_one_second() -> None:
    take = taking(100)
    assert take(100, 0.0)
    assert not take(1, 0.005)
    assert take(100, 50.0)
    assert not take(1, 50.0)
    assert take(50, 50.5)


def test_a_refusal_takes_nothing_and_a_clock_that_stands_gives_nothing() -> None:
    take = taking(10)
    assert not take(11, 0.0)
    assert take(10, 0.0)
    assert not take(1, -5.0)
    assert not take(6, -4.5)
    assert take(5, -4.5)


def test_what_comes_after_the_process_stood_still_is_within_the_budget() -> None:
    rate = TokenBucket(10, Instant(0.0))
    assert rate.take(10, Instant(0.0))
    rate.extend(3.0)
    assert rate.take(40, Instant(4.0))
    assert not rate.take(1, Instant(4.0))
    rate.extend(1e6)
    assert rate.take(610, Instant(5.0))
    assert not rate.take(1, Instant(5.0))
    assert not rate.take(11, Instant(6.0))


LIMITS = Limits(max_events_per_s=64)


def of_address(address: Address, at: Instant) -> PointingSession:
    """A session of an address, after its hello."""
    session = PointingSession("name", LIMITS, at, address)
    session.receive(json.dumps(hello()), at)
    return session


@pytest.mark.parametrize(
    ("frame", "frames"),
    [(packed(*[ROW] * 64), 1), ('{"type":"reset"}', MESSAGES_PER_S - BUILDING)],
)
def test_who_comes_again_has_no_fresh_budget(frame: str | bytes, frames: int) -> None:
    """Sessions of one address, one after another, share what so many may send at a time."""
    known = Addresses(LIMITS)

    def session_of(name: str, at: float) -> PointingSession:
        session = of_address(known.of(name, Instant(at)), Instant(at))
        for _ in range(frames):
            session.receive(frame, Instant(at))
        return session

    for _ in range(SESSIONS_OF_AN_ADDRESS):
        assert session_of("192.0.2.1", 0.0).close is None
    close = session_of("192.0.2.1", 0.0).close
    assert close is not None
    assert (close.code, "of this address" in close.reason) == (1008, True)
    assert session_of("192.0.2.2", 0.0).close is None
    assert session_of("192.0.2.1", 1.0).close is None


def test_addresses_that_are_idle_are_forgotten() -> None:
    known = Addresses(LIMITS)

    def used(name: str) -> Address:
        address = known.of(name, Instant(0.0))
        address.events.take(1, Instant(0.0))
        return address

    idle, busy, open_ = map(used, ("idle", "busy", "open"))
    open_.sessions = 1
    busy.events.take(1, Instant(1.0))
    known.of("another", Instant(1.0))
    assert known.of("open", Instant(1.0)) is open_
    assert known.of("busy", Instant(1.0)) is busy
    assert known.of("idle", Instant(1.0)) is not idle


def test_a_moment_has_no_difference_with_a_number_or_another_moment() -> None:
    moment: Any = Instant(1.0)
    for other in (0.5, Instant(0.5)):
        with pytest.raises(TypeError):
            moment - other
        with pytest.raises(TypeError):
            other - moment
    assert moment.since(Instant(0.5)) == 0.5


def targets(count: int) -> dict[str, Any]:
    one = {"x": 0, "y": 0, "width": 1, "height": 1}
    return {"type": "targets", "targets": [{"id": str(i), **one} for i in range(count)]}


def test_targets_replace_the_set_and_are_at_most_256() -> None:
    talk = Talk()
    assert talk.say(targets(256)) == [{"type": "targets", "count": 256}]
    assert talk.say(targets(2)) == [{"type": "targets", "count": 2}]
    error = talk.error(targets(257))
    assert (error["code"], error["path"], error["recoverable"]) == ("too_many", "$.targets", True)
    assert talk.goes_on()
    assert [one["id"] for one in talk.say(events([1e6 + 1.0, 0.0, 0.0, None, None, 0]))[-1]["targets"]] == [
        "0",
        "1",
    ]


def test_predictions_that_are_not_read_give_way_and_are_counted() -> None:
    talk = Talk()
    for t in range(100):
        talk.session.receive(json.dumps(events([t, t, 0, None, None, 0])), Instant(t))
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
    frame = packed(*[ROW] * 50)
    for _ in range(1000):
        talk.session.receive(frame, Instant(0.0))
        assert talk.closed is None
    slow, *newest = talk.hear()
    assert slow["message"].startswith("49950 ")
    assert len(newest) <= 50
    assert len(talk.say(events(ROW))) == 1


def test_other_answers_that_are_not_read_end_the_session_too() -> None:
    talk = Talk()
    for k in range(1024):
        talk.session.receive("{", Instant(k / 100))
    assert talk.closed is None
    talk.session.receive("{", Instant(10.24))
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
