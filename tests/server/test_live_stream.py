"""``/v1/live`` over a real socket: what viewers of an attached device hear, and what they may not do."""

from __future__ import annotations

import json
import time
from contextlib import suppress
from itertools import count
from socket import SO_RCVBUF, SOL_SOCKET
from typing import Any

import pytest
from httpx2 import get
from msgspec.structs import replace
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

import pointpred_server.websocket_protocol
from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.protocol.server_messages import Curve
from pointpred.transfer import TransferLearner
from pointpred_server.live_feed import MOST_WAITING
from tests.server.listener import soon
from tests.server.live_attached import ATTACHED, Attachment, attached
from tests.server.running import PATIENCE_S, Running, running


def look(here: Running, query: str = "", **options: Any) -> ClientConnection:
    url = f"ws://127.0.0.1:{here.port}/v1/live{query}"
    settings = {"open_timeout": PATIENCE_S, "compression": None, **options}
    return connect(url, subprotocols=[Subprotocol(SUBPROTOCOL)], **settings)


def hear(socket: ClientConnection, kind: str) -> dict[str, Any]:
    """The next message of a type."""
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        message: dict[str, Any] = json.loads(socket.recv(PATIENCE_S))
        if message["type"] == kind:
            return message
    raise AssertionError(f"no {kind} within {PATIENCE_S:g} s")


def ended(socket: ClientConnection) -> int:
    """The close code with which the service ends a connection."""
    with suppress(ConnectionClosed):
        while True:
            socket.recv(PATIENCE_S)
    assert socket.close_code is not None
    return socket.close_code


def test_a_viewer_gets_the_device_then_events_and_predictions() -> None:
    with attached() as (here, made), look(here) as socket:
        first = json.loads(socket.recv(PATIENCE_S))
        assert first == json.loads(json.dumps({"type": "device", **_told(ATTACHED)}))
        assert hear(socket, "status")["reports"] == 0
        events: list[list[float]] = []
        newest = None
        sent = made.move(1.0)
        while len(events) < sent:
            message = json.loads(socket.recv(PATIENCE_S))
            if message["type"] == "events":
                events += message["events"]
            elif message["type"] == "prediction":
                newest = message
        event, prediction = made.session.newest or (None, None)
        assert event is not None
        assert prediction is not None
        assert events[-1] == [event.t, event.x, event.y, event.dx, event.dy, event.buttons]
        newest = newest or hear(socket, "prediction")
        assert (newest["t"], newest["x"], newest["phase"]) == (event.t, prediction.x, prediction.phase)
        assert hear(socket, "status")["reports"] == sent


def _told(struct: Any) -> dict[str, Any]:
    return {name: getattr(struct, name) for name in struct.__struct_fields__}


def test_where_nothing_is_attached_it_is_404_with_what_to_do_next() -> None:
    with running() as here:
        with pytest.raises(InvalidStatus) as refused:
            look(here)
        assert refused.value.response.status_code == 404
        told = json.loads(refused.value.response.body or b"")
        assert told["type"] == "error"
        assert "pointpred live --serve" in told["message"]
        asked = get(f"{here.url}/v1/live", timeout=PATIENCE_S).json()
        assert asked["attached"] is None
        assert asked["message"] == told["message"]
        with pytest.raises(InvalidStatus) as foreign:
            look(here, origin="https://elsewhere.example")
        assert foreign.value.response.status_code == 403  # what is here is no other site's business


def test_http_says_what_is_attached() -> None:
    with attached() as (here, _):
        assert get(f"{here.url}/v1/live", timeout=PATIENCE_S).json()["attached"]["name"] == "a made-up mouse"


def test_foreign_pages_and_those_without_the_token_see_nothing() -> None:
    with attached(token="open sesame") as (here, _):
        with pytest.raises(InvalidStatus) as refused:
            look(here, "?token=open%20sesame", origin="https://elsewhere.example")
        assert refused.value.response.status_code == 403
        with look(here) as socket:
            told = json.loads(socket.recv(PATIENCE_S))
            assert (told["type"], told["code"]) == ("error", "unauthorized")
            assert ended(socket) == 1008
        assert get(f"{here.url}/v1/live", timeout=PATIENCE_S).status_code == 401
        with look(here, "?token=open%20sesame") as socket:
            assert hear(socket, "device")
    with running(token="open sesame") as here, look(here) as socket:  # not even whether there is a device
        assert hear(socket, "error")["code"] == "unauthorized"


@pytest.mark.parametrize(
    ("frame", "code"),
    [
        ('{"type":"hello","version":1,"predictor":"switched"}', "out_of_place"),
        ('{"type":"events","events":[[0,1,2,null,null,0]]}', "out_of_place"),
        (b"\0" * 30, "out_of_place"),
        ("nonsense", "bad_json"),
        ('{"type":"dance"}', "unknown_type"),
        ('{"type":"bye","reason":7}', "bad_field"),
    ],
)
def test_what_a_viewer_says_is_answered_and_changes_nothing(frame: str | bytes, code: str) -> None:
    with attached() as (here, made), look(here) as socket:
        hear(socket, "status")
        socket.send(frame)
        assert hear(socket, "error")["code"] == code
        made.move(1.0)
        assert hear(socket, "prediction")["x"] is not None


@pytest.mark.parametrize(("frame", "count", "code"), [("x" * 70_000, 1, 1009), ("[]", 600, 1008)])
def test_a_viewer_that_says_too_much_is_sent_away(
    frame: str, count: int, code: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    # So few that however slowly the machine sends and reads them, it is faster.
    monkeypatch.setattr("pointpred_server.sessions.quota.MESSAGES_PER_S", 5)
    with attached() as (here, _), look(here) as socket:
        with suppress(ConnectionClosed):
            for _ in range(count):
                socket.send(frame)
        assert ended(socket) == code


def test_a_goodbye_is_taken_and_the_service_says_its_own() -> None:
    with attached() as (here, _), look(here) as socket, look(here) as other:
        socket.send('{"type":"bye"}')
        assert ended(socket) == 1000
        here.server.should_exit = True
        assert hear(other, "bye")["reason"] == "the server stops"


def test_viewers_count_as_sessions() -> None:
    with attached(max_sessions=1) as (here, _), look(here) as socket:
        hear(socket, "device")
        with look(here) as second:
            assert hear(second, "error")["code"] == "too_many"


def test_a_viewer_that_does_not_read_gets_the_newest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(pointpred_server.websocket_protocol, "STUCK_S", PATIENCE_S)
    moves = count()
    with attached() as (here, made), look(here, max_queue=1) as socket:
        hear(socket, "status")
        socket.socket.setsockopt(SOL_SOCKET, SO_RCVBUF, 2**16)
        (viewer,) = here.service._open
        # However seldom the service has its turn: each time it sends what has come, until no more goes out.
        soon(lambda: made.move(float(next(moves))) and viewer.outbox.dropped_total > 1000, "some gave way")
        told = hear(socket, "error")
        assert (told["code"], told["recoverable"]) == ("slow", True)
        newest = made.session.newest
        assert newest is not None
        while hear(socket, "prediction")["t"] != newest[0].t:
            pass


def test_a_late_event_loop_leaves_out_the_oldest_and_counts_them() -> None:
    class Later:
        def call_soon_threadsafe(self, *call: Any) -> None:
            """Never gets round to it."""

    made = Attachment()
    made.feed.start(Later())  # type: ignore[arg-type]
    made.feed._viewers[object()] = lambda: None  # type: ignore[index]
    sent = sum(made.move(float(i)) for i in range(4))
    assert made.feed.skipped == sent - MOST_WAITING


def test_a_device_outlives_the_service_it_was_shown_by() -> None:
    with attached() as (here, made), look(here) as socket:
        hear(socket, "status")
    made.feed._viewers[object()] = lambda: None  # type: ignore[index]
    made.move(1.0)
    made.feed.fail("nobody hears it")
    assert made.move(2.0) * 2 == made.session.reports


def test_the_curve_is_said_when_it_is_new() -> None:
    with attached() as (here, made):
        made.feed.curve = Curve("identified", TransferLearner(cpi=800.0).curve())
        with look(here) as socket:
            assert hear(socket, "transfer")["curve"]["gains"] == []
            made.feed.curve = Curve("nothing learnt yet")
            assert hear(socket, "transfer")["words"] == "nothing learnt yet"


def test_another_device_is_said_and_so_is_silence() -> None:
    with attached() as (here, made), look(here) as socket:
        assert hear(socket, "device")["name"] == "a made-up mouse"
        assert hear(socket, "status")["note"] is None
        made.session.note = lambda: "nothing moves"
        made.feed.attached = replace(made.feed.attached, name="another mouse")
        assert hear(socket, "device")["name"] == "another mouse"
        assert hear(socket, "status")["note"] == "nothing moves"


def test_a_session_that_fails_ends_its_viewers_with_a_reason() -> None:
    with attached() as (here, made), look(here) as socket:
        hear(socket, "status")
        made.feed.fail("the device's session failed")
        assert hear(socket, "error")["message"] == "the device's session failed"
        assert ended(socket) == 1011
