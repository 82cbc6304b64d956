"""A real process tells nothing of what anybody did, and no token, whatever it is sent and whatever breaks."""

from __future__ import annotations

import json
import os
import re
import signal
import socket as socket_module
import struct
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from httpx2 import get, post
from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.sync.client import ClientConnection, connect

from tests.server.running import HELLO, PATIENCE_S

TOKEN = "open-sesame-4711"
SECRETS = ("7315.25", "8264.75", "made-up-name", TOKEN, "open%2Dsesame", "sesame")
"""Where somebody pointed, and when; what they called things; and the token, as text and in addresses."""
FAILING = """
import sys
from pointpred_server.sessions.pointing import PointingSession
real = PointingSession.receive
def receive(self, frame, now):
    if frame == '{"type":"reset"}':
        raise RuntimeError(f"cannot use 7315.25 of {self.outbox!r}")
    real(self, frame, now)
PointingSession.receive = receive
from pointpred.cli import main
main(sys.argv[1:])
"""
"""A service in which one kind of message breaks a session, in words that quote an event."""
ROW = "[8264.75,7315.25,3,null,null,0]"
PACKED = struct.pack("<dddhhH", 8264.75, 7315.25, 3.0, 1, 1, 0)
FRAMES: tuple[str | bytes, ...] = (
    "{oops 7315.25",
    '{"type":"events","events":7315.25}',
    '{"type":"events","events":[[8264.75,"7315.25",3,null,null,0]]}',
    f'{{"type":"events","events":[{ROW},[NaN,7315.25,3,null,null,0]]}}',
    '{"type":"events","events":[[8264.75,7315.25e300,3,null,null,0]]}',
    f'{{"type":"events","events":[{ROW}]}}',
    '{"type":"events","events":[[1,7315.25,3,null,null,0]]}',
    PACKED,
    PACKED[:-1],
    struct.pack("<dddhhH", float("nan"), 7315.25, 3.0, 1, 1, 0),
    '{"type":"made-up-name"}',
    '{"type":"configure","predictor":"made-up-name"}',
    '{"type":"configure","parameters":{"made-up-name":7315.25}}',
    '{"type":"targets","targets":[{"id":"made-up-name","x":7315.25,"y":1,"width":-1,"height":1}]}',
    '{"type":"trial","action":"start","target":{"x":7315.25,"y":8264.75,"width":1}}',
    '{"type":"trial","action":"end"}',
    '{"type":"trial","action":"end"}',
    HELLO,
)
BYE = '{"type":"bye","reason":"at 7315.25 as made-up-name"}'
LAST: tuple[str | bytes, ...] = (
    BYE,
    '{"type":"reset"}',
    "7315.25," * 9000,
    PACKED * 1025,
    b"7315.25," * 2**18,
)
"""What ends a session."""
RAW = (
    b"7315.25 8264.75\r\n\r\n",
    b"GET /?made-up-name=7315.25 HTTP/9.9\r\n\r\n",
    b"POST /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 7315.25\r\n\r\n",
    b"GET /v1/stream?token=open-sesame-4711 HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\n"
    b"Connection: Upgrade\r\nSec-WebSocket-Key: 7315.25\r\nSec-WebSocket-Version: 13\r\n\r\n",
    b"GET /v1/stream?token=open-sesame-4711 HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\n"
    b"Connection: Upgrade\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n"
    b"\x83\x87\0\0\0\x007315.25",
)
"""What is no HTTP, or no WebSocket: the last is a frame of a kind that does not exist."""


@pytest.fixture(params=["json", "text"])
def process(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A service that records, asks for a token and is reached through no test's hands, and its address."""
    arguments = ["serve", "--port", "0", "--token", TOKEN, "--record", str(tmp_path / "kept")]
    command = [sys.executable, "-c", FAILING, *arguments]
    environment = {**os.environ, "POINTPRED_LOG_FORMAT": request.param}
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
    ) as running:
        assert running.stdout is not None
        address = running.stdout.readline().strip()
        try:
            yield running, address
        finally:
            running.kill()


def stream(address: str, token: str = TOKEN) -> ClientConnection:
    found = re.match(r"http(://[^/]+)", address)
    assert found is not None, address
    return connect(f"ws{found[1]}/v1/stream?token={token}", compression=None, open_timeout=PATIENCE_S)


def talk(address: str, *frames: str | bytes) -> list[str]:
    """Say all of it in one session, and hear the answers until it ends."""
    heard: list[str] = []
    with stream(address) as socket, suppress(ConnectionClosed):
        socket.send(HELLO)
        for frame in frames:
            socket.send(frame)
        while True:
            heard.append(str(socket.recv(PATIENCE_S)))
    return heard


def ask(base: str) -> None:
    """Bad requests over HTTP."""
    shown = {"Authorization": f"Bearer {TOKEN}"}
    body = b"made-up-name,1,8264.75,7315.25,x\n"
    assert post(f"{base}/v1/samples?token={TOKEN}", content=body, timeout=PATIENCE_S).status_code == 405
    assert get(f"{base}/v1/samples/made-up-name", headers=shown, timeout=PATIENCE_S).status_code == 404
    assert get(f"{base}/made-up-name?token={TOKEN}&at=7315.25", timeout=PATIENCE_S).status_code == 404
    assert get(f"{base}/?token={TOKEN}x", timeout=PATIENCE_S).status_code == 401
    assert (
        get(f"{base}/?token={TOKEN}", headers={"Host": "made-up-name"}, timeout=PATIENCE_S).status_code == 403
    )
    assert get(f"{base}/v1/samples?token={TOKEN}", timeout=PATIENCE_S).status_code == 200


def test_a_real_process_writes_no_movement_and_no_token(process: tuple[subprocess.Popen[str], str]) -> None:
    running, address = process
    base = address.split("/?")[0].rstrip("/")
    answers = talk(address, *FRAMES, BYE)
    assert sum('"type":"error"' in answer for answer in answers) >= 12
    for frame in LAST:
        talk(address, frame)
    with suppress(InvalidHandshake, ConnectionClosed), stream(address, TOKEN + "x") as socket:
        socket.recv(PATIENCE_S)
    ask(base)
    for raw in RAW:
        with socket_module.create_connection(("127.0.0.1", int(base.rpartition(":")[2]))) as plain:
            plain.sendall(raw)
            plain.settimeout(2)
            with suppress(OSError):
                plain.recv(4096)
    assert get(f"{base}/healthz", timeout=PATIENCE_S).status_code == 200
    running.send_signal(signal.SIGTERM)
    out, err = running.communicate(timeout=PATIENCE_S)
    for secret in SECRETS:
        assert secret not in err
        assert secret not in out
    assert "Traceback" not in err
    assert "session failed" in err, "the broken session is told"
    assert "RuntimeError at" in err
    assert err.count("session closed") >= 1 + len(LAST)
    entries = [json.loads(line) for line in err.splitlines() if line.startswith("{")]
    assert not entries or {entry["level"] for entry in entries} >= {"info", "error"}
