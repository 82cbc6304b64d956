"""The whole way: a real browser, the real service, its own count of events."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from urllib.request import urlopen

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.live.devtools import drive_mouse
from tests.server import browser
from tests.server.listener import soon

pytestmark = browser.needed


@pytest.fixture
def served() -> Iterator[tuple[str, str]]:
    """The addresses of the page and of the metrics of a service in a process of its own."""
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", "--metrics-port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as service:
        assert service.stdout is not None
        assert service.stderr is not None
        said = json.loads(next(line for line in service.stderr if "Metrics: " in line))["message"]
        yield service.stdout.readline().strip(), said.removeprefix("Metrics: ")
        service.terminate()


def test_the_service_counts_every_event_of_a_page(served: tuple[str, str], tmp_path: Path) -> None:
    url, metrics = served

    def counted() -> float:
        with urlopen(metrics) as answer:
            found = re.search(r"^pointpred_events_total (\S+)$", answer.read().decode(), re.MULTILINE)
        return float(found[1]) if found else 0.0

    connect = """import("/pointpred.js").then(({ connect }) => {
      window.heard = [];
      window.connection = connect(undefined, { reply: "event" });
      connection.on("prediction", (prediction) => heard.push(prediction.t));
    })"""
    with (
        browser.running(tmp_path / "profile") as chromium,
        chromium.tab(f"{url}healthz") as page,
        chromium.hand(page) as hand,
    ):
        page.evaluate(connect)
        soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")
        i = np.arange(500.0)
        drive_mouse(hand, EventColumns.of(i / 1000, 100 + i, 100 + i / 4), speed=math.inf)
        soon(lambda: page.evaluate("connection.sent") == 500, "500 events were sent")
        soon(lambda: counted() == 500.0, "500 events were counted")
        soon(lambda: page.evaluate("heard.length") > 0, "predictions came back")
        assert page.evaluate("connection.dropped") == 0
        assert page.evaluate("connection.delayMs") > 0.0
