"""The threads of ``pointpred live``: one drives the session, one draws the view, the main one waits."""

from __future__ import annotations

import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

from pointpred.live.session import LiveSession

SWITCH_S = 0.0005
"""How long a thread may keep the interpreter while a report waits: drawing a view takes milliseconds."""
LOOK_S = 0.1
"""How often the main thread looks whether the end has come."""


class SessionThread:
    """Drives a session until it is stopped or fails; ``stop`` then raises the error."""

    def __init__(self, session: LiveSession, failed: Callable[[str], None] = lambda why: None) -> None:
        self.session = session
        self.stopping = threading.Event()
        self._failed = failed
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._run, name="device", daemon=True)
        self._timer: threading.Timer | None = None

    def start(self, seconds: float | None) -> None:
        """Begin; end by itself after ``seconds``, unless they are ``None`` or more than a clock can count."""
        self._thread.start()
        if seconds is not None and seconds < threading.TIMEOUT_MAX:
            self._timer = threading.Timer(seconds, self.stopping.set)
            self._timer.daemon = True
            self._timer.start()

    def stop(self) -> None:
        """End, and raise the error that ended it before."""
        self.stopping.set()
        if self._timer is not None:
            self._timer.cancel()
        self._thread.join()
        if self._error is not None:
            raise self._error

    def _run(self) -> None:
        try:
            self.session.run(self.stopping)
        except Exception as error:  # raised by stop(), on the main thread
            self._error = error
            self._failed("the session of the attached device ended with an error")
        finally:
            self.stopping.set()


class ViewThread:
    """Draws the view; an error ends the session and is kept in ``error``."""

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
        except BaseException as error:  # SystemExit too: rich raises it where a pipe was closed
            self.error = error
        finally:
            self._stopping.set()


def wait(stopping: threading.Event) -> None:
    """Wait for the end on the main thread, where Python runs the handlers of signals.

    It does not wait for the event itself: a handler may run while the event's lock is held, and it sets the
    event.
    """
    while not stopping.is_set():
        time.sleep(LOOK_S)


@contextmanager
def end_on_signal(stopping: threading.Event) -> Iterator[None]:
    """End in order at SIGTERM; threads take turns quickly meanwhile."""
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
