"""A service at the limit of open files of its process."""

from __future__ import annotations

import resource
import socket
from contextlib import ExitStack, suppress
from pathlib import Path

import pytest

from tests.faults.service import Client, Running, service
from tests.server.listener import soon

FILES = 64


def port_of(running: Running) -> int:
    """The port that a service listens on."""
    return int(running.address.rstrip("/").rpartition(":")[2])


@pytest.mark.slow
def test_too_many_open_files_refuse_newcomers_only(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path))
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
