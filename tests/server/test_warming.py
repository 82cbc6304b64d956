"""Who comes before compiled code is warm: accepted at once, greeted when it is."""

from __future__ import annotations

import asyncio
import json
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator

import pytest
from httpx2 import get
from websockets.exceptions import ConnectionClosed

from pointpred.registry import REGISTRY
from pointpred.server import warm as warming
from pointpred.server.endpoint import StreamEndpoint
from pointpred.server.service import Service
from pointpred.server.settings import Settings
from tests.server.listener import soon
from tests.server.running import HELLO, PATIENCE_S, running

Progress = Callable[[int, int, str], bool]


@pytest.fixture
def warm(monkeypatch: pytest.MonkeyPatch) -> Iterator[threading.Event]:
    """Warming takes until this is set."""
    warming.warm_one("switched")  # here, where nobody waits for the compiler
    done = threading.Event()

    def slow(progress: Progress) -> None:
        while not done.wait(0.01):
            if not progress(0, 1, ""):
                return

    monkeypatch.setattr("pointpred.server.service.warm", slow)
    yield done
    done.set()


def test_who_comes_early_is_accepted_and_greeted_when_code_is_warm(warm: threading.Event) -> None:
    with running(max_sessions=2) as here, here.connect() as early, here.connect() as other:
        for socket in (early, other):
            socket.send(HELLO)
        with pytest.raises(TimeoutError):
            early.recv(0.3)
        assert "pointpred_sessions 0.0" in get(f"{here.url}/metrics", timeout=PATIENCE_S).text
        assert get(f"{here.url}/readyz", timeout=PATIENCE_S).status_code == 503
        assert get(f"{here.url}/healthz", timeout=PATIENCE_S).status_code == 200
        with here.connect() as third:  # those who wait are counted
            assert json.loads(third.recv(PATIENCE_S))["code"] == "too_many"
        warm.set()
        for socket in (early, other):
            assert json.loads(socket.recv(PATIENCE_S))["type"] == "welcome"
            socket.send('{"type":"events","events":[[1,5,6,null,null,0]]}')
            assert json.loads(socket.recv(PATIENCE_S))["t"] == 1.0
        soon(lambda: get(f"{here.url}/readyz", timeout=PATIENCE_S).status_code == 200, "ready")


def test_who_waits_for_warm_code_hears_that_the_service_stops(warm: threading.Event) -> None:
    with running() as here, here.connect() as early:
        early.send(HELLO)
        here.server.should_exit = True
        assert json.loads(early.recv(PATIENCE_S))["type"] == "bye"
        with pytest.raises(ConnectionClosed) as closed:
            early.recv(PATIENCE_S)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1001


def test_who_leaves_while_code_is_warmed_leaves_its_place(warm: threading.Event) -> None:
    with running(max_sessions=1) as here:
        for said in ([], [HELLO], [HELLO] + 100 * ['{"type":"reset"}']):
            with here.connect() as early:
                for text in said:
                    early.send(text)
                soon(lambda: here.service.full, "it waits")
            soon(lambda: not here.service.full, "its place is free")
        with here.connect() as other:
            other.send(HELLO)
            soon(lambda: here.service.full, "it waits")
            warm.set()
            assert json.loads(other.recv(PATIENCE_S))["type"] == "welcome"
        assert get(f"{here.url}/metrics", timeout=PATIENCE_S).status_code == 200


def test_no_place_is_free_between_waiting_for_warm_code_and_the_session() -> None:
    async def talk() -> list[bool]:
        service = Service(Settings(max_sessions=1))
        warmed = service._warming = asyncio.get_running_loop().create_future()
        frames: asyncio.Queue[dict[str, str]] = asyncio.Queue()
        frames.put_nowait({"type": "websocket.connect"})

        async def send(message: object) -> None:
            """Nobody hears it."""

        scope = {"type": "websocket", "headers": [], "query_string": b""}
        task = asyncio.ensure_future(StreamEndpoint(service)(scope, frames.get, send))
        while not service.full:
            await asyncio.sleep(0)
        warmed.set_result(None)
        full = []
        while not service._open:
            await asyncio.sleep(0)
            full.append(service.full)
        frames.put_nowait({"type": "websocket.disconnect"})
        await task
        return full

    full = asyncio.run(talk())
    assert len(full) > 1
    assert all(full)


def test_frames_that_came_early_are_answered_in_their_order(warm: threading.Event) -> None:
    with running() as here, here.connect() as early:
        early.send(HELLO)
        for t in range(20):
            early.send(f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}')
        soon(lambda: here.service._waiting == 1, "it waits")
        warm.set()
        assert json.loads(early.recv(PATIENCE_S))["type"] == "welcome"
        last = -1.0
        while last < 19.0:  # predictions may give way to newer ones
            answer = json.loads(early.recv(PATIENCE_S))
            assert answer["type"] == "prediction", answer
            assert answer["t"] > last
            last = answer["t"]


def test_code_that_cannot_be_warmed_is_logged_and_clients_are_served_all_the_same(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def broken(progress: Progress) -> None:
        raise RuntimeError("no compiler")

    monkeypatch.setattr("pointpred.server.service.warm", broken)
    with running() as here, here.greeted():
        assert get(f"{here.url}/readyz", timeout=PATIENCE_S).json() == {"ready": False, "stopping": False}
    assert "compiled code could not be warmed" in caplog.text


@pytest.mark.parametrize("goes_on", [True, False])
def test_a_helper_compiles_meanwhile_and_ends_with_the_warming(
    monkeypatch: pytest.MonkeyPatch, goes_on: bool
) -> None:
    started: list[subprocess.Popen[bytes]] = []

    def helper() -> subprocess.Popen[bytes]:
        started.append(subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"]))
        return started[-1]

    warmed: list[str] = []
    monkeypatch.setattr(warming, "warm_one", warmed.append)
    monkeypatch.setattr(warming, "_helper", helper)
    monkeypatch.setattr(warming, "_processors", lambda: 2)
    monkeypatch.setattr(warming, "awaits_compiling", lambda law: False)
    warming.warm()
    assert warmed == list(REGISTRY)
    assert not started, "what was in the cache needs no help"
    monkeypatch.setattr(warming, "awaits_compiling", lambda law: True)
    warming.warm(lambda done, of, name: goes_on or done < 3)
    (one,) = started
    assert one.poll() is not None
    assert warmed[len(REGISTRY) :] == list(REGISTRY)[: None if goes_on else 3]


def test_the_helper_is_a_program_that_warms_every_predictor_from_the_last_on() -> None:
    spied = (
        "import pointpred.registry as known, runpy; build = known.build\n"
        "known.build = lambda name, **all: print(name) or build(name, **all)\n"
        "import pointpred.server.sessions.session\n"
        "runpy.run_module('pointpred.server.warm', run_name='__main__')"
    )
    helper = subprocess.Popen(
        [sys.executable, "-c", spied], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert helper.stdout is not None
    with helper:
        said = helper.stdout.read().split()  # its input stays open: who asked for help lives
    assert set(said) == REGISTRY.keys()
    assert said[:2] == list(reversed(REGISTRY))[:2]
    assert helper.returncode == 0


def test_the_helper_ends_when_who_asked_for_it_has_ended() -> None:
    helper = subprocess.Popen([sys.executable, "-m", "pointpred.server.warm"], stdin=subprocess.PIPE)
    with helper:
        assert helper.stdin is not None
        helper.stdin.close()
        assert helper.wait(30) == 1


def test_a_session_after_warming_compiles_and_loads_nothing() -> None:
    """In a process of its own, which has compiled nothing for other tests."""
    program = """
from numba.core.dispatcher import Dispatcher
from pointpred.server import warm
warm.warm()
asked, compile = [], Dispatcher.compile
def spied(self, signature):
    asked.append(f"{self.py_func.__module__}.{self.py_func.__name__}{signature}")
    return compile(self, signature)
Dispatcher.compile = spied
warm.talk([
    {"type": "hello", "version": 1, "predictor": "kinematic", "device": {"cpi": 800}},
    {"type": "targets", "targets": [{"id": "a", "x": 1, "y": 2, "width": 3, "height": 4}]},
    {"type": "trial", "action": "start"},
    *({"type": "events", "events": [warm.reach(i)]} for i in range(60)),
    {"type": "trial", "action": "end"},
])
warm.talk([
    {"type": "hello", "version": 1, "predictor": "switched", "device": {"cpi": 800}, "assist": {}},
    *({"type": "events", "events": [warm.reach(i), warm.reach(i)]} for i in range(9)),
    bytes(60),
])
print(asked)
"""
    said = subprocess.run([sys.executable, "-c", program], check=True, stdout=subprocess.PIPE, text=True)
    assert said.stdout == "[]\n"
