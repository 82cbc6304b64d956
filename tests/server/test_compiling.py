"""Who comes while a first start compiles: served by what is ready, and waiting for just what is not."""

from __future__ import annotations

import asyncio
import json
import os
import subprocess
import sys
import threading
from collections.abc import Iterator

import pytest
from httpx2 import get
from websockets.exceptions import ConnectionClosed

from pointpred.compiled import COMPILED
from pointpred.registry import RECOMMENDED, REGISTRY
from pointpred_server.compiling import compiler as room
from pointpred_server.compiling.compiler import Compiler
from pointpred_server.compiling.order import PartQueue
from pointpred_server.compiling.parts import (
    ASSISTANCE,
    PIECES,
    TARGETS,
    TRIALS,
    Part,
    parts,
    parts_for,
    predict,
)
from pointpred_server.compiling.process import LOW_PRIORITY, CompilerProcess
from pointpred_server.service import Service
from tests.server.compiler import Awaited, FakeProcesses
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, Running, running

OTHERS = [name for name in REGISTRY if name != RECOMMENDED]
EVENT = '{"type":"events","events":[[%s,5,6,null,null,0]]}'
WELCOME, PREDICTION = "welcome", "prediction"


def hello(predictor: str = RECOMMENDED) -> str:
    return json.dumps({"type": "hello", "version": 1, "predictor": predictor})


@pytest.fixture
def compiler(monkeypatch: pytest.MonkeyPatch) -> Iterator[FakeProcesses]:
    for name in (RECOMMENDED, "ktm", "switched"):
        predict(name)  # here, where nobody waits for the compiler
    monkeypatch.setattr(room, "_processors", lambda: 1)
    one = FakeProcesses()
    yield one
    one.allow()


@pytest.fixture
def here(compiler: FakeProcesses) -> Iterator[Running]:
    def prepare(service: Service) -> None:
        service.compiler = compiler.compiling([RECOMMENDED, TARGETS, TRIALS, *OTHERS])

    with running(prepare, max_sessions=3) as one:
        yield one
        compiler.allow()


def ready(here: Running) -> bool:
    return get(f"{here.url}/readyz", timeout=PATIENCE_S).status_code == 200


def test_the_recommended_predictor_is_compiled_first() -> None:
    order = PartQueue(parts(), room.FIRST)
    names = []
    while (part := order.take()) is not None:
        names.append(part.name)
        order.finish(part.name)
    assert names[:5] == [*PIECES, RECOMMENDED]
    assert [name for name in names if name in REGISTRY] == [RECOMMENDED, *OTHERS]
    assert {TARGETS, ASSISTANCE, TRIALS} < set(names)


def test_a_part_waits_for_the_parts_it_is_made_of() -> None:
    order = PartQueue(parts(), room.FIRST)
    begun = [order.take() for _ in range(4)]
    anybody, person, whole, motions = PIECES
    assert [part and part.name for part in begun] == [anybody, person, motions, None]
    order.finish(anybody)
    assert order.take() is None
    order.finish(person)
    assert getattr(order.take(), "name", None) == whole
    order.finish(motions)
    order.finish(whole)
    assert getattr(order.take(), "name", None) == RECOMMENDED
    assert order.take() is None  # nothing delays the first answer
    order.finish(RECOMMENDED)
    assert getattr(order.take(), "name", None) == TARGETS


def test_preferred_parts_come_after_the_first_ones() -> None:
    order = PartQueue(parts(), room.FIRST)
    order.prefer(["ktm"])
    order.prefer(["switched", "ktm"])
    names = []
    while (part := order.take()) is not None:
        names.append(part.name)
        order.finish(part.name)
    assert names[5:7] == ["ktm", "switched"]


def test_names_of_one_class_are_not_compiled_at_the_same_time() -> None:
    order = PartQueue(parts(), room.FIRST)
    while RECOMMENDED not in order.done:
        order.finish(getattr(order.take(), "name", ""))
    order.prefer(["kep-quartic", "ktm"])
    begun: list[str] = []
    while (part := order.take()) is not None:
        begun.append(part.name)
    assert [name for name in begun if name.startswith("kep")] == ["kep-quadratic"]
    assert begun.index("kep-quadratic") < begun.index("ktm") < begun.index(TRIALS)
    order.finish("kep-quadratic")
    assert getattr(order.take(), "name", None) == "kep-quartic"


@pytest.mark.parametrize(
    ("message", "wanted"),
    [
        ({"type": "hello", "version": 1, "predictor": "ktm"}, ["ktm"]),
        ({"type": "hello", "version": 1, "predictor": "ktm", "assist": {}}, ["ktm", ASSISTANCE]),
        (
            {"type": "configure", "predictor": "hold", "parameters": {"differentiator": "kalman"}},
            ["hold", "differentiator kalman"],
        ),
        ({"type": "configure", "reply": "event"}, []),
        ({"type": "targets", "targets": [{"id": "a", "x": 1, "y": 2, "width": 3, "height": 4}]}, [TARGETS]),
        ({"type": "targets", "targets": []}, []),
        ({"type": "trial", "action": "end"}, [TRIALS]),
        ({"type": "trial", "action": "start"}, []),
        ({"type": "events", "events": [[1, 2, 3, None, None, 0]]}, []),
        ({"type": "nonsense"}, []),
    ],
)
def test_what_a_message_needs(message: dict[str, object], wanted: list[str]) -> None:
    assert parts_for(json.dumps(message)) == wanted
    assert set(wanted) <= {part.name for part in parts()}


def test_a_ready_predictor_is_served_while_others_compile(here: Running, compiler: FakeProcesses) -> None:
    with here.connect() as early, here.connect() as other:
        early.send(hello())
        with pytest.raises(TimeoutError):
            early.recv(0.2)
        assert not ready(here)
        assert get(f"{here.url}/healthz", timeout=PATIENCE_S).status_code == 200
        compiler.allow(RECOMMENDED)
        assert json.loads(early.recv(PATIENCE_S))["type"] == WELCOME
        soon(lambda: ready(here), "ready")
        other.send(hello("ktm"))  # the last but four
        for i in range(20):
            early.send(EVENT % i)
            assert json.loads(early.recv(PATIENCE_S))["t"] == i
        soon(lambda: here.service.compiler._waiting, "the other one waits")
        compiler.allow(TARGETS, "ktm")
        assert json.loads(other.recv(PATIENCE_S))["type"] == WELCOME
        assert [name for name in compiler.asked if name != LOW_PRIORITY][:3] == [RECOMMENDED, TARGETS, "ktm"]
        assert compiler.asked.index(LOW_PRIORITY) == 1


def test_a_message_waits_for_what_it_needs_and_answers_keep_their_order(
    here: Running, compiler: FakeProcesses
) -> None:
    compiler.allow(RECOMMENDED)
    with here.connect() as socket:
        socket.send(hello())
        assert json.loads(socket.recv(PATIENCE_S))["type"] == WELCOME
        socket.send(EVENT % 1)
        assert json.loads(socket.recv(PATIENCE_S))["t"] == 1.0
        socket.send('{"type":"configure","predictor":"switched"}')
        for t in range(2, 20):
            socket.send(EVENT % t)
        with pytest.raises(TimeoutError):
            socket.recv(0.2)
        compiler.allow()
        assert json.loads(socket.recv(PATIENCE_S))["predictor"] == "switched"
        last = 1.0
        while last < 19.0:  # predictions may give way to newer ones
            answer = json.loads(socket.recv(PATIENCE_S))
            assert answer["type"] == PREDICTION, answer
            assert answer["t"] > last
            last = answer["t"]
        soon(lambda: here.service.compiler.over, "all is compiled")
        socket.send(EVENT % 20)
        assert json.loads(socket.recv(PATIENCE_S))["t"] == 20.0
        ((connection, _),) = here.service._open.values()
        assert connection is not None
        assert connection.prepare is None, "what follows is not looked at any more"


def test_what_is_compiled_is_told(here: Running, compiler: FakeProcesses) -> None:
    def told() -> dict[str, object]:
        answer: dict[str, object] = get(f"{here.url}/v1/compiling", timeout=PATIENCE_S).json()
        return answer

    count, recommended = len(REGISTRY), {"recommended": RECOMMENDED}
    soon(lambda: told()["next"] == RECOMMENDED, "it has begun")
    assert told() == {"done": 0, "of": count, "next": RECOMMENDED, "ready": [], **recommended}
    compiler.allow(RECOMMENDED, TARGETS, TRIALS)
    soon(lambda: told()["next"] == OTHERS[0], "the others follow")
    assert told() == {"done": 1, "of": count, "next": OTHERS[0], "ready": [RECOMMENDED], **recommended}
    compiler.allow()
    soon(lambda: told()["next"] is None, "all is done")
    assert told() == {"done": count, "of": count, "next": None, "ready": list(REGISTRY), **recommended}
    assert compiler.ended == 1


def test_a_waiting_client_counts_and_is_told_of_a_stop(here: Running) -> None:
    with here.connect() as early, here.connect(), here.connect():
        early.send(hello())
        with here.connect() as fourth:
            assert json.loads(fourth.recv(PATIENCE_S))["code"] == "too_many"
        here.server.should_exit = True
        assert json.loads(early.recv(PATIENCE_S))["type"] == "bye"
        with pytest.raises(ConnectionClosed) as closed:
            early.recv(PATIENCE_S)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1001


def test_who_leaves_while_it_waits_leaves_its_place(here: Running) -> None:
    for said in ([], [hello()], [hello()] + 100 * ['{"type":"reset"}']):
        with here.connect(), here.connect(), here.connect() as early:
            for text in said:
                early.send(text)
            soon(lambda: here.service.full, "they wait")
        soon(lambda: not here.service._open, "their places are free")
    assert get(f"{here.url}/metrics", timeout=PATIENCE_S).status_code == 200


def test_waiting_for_the_compiler_is_not_idleness(compiler: FakeProcesses) -> None:
    def prepare(service: Service) -> None:
        service.compiler = compiler.compiling([RECOMMENDED])

    with running(prepare) as here, here.connect() as early:
        early.send(hello())
        soon(lambda: any(one.waits_for_compiler for one in here.service._open), "it waits")
        (session,) = here.service._open
        session.tick(session.last_received + 1e6)
        assert session.close is None
        compiler.allow()
        assert json.loads(early.recv(PATIENCE_S))["type"] == WELCOME
        assert not session.waits_for_compiler


def test_a_recording_is_scored_once_its_predictors_are_compiled(
    here: Running, compiler: FakeProcesses
) -> None:
    body = "user,trial,t_s,x_px,y_px\n" + "".join(f"ann,1,{i / 100},{7 * i},{3 * i}\n" for i in range(60))
    compiler.allow(RECOMMENDED, TARGETS)
    answers: list[int] = []

    def post() -> None:
        from httpx2 import post

        answer = post(f"{here.url}/v1/score?predictors=switched", content=body, timeout=PATIENCE_S)
        answers.append(answer.status_code)

    poster = threading.Thread(target=post)
    poster.start()
    soon(lambda: here.service.compiler._waiting, "it waits")
    compiler.allow(TRIALS)
    soon(lambda: "switched" in compiler.asked, "it is next")
    assert not answers
    compiler.allow("switched")
    poster.join(PATIENCE_S)
    assert answers == [200]
    assert "linear" not in compiler.asked


def test_a_part_that_fails_is_logged_and_clients_are_served(
    caplog: pytest.LogCaptureFixture,
) -> None:
    def broken() -> None:
        raise RuntimeError("no compiler")

    def prepare(service: Service) -> None:
        service.compiler = Compiler([Part(RECOMMENDED, broken, ())])

    with running(prepare) as here, here.greeted(hello()):
        assert get(f"{here.url}/readyz", timeout=PATIENCE_S).json() == {"ready": False, "stopping": False}
    assert "could not be compiled" in caplog.text


def test_what_is_in_the_cache_needs_no_process_and_is_not_spoken_of(caplog: pytest.LogCaptureFixture) -> None:
    compiler, ran = FakeProcesses(), []
    names = list(REGISTRY)
    compiling = Compiler([Part(name, lambda name=name: ran.append(name), ()) for name in names], compiler)  # type: ignore[arg-type, misc]
    compiling.start()
    compiling.join()
    assert sorted(ran) == sorted(names)
    assert compiler.asked == []
    assert not compiling.compiled_any
    assert "ompil" not in caplog.text


def test_a_service_that_stops_gives_up_what_is_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[subprocess.Popen[bytes]] = []

    class Endless(CompilerProcess):
        def __init__(self) -> None:
            command = [sys.executable, "-c", "import sys, time; print(flush=True); time.sleep(600)"]
            self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
            started.append(self.process)
            assert self.process.stdout is not None
            self.process.stdout.readline()

    monkeypatch.setattr(room, "_processors", lambda: 2)
    compiling = Compiler([Awaited(name, lambda: None, ()) for name in OTHERS], Endless)
    compiling.start()
    soon(lambda: len(started) == 2, "both work")
    compiling.stop()
    compiling.join()
    assert [one.poll() is not None for one in started] == [True, True]
    assert compiling.over


def test_until_ends_for_unknown_names_and_before_the_start() -> None:
    compiler = FakeProcesses()
    asyncio.run(compiler.compiling([RECOMMENDED]).until([RECOMMENDED]))
    compiling = compiler.compiling([RECOMMENDED])
    compiling.start()
    asyncio.run(compiling.until(["no such predictor"]))
    compiler.allow()
    compiling.join()


def test_a_process_compiles_what_is_named_and_ends_with_who_asked() -> None:
    process = CompilerProcess()
    try:
        for name in (LOW_PRIORITY, LOW_PRIORITY, "no such part", "hold"):
            process.compile(name)
            assert process.process.poll() is None
        assert os.getpriority(os.PRIO_PROCESS, process.process.pid) > os.getpriority(os.PRIO_PROCESS, 0)
        assert process.process.stdin is not None
        process.process.stdin.close()
        assert process.process.wait(30) == 1
    finally:
        process.process.kill()
        assert process.process.stdout is not None
        process.process.stdout.close()
        process.process.wait()


def test_a_process_that_has_ended_keeps_nobody_waiting() -> None:
    process = CompilerProcess()
    process.kill()
    process.process.wait()
    process.compile("hold")
    process.compile("hold")
    process.end()


@pytest.mark.skipif(not COMPILED, reason="plain Python compiles nothing")
def test_a_session_whose_parts_are_ready_compiles_and_loads_nothing() -> None:
    """In a process of its own, which has compiled nothing for other tests: only the parts it waits for."""
    program = """
import json
from numba.core.dispatcher import Dispatcher
from pointpred_server.compiling.parts import parts_for
from pointpred_server.compiling.parts import HELLO, parts, reach, run_session
known = {part.name: part for part in parts()}
asked, compile = [], Dispatcher.compile
def spied(self, signature):
    asked.append(f"{self.py_func.__module__}.{self.py_func.__name__}{signature}")
    return compile(self, signature)
def converse(frames):
    Dispatcher.compile = compile
    texts = [json.dumps(frame) for frame in frames if not isinstance(frame, bytes)]
    names = {name for text in texts for name in parts_for(text)}
    for name in names:
        for before in known[name].after:
            known[before].run()
        known[name].run()
    Dispatcher.compile = spied
    run_session(frames)
converse([
    {**HELLO, "predictor": "kinematic-adaptive"},
    {"type": "targets", "targets": [{"id": "a", "x": 1, "y": 2, "width": 3, "height": 4}]},
    {"type": "trial", "action": "start"},
    *({"type": "events", "events": [reach(i)]} for i in range(60)),
    {"type": "trial", "action": "end"},
    bytes(30), bytes(60),
])
converse([
    {**HELLO, "predictor": "switched", "assist": {}, "parameters": {"differentiator": "kalman"}},
    *({"type": "events", "events": [reach(i), reach(i)]} for i in range(9)),
    bytes(60),
])
print(asked)
"""
    said = subprocess.run([sys.executable, "-c", program], check=True, stdout=subprocess.PIPE, text=True)
    assert said.stdout == "[]\n"
