"""The parts of a service of several processes, each alone."""

from __future__ import annotations

import asyncio
import signal
import socket
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, cast

import pytest
from httpx2 import get
from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram

from pointpred.errors import ParameterError, SourceError
from pointpred.live.run import page_opener
from pointpred_server.cli.serve import serve
from pointpred_server.listening import listen
from pointpred_server.settings import Settings
from pointpred_server.workers import restarts
from pointpred_server.workers import supervisor as supervisor_module
from pointpred_server.workers.counts import WorkerCounts
from pointpred_server.workers.dispatcher import Dispatcher
from pointpred_server.workers.families import Family, ServiceFamilies, families_of, text_of
from pointpred_server.workers.process import WorkerProcess
from pointpred_server.workers.supervisor import Supervisor
from pointpred_server.workers.worker import OtherWorkers
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, running

pytestmark = pytest.mark.skipif(not hasattr(socket, "send_fds"), reason="no descriptors are passed here")


def families(events: int, sessions: int, delays: list[float]) -> list[Family]:
    registry = CollectorRegistry()
    Counter("events", "", registry=registry).inc(events)
    Gauge("sessions", "", registry=registry).set(sessions)
    Gauge("process_files", "", registry=registry).set(sessions)
    histogram = Histogram("delay", "", buckets=(1.0,), registry=registry)
    for delay in delays:
        histogram.observe(delay)
    return families_of(registry)


def values(merged: list[Family]) -> dict[str, float]:
    return {
        name + "".join(labels.values()): value
        for family in merged
        for name, labels, value in family.rows
        if "created" not in name
    }


def test_metrics_are_summed_and_counts_outlive_their_worker() -> None:
    service = ServiceFamilies()
    service.update("0", families(3, 2, [0.5, 2.0]))
    service.update("1", families(4, 1, [0.5]))
    expected = {"events_total": 7, "delay_count": 3, "delay_sum": 3.0, "delay_bucket1.0": 2}
    both = {"sessions": 3, "process_files0": 2, "process_files1": 1}
    assert expected | both | {"delay_bucket+Inf": 3} == values(service.merged())
    service.end("1")
    alone = {"sessions": 2, "process_files0": 2}
    assert expected | alone | {"delay_bucket+Inf": 3} == values(service.merged())
    service.update("1", families(10, 0, []))
    assert values(service.merged())["events_total"] == 17
    assert "events_total 17.0" in text_of(service.merged())


class Worker:
    """Takes connections while it has room."""

    def __init__(self, load: int = 0, room: int = 1000) -> None:
        self.load, self.room = load, room
        self.taken = 0

    def hand(self, connection: socket.socket) -> bool:
        if self.taken >= self.room:
            return False
        self.taken += 1
        self.load += 1
        return True


def dispatched(workers: list[Worker], clients: int, until_taken: int) -> None:
    """Connect clients, and wait until so many connections have been taken."""

    async def dispatch() -> None:
        with listen("127.0.0.1", 0) as listening:
            address = listening.getsockname()
            dispatcher = Dispatcher(listening, lambda: workers)
            dispatcher.start()
            opened = [socket.create_connection(address) for _ in range(clients)]
            async with asyncio.timeout(PATIENCE_S):
                while sum(worker.taken for worker in workers) < until_taken:
                    await asyncio.sleep(0.001)
                    if len(workers) == 1 and workers[0].taken == workers[0].room:
                        workers.append(Worker())
            dispatcher.stop()
            for one in opened:
                one.close()

    asyncio.run(dispatch())


def test_the_worker_with_the_fewest_connections_gets_the_next() -> None:
    workers = [Worker(load=6), Worker(load=2), Worker()]
    dispatched(workers, 10, 10)
    assert [worker.load for worker in workers] == [6, 6, 6]


def test_a_full_worker_is_passed_over() -> None:
    workers = [Worker(room=1), Worker(load=5)]
    dispatched(workers, 8, 8)
    assert [worker.taken for worker in workers] == [1, 7]


def test_connections_wait_while_nobody_takes_them() -> None:
    workers = [Worker(room=3)]
    dispatched(workers, 8, 8)
    assert [worker.taken for worker in workers] == [3, 5]


def test_workers_that_end_at_once_are_not_started_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    monkeypatch.setattr(restarts, "FIRST_S", 0.001)
    announced: list[bool] = []
    opened = listen("127.0.0.1", 0)
    supervisor = Supervisor(opened, Settings(workers=2), lambda: announced.append(True))
    with pytest.raises(SourceError, match="every worker ends soon after its start"):
        asyncio.run(supervisor.run())
    assert not announced


def program(folder: Path, text: str) -> str:
    """A file that runs, in the place of Python."""
    file = folder / "worker"
    file.write_text(text)
    file.chmod(0o755)
    return str(file)


def test_the_exit_code_of_a_worker_is_known_that_ends_before_it_has_read_anything(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "executable", program(tmp_path, "#!/bin/sh\nkill -TERM $$\n"))

    async def ended() -> int:
        process = WorkerProcess(0, WorkerCounts(1, 1), lambda worker, message: None)
        return await (await process.start(Settings().model_dump(mode="json"), 1))

    assert {asyncio.run(ended()) for _ in range(20)} == {-signal.SIGTERM}


def test_workers_that_are_stopped_again_and_again_do_not_end_the_service(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/true")  # ends as a worker does that was asked to
    monkeypatch.setattr(restarts, "FIRST_S", 0.001)
    supervisor = Supervisor(listen("127.0.0.1", 0), Settings(workers=2), lambda: None)

    def stops() -> float:
        return (
            supervisor._registry.registry.get_sample_value(
                "pointpred_worker_restarts_total", {"reason": "stop"}
            )
            or 0.0
        )

    async def serve_for_a_while() -> None:
        running = asyncio.create_task(supervisor.run())
        while not running.done() and stops() <= 4 * restarts.MOST_FAILURES:
            await asyncio.sleep(0.01)
        if not running.done():
            supervisor._stop(signal.SIGTERM)
        assert await running is signal.SIGTERM

    asyncio.run(serve_for_a_while())


def test_a_worker_that_hangs_before_it_answers_is_killed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(sys, "executable", program(tmp_path, "#!/bin/sh\nexec sleep 600\n"))
    for name, seconds in (("START_S", 0.2), ("WATCH_S", 0.02), ("WORKERS_END_S", 0.2)):
        monkeypatch.setattr(supervisor_module, name, seconds)
    supervisor = Supervisor(listen("127.0.0.1", 0), Settings(workers=1), lambda: None)

    async def serve_for_a_while() -> None:
        running = asyncio.create_task(supervisor.run())
        async with asyncio.timeout(PATIENCE_S):
            while "ended by SIGKILL" not in caplog.text:
                await asyncio.sleep(0.01)
        supervisor._stop(signal.SIGTERM)
        await running

    asyncio.run(serve_for_a_while())
    assert "has not answered for 0.2 s and is killed" in caplog.text


STOPPED_ONLY_WHEN_ASKED = f"""#!{sys.executable}
import socket, sys
control = socket.socket(fileno=int(sys.argv[4]))
while b'"stop"' not in control.recv(65536):
    pass
"""


def test_a_worker_that_is_being_started_when_the_service_stops_is_asked_to_stop(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(sys, "executable", program(tmp_path, STOPPED_ONLY_WHEN_ASKED))
    monkeypatch.setattr(supervisor_module, "WORKERS_END_S", 5.0)
    supervisor = Supervisor(listen("127.0.0.1", 0), Settings(workers=1), lambda: None)
    start = WorkerProcess.start

    async def start_and_stop(worker: WorkerProcess, *arguments: Any) -> Any:
        supervisor._stop(signal.SIGTERM)
        await asyncio.sleep(0.01)  # the others are asked now
        return await start(worker, *arguments)

    monkeypatch.setattr(WorkerProcess, "start", start_and_stop)
    assert asyncio.run(supervisor.run()) is signal.SIGTERM
    assert "were killed" not in caplog.text


def test_a_system_that_hands_no_connections_over_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(socket, "send_fds")
    with pytest.raises(ParameterError, match="--workers 2: this system cannot hand connections"):
        serve(workers=2, port=0)


def test_a_device_is_served_by_one_process(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POINTPRED_WORKERS", "2")
    with pytest.raises(ParameterError, match="POINTPRED_WORKERS is 2, but a device is served from the one"):
        page_opener("127.0.0.1", 0)


def test_workers_that_somebody_stops_are_no_failures() -> None:
    one = restarts.Restarts()
    one.pause_s(1.0)
    assert [one.pause_s(1.0, ordered=True) for _ in range(6)] == [restarts.FIRST_S] * 6
    assert not one.hopeless
    assert one.pause_s(1.0) == 2 * restarts.FIRST_S, "the failures before and after are in a row"
    one.pause_s(90.0, ordered=True)
    assert one.pause_s(1.0) == restarts.FIRST_S


def test_metrics_of_workers_that_do_not_come_are_refused_and_not_waited_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("pointpred_server.workers.worker.METRICS_S", 0.1)
    peers = OtherWorkers(0, WorkerCounts(1, 1))
    near, far = socket.socketpair()
    with near, far, running(lambda service: setattr(service, "peers", peers)) as here:

        class Slow:
            """Hears everything and answers late."""

            def is_closing(self) -> bool:
                return False

            def write(self, message: bytes) -> None:
                near.sendall(message)

        peers.ask = cast(asyncio.StreamWriter, Slow())
        answer = get(f"{here.url}/metrics", timeout=PATIENCE_S)
        assert (answer.status_code, answer.json()["code"]) == (503, "slow")
        monkeypatch.setattr("pointpred_server.workers.worker.METRICS_S", PATIENCE_S)
        with ThreadPoolExecutor(1) as other:
            asked = other.submit(get, f"{here.url}/metrics", timeout=PATIENCE_S)
            far.settimeout(PATIENCE_S)
            far.recv(100)
            soon(lambda: len(peers._texts) == 2, "both were asked for")
            peers.take_text("late")
            here.server.servers[0].get_loop().call_soon_threadsafe(peers.take_text, "in time")
            assert asked.result(PATIENCE_S).text == "in time"
