"""Two services behind a proxy restart one by one, or one is killed: every client goes on at the other one.

Some clients are those of a browser, the others those of Python, with the example of the guide. Each makes one
movement after another, and is told along every one what a pipeline says that nobody interrupts.
"""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from itertools import cycle
from pathlib import Path
from statistics import median
from typing import Any
from urllib.request import urlopen

import numpy as np
import pytest
from playwright.sync_api import Page

import pointpred.client.connection
from pointpred import EventColumns, PredictionColumns
from pointpred.client import connect
from pointpred.errors import SourceError
from tests.server import browser
from tests.server import reverse_proxies as proxies
from tests.server.listener import soon
from tests.server.running import PATIENCE_S
from tests.server.test_proxies import KINDS, PERSON, TOKEN, movements, without_a_break

pytestmark = browser.needed

BROWSERS, PYTHONS = 8, 58
"""Clients of each kind. Chromium lets a page with many more wait for up to 5 s before each of them."""
PAUSE_S = 0.8
"""Between two movements of a client."""
SETTLED_S = 2.5
"""Until most clients have moved several times."""
PYTHON_ADDRESSES = ("127.0.0.2", "127.0.0.3")
"""Those of the Python clients: a proxy admits 50 connections of one address."""
REFUSED = 2
"""Attempts of a client that may fail in all: they meet a service just as it ends."""

WALK = """
(async () => {
  const { connect } = await import("/pointpred.js");
  const parts = PARTS, pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  const until = async (condition) => { while (!condition()) await pause(5); };
  window.ending = false;
  window.clients = Array.from({ length: COUNT }, () => {
    const client = { heard: [], opened: [], lost: [], attempts: 1, done: false };
    const connection = connect(undefined, { ...OPTIONS, queue: 0 });  // what was interrupted is sent again
    let predicted = [], known = "";
    connection.on("prediction", ({ x, y }) => predicted.push([x, y]));
    const now = () => performance.now() / 1000;
    connection.on("welcome", ({ limits }) => client.opened.push([now(), limits.max_targets]));
    connection.on("state", (state) => {
      if (state === "connecting") client.attempts += 1;
      if (state === "waiting" && client.opened.length > client.lost.length) client.lost.push(now());
    });
    (async () => {
      while (!window.ending) {
        await until(() => connection.state === "open");
        const part = parts[client.heard.length], before = client.lost.length;
        predicted = [];
        connection.send(part);
        await until(() => predicted.length === part.length || client.lost.length > before);
        if (predicted.length < part.length) continue;
        const heard = predicted;
        connection.reset();
        const person = await connection.person();
        if (person === known) continue;  // the answer was lost: the movement was not learned
        known = person;
        client.heard.push(heard);
        await pause(PAUSE * (0.5 + Math.random()));
      }
      client.done = true;
      connection.close();
    })();
    return client;
  });
})()
"""


class Restarted:
    """A service as a process on a port of its own; clients know it by its ``max_targets``."""

    def __init__(self, number: int) -> None:
        self.number = number
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port: int = free.getsockname()[1]
        self.start()

    def start(self) -> None:
        """Start it and wait until it is ready."""
        words = [f"--port={self.port}", "--trust-proxy=127.0.0.1"]
        limits = {"MAX_TARGETS": self.number, "MAX_SESSIONS": BROWSERS + PYTHONS, "LOG_FORMAT": "json"}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "pointpred", "serve", *words],
            env={
                **os.environ,
                "POINTPRED_TOKEN": TOKEN,
                **{f"POINTPRED_{name}": str(value) for name, value in limits.items()},
            },
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        soon(self.is_ready, "it is ready")

    def is_ready(self) -> bool:
        assert self.process.poll() is None, "it ended"
        try:
            with urlopen(f"http://127.0.0.1:{self.port}/readyz", timeout=PATIENCE_S):
                return True
        except OSError:
            return False

    def end(self, number: int) -> int:
        """Send it a signal; returns its exit code."""
        self.process.send_signal(number)
        return self.process.wait(PATIENCE_S)

    def restart(self) -> None:
        """As ``systemctl restart`` does."""
        assert self.end(signal.SIGTERM) in (0, -signal.SIGTERM)
        self.start()


class Moving(list[EventColumns]):
    """Movements, one after another with pauses, until it is said that there are no more."""

    ended = False

    def __len__(self) -> int:
        return 0 if self.ended else super().__len__()

    def __getitem__(self, place: Any) -> Any:
        time.sleep(PAUSE_S * np.random.default_rng().uniform(0.5, 1.5))
        return super().__getitem__(place)


@dataclass
class Client:
    """What became of a client: when it was at which service, and what it was told."""

    opened: list[tuple[float, int]] = field(default_factory=list)
    """Times, s, and the number of the service."""
    lost: list[float] = field(default_factory=list)
    attempts: int = 0
    """How often it tried to open a session."""
    heard: list[np.ndarray] = field(default_factory=list)
    """x, y of the predictions along each movement."""

    @property
    def without_s(self) -> list[float]:
        """How long it had no session, each time."""
        return [opened - lost for lost, (opened, _) in zip(self.lost, self.opened[1:], strict=False)]


class PythonClient(threading.Thread):
    """Runs the example of the guide."""

    def __init__(self, url: str, parts: list[EventColumns]) -> None:
        super().__init__()
        self.client, self.movements = Client(), Moving(parts)
        self.predicted: list[PredictionColumns] = []
        self._names, self._url = proxies.example(), url
        self._names["connect"] = self._connect
        self.start()

    def run(self) -> None:
        predict = self._names["predict_movements"]
        self.predicted = predict(self._url, self.movements, token=TOKEN, timeout_s=PATIENCE_S)
        self.client.heard = [each.table[:, 1:3] for each in self.predicted]

    @contextmanager
    def _connect(self, url: str, **options: Any) -> Iterator[Any]:
        """``connect``, which also notes when the session begins and when it is lost."""
        self.client.attempts += 1
        with connect(url, **options) as connection:
            self.client.opened.append((time.monotonic(), connection.limits.max_targets))
            try:
                yield connection
            except SourceError:
                self.client.lost.append(time.monotonic())
                raise


class Crowd:
    """All clients, who move."""

    def __init__(self, url: str, page: Page, parts: list[EventColumns]) -> None:
        self._page = page
        rows = [[[t, x, y, None, None, 0] for t, x, y in part.table[:, :3].tolist()] for part in parts]
        options = {"token": TOKEN, "predictor": PERSON, "reply": "event", "pointer": False}
        filled = {"PARTS": rows, "COUNT": BROWSERS, "OPTIONS": options, "PAUSE": 1000 * PAUSE_S}
        script = WALK
        for name, value in filled.items():
            script = script.replace(name, json.dumps(value))
        page.evaluate(script)
        self._python = [PythonClient(url, parts) for _ in range(PYTHONS)]

    def clients(self) -> list[Client]:
        """Everybody, as of now; those of the browser first."""
        told = self._page.evaluate("clients.map(({ done, ...kept }) => kept)")
        browsers = [
            Client(
                [(at, number) for at, number in one["opened"]],
                one["lost"],
                one["attempts"],
                [np.array(xy, dtype=np.float64) for xy in one["heard"]],
            )
            for one in told
        ]
        return [*browsers, *(each.client for each in self._python)]

    def at(self) -> list[int]:
        """The number of the service at which each client is; 0: at none."""
        where = "clients.map(({ opened, lost }) => opened.length > lost.length ? opened.at(-1)[1] : 0)"
        python = [each.client for each in self._python]
        return [
            *self._page.evaluate(where),
            *(one.opened[-1][1] if len(one.opened) > len(one.lost) else 0 for one in python),
        ]

    def settle(self) -> None:
        """Wait until everybody has a session, and has moved for a while."""
        soon(lambda: 0 not in self.at(), "everybody has a session")
        time.sleep(SETTLED_S)

    def end(self) -> list[Client]:
        """Everybody stops after the movement under way."""
        self._page.evaluate("window.ending = true")
        for each in self._python:
            each.movements.ended = True
        for each in self._python:
            each.join(PATIENCE_S)
            assert not each.is_alive()
        soon(lambda: self._page.evaluate("clients.every(({ done }) => done)"), "all have ended")
        return self.clients()


@contextmanager
def crowded(
    name: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[tuple[list[Restarted], Crowd, list[EventColumns]]]:
    """Two services behind a proxy, and clients of both kinds that move."""
    dial, addresses = pointpred.client.connection.dial, cycle(PYTHON_ADDRESSES)
    monkeypatch.setattr(
        pointpred.client.connection,
        "dial",
        lambda url, **options: dial(url, source_address=(next(addresses), 0), **options),
    )
    monkeypatch.setenv("SSL_CERT_FILE", str(folder / "lab.crt"))
    parts = movements(200)
    with ExitStack() as stack:
        services = [Restarted(901), Restarted(902)]
        for service in services:
            stack.callback(lambda service=service: service.end(signal.SIGKILL))
        port = stack.enter_context(proxies.proxy(name, folder, [each.port for each in services], tls=True))
        flags = ["--ignore-certificate-errors"]
        chromium = stack.enter_context(browser.running(folder / "profile", *flags))
        url = f"https://localhost:{port}"
        page = stack.enter_context(chromium.tab(f"{url}/healthz"))
        crowd = Crowd(url, page, parts)
        stack.callback(crowd.end)
        crowd.settle()
        yield services, crowd, parts


def report(name: str, clients: list[Client]) -> None:
    """What `pytest -s` shows."""
    lost = sum(len(one.opened) <= len(one.lost) for one in clients)
    for kind, some in (("browser", clients[:BROWSERS]), ("Python", clients[BROWSERS:])):
        waits = sorted(wait for one in some for wait in one.without_s)
        print(
            f"\n{name}: {lost} of {len(clients)} sessions lost; {kind}: {len(waits)} interruptions,"
            f" without a service for {median(waits):.2f} s (median), {waits[-1]:.2f} s (longest),"
            f" {sum(one.attempts - len(one.opened) for one in some)} attempts refused,"
            f" {sum(len(one.heard) for one in some)} movements"
        )


@pytest.mark.slow
@pytest.mark.parametrize(("name", "tls"), [KINDS[0], KINDS[2]])
def test_no_client_is_lost_when_a_service_is_killed_or_both_restart_one_by_one(
    name: str, tls: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with crowded(name, tmp_path, monkeypatch) as (services, crowd, parts):
        first, second = services
        before = crowd.at()
        assert 0.3 < before.count(first.number) / len(before) < 0.7, "sessions are spread"
        first.end(signal.SIGKILL)
        crowd.settle()
        assert set(crowd.at()) == {second.number}
        interrupted = [len(one.lost) for one in crowd.clients()]
        assert interrupted == [int(number == first.number) for number in before], "its own sessions only"
        first.start()
        for service in (second, first):
            time.sleep(SETTLED_S)  # longer than a proxy leaves out a service that was refused
            service.restart()
            crowd.settle()
        clients = crowd.end()
    report(name, clients)
    most = max(len(one.heard) for one in clients)
    expected = [each.table[:, 1:3] for each in without_a_break(parts[:most])]
    for one in clients:
        assert len(one.lost) >= 1
        assert len(one.opened) == len(one.lost) + 1
        assert one.attempts <= len(one.opened) + REFUSED, "a proxy finds the service that is there"
        assert len(one.heard) >= 5
        for heard, wanted in zip(one.heard, expected, strict=False):
            np.testing.assert_array_equal(heard, wanted)
