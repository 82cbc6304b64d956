"""The compiled load generator counts every answer and every delay: what it reports is what happened."""

from __future__ import annotations

import os
import shutil
import socket
import threading
import time
from pathlib import Path

import pytest

from evidence.costs.load.generator import Counts, Group, Plan, built, recording, run, track
from evidence.machine import ALL
from tests.server.running import Running, running

pytestmark = pytest.mark.skipif(shutil.which("cc") is None, reason="needs a C compiler: 'cc'")
HELLO = '{"type":"hello","version":1,"predictor":"hold","encoding":"%s"}'
STOP_AT_BYTES = 36 * 100
"""A frame of one event has 36 bytes: the hundredth is kept waiting."""
RATE_HZ, SIZE, CLIENTS, SECONDS = 250.0, 8, 2, 0.8


@pytest.fixture(autouse=True)
def _sample(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("POINTPRED_RECORDINGS", raising=False)
    recording.cache_clear()
    track.cache_clear()


def port_of(here: Running) -> int:
    return int(here.url.rpartition(":")[2])


def counted(*groups: Group, seconds: float = SECONDS) -> list[Counts]:
    return run(Plan(groups, seconds=seconds, warm=0.2, drain=60.0), ALL).groups


def test_every_event_is_answered_and_timed() -> None:
    """Both encodings, two clients each: the service has used what the generator sent, and refused nothing."""
    with running() as here:
        groups = [
            Group(
                encoding,
                port_of(here),
                (os.getpid(),),
                clients=CLIENTS,
                rate=RATE_HZ,
                size=SIZE,
                json=encoding == "json",
                greeting=(HELLO % encoding,),
            )
            for encoding in ("binary", "json")
        ]
        results = counted(*groups)
        here.service.update_metrics()
    frames = CLIENTS * RATE_HZ * (SECONDS + 0.2)
    for result in results:
        assert result.sent == result.answered == frames
        assert result.delay.count == CLIENTS * RATE_HZ * SECONDS
        assert (result.unanswered, result.repeated, result.texts, result.closes) == (0, 0, {}, {})
        assert 0.0 < result.delay.p50_ms <= result.delay.p99_ms <= result.delay.max_ms
        assert result.server_us > 0.0
    assert here.service.metrics.events._value.get() == 2 * frames * SIZE


def test_what_a_session_refuses_and_how_it_ends_is_counted() -> None:
    """A script of a wrong message, and one above the limits of a frame."""
    with running() as here:
        port = port_of(here)
        wrong = Group("wrong", port, kind="script", rate=50.0, greeting=(HELLO % "json",), messages=("{",))
        long = Group(
            "long", port, kind="script", rate=50.0, greeting=(HELLO % "json",), messages=(" " * 70_000,)
        )
        refused, closed = counted(wrong, long)
    assert refused.texts == {"bad_json": refused.sent}
    assert closed.texts == {"too_large": 1}
    assert closed.closes == {"1009": 1}


def test_a_frame_that_could_not_be_answered_has_waited_since_it_was_due() -> None:
    """A server that stops for a while delays every frame due meanwhile, not only the one under way."""
    stopped_s = 0.4

    def echo(opened: socket.socket) -> None:
        connection, received = opened.accept()[0], 0
        with connection:
            while data := connection.recv(2**16):
                if received < STOP_AT_BYTES <= received + len(data):
                    time.sleep(stopped_s)
                received += len(data)
                connection.sendall(data)

    with socket.create_server(("127.0.0.1", 0)) as opened:
        thread = threading.Thread(target=echo, args=(opened,))
        thread.start()
        (result,) = counted(Group("stopped", opened.getsockname()[1], kind="raw", rate=RATE_HZ), seconds=1.2)
        thread.join()
    assert result.unanswered == 0
    assert result.sent == result.answered == RATE_HZ * 1.4
    assert result.delay.p90_ms > 1e3 * stopped_s / 3  # one frame in three was due while it stood still


def test_the_generator_is_built_again_when_its_source_is_newer(tmp_path: Path) -> None:
    program = built()
    os.utime(program, (0.0, 0.0))
    built.cache_clear()
    assert built() == program
    assert program.stat().st_mtime > 0.0
