"""What the service costs: ``python -m benchmarks.service`` writes ``pages/costs/service.json``.

A server in a process of its own, a load generator in another, loopback between them. Prediction and echo
take turns of a twentieth of a second, and the median ratio of neighbours counts. Of rounds that have no
neighbour the quietest counts, because whatever else the machine does can only add. A round in which the
load generator used more than 90 % of its processor is invalid: it then measures the generator.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from urllib.error import HTTPError
from urllib.request import urlopen

from benchmarks.machine import machine
from pages import PAGES
from pages.arguments import parse
from pages.data import Table, Tables, write

FILE = PAGES / "costs" / "service.json"
TURNS_SECONDS = 15.0
ROUNDS, SECONDS = 5, 1.0
PACED_ROUNDS, PACED_SECONDS = 10, 3.0
SATURATED = 0.9
CLIENTS = 8
TARGETS = (0, 1, 20, 100)
PACED = (("one client at 1 kHz", 1, 1), ("20 clients at 1 kHz", 20, 1), ("10 clients at 8 kHz", 10, 8))
"""What is told, clients, events a frame; each client sends 1000 frames a second."""

Told = dict[str, float]


@contextmanager
def server() -> Iterator[dict[str, int]]:
    """The server under measurement: its port and its process."""
    command = [sys.executable, "-m", "benchmarks.service_server"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield {"port": int(process.stdout.readline()), "pid": process.pid}
        finally:
            process.kill()


def load(where: dict[str, int], **plan: Any) -> Told | None:
    """One round; ``None`` where the load generator saturated."""
    words = json.dumps({**where, **plan})
    command = [sys.executable, "-m", "benchmarks.service_load", words]
    result: Told = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
    return result if result["own_share"] <= SATURATED else None


def quietest(rounds: list[Told | None], by: str = "server_us") -> Told | None:
    """The valid round with the least of something."""
    return min((result for result in rounds if result), key=lambda result: result[by], default=None)


def cost_rows(where: dict[str, int]) -> list[tuple[str, ...]]:
    """Processor time a message, with prediction in turns with the echo."""
    rows = []
    for encoding, size in ((encoding, size) for encoding in ("binary", "json") for size in (1, 8, 32)):
        plan = {"path": "/v1/stream", "beside": "/v1/echo", "encoding": encoding, "size": size}
        result = load(where, clients=CLIENTS, seconds=TURNS_SECONDS, **plan)
        if result is None:
            rows.append((encoding, f"{size}", "invalid: the load generator saturated", *[""] * 5))
            continue
        added, low, high = (100 * (result[name] - 1.0) for name in ("ratio", "ratio_low", "ratio_high"))
        rate = 1e6 / result["server_us"]
        rows.append(
            (
                encoding,
                f"{size}",
                f"{result['beside_us']:.1f}",
                f"{result['server_us']:.1f}",
                f"{added:+.0f} % ({low:+.0f} to {high:+.0f})",
                f"{rate:.0f}",
                f"{rate * size:.0f}",
                f"{100 * result['own_share']:.0f} %",
            )
        )
    return rows


def target_rows(where: dict[str, int]) -> list[tuple[str, ...]]:
    """Processor time of a frame of one event, by the number of targets."""
    rounds_of: dict[tuple[str, int], list[Told | None]] = {}
    for _ in range(ROUNDS):
        for encoding, count in ((encoding, count) for encoding in ("binary", "json") for count in TARGETS):
            plan = {"path": "/v1/stream", "encoding": encoding, "size": 1, "targets": count}
            result = load(where, clients=CLIENTS, seconds=SECONDS, **plan)
            rounds_of.setdefault((encoding, count), []).append(result)
    rows = []
    for (encoding, count), rounds in rounds_of.items():
        result = quietest(rounds)
        words = "invalid: the load generator saturated" if result is None else f"{result['server_us']:.1f}"
        rows.append((encoding, f"{count}", words))
    return rows


def paced_rows(where: dict[str, int]) -> list[tuple[str, ...]]:
    """Round trips of clients that keep to the clock."""
    rounds_of: dict[str, list[Told | None]] = {}
    for _ in range(PACED_ROUNDS):
        for name, clients, size in PACED:
            plan = {"path": "/v1/stream", "encoding": "binary", "rate": 1000.0, "seconds": PACED_SECONDS}
            rounds_of.setdefault(name, []).append(load(where, clients=clients, size=size, **plan))
    rows = []
    for name, _, size in PACED:
        result = quietest(rounds_of[name], "p99_ms")
        if result is None:
            rows.append((name, f"{size}", *["invalid: the load generator saturated"], *[""] * 5))
            continue
        numbers = (f"{result['messages_per_s']:.0f}", f"{result['p50_ms']:.3f}", f"{result['p99_ms']:.3f}")
        shares = (f"{100 * result['server_share']:.0f} %", f"{100 * result['own_share']:.0f} %")
        rows.append((name, f"{size}", *numbers, *shares, f"{result['given_way']:.0f}"))
    return rows


def ready_s(cache: str | None = None) -> float:
    """Seconds from starting ``pointpred serve`` until it says that it is ready."""
    environment = {**os.environ, **({"POINTPRED_CACHE_DIR": cache} if cache else {})}
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0"]
    start = time.perf_counter()
    quiet = subprocess.DEVNULL
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=quiet, text=True, env=environment
    ) as process:
        assert process.stdout is not None
        try:
            while not (line := process.stdout.readline()).startswith("http"):
                if not line:
                    raise RuntimeError("the service ended before it was ready")
            while not is_ready(line.strip() + "readyz"):
                time.sleep(0.01)
            return time.perf_counter() - start
        finally:
            process.terminate()


def is_ready(url: str) -> bool:
    """Whether a service says that its compiled code is warm."""
    try:
        with urlopen(url) as answer:
            return bool(answer.status == 200)
    except HTTPError:
        return False


def start_rows() -> list[tuple[str, ...]]:
    """With the compile cache, and without it."""
    warm = min(ready_s() for _ in range(5))
    with tempfile.TemporaryDirectory() as empty:
        cold = ready_s(empty)
    return [("with the compile cache", f"{warm:.2f}"), ("the first ever", f"{cold:.1f}")]


COST = (
    "encoding",
    "events a frame",
    "echo, us",
    "prediction, us",
    "added (quartiles)",
    "messages/s a core",
    "events/s a core",
    "load generator",
)
PACE = (
    "load",
    "events a frame",
    "frames/s",
    "p50 ms",
    "p99 ms",
    "server",
    "load generator",
    "times predictions gave way",
)


def main() -> None:
    """Measure, print, and write the page."""
    print("measuring the service beside an echo; this takes about three minutes", file=sys.stderr)
    where_measured, tables = machine(load=True), {}
    with server() as where:
        tables["targets"] = Table.of(("encoding", "targets", "us a frame"), target_rows(where))
        tables["cost"] = Table.of(COST, cost_rows(where))
        tables["paced"] = Table.of(PACE, paced_rows(where))
    tables["start"] = Table.of(("start", "s until ready"), start_rows())
    write(Tables(tables, where_measured), FILE)
    print(f"wrote {FILE}")


if __name__ == "__main__":
    parse(__doc__)
    main()
