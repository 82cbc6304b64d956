"""Frames of events that have waited are used as one: every event counts, as if each had been used alone."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable

import pytest

from pointpred.protocol.decoding import decode_client_message
from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Limits
from pointpred_server.sessions.pointing import PointingSession

HELLO = '{"type":"hello","version":1,"predictor":"%s","encoding":"%s","reply":"%s"}'
LATE = '{"type":"events","events":[[0.5,1,2,null,null,0]]}'


def movement(first: int, count: int) -> list[tuple[float, float, float, int, int, int]]:
    return [(1 + 1e-3 * k, k * k / 50, k / 3, k, 1, 0) for k in range(first, first + count)]


def packed(first: int, count: int = 1) -> bytes:
    """Events of a movement, 1 ms apart."""
    return b"".join(struct.pack("<dddhhH", *row) for row in movement(first, count))


def text(first: int, count: int = 1) -> str:
    """The same in JSON."""
    return json.dumps({"type": "events", "events": movement(first, count)})


MADE: dict[str, Callable[[int, int], Frame]] = {"binary": packed, "json": text}


def greeted(predictor: str, encoding: str, reply: str, **limits: int) -> PointingSession:
    session = PointingSession("here", Limits(**limits), 0.0)
    session.receive(HELLO % (predictor, encoding, reply), 0.0)
    session.outbox.take()
    return session


def one_by_one(session: PointingSession, frames: list[Frame]) -> list[Frame]:
    answers = []
    for frame in frames:
        session.receive(frame, 1.0)
        answers += session.outbox.take()
    return answers


def together(session: PointingSession, frames: list[Frame]) -> list[Frame]:
    answers = []
    while frames:
        frames = frames[session.receive_together(frames, 1.0) :]
        answers += session.outbox.take()
    return answers


@pytest.mark.parametrize("predictor", ["switched", "kinematic", "kinematic-adaptive"])
@pytest.mark.parametrize("encoding", ["binary", "json"])
def test_frames_that_waited_get_the_last_answer_of_them(predictor: str, encoding: str) -> None:
    sizes = [1, 1, 1, 3, 1, 8, 2]
    frames = [MADE[encoding](sum(sizes[:k]), size) for k, size in enumerate(sizes)]
    apart, joined = greeted(predictor, encoding, "frame"), greeted(predictor, encoding, "frame")
    answers = one_by_one(apart, frames)
    assert len(answers) == len(frames)
    assert together(joined, frames) == answers[-1:]
    assert joined.events == apart.events == sum(sizes)
    after = [MADE[encoding](sum(sizes), 1)]
    assert one_by_one(joined, after) == one_by_one(apart, after)


@pytest.mark.parametrize("encoding", ["binary", "json"])
def test_every_event_is_answered_where_the_client_asked_for_that(encoding: str) -> None:
    frames = [MADE[encoding](3 * k, 3) for k in range(5)]
    apart, joined = greeted("switched", encoding, "event"), greeted("switched", encoding, "event")
    alone, answers = one_by_one(apart, frames), together(joined, frames)
    if encoding == "binary":
        assert [b"".join(one for one in alone if isinstance(one, bytes))] == answers
    else:
        assert alone == answers


@pytest.mark.parametrize("between", ['{"type":"reset"}', "{", b"\0" * 29, b"", LATE, text(4, 9)], ids=str)
@pytest.mark.parametrize("place", [0, 1, 5])
def test_what_is_not_just_events_is_answered_as_ever(between: Frame, place: int) -> None:
    frames: list[Frame] = [text(k) for k in range(6)]
    frames.insert(place, between)
    apart, joined = greeted("switched", "json", "frame"), greeted("switched", "json", "frame")
    alone, answers = one_by_one(apart, frames), together(joined, frames)
    assert [one for one in answers if "error" in str(one)] == [one for one in alone if "error" in str(one)]
    assert answers[-1] == alone[-1]
    assert (joined.events, joined.refusals) == (apart.events, apart.refusals)


def test_frames_that_end_at_one_time_are_told_apart() -> None:
    session = greeted("switched", "json", "frame")
    assert len(together(session, [text(1), text(1), text(1)])) == 3


def test_limits_hold_for_frames_that_waited() -> None:
    frames: list[Frame] = [packed(4 * k, 4) for k in range(10)]
    apart = greeted("hold", "binary", "frame", max_events_per_s=20)
    joined = greeted("hold", "binary", "frame", max_events_per_s=20)
    one_by_one(apart, frames)
    together(joined, frames)
    assert apart.close == joined.close
    assert apart.close is not None
    assert apart.close.code == 1008
    assert apart.events == joined.events == 20
    many = greeted("hold", "binary", "frame", max_events_per_frame=12)
    assert len(together(many, frames)) == 4, "a table of frames is no longer than a frame may be"


def test_as_many_frames_are_joined_as_one_turn_of_the_loop_may_take() -> None:
    session = greeted("switched", "json", "frame", max_events_per_s=100_000)
    assert len(together(session, [text(20 * k, 20) for k in range(50)])) <= 3
    assert session.events == 1000
    assert session.work is None


def test_frames_that_cannot_be_joined_are_not_tried_again_and_again(monkeypatch: pytest.MonkeyPatch) -> None:
    decoded: list[Frame] = []

    def decode(frame: str) -> object:
        decoded.append(frame)
        return decode_client_message(frame)

    session = greeted("switched", "json", "frame")
    session.receive(text(0), 1.0)
    frames: list[Frame] = [text(10 + k) for k in range(63)]
    frames.append(json.dumps({"type": "events", "events": [*movement(0, 1), *movement(90, 1)]}))
    monkeypatch.setattr("pointpred_server.sessions.pointing.decode_client_message", decode)
    together(session, frames)
    assert session.refusals == {"out_of_order": 1}
    assert session.events == 65
    assert len(decoded) <= 3 * len(frames)
