"""What prediction in a page costs: ``python -m evidence costs in_page``.

The costs of ``page_cost.mjs`` in Node's V8, and the share of a
core of a page in Chromium while its mouse moves: ``process`` is that of the page's process, ``more`` what a
page without registrations does not take; js.foresight of npm registers the same elements in the same page.
Needs node, npm and Chromium.
"""

from __future__ import annotations

import math
import statistics
import subprocess
import tempfile
import threading
import time
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, NamedTuple

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.intent.site import IMPORTS, PACKAGE, install
from evidence.machine import machine
from pointpred.live.devtools import Page, open_page
from tests.server import browser

LIB = Path(__file__).parents[2] / "server" / "pointpred_server" / "web" / "lib"
SIZE = 1250, 700
COUNT, PREDICTORS = 1000, ("minimum-jerk", "kinematic-adaptive")
SECONDS, ROUNDS, RATE_HZ = 5.0, 5, 1000.0
ELEMENTS = """{ document.body.innerHTML = ''; document.body.style = 'margin: 0; position: relative';
for (let i = 0; i < COUNT; i += 1) {
  const one = document.createElement('a'), [column, row] = [i % COLUMNS, Math.floor(i / COLUMNS)];
  one.textContent = i;
  const [left, top, side] = [column * STEP, row * STEP, STEP - 6].map((px) => `${px}px`);
  Object.assign(one.style, { position: 'absolute', left, top, width: side, height: side, overflow: 'clip' });
  document.body.append(one);
} }"""
REGISTER = """import('/intent/index.js').then(({ onIntent }) => {
  window.fired = 0;
  for (const one of document.querySelectorAll('a'))
    onIntent(one, () => { fired += 1; }, { predictor: 'PREDICTOR' });
  return new Promise((done) => setTimeout(done, 1500));
})"""


FORESIGHT = """import('js.foresight').then(({ ForesightManager }) => {
  const manager = ForesightManager.initialize();
  window.fired = 0;
  for (const element of document.querySelectorAll('a'))
    manager.register({ element, callback: () => { fired += 1; } });
  return new Promise((done) => setTimeout(done, 1500));
})"""


class Host(SimpleHTTPRequestHandler):
    """The browser client and packages of npm as files; any other address is an empty page."""

    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".mjs": "text/javascript"}

    def __init__(self, *given: Any, modules: Path | None = None, **more: Any) -> None:
        self.modules = modules
        super().__init__(*given, **more)

    def translate_path(self, path: str) -> str:
        """The file at an address."""
        if self.modules is not None and path.startswith("/npm/"):
            return str(self.modules / path.removeprefix("/npm/"))
        return super().translate_path(path)

    def do_GET(self) -> None:
        """Answer a request."""
        if self.path.endswith((".js", ".mjs")):
            return super().do_GET()
        body = f"<!doctype html><title>cost</title>{IMPORTS}<body>".encode()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)
        return None

    def log_message(self, format: str, *args: object) -> None:
        """Print nothing."""


COALESCED = """new Promise((done) => {
  const [seconds, rate, width, height] = [SECONDS, RATE, WIDTH, HEIGHT], began = performance.now();
  const at = (k) => ({ pointerType: 'mouse', isPrimary: true, bubbles: true,
    clientX: width * (0.5 + 0.45 * Math.sin(6 * k / rate)),
    clientY: height * (0.5 + 0.45 * Math.sin(4 * k / rate + 1)) });
  let sent = 0;
  const frame = () => {
    const now = (performance.now() - began) / 1000, due = Math.floor(Math.min(now, seconds) * rate);
    const moves = [];
    for (; sent < due; sent += 1) moves.push(new PointerEvent('pointermove', at(sent)));
    const event = new PointerEvent('pointermove', { ...at(sent - 1), coalescedEvents: moves });
    if (moves.length) document.body.dispatchEvent(event);
    if (now < seconds) requestAnimationFrame(frame);
    else done(sent);
  };
  requestAnimationFrame(frame);
})"""
"""Moves of a mouse at a rate, handed over once a frame."""


def drive_coalesced(page: Page, seconds: float, rate_hz: float) -> int:
    """Moves of the mouse for some seconds, by the page itself; returns how many."""
    values = {"SECONDS": seconds, "RATE": rate_hz, "WIDTH": SIZE[0], "HEIGHT": SIZE[1]}
    script = COALESCED
    for word, value in values.items():
        script = script.replace(word, str(value))
    return int(page.evaluate(script))


def busy(page: Page) -> tuple[float, float]:
    """Seconds that the page's process, and its main thread, have worked so far."""
    metrics = {one["name"]: one["value"] for one in page.call("Performance.getMetrics")["metrics"]}
    return metrics["ProcessTime"], metrics["TaskDuration"]


def share(page: Page, seconds: float, rate_hz: float) -> tuple[float, float, float]:
    """Share of a core of the process and of its main thread, and moves a second that were sent."""
    before, began = busy(page), time.perf_counter()
    sent = drive_coalesced(page, seconds, rate_hz)
    took = time.perf_counter() - began
    process, main = (after - first for after, first in zip(busy(page), before, strict=True))
    return process / took, main / took, sent / took


LISTEN = """addEventListener('pointermove', (event) => {
  window.rows = event.getCoalescedEvents().map((one) => [one.timeStamp, one.clientX, one.clientY]);
}, { capture: true, passive: true })"""
"""What hearing every event costs, whatever is done with them."""


class Costs(NamedTuple):
    """What a page costs: shares of a core, and moves a second."""

    process: float
    thread: float
    more: float
    rate: float


def costs(in_view: int, modules: Path) -> dict[str, Costs]:
    """The medians of all rounds, by what is registered in the page.

    ``in_view``: elements in the window; ``modules``: where js.foresight is installed.
    """
    step = math.floor(math.sqrt(SIZE[0] * SIZE[1] / in_view))
    elements = (
        ELEMENTS.replace("COUNT", str(COUNT))
        .replace("COLUMNS", str(SIZE[0] // step))
        .replace("STEP", str(step))
    )
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Host, directory=str(LIB), modules=modules))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with (
        tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile,
        browser.running(Path(profile)) as chromium,
        open_page(chromium.devtools, timeout_s=browser.PATIENCE_S) as page,
    ):
        page.call("Performance.enable")
        size = {"width": SIZE[0], "height": SIZE[1], "deviceScaleFactor": 1, "mobile": False}
        page.call("Emulation.setDeviceMetricsOverride", **size)
        names = (None, "listener alone", *PREDICTORS, PACKAGE)
        measured: dict[str | None, list[tuple[float, ...]]] = {name: [] for name in names}
        for _ in range(ROUNDS):  # in turn, so that a busy machine is busy for each of them
            for name in names:
                page.go(f"http://127.0.0.1:{server.server_port}/page")
                page.evaluate(elements)
                if name == "listener alone":
                    page.evaluate(LISTEN)
                elif name == PACKAGE:
                    page.evaluate(FORESIGHT)
                elif name is not None:
                    page.evaluate(REGISTER.replace("PREDICTOR", name))
                drive_coalesced(page, 3.0, RATE_HZ)  # what the browser compiles at first
                measured[name].append(share(page, SECONDS, RATE_HZ))
    server.shutdown()
    server.server_close()
    base = statistics.median(one[0] for one in measured[None])
    medians = {}
    for name, shares in measured.items():
        process, thread, rate = (statistics.median(column) for column in zip(*shares, strict=True))
        medians[name or "nothing registered"] = Costs(process, thread, process - base, rate)
    return medians


IN_VIEW = (1000, 100)


def events() -> Table:
    """What an event costs, alone and with 100 targets."""
    script = Path(__file__).with_name("page_cost.mjs")
    done = subprocess.run(["node", str(script)], capture_output=True, text=True, check=True)
    rows = [line.split() for line in done.stdout.splitlines()]
    columns = ("predictor", "an event, us", "with 100 targets, us")
    return Table.of(columns, [(f"`{name}`", *numbers) for name, *numbers in rows])


def pages() -> Table:
    """The share of a core of a page while its mouse moves at 1 kHz."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        modules = install(Path(folder))
        for in_view in IN_VIEW:
            rows += [
                (str(in_view), name, f"{100.0 * one.process:.1f}", f"{100.0 * one.more:.1f}")
                for name, one in costs(in_view, modules).items()
            ]
    columns = ("in view", "registered with", "process, %", "more than without, %")
    return Table.of(columns, rows)


def main() -> None:
    """Measure, print and write."""
    where = machine(load=True)
    tables = {"in_page_events": events(), "in_page_share": pages()}
    for table in tables.values():
        for row in table.rows:
            print("  ".join(map(str, row)))
    keep("costs", tables, part="in_page", machine=where)


if __name__ == "__main__":
    parse(__doc__)
    main()
