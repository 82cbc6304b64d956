"""An attack that fails, or does nothing, is no attack that was withstood."""

from __future__ import annotations

import os
import resource
import socket
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from evidence.attacks.attacked import Attacker, shown
from evidence.attacks.attackers import UPGRADE, Attack, Here, Talk
from evidence.machine import processor_s

SWITCHED = b"HTTP/1.1 101 Switching Protocols\r\n\r\n\x81\x02{}"
WORDS = b'{"type":"error","code":"too_fast"}'
ERROR = bytes([0x81, len(WORDS)]) + WORDS

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the benchmark reads /proc")


@pytest.fixture
def port() -> Iterator[int]:
    with socket.create_server(("127.0.0.1", 0), backlog=128) as server:
        yield server.getsockname()[1]


def failing(here: Here) -> None:
    raise OSError("nobody is attacked")


def idle(here: Here) -> None:
    """Nothing."""


def active(here: Here) -> None:
    here.keep_open(here.opened(3))


def at(port: int, seconds: float = 0.0) -> Here:
    return Here(port, "127.0.0.3", time.monotonic() + seconds)


@pytest.mark.parametrize(("attack", "code"), [(failing, 1), (idle, 0)])
def test_an_attack_that_does_nothing_ends_the_measurement(attack: Attack, code: int, port: int) -> None:
    with pytest.raises(SystemExit, match=f"'{attack.__name__}' did nothing: exit code {code}"):
        Attacker(attack, at(port)).finish()


def test_what_an_attack_was_answered_is_counted(port: int) -> None:
    assert Attacker(active, at(port, 1.0)).finish() == {"kept open": 3}


def test_connections_stay_open_where_no_more_can_be_opened(port: int) -> None:
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    used = len(list(Path("/proc/self/fd").iterdir()))
    resource.setrlimit(resource.RLIMIT_NOFILE, (used + 20, before[1]))
    try:
        connections = at(port, 60.0).opened(100)
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, before)
    for one in connections:
        one.close()
    assert 10 < len(connections) < 100


@pytest.mark.parametrize(
    ("answer", "heard"),
    [
        (b"HTTP/1.1 403 Forbidden\r\n\r\n{}", "403"),
        (SWITCHED, "101"),
        (SWITCHED + ERROR + b"\x88\x02\x03\xf0", "1008 too_fast"),
        (b"", "ended"),
    ],
)
def test_how_a_connection_was_answered(answer: bytes, heard: str) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        here = at(server.getsockname()[1], 60.0)
        with Talk(here, UPGRADE) as talk:
            one, _ = server.accept()
            with one:
                one.recv(4096)
                one.sendall(answer)
            talk.read(60.0)
    assert here.heard == {heard: 1}


def test_the_answers_are_shown_with_their_shares() -> None:
    assert shown(Counter({"403": 3})) == "403"
    assert shown(Counter({"403": 2, "429": 6, "ended": 0})) == "429 (75%), 403 (25%)"


def test_the_processor_time_of_a_process_that_has_ended_is_0() -> None:
    assert processor_s(os.getpid()) > 0.0
    assert processor_s(2**22 + 1) == 0.0
