"""What a reverse proxy adds to the delay: ``python -m benchmarks.proxies``.

The same clients of a load generator directly at a service, behind nginx and behind HAProxy, in turns. The
proxies run with the configurations of docs/guide/proxies.md, without TLS. The service has one core, the
generator another where there is one, and the proxy both.
"""

from __future__ import annotations

import tempfile
from contextlib import ExitStack
from pathlib import Path

from benchmarks import reverse_proxies
from benchmarks.load.cores import ALL, LAST, on_cores
from benchmarks.load.generator import Group, Plan, Run, run
from benchmarks.load.servers import service
from benchmarks.machine import machine
from pages import PAGES
from pages.arguments import parse
from pages.data import Table, Tables, write

FILE = PAGES / "costs" / "proxies.json"
CLIENTS = (1, 10)
RATE_HZ = 1000.0
ROUNDS = 5
SECONDS = 2.0
HELLO = '{"type":"hello","version":1,"predictor":"kinematic-adaptive"}'


def measured(ports: dict[str, int], clients: int) -> dict[str, list[Run]]:
    """Runs by the name of the way, in turns."""
    runs: dict[str, list[Run]] = {name: [] for name in ports}
    for _ in range(ROUNDS):
        for name, port in ports.items():
            group = Group(name, port, clients=clients, rate=RATE_HZ, greeting=(HELLO,))
            runs[name].append(run(Plan((group,), seconds=SECONDS), LAST))
    return runs


def row(name: str, clients: int, runs: list[Run]) -> list[str]:
    """The round with the smallest p99: what else the machine does can only add."""
    best = min((run.groups[0] for run in runs), key=lambda group: group.delay.p99_ms)
    numbers = (best.delay.p50_ms, best.delay.p99_ms, best.delay.p999_ms, best.late.p99_ms)
    return [str(clients), name, *(f"{number:.3f}" for number in numbers)]


def main() -> None:
    """Measure, print, and keep the numbers."""
    where = machine(load=True)
    rows = []
    with ExitStack() as stack:
        ports = {"directly": stack.enter_context(service()).port}
        for name, program in reverse_proxies.PROGRAMS.items():
            if program is None:
                raise SystemExit(f"{name} is not installed: on Debian, apt install nginx haproxy")
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
            with on_cores(ALL):
                one = ports["directly"]
                ports[name] = stack.enter_context(reverse_proxies.proxy(name, folder, [one, one], tls=False))
        for clients in CLIENTS:
            rows += [row(name, clients, runs) for name, runs in measured(ports, clients).items()]
    for each in rows:
        print("  ".join(each))
    columns = ("clients", "way", "p50 ms", "p99 ms", "p99.9 ms", "generator late, p99 ms")
    write(Tables({"delay": Table.of(columns, rows)}, where), FILE)


if __name__ == "__main__":
    parse(__doc__)
    main()
