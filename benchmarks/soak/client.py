"""One client of the soak without its socket: bytes in, bytes out, and every answer compared."""

from __future__ import annotations

import json
import os
import tempfile
from base64 import b64encode
from collections import deque
from pathlib import Path

import msgspec
import numpy as np

from benchmarks.soak.frames import BINARY, CLOSE, PING, PONG, TEXT, frame, split
from benchmarks.soak.movement import events
from benchmarks.soak.offline import CPI, DPI, OfflineRun
from pointpred.protocol.packed import pack_events
from pointpred.records import FloatArray

ERROR, PREDICTION = b'{"type":"error"', b'{"type":"prediction"'
BYE = frame(TEXT, b'{"type":"bye"}')


def upgrade(port: int, path: str = "/v1/stream") -> bytes:
    """The request that begins a WebSocket."""
    return (
        f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: {b64encode(bytes(16)).decode()}\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Protocol: pointpred.v1\r\n\r\n"
    ).encode()


class StreamClient:
    """Speaks for a client that keeps to the rules.

    ``delays`` holds the seconds from when an event was due to be sent to the first answer that counts it.
    """

    def __init__(
        self,
        folder: Path,
        number: int,
        rate_hz: float,
        *,
        predictor: str = "switched",
        encoding: str = "binary",
        reply: str = "frame",
    ) -> None:
        self.session = ""
        self.close_code = 0
        self.errors: list[str] = []
        """Errors that an innocent client must not get."""
        self.behind = 0
        """How often the service said that answers gave way to newer ones."""
        self.delays: list[float] = []
        descriptor, file = tempfile.mkstemp(dir=folder)
        os.close(descriptor)
        self.run = OfflineRun(predictor, Path(file))
        self._number, self._rate_hz, self._binary = number, rate_hz, encoding == "binary"
        self._hello = {"type": "hello", "version": 1, "predictor": predictor, "encoding": encoding}
        self._hello |= {"reply": reply, "device": {"cpi": CPI}, "screen": {"dpi": DPI}}
        self._rest = b""
        self._upgraded = False
        self._due: deque[tuple[float, float]] = deque()

    def skip(self, seconds: float) -> None:
        """The next event is later by so much: nobody moved."""
        self._pause += seconds

    _pause = 0.0

    def frames(self, count: int, due: float, *, a_frame: int = 1) -> bytes:
        """The next events, framed; they were to be sent at ``due``."""
        table = events(self._number, self._rate_hz, self.run.events, count)
        table[:, 0] += self._pause
        self.run.sent(table)
        self._due.extend((t, due) for t in table[:, 0].tolist())
        return b"".join(self._frame(table[at : at + a_frame]) for at in range(0, count, a_frame))

    def _frame(self, table: FloatArray) -> bytes:
        if self._binary:
            return frame(BINARY, pack_events(table))
        rows = [[*row[:5], int(row[5])] for row in table.tolist()]
        return frame(TEXT, json.dumps({"type": "events", "events": rows}).encode())

    def receive(self, data: bytes, now: float) -> bytes:
        """Take in what came; returns what is to be sent at once."""
        self._rest += data
        if not self._upgraded:
            head, end, rest = self._rest.partition(b"\r\n\r\n")
            if not end:
                return b""
            if not head.startswith(b"HTTP/1.1 101"):
                raise ConnectionError(f"no upgrade: {head[:80]!r}")
            self._upgraded, self._rest = True, rest
            return frame(TEXT, json.dumps(self._hello).encode())
        frames, self._rest = split(self._rest)
        return b"".join(self._take(opcode, payload, now) for opcode, payload in frames)

    def _take(self, opcode: int, payload: bytes, now: float) -> bytes:
        if opcode == PING:
            return frame(PONG, payload)
        if opcode == CLOSE:
            self.close_code = int.from_bytes(payload[:2], "big")
            return frame(CLOSE, payload[:2])
        if opcode == BINARY or payload.startswith(PREDICTION):
            self._answered(self.run.answered(payload if opcode == BINARY else payload.decode()), now)
        elif opcode == TEXT and not self.session:
            self.session = msgspec.json.decode(payload).get("session", "")
        elif payload.startswith(ERROR):
            if msgspec.json.decode(payload)["code"] == "slow":
                self.behind += 1
            else:
                self.errors.append(payload.decode())
        return b""

    def _answered(self, newest: float, now: float) -> None:
        while self._due and self._due[0][0] <= newest:
            self.delays.append(now - self._due.popleft()[1])

    def take_delays(self) -> np.ndarray:
        """The delays since the last call, s."""
        delays, self.delays = np.array(self.delays), []
        return delays

    @property
    def answered(self) -> bool:
        """Whether every event is answered."""
        return not self._due
