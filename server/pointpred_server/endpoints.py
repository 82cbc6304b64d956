"""The WebSocket endpoints, ``/v1/stream`` and ``/v1/live``: who may connect, and a session for those who may.

They are ASGI applications without a framework's wrapper: they run for every event.
"""

from __future__ import annotations

import asyncio
import logging

from uvicorn.protocols.utils import ClientDisconnected

from pointpred.logs import place_of
from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.protocol.server_messages import Code, ErrorMessage, encode
from pointpred_server.access import Receive, Scope, Send, admits_origin, has_token, header
from pointpred_server.connection import FRAMES, GRACE_S, Connection, FrameSocket
from pointpred_server.service import Service
from pointpred_server.sessions.lifecycle import FAILED

log = logging.getLogger("pointpred.service")

UPGRADE = b"This path speaks WebSocket, subprotocol pointpred.v1.\n"
TOKEN_NEEDED = "show the token as ?token= or Authorization: Bearer"
NO_DEVICE = (
    "no device is attached; to show a mouse here, run 'pointpred live --serve' "
    "on the machine it is plugged into"
)


class StreamEndpoint:
    """``WS /v1/stream``: pointing sessions."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse foreign origins before the upgrade; then check the token, then the limits; then serve."""
        if scope["type"] != "websocket":
            await _ask_to_upgrade(send)
            return
        try:
            await receive()  # websocket.connect
            await self._answer(scope, send)
        except ClientDisconnected:
            pass  # it left before it had a session

    async def _answer(self, scope: Scope, send: Send) -> None:
        """Serve a client that may have a session; one that is refused is told why, and counted."""
        if not await self._admit(scope, send):
            return
        with self.service.place_of_address(_address(scope)) as place:
            if place:
                await self._serve(scope, send)
                return
        most = self.service.settings.share
        sentence = f"{most} sessions of this address are open, which is the most"
        await self._refuse(send, "too_many", sentence, 1013)

    async def _admit(self, scope: Scope, send: Send) -> bool:
        """Whether a client may ask for a session, and the service has room for one."""
        service = self.service
        if not admits_origin(scope, service.settings.allow_origin):
            service.refuse_origin(header(scope, b"origin"))
            await send({"type": "websocket.close", "code": 1008})  # before accept: HTTP 403
            return False
        subprotocol = SUBPROTOCOL if SUBPROTOCOL in scope.get("subprotocols", ()) else None
        await send({"type": "websocket.accept", "subprotocol": subprotocol})
        if not has_token(scope, service.settings.token):
            await self._refuse(send, "unauthorized", TOKEN_NEEDED, 1008)
            return False
        if service.full:
            most = service.settings.max_sessions
            await self._refuse(send, "too_many", f"{most} sessions are open, which is the most", 1013)
            return False
        return True

    async def _refuse(self, send: Send, code: Code, message: str, close: int) -> None:
        self.service.metrics.connections_refused.labels(code).inc()
        await send_error(send, code, message, close)

    async def _serve(self, scope: Scope, send: Send) -> None:
        service = self.service
        session = service.open_session(asyncio.get_running_loop().time())
        connection = Connection(
            session, _socket(scope), service.arrivals, service.metrics.delays.observe, service.work_threads
        )
        try:
            await self._run(connection, send)
        finally:
            service.close_session(session)

    async def _run(self, connection: Connection, send: Send) -> None:
        """Run a connection; whatever breaks, the process and the other sessions go on."""
        session = connection.session
        try:
            self.service.attach(session, connection)
            if (close := await connection.run()) is not None:
                await send({"type": "websocket.close", "code": close.code, "reason": close.reason})
        except ClientDisconnected:
            pass  # it went away while something was sent
        except Exception as error:
            # The message might quote an event: the entry names the place, not the values.
            log.error("session failed", extra={"session": session.name, "error": place_of(error)})
            session.fail()
            await send_error(send, "internal", FAILED, 1011)


class LiveEndpoint(StreamEndpoint):
    """``WS /v1/live``: viewers of the attached device; the same origins, token and limits as for sessions."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse foreign origins, then everybody where nothing is attached, then as for sessions."""
        try:
            await receive()  # websocket.connect
            if self._nothing_attached(scope):
                self.service.metrics.connections_refused.labels("out_of_place").inc()
                await _send_not_found(scope, send)
                return
            await self._answer(scope, send)
        except ClientDisconnected:
            pass  # it left before it saw anything

    def _nothing_attached(self, scope: Scope) -> bool:
        """Whether to answer that no device is attached, which only clients learn that may connect."""
        settings = self.service.settings
        return (
            self.service.live is None
            and admits_origin(scope, settings.allow_origin)
            and has_token(scope, settings.token)
        )

    async def _serve(self, scope: Scope, send: Send) -> None:
        service = self.service
        if (feed := service.live) is None:
            return
        viewer = service.open_viewer(asyncio.get_running_loop().time())
        connection = Connection(viewer, _socket(scope), service.arrivals)  # it sends nothing to predict
        try:
            feed.join(viewer, connection.flush)
            await self._run(connection, send)
        finally:
            feed.leave(viewer)
            service.close_session(viewer)


def _socket(scope: Scope) -> FrameSocket:
    """The WebSocket of a connection, below ASGI: ``make_server`` has uvicorn use our protocol."""
    socket: FrameSocket = scope["extensions"][FRAMES]["socket"]
    return socket


def _address(scope: Scope) -> str | None:
    """Where a client connects from; as a proxy says, where one is trusted."""
    client = scope.get("client")
    return client[0] if client else None


async def send_error(send: Send, code: Code, message: str, close: int) -> None:
    """An error and the close, where the client takes them."""
    text = encode(ErrorMessage(code, message, None, recoverable=False)).decode()
    try:
        async with asyncio.timeout(GRACE_S):
            await send({"type": "websocket.send", "text": text})
            await send({"type": "websocket.close", "code": close, "reason": message[:120]})
    except (OSError, RuntimeError) as error:  # a timeout is an OSError
        log.info("a client left before it was told why", extra={"code": code, "error": place_of(error)})


async def _ask_to_upgrade(send: Send) -> None:
    headers = [
        (b"content-type", b"text/plain; charset=utf-8"),
        (b"connection", b"upgrade"),
        (b"upgrade", b"websocket"),
    ]
    await send({"type": "http.response.start", "status": 426, "headers": headers})
    await send({"type": "http.response.body", "body": UPGRADE})


async def _send_not_found(scope: Scope, send: Send) -> None:
    """404 before the upgrade, with the error in it where the server can send it."""
    if "websocket.http.response" not in scope.get("extensions", {}):
        await send({"type": "websocket.close", "code": 1008})
        return
    body = encode(ErrorMessage("out_of_place", NO_DEVICE, None))
    headers = [(b"content-type", b"application/json"), (b"content-length", str(len(body)).encode())]
    await send({"type": "websocket.http.response.start", "status": 404, "headers": headers})
    await send({"type": "websocket.http.response.body", "body": body})
