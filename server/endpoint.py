"""``WS /v1/stream``: who may connect, and a session for those who may."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Coroutine, MutableMapping
from functools import partial
from secrets import compare_digest
from typing import Any
from urllib.parse import parse_qs

from uvicorn.protocols.utils import ClientDisconnected

from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.protocol.server_messages import Code, ErrorMessage, encode
from pointpred.server.compiling.needs import needs
from pointpred.server.connections.early import Early, Message
from pointpred.server.connections.talk import LAST_S, Receive, Send, Talk
from pointpred.server.hosts import admits_origin, header
from pointpred.server.logs import place_of
from pointpred.server.service import Service
from pointpred.server.sessions.conversation import FAILED
from pointpred.server.sessions.session import Session

log = logging.getLogger("pointpred.service")

Scope = MutableMapping[str, Any]

UPGRADE = b"This path speaks WebSocket, subprotocol pointpred.v1.\n"
SHOW_TOKEN = "show the token as ?token= or Authorization: Bearer"
STOPS = "the server stops"


class StreamEndpoint:
    """An ASGI application for one WebSocket path, without a framework's wrapper: it runs for every event."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse foreign origins before the upgrade; then the token, then the limits; then talk."""
        if scope["type"] != "websocket":
            await _ask_to_upgrade(send)
            return
        try:
            await receive()  # websocket.connect
            if await self._admitted(scope, send):
                await self._serve(receive, send)
        except ClientDisconnected:
            pass  # it left before it had a session

    async def _admitted(self, scope: Scope, send: Send) -> bool:
        """Whether a session may begin; who is refused is told, and counted."""
        service = self.service
        if not admits_origin(scope, service.settings.allow_origin):
            service.refuse_origin(header(scope, b"origin"))
            await send({"type": "websocket.close", "code": 1008})  # before accept: HTTP 403
            return False
        offered = SUBPROTOCOL if SUBPROTOCOL in scope.get("subprotocols", ()) else None
        await send({"type": "websocket.accept", "subprotocol": offered})
        if not shows_token(scope, service.settings.token):
            await self._refuse(send, "unauthorized", SHOW_TOKEN, 1008)
            return False
        if service.full:
            most = service.settings.max_sessions
            await self._refuse(send, "too_many", f"{most} sessions are open, which is the most", 1013)
            return False
        return True

    async def _refuse(self, send: Send, code: Code, message: str, close: int) -> None:
        self.service.metrics.turned_away.labels(code).inc()
        await turn_away(send, code, message, close)

    async def _serve(self, receive: Receive, send: Send) -> None:
        service = self.service
        session = service.open(asyncio.get_running_loop().time())
        early = None if service.compiling.over else Early(receive, partial(self._lacks, session))
        try:
            talk = Talk(session, early or receive, send, service.metrics.delay.observe, service.scorer)
            service.attach(session, talk)
            await talk.run()
        except ClientDisconnected:
            pass  # it went away while something was sent
        except Exception as error:  # whatever it is, the process and the other sessions go on
            # The message might quote an event: the entry names the place, not the values.
            log.error("session failed", extra={"session": session.name, "error": place_of(error)})
            session.fail()
            await turn_away(send, "internal", FAILED, 1011)
        finally:
            if early is not None:
                early.leave()
            session.lose()
            service.closed(session)

    def _lacks(self, session: Session, message: Message) -> Coroutine[Any, Any, None] | None:
        """What has to be compiled before a session is given a message; a first event would wait for it."""
        compiling = self.service.compiling
        if message["type"] != "websocket.receive" or compiling.over:
            return None
        frame = message.get("bytes")
        names = compiling.missing(needs(message["text"] if frame is None else frame))
        return self._wait(session, names) if names else None

    async def _wait(self, session: Session, names: list[str]) -> None:
        session.kept_waiting = True
        try:
            await self.service.compiling.until(names)
        finally:
            session.kept_waiting = False


def shows_token(scope: Scope, token: str | None) -> bool:
    """Whether a request shows the token, where one is asked for."""
    if token is None:
        return True
    shown = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [])
    scheme, _, word = (header(scope, b"authorization") or "").partition(" ")
    if scheme.lower() == "bearer":
        shown.append(word.strip())
    return any(compare_digest(word.encode(), token.encode()) for word in shown)


async def turn_away(send: Send, code: Code, message: str, close: int) -> None:
    """An error and the close, where the client takes them."""
    said = encode(ErrorMessage(code, message, None, recoverable=False)).decode()
    try:
        async with asyncio.timeout(LAST_S):
            await send({"type": "websocket.send", "text": said})
            await send({"type": "websocket.close", "code": close, "reason": message[:120]})
    except (OSError, RuntimeError) as error:  # a timeout is an OSError
        log.info("a client was gone before it was told", extra={"code": code, "error": place_of(error)})


async def _ask_to_upgrade(send: Send) -> None:
    headers = [
        (b"content-type", b"text/plain; charset=utf-8"),
        (b"connection", b"upgrade"),
        (b"upgrade", b"websocket"),
    ]
    await send({"type": "http.response.start", "status": 426, "headers": headers})
    await send({"type": "http.response.body", "body": UPGRADE})
