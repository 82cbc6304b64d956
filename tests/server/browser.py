"""The system's Chromium for tests, where there is one, driven by Playwright."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import BrowserContext, CDPSession, Page, Playwright, sync_playwright
from websockets.sync.client import connect as dial

from pointpred.live.devtools import Page as DevTools

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
QUIET = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--window-size=1280,720",
)

PATIENCE_S = 120.0
"""A browser that many others starve may take long to answer."""

needed = pytest.mark.skipif(BROWSER is None, reason="no chromium on this machine")


def move_at(protocol: CDPSession, x: float, y: float, t: float) -> None:
    """Move the mouse of a tab, with a time that the event gives, s since 1970."""
    event = {"type": "mouseMoved", "x": x, "y": y, "timestamp": t}
    protocol.send("Input.dispatchMouseEvent", event)


_started: list[Playwright] = []
"""The one of this process: Playwright cannot be started twice at a time in a thread."""


class Chromium(NamedTuple):
    """A running browser, and the address of its DevTools."""

    context: BrowserContext
    devtools: str

    @contextmanager
    def tab(self, url: str = "about:blank") -> Iterator[Page]:
        """A tab at an address."""
        page = self.context.new_page()
        page.goto(url)
        yield page
        page.close()

    @contextmanager
    def hand(self, page: Page) -> Iterator[DevTools]:
        """A connection of its own to a tab, which moves its mouse without waiting, as Playwright cannot."""
        session = self.context.new_cdp_session(page)
        target = session.send("Target.getTargetInfo")["targetInfo"]["targetId"]
        session.detach()
        address = f"ws://{urlsplit(self.devtools).netloc}/devtools/page/{target}"
        with dial(address, max_size=None, max_queue=None, compression=None, proxy=None) as socket:
            yield DevTools(socket, PATIENCE_S)


@contextmanager
def running(profile: Path, *further: str) -> Iterator[Chromium]:
    """A browser, with further flags."""
    with _playwright() as playwright:
        context = playwright.chromium.launch_persistent_context(
            profile,
            executable_path=BROWSER,
            args=[*QUIET, *further, "--remote-debugging-port=0"],
            ignore_default_args=["--hide-scrollbars"],
            viewport={"width": 1280, "height": 720},
        )
        context.set_default_timeout(1000.0 * PATIENCE_S)
        port = (profile / "DevToolsActivePort").read_text(encoding="utf-8").split()[0]
        try:
            yield Chromium(context, f"http://127.0.0.1:{port}")
        finally:
            context.close()


@contextmanager
def _playwright() -> Iterator[Playwright]:
    """Playwright until the last browser ends: meanwhile this thread can run no other event loop."""
    if _started:
        yield _started[0]
        return
    with sync_playwright() as playwright:
        _started.append(playwright)
        try:
            yield playwright
        finally:
            _started.clear()
