"""The page while it comes: nothing is shown of it before all is there, for what follows would move it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler
from pathlib import Path

import pytest

from pointpred_server.page import WEB
from tests.hosts import Silent, host
from tests.server import browser, page_browser

pytestmark = browser.needed

HALVES = ("</header>", '<div class="side">', "</dl>", "</section>")
"""Where the page may stop for a while: before its views, within the first, after it."""
WHOLE = "</main>"
PAUSE_S = 0.6
"""Time enough to draw a half."""
PAINTED = "performance.getEntriesByName('first-contentful-paint').map(({ startTime }) => startTime)"


class Halting(Silent, BaseHTTPRequestHandler):
    """Sends the page in two halves, which says itself when it was whole; its styles, and no program."""

    def do_GET(self) -> None:
        style = WEB / self.path.removeprefix("/web/")
        self.send_response(200)
        self.send_header("Content-Type", "text/css" if style.suffix == ".css" else "text/html")
        self.end_headers()
        if style.suffix == ".css":
            self.wfile.write(style.read_bytes())
        elif self.path[1:].isdigit():
            page = (WEB / "page" / "index.html").read_text(encoding="utf-8")
            first, half, rest = page.partition(HALVES[int(self.path[1:])])
            self.wfile.write((first + half).encode())
            self.wfile.flush()
            time.sleep(PAUSE_S)
            told = "<script>window.whole = performance.now()</script>"
            self.wfile.write(rest.replace(WHOLE, told + WHOLE).encode())


@pytest.fixture
def halting() -> Iterator[str]:
    with host(Halting) as origin:
        yield f"{origin}/"


@pytest.mark.parametrize("half", range(len(HALVES)))
def test_half_of_the_page_is_not_shown(halting: str, tmp_path: Path, half: int) -> None:
    with page_browser.visitor(tmp_path / "profile", (390, 844)) as visitor:
        visitor.open(f"{halting}{half}")
        [shown] = visitor.wait(f"{PAINTED}.length && {PAINTED}")
        assert shown > visitor.value("whole")
        assert visitor.shift() < 0.001
