"""WebSocket framing as a client writes and reads it: unchecked, so that wrong frames can be sent."""

from __future__ import annotations

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


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
