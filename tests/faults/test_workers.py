"""A service of several workers: one is killed while both record, and all of them stand still."""

from __future__ import annotations

import os
import signal
import time
from contextlib import ExitStack
from pathlib import Path

import pytest

from tests.faults.service import Client, Running, service, wait_until_ready
from tests.server.listener import soon

STILL_S = 65.0
"""Longer than a worker may leave its supervisor without an answer."""


def workers_of(running: Running) -> list[int]:
    """The processes of the workers."""
    children = Path(f"/proc/{running.process.pid}/task/{running.process.pid}/children").read_text().split()
    return [int(child) for child in children if b"workers.worker" in command_of(int(child))]


def command_of(process_id: int) -> bytes:
    """The command line of a process; empty where it has ended."""
    try:
        return Path(f"/proc/{process_id}/cmdline").read_bytes()
    except OSError:
        return b""


def is_gone(client: Client) -> bool:
    """Whether the service has left a client."""
    return client.socket.close_code is not None


@pytest.mark.slow
def test_a_killed_worker_ends_its_own_sessions_and_its_recordings_can_be_read(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path, "--workers", "2"))
        wait_until_ready(running)
        clients = [opened.enter_context(Client(running.url)) for _ in range(4)]
        for client in clients:
            client.exchange(200)
        soon(lambda: all(len(client.recorded(running)) == 200 for client in clients), "all is recorded")
        os.kill(workers_of(running)[0], signal.SIGKILL)
        soon(lambda: sum(map(is_gone, clients)) == 2, "its sessions are gone")
        for client in clients:
            if not is_gone(client):
                client.exchange(200)
                client.leave()
            sent = len(client.sent)
            soon(lambda client=client, sent=sent: len(client.recorded(running)) == sent, "kept whole")
        soon(lambda: len(workers_of(running)) == 2, "another worker was started")
        with Client(running.url) as client:
            client.exchange(50)
            client.leave()


@pytest.mark.slow
def test_a_service_of_workers_that_stood_still_loses_none(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path, "--workers", "2"))
        wait_until_ready(running)
        clients = [opened.enter_context(Client(running.url)) for _ in range(2)]
        for client in clients:
            client.exchange(50)
        workers = workers_of(running)
        everybody = [running.process.pid, *workers]
        for process_id in everybody:
            os.kill(process_id, signal.SIGSTOP)
        time.sleep(STILL_S)
        for process_id in everybody:
            os.kill(process_id, signal.SIGCONT)
            time.sleep(0.5)  # the supervisor is the first that goes on
        time.sleep(3.0)
        for client in clients:
            client.exchange(50)
        assert workers_of(running) == workers
