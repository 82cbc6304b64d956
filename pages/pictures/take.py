"""Pictures of the page at three widths, light and dark: before anybody moves, during a movement, after it.

``python -m pages.pictures.take --out FOLDER`` starts a service of its own; ``--address URL`` takes one that
runs. A real mouse in a headless Chromium follows a movement of the embedded sample, scaled to the picture.
"""

from __future__ import annotations

import argparse
import base64
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np
import numpy.typing as npt

from pointpred.datasets import sample
from pointpred.live.devtools import Page, open_page

SIZES = {1440: 900, 1024: 768, 390: 844}
THEMES = ("light", "dark")
VIEWS = ("live", "details", "circle", "replay", "assist")
RATE_HZ = 125.0
READY_S = 600.0
SHOWS = "document.querySelector('#live-scene').dataset.shows"
CONNECTED = "document.querySelector('#live-card-0 .connection').dataset.state === 'open'"
GOAL = """(() => {
  const scene = document.querySelector('#circle-scene'), { left, top } = scene.getBoundingClientRect();
  if (!scene.dataset.target) return null;
  const { x, y } = JSON.parse(scene.dataset.target);
  return { x: left + x, y: top + y };
})()"""
TILE = """import('/web/live/tiles.js').then(({ row }) => {
  const { clientWidth, clientHeight } = document.querySelector('#live-scene');
  const { x, y, width, height } = row(clientWidth, clientHeight)[3];
  return [x + width / 2, y + height / 2];
})"""


@dataclass
class Shot:
    """What a picture is of."""

    view: str
    moment: str
    width: int
    theme: str

    @property
    def name(self) -> str:
        """The name of its file."""
        return f"{self.view}-{self.moment}-{self.width}-{self.theme}.webp"


@contextmanager
def service() -> Iterator[str]:
    """A service of its own; yields the address of its page."""
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        assert process.stdout is not None
        try:
            yield next(line.strip() for line in process.stdout if line.startswith("http"))
        finally:
            process.terminate()


@contextmanager
def browser() -> Iterator[str]:
    """A headless Chromium; yields the address of its DevTools."""
    program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if program is None:
        sys.exit("no chromium on this machine")
    with tempfile.TemporaryDirectory() as profile:
        flags = ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run"]
        command = [program, *flags, f"--user-data-dir={profile}", "--remote-debugging-port=0", "about:blank"]
        with subprocess.Popen(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
        ) as process:
            assert process.stderr is not None
            try:
                yield next(
                    f"http://{line.split('/')[2]}" for line in process.stderr if line.startswith("DevTools")
                )
            finally:
                process.terminate()
                process.stderr.read()


def wait_for(page: Page, expression: str, patience_s: float = 60.0) -> None:
    """Wait until an expression is true in the page."""
    end = time.monotonic() + patience_s
    while not page.evaluate(expression):
        if time.monotonic() > end:
            sys.exit(f"waited {patience_s:g} s in vain for {expression}")
        time.sleep(0.03)


def movement(start: tuple[float, float], end: tuple[float, float]) -> npt.NDArray[np.float64]:
    """Rows t s, x px, y px of a simulated movement, turned and scaled to lead from one point to another."""
    events = sample().rows(0)
    path = events.x + 1j * events.y
    first = int(np.argmax(np.abs(path - path[0]) > 3.0))
    t, path = events.t[first:] - events.t[first], path[first:]
    begin, goal = complex(*start), complex(*end)
    path = begin + (path - path[0]) * (goal - begin) / (path[-1] - path[0])
    times = np.arange(0.0, t[-1], 1.0 / RATE_HZ)
    return np.column_stack([times, np.interp(times, t, path.real), np.interp(times, t, path.imag)])


class Photographer:
    """Opens views, moves the mouse and takes pictures."""

    def __init__(self, devtools: str, address: str, out: Path) -> None:
        self.page, self.hand = (
            open_page(devtools),
            open_page(devtools),
        )  # two lines to one tab: one moves, one looks
        self.address, self.out = address, out
        self.page.call("Page.enable")

    def open(self, view: str, width: int, theme: str, *, still: bool = False) -> None:
        """Show a view in a new document."""
        size = {"width": width, "height": SIZES[width], "deviceScaleFactor": 1, "mobile": False}
        self.page.call("Emulation.setDeviceMetricsOverride", **size)
        features = {"prefers-color-scheme": theme, "prefers-reduced-motion": "reduce" if still else ""}
        media = [{"name": name, "value": value} for name, value in features.items()]
        self.page.call("Emulation.setEmulatedMedia", features=media)
        self.page.go("about:blank")
        self.page.go(f"{self.address}#{view}")

    def take(self, shot: Shot, *, full: bool = False) -> None:
        """Take one picture."""
        options = {"format": "webp", "quality": 45, "captureBeyondViewport": full}
        data = self.page.call("Page.captureScreenshot", **options)["data"]
        (self.out / shot.name).write_bytes(base64.b64decode(data))

    def move(self, rows: npt.NDArray[np.float64], started: threading.Event | None = None) -> None:
        """Follow a path in real time; ``started`` is set once 45 % of the way lies behind."""
        began = time.perf_counter()
        way = np.hypot(rows[:, 1] - rows[-1, 1], rows[:, 2] - rows[-1, 2])
        for (t, x, y), left in zip(rows.tolist(), way, strict=True):
            time.sleep(max(0.0, began + t - time.perf_counter()))
            self.hand.send("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
            if started is not None and left < 0.55 * way[0]:
                started.set()
        self.hand.wait_for_results()

    def live(self, width: int, theme: str) -> None:
        """The live view before anybody moves, in the middle of a movement, and after it."""
        self.open("live", width, theme, still=True)
        wait_for(self.page, CONNECTED, READY_S)
        wait_for(self.page, f"{SHOWS} === 'demo'")
        time.sleep(0.5)
        self.take(Shot("live", "demo", width, theme))
        self.open("live", width, theme)
        wait_for(self.page, CONNECTED)
        left, top, wide, high = self.page.evaluate(
            "(({ x, y, width, height }) => [x, y, width, height])"
            "(document.querySelector('#live-scene').getBoundingClientRect())"
        )
        x, y = self.page.evaluate(TILE)
        start, end = (left + 0.16 * wide, top + 0.24 * high), (left + x, top + y)
        for _ in range(3):  # a person's first movements: the predictor learns from each
            self.move(movement(start, end))
            time.sleep(0.5)
            self.move(movement(end, start))
            time.sleep(0.5)
        started = threading.Event()
        hand = threading.Thread(target=self.move, args=(movement(start, end), started))
        hand.start()
        started.wait()
        self.take(Shot("live", "moving", width, theme))
        hand.join()
        time.sleep(0.6)
        if theme == "light":
            self.take(Shot("live", "rest", width, theme))

    def circle(self, width: int, theme: str, *, result: bool) -> None:
        """The circle before a run; ``result``: and its result, after a block of five targets."""
        self.open("circle", width, theme)
        wait_for(self.page, "!document.querySelector('#circle-start').disabled", READY_S)
        time.sleep(0.5)
        self.take(Shot("circle", "start", width, theme))
        if not result:
            return
        for name, value in (("targets", 5), ("blocks", 1)):
            self.page.evaluate(f"document.querySelector('[name={name}]').value = {value}")
        self.page.evaluate("document.querySelector('#circle-start').click()")
        place = (300.0, 300.0)
        for _ in range(6):
            wait_for(self.page, GOAL)
            x, y = self.page.evaluate(f"(({{ x, y }}) => [x, y])({GOAL})")
            rows = movement(place, (x, y))
            self.move(rows[rows[:, 0] < 1.2])
            for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
                about = {"button": "left", "clickCount": 1} if kind != "mouseMoved" else {}
                self.page.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **about)
            place = (x, y)
        wait_for(self.page, "document.querySelector('#circle-result').dataset.state === 'done'")
        self.page.evaluate("document.querySelector('#circle-result').scrollIntoView()")
        time.sleep(0.5)
        self.take(Shot("circle", "result", width, theme))

    def replay(self, width: int, theme: str) -> None:
        """The replay view, half of the way along a movement of the sample."""
        self.open("replay", width, theme)
        wait_for(self.page, "!document.querySelector('#replay-play').disabled", READY_S)
        time.sleep(0.5)
        self.take(Shot("replay", "middle", width, theme))

    def assist(self, width: int, theme: str) -> None:
        """The assist view, which needs a mouse of its own to show more."""
        self.open("assist", width, theme)
        wait_for(self.page, "!document.querySelector('#assist-predictor').disabled", READY_S)
        self.take(Shot("assist", "start", width, theme))

    def details(self, width: int, theme: str) -> None:
        """What is below the live picture: parameters, words and the attached device."""
        self.open("live", width, theme, still=True)
        wait_for(self.page, CONNECTED, READY_S)
        wait_for(self.page, "document.querySelector('#live-predictor-0').options.length > 1")
        self.page.evaluate(
            "{ const one = document.querySelector('#live-predictor-0'); one.value = 'switched';"
            "one.dispatchEvent(new Event('change'));"
            "document.querySelectorAll('#view-live > details').forEach((one) => { one.open = true; });"
            "(document.querySelector('#live-parameters-0') ?? document.querySelector('#live-device'))"
            ".scrollIntoView(); }"
        )
        time.sleep(0.5)
        self.take(Shot("live", "details", width, theme))


def main() -> None:
    """Take the pictures that are asked for."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=Path, required=True, help="folder for the pictures")
    parser.add_argument("--address", help="of a service that runs; one is started unless given")
    parser.add_argument("--views", nargs="+", default=list(VIEWS), choices=VIEWS)
    parser.add_argument("--widths", type=int, nargs="+", default=list(SIZES), choices=list(SIZES))
    parser.add_argument("--themes", nargs="+", default=list(THEMES), choices=THEMES)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    with nullcontext(arguments.address) if arguments.address else service() as address, browser() as devtools:
        one = Photographer(devtools, address, arguments.out)
        for view, width, theme in product(arguments.views, arguments.widths, arguments.themes):
            if view == "circle":
                one.circle(width, theme, result=width == 1440 and theme == "light")
            else:
                getattr(one, view)(width, theme)


if __name__ == "__main__":
    main()
