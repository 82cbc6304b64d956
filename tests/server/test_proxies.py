"""The service behind nginx and HAProxy, with the configurations in deploy/ and the example of the guide."""

from __future__ import annotations

import asyncio
import json
import ssl
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import HTTPSHandler, Request, build_opener

import numpy as np
import pytest
from websockets.exceptions import InvalidStatus, WebSocketException
from websockets.sync.client import connect as dial
from websockets.typing import Origin, Subprotocol

from pointpred import EventColumns, PredictionColumns, build, run
from pointpred.client import AsyncConnection, ServiceError, connect, connect_async
from pointpred.errors import SourceError
from tests.server import browser
from tests.server import reverse_proxies as proxies
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, Running, running
from tests.server.test_chromium_client import CONNECT

TOKEN = "open-sesame-9"
PERSON = "kinematic-adaptive"
ON_THE_WIRE = 9
"""Columns of a prediction that are sent."""
KINDS = [
    pytest.param(
        name,
        tls,
        marks=pytest.mark.skipif(
            proxies.PROGRAMS[name] is None or (tls and proxies.OPENSSL is None),
            reason=f"{name} or openssl is not installed",
        ),
        id=f"{name}, {'TLS' if tls else 'plain'}",
    )
    for name in ("nginx", "haproxy")
    for tls in (True, False)
]
SERVING = {"token": TOKEN, "allow_host": ["lab.example"], "trust_proxy": ["127.0.0.1"]}


class Proxied:
    """Two services behind a proxy."""

    def __init__(self, services: list[Running], port: int, folder: Path, *, tls: bool) -> None:
        self.services, self.port = services, port
        self.origin = f"{'https' if tls else 'http'}://localhost:{port}"
        self._trust = ssl.create_default_context(cafile=folder / "lab.crt") if tls else None
        if self._trust is not None:
            self._trust.maximum_version = ssl.TLSVersion.TLSv1_2  # see pointpred/client/connection.py

    def get(self, path: str, **headers: str) -> tuple[int, bytes]:
        """The status and the body of an answer."""
        opener = build_opener(HTTPSHandler(context=self._trust))
        headers = {"Authorization": f"Bearer {TOKEN}", **headers}
        try:
            with opener.open(Request(f"{self.origin}{path}", headers=headers), timeout=PATIENCE_S) as answer:
                return answer.status, answer.read()
        except HTTPError as error:
            return error.code, error.read()

    def dial(self, origin: str, token: str = TOKEN) -> Any:
        """A WebSocket, as a page of an origin opens it."""
        url = self.origin.replace("http", "ws", 1)
        return dial(
            f"{url}/v1/stream?token={token}",
            origin=Origin(origin),
            ssl=self._trust,
            subprotocols=[Subprotocol("pointpred.v1")],
            open_timeout=PATIENCE_S,
        )

    def sessions(self) -> list[int]:
        return [len(each.service._open) for each in self.services]

    def stop(self, number: int) -> None:
        """As SIGTERM does."""
        self.services[number].server.should_exit = True


@contextmanager
def proxied(name: str, folder: Path, *, tls: bool) -> Iterator[Proxied]:
    with ExitStack() as stack:
        services = [stack.enter_context(running(**SERVING)) for _ in range(2)]
        ports = [each.port for each in services]
        port = stack.enter_context(proxies.proxy(name, folder, ports, tls=tls))
        here = Proxied(services, port, folder, tls=tls)
        soon(lambda: here.get("/healthz")[0] == 200, "the proxy passes requests on")
        yield here


@pytest.fixture
def trusted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Clients believe the certificate of the test."""
    monkeypatch.setenv("SSL_CERT_FILE", str(tmp_path / "lab.crt"))


def movements(count: int) -> list[EventColumns]:
    """Reaches of different lengths, each 0.6 s."""
    t = np.arange(60) / 100
    s = np.minimum(t / 0.5, 1.0)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    return [
        EventColumns.of(t + i, np.round((300 + 60 * i) * way), np.round(20 * i * way)) for i in range(count)
    ]


def without_a_break(parts: list[EventColumns]) -> list[PredictionColumns]:
    """What one pipeline predicts along all movements."""
    pipeline = build(PERSON)
    predicted = []
    for part in parts:
        predicted.append(run(pipeline, part))
        pipeline.reset()
    return predicted


def assert_same(predicted: list[PredictionColumns], expected: list[PredictionColumns]) -> None:
    assert len(predicted) == len(expected)
    for one, other in zip(predicted, expected, strict=True):
        np.testing.assert_array_equal(one.table[:, :ON_THE_WIRE], other.table[:, :ON_THE_WIRE])


@pytest.mark.parametrize(("name", "tls"), KINDS)
@pytest.mark.usefixtures("trusted")
def test_who_may_connect_and_how_sessions_are_spread(name: str, tls: bool, tmp_path: Path) -> None:
    with proxied(name, tmp_path, tls=tls) as here:
        assert here.get("/readyz")[0] == 200
        assert b"pointpred" in here.get("/")[1]
        assert here.get("/", Authorization="Bearer another-one")[0] == 401
        assert here.get("/", Host="lab.example")[0] == 200
        assert here.get("/", Host="elsewhere.example")[0] == 403
        with here.dial(here.origin) as socket:
            socket.send('{"type":"hello","version":1,"predictor":"hold"}')
            assert '"welcome"' in socket.recv(PATIENCE_S)
        other = here.origin.replace("https", "http") if tls else here.origin.replace("http", "https")
        for origin in ("https://elsewhere.example", other):
            with pytest.raises(InvalidStatus):
                here.dial(origin)
        with pytest.raises(ServiceError, match="token"):
            connect(here.origin, token="another-one", timeout_s=PATIENCE_S)
        soon(lambda: here.sessions() == [0, 0], "all have left")
        (events,) = movements(1)
        expected = run(build("switched"), events)
        options = {"token": TOKEN, "timeout_s": PATIENCE_S, "predictor": "switched", "reply": "event"}
        with ExitStack() as stack:
            clients = [stack.enter_context(connect(here.origin, **options)) for _ in range(6)]
            assert here.sessions() == [3, 3]
            if tls:  # requests were lost with TLS 1.3
                assert {client._socket.socket.version() for client in clients} == {"TLSv1.2"}
            for client in clients:
                client.send(events)
                np.testing.assert_array_equal(client.columns().table, expected.table)


@pytest.mark.parametrize(("name", "tls"), KINDS[1::2])
def test_one_address_has_fifty_connections_and_no_log_holds_a_token(
    name: str, tls: bool, tmp_path: Path
) -> None:
    with proxied(name, tmp_path, tls=tls) as here:
        with ExitStack() as stack:
            for _ in range(50):
                stack.enter_context(here.dial(here.origin))
            with pytest.raises((WebSocketException, OSError)), here.dial(here.origin):
                pass
        soon(lambda: here.sessions() == [0, 0], "all have left")
        with here.dial(here.origin):
            pass
        for number in range(2):
            here.stop(number)
        soon(lambda: here.get(f"/v1/predictors?token={TOKEN}")[0] in (502, 503), "no service answers")
    written = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert [file for file, text in written.items() if TOKEN in text] == []


class Interrupting(list[EventColumns]):
    """Movements; something is done when one of them is asked for."""

    def __init__(self, parts: list[EventColumns], at: dict[int, Callable[[], None]]) -> None:
        super().__init__(parts)
        self._at = at

    def __getitem__(self, place: Any) -> Any:
        if place in self._at:
            self._at.pop(place)()
        return super().__getitem__(place)


@pytest.mark.parametrize(("name", "tls"), KINDS[::2])
@pytest.mark.usefixtures("trusted")
def test_a_person_goes_on_at_another_service(name: str, tls: bool, tmp_path: Path) -> None:
    parts = movements(6)
    expected = without_a_break(parts)
    with proxied(name, tmp_path, tls=tls) as here:

        def stop_serving() -> None:
            """Stop the service that has the session; the other one goes on."""
            here.stop(here.sessions().index(1))
            soon(lambda: sum(each.service.stopping for each in here.services) == 1, "it stops")

        predicted = proxies.example()["predict_movements"](
            here.origin, Interrupting(parts, {3: stop_serving}), token=TOKEN, timeout_s=PATIENCE_S
        )
        assert_same(predicted, expected)
        stopped = [each.service.stopping for each in here.services]
        assert sorted(stopped) == [False, True]
        assert_same(asyncio.run(predict_async(here.origin, parts)), expected)


async def predict_async(url: str, parts: list[EventColumns]) -> list[PredictionColumns]:
    """As the guide's example, with a new connection for each movement."""
    person, predicted = "", []
    for part in parts:
        connection: AsyncConnection = await connect_async(
            url, token=TOKEN, timeout_s=PATIENCE_S, reply="event", person=person
        )
        async with connection:
            await connection.send(part)
            predicted.append(await connection.columns())
            await connection.reset()
            person = await connection.person()
    return predicted


def test_a_movement_that_was_interrupted_is_sent_again() -> None:
    """The service stops while events of a movement are on their way, and another one takes its place."""
    parts = movements(4)
    with running(**SERVING) as one, running(**SERVING) as two:
        addresses = iter([one.url, two.url, two.url])
        connects = iter([one, two])

        def connect_in_turn(url: str, **options: Any) -> Any:
            connection = connect(next(addresses), **options)
            send, serving = connection.send, next(connects)

            def send_and_stop(events: EventColumns) -> int:
                count = send(events)
                if serving is one and len(sent) == 2:
                    serving.server.should_exit = True
                sent.append(events)
                return count

            connection.send = send_and_stop  # type: ignore[method-assign, assignment]
            return connection

        sent: list[Any] = []
        names = proxies.example()
        names["connect"] = connect_in_turn
        predicted = names["predict_movements"]("any", parts, token=TOKEN, timeout_s=PATIENCE_S)
    assert_same(predicted, without_a_break(parts))


@browser.needed
@pytest.mark.skipif(proxies.PROGRAMS["nginx"] is None, reason="nginx is not installed")
def test_the_browser_client_goes_on_at_another_service(tmp_path: Path) -> None:
    parts = movements(4)
    options = {"token": TOKEN, "predictor": PERSON, "reply": "event", "pointer": False}
    with (
        proxied("nginx", tmp_path, tls=False) as here,
        browser.running(tmp_path / "profile") as chromium,
        chromium.tab(f"{here.origin}/healthz") as page,
    ):
        page.evaluate(CONNECT.replace("OPTIONS", json.dumps(options)))
        heard = []
        for place, part in enumerate(parts):
            soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")
            rows = [[t, x, y, None, None, 0] for t, x, y in part.table[:, :3].tolist()]
            page.evaluate(f"heard.prediction.length = 0; connection.send({json.dumps(rows)})")
            soon(lambda: page.evaluate("heard.prediction.length") == 60, "every prediction")
            page.evaluate("connection.reset()")
            heard.append(page.evaluate("heard.prediction.map(({ x, y }) => [x, y])"))
            page.evaluate("connection.person()")
            if place == 1:
                here.stop(here.sessions().index(1))
                soon(lambda: page.evaluate("connection.state") != "open", "its service stops")
    for xy, expected in zip(heard, without_a_break(parts), strict=True):
        found = np.array([[np.nan if v is None else v for v in row] for row in xy], dtype=np.float64)
        np.testing.assert_array_equal(found, expected.table[:, 1:3])


def test_a_service_that_stops_refuses_new_connections_at_once() -> None:
    """One client does not close: the service waits for it, and others are refused meanwhile."""
    with running() as here, here.greeted() as slow:
        slow.protocol.receive_data = lambda data: None  # type: ignore[method-assign]
        here.server.should_exit = True
        soon(lambda: here.service.stopping, "it stops")
        with pytest.raises(SourceError, match="refused"):
            connect(here.url, timeout_s=PATIENCE_S)
        assert here.service._open, "it still waits for the client"
