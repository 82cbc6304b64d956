"""The WebSocket over a real socket: every row of the table of bad input, and the next good event after it."""

from __future__ import annotations

import json
import resource
from contextlib import suppress

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection

from pointpred_server.sessions.quota import MESSAGES_PER_S
from tests.server.listener import soon
from tests.server.running import HELLO, PATIENCE_S, Running, ends, running, told


def good(socket: ClientConnection, t: float = 1.0) -> None:
    """The next good event is answered."""
    socket.send(f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}')
    answer = told(socket)
    assert answer["type"] == "prediction"
    assert answer["t"] == t


@pytest.mark.parametrize(("frame", "code"), [("{oops", "bad_json"), (b"12345", "bad_field")])
def test_bad_input_is_answered_and_the_session_lives(service: Running, frame: str | bytes, code: str) -> None:
    """What else is bad input, and how it is answered, ``tests/unit/test_server_bad_input.py`` holds."""
    with service.greeted() as socket:
        socket.send(frame)
        answer = told(socket)
        assert (answer["type"], answer["code"], answer["recoverable"]) == ("error", code, True)
        good(socket)


def test_too_large_a_frame_ends_the_session_with_1009(service: Running) -> None:
    with service.greeted() as socket:
        socket.send(b"0" * 70_000)
        ends(socket, "too_large", 1009)
    with service.greeted() as socket:
        socket.send(b"\0" * 30 * 65)
        ends(socket, "too_large", 1009)
    with service.greeted() as socket:  # the process goes on
        good(socket)


def test_too_many_events_a_second_end_the_session_with_1008() -> None:
    with running(max_events_per_s=50) as here, here.greeted() as socket:
        row = [0.0, 1.0, 1.0, None, None, 0]
        socket.send(json.dumps({"type": "events", "events": [row] * 51}))
        ends(socket, "too_fast", 1008)


@pytest.mark.parametrize(
    "message",
    [
        '{"type":"reset"}',
        '{"type":"configure","predictor":"linear"}',
        '{"type":"targets","targets":[]}',
        '{"type":"trial","action":"start"}',
        "{oops",
    ],
)
def test_a_flood_of_other_messages_ends_the_session_with_1008(
    message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Fewer than the slowest machine takes in: it is the sixth message of a second that ends a session.
    monkeypatch.setattr("pointpred_server.sessions.quota.MESSAGES_PER_S", 5)
    monkeypatch.setattr("pointpred_server.sessions.pointing.BUILDING", 1)
    with running() as service, service.greeted() as other, service.greeted() as socket:
        with suppress(ConnectionClosed):  # it may hear the end before it has said everything
            for _ in range(5 * MESSAGES_PER_S):
                socket.send(message)
        last = told(socket)
        with suppress(ConnectionClosed):
            while True:
                last = told(socket)
        assert (last["code"], last["recoverable"]) == ("too_fast", False)
        assert socket.close_code == 1008
        good(other)


def test_silence_ends_the_session_with_1008() -> None:
    with running(idle_s=0.5) as here, here.greeted() as socket:
        ends(socket, "idle", 1008)


def test_more_sessions_than_allowed_are_turned_away_with_1013() -> None:
    with running(max_sessions=1) as here, here.greeted() as first:
        with here.connect() as second:
            ends(second, "too_many", 1013)
        good(first)


def test_a_foreign_page_is_refused_before_the_upgrade(service: Running) -> None:
    with pytest.raises(InvalidStatus) as refused:
        service.connect(origin="http://evil.example")
    assert refused.value.response.status_code == 403
    with pytest.raises(InvalidStatus) as refused:
        service.connect(additional_headers={"Host": "evil.example"})
    assert refused.value.response.status_code == 400, "two of them"
    with service.connect(origin=service.url) as socket:
        socket.send(HELLO)
        assert told(socket)["type"] == "welcome"


def test_another_sites_page_connects_where_it_is_allowed() -> None:
    with (
        running(allow_origin=["https://lab.example"]) as here,
        here.connect(origin="https://lab.example") as socket,
    ):
        socket.send(HELLO)
        assert told(socket)["type"] == "welcome"


def test_a_token_is_asked_for_where_there_is_one() -> None:
    with running(token="open sesame") as here:
        with here.connect() as socket:
            ends(socket, "unauthorized", 1008)
        for shown in (
            {"query": "?token=open%20sesame"},
            {"additional_headers": {"Authorization": "Bearer open sesame"}},
        ):
            with here.connect(**shown) as socket:
                socket.send(HELLO)
                assert told(socket)["type"] == "welcome"


def test_a_service_that_stops_says_bye_and_closes_with_1001() -> None:
    with running() as here, here.greeted() as socket:
        good(socket)
        here.server.should_exit = True
        assert told(socket)["type"] == "bye"
        with pytest.raises(ConnectionClosed) as closed:
            socket.recv(PATIENCE_S)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1001


def dropped(here: Running) -> float:
    """Predictions that gave way, as the service itself counts them."""
    (family,) = here.service.metrics.dropped.collect()
    return next(one.value for one in family.samples if one.name.endswith("_total"))


def test_a_client_that_does_not_read_costs_no_memory() -> None:
    """It sends far more answers' worth than any buffer holds; what it missed is counted, not kept."""
    with running(max_events_per_s=10**8) as here, here.greeted() as other:
        hello = HELLO.replace('"switched"', '"switched","reply":"event"')
        with here.greeted(hello, max_queue=1, close_timeout=0.5) as silent:
            rows = [[0.001 * i, float(i), 1.0, None, None, 0] for i in range(64)]
            before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            for k in range(6000):  # 384,000 predictions, about 50 MB of JSON
                for row in rows:
                    row[0] += 1.0
                try:
                    silent.send(json.dumps({"type": "events", "events": rows}))
                except ConnectionClosed:
                    break
                if k % 1000 == 0:
                    good(other, float(k + 1))
            soon(lambda: dropped(here) > 0, "what it missed is counted")
            grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
        assert grown < 40_000  # kB
        good(other, 1e6)
