"""A client whose network is cut: no packet says that it has left."""

from __future__ import annotations

import os
import shutil
import subprocess
from contextlib import ExitStack
from pathlib import Path

import pytest

from tests.faults.service import Client, Running, service
from tests.server.listener import soon

HERE, THERE = "10.213.77.1", "10.213.77.2"
CABLE = f"pp{os.getpid() % 100_000}"
TOKEN = "a-token-of-this-test"
IDLE_S = 4.0


@pytest.fixture
def own_network() -> list[str]:
    """The command that gives a program a network of its own; needs the right to lay a cable to it."""
    if shutil.which("ip") is None or shutil.which("unshare") is None:
        pytest.skip("needs ip (iproute2) and unshare (util-linux)")
    trial = ["unshare", "--net", "ip", "link", "add", "trial0", "type", "veth", "peer", "name", "trial1"]
    if os.geteuid() != 0 or subprocess.run(trial, capture_output=True, check=False).returncode:
        pytest.skip("this user may not make a network of its own (unshare --net, ip link add)")
    return ["unshare", "--net"]


def ip(*words: str, inside: int | None = None) -> None:
    """Run ``ip``, in the network of a process where one is given."""
    enter = [] if inside is None else ["nsenter", "--net", "--target", str(inside)]
    subprocess.run([*enter, "ip", *words], check=True, capture_output=True)


def connect(running: Running) -> None:
    """Lay a cable between this network and that of the service."""
    process_id = running.process.pid
    ip("link", "add", CABLE, "type", "veth", "peer", "name", "cable", "netns", str(process_id))
    for name, address, inside in ((CABLE, HERE, None), ("cable", THERE, process_id)):
        ip("address", "add", f"{address}/30", "dev", name, inside=inside)
        ip("link", "set", name, "up", inside=inside)
    ip("link", "set", "lo", "up", inside=process_id)


@pytest.mark.slow
def test_a_client_whose_network_is_cut_is_ended(own_network: list[str], tmp_path: Path) -> None:
    options = ("--host", "0.0.0.0", "--allow-host", THERE, "--token", TOKEN)
    environment = {**os.environ, "POINTPRED_IDLE_S": f"{IDLE_S}"}
    with ExitStack() as opened:
        running = opened.enter_context(
            service(tmp_path, *options, wrapper=own_network, environment=environment)
        )
        connect(running)
        opened.callback(subprocess.run, ["ip", "link", "delete", CABLE], check=False, capture_output=True)
        running.address = running.address.replace("127.0.0.1", THERE)
        running.token = TOKEN
        before = descriptors(running)
        silent, sending = (Client(running.url) for _ in range(2))
        for client in (silent, sending):
            opened.enter_context(client)
            client.exchange(50)
        sending.send(500)  # whose answers are on the way, or never leave
        ip("link", "set", "cable", "down", inside=running.process.pid)
        soon(lambda: len(closed(running)) == 2, "both sessions have ended")
        soon(lambda: descriptors(running) <= before, "and nothing is held of them")
        ip("link", "set", "cable", "up", inside=running.process.pid)
        with Client(running.url) as client:
            client.exchange(50)
            client.leave()
        assert len(silent.recorded(running)) == 50
        assert len(sending.recorded(running)) >= 50
        for client in (silent, sending):
            client.socket.socket.close()


def closed(running: Running) -> list[str]:
    """The sessions that have ended, by the log."""
    return [line for line in running.log.read_text().splitlines() if '"session closed' in line]


def descriptors(running: Running) -> int:
    """How many files and sockets the service holds."""
    return len(list(Path(f"/proc/{running.process.pid}/fd").iterdir()))
