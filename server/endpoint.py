"""``WS /v1/stream``: who may connect, and a session for those who may."""

from __future__ import annotations

import asyncio
import logging
import traceback
from collections.abc import MutableMapping
from pathlib import Path
from secrets import compare_digest
from typing import Any
from urllib.parse import parse_qs, urlsplit

from pointpred.server.messages import SUBPROTOCOL, Bye, Code, ErrorMessage, encode
from pointpred.server.service import Service
from pointpred.server.talk import Receive, Send, Talk

log = logging.getLogger("pointpred.service")

Scope = MutableMapping[str, Any]


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
        if not self.admits_origin(scope):
            await send({"type": "websocket.close", "code": 1008})  # before accept: HTTP 403
            return
        offered = SUBPROTOCOL if SUBPROTOCOL in scope.get("subprotocols", ()) else None
        await send({"type": "websocket.accept", "subprotocol": offered})
        service = self.service
        if not shows_token(scope, service.settings.token):
            await _turn_away(send, "unauthorized", "show the token as ?token= or Authorization: Bearer", 1008)
        elif service.stopping:
            await send({"type": "websocket.send", "text": encode(Bye("the server stops")).decode()})
            await send({"type": "websocket.close", "code": 1001, "reason": "the server stops"})
        elif service.full:
            most = service.settings.max_sessions
            await _turn_away(send, "too_many", f"{most} sessions are open, which is the most", 1013)
        else:
            await self._serve(receive, send)

    async def _serve(self, receive: Receive, send: Send) -> None:
        service = self.service
        session = service.open(asyncio.get_running_loop().time())
        try:
            talk = Talk(session, receive, send, service.metrics.delay.observe)
            service.attach(session, talk)
            await talk.run()
        except OSError:
            pass  # the client went away while something was sent
        except Exception as error:  # whatever it is, the process and the other sessions go on
            # The message might quote an event: the entry names the place, not the values.
            log.error("session failed", extra={"session": session.name, "error": place_of(error)})
            session.fail()
            await _last_words(session.outbox.take(), send)
        finally:
            service.closed(session)

    def admits_origin(self, scope: Scope) -> bool:
        """Whether the page that connects, if it is one, is ours or allowed."""
        origin = header(scope, b"origin")
        if origin is None or origin in self.service.settings.allow_origin:
            return True
        host = header(scope, b"host")
        return urlsplit(origin).scheme in ("http", "https") and urlsplit(origin).netloc == host


def place_of(error: BaseException) -> str:
    """Type and place of an error, without its words."""
    frames = traceback.extract_tb(error.__traceback__)
    where = f" at {Path(frames[-1].filename).name}:{frames[-1].lineno}" if frames else ""
    return f"{type(error).__name__}{where}"


def header(scope: Scope, name: bytes) -> str | None:
    """The value of a header; the last one where it is repeated."""
    found = [value.decode("latin-1") for key, value in scope["headers"] if key == name]
    return found[-1] if found else None


def shows_token(scope: Scope, token: str | None) -> bool:
    """Whether a request shows the token, where one is asked for."""
    if token is None:
        return True
    shown = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [])
    bearer = (header(scope, b"authorization") or "").removeprefix("Bearer ")
    return any(compare_digest(word.encode(), token.encode()) for word in (*shown, bearer))


async def _turn_away(send: Send, code: Code, message: str, close: int) -> None:
    said = encode(ErrorMessage(code, message, None, recoverable=False)).decode()
    await send({"type": "websocket.send", "text": said})
    await send({"type": "websocket.close", "code": close, "reason": message[:120]})


async def _last_words(frames: list[str | bytes], send: Send) -> None:
    try:
        for frame in frames:
            kind = "bytes" if isinstance(frame, bytes) else "text"
            await send({"type": "websocket.send", kind: frame})
        await send({"type": "websocket.close", "code": 1011, "reason": "the server failed"})
    except (OSError, RuntimeError):
        log.info("a failed session could not be told so")


async def _plain(send: Send, status: int, body: bytes) -> None:
    headers = [(b"content-type", b"text/plain; charset=utf-8")]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": body})
