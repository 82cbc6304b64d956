"""Which requests are answered: their ``Host`` header, the origin of the page that asks, and the token.

A page of another name must not reach a service on this machine. A page that is refused is told which flag of
``pointpred serve`` admits it, and the refusal is logged once an origin.
"""

from __future__ import annotations

import logging
import re
from collections.abc import Collection, Iterable, MutableMapping
from ipaddress import IPv4Address, IPv6Address, IPv6Network, ip_address, ip_network
from secrets import compare_digest
from typing import Any
from urllib.parse import parse_qs

log = logging.getLogger("pointpred.service")

LOOPBACK = frozenset({"127.0.0.1", "localhost", "::1"})
WILDCARDS = frozenset({"0.0.0.0", "::"})
MAPPED = "::ffff:"
"""Before an IPv4 address on a socket for both kinds."""
HOP = re.compile(r"^\[([0-9a-fA-F:.]+)\](?::[0-9]+)?$|^([0-9.]+):[0-9]+$")
"""An address in brackets or with a port, as some proxies write it."""
HOST = re.compile(r"(?:\[([0-9a-f:.]+)\]|([^\s:/@\[\]?#]+))(?::[0-9]{0,5})?")
HOST_REFUSED = "this host name is not served here"
TOKEN_NEEDED = "show the token as ?token= or Authorization: Bearer"
ORIGIN = re.compile(r"https?://[a-z0-9._~%:\[\]-]{1,300}")
ORIGIN_FLAG = "--allow-origin"
MOST_ORIGINS = 64
"""Origins that are remembered as logged: anybody can invent more."""
FILE_PAGE = "a page opened as a file has no origin that could be allowed: serve it over http"

Scope = MutableMapping[str, Any]
"""A request as ASGI has it; only its headers, query, scheme and client are read."""


class HostRule:
    """Admits the loopback names, the bound address and further names.

    DNS rebinding needs a name, so a service bound to every address admits every numeric address as well.
    """

    def __init__(self, bound: str = "127.0.0.1", further: Iterable[str] = ()) -> None:
        self.names = LOOPBACK | {bound.lower()} | {name.lower() for name in further}
        self.any_address = bound in WILDCARDS

    def admits(self, scope: Scope) -> bool:
        """Whether a request is answered: it has one ``Host`` header, with a name that is served."""
        match = HOST.fullmatch((header(scope, b"host") or "").strip(" \t").lower())
        name = (match[1] or match[2]) if match else ""
        return name in self.names or (self.any_address and is_address(name))


def header(scope: Scope, name: bytes) -> str | None:
    """The value of a header; several are joined by commas, as HTTP has it."""
    values = [value.decode("latin-1") for key, value in scope["headers"] if key == name]
    return ", ".join(values) if values else None


def believe_proxy(scope: Scope, proxies: Iterable[str]) -> None:
    """Take the client and the scheme from the headers of a proxy, where it is among those that are trusted.

    The client is the last address that no trusted proxy has, as the nearest of them wrote it; the proxy where
    what it wrote is no address.
    """
    client = scope["client"]
    if client is not None:
        client = scope["client"] = client[0].removeprefix(MAPPED), client[1]
    trusted = [ip_network(proxy) for proxy in proxies]

    def trusts(address: str) -> bool:
        return is_address(address) and any(ip_address(address) in proxy for proxy in trusted)

    if client is None or not trusts(client[0]):
        return
    if (scheme := header(scope, b"x-forwarded-proto")) in ("http", "https", "ws", "wss"):
        scope["scheme"] = scheme
    hops = [HOP.sub(r"\1\2", hop.strip()) for hop in (header(scope, b"x-forwarded-for") or "").split(",")]
    first = next((hop for hop in reversed(hops) if not trusts(hop)), hops[0])
    if is_address(first):
        scope["client"] = first, 0


def network_of(address: str) -> str:
    """What sessions are counted by: an IPv4 address, or the /64 network of an IPv6 address.

    One customer of a provider has a whole network of IPv6 addresses. The address of this machine, and what is
    no address, are returned as they are.
    """
    try:
        parsed = ip_address(address)
    except ValueError:
        return address
    if isinstance(parsed, IPv6Address) and parsed.ipv4_mapped is not None:
        parsed = parsed.ipv4_mapped
    if isinstance(parsed, IPv4Address) or parsed.is_loopback:
        return str(parsed)
    return str(IPv6Network((int(parsed), 64), strict=False))


def is_address(name: str) -> bool:
    """Whether a name is a numeric address."""
    try:
        ip_address(name)
    except ValueError:
        return False
    return True


def admits_origin(scope: Scope, allowed: Collection[str]) -> bool:
    """Whether the page that asks is ours or allowed; a client without an ``Origin`` header is no page."""
    origin = header(scope, b"origin")
    if origin is None or origin in allowed:
        return True
    scheme = "https" if scope.get("scheme") in ("https", "wss") else "http"  # as a proxy says, where one is
    return origin == f"{scheme}://{header(scope, b'host')}"


def origin_advice(origin: str | None) -> str:
    """What admits pages of an origin, as its ``Origin`` header has it.

    >>> origin_advice("https://a.example")
    'pages of https://a.example may not connect; pointpred serve --allow-origin https://a.example allows them'
    """
    if origin == "null":
        return FILE_PAGE
    if not is_origin(origin):
        return f"this origin cannot be allowed; {ORIGIN_FLAG} takes one such as https://page.example"
    return f"pages of {origin} may not connect; pointpred serve {ORIGIN_FLAG} {origin} allows them"


def is_origin(origin: str | None) -> bool:
    """Whether an origin is written as browsers write it; one that is not is never quoted."""
    return origin is not None and ORIGIN.fullmatch(origin) is not None


class RefusedOrigins:
    """Logs the first refusal of each origin; memory is bounded."""

    def __init__(self) -> None:
        self._logged: set[str] = set()

    def add(self, origin: str | None) -> None:
        """A page of this origin was refused."""
        advice = origin_advice(origin)
        if advice in self._logged or len(self._logged) == MOST_ORIGINS:
            return
        self._logged.add(advice)
        log.warning("a page was refused: %s", advice)


def has_token(scope: Scope, token: str | None) -> bool:
    """Whether a request carries the token, where one is needed."""
    if token is None:
        return True
    tokens = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [])
    scheme, _, credentials = (header(scope, b"authorization") or "").partition(" ")
    if scheme.lower() == "bearer":
        tokens.append(credentials.strip())
    return any(compare_digest(one.encode(), token.encode()) for one in tokens)
