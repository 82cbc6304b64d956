"""Frames as a client sends them: events of a reach, packed or JSON, in WebSocket's framing."""

from __future__ import annotations

import json
from struct import Struct

import numpy as np

from benchmarks.per_event import reach

EVENT = Struct("<dddhhH")
TEXT, BINARY, CLOSE, PING = 1, 2, 8, 9


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


def hello(predictor: str, encoding: str) -> bytes:
    """The first message of a session: a device of 2000 CPI."""
    message = {"type": "hello", "version": 1, "predictor": predictor, "encoding": encoding}
    return frame(TEXT, json.dumps({**message, "device": {"cpi": 2000}}).encode())


def targets(count: int) -> bytes:
    """So many targets, in rows of eight."""
    size = {"width": 60.0, "height": 40.0}
    listed = [{"id": str(i), "x": 200.0 * (i % 8), "y": 150.0 * (i // 8), **size} for i in range(count)]
    return frame(TEXT, json.dumps({"type": "targets", "targets": listed}).encode())


RESET = frame(TEXT, b'{"type":"reset"}')


def events(encoding: str, count: int, size: int, period_s: float) -> list[bytes]:
    """``count`` frames of ``size`` events, ``period_s`` apart: one reach after another."""
    numbers = np.arange(count * size)
    table = reach().table
    rows = table[numbers % len(table)]
    rows[:, 0] = numbers * period_s
    values = rows.tolist()
    frames = []
    for first in range(0, len(values), size):
        part = values[first : first + size]
        if encoding == "binary":
            packed = b"".join(EVENT.pack(*row[:3], *map(int, row[3:])) for row in part)
            frames.append(frame(BINARY, packed))
        else:
            listed = [[*row[:5], int(row[5])] for row in part]
            frames.append(frame(TEXT, json.dumps({"type": "events", "events": listed}).encode()))
    return frames


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
