"""WebSocket frames as bytes: whole data frames of a client, and frames to send, without a parser.

Almost every frame is a whole message in one piece. The parser of ``websockets`` reads all others.
"""

from __future__ import annotations

from struct import Struct

from websockets.frames import Opcode
from websockets.speedups import apply_mask

from pointpred.protocol.frames import Frame

WHOLE = 0x80
"""In the first byte of a frame: the last piece of a message, no reserved bit set."""
TEXT, BINARY = WHOLE | Opcode.TEXT, WHOLE | Opcode.BINARY
WHOLE_MESSAGES = TEXT, BINARY
MASKED = 0x80
"""In the second byte: the payload is masked, as every frame of a client must be."""
SHORT_BYTES, MIDDLE_BYTES = 126, 2**16
"""Payloads below these lengths have the length in one byte, or in two more bytes."""

USUAL_BYTES = 1024
"""Most payloads are shorter: the beginnings of their frames are made once."""

_middle_head, _long_head = Struct("!BBH"), Struct("!BBQ")


def frame_end(received: bytes, at: int) -> int:
    """Where the frame that begins at ``at`` ends; 0 where its length has not come yet.

    One that is not masked ends with its first two bytes: there the parser refuses it.
    """
    come = len(received) - at
    if come < 2:
        return 0
    if received[at + 1] < MASKED:
        return at + 2
    size = received[at + 1] & ~MASKED
    if size < SHORT_BYTES:
        return at + 6 + size
    extra = 2 if size == SHORT_BYTES else 8
    if come < 2 + extra:
        return 0
    return at + 6 + extra + int.from_bytes(received[at + 2 : at + 2 + extra], "big")


def whole_message(received: bytes, at: int, end: int) -> Frame | None:
    """The message in the frame from ``at`` to ``end``; ``None`` where the parser has to read it.

    That is a piece of a message, a control frame, or one that breaks a rule, such as text that is no UTF-8.
    """
    head, size = received[at], received[at + 1]
    if size < MASKED or head not in WHOLE_MESSAGES:
        return None
    size &= ~MASKED
    mask = at + (2 if size < SHORT_BYTES else 4 if size == SHORT_BYTES else 10)
    payload = apply_mask(received[mask + 4 : end], received[mask : mask + 4])
    if head == BINARY:
        return payload
    try:
        return payload.decode()
    except UnicodeDecodeError:
        return None


def framed(frame: Frame) -> bytes:
    """A message as the server sends it: one frame, not masked."""
    if isinstance(frame, str):
        payload = frame.encode()
        size = len(payload)
        return (_text_heads[size] if size < USUAL_BYTES else _head(TEXT, size)) + payload
    size = len(frame)
    return (_binary_heads[size] if size < USUAL_BYTES else _head(BINARY, size)) + frame


def _head(first: int, size: int) -> bytes:
    """The beginning of a frame with a payload of this size."""
    if size < SHORT_BYTES:
        return bytes((first, size))
    if size < MIDDLE_BYTES:
        return _middle_head.pack(first, SHORT_BYTES, size)
    return _long_head.pack(first, SHORT_BYTES + 1, size)


_text_heads = [_head(TEXT, size) for size in range(USUAL_BYTES)]
_binary_heads = [_head(BINARY, size) for size in range(USUAL_BYTES)]
