"""The mouse of a participant at this machine, read beside the page: its own reports, at its own rate."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Sequence

import numpy as np
from msgspec.structs import replace

from pointpred.clock import now
from pointpred.devices.cursor_paths import MotorPath
from pointpred.devices.source import DeviceSource
from pointpred.errors import ParameterError
from pointpred.live.follow import has_counts
from pointpred.live.run import SessionThread
from pointpred.live.session import LiveSession
from pointpred.recording import Provenance
from pointpred.records import EventColumns, FloatArray, Pair, PointerEvent
from pointpred.registry import build
from pointpred.studies.folder import CLOCK, FORMAT

MOST = 120_000
"""Events that are remembered: two minutes at 1 kHz."""
SAME_PAGE_S = 1e-3
"""The clocks of two pages begin further apart."""


class MouseReader:
    """Remembers the newest events of a mouse, whose positions are the hand's own path; a ``Mouse``.

    Assumes an open source, which the caller closes, and a page in a browser of this machine: the two clocks
    are brought together by the time of day, when the first movement of a page comes. Nothing is kept of a
    mouse that another clock than the monotonic one stamps. Raises ParameterError for a source without counts.
    """

    def __init__(self, source: DeviceSource, cpi: float | None, failed: Callable[[str], None]) -> None:
        """``failed`` is told, from the reader's thread, when the mouse can be read no more."""
        if not has_counts(source):
            raise ParameterError(
                f"{source.name} sends no counts: 'study run' records a mouse", field="device"
            )
        path = MotorPath(cpi)
        self.source = source
        self.kept = 0
        """Events that ``between`` gave."""
        self.origin = Provenance(FORMAT, origin=path.words, clock=CLOCK, cpi=cpi)
        self._events: deque[PointerEvent] = deque(maxlen=MOST)
        self._lock = threading.Lock()
        self._epoch, self._offset = float("-inf"), 0.0
        self._thread = SessionThread(LiveSession(source, path, build("hold"), watchers=[self._take]), failed)

    def start(self) -> None:
        """Read from now on."""
        self._thread.start(None)

    def stop(self) -> None:
        """Read no more; raises the error that ended it before."""
        self._thread.stop()

    def between(self, begin: float, end: float, epoch: float) -> FloatArray:
        """As ``Mouse`` has it."""
        if abs(epoch - self._epoch) > SAME_PAGE_S:
            self._epoch, self._offset = epoch, now().s - time.time() + epoch
        first, last = begin + self._offset, end + self._offset
        with self._lock:
            events = list(self._events) if "monotonic" in self.source.clock else []
        chosen = [replace(e, t=e.t - self._offset) for e in events if first <= e.t <= last]
        self.kept += len(chosen)
        return EventColumns.of_events(chosen).table if chosen else np.empty((0, 6))

    def _take(self, pairs: Sequence[Pair]) -> None:
        with self._lock:
            self._events.extend(event for event, _ in pairs)
