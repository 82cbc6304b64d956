"""What a process of clients reports, a line of JSON a second: a histogram of delays, counts, errors."""

from __future__ import annotations

import json
import math
import sys
import threading
import time
from collections import Counter
from contextlib import suppress
from pathlib import Path

import msgspec
import numpy as np

from evidence.costs.soak.client import StreamClient
from evidence.costs.soak.offline import difference, paths

SHORTEST_S, RATIO = 1e-5, 1.01
"""The bins of delays: each ends 1 % above the one before."""
LATER_S = 1.0
"""After the entry in the log the recorder writes what waits."""
LOOK_S = 0.25
PATIENCE_S = 120.0
"""A session that its client has left is on the disk within this time."""


class Plan(msgspec.Struct):
    """Where the service is, and where what the clients sent is kept until it is compared."""

    port: int
    pid: int
    log: str
    scratch: str
    recordings: str
    seed: int = 1


class Report(msgspec.Struct):
    """What happened since the last one."""

    delays: dict[int, int] = {}
    counts: dict[str, int] = {}
    wrong: list[str] = []


def bin_of(delay_s: float) -> int:
    """The bin of a delay."""
    return max(0, math.ceil(math.log(max(delay_s, SHORTEST_S) / SHORTEST_S) / math.log(RATIO)))


def delay_of(number: int) -> float:
    """The upper end of a bin, s."""
    return SHORTEST_S * RATIO**number


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


class Reporter:
    """Collects what the clients of one process do, and writes it to stdout."""

    def __init__(self, plan: Plan) -> None:
        self._folder = Path(plan.recordings)
        self._endings = Endings(Path(plan.log), plan.pid)
        self.counts: Counter[str] = Counter()
        self.wrong: list[str] = []
        self._delays: Counter[int] = Counter()
        self._lock = threading.Lock()
        self.stopping = threading.Event()
        """Set when the soak has closed our stdin."""
        threading.Thread(target=self._watch, daemon=True).start()

    def _watch(self) -> None:
        sys.stdin.read()
        self.stopping.set()

    def add_delays(self, delays: np.ndarray) -> None:
        """Count delays of answers to events."""
        self._delays.update(bin_of(delay) for delay in delays.tolist())

    def write(self) -> None:
        """Write what has come together since the last line."""
        with self._lock:
            line = msgspec.json.encode(Report(dict(self._delays), dict(self.counts), self.wrong))
            self._delays.clear()
            self.counts.clear()
            self.wrong.clear()
        sys.stdout.write(line.decode() + "\n")
        sys.stdout.flush()

    def conclude(self, client: StreamClient, *, whole: bool) -> None:
        """Compare what was answered and recorded of a session that its client has left; blocks.

        ``whole``: the client left as it should, so every event is answered and recorded.
        """
        client.run.close()
        wrong = client.run.wrong + client.errors
        if whole and not client.run.complete:
            wrong.append(f"{client.session}: its last events were not answered")
        if client.session:
            if not self._endings.wait(client.session, PATIENCE_S):
                wrong.append(f"{client.session}: the service has not ended it after {PATIENCE_S:g} s")
            elif message := difference(self._folder, client.session, client.run.file, whole=whole):
                wrong.append(message)
        counts = Counter({"events sent": client.run.events, "predictions compared": client.run.answers})
        counts["sessions compared" if client.session else "sessions without a welcome"] = 1
        if not wrong:
            counts.update(_forget(client, self._folder))
        with self._lock:
            self.wrong += wrong
            self.counts.update(counts)


def _forget(client: StreamClient, folder: Path) -> Counter[str]:
    """Remove the files of a session in which everything was right, and count their bytes.

    An hour of them would take gigabytes.
    """
    bytes_of: Counter[str] = Counter()
    for file in (client.run.file, *paths(client.run.file)):
        file.unlink()
    for file in folder.glob(f"*-{client.session}_*.csv") if client.session else ():
        bytes_of[f"bytes of {file.stem.rpartition('_')[2]}"] += file.stat().st_size
        file.unlink()
    return bytes_of
