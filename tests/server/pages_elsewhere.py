"""Bare pages of other sites, for a browser to open."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler

from tests.hosts import Silent, host


@contextmanager
def page_elsewhere(**headers: str) -> Iterator[str]:
    """A bare page on a port of its own, with these headers; yields its origin."""

    class Bare(Silent, BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            for name, value in {"Content-Type": "text/html", **headers}.items():
                self.send_header(name.replace("_", "-"), value)
            self.end_headers()
            self.wfile.write(b"<!doctype html><title>elsewhere</title>")

    with host(Bare) as origin:
        yield origin
