"""A service of several processes: one address, one token, sums of metrics, and crashes that stay apart."""

from __future__ import annotations

import os
import signal
import socket
import time
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from pathlib import Path

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection
from websockets.sync.client import connect as dial
from websockets.typing import Subprotocol

from pointpred import build, run
from pointpred.client import Connection, ServiceError, connect
from pointpred.datasets import sample
from pointpred.errors import SourceError
from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.recorder.recordings import listing
from pointpred.registry import RECOMMENDED
from pointpred_server.workers.dispatcher import NO_FILES_S
from pointpred_server.workers.supervisor import SILENT_S
from tests.server.listener import soon
from tests.server.running import HELLO, PATIENCE_S
from tests.server.serving_workers import Served, served

pytestmark = pytest.mark.skipif(not hasattr(socket, "send_fds"), reason="no descriptors are passed here")

CLIENTS = 20
TOKEN = "open-sesame-9"
ON_THE_WIRE = 9
"""Columns of a prediction that are sent."""


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """Two workers that record into one folder."""
    kept = tmp_path_factory.mktemp("kept")
    limits = ("--max-sessions", "24", "--trust-proxy", "127.0.0.1")
    with served("--workers", "2", "--token", TOKEN, *limits, "--record", str(kept)) as one:
        one.wait_until_ready()
        yield one


def opened(service: Served, stack: ExitStack, count: int) -> list[Connection]:
    """Sessions with the recommended predictor, which every worker has loaded."""
    return [
        stack.enter_context(connect(service.address, token=TOKEN, timeout_s=PATIENCE_S, reply="event"))
        for _ in range(count)
    ]


def sessions(service: Served) -> list[float]:
    metrics = service.metrics(TOKEN)
    return [metrics["pointpred_worker_sessions", str(number)] for number in range(2)]


def connections(service: Served) -> float:
    metrics = service.metrics(TOKEN)
    return sum(metrics["pointpred_worker_connections", str(number)] for number in range(2))


def until_idle(service: Served) -> None:
    """Wait until both workers answer, and no session is open."""
    soon(lambda: len(service.children()) == 2, "both run")
    soon(lambda: all(("process_open_fds", n) in service.metrics(TOKEN) for n in "01"), "both answer")
    soon(lambda: sessions(service) == [0, 0], "every session is counted as ended")
    soon(lambda: connections(service) <= 1, "no connection is left but the one that asks")


def test_sessions_are_spread_evenly_and_answered_as_by_one_process(service: Served) -> None:
    events = sample().rows(0)
    expected = run(build(RECOMMENDED), events).table[:, :ON_THE_WIRE]
    until_idle(service)
    before = service.metrics(TOKEN)["pointpred_events_total", ""]
    with ExitStack() as stack:
        clients = opened(service, stack, CLIENTS)
        assert sessions(service) == [CLIENTS / 2, CLIENTS / 2]
        for client in clients:
            client.send(events)
        for client in clients:
            np.testing.assert_array_equal(client.columns().table[:, :ON_THE_WIRE], expected)
        metrics = service.metrics(TOKEN)
    assert metrics["pointpred_events_total", ""] == before + CLIENTS * len(events)
    assert metrics["pointpred_sessions", ""] == CLIENTS
    assert metrics["pointpred_workers", ""] == 2
    for who in ("0", "1", "supervisor"):
        assert metrics["process_resident_memory_bytes", who] > 2**20


def test_a_person_goes_on_at_another_worker(service: Served) -> None:
    """By the string alone: the predictions are those of one session."""
    movements = [sample().rows(index) for index in range(4)]
    pipeline, predicted, person = build(RECOMMENDED), [], ""
    until_idle(service)
    with ExitStack() as stack:
        clients = opened(service, stack, 2)
        assert sessions(service) == [1, 1]
        for number, events in enumerate(movements):
            client = clients[number % 2]
            client.person(person)
            client.send(events)
            predicted.append(client.columns().table[:, :ON_THE_WIRE])
            client.reset()
            person = client.person()
    for events, table in zip(movements, predicted, strict=True):
        np.testing.assert_array_equal(table, run(pipeline, events).table[:, :ON_THE_WIRE])
        pipeline.reset()


def test_the_bound_on_sessions_is_one_for_all_workers(service: Served) -> None:
    until_idle(service)
    with ExitStack() as stack:
        opened(service, stack, 24)
        with pytest.raises(ServiceError, match="24 sessions are open"):
            opened(service, stack, 1)


def test_the_share_of_an_address_is_one_for_all_workers(service: Served) -> None:
    """Half of the sessions; a second address has its own share."""
    url = f"ws://127.0.0.1:{service.port}/v1/stream?token={TOKEN}"

    def answer(stack: ExitStack, address: str) -> str:
        headers = {"X-Forwarded-For": address}
        one = stack.enter_context(
            dial(url, subprotocols=[Subprotocol(SUBPROTOCOL)], additional_headers=headers)
        )
        with suppress(ConnectionClosed):
            one.send(HELLO)
        return str(one.recv(PATIENCE_S))

    for _ in range(2):  # what is over is not counted
        until_idle(service)
        with ExitStack() as stack:
            assert all('"welcome"' in answer(stack, "192.0.2.7") for _ in range(12))
            assert "12 sessions of this address are open" in answer(stack, "192.0.2.7")
            assert '"welcome"' in answer(stack, "192.0.2.8")


def test_the_token_is_asked_for_by_every_worker(service: Served) -> None:
    for _ in range(4):
        with pytest.raises(ServiceError, match="token"):
            connect(service.address, token="another-one", timeout_s=PATIENCE_S)


def test_a_crash_ends_the_sessions_of_one_worker_only(service: Served) -> None:
    events = sample().rows(1)
    until_idle(service)
    first, _ = service.children()
    with ExitStack() as stack:
        clients = opened(service, stack, 4)
        while 0 in sessions(service):  # a worker that was held up is given none; over 12 are refused
            time.sleep(0.5)
            clients += opened(service, stack, 1)
        for client in clients:
            client.send(events)
            client.columns()
        before = service.metrics(TOKEN)
        spread = sessions(service)
        os.kill(first, signal.SIGKILL)
        lost: list[str] = []
        for client in clients:
            try:
                client.reset()
                client.send(events)
                assert len(client.columns()) == len(events)
            except SourceError as error:  # its connection was lost
                lost.append(str(error))
        assert sorted([len(lost), len(clients) - len(lost)]) == sorted(spread), lost
        soon(lambda: len(service.children()) == 2, "another worker starts")
        soon(lambda: any("ended by SIGKILL" in message for message in service.messages()), "it is logged")
        after = service.metrics(TOKEN)
        restarts = "pointpred_worker_restarts_total"
        assert after[restarts, "crash"] == before[restarts, "crash"] + 1
        for name in ("pointpred_events_total", "pointpred_event_to_prediction_seconds_count"):
            assert after[name, ""] >= before[name, ""], "counts of an ended worker are kept"
        service.wait_until_ready()  # it stays ready while others answer
    until_idle(service)  # its sessions are not counted any more


def test_a_worker_that_somebody_stops_is_started_again_and_no_crash(service: Served) -> None:
    until_idle(service)
    before = service.metrics(TOKEN)
    stopped, _ = service.children()
    os.kill(stopped, signal.SIGTERM)
    sentence = f"(process {stopped}) was stopped; another one starts"
    soon(lambda: any(sentence in message for message in service.messages()), "it is logged")
    after = service.metrics(TOKEN)
    for reason, more in (("stop", 1), ("crash", 0)):
        name = "pointpred_worker_restarts_total", reason
        assert after[name] == before[name] + more


def test_a_worker_that_hangs_is_given_no_session(service: Served) -> None:
    until_idle(service)
    held, _ = service.children()
    os.kill(held, signal.SIGSTOP)
    try:
        time.sleep(SILENT_S + 1.0)
        with ExitStack() as stack:
            for client in opened(service, stack, 6):
                client.send(sample().rows(2))
                assert len(client.columns())
    finally:
        os.kill(held, signal.SIGCONT)


def test_a_worker_that_may_open_no_further_file_is_given_connections_again(service: Served) -> None:
    resource = pytest.importorskip("resource")
    until_idle(service)
    held, _ = service.children()
    usual = resource.prlimit(held, resource.RLIMIT_NOFILE)
    resource.prlimit(held, resource.RLIMIT_NOFILE, (3, usual[1]))
    with ExitStack() as stack:
        for _ in range(8):
            stack.enter_context(socket.create_connection(("127.0.0.1", service.port)))
        soon(lambda: sum("no further file" in message for message in service.messages()) == 3, "it is logged")
        resource.prlimit(held, resource.RLIMIT_NOFILE, usual)
    time.sleep(2 * NO_FILES_S)  # those that waited are over, and counted so
    with ExitStack() as stack:
        opened(service, stack, 8)
        assert sessions(service) == [4, 4]


def test_names_of_recordings_are_unique_over_workers(service: Served) -> None:
    folder = Path(service.process.args[-1])  # type: ignore[index, arg-type]
    earlier = len(listing(folder, counted=False))
    until_idle(service)
    with ExitStack() as stack:
        for client in opened(service, stack, CLIENTS):
            client.send(sample().rows(3))
            client.columns()
    soon(lambda: len(listing(folder, counted=False)) >= earlier + CLIENTS, "recorded")
    names = [one.name for one in listing(folder, counted=False)]
    assert len(names) == len(set(names))


def assert_bye(sockets: list[ClientConnection]) -> None:
    """Each session is told that the service stops."""
    for one in sockets:
        assert '"bye"' in one.recv(PATIENCE_S)
        with pytest.raises(ConnectionClosed) as closed:
            one.recv(PATIENCE_S)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1001


def greeted(service: Served, stack: ExitStack, token: str, count: int) -> list[ClientConnection]:
    url = f"ws://127.0.0.1:{service.port}/v1/stream?token={token}"
    sockets = []
    for _ in range(count):
        sockets.append(stack.enter_context(dial(url, subprotocols=[Subprotocol(SUBPROTOCOL)])))
        sockets[-1].send(HELLO)
        assert '"welcome"' in sockets[-1].recv(PATIENCE_S)
    return sockets


def test_workers_end_with_a_supervisor_that_was_killed() -> None:
    with served("--workers", "2", "--token", TOKEN) as service, ExitStack() as stack:
        children = service.children()
        assert len(children) == 2
        sockets = greeted(service, stack, TOKEN, 4)
        service.stop(signal.SIGKILL)
        assert_bye(sockets)
    soon(lambda: not any(Path(f"/proc/{pid}").exists() for pid in children), "they end as well")


def test_interrupting_sends_bye_to_the_sessions_of_all_workers() -> None:
    """And a token that was made up is one for all."""
    with served("--workers", "2", "--host", "0.0.0.0") as service, ExitStack() as stack:
        token = service.announced.partition("?token=")[2]
        assert len(token) > 20
        sockets = greeted(service, stack, token, 4)
        assert service.metrics(token)["pointpred_workers", ""] == 2
        service.process.send_signal(signal.SIGINT)
        assert_bye(sockets)
        assert service.process.wait(PATIENCE_S) == 0
        assert service.process.stdout is not None
        assert service.process.stdout.read() == "", "the address is announced once"
        soon(lambda: "stopped" in service.messages(), "it says so")
        assert not any("Traceback" in message for message in service.messages())
