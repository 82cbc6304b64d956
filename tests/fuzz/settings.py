"""Any text as the settings of a service, and as the headers that decide who may connect."""

from __future__ import annotations

import re

from pydantic import ValidationError

from pointpred_server.access import HostRule, admits_origin, has_token, is_origin, origin_advice
from pointpred_server.settings import Settings
from tests.fuzz.refusals import refused

SERVED = (b"127.0.0.1", b"[127.0.0.1]", b"localhost", b"[::1]", b"lab.example")
PORT = re.compile(rb":[0-9]*\Z")
TOKEN = "a-token-of-24-characters"
NAMES = ("host", "allow_host", "allow_origin", "token", "coefficients", "max_sessions", "port", "idle_s")


def check(data: bytes) -> str:
    """An input is lines: a setting each, and the first ones also as Host, Origin, Authorization and query."""
    lines = data.split(b"\n")
    texts = [line.decode(errors="replace") for line in lines]
    came = "refused"
    try:
        settings = Settings(**dict(zip(NAMES, texts, strict=False)))  # type: ignore[arg-type]
        assert TOKEN not in str(settings.printable())
        came = "read"
    except ValidationError as error:
        refused(error)
    host, origin, authorization, query = [*lines, b"", b"", b"", b""][:4]
    headers = [(b"host", host), (b"origin", origin), (b"authorization", authorization)]
    scope = {"type": "http", "scheme": "http", "headers": headers, "query_string": query}
    rule = HostRule("127.0.0.1", ["lab.example"])
    if rule.admits(scope):
        assert PORT.sub(b"", host.strip(b" \t").lower()) in SERVED
    if admits_origin(scope, ("https://lab.example",)):
        assert origin in (b"https://lab.example", b"http://" + host)
    if is_origin(texts[0]):
        assert texts[0] in origin_advice(texts[0])
    if has_token(scope, TOKEN):
        assert TOKEN.encode() in authorization or b"token" in query
    return came


def seeds() -> list[bytes]:
    return [
        b"127.0.0.1\nlab.example,a.example\nhttps://lab.example\na-token-of-24-characters\n\n8\n9000\n60",
        b"localhost:8765\nhttp://localhost:8765\nBearer a-token-of-24-characters\ntoken=a-token",
        b"[::1]:80\nnull\nBasic x\ntoken=%61&token=b\nme=/nowhere/me.npz",
        b"localhost.elsewhere.example:80",
        b'lab.example\nhttps://lab.example\n\n\n{"me": "/nowhere/me.npz"}',
    ]
