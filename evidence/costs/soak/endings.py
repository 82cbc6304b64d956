"""When the service has ended a session: its log says so, and no file of its recording is open any more."""

from __future__ import annotations

import json
import threading
import time
from contextlib import suppress
from pathlib import Path

LATER_S = 1.0
"""After the entry in the log the recorder writes what waits."""
LOOK_S = 0.25


class Endings:
    """Reads the log of a service as it grows; one object may serve several threads."""

    def __init__(self, log: Path, pid: int) -> None:
        self._log = log
        self._descriptors = Path(f"/proc/{pid}/fd")
        self._closed: set[str] = set()
        self._at = 0
        self._lock = threading.Lock()

    def wait(self, session: str, patience_s: float) -> bool:
        """Wait until a session has ended and is on the disk; False where that takes too long."""
        until = time.monotonic() + patience_s
        while not self._is_closed(session):
            if time.monotonic() > until:
                return False
            time.sleep(LOOK_S)
        time.sleep(LATER_S)
        while any(session in name for name in self._open()):
            if time.monotonic() > until:
                return False
            time.sleep(LOOK_S)
        return True

    def _is_closed(self, session: str) -> bool:
        with self._lock:
            self._read()
            return session in self._closed

    def _read(self) -> None:
        """Take in what was logged since the last time."""
        with self._log.open("rb") as log:
            log.seek(self._at)
            whole, end, _ = log.read().rpartition(b"\n")
        self._at += len(whole) + len(end)
        entries = [json.loads(line) for line in whole.splitlines() if line.startswith(b"{")]
        self._closed |= {entry["session"] for entry in entries if "session closed" in entry["message"]}

    def _open(self) -> list[str]:
        """The files that the service holds open."""
        names = []
        for descriptor in self._descriptors.iterdir():
            with suppress(OSError):  # closed meanwhile
                names.append(str(descriptor.readlink()))
        return names
