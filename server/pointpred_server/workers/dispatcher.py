"""Accepts connections and hands each to the worker that has the fewest.

A session lasts long: where the workers accept for themselves, one of them soon has many more than another,
and a worker that is held up would still be given its share.
"""

from __future__ import annotations

import asyncio
import errno
import logging
import socket
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Protocol

RETRY_S = 0.005
"""Pause while no worker takes a connection: it waits, and further ones wait in the kernel."""
NO_FILES_S = 0.5
"""Pause where this process may open no further file."""
AT_ONCE = 64
"""Connections accepted before other work has its turn."""

log = logging.getLogger("pointpred.service")


class Taker(Protocol):
    """What connections are handed to."""

    @property
    def load(self) -> int:
        """Connections that it has."""

    def hand(self, connection: socket.socket) -> bool:
        """Give it a connection; False where it takes none now."""


class Dispatcher:
    """Runs on the event loop from ``start`` to ``stop``; ``takers`` names those that may be given one."""

    def __init__(self, listening: socket.socket, takers: Callable[[], Sequence[Taker]]) -> None:
        self._listening = listening
        self._takers = takers
        self._waiting: socket.socket | None = None  # accepted, and taken by nobody yet
        self._pause: asyncio.TimerHandle | None = None
        self._turn = 0  # among equals each has its turn

    def start(self) -> None:
        """Accept from now on."""
        self._listening.setblocking(False)
        asyncio.get_running_loop().add_reader(self._listening, self._accept)

    def stop(self) -> None:
        """Refuse further connections."""
        asyncio.get_running_loop().remove_reader(self._listening)
        if self._pause is not None:
            self._pause.cancel()
        if self._waiting is not None:
            self._waiting.close()
        self._listening.close()

    def _accept(self) -> None:
        for _ in range(AT_ONCE):
            try:
                connection = self._waiting or self._listening.accept()[0]
            except (BlockingIOError, InterruptedError, ConnectionAbortedError):
                return
            except OSError as error:
                if error.errno not in (errno.EMFILE, errno.ENFILE, errno.ENOBUFS, errno.ENOMEM):
                    raise
                log.error("no connection can be accepted: %s", error.strerror)
                self._wait(NO_FILES_S)
                return
            if not self._hand(connection):
                self._waiting = connection
                self._wait(RETRY_S)
                return
            self._waiting = None
            connection.close()  # the worker has its own descriptor of it

    def _hand(self, connection: socket.socket) -> bool:
        takers = self._takers()
        if not takers:
            return False
        self._turn = (self._turn + 1) % len(takers)
        in_turn = [*takers[self._turn :], *takers[: self._turn]]
        return any(taker.hand(connection) for taker in sorted(in_turn, key=lambda taker: taker.load))

    def _wait(self, seconds: float) -> None:
        loop = asyncio.get_running_loop()
        loop.remove_reader(self._listening)
        self._pause = loop.call_later(seconds, self._go_on)

    def _go_on(self) -> None:
        self._pause = None
        with suppress(ValueError):  # closed meanwhile
            asyncio.get_running_loop().add_reader(self._listening, self._accept)
        self._accept()
