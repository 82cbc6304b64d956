"""Frames that wait for the work of a session, and count by the time they came, or for a busy service."""

from __future__ import annotations

import asyncio
import itertools
import json
from collections.abc import Coroutine
from concurrent.futures import Future
from typing import Any

import pytest

from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Limits
from pointpred_server.arrivals import Arrivals
from pointpred_server.connection import Connection
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.sessions.work import Completion, Work
from pointpred_server.work_threads import WorkThreads
from tests.server.fake_socket import FakeSocket
from tests.server.hurried import HurriedLoop

HELLO = '{"type":"hello","version":1,"predictor":"hold"}'
EVENT = '{"type":"events","events":[[%d,5,6,null,null,0]]}'
START, END = '{"type":"trial","action":"start"}', '{"type":"trial","action":"end"}'
FRAMES = [HELLO, START, END, *(EVENT % i for i in range(1, 9))]


class SlowThread(WorkThreads):
    """Takes a minute for anything."""

    def submit(self, work: Work) -> Future[Completion]:
        done: Future[Completion] = Future()
        asyncio.get_running_loop().call_later(60.0, lambda: done.set_result(work()))
        return done


async def session_after_frames(most: int) -> tuple[PointingSession, Connection]:
    """A session that scores a trial until all its frames have come, one a second."""
    loop = asyncio.get_running_loop()

    def write(frame: Frame) -> None:
        if session.close is not None or "8.0" in str(frame):
            socket.there.disconnect(None)

    def come() -> None:
        for place, text in enumerate(FRAMES):
            loop.call_later(1.0 * place, lambda text=text: socket.there.receive([text]))

    session, socket = PointingSession("early", Limits(max_events_per_s=most), loop.time()), FakeSocket(write)
    socket.on_attach = come
    connection = Connection(session, socket, Arrivals(), threads=SlowThread())
    await connection.run()
    return session, connection


def in_no_time(running: Coroutine[Any, Any, tuple[PointingSession, Connection]]) -> Any:
    with asyncio.Runner(loop_factory=HurriedLoop) as runner:
        return runner.run(running)


def test_frames_that_waited_are_not_a_burst() -> None:
    session, connection = in_no_time(session_after_frames(1))
    assert session.refusals == {}
    assert connection.frames == len(FRAMES)


class Late(Arrivals):
    """Everything can have waited for half a second."""

    def since(self, now: float, turn: float) -> float:
        return now - 0.5


@pytest.mark.parametrize(("together_s", "answers"), [(60.0, 8), (0.02, 1)])
def test_only_frames_that_have_waited_are_used_as_one(
    together_s: float, answers: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pointpred_server.connection.TOGETHER_S", together_s)
    monkeypatch.setattr("pointpred_server.connection.TURN_S", 60.0)
    session, socket, delays = asyncio.run(overloaded(Late(), rounds=1))
    predicted = [frame for frame in socket.written if '"prediction"' in str(frame)]
    assert len(predicted) == len(delays) == answers
    assert '"t":8.0' in str(predicted[-1])
    assert session.events == 8


def test_a_client_is_told_that_the_service_is_behind_at_most_once_a_second(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("pointpred_server.connection.TURN_S", 60.0)
    monkeypatch.setattr("pointpred_server.connection.COSTLY_S", 60.0)
    _, socket, delays = asyncio.run(overloaded(Late(), rounds=50))
    errors = [json.loads(frame) for frame in socket.written if '"slow"' in str(frame)]
    assert len(delays) == 50
    assert all(arrived >= 0.5 > taken for taken, arrived in delays)
    (behind,) = errors
    assert behind["recoverable"]
    assert 0.5 <= behind["behind_s"] < 60.0
    assert behind["path"] is None


async def overloaded(
    arrivals: Arrivals, rounds: int
) -> tuple[PointingSession, FakeSocket, list[tuple[float, float]]]:
    """A session that gets eight frames at once, in so many rounds."""
    delays: list[tuple[float, float]] = []
    session, socket = PointingSession("late", Limits(), asyncio.get_running_loop().time()), FakeSocket()

    def come() -> None:
        socket.there.receive([HELLO])
        for at in range(rounds):
            socket.there.receive([EVENT % (8 * at + i) for i in range(1, 9)])
        socket.there.disconnect(None)

    socket.on_attach = come
    await Connection(session, socket, arrivals, lambda taken, arrived: delays.append((taken, arrived))).run()
    return session, socket, delays


@pytest.mark.parametrize("together", [True, False], ids=["together", "one by one, as in fragments"])
def test_others_have_their_turn_between_frames_that_take_long(
    together: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    ticks = itertools.count()
    monkeypatch.setattr("pointpred_server.connection.perf_counter", lambda: 1e-3 * next(ticks))
    used = asyncio.run(taken_in_turns(60, together=together))
    assert used[-1] == 60
    assert len(set(used)) >= 20


@pytest.mark.parametrize("count", [64, 65, 128])
def test_a_client_is_read_again_and_its_end_noticed_whatever_has_waited(count: int) -> None:
    assert asyncio.run(taken_in_turns(count))[-1] == count


async def taken_in_turns(count: int, *, together: bool = True) -> list[int]:
    """How many of so many frames that came at once were used, at each turn of the loop; the client leaves."""
    loop, used = asyncio.get_running_loop(), []
    session, socket = PointingSession("long", Limits(), loop.time()), FakeSocket()
    running = loop.create_task(Connection(session, socket, Arrivals()).run())
    await asyncio.sleep(0)
    socket.there.receive([HELLO])
    there = socket.there
    frames = [EVENT % i for i in range(count)]
    for part in [frames] if together else [[one] for one in frames]:
        there.receive(part)
    if session.events < count:
        assert socket.paused, "what has not been used is waited for before more is read"
    there.disconnect(None)
    while not running.done():
        used.append(session.events)
        await asyncio.sleep(0)
    assert not socket.paused
    return used
