"""A service in this process that keeps every frame it hears: the real session behind a plain socket."""

from __future__ import annotations

import http
import mimetypes
import socket
import threading
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Self

import msgspec
import numpy as np
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response
from websockets.sync.server import ServerConnection, serve
from websockets.typing import Subprotocol

from pointpred.clock import now
from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.protocol.server_messages import Limits
from pointpred_server.app import CLIENT_MODULE
from pointpred_server.http_responses import SECURITY_HEADERS
from pointpred_server.sessions.pointing import PointingSession

WEB = Path(__file__).parents[2] / "server" / "pointpred_server" / "web"
RECORD = np.dtype(
    [("t", "<f8"), ("x", "<f8"), ("y", "<f8"), ("dx", "<i2"), ("dy", "<i2"), ("buttons", "<u2")]
)
BARE = b'<!doctype html><title>bare</title><body style="margin:0"><div id="box"></div>'


class Listener:
    """Serves the client and a bare page, speaks the protocol, and remembers what it was told."""

    def __init__(
        self, port: int = 0, limits: Limits | None = None, coefficients: Mapping[str, Path] | None = None
    ) -> None:
        self._coefficients = coefficients or {}
        self.limits = limits or Limits()
        self.frames: list[str | bytes] = []
        self.requests: list[str] = []
        self._open: set[ServerConnection] = set()
        self._kept = socket.socket()  # so that nobody gets the port between this one's end and its successor
        self._kept.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self._kept.bind(("127.0.0.1", port))
        self.port: int = self._kept.getsockname()[1]
        self._server = serve(
            self._talk,
            "127.0.0.1",
            self.port,
            subprotocols=[Subprotocol(SUBPROTOCOL)],
            process_request=self._page,
            close_timeout=1,
            compression=None,
            ping_interval=None,  # a session that is busy with compiled code reads no pong
            max_queue=None,
        )
        self._thread = threading.Thread(target=self._server.serve_forever)
        self._thread.start()

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def events(self) -> np.ndarray:
        """Every event that came as a binary frame."""
        return np.concatenate([np.empty(0, RECORD), *(np.frombuffer(f, RECORD) for f in self.binary())])

    def binary(self) -> list[bytes]:
        return [frame for frame in self.frames if isinstance(frame, bytes)]

    def messages(self, kind: str) -> list[dict]:
        """Every JSON message of a type."""
        texts = [msgspec.json.decode(frame) for frame in self.frames if isinstance(frame, str)]
        return [message for message in texts if message["type"] == kind]

    def stop(self, code: int = 1001) -> None:
        self._server.shutdown()
        for connection in list(self._open):
            connection.close(code)
        self._thread.join()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.stop()
        self._kept.close()

    def _talk(self, connection: ServerConnection) -> None:
        self._open.add(connection)
        session = PointingSession("here", self.limits, now(), coefficients=self._coefficients)
        try:
            for frame in connection:
                self.frames.append(frame)
                session.receive(frame, now())
                with suppress(ConnectionClosed):  # what came before the client left is still heard
                    for answer in session.outbox.take():
                        connection.send(answer)
                if session.close is not None:
                    connection.close(session.close.code, session.close.reason)
        except ConnectionClosed:
            pass
        finally:
            self._open.discard(connection)

    def _page(self, connection: ServerConnection, request: Request) -> Response | None:
        path = request.path.partition("?")[0]
        if path == "/v1/stream":
            return None
        self.requests.append(path)
        name = path.removeprefix("/").removeprefix("web/")
        file = WEB / name
        body = file.read_bytes() if name and file.is_file() else BARE
        if path == "/pointpred.js":
            body = CLIENT_MODULE.encode()
        kind = mimetypes.guess_type(name)[0] or "text/html"
        headers = Headers(
            {
                **SECURITY_HEADERS,
                "Content-Type": kind,
                "Content-Length": str(len(body)),
                "Connection": "close",
            }
        )
        return Response(http.HTTPStatus.OK, "OK", headers, body)


def soon(condition: object, what: str, seconds: float = 120.0) -> None:
    """Wait until something holds."""
    until = time.monotonic() + seconds
    while not condition():  # type: ignore[operator]
        assert time.monotonic() < until, f"not within {seconds:g} s: {what}"
        time.sleep(0.01)
