"""A service at the limits of its process: files and memory."""

from __future__ import annotations

import http.client
import resource
import socket
from contextlib import ExitStack, suppress
from pathlib import Path

import pytest

from tests.faults.service import Client, Running, service, wait_until_ready
from tests.server.listener import soon

FILES = 64
ROOM_MB = 16


def port_of(running: Running) -> int:
    """The port that a service listens on."""
    return int(running.address.rstrip("/").rpartition(":")[2])


@pytest.mark.slow
def test_too_many_open_files_refuse_newcomers_only(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path))
        wait_until_ready(running)
        client = opened.enter_context(Client(running.url))
        client.exchange(50)
        soon(lambda: len(client.recorded(running)) == 50, "it is recorded")
        resource.prlimit(running.process.pid, resource.RLIMIT_NOFILE, (FILES, FILES))
        crowd = []
        for _ in range(3 * FILES):
            with suppress(OSError):
                crowd.append(socket.create_connection(("127.0.0.1", port_of(running)), 2.0))
        client.exchange(200)
        soon(lambda: len(client.recorded(running)) == 250, "an open recording goes on")
        for one in crowd:
            one.close()
        with Client(running.url) as other:
            other.exchange(50)
            other.leave()
            soon(lambda: len(other.recorded(running)) == 50, "afterwards all is as before")
        entries = running.log.read_text().splitlines()
        assert len(entries) < 50, "the log is not flooded"


@pytest.mark.slow
def test_a_recording_for_which_there_is_no_memory_is_refused(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path))
        wait_until_ready(running)
        client = opened.enter_context(Client(running.url))
        client.exchange(50)
        assert upload(running, 100)[0] == 200
        status = Path(f"/proc/{running.process.pid}/status").read_text()
        (used_kb,) = (int(line.split()[1]) for line in status.splitlines() if line.startswith("VmSize"))
        most = (used_kb << 10) + (ROOM_MB << 20)
        resource.prlimit(running.process.pid, resource.RLIMIT_AS, (most, most))
        code, answer = upload(running, 400_000)
        assert code in {413, 500, 503}, answer
        client.exchange(200)
        soon(lambda: len(client.recorded(running)) == 250, "the session goes on, and its recording")
        assert upload(running, 100)[0] == 200


def upload(running: Running, rows: int) -> tuple[int, bytes]:
    """Have a recording of so many rows scored."""
    lines = [f"{row / 1000},{row % 500},{row % 300}" for row in range(rows)]
    body = "\n".join(["t_s,x_px,y_px", *lines, ""]).encode()
    connection = http.client.HTTPConnection("127.0.0.1", port_of(running), timeout=300.0)
    connection.request("POST", "/v1/score?predictors=hold", body)
    answer = connection.getresponse()
    try:
        return answer.status, answer.read()
    finally:
        connection.close()
