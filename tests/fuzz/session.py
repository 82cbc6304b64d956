"""Any frames of a client to a session, and any frames of a service to the Python client.

An input of several frames has each behind two bytes: the highest bit says binary, the others its length.
"""

from __future__ import annotations

import json

import msgspec
import numpy as np

from pointpred.client.session import ClientSession, hello_message
from pointpred.clock import Instant
from pointpred.errors import PointpredError
from pointpred.protocol.client_messages import ClientMessage
from pointpred.protocol.decoding import (
    check_numbers,
    decode_client_message,
    decode_server_message,
    rows_of_bytes,
)
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import PREDICTION, pack_events, pack_predictions
from pointpred.protocol.server_messages import Limits
from pointpred.registry import build
from pointpred_server.sessions.pointing import PointingSession
from tests.fuzz.refusals import refused

BINARY = 0x8000
LIMITS = Limits(max_frame_bytes=4096, max_events_per_frame=64, max_events_per_s=2000, max_targets=16)
PREDICTORS = ("hold", "switched", "kinematic")
HELLO = {"type": "hello", "version": 1, "predictor": "switched"}
EVENTS = [[0.01 * i, 5.0 * i, 2.0 * i * i, 4, -2, 0] for i in range(12)]
TARGET = {"id": "a", "x": 0, "y": 0, "width": 40, "height": 20}
MESSAGES = (
    HELLO,
    {**HELLO, "device": {"cpi": 800, "rate_hz": 1000}, "encoding": "binary", "reply": "event"},
    {**HELLO, "predictor": "kinematic-adaptive", "places": True, "person": ""},
    {**HELLO, "parameters": {"gap_s": 0.05}, "assist": {}, "screen": {"width_px": 9, "height_px": 9}},
    {"type": "events", "events": EVENTS},
    {"type": "events", "events": [[1, 2, 3, None, None, 0]]},
    {"type": "targets", "targets": [TARGET, {**TARGET, "id": "b", "x": 100, "weight": 2}]},
    {"type": "trial", "action": "start"},
    {"type": "trial", "action": "end", "target": {"x": 40, "y": 10, "width": 40}},
    {"type": "configure", "predictor": "hold", "precision": 0.9},
    {"type": "enter", "key": "editor", "x": 300, "y": 100},
    {"type": "person"},
    {"type": "forget"},
    {"type": "reset"},
    {"type": "bye", "reason": "done"},
)


def joined(*frames: str | bytes) -> bytes:
    """Frames as an input."""
    parts = [(frame.encode(), 0) if isinstance(frame, str) else (frame, BINARY) for frame in frames]
    return b"".join((len(data) | flag).to_bytes(2, "big") + data for data, flag in parts)


def frames_of(data: bytes) -> list[str | bytes]:
    """The frames of an input; text is what a socket passes on, valid UTF-8."""
    frames: list[str | bytes] = []
    while len(data) > 2:
        head = int.from_bytes(data[:2], "big")
        frame, data = data[2 : 2 + head % BINARY], data[2 + head % BINARY :]
        frames.append(frame if head >= BINARY else frame.decode(errors="replace"))
    return frames


def check_message(data: bytes) -> str:
    """One frame, as text and as packed records; a message is the same when it is encoded and read again."""
    try:
        table = np.array(rows_of_bytes(data)).reshape(-1, 6)
        check_numbers(table)
    except ProtocolError as error:
        refused(error)
    else:
        assert np.isfinite(table[:, :3]).all()
    text = data.decode(errors="replace")
    try:
        message = decode_client_message(text)
    except ProtocolError as error:
        return refused(error)
    again = decode_client_message(msgspec.json.encode(message).decode())
    assert isinstance(again, ClientMessage)
    assert again == message
    return "read"


def message_seeds() -> list[bytes]:
    return [json.dumps(one).encode() for one in MESSAGES] + [pack_events(np.array(EVENTS, np.float64))]


def check_session(data: bytes) -> str:
    """Frames to a session that was greeted: it answers in messages of the protocol, or ends."""
    session = PointingSession("fuzz", LIMITS, Instant(0.0))
    predictor = PREDICTORS[data[0] % len(PREDICTORS)] if data else PREDICTORS[0]
    hello = {**HELLO, "predictor": predictor}
    answered = 0
    for place, frame in enumerate([json.dumps(hello), *frames_of(data[1:])]):
        session.receive(frame, Instant(0.01 * place))
        for answer in session.outbox.take():
            answered += 1
            if isinstance(answer, bytes):
                assert len(answer) % PREDICTION[1].itemsize == 0
            else:
                decode_server_message(answer)
        if session.close is not None:
            assert session.close.code in (1000, 1008, 1009, 1013)
            return "ended"
    return "answered" if answered > 1 else "silent"


def session_seeds() -> list[bytes]:
    texts = [json.dumps(one) for one in MESSAGES]
    binary = pack_events(np.array(EVENTS, np.float64))
    whole = joined(*texts[4:14])
    return [b"\1" + joined(one) for one in texts] + [b"\0" + joined(binary), b"\2" + whole]


def check_client(data: bytes) -> str:
    """Frames of a service to the client."""
    client = ClientSession(hello_message())
    read = refusals = 0
    for frame in frames_of(data):
        try:
            client.receive(frame)
            read += 1
        except PointpredError as error:
            refused(error)
            refusals += 1
    while client.take() is not None:
        pass
    client.choices()
    return f"{min(read, 1)} read, {min(refusals, 1)} refused"


def client_seeds() -> list[bytes]:
    session = PointingSession("fuzz", LIMITS, Instant(0.0))
    answers: list[str | bytes] = []
    for message in (HELLO, *MESSAGES[4:]):
        session.receive(json.dumps(message), Instant(0.0))
        answers += session.outbox.take()
    pipeline = build("hold")
    rows = np.array([pipeline.advance(tuple(map(float, row))) for row in EVENTS[:3]])
    return [joined(one) for one in answers] + [joined(pack_predictions(rows)), joined(*answers)[:4000]]
