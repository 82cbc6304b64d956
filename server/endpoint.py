"""``WS /v1/stream``: who may connect, and a session for those who may."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import MutableMapping
from secrets import compare_digest
from typing import Any
from urllib.parse import parse_qs

from uvicorn.protocols.utils import ClientDisconnected

from pointpred.server.hosts import admits_origin, header
from pointpred.server.logs import place_of
from pointpred.server.messages import SUBPROTOCOL, Bye, Code, ErrorMessage, encode
from pointpred.server.service import Service
from pointpred.server.talk import Receive, Send, Talk

log = logging.getLogger("pointpred.service")

Scope = MutableMapping[str, Any]

FAILED = "the server failed; the session ends"
LAST_S = 5.0
"""A client may read for so long that its session failed."""


class StreamEndpoint:
    """An ASGI application for one WebSocket path, without a framework's wrapper: it runs for every event."""

    def __init__(self, service: Service) -> None:
        self.service = service

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse foreign origins before the upgrade; then the token, then the limits; then talk."""
        if scope["type"] != "websocket":
            await _plain(send, 426, b"This path speaks WebSocket, subprotocol pointpred.v1.\n")
            return
        await receive()  # websocket.connect
        if not admits_origin(scope, self.service.settings.allow_origin):
            await send({"type": "websocket.close", "code": 1008})  # before accept: HTTP 403
            return
        offered = SUBPROTOCOL if SUBPROTOCOL in scope.get("subprotocols", ()) else None
        await send({"type": "websocket.accept", "subprotocol": offered})
        service = self.service
        if not shows_token(scope, service.settings.token):
            await _turn_away(send, "unauthorized", "show the token as ?token= or Authorization: Bearer", 1008)
            return
        if service.full:
            most = service.settings.max_sessions
            await _turn_away(send, "too_many", f"{most} sessions are open, which is the most", 1013)
            return
        await service.until_warm()  # or this first event would compile, and every session wait for it
        if service.stopping:
            await send({"type": "websocket.send", "text": encode(Bye("the server stops")).decode()})
            await send({"type": "websocket.close", "code": 1001, "reason": "the server stops"})
        else:
            await self._serve(receive, send)

    async def _serve(self, receive: Receive, send: Send) -> None:
        service = self.service
        session = service.open(asyncio.get_running_loop().time())
        try:
            talk = Talk(session, receive, send, service.metrics.delay.observe, service.scorer)
            service.attach(session, talk)
            await talk.run()
        except ClientDisconnected:
            pass  # it went away while something was sent
        except Exception as error:  # whatever it is, the process and the other sessions go on
            # The message might quote an event: the entry names the place, not the values.
            log.error("session failed", extra={"session": session.name, "error": place_of(error)})
            session.fail()
            await _turn_away(send, "internal", FAILED, 1011)
        finally:
            session.lose()
            service.closed(session)


def shows_token(scope: Scope, token: str | None) -> bool:
    """Whether a request shows the token, where one is asked for."""
    if token is None:
        return True
    shown = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [])
    bearer = (header(scope, b"authorization") or "").removeprefix("Bearer ")
    return any(compare_digest(word.encode(), token.encode()) for word in (*shown, bearer))


async def _turn_away(send: Send, code: Code, message: str, close: int) -> None:
    """An error and the close, where the client takes them."""
    said = encode(ErrorMessage(code, message, None, recoverable=False)).decode()
    try:
        async with asyncio.timeout(LAST_S):
            await send({"type": "websocket.send", "text": said})
            await send({"type": "websocket.close", "code": close, "reason": message[:120]})
    except (OSError, RuntimeError) as error:  # a timeout is an OSError
        log.info("a client was gone before it was told", extra={"code": code, "error": place_of(error)})


async def _plain(send: Send, status: int, body: bytes) -> None:
    headers = [(b"content-type", b"text/plain; charset=utf-8")]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": body})
