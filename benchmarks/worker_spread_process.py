"""A process of ``benchmarks.worker_spread``: takes connections and sends its name to each."""

from __future__ import annotations

import asyncio
import socket
import sys
from typing import Any

import uvloop


class Named(asyncio.Protocol):
    """Sends the name of its process to who connects."""

    def connection_made(self, transport: Any) -> None:
        """Send it."""
        transport.write(sys.argv[2].encode())


async def accept(listening: socket.socket) -> None:
    """Accept connections."""
    server = await asyncio.get_running_loop().create_server(Named, sock=listening)
    print("ready", flush=True)
    await server.serve_forever()


async def receive(handing: socket.socket) -> None:
    """Take connections that another process has accepted."""
    loop, opened = asyncio.get_running_loop(), set()
    handing.setblocking(False)

    def take() -> None:
        _, descriptors, _, _ = socket.recv_fds(handing, 1, 1)
        connection = socket.socket(fileno=descriptors[0])
        connection.setblocking(False)
        task = loop.create_task(loop.connect_accepted_socket(Named, connection))
        opened.add(task)

    loop.add_reader(handing, take)
    print("ready", flush=True)
    await asyncio.Event().wait()


if __name__ == "__main__":
    kind, descriptor = sys.argv[1], int(sys.argv[3])
    uvloop.run({"accept": accept, "receive": receive}[kind](socket.socket(fileno=descriptor)))
