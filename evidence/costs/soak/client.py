"""One client of the soak without its socket: bytes in, bytes out, and every answer compared.

Its frames are written and read unchecked, so that wrong ones can be sent. It sends the movements of the
embedded sample, one after another, for ever.
"""

from __future__ import annotations

import json
import os
import tempfile
from base64 import b64encode
from collections import deque
from functools import cache
from pathlib import Path

import msgspec
import numpy as np

from evidence.costs.soak.offline import CPI, DPI, OfflineRun
from pointpred.datasets import sample
from pointpred.protocol.frames import pack_events
from pointpred.records import FloatArray

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
APART = 9973
"""Events between the beginnings of two clients in the sample."""
ERROR, PREDICTION = b'{"type":"error"', b'{"type":"prediction"'


def frame(opcode: int, payload: bytes) -> bytes:
    """A client's frame; the masking key is zero, which spares the load generator, not the server."""
    size = len(payload)
    if size < 126:
        head = bytes((0x80 | opcode, 0x80 | size))
    elif size < 65536:
        head = bytes((0x80 | opcode, 0x80 | 126)) + size.to_bytes(2, "big")
    else:
        head = bytes((0x80 | opcode, 0x80 | 127)) + size.to_bytes(8, "big")
    return head + bytes(4) + payload


def split(received: bytes) -> tuple[list[tuple[int, bytes]], bytes]:
    """The server's whole frames, as opcode and payload, and what is left over."""
    frames, at = [], 0
    while len(received) - at >= 2:
        head, size, start = received[at] & 15, received[at + 1], at + 2
        if size == 126:
            size, start = int.from_bytes(received[at + 2 : at + 4], "big"), at + 4
        elif size == 127:
            size, start = int.from_bytes(received[at + 2 : at + 10], "big"), at + 10
        if start + size > len(received):
            break
        frames.append((head, received[start : start + size]))
        at = start + size
    return frames, received[at:]


@cache
def _recorded() -> FloatArray:
    return sample().events.table


def events(number: int, rate_hz: float, first: int, count: int) -> FloatArray:
    """Events ``first`` to ``first + count`` of a client, as rows of t s, x px, y px, dx, dy, buttons."""
    recorded = _recorded()
    places = np.arange(first, first + count)
    table = recorded[(places + number * APART) % len(recorded)]
    table[:, 0] = places / rate_hz
    return table


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
