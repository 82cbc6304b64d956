"""Which ``Host`` headers are answered: a page of another name must not reach a service on this machine."""

from __future__ import annotations

import re
from collections.abc import Awaitable, Callable, Collection, Iterable, Mapping, MutableMapping
from ipaddress import ip_address
from typing import Any

from pointpred.protocol.server_messages import ErrorMessage, encode

LOOPBACK = frozenset({"127.0.0.1", "localhost", "::1"})
HOST = re.compile(r"(?:\[([0-9a-f:.]+)\]|([^\s:/@\[\]?#]+))(?::[0-9]{0,5})?")
WILDCARDS = frozenset({"0.0.0.0", "::"})
REFUSAL = encode(ErrorMessage("unauthorized", "this host name is not served here"))

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
Application = Callable[[Scope, Receive, Send], Awaitable[None]]


class HostRule:
    """Admits the loopback names, the bound address and further names.

    DNS rebinding needs a name, so a service bound to every address admits every numeric address as well.
    """

    def __init__(self, bound: str = "127.0.0.1", further: Iterable[str] = ()) -> None:
        self.names = LOOPBACK | {bound.lower()} | {name.lower() for name in further}
        self.any_address = bound in WILDCARDS

    def admits(self, header: str) -> bool:
        """Whether a request with this ``Host`` header is answered."""
        name = _without_port(header.strip().lower())
        return name in self.names or (self.any_address and is_address(name))


class HostGuard:
    """ASGI middleware: 403 for a ``Host`` header the rule does not admit, before anything else runs."""

    def __init__(
        self,
        app: Application,
        rule: HostRule,
        headers: Mapping[str, str] | None = None,
        refused: Callable[[], None] = lambda: None,
    ) -> None:
        """``headers`` go with every refusal, and ``refused`` is called for it."""
        self.app = app
        self.refused = refused
        self.headers = [(name.lower().encode(), text.encode()) for name, text in (headers or {}).items()]
        self.rule = rule

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        received = [value.decode("latin-1") for key, value in scope["headers"] if key == b"host"]
        if len(received) == 1 and self.rule.admits(received[0]):
            await self.app(scope, receive, send)
            return
        self.refused()
        if scope["type"] == "websocket":
            await receive()
            await send({"type": "websocket.close", "code": 1008})
        else:
            headers = [(b"content-type", b"application/json"), *self.headers]
            await send({"type": "http.response.start", "status": 403, "headers": headers})
            await send({"type": "http.response.body", "body": REFUSAL})


def header(scope: Scope, name: bytes) -> str | None:
    """The value of a header; several are joined by commas, as HTTP has it."""
    found = [value.decode("latin-1") for key, value in scope["headers"] if key == name]
    return ", ".join(found) if found else None


def admits_origin(scope: Scope, allowed: Collection[str]) -> bool:
    """Whether the page that asks is ours or allowed; what sends no ``Origin`` is no page."""
    origin = header(scope, b"origin")
    if origin is None or origin in allowed:
        return True
    scheme = "https" if scope.get("scheme") in ("https", "wss") else "http"  # as a proxy says, where one is
    return origin == f"{scheme}://{header(scope, b'host')}"


def _without_port(host: str) -> str:
    """The name or address in a ``Host`` header; empty, which nobody admits, where it is malformed."""
    found = HOST.fullmatch(host)
    return (found.group(1) or found.group(2)) if found else ""


def is_address(name: str) -> bool:
    """Whether a name is a numeric address."""
    try:
        ip_address(name)
    except ValueError:
        return False
    return True
