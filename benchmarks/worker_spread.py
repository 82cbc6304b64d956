"""How connections are spread over two processes: ``python -m benchmarks.worker_spread``.

Twenty clients connect and stay, as sessions do: to a socket that both processes inherited and accept from, to
a socket of each process on one port (SO_REUSEPORT), and as ``pointpred serve --workers 2`` does it, where one
process accepts and hands each connection to the process that has the fewest.
"""

from __future__ import annotations

import asyncio
import socket
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager

import numpy as np

from benchmarks.machine import machine
from pages import PAGES
from pages.arguments import parse
from pages.data import Table, Tables, write
from pointpred_server.workers.dispatcher import Dispatcher

FILE = PAGES / "costs" / "spread.json"
CLIENTS = 20
PROCESSES = 2
ROUNDS = 50
GAPS_S = {"together": 0.0, "10 ms apart": 0.01}


class Process:
    """A process that connections are handed to."""

    def __init__(self, handing: socket.socket) -> None:
        self.load = 0
        self._handing = handing

    def hand(self, connection: socket.socket) -> bool:
        """Give it a connection; False where it takes none now."""
        try:
            socket.send_fds(self._handing, [b"c"], [connection.fileno()])
        except BlockingIOError:
            return False
        self.load += 1
        return True


Way = Callable[[ExitStack], tuple[int, list[Process]]]


def start(stack: ExitStack, kind: str, name: str, far: socket.socket) -> None:
    """A process of the benchmark, which names itself and takes connections from a socket."""
    command = [sys.executable, "-m", "benchmarks.worker_spread_process", kind, name, str(far.fileno())]
    process = stack.enter_context(
        subprocess.Popen(command, stdout=subprocess.PIPE, pass_fds=[far.fileno()], text=True)
    )
    stack.callback(process.kill)
    assert process.stdout is not None
    process.stdout.readline()


def bound(*, shared: bool = False, port: int = 0) -> socket.socket:
    """A listening socket on loopback."""
    opened = socket.socket()
    if shared:
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
    opened.bind(("127.0.0.1", port))
    opened.listen(socket.SOMAXCONN)
    return opened


def inherited(stack: ExitStack) -> tuple[int, list[Process]]:
    """One socket, from which every process accepts."""
    opened = stack.enter_context(bound())
    for name in "ab":
        start(stack, "accept", name, opened)
    return opened.getsockname()[1], []


def reused(stack: ExitStack) -> tuple[int, list[Process]]:
    """A socket of each process: the kernel chooses by a hash of the addresses."""
    port = 0
    for name in "ab":
        with bound(shared=True, port=port) as opened:
            port = opened.getsockname()[1]
            start(stack, "accept", name, opened)
    return port, []


def handed(stack: ExitStack) -> tuple[int, list[Process]]:
    """As the service does it."""
    processes = []
    for name in "ab":
        near, far = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
        near.setblocking(False)
        with far:
            start(stack, "receive", name, far)
        processes.append(Process(stack.enter_context(near)))
    opened = bound()
    stack.enter_context(dispatching(Dispatcher(opened, lambda: processes)))
    return opened.getsockname()[1], processes


@contextmanager
def dispatching(dispatcher: Dispatcher) -> Iterator[None]:
    """Run a dispatcher on an event loop of its own."""
    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever)
    thread.start()
    loop.call_soon_threadsafe(dispatcher.start)
    yield
    loop.call_soon_threadsafe(dispatcher.stop)
    loop.call_soon_threadsafe(loop.stop)
    thread.join()
    loop.close()


def largest(port: int, gap_s: float) -> int:
    """How many of the clients the process has that has the most."""
    with ExitStack() as stack:
        clients = []
        for _ in range(CLIENTS):
            clients.append(stack.enter_context(socket.create_connection(("127.0.0.1", port))))
            time.sleep(gap_s)
        return max(Counter(client.recv(1) for client in clients).values())


def rows(title: str, way: Way) -> Iterator[list[str]]:
    """The spread of one way, however quickly the clients come."""
    with ExitStack() as stack:
        port, processes = way(stack)
        for name, gap_s in GAPS_S.items():
            found = []
            for _ in range(ROUNDS):
                found.append(largest(port, gap_s))
                for process in processes:
                    process.load = 0  # all have left
            yield [title, name, f"{np.mean(found):.1f}", str(max(found))]


def main() -> None:
    """Measure, print, and keep the numbers."""
    where = machine(load=True)
    ways = {"one inherited socket": inherited, "SO_REUSEPORT": reused, "handed over": handed}
    found = [row for title, way in ways.items() for row in rows(title, way)]
    for row in found:
        print("  ".join(row))
    columns = ("", f"{CLIENTS} clients come", "the fuller process has, mean", "at most")
    write(Tables({"spread": Table.of(columns, found)}, where), FILE)


if __name__ == "__main__":
    parse(__doc__)
    main()
