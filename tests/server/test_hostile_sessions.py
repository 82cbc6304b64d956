"""Sessions that stay within every limit and would still harm, or be harmed: over a real socket."""

from __future__ import annotations

import json
import struct

import pytest

import pointpred_server.websocket_protocol
from tests.server.listener import RECORD, soon
from tests.server.running import HELLO, PATIENCE_S, event, running, told

PACKED = HELLO[:-1] + ',"encoding":"binary","reply":"event"}'


def packed(first: int, count: int) -> bytes:
    rows = bytearray()
    for place in range(first, first + count):
        rows += struct.pack("<dddhhH", 1e-4 * place, 5.0, 6.0, -32768, -32768, 0)
    assert len(rows) == count * RECORD.itemsize
    return bytes(rows)


def test_a_burst_within_the_limits_is_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        pointpred_server.websocket_protocol, "STUCK_S", PATIENCE_S
    )  # it reads only when all is taken in
    with running(max_events_per_s=10**6) as here, here.greeted(PACKED, max_queue=1) as socket:
        for frame in range(960):
            socket.send(packed(64 * frame, 64))
        (session,) = here.service._open
        soon(lambda: session.outbox.predictions == 960 * 64, "every frame is taken in")
        told_of = 0
        while True:
            answer = socket.recv(PATIENCE_S)
            if isinstance(answer, str):
                said = json.loads(answer)
                assert (said["code"], said["recoverable"]) == ("slow", True)
                told_of += int(said["message"].split()[0])
                continue
            if struct.unpack_from("<d", answer, len(answer) - 65)[0] == 1e-4 * (960 * 64 - 1):
                break
        assert told_of == session.outbox.dropped_total > 10_000
        socket.send(packed(960 * 64, 1))
        assert struct.unpack_from("<d", socket.recv(PATIENCE_S))[0] == 1e-4 * 960 * 64


@pytest.mark.parametrize("predictor", ["switched", "hold"])
def test_parameters_that_make_events_costly_are_refused_by_their_names(predictor: str) -> None:
    costly = {"gap_s": 0.1, "step_s": 1e-5}
    with running() as here, here.connect() as socket:
        socket.send(json.dumps({"type": "hello", "version": 1, "predictor": predictor, "parameters": costly}))
        answer = told(socket)
        assert (answer["code"], answer["recoverable"]) == ("bad_field", True)
        assert answer["path"] == "$.parameters.step_s"
        assert all(word in str(answer["message"]) for word in ("gap_s", "step_s", "0.1", "1e-05"))
        socket.send(HELLO)
        assert told(socket)["type"] == "welcome"
        for parameters, path in (({"step_s": 2e-4}, "step_s"), ({"gap_s": 0.5}, "gap_s")):
            socket.send(json.dumps({"type": "configure", "parameters": parameters}))
            answer = told(socket)
            assert (answer["code"], answer["path"]) == ("bad_field", f"$.parameters.{path}")
        socket.send(json.dumps({"type": "configure", "parameters": {"gap_s": 0.25}}))
        assert told(socket)["type"] == "welcome"
        socket.send(event(1.0))
        assert told(socket)["t"] == 1.0


DEEP = "[" * 900 + "NaN" + "]" * 900
KEYS = '{"' + "k" * 500 + '":'


@pytest.mark.parametrize(
    "text",
    [
        pytest.param('{"a":' + DEEP + ',"type":"hello"}', id="lists"),
        pytest.param('{"type":"hello","parameters":{"a":' + DEEP + "}}", id="a parameter"),
        pytest.param(KEYS * 100 + "NaN" + "}" * 100, id="long keys"),
        pytest.param("[" * 30_000 + "NaN" + "]" * 30_000, id="deeper than any decoder goes"),
        pytest.param('{"a":' + "[" * 900 + "1" + "]" * 900 + ',"type":5}', id="a type that is none"),
    ],
)
def test_deep_text_is_answered_and_the_session_goes_on(text: str) -> None:
    with running() as here, here.greeted() as socket:
        socket.send(text)
        answer = told(socket)
        assert answer["type"] == "error"
        assert (answer["code"], answer["recoverable"]) in (("bad_field", True), ("bad_json", True))
        assert len(str(answer["path"] or "")) <= 203
        assert len(str(answer["message"])) <= 1003
        socket.send(event(1.0))
        assert told(socket)["t"] == 1.0


def test_a_type_that_is_no_text_is_a_bad_field() -> None:
    with running() as here, here.greeted() as socket:
        for text, code in (('{"type":5}', "bad_field"), ('{"type":"five"}', "unknown_type")):
            socket.send(text)
            answer = told(socket)
            assert (answer["code"], answer["path"]) == (code, "$.type")
            assert "hello, events" in str(answer["message"])
