"""An attack that fails, or does nothing, is no attack that was withstood."""

from __future__ import annotations

import os
import resource
import socket
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from evidence.attacks.attacked import Attacker, opened
from evidence.machine import processor_s

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the benchmark reads /proc")


@pytest.fixture
def port() -> Iterator[int]:
    with socket.create_server(("127.0.0.1", 0), backlog=128) as server:
        yield server.getsockname()[1]


def failing(port: int, until: float) -> int:
    raise OSError("nobody is attacked")


def idle(port: int, until: float) -> int:
    return 0


def active(port: int, until: float) -> int:
    connections = opened(port, 3)
    for one in connections:
        one.close()
    return len(connections)


@pytest.mark.parametrize(("attack", "code"), [(failing, 1), (idle, 0)])
def test_an_attack_that_does_nothing_ends_the_measurement(attack, code: int, port: int) -> None:
    with pytest.raises(SystemExit, match=f"'{attack.__name__}' did nothing: exit code {code}"):
        Attacker(attack, port, 0.0).finish()


def test_what_an_attack_did_is_counted(port: int) -> None:
    assert Attacker(active, port, 0.0).finish() == 3


def test_connections_stay_open_where_no_more_can_be_opened(port: int) -> None:
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    used = len(list(Path("/proc/self/fd").iterdir()))
    resource.setrlimit(resource.RLIMIT_NOFILE, (used + 20, before[1]))
    try:
        connections = opened(port, 100)
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, before)
    for one in connections:
        one.close()
    assert 10 < len(connections) < 100


def test_the_processor_time_of_a_process_that_has_ended_is_0() -> None:
    assert processor_s(os.getpid()) > 0.0
    assert processor_s(2**22 + 1) == 0.0
