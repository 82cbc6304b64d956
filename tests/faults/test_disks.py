"""A disk that is full, read-only, hanging or failing: no session notices, and what was written stays."""

from __future__ import annotations

import errno
import socket
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import urlopen

import pytest

from evidence.costs.soak.sessions import upgrade
from tests.faults.conftest import ERROR, HANG, Faults
from tests.faults.service import Client, Running, service
from tests.server.listener import soon
from tests.server.running import PATIENCE_S

FAILED = "pointpred_recordings_failed_total"
ROOM = "128k"
"""The size of the disk: some hundred events."""


def on_a_small_disk(own_mounts: list[str], folder: Path) -> list[str]:
    """The command that runs a program with a small disk in a folder."""
    script = 'mount -t tmpfs -o "size=$1" none "$2" && shift 2 && exec "$@"'
    return [*own_mounts, "sh", "-c", script, "sh", ROOM, str(folder)]


def remount(running: Running, how: str, folder: Path) -> None:
    """Remount the disk in the service's own mounts."""
    enter = ["nsenter", "--target", str(running.process.pid), "--user", "--mount", "--preserve-credentials"]
    subprocess.run([*enter, "mount", "-o", f"remount,{how}", "none", str(folder)], check=True)


def test_a_full_or_read_only_disk_ends_recordings_and_nothing_else(
    own_mounts: list[str], tmp_path: Path
) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    with service(tmp_path, wrapper=on_a_small_disk(own_mounts, disk), inside=disk) as running:
        with Client(running.url) as client:
            client.exchange(100)
            soon(lambda: len(client.recorded(running)) == 100, "the first events are recorded")
            while not running.metric(FAILED) and len(client.sent) < 20_000:
                client.exchange(500)
            assert running.metric(FAILED) == 1
            client.exchange(100)
            client.leave()
            kept = len(client.recorded(running))
            assert 100 <= kept < len(client.sent)
            lost = len(client.sent) - kept
            soon(lambda: running.metric("pointpred_recorder_events_lost_total") == lost, "it is counted")
            (message,) = running.errors()
            assert message.endswith("No space left on device")
        for file in running.folder.iterdir():  # what the administrator does
            file.unlink()
        is_recorded(running)

        soon(lambda: not open_files(running), "its files are closed")
        remount(running, "ro", disk)
        with Client(running.url) as client:
            client.exchange(100)
            client.leave()
        soon(lambda: running.metric(FAILED) == 2, "it cannot be recorded")
        assert "Read-only file system" in running.errors()[-1]
        remount(running, "rw", disk)
        is_recorded(running)


def is_recorded(running: Running) -> None:
    """A new session is recorded to its last event."""
    with Client(running.url) as client:
        client.exchange(100)
        client.leave()
        soon(lambda: len(client.recorded(running)) == 100, "a new session is recorded")


def open_files(running: Running) -> list[str]:
    """The recordings that the service holds open."""
    links = Path(f"/proc/{running.process.pid}/fd").iterdir()
    return [target for target in (str(link.readlink()) for link in links) if target.endswith(".csv")]


def test_a_disk_that_hangs_or_fails_holds_up_no_session(faults: Faults, tmp_path: Path) -> None:
    with service(tmp_path, environment=faults.environment) as running, ExitStack() as opened:
        first, second = (
            opened.enter_context(Client(running.url)),
            opened.enter_context(Client(running.url, "switched")),
        )
        first.exchange(100)
        soon(lambda: len(first.recorded(running)) == 100, "the first events are recorded")
        faults.set(HANG, 1)
        first.exchange(500)
        soon(lambda: faults.held_up, "the disk hangs")
        second.exchange(500)
        urlopen(f"{running.address}healthz", timeout=PATIENCE_S).close()
        assert faults.held_up == 1  # one thread writes, and everything else goes on
        assert len(first.recorded(running)) == 100
        assert second.recorded(running).size == 0
        faults.set(HANG, 0)
        soon(lambda: len(first.recorded(running)) == 600, "what waited is written")
        soon(lambda: len(second.recorded(running)) == 500, "of every session")

        faults.set(ERROR, errno.EIO)
        first.exchange(100)
        second.exchange(100)
        soon(lambda: running.metric(FAILED) == 2, "both recordings end")
        faults.set(ERROR, 0)
        first.exchange(100)
        is_recorded(running)
        assert len(first.recorded(running)) == 600
        assert len(second.recorded(running)) == 500


@pytest.mark.slow
def test_a_service_stops_within_ten_seconds_although_a_disk_and_a_client_hang(
    faults: Faults, tmp_path: Path
) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path, environment=faults.environment))
        client = opened.enter_context(Client(running.url))
        client.exchange(100)
        soon(lambda: len(client.recorded(running)) == 100, "the first events are recorded")
        faults.set(HANG, 1)
        client.exchange(100)
        soon(lambda: faults.held_up, "the disk hangs")
        port = urlsplit(running.address).port or 0
        hanging = opened.enter_context(socket.create_connection(("127.0.0.1", port), PATIENCE_S))
        hanging.sendall(upgrade(port))
        begun = time.monotonic()
        assert running.stop() in {0, -15}
        took = time.monotonic() - begun
        assert took < 10.0
        (error,) = running.errors()
        assert error.startswith("the recorder could not write everything within ")
        assert len(client.recorded(running)) == 100


@pytest.mark.slow
def test_a_folder_that_cannot_be_written_is_refused_at_the_start(
    own_mounts: list[str], tmp_path: Path
) -> None:
    script = 'mount -t tmpfs -o "ro,size=64k" none "$1" && shift 1 && exec "$@"'
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", "--record", str(tmp_path)]
    left = subprocess.run(
        [*own_mounts, "sh", "-c", script, "sh", str(tmp_path), *command],
        capture_output=True,
        text=True,
        check=False,
    )
    assert left.returncode == 1
    assert left.stderr.strip().endswith("cannot record there: it is read-only, or not this user's")
