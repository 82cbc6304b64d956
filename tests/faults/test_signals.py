"""A service that is stopped for good, and one that stands still for a while."""

from __future__ import annotations

import json
import os
import signal
import socket
import time
from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed

from evidence.costs.soak.sessions import PING, PONG, TEXT, frame, split, upgrade
from pointpred.protocol.frames import PREDICTION
from tests.faults.service import Client, service
from tests.server.listener import soon
from tests.server.running import PATIENCE_S

IDLE_S = 4.0
"""The longest silence that this service allows."""
STILL_S = 5.5
PING_TIMEOUT_S = 20.0


def test_a_service_that_is_stopped_answers_and_records_what_it_has(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path))
        clients = [opened.enter_context(Client(running.url, "switched")) for _ in range(4)]
        for client in clients:
            client.exchange(50)
            client.send(300)  # on the way while the service stops
        begun = time.monotonic()
        assert running.stop() in {0, -signal.SIGTERM}
        assert time.monotonic() - begun < 10.0
        for client in clients:
            answered, byes = 50, 0
            for answer in until_closed(client):
                if isinstance(answer, bytes):
                    assert not byes, "bye is the last message"
                    answered += len(answer) // PREDICTION[1].itemsize
                else:
                    byes += json.loads(answer)["type"] == "bye"
            assert client.socket.close_code == 1001
            assert byes == 1
            assert len(client.recorded(running)) == answered, "every answer is recorded, and no more"
        assert running.errors() == []


def until_closed(client: Client) -> list[str | bytes]:
    """What comes until the service has closed the connection."""
    answers: list[str | bytes] = []
    with suppress(ConnectionClosed):
        while True:
            answers.append(client.socket.recv(PATIENCE_S))
    return answers


def still(process_id: int, seconds: float) -> None:
    """The process stands still, as a laptop that sleeps."""
    os.kill(process_id, signal.SIGSTOP)
    time.sleep(seconds)
    os.kill(process_id, signal.SIGCONT)


@pytest.mark.slow
def test_a_service_that_stood_still_ends_no_session_but_silent_ones(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(
            service(tmp_path, environment={**os.environ, "POINTPRED_IDLE_S": f"{IDLE_S}"})
        )
        one, other, silent = (opened.enter_context(Client(running.url)) for _ in range(3))
        for client in (one, other, silent):
            client.exchange(50)
        still(running.process.pid, STILL_S)
        for client in (one, other):
            client.exchange(50)
        for client in (one, other):
            client.leave()
            assert client.socket.close_code == 1000
            soon(lambda client=client: len(client.recorded(running)) == 100, "all is recorded")
        until_closed(silent)
        assert silent.socket.close_code == 1008


def newest_time(answer: bytes) -> float:
    """The time of the newest prediction of a frame."""
    return float(np.frombuffer(answer, PREDICTION[1])["t"][-1, 0])


@pytest.mark.slow
@pytest.mark.parametrize("seconds", [15.0, 50.0])
def test_what_was_sent_meanwhile_is_answered(tmp_path: Path, seconds: float) -> None:
    """Longer than the service waits for the answer to a ping, and for a client that does not read."""
    with ExitStack() as opened:
        running = opened.enter_context(
            service(tmp_path, environment={**os.environ, "POINTPRED_IDLE_S": "10"})
        )
        client = opened.enter_context(Client(running.url, reply="frame"))
        client.exchange(50)
        running.process.send_signal(signal.SIGSTOP)
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            client.send(100)  # 1 kHz: the budget of the events of a second is 20,000
            time.sleep(0.1)
        running.process.send_signal(signal.SIGCONT)
        last, newest = client.sent[-1, 0], 0.0
        while newest < last:
            answer = client.socket.recv(PATIENCE_S)
            if isinstance(answer, bytes):
                newest = newest_time(answer)
        client.leave()
        assert client.socket.close_code == 1000
        soon(lambda: len(client.recorded(running)) == len(client.sent), "all is recorded", 60.0)
        assert running.metric("pointpred_recorder_events_lost_total") == 0


@pytest.mark.slow
def test_an_answer_to_a_ping_that_came_meanwhile_counts(tmp_path: Path) -> None:
    with ExitStack() as opened:
        running = opened.enter_context(service(tmp_path))
        port = int(running.address.rstrip("/").rpartition(":")[2])
        raw = opened.enter_context(socket.create_connection(("127.0.0.1", port), PATIENCE_S))
        raw.sendall(upgrade(port))
        assert raw.recv(1 << 16).endswith(b"\r\n\r\n")
        raw.sendall(frame(TEXT, b'{"type":"hello","version":1,"predictor":"linear"}'))
        received = frames_from(raw, lambda opcode: opcode == PING)  # after 20 s
        running.process.send_signal(signal.SIGSTOP)
        raw.sendall(frame(PONG, received[-1][1]))
        time.sleep(PING_TIMEOUT_S + 2.0)
        running.process.send_signal(signal.SIGCONT)
        raw.sendall(frame(TEXT, b'{"type":"events","events":[[0.0,1.0,2.0,null,null,0]]}'))
        assert frames_from(raw, lambda opcode: opcode != PING)[-1][0] == TEXT, "it goes on"


def frames_from(raw: socket.socket, last: Callable[[int], bool]) -> list[tuple[int, bytes]]:
    """The frames that come until one with such an opcode."""
    frames: list[tuple[int, bytes]] = []
    received = b""
    while not frames or not last(frames[-1][0]):
        some, received = split(received + raw.recv(1 << 16))
        frames += some
    return frames
