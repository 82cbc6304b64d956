"""The Python client after something was refused: it waits for what still comes, and for nothing else."""

from __future__ import annotations

import asyncio
import math
from collections import deque
from collections.abc import Iterable, Sequence
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.client import ServiceError, connect, connect_async
from pointpred.client.session import ClientSession, hello_message
from pointpred.clock import Instant
from pointpred.protocol.server_messages import Limits, Welcome
from pointpred_server.sessions.pointing import PointingSession
from tests.server.listener import Listener

Rows = Sequence[tuple[float, float, float]]


class Pair:
    """The sessions of a client and of the server without a socket: answers arrive when the test wants it."""

    def __init__(self, **hello: Any) -> None:
        self.client = ClientSession(hello_message(predictor="hold", **hello))
        self.session = PointingSession("here", Limits(), Instant(0.0))
        self.tell(self.client.hello_frame())
        assert self.hear() == []

    def tell(self, frame: str | bytes) -> None:
        self.session.receive(frame, Instant(0.0))

    def send(self, rows: Rows) -> None:
        for frame in self.client.event_frames(rows):
            self.tell(frame)

    def hear(self) -> list[str]:
        """Take in every answer; the codes of what was refused."""
        return self.take_in(self.session.outbox.take())

    def take_in(self, frames: Iterable[str | bytes]) -> list[str]:
        codes = []
        for frame in frames:
            try:
                self.client.receive(frame)
            except ServiceError as error:
                codes.append(error.code)
        return codes

    def times(self) -> list[float]:
        return self.client.take_all().t.tolist()


BAD: dict[str, tuple[Rows, str, list[float]]] = {
    "too late a time": ([(1e12, 0, 0)], "bad_field", []),
    "no place": ([(1.5, math.nan, 0)], "bad_field", []),
    "no time": ([(math.nan, 0, 0)], "bad_field", []),
    "a good event beside it": ([(1.2, 0, 0), (1.3, 1e10, 0)], "bad_field", []),
    "backwards": ([(0.5, 0, 0)], "out_of_order", []),
    "backwards and no place": ([(0.5, math.nan, 0)], "bad_field", []),
    "backwards beside a good event": ([(1.2, 0, 0), (1.1, 0, 0)], "out_of_order", [1.2]),
}
"""Events that follow one of 1 s, the code of the error, and the times that are kept."""


@pytest.mark.parametrize("encoding", ["binary", "json"])
@pytest.mark.parametrize("reply", ["frame", "event"])
@pytest.mark.parametrize(("rows", "code", "kept"), BAD.values(), ids=BAD)
def test_nothing_is_awaited_for_a_refused_frame(
    rows: Rows, code: str, kept: list[float], reply: str, encoding: str
) -> None:
    pair = Pair(reply=reply, encoding=encoding)
    pair.send([(1.0, 0, 0)])
    assert pair.hear() == []
    pair.send(rows)
    assert not pair.client.answered
    assert pair.hear() == [code]
    assert pair.client.answered
    assert pair.times() == [1.0, *kept]
    pair.send([(2.0, 0, 0)])
    assert not pair.client.answered
    assert pair.hear() == []
    assert pair.client.answered
    assert pair.times() == [2.0]


@pytest.mark.parametrize("together", [False, True], ids=["one by one", "giving way"])
@pytest.mark.parametrize("rows", [rows for rows, *_ in BAD.values()], ids=BAD)
def test_frames_sent_before_the_refusal_was_heard(rows: Rows, together: bool) -> None:
    """All is sent before an answer is heard; ``together``: the newest prediction speaks for all."""
    pair = Pair(reply="event")
    answers = []
    for part in ([(0.8, 0, 0)], [(1.0, 0, 0)], rows, [(1.6, 0, 0), (1.6, 1, 0)], [(2.0, 0, 0)]):
        pair.send(part)
        if not together:
            answers += pair.session.outbox.take()
    refused = 0
    for frame in answers or pair.session.outbox.take():
        assert not pair.client.answered
        try:
            pair.client.receive(frame)
        except ServiceError:
            refused += 1
    assert refused == 1
    assert pair.client.answered
    assert pair.times()[-1] == 2.0
    assert len(pair.client.notices) == together


def test_a_refused_first_event_leaves_the_start_over_in_force() -> None:
    pair = Pair(reply="event")
    pair.send([(9.0, 0, 0)])
    pair.tell(pair.client.reset_frame())
    pair.send([(0.0, math.nan, 0)])
    pair.send([(1.0, 0, 0)])
    assert pair.hear() == ["bad_field"]
    assert pair.client.answered
    pair.send([(0.9, 0, 0)])
    assert pair.hear() == ["out_of_order"]
    assert pair.client.answered


def test_what_else_is_refused_leaves_events_awaited() -> None:
    pair = Pair()
    pair.tell(pair.client.configure_frame(predictor="nobody"))
    pair.send([(1.0, 0, 0)])
    refusal, prediction = pair.session.outbox.take()
    with pytest.raises(ServiceError, match="unknown_predictor"):
        pair.client.receive(refusal)
    assert not pair.client.answered
    pair.client.receive(prediction)
    assert pair.client.answered


def test_the_call_after_a_refusal_gives_what_comes_after() -> None:
    with Listener() as listener, connect(listener.url, predictor="hold", timeout_s=300.0) as connection:
        connection.send([(1.0, 0, 0)])
        connection.send([(1e12, 0, 0)])
        connection.send([(2.0, 0, 0)])
        heard = []
        with pytest.raises(ServiceError, match=r"bad_field at \$\.events\[0\]\[0\]"):
            heard.extend(connection.predictions())
        heard.extend(connection.predictions())
        assert [p.t for p in heard] == [1.0, 2.0]
        connection.send([(0.5, 0, 0)])
        with pytest.raises(ServiceError, match="out_of_order"):
            connection.columns()
        assert len(connection.columns()) == 0


def test_the_call_after_a_refusal_for_asyncio() -> None:
    async def talk(url: str) -> None:
        async with await connect_async(url, predictor="hold", timeout_s=300.0) as connection:
            await connection.send([(1.0, math.nan, 0)])
            with pytest.raises(ServiceError, match="bad_field"):
                await connection.columns()
            assert len(await connection.columns()) == 0

    with Listener() as listener:
        asyncio.run(talk(listener.url))


def test_a_welcome_forgets_nothing_that_was_asked() -> None:
    pair = Pair()
    pair.send([(1.0, 0, 0)])
    pair.tell(pair.client.configure_frame(predictor="linear"))
    assert not pair.client.answered
    assert pair.hear() == []
    pair.client.configured(predictor="linear")
    assert isinstance(pair.client.greeting, Welcome)
    pair.send([(0.5, 0, 0)])  # another predictor begins without memory
    assert pair.hear() == []
    assert pair.client.answered


def test_after_a_change_of_the_predictor_no_time_is_late() -> None:
    """A frame that begins before the last event and ends after it is answered whole: no error is awaited."""
    pair = Pair()
    pair.send([(1.0, 0, 0)])
    pair.tell(pair.client.configure_frame(predictor="linear"))
    assert pair.hear() == []
    pair.client.configured(predictor="linear")
    pair.send([(0.5, 0, 0), (1.5, 0, 0)])
    assert pair.hear() == []
    assert pair.client.answered
    assert pair.times() == [1.0, 1.5]


def test_changes_that_are_none_for_the_service_are_none_for_the_client() -> None:
    """Both still answer each event, and refuse a time before the newest."""
    pair = Pair(reply="event", encoding="json")
    pair.send([(1.0, 0, 0)])
    nothing: dict[str, Any] = {"predictor": None, "parameters": {}, "reply": None}
    pair.tell(pair.client.configure_frame(**nothing))
    assert pair.hear() == []
    pair.client.configured(**nothing)
    assert pair.client.hello.reply == "event"
    pair.send([(0.5, 0, 0), (1.5, 0, 0), (2.0, 0, 0)])
    answers = pair.session.outbox.take()
    assert len(answers) == 3
    codes = []
    for frame in answers:
        assert not pair.client.answered
        codes += pair.take_in([frame])
    assert codes == ["out_of_order"]
    assert pair.client.answered
    assert pair.times() == [1.0, 1.5, 2.0]


def test_the_newest_of_equal_times_speaks_for_those_that_gave_way() -> None:
    pair = Pair()
    for x in range(3):
        pair.send([(1.0, x, 0)])
    assert pair.hear() == []
    assert pair.client.answered


TIMES = st.sampled_from([0.0, 1.0, 1.0, 2.0, 3.0, 4.0, 1e12, math.nan])
STEPS = st.lists(
    st.one_of(st.lists(TIMES, min_size=1, max_size=3), st.sampled_from(["reset", "hear"])), max_size=12
)


@given(steps=STEPS, reply=st.sampled_from(["frame", "event"]))
def test_whatever_is_sent_the_last_answer_is_the_last_awaited(steps: list[Any], reply: str) -> None:
    """Answers are heard later than they are made, one frame after another."""
    pair = Pair(reply=reply)
    answers: deque[list[str | bytes]] = deque()
    for step in steps:
        if step == "reset":
            pair.tell(pair.client.reset_frame())
        elif step == "hear" and answers:
            assert not pair.client.answered
            pair.take_in(answers.popleft())
        elif isinstance(step, list):
            pair.send([(t, 0.0, 0.0) for t in step])
            answers.append(pair.session.outbox.take())
    for frames in answers:
        assert not pair.client.answered
        pair.take_in(frames)
    assert pair.client.answered


@given(steps=STEPS, reply=st.sampled_from(["frame", "event"]))
def test_replaced_predictions_leave_nothing_unanswered(steps: list[Any], reply: str) -> None:
    pair = Pair(reply=reply)
    for step in steps:
        if step == "reset":
            pair.tell(pair.client.reset_frame())
        elif step == "hear":
            pair.hear()
            assert pair.client.answered
        else:
            pair.send([(t, 0.0, 0.0) for t in step])
            assert not pair.client.answered
    pair.hear()
    assert pair.client.answered
