"""Both Python clients: the same calls, the same last words, the same patience, the same bounds."""

from __future__ import annotations

import asyncio
import inspect
import re
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.server import ServerConnection, serve

from pointpred.client import AsyncConnection, Connection, ServiceError, connect, connect_async
from pointpred.client.session import KEPT_NOTICES, ClientSession, hello_message
from pointpred.errors import ParameterError, SourceError
from pointpred.protocol.server_messages import ErrorMessage, Limits, PredictionMessage, Welcome, encode
from tests.server.listener import Listener, soon

WELCOME = encode(Welcome(1, "here", "hold", Limits())).decode()
PREDICTION = encode(PredictionMessage(0.0)).decode()
GAVE_WAY = encode(ErrorMessage("slow", "1 predictions gave way")).decode()
LAST = encode(ErrorMessage("idle", "nothing was heard for 60 s", None, recoverable=False)).decode()
PATIENCE_S = 120.0
"""For what is bound to come, however busy the machine is."""
PAGE = Path(__file__).parents[2] / "docs" / "guide" / "python-client.md"


@contextmanager
def answering(talk: Any) -> Iterator[str]:
    """A service that does as told once it has said welcome."""

    def welcome(connection: ServerConnection) -> None:
        connection.recv()
        connection.send(WELCOME)
        with suppress(ConnectionClosed):
            talk(connection)

    with serve(welcome, "127.0.0.1", 0, compression=None, close_timeout=1, ping_interval=None) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"ws://127.0.0.1:{server.socket.getsockname()[1]}"
        finally:
            server.shutdown()
            thread.join()


def calls(kind: type) -> dict[str, list[str]]:
    """The public calls of a class and what they take."""
    public = {name: each for name, each in vars(kind).items() if not name.startswith("_")}
    return {
        name: [] if isinstance(each, property) else list(inspect.signature(each).parameters)
        for name, each in public.items()
    }


def test_both_connections_have_the_same_calls() -> None:
    assert calls(AsyncConnection) == calls(Connection)
    shared = {"choices", "proposed", "cursor", "welcome", "limits", "notices", "noticed"}
    for name in (calls(Connection).keys() | shared) - {"start"}:
        assert re.search(rf"\| .*`{name}\b", PAGE.read_text()), f"{name} is not in {PAGE.name}"


def test_asyncio_looks_at_what_is_there() -> None:
    async def talk(url: str) -> None:
        async with await connect_async(
            url, timeout_s=PATIENCE_S, predictor="hold", reply="event"
        ) as connection:
            assert connection.welcome.predictor == "hold"
            assert connection.limits == Limits()
            assert len(await connection.poll()) == 0
            await connection.send([(0.0, 1, 2), (0.1, 3, 4)])
            until, heard = time.monotonic() + PATIENCE_S, []
            while len(heard) < 2 and time.monotonic() < until:
                heard.extend((await connection.poll()).t.tolist())
            assert heard == [0.0, 0.1]
            assert len(await connection.columns()) == 0

    with Listener() as listener:
        asyncio.run(talk(listener.url))


def test_polling_takes_all_that_has_arrived_and_notices_the_end() -> None:
    said, looked = threading.Event(), threading.Event()

    def leave(connection: ServerConnection) -> None:
        for _ in range(3):
            connection.send(PREDICTION)
        said.set()
        assert looked.wait(PATIENCE_S)

    async def talk(url: str) -> None:
        connection = await connect_async(url, timeout_s=PATIENCE_S)
        assert await asyncio.to_thread(said.wait, PATIENCE_S)
        await (await connection._socket.ping())  # what was sent before the answer to it has arrived
        assert len(await connection.poll()) == 3
        looked.set()
        await connection._socket.wait_closed()
        with pytest.raises(SourceError, match="closed the session: 1000"):
            await connection.poll()
        await connection.close()

    with answering(leave) as url:
        asyncio.run(talk(url))


def leave_in_words(connection: ServerConnection) -> None:
    connection.send(LAST)


def test_the_last_words_are_heard_when_nothing_can_be_sent() -> None:
    async def talk(url: str) -> None:
        connection = await connect_async(url, timeout_s=PATIENCE_S)
        await connection._socket.wait_closed()
        with pytest.raises(ServiceError, match="idle: nothing was heard"):
            await connection.reset()
        with pytest.raises(SourceError, match="closed the session: 1000"):
            await connection.reset()
        await connection.close()

    with answering(leave_in_words) as url:
        asyncio.run(talk(url))
        connection = connect(url, timeout_s=PATIENCE_S)
        soon(lambda: connection._socket.close_code is not None, "the service has left")
        with pytest.raises(ServiceError, match="idle: nothing was heard"):
            connection.reset()
        connection.close()


def predict_for_ever(connection: ServerConnection) -> None:
    until = time.monotonic() + PATIENCE_S
    while time.monotonic() < until:  # sooner, the client leaves
        connection.send(PREDICTION)
        time.sleep(0.001)


def test_predictions_do_not_lengthen_the_wait_for_an_answer() -> None:
    async def talk(url: str) -> float:
        async with await connect_async(url, timeout_s=PATIENCE_S) as connection:
            connection.timeout_s = 0.5
            began = time.monotonic()
            with pytest.raises(SourceError, match=r"did not answer for 0\.5 s"):
                await connection.targets([])
            return time.monotonic() - began

    with answering(predict_for_ever) as url:
        assert asyncio.run(talk(url)) < PATIENCE_S / 2
        with connect(url, timeout_s=PATIENCE_S) as connection:
            connection.timeout_s = 0.5
            began = time.monotonic()
            with pytest.raises(SourceError, match=r"did not answer for 0\.5 s"):
                connection.targets([])
            assert time.monotonic() - began < PATIENCE_S / 2


def test_a_client_that_was_told_more_than_it_read_can_leave(monkeypatch: pytest.MonkeyPatch) -> None:
    """The library's reader stands still while many frames wait to be read; leaving must not wait for it."""
    monkeypatch.setattr("pointpred.client.session.QUEUE", 4)
    all_is_said = threading.Event()

    def flood(socket: ServerConnection) -> None:
        for _ in range(3000):
            socket.send(PREDICTION)
        all_is_said.set()
        with suppress(ConnectionClosed):
            while True:
                socket.recv()

    with answering(flood) as url:
        connection = connect(url, timeout_s=PATIENCE_S)
        assert all_is_said.wait(PATIENCE_S)
        time.sleep(0.3)
        connection.close()
        assert connection._socket.close_code == 1000, "it was cut, after the library's patience had ended"


def test_the_newest_notices_are_kept_and_all_are_counted() -> None:
    talk = ClientSession(hello_message())
    for _ in range(KEPT_NOTICES + 5):
        assert talk.receive(GAVE_WAY) is None
    assert len(talk.notices) == KEPT_NOTICES
    assert talk.noticed == KEPT_NOTICES + 5


def many(count: int) -> list[dict[str, Any]]:
    """Targets as a browser measures them."""
    return [
        {"id": f"target-{k}", "x": k / 3, "y": k / 7, "width": 100 / 3, "height": 50 / 7}
        for k in range(count)
    ]


def test_a_message_over_the_limit_is_not_sent() -> None:
    said = r"targets: a frame holds at most 65536 bytes, received \d{5,}"

    async def talk(url: str) -> None:
        async with await connect_async(url, timeout_s=PATIENCE_S) as connection:
            with pytest.raises(ParameterError, match=said):
                await connection.targets(many(1000))
            assert await connection.targets(many(500)) == 500

    with Listener(limits=Limits(max_targets=1000)) as listener:
        with connect(listener.url, timeout_s=PATIENCE_S) as connection:
            with pytest.raises(ParameterError, match=said):
                connection.targets(many(1000))
            assert connection.targets(many(500)) == 500
            with pytest.raises(ParameterError, match="configure: a frame holds at most 65536 bytes"):
                connection.configure(parameters={"delay_s": [0.1] * 20_000})
            assert connection.targets([]) == 0
        asyncio.run(talk(listener.url))
        assert max(map(len, listener.frames)) <= 65536


def test_a_message_of_just_the_limit_is_sent() -> None:
    size = len(encode({"type": "targets", "targets": many(3)}))
    for most in (size, size - 1):
        with (
            Listener(limits=Limits(max_frame_bytes=most)) as listener,
            connect(listener.url, timeout_s=PATIENCE_S) as connection,
        ):
            if most == size:
                assert connection.targets(many(3)) == 3
            else:
                with pytest.raises(ParameterError, match=f"at most {most} bytes, received {size}"):
                    connection.targets(many(3))
