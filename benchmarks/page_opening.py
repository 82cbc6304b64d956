"""How soon the live page predicts, and how late: ``python -m benchmarks.page_opening``.

Ten openings of each kind in turn, each with an empty cache, in one Chromium over loopback: from the start of
the navigation to the first drawn prediction of the recommended predictor. Then a mouse moves at 125 Hz with
the page's own comparison switched on: the delays that it shows, and how far both predictions are apart.
The service has compiled everything before. Writes ``pages/costs/opening.json``.
"""

from __future__ import annotations

import math
import statistics
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from benchmarks.machine import machine
from pages import PAGES
from pages.arguments import parse
from pages.data import Table, Tables, write
from pointpred_server.demo import write_demo
from tests.server.page_browser import Visitor, service, visitor

FILE = PAGES / "costs" / "opening.json"
OPENINGS = 10
SIZE = (1440, 900)
SECONDS, RATE_HZ = 20.0, 125.0
FIRST = """new MutationObserver(() => {
  const regions = document.querySelector('#live-scene')?.dataset.regions;
  if (window.first === undefined && regions && JSON.parse(regions)[0]) window.first = performance.now();
}).observe(document, { subtree: true, attributes: true, attributeFilter: ['data-regions'] });"""
COMPARED = "document.querySelector('#live-compared')"


class Quiet(SimpleHTTPRequestHandler):
    """A static host that prints nothing."""

    def log_message(self, format: str, *args: object) -> None:
        """Print nothing."""


@contextmanager
def static_host() -> Iterator[str]:
    """The page as files; yields its address."""
    with tempfile.TemporaryDirectory() as folder:
        write_demo(Path(folder))
        with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=folder)) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            yield f"http://127.0.0.1:{server.server_port}/"
            server.shutdown()


def first_prediction_ms(one: Visitor, address: str) -> float:
    """Open the page with an empty cache; DevTools do not watch the network, which takes time."""
    one.page.call("Network.clearBrowserCache")
    one.page.call("Network.disable")
    one.open(address)
    one.wait("window.first !== undefined")
    found = float(one.value("first"))
    one.page.call("Network.enable")
    return found


def compared(one: Visitor, address: str) -> tuple[tuple[str, str], ...]:
    """What the page's comparison shows after some seconds of movement."""
    one.open(address)
    one.wait("document.querySelector('#live-card-0 .connection').dataset.state === 'open'")
    one.value("document.querySelector('#live-compare').click()")
    one.wait("document.querySelector('#live-compare-status').textContent.startsWith('Move')")
    left, top, width, height = one.corner("#live-scene")
    began = time.perf_counter()
    for i in range(round(SECONDS * RATE_HZ)):
        time.sleep(max(0.0, began + i / RATE_HZ - time.perf_counter()))
        angle = 2.0 * math.pi * i / RATE_HZ
        x = left + width * (0.5 + 0.4 * math.sin(0.5 * angle))
        y = top + height * (0.5 + 0.3 * math.sin(0.35 * angle))
        one.mouse("mouseMoved", x, y)
    one.page.wait_for_results()
    time.sleep(0.5)
    page, by_service = (one.text(f"#live-compared [data-of={of}]") for of in ("page", "service"))
    return (
        ("delay in the page, median of 100, ms", page),
        ("delay by the service, median of 100, ms", by_service),
        ("events compared", str(one.value(f"{COMPARED}.dataset.events"))),
        ("largest distance of both endpoints, px", f"{float(one.value(f'{COMPARED}.dataset.px')):.1e}"),
    )


def main() -> None:
    """Measure, print and write."""
    where = machine(load=True)
    with service() as url, static_host() as files, tempfile.TemporaryDirectory() as profile:
        kinds = {
            "in the page, served by the service": url,
            "in the page, files of a static host": files,
            "by the service": f"{url}?by=service",
        }
        found: dict[str, list[float]] = {kind: [] for kind in kinds}
        with visitor(Path(profile), SIZE) as one:
            one.page.call("Page.addScriptToEvaluateOnNewDocument", source=FIRST)
            for kind, address in [pair for _ in range(OPENINGS) for pair in kinds.items()]:
                found[kind].append(first_prediction_ms(one, address))
            delays = compared(one, url)
    openings = [
        (kind, f"{statistics.median(ms):.0f}", f"{min(ms):.0f}", f"{max(ms):.0f}")
        for kind, ms in found.items()
    ]
    for row in (*openings, *delays):
        print("  ".join(row))
    columns = ("predicted", "median of ten, ms", "fastest, ms", "slowest, ms")
    write(
        Tables({"openings": Table.of(columns, openings), "delays": Table.of(("", "shown"), delays)}, where),
        FILE,
    )


if __name__ == "__main__":
    parse(__doc__)
    main()
