"""A session on a thread of its own, while the command line shows it or serves it."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from types import FrameType

    from pointpred.devices.sessions import LiveSession

SWITCH_S = 0.0005
"""How long a thread may hold the interpreter while a report waits: a view takes milliseconds to draw."""

LOOK_S = 0.5
"""How often a main thread that waits looks for signals: one that another thread was handed wakes nobody."""


class Following:
    """Drives a session until it is told to stop, or until something breaks, which ``stop`` then raises."""

    def __init__(self, session: LiveSession, failed: Callable[[str], None] = lambda why: None) -> None:
        self.session = session
        self.stopping = threading.Event()
        self._failed = failed
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._run, name="device", daemon=True)

    def start(self, seconds: float | None) -> None:
        """Begin; end by itself after ``seconds`` where they are given and a clock can count them."""
        self._thread.start()
        if seconds is not None and seconds < threading.TIMEOUT_MAX:
            timer = threading.Timer(seconds, self.stopping.set)
            timer.daemon = True
            timer.start()

    def stop(self) -> None:
        """End, and raise what ended it before."""
        self.stopping.set()
        self._thread.join()
        if self._error is not None:
            raise self._error

    def _run(self) -> None:
        try:
            self.session.run(self.stopping)
        except Exception as error:  # told by stop(), on the main thread
            self._error = error
            self._failed("the session of the attached device ended with an error")
        finally:
            self.stopping.set()


class Viewing:
    """A view on a thread of its own; where it breaks it ends the session, and ``error`` is what broke it."""

    def __init__(self, show: Callable[[], None], stopping: threading.Event) -> None:
        self.error: BaseException | None = None
        self._show, self._stopping = show, stopping
        self._thread = threading.Thread(target=self._run, name="view")
        self._thread.start()

    def join(self) -> None:
        """Wait for its end."""
        self._thread.join()

    def _run(self) -> None:
        try:
            self._show()
        except BaseException as error:  # SystemExit too: what becomes of a pipe that nobody reads any more
            self.error = error
        finally:
            self._stopping.set()


def until(stopping: threading.Event) -> None:
    """Wait for the end, as the main thread, in which Python's own handlers of signals run."""
    while not stopping.wait(LOOK_S):
        pass


@contextmanager
def attentive(stopping: threading.Event) -> Iterator[None]:
    """A process whose threads take turns quickly, and which ends in order when it is asked to."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(SWITCH_S)

    def end(number: int, frame: FrameType | None) -> None:
        stopping.set()

    main = threading.current_thread() is threading.main_thread()
    before = signal.signal(signal.SIGTERM, end) if main else None
    try:
        yield
    finally:
        sys.setswitchinterval(interval)
        if main:
            signal.signal(signal.SIGTERM, before or signal.SIG_DFL)
