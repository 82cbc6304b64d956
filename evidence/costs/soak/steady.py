"""The steady clients, whose delays are judged: ``python -m evidence.costs.soak.steady PLAN``.

They send an event a message, and keep to the clock whatever comes back. The loop waits by ``select``, whose
timeouts are exact; an event loop's are whole milliseconds.
"""

from __future__ import annotations

import select
import socket
import time
from pathlib import Path

import msgspec

from evidence.arguments import parse
from evidence.costs.soak.client import BYE, StreamClient, upgrade
from evidence.costs.soak.reports import Plan, Reporter

KINDS = (
    ("kinematic-adaptive", 125.0, "json"),
    ("kinematic-adaptive", 125.0, "binary"),
    ("linear", 1000.0, "binary"),
    ("switched", 1000.0, "binary"),
)
"""Predictor, events a second, encoding."""
END_S = 20.0
"""So long the last answers may take."""


class Steady:
    """One client and its socket."""

    def __init__(self, plan: Plan, number: int) -> None:
        predictor, self.rate_hz, encoding = KINDS[number]
        self.client = StreamClient(
            Path(plan.scratch), number, self.rate_hz, predictor=predictor, encoding=encoding
        )
        self.socket = socket.create_connection(("127.0.0.1", plan.port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.sendall(upgrade(plan.port))
        while not self.client.session:
            self.read()
        self.due = time.perf_counter() + number / 10_000

    def read(self) -> None:
        """Take in what came; raises ConnectionError where the service has left."""
        data = self.socket.recv(1 << 16)
        if not data:
            raise ConnectionError(f"a steady client was cut; close code {self.client.close_code}")
        if reply := self.client.receive(data, time.perf_counter()):
            self.socket.sendall(reply)

    def send_due(self, now: float) -> None:
        """Send every event whose time has come."""
        while self.due <= now:
            self.socket.sendall(self.client.frames(1, self.due))
            self.due += 1.0 / self.rate_hz


def main(words: str) -> None:
    """Send until stdin is closed, then compare everything."""
    plan = msgspec.json.decode(words, type=Plan)
    reporter = Reporter(plan)
    steady = [Steady(plan, number) for number in range(len(KINDS))]
    by_socket = {one.socket: one for one in steady}
    reported_at = time.perf_counter()
    while not reporter.stopping.is_set():
        now = time.perf_counter()
        for one in steady:
            one.send_due(now)
        pause = min(one.due for one in steady) - time.perf_counter()
        for ready in select.select(by_socket, [], [], max(0.0, pause))[0]:
            by_socket[ready].read()
        if now - reported_at >= 1.0:
            reported_at = now
            tell(reporter, steady)
    until = time.perf_counter() + END_S
    while not all(one.client.answered for one in steady) and time.perf_counter() < until:
        for ready in select.select(by_socket, [], [], 0.1)[0]:
            by_socket[ready].read()
    for one in steady:
        one.socket.sendall(BYE)
        while not one.client.close_code:
            one.read()
        one.socket.close()
    tell(reporter, steady)
    for one in steady:
        reporter.conclude(one.client, whole=True)
    reporter.write()


def tell(reporter: Reporter, steady: list[Steady]) -> None:
    """Compare what came, and report."""
    for one in steady:
        one.client.run.compare()
        reporter.add_delays(one.client.take_delays())
        reporter.wrong += one.client.run.wrong
        one.client.run.wrong.clear()
    reporter.write()


if __name__ == "__main__":
    main(parse(__doc__, metavar="PLAN", most=1)[0])
