"""What every live device has in common: its description, reports with times, a queue, a reading thread."""

from __future__ import annotations

import threading
import time
from abc import ABC, abstractmethod
from collections import deque
from contextlib import suppress
from queue import Empty, SimpleQueue
from types import TracebackType
from typing import Literal, Protocol, Self

import msgspec

from pointpred.devices.surface import Place, Surface
from pointpred.errors import ParameterError, SourceError

MOST_WAITING = 65536
"""Reports that a queue holds by default: eight seconds of the fastest mice."""
BROWSER = (
    "run 'pointpred serve' and use a browser: its page reads the pointer, and docs/guide/browser.md names "
    "the browser client for pages of your own"
)
"""What to do where no device can be read."""
BUTTON_NAMES = {1: "left", 2: "right", 4: "middle", 8: "back", 16: "forward"}
"""Bits of ``PointerEvent.buttons``, and their names, which are those of the DevTools protocol."""


class Report(msgspec.Struct, frozen=True, gc=False):
    """One report of a device: counts since the report before; a ``PlaceReport`` has a position.

    ``t`` s on the clock the source names; ``dx dy`` counts, y downwards; ``buttons`` pressed after it, as in
    ``PointerEvent``; ``wheel`` steps away from the hand, ``pan`` steps of a horizontal wheel to the right.
    """

    t: float
    dx: float
    dy: float
    buttons: int = 0
    wheel: float = 0
    pan: float = 0


class PlaceReport(Report, frozen=True, kw_only=True, gc=False):
    """Where on its ``surface`` an absolute device is; ``dx dy`` say in its own units that it moved."""

    place: Place
    surface: Surface


class PlaceReports:
    """Makes the reports of a surface's places, with the way since the place before."""

    def __init__(self, surface: Surface) -> None:
        self.surface = surface
        self._last: Place | None = None

    def report(self, t: float, place: Place, wheel: float = 0, pan: float = 0) -> PlaceReport:
        """The report of a place at ``t`` s."""
        (x, y), last = (self.surface.x, self.surface.y), self._last or place
        dx, dy = (place.x - last.x) * (x.most - x.least), (place.y - last.y) * (y.most - y.least)
        self._last = place
        return PlaceReport(t, dx, dy, place.buttons, wheel, pan, place=place, surface=self.surface)


class DeviceInfo(msgspec.Struct, frozen=True):
    """A device of this machine; where it cannot be opened, ``why``, and ``advice`` on what to do next."""

    path: str
    name: str
    kind: Literal["hid", "evdev", "cursor"]
    openable: bool
    why: str | None = None
    advice: str | None = None


class BoundedQueue:
    """Reports passed from one reader thread to one consumer; when full, the oldest is dropped.

    ``put`` never blocks and what it drops is counted in ``lost``. Holds at most ``most`` reports.
    Raises ParameterError when ``most`` is below 1.

    The consumer takes no lock: Ctrl-C may raise KeyboardInterrupt at any point of ``take``, and a lock left
    behind would block the reader for ever.

    >>> queue = BoundedQueue(2)
    >>> for t in (0.0, 0.1, 0.2):
    ...     queue.put(Report(t, 1, 0))
    >>> [report.t for report in queue.take(0.0)], queue.lost
    ([0.1, 0.2], 1)
    """

    def __init__(self, most: int = MOST_WAITING) -> None:
        if most < 1:
            raise ParameterError(f"a queue of at most {most} reports, expected at least 1")
        self.lost = 0
        self._most = most
        self._waiting: deque[Report] = deque()
        self._wake: SimpleQueue[None] = SimpleQueue()
        self._closed = False
        self._failure: SourceError | None = None

    def put(self, report: Report) -> None:
        """Append one report; where there is no room, the oldest is dropped and counted."""
        if len(self._waiting) >= self._most:
            with suppress(IndexError):  # the consumer has just taken all
                self._waiting.popleft()
                self.lost += 1
        self._waiting.append(report)
        if self._wake.empty():
            self._wake.put(None)

    def take(self, timeout_s: float) -> list[Report]:
        """Everything that waits, in order; waits at most ``timeout_s`` until there is something.

        Raises the failure that closed the queue once nothing waits any more.
        """
        until = time.monotonic() + timeout_s
        while not self._waiting and not self._closed and (left := until - time.monotonic()) > 0:
            with suppress(Empty):
                self._wake.get(timeout=left)
        closed = self._closed  # read first: what was put before the end is taken
        taken: list[Report] = []
        with suppress(IndexError):  # the reader may drop one meanwhile
            taken.extend(self._waiting.popleft() for _ in range(len(self._waiting)))
        if closed and not taken and self._failure is not None:
            raise self._failure
        return taken

    def close(self, failure: SourceError | None = None) -> None:
        """Wake the consumer: no more reports will come, because of ``failure`` if not ``None``.

        What waits can still be taken.
        """
        self._failure = self._failure or failure
        self._closed = True
        self._wake.put(None)


class ClosedOnExit(ABC):
    """A context manager that is its own target and is closed at the end."""

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    @abstractmethod
    def close(self) -> None:
        """Stop; may be called twice."""


class DeviceSource(Protocol):
    """A device being read: entering opens it and starts its reader thread, leaving closes it.

    Entering raises SourceError that says what to do next. While unplugged (``plugged`` is false) it waits for
    the same device to come back and goes on. ``lost`` counts reports dropped because the queue was full,
    ``unreadable`` reports that could not be decoded, ``resynchronised`` recoveries after the kernel dropped
    events. ``clock`` says which clock stamps the reports and where.
    """

    @property
    def name(self) -> str:
        """What the device calls itself."""

    @property
    def clock(self) -> str:
        """Which clock stamps the reports, and when."""

    @property
    def path(self) -> str:
        """Where it is open, or was last."""

    @property
    def lost(self) -> int:
        """Reports dropped because they were not taken in time."""

    @property
    def unreadable(self) -> int:
        """Reports that could not be decoded."""

    @property
    def resynchronised(self) -> int:
        """Recoveries after the kernel had dropped events."""

    @property
    def plugged(self) -> bool:
        """Whether the device is there now."""

    def take(self, timeout_s: float) -> list[Report]:
        """Everything that came since the last call; waits at most ``timeout_s`` until something came."""

    def close(self) -> None:
        """Stop reading; may be called twice."""

    def __enter__(self) -> Self: ...

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None: ...


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
