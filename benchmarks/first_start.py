"""The first hour's first minutes: ``python -m benchmarks.first_start``.

A fresh clone of the last commit in a temporary folder, a home and a compile cache that are empty, an
environment with nothing but a path; then what ``make run`` does: install, start, and start again. Seconds are
those of the clock on the processors named; processor seconds beside them say what a busy machine adds.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.request import urlopen

from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from benchmarks.machine import machine
from pages.arguments import parse
from pages.data import Table, Tables, write
from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.registry import RECOMMENDED

ROOT = Path(__file__).parent.parent
FILE = ROOT / "pages" / "costs" / "first_start.json"
PROCESSORS = 2
RATE_HZ = 125.0
PATIENCE_S = 900.0
MIB = 1 << 20


def fresh(folder: Path) -> dict[str, str]:
    """A clone in ``folder``/clone, and the environment of somebody who has just come."""
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(folder / "clone")], check=True)
    (folder / "home").mkdir()
    environment = {name: os.environ[name] for name in ("PATH", "LANG") if name in os.environ}
    # Where packages come from is the machine's affair: a mirror that it names is used here, too.
    environment |= {name: value for name, value in os.environ.items() if name.startswith("PIP_")}
    return environment | {"HOME": str(folder / "home")}


def installed(folder: Path, environment: dict[str, str]) -> tuple[tuple[str, ...], ...]:
    """Seconds and sizes of what ``make run`` installs."""
    clone = folder / "clone"
    python = f"PYTHON={sys.executable}"
    before, began = cpu_s(), time.perf_counter()
    subprocess.run(["make", "--silent", python, ".venv/.run"], cwd=clone, env=environment, check=True)
    seconds, used = time.perf_counter() - began, cpu_s() - before
    size = sum(path.lstat().st_size for path in (clone / ".venv").rglob("*")) / MIB
    return (
        ("install what running needs", f"{seconds:.1f}", f"{used:.1f}"),
        ("its size", f"{size:.0f} MiB", ""),
    )


@contextmanager
def service(folder: Path, environment: dict[str, str]) -> Iterator[tuple[str, float]]:
    """A service from the clone: where its page is, and when its process was started."""
    began = time.perf_counter()
    command = [str(folder / "clone" / ".venv" / "bin" / "pointpred"), "serve", "--port", "0"]
    quiet = subprocess.DEVNULL
    with subprocess.Popen(
        command, cwd=folder / "clone", env=environment, stdout=subprocess.PIPE, stderr=quiet, text=True
    ) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip(), began
        finally:
            process.terminate()


def started(name: str, folder: Path, environment: dict[str, str]) -> list[tuple[str, ...]]:
    """From the start of the process to the page, the first prediction, and everything compiled."""
    before = cpu_s()
    with service(folder, environment) as (url, began):
        page_s = time.perf_counter() - began
        with greeted(url) as socket:
            ask(socket, 0)
            answer_s = time.perf_counter() - began
            delays = follow(socket, url)
            all_s = time.perf_counter() - began
    delays.sort()
    p50, p99 = (1e3 * delays[int(len(delays) * share)] for share in (0.5, 0.99))
    return [
        (f"{name}: the page can be opened", f"{page_s:.1f}", ""),
        (f"{name}: first prediction of `{RECOMMENDED}`", f"{answer_s:.1f}", ""),
        (f"{name}: every predictor is ready", f"{all_s:.1f}", f"{cpu_s() - before:.1f}"),
        (f"{name}: answers meanwhile, p50 and p99", f"{p50:.1f} and {p99:.1f} ms", ""),
    ]


@contextmanager
def greeted(url: str) -> Iterator[ClientConnection]:
    """A session with the recommended predictor."""
    address = url.replace("http", "ws", 1) + "v1/stream"
    with connect(address, subprotocols=[Subprotocol(SUBPROTOCOL)], open_timeout=PATIENCE_S) as socket:
        socket.send(json.dumps({"type": "hello", "version": 1, "predictor": RECOMMENDED}))
        socket.recv(PATIENCE_S)
        yield socket


def ask(socket: ClientConnection, number: int) -> None:
    """One event, and its prediction."""
    event = [number / RATE_HZ, 5.0 + number, 6.0, None, None, 0]
    socket.send(json.dumps({"type": "events", "events": [event]}))
    socket.recv(PATIENCE_S)


def follow(socket: ClientConnection, url: str) -> list[float]:
    """A session at the rate of a plain mouse until all is compiled: seconds of each answer."""
    delays, number = [], 1
    while True:
        began = time.perf_counter()
        ask(socket, number)
        delays.append(time.perf_counter() - began)
        time.sleep(max(0.0, 1 / RATE_HZ - delays[-1]))
        number += 1
        if number % int(RATE_HZ) == 0 and far(url)["next"] is None:
            return delays


def far(url: str) -> dict[str, Any]:
    """How far compiling is."""
    with urlopen(url + "v1/compiling") as answer:
        progress: dict[str, Any] = json.load(answer)
        return progress


def cpu_s() -> float:
    """Processor seconds of all children that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main() -> None:
    """Measure, print, and keep the numbers."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, set(sorted(os.sched_getaffinity(0))[:PROCESSORS]))
    where = machine(load=True)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        environment = fresh(folder)
        rows = [*installed(folder, environment), *started("first start", folder, environment)]
        rows += started("second start", folder, environment)
    for row in rows:
        print("  ".join(row))
    write(Tables({"numbers": Table.of(("", "s", "processor s"), rows)}, where), FILE)


if __name__ == "__main__":
    parse(__doc__)
    main()
