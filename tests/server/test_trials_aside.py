"""A trial is scored beside the event loop: others are served meanwhile, and answers keep their order."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest
from websockets.exceptions import ConnectionClosed

import pointpred_server.sessions.trials
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, Running, running, told

START = '{"type":"trial","action":"start"}'
END = '{"type":"trial","action":"end"}'


def event(t: float) -> str:
    return f'{{"type":"events","events":[[{t},{10 * t},6,null,null,0]]}}'


class Held:
    """Scoring that waits until it may go on."""

    def __init__(self) -> None:
        self.begun = threading.Event()
        self.go = threading.Event()
        self.fails = False


@pytest.fixture
def held(monkeypatch: pytest.MonkeyPatch) -> Iterator[Held]:
    here, real = Held(), pointpred_server.sessions.trials.prepare

    def slow(*arguments: object, **options: object) -> object:
        here.begun.set()
        assert here.go.wait(PATIENCE_S)
        if here.fails:
            raise RuntimeError("at 7315.25")
        return real(*arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr("pointpred_server.listening.CLOSE_S", PATIENCE_S)
    monkeypatch.setattr(pointpred_server.sessions.trials, "prepare", slow)
    yield here
    here.go.set()


@pytest.fixture
def service(held: Held) -> Iterator[Running]:
    with running() as here:
        yield here
        held.go.set()


def test_others_are_served_meanwhile_and_answers_keep_their_order(service: Running, held: Held) -> None:
    with service.greeted() as other, service.greeted() as socket:
        for frame in (START, event(1.0), END, event(2.0), '{"type":"targets","targets":[]}'):
            socket.send(frame)
        assert told(socket)["t"] == 1.0
        assert held.begun.wait(PATIENCE_S)
        for i in range(20):
            other.send(event(float(i)))
            assert told(other)["t"] == i
        with pytest.raises(TimeoutError):
            socket.recv(0.2)
        held.go.set()
        assert [told(socket)["type"] for _ in range(3)] == ["score", "prediction", "targets"]


def test_a_client_that_leaves_meanwhile_is_let_go(service: Running, held: Held) -> None:
    with service.greeted(close_timeout=0.5) as socket:  # it leaves without an answer to its goodbye
        for frame in (START, event(1.0), END):
            socket.send(frame)
        assert held.begun.wait(PATIENCE_S)
    held.go.set()
    soon(lambda: not service.service._open, "the session is over")
    with service.greeted() as other:
        other.send(event(1.0))
        assert told(other)["t"] == 1.0


def test_scoring_that_breaks_ends_that_session_only(service: Running, held: Held) -> None:
    with service.greeted() as other, service.greeted() as socket:
        held.fails = True
        held.go.set()
        for frame in (START, END):
            socket.send(frame)
        assert told(socket)["code"] == "internal"
        other.send(event(1.0))
        assert told(other)["t"] == 1.0


def test_a_service_that_stops_meanwhile_says_the_score_first(service: Running, held: Held) -> None:
    with service.greeted() as socket:
        for frame in (START, END):
            socket.send(frame)
        assert held.begun.wait(PATIENCE_S)
        service.server.should_exit = True
        soon(lambda: service.service.stopping, "stopping")
        held.go.set()
        assert [told(socket)["type"] for _ in range(2)] == ["score", "bye"]
        with pytest.raises(ConnectionClosed):
            socket.recv(PATIENCE_S)
        assert socket.close_code == 1001
