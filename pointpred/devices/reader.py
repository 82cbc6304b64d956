"""A source that reads its device on a thread of its own."""

from __future__ import annotations

import threading
from abc import abstractmethod

from pointpred.devices.source import BoundedQueue, ClosedOnExit, Report
from pointpred.errors import SourceError


class ReaderSource(ClosedOnExit):
    """Reads on its own thread into a bounded queue; what ends the thread is raised by ``take``.

    A kind of source adds ``_read_all``, which reads until the source is closed, and ``_close_device``, which
    the thread calls last. ``path`` is where the device is; ``_described`` is what errors call it.
    """

    path: str

    def __init__(self, most: int) -> None:
        self._queue = BoundedQueue(most)
        self._stopping = threading.Event()
        self._thread: threading.Thread | None = None

    @property
    def lost(self) -> int:
        """Reports dropped because nobody took them in time."""
        return self._queue.lost

    def take(self, timeout_s: float) -> list[Report]:
        """Everything that came since the last call; waits at most ``timeout_s`` until something came."""
        if self._thread is None:
            raise SourceError(f"{self._described}: not open; use it in a 'with' statement")
        return self._queue.take(timeout_s)

    def close(self) -> None:
        """Stop reading; may be called twice. What was read can still be taken."""
        self._stopping.set()
        if self._thread is not None:
            self._thread.join()
        self._queue.close()

    @property
    def _described(self) -> str:
        return self.path or "this source"

    def _check_unused(self) -> None:
        """Raise SourceError if the source was opened before."""
        if self._thread is not None:
            raise SourceError(f"{self._described}: this source is open already; make another")

    def _start(self) -> None:
        self._thread = threading.Thread(target=self._run, name=f"reader of {self.path}", daemon=True)
        self._thread.start()

    def _run(self) -> None:
        failure = None
        try:
            self._read_all()
        except SourceError as error:
            failure = error
        except Exception as error:  # raised by take, as an error on this thread would go unnoticed
            failure = SourceError(f"{self._described}: reading ended: {error}")
            failure.__cause__ = error
        finally:
            self._close_device()
            self._queue.close(failure)

    @abstractmethod
    def _read_all(self) -> None:
        """Read until the source is closed; raises what ends it before."""

    @abstractmethod
    def _close_device(self) -> None:
        """Close what was read."""
