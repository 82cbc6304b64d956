"""Yardsticks: ``python -m evidence.costs.load.echoes asgi|raw`` prints its port and sends everything back.

``asgi`` is an ASGI application of six lines on the uvicorn that the service runs on, with uvicorn's own
WebSocket protocol; ``raw`` has no WebSocket at all, only uvloop.
"""

from __future__ import annotations

import asyncio
import socket
from typing import Any

import uvicorn
import uvloop

from evidence.arguments import parse


async def application(scope: Any, receive: Any, send: Any) -> None:
    """Accept a WebSocket and send back what comes."""
    await receive()
    await send({"type": "websocket.accept"})
    while (message := await receive())["type"] == "websocket.receive":
        await send({**message, "type": "websocket.send"})


class Echo(asyncio.Protocol):
    """Send back what comes."""

    def connection_made(self, transport: Any) -> None:
        """Keep the connection."""
        self.transport = transport

    def data_received(self, data: bytes) -> None:
        """Send it back."""
        self.transport.write(data)


async def serve_raw(opened: socket.socket) -> None:
    """Serve until killed."""
    server = await asyncio.get_running_loop().create_server(Echo, sock=opened)
    await server.serve_forever()


def main(kind: str) -> None:
    """Listen on a free port of loopback and serve until killed."""
    opened = socket.create_server(("127.0.0.1", 0))
    print(opened.getsockname()[1], flush=True)
    if kind == "raw":
        uvloop.run(serve_raw(opened))
    else:
        config = uvicorn.Config(
            application,
            ws="websockets-sansio",
            lifespan="off",
            log_level="warning",
            ws_per_message_deflate=False,
        )
        uvicorn.Server(config).run([opened])


if __name__ == "__main__":
    main(*parse(__doc__, metavar="kind", choices=("asgi", "raw"), most=1))
