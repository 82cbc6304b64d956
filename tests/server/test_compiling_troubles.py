"""What goes wrong while a first start compiles: clients are served all the same, and nothing grows."""

from __future__ import annotations

import asyncio
import logging
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from typing import Any

import pytest
from httpx2 import get

from pointpred.registry import RECOMMENDED, REGISTRY
from pointpred_server.compiling import compiler as room
from pointpred_server.compiling.compiler import Compiler
from pointpred_server.compiling.order import PartQueue
from pointpred_server.compiling.parts import PIECES, TARGETS, Part
from pointpred_server.compiling.process import LOW_PRIORITY, NICENESS
from pointpred_server.service import Service
from tests.server.compiler import Awaited, FakeProcesses
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, running

NAMES = [RECOMMENDED, "hold", "ktm", "switched"]


class Dying(FakeProcesses):
    """A process that ends at the names in ``deadly``; ``started`` counts how often one was asked for."""

    def __init__(self, *deadly: str) -> None:
        super().__init__()
        self.deadly = list(deadly)
        self.started = 0
        self.allow()

    def __call__(self) -> FakeProcesses:
        self.started += 1
        return self

    def compile(self, name: str) -> bool:
        if name in self.deadly:
            self.deadly.remove(name)
            return False
        return super().compile(name)


def compiled(process: Callable[[], Any], parts: list[Part]) -> Compiler:
    compiling = Compiler(parts, process)
    compiling.start()
    compiling.join()
    return compiling


def steps(caplog: pytest.LogCaptureFixture) -> list[tuple[int, str]]:
    """How many were done, and what was next, of each entry about a step."""
    entries = [one.args for one in caplog.records if "of %d" in str(one.msg)]
    return [(args[0], args[2]) for args in entries if isinstance(args, tuple)]  # type: ignore[misc]


def warnings(caplog: pytest.LogCaptureFixture) -> int:
    return sum(one.levelno >= logging.WARNING for one in caplog.records)


def test_names_that_are_no_parts_are_not_kept() -> None:
    order = PartQueue([Part(name, lambda: None, ()) for name in NAMES], ())
    for i in range(100):
        order.prefer([f"nobody {i}", "ktm"])
    assert set(order._preferred) <= set(NAMES)


def test_who_misses_nothing_moves_nothing_to_the_front() -> None:
    compiler = FakeProcesses()
    compiling = compiler.compiling(NAMES)
    asyncio.run(compiling.until(["switched"]))  # nothing has begun
    part = compiling._queue.take()
    assert part is not None
    assert part.name == RECOMMENDED
    assert [one.name for one in compiling._queue.waiting] == NAMES[1:]


def test_a_part_that_is_taken_is_never_out_of_sight() -> None:
    seen: list[bool] = []

    class Watched(list[Part]):
        def __delitem__(self, place: Any) -> None:
            super().__delitem__(place)
            seen.append(order.finished)

    order = PartQueue([Part("hold", lambda: None, ())], ())
    order.waiting = Watched(order.waiting)
    order.take()
    assert seen == [False]


def test_who_waited_on_a_loop_that_has_closed_disturbs_nobody() -> None:
    class Closing:
        def is_closed(self) -> bool:
            return False

        def call_soon_threadsafe(self, call: object) -> None:
            raise RuntimeError("Event loop is closed")

    compiler = FakeProcesses()
    compiler.allow()
    compiling = compiler.compiling(NAMES)
    compiling._waiting.add((Closing(), asyncio.Event()))  # type: ignore[arg-type]
    compiling.start()
    compiling.join()
    assert compiling.over


def test_without_processes_a_thread_compiles(
    caplog: pytest.LogCaptureFixture,
) -> None:
    threads: list[str] = []

    def refused() -> FakeProcesses:
        raise BlockingIOError(11, "no more processes")

    def prepare(service: Service) -> None:
        parts = [Awaited(name, lambda: threads.append(threading.current_thread().name), ()) for name in NAMES]
        service.compiler = Compiler(parts, refused)  # type: ignore[arg-type]

    with running(prepare) as here:
        soon(lambda: get(f"{here.url}/readyz", timeout=PATIENCE_S).status_code == 200, "ready")
        here.service.compiler.join()
        assert here.service.compiler.failed == set()
    assert len(threads) == len(NAMES)
    assert all(name.startswith("compiling") for name in threads)
    assert warnings(caplog) == 1


def test_a_process_that_dies_is_replaced(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(room, "_processors", lambda: 1)
    dying = Dying("hold")
    compiling = compiled(dying, [Awaited(name, lambda: None, ()) for name in NAMES])
    assert dying.started == 2
    assert [name for name in dying.asked if name != LOW_PRIORITY] == NAMES
    assert compiling.failed == set()
    assert warnings(caplog) == 1


def test_processes_that_die_again_and_again_are_given_up(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(room, "_processors", lambda: 1)
    ran: list[str] = []
    dying = Dying(*100 * [RECOMMENDED])
    parts = [Awaited(name, lambda name=name: ran.append(name), ()) for name in NAMES]  # type: ignore[misc]
    compiling = compiled(dying, parts)
    assert dying.started == 1 + room.REPLACEMENTS == warnings(caplog)
    assert dying.ended == dying.started
    assert ran == NAMES
    assert compiling.ready(RECOMMENDED)


def test_what_failed_is_not_among_the_ready() -> None:
    def broken() -> None:
        raise RuntimeError("no compiler")

    compiling = compiled(FakeProcesses(), [Part("hold", broken, ()), Part("ktm", lambda: None, ())])
    assert compiling.progress().ready == ["ktm"]


@pytest.mark.skipif(not hasattr(os, "nice"), reason="no niceness here")
def test_a_process_of_a_nice_service_stays_as_nice_as_it_is() -> None:
    most = NICENESS + 4
    more = most - os.nice(0)
    command = ["nice", "-n", str(more), sys.executable, "-m", "pointpred_server.compiling.process"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(LOW_PRIORITY.encode() + b"\n")
        process.stdin.flush()
        assert process.stdout.readline() == b"\n"
        assert os.getpriority(os.PRIO_PROCESS, process.pid) == most
        process.stdin.close()


def test_each_step_is_logged_once_and_in_order(
    caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(room, "_processors", lambda: 2)
    caplog.set_level(logging.INFO)
    compiler = FakeProcesses()
    anybody, person, whole, motions = PIECES
    after = {whole: (anybody, person), RECOMMENDED: PIECES}
    names = [*PIECES, RECOMMENDED, TARGETS, *(name for name in REGISTRY if name != RECOMMENDED)]
    parts = [Awaited(name, lambda: None, (), after.get(name, ())) for name in names]
    compiling = Compiler(parts, compiler)  # type: ignore[arg-type]
    compiling.start()
    compiler.allow(anybody, motions)
    soon(lambda: TARGETS in compiler.asked, "another part is under way")
    compiler.allow(*PIECES, RECOMMENDED)  # while that one is not done
    soon(lambda: compiling.ready(RECOMMENDED), "the first is ready")
    compiler.allow()
    compiling.join()
    logged = steps(caplog)
    done, following = [one for one, _ in logged], [name for _, name in logged]
    assert following[:2] == [RECOMMENDED, TARGETS]
    assert done[:2] == [0, 1]
    assert done == sorted(done)
    assert len(set(following)) == len(following)
    assert sum("Compiled" in one.message for one in caplog.records) == 1
