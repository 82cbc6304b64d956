"""The live page in a real browser: a hand for its mouse, and what it complained of, asked for and shifted."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Literal

from playwright.sync_api import ConsoleMessage, Error, Page, Request, WebSocket

from pointpred.errors import SourceError
from pointpred.live.devtools import Page as DevTools
from tests.server import browser

SHIFTS = """
window.shifts = [];
new PerformanceObserver((list) => {
  for (const entry of list.getEntries())
    if (!entry.hadRecentInput)
      window.shifts.push([entry.value, entry.sources.map(({node}) => node?.id || node?.nodeName).join(" ")]);
}).observe({ type: "layout-shift", buffered: true });
"""
COLOURS = """{
  const scene = document.querySelector("PART");
  window.colours = new Set();
  new MutationObserver(() => {
    if (JSON.parse(scene.dataset.regions)[0]?.opacity !== 1) return;
    const canvas = new OffscreenCanvas(scene.width, scene.height);
    const copy = canvas.getContext("2d", { willReadFrequently: true });
    copy.drawImage(scene, 0, 0);
    const { data } = copy.getImageData(0, 0, scene.width, scene.height);
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] === 255) colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
  }).observe(scene, { attributeFilter: ["data-drawn"] });
}"""
"""Gathers the colours of a picture whenever an endpoint is drawn that does not fade: it soon goes."""
VALUE = """async (expression) => {
  const found = await (0, eval)(expression);
  try { return JSON.stringify(found); } catch { return null; }  // what holds itself, as Vue's objects do
}"""
"""Playwright itself would call a function that comes out of an expression."""
PATIENCE_S = 120.0


@contextmanager
def service(port: int = 0) -> Iterator[str]:
    """A service of its own, ready to answer, at a free port unless one is given; yields its address."""
    command = [sys.executable, "-m", "pointpred", "serve", "--port", str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        assert process.stdout is not None
        try:
            address = next(line.strip() for line in process.stdout if line.startswith("http"))
            yield address
        finally:
            process.kill()


@contextmanager
def visitor(profile: Path, size: tuple[int, int] = (1280, 720)) -> Iterator[Visitor]:
    """Somebody with a browser of his own, on an empty page."""
    with browser.running(profile) as chromium, chromium.tab() as page, chromium.hand(page) as hand:
        yield Visitor(page, hand, size)


def until(asked: Callable[[], Any], words: str, patience_s: float = PATIENCE_S) -> Any:
    """Ask until the answer is true; returns it."""
    end = time.monotonic() + patience_s
    while not (answer := asked()):
        assert time.monotonic() < end, f"waited {patience_s:g} s in vain for {words}"
        time.sleep(0.03)
    return answer


class Visitor:
    """Looks at the page, moves its mouse and presses its keys."""

    def __init__(self, page: Page, hand: DevTools, size: tuple[int, int]) -> None:
        self.page = page
        self.hand = hand
        """Commands of the browser's own protocol, without waiting for the page."""
        self.sockets: list[WebSocket] = []
        """Those that the page has made since it was opened."""
        self._said: list[str] = []
        self._asked: set[str] = set()
        page.on("console", self._hear)
        page.on("pageerror", self._hear)
        page.on("request", self._note)
        page.on("websocket", self._note)
        page.add_init_script(SHIFTS)
        self.resize(*size)

    def _hear(self, said: ConsoleMessage | Error) -> None:
        if isinstance(said, Error) or said.type in ("error", "warning"):
            self._said.append(str(said if isinstance(said, Error) else said.text))

    def _note(self, asked: Request | WebSocket) -> None:
        self._asked.add(asked.url)
        if isinstance(asked, WebSocket):
            self.sockets.append(asked)

    def resize(self, width: int, height: int) -> None:
        """Give the page a size in CSS px."""
        self.page.set_viewport_size({"width": width, "height": height})

    def prefer(
        self,
        color_scheme: Literal["light", "dark"] = "light",
        reduced_motion: Literal["reduce", "no-preference"] = "no-preference",
    ) -> None:
        """Set media features."""
        self.page.emulate_media(color_scheme=color_scheme, reduced_motion=reduced_motion)

    def open(self, url: str) -> None:
        """Go to an address in a new document, and wait until it has loaded."""
        self.page.goto("about:blank")
        for heard in (self.sockets, self._said, self._asked):
            heard.clear()
        self.page.goto(url)

    def value(self, expression: str) -> Any:
        """What an expression yields in the page, as JSON has it; raises SourceError where it throws."""
        try:
            found = self.page.evaluate(VALUE, expression)
        except Error as error:
            raise SourceError(f"the page threw: {error}") from error
        return None if found is None else json.loads(found)

    def wait(self, expression: str, patience_s: float = PATIENCE_S) -> Any:
        """Wait until an expression is true; returns its value."""
        return until(lambda: self.value(expression), expression, patience_s)

    def text(self, part: str) -> str:
        """The words in the first element that a selector finds."""
        return self.page.text_content(part) or ""

    def gather_colours(self, part: str) -> None:
        """Gather from now on what colours a live picture has while an endpoint is drawn."""
        self.value(COLOURS.replace("PART", part))

    def colours(self) -> set[tuple[int, int, int]]:
        """Red, green and blue of what was gathered."""
        return {(one >> 16, one >> 8 & 255, one & 255) for one in self.value("[...colours]")}

    def choose(self, part: str, value: str) -> None:
        """Choose an option of a select."""
        self.page.select_option(part, value)

    def enter(self, name: str, value: object) -> None:
        """Type into the field of a form."""
        self.page.fill(f"[name={name}]", str(value))

    def give_files(self, texts: dict[str, str]) -> None:
        """Give files with these texts to the replay view, by their names."""
        self.page.set_input_files(
            "#replay-file",
            [{"name": name, "mimeType": "text/csv", "buffer": text.encode()} for name, text in texts.items()],
        )

    def corner(self, part: str) -> tuple[float, float, float, float]:
        """Left, top, width and height of an element, CSS px."""
        box = f"document.querySelector({part!r}).getBoundingClientRect()"
        left, top, width, height = self.value(f"(({{x, y, width, height}}) => [x, y, width, height])({box})")
        return left, top, width, height

    def mouse(self, kind: str, x: float, y: float, **more: float) -> None:
        """Move, press or release the mouse without waiting for the page, as a hand does."""
        pressed = kind in ("mousePressed", "mouseReleased")
        about = {"button": "left" if pressed else "none", "clickCount": int(pressed)}
        self.hand.send(
            "Input.dispatchMouseEvent",
            **{"type": kind, "x": x, "y": y, "buttons": int(kind == "mousePressed"), **about, **more},
        )

    def click(self, x: float, y: float) -> None:
        """Press and release, and wait until the page has seen it."""
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)
        self.hand.wait_for_results()

    def reach(
        self,
        start: tuple[float, float],
        end: tuple[float, float],
        seconds: float,
        rate_hz: float = 200.0,
        paced: bool = False,
    ) -> None:
        """Move in a straight line at the speed of least jerk.

        ``paced``: wait for a frame of the page every 20 ms of the movement, and give the events the
        times that were planned, so that a slow machine sees the same movement.
        """
        began, count = time.perf_counter(), round(seconds * rate_hz)
        epoch, a_frame = time.time(), round(0.02 * rate_hz)
        for i in range(1, count + 1):
            u = i / count
            share = 10 * u**3 - 15 * u**4 + 6 * u**5
            place = [a + share * (b - a) for a, b in zip(start, end, strict=True)]
            time.sleep(max(0.0, began + i / rate_hz - time.perf_counter()))
            planned = {"timestamp": epoch + i / rate_hz} if paced else {}
            self.mouse("mouseMoved", place[0], place[1], **planned)
            if paced and i % a_frame == 0:
                self.value("new Promise((done) => requestAnimationFrame(() => done()))")
        self.hand.wait_for_results()

    def press(self, key: str) -> None:
        """Press and release a key."""
        self.page.keyboard.press(key)

    def shift(self) -> float:
        """The sum of the layout shifts that no input explains; 0.1 is called good on the web."""
        return float(self.value("shifts.reduce((sum, [one]) => sum + one, 0)"))

    def complaints(self) -> list[str]:
        """Errors and warnings of the page and of the browser about it, since it was opened."""
        self.value("0")
        return self._said

    def asked(self) -> set[str]:
        """Every address that the page has asked for since it was opened, sockets included."""
        return self._asked
