"""Writes sessions to disk while they last, when asked to: a killed process loses little.

The event loop only queues copies of the tables; one thread turns them into rows and writes them every 0.1 s,
and syncs the files every 0.3 s, so that they survive a loss of power.
"""

from __future__ import annotations

import logging
import os
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from datetime import UTC, datetime
from itertools import groupby
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.logs import place_of
from pointpred.protocol.client_messages import Conditions, Goal, Hello, cpi_of, dpi_of
from pointpred.recorder.files import SessionFiles, Write, prediction_rows, sample_rows, trial_row, warm_rows
from pointpred.recorder.recordings import name_of, prepare
from pointpred.recording import Provenance
from pointpred.recordings.own import RECORDER
from pointpred.records import EventColumns, FloatArray, PredictionColumns

NOTHING: FloatArray = np.empty((0, 6))

WRITE_S = 0.1
SYNC_S = 0.3
MOST_WAITING = 200_000
"""Events, and as many marks of trials, that may wait to be written; more are lost, and counted. About 110 MB
with their predictions where each event came alone, 25 MB where many came together."""
CLOCK = "the client's clock, s"

log = logging.getLogger("pointpred.recorder")


class Item(msgspec.Struct, frozen=True):
    """Events with their predictions, or the start or end of a trial, or the end of the session."""

    events: FloatArray = NOTHING
    predictions: FloatArray = NOTHING
    trial: str | None = None
    """The trial the events belong to, or the one that has ended."""
    predictor: str = ""
    parameters: str | None = None
    ends: bool = False
    target: tuple[float, float, float] | None = None
    samples: int = 0
    conditions: tuple[str | float | None, ...] = ()
    closes: bool = False

    def __len__(self) -> int:
        """How many events it holds."""
        return len(self.events)


class SessionRecorder:
    """A ``SessionObserver`` whose methods neither wait nor raise."""

    def __init__(self, put: Put, files: SessionFiles, hello: Hello) -> None:
        self.name = files.name
        self.files = files
        self.lost = 0
        """Events that were not recorded."""
        self.failed = False
        self.due = 0.0
        """When the files must be synced next; 0 while nothing is unsynced."""
        self._put = put
        self._trials = 0
        self._running: str | None = None
        self._goal: Goal | None = None
        self._samples = 0
        self.configure(hello)

    def configure(self, hello: Hello) -> None:
        """The predictor, its parameters and the assistance from now on."""
        self._predictor = hello.predictor
        settings = {**hello.parameters, "assist": hello.assist} if hello.assist else hello.parameters
        self._parameters = msgspec.json.encode(settings).decode() if settings else None

    def events(self, table: EventColumns, predictions: PredictionColumns) -> None:
        """Record events and the prediction after each."""
        self._samples += len(table)
        item = Item(
            table.table.copy(), predictions.table.copy(), self._running, self._predictor, self._parameters
        )
        self._put(self, item)

    def trial(self, action: str, target: Goal | None = None, conditions: Conditions | None = None) -> None:
        """A trial starts, which drops one that was running, or it ends; ``conditions`` are read at its end.

        Those of the first trial are the columns of all.
        """
        if action == "start":
            self._trials += 1
            self._running, self._goal, self._samples = str(self._trials), target, 0
        elif self._running is not None:
            goal = target or self._goal
            place = (goal.x, goal.y, goal.width) if goal else None
            if self.files.conditions is None:
                self.files.conditions = conditions or {}
            told = tuple((conditions or {}).get(name) for name in self.files.conditions)
            item = Item(trial=self._running, ends=True, target=place, samples=self._samples, conditions=told)
            self._put(self, item)
            self._running = None

    def close(self) -> None:
        """The session has ended."""
        self._put(self, Item(closes=True))


Put = Callable[[SessionRecorder, Item], None]


def rows_of(user: str, items: Sequence[Item]) -> Iterator[tuple[str, bytes]]:
    """The rows to append, file by file: a trial comes after its samples."""
    with_events = [item for item in items if len(item)]
    if with_events:
        marks = [(item.trial, len(item)) for item in with_events]
        yield (
            "samples",
            sample_rows(user, merged(marks), np.concatenate([item.events for item in with_events])),
        )
    ended = [item for item in items if item.ends]
    if ended:  # not before: the first that ends says what the columns are
        yield (
            "trials",
            b"".join(
                trial_row(user, item.trial or "", item.target, item.samples, item.conditions)
                for item in ended
            ),
        )
    if with_events:
        predictors = merged([(item.predictor, len(item)) for item in with_events])
        parameters = merged([(item.parameters, len(item)) for item in with_events])
        table = np.concatenate([item.predictions for item in with_events])
        yield "predictions", prediction_rows(predictors, parameters, table)


def merged(words: Sequence[tuple[str | None, int]]) -> list[tuple[str | None, int]]:
    """Runs of the same word as one.

    >>> merged([("a", 2), ("a", 1), (None, 4)])
    [('a', 3), (None, 4)]
    """
    return [
        (word, sum(count for _, count in run)) for word, run in groupby(words, key=lambda entry: entry[0])
    ]


class Recorder:
    """Writes sessions into a folder from its own thread; raises SourceError where it cannot.

    ``waiting_most`` bounds the events that wait in memory. ``write`` is for tests of full disks.
    """

    def __init__(
        self,
        folder: Path,
        *,
        waiting_most: int = MOST_WAITING,
        write: Write = os.write,
        today: Callable[[], datetime] = lambda: datetime.now(UTC),
    ) -> None:
        self.folder = folder
        self.lost = 0
        """Events and ends of trials of all sessions that are in no file."""
        self.failures = 0
        """Sessions whose recording stopped because of an error."""
        self.waiting = 0
        """Events that wait to be written."""
        self._marks = 0  # marks of trials that wait
        self._most = waiting_most
        self._write = write
        self._today = today
        self._lock = threading.Lock()
        self._items: list[tuple[SessionRecorder, Item]] = []
        self._open: set[SessionRecorder] = set()
        self._dirty: list[SessionRecorder] = []
        self._wake = threading.Event()
        self._stopping = threading.Event()
        if prepare(folder):
            log.warning("others on this machine can look into %s; its files are for its owner only", folder)
        warm_rows()
        self._thread = threading.Thread(target=self._run, name="recorder", daemon=True)
        self._thread.start()

    def open(self, session: str, hello: Hello) -> SessionRecorder | None:
        """A recording of a session, ``None`` once the recorder has been closed; no file is made yet."""
        if self._stopping.is_set():
            return None
        begun = self._today()
        name = name_of(session, begun)
        origin = Provenance(
            RECORDER, origin="as the client says", clock=CLOCK, dpi=dpi_of(hello), cpi=cpi_of(hello)
        )
        return self.record(SessionFiles(self.folder, name, about_of(origin, begun), self._write), hello)

    def record(self, files: SessionFiles, hello: Hello) -> SessionRecorder:
        """A recording into the caller's files."""
        return SessionRecorder(self._put, files, hello)

    def _put(self, session: SessionRecorder, item: Item) -> None:
        """Queue something for the thread; events beyond the bound are lost and counted."""
        count, mark = len(item), item.ends
        with self._lock:
            full = self.waiting + count > self._most or (mark and self._marks >= self._most)
            over = session.failed or self._stopping.is_set()
            if ((count or mark) and over) or (full and not item.closes):
                session.lost += count + item.ends
                self.lost += count + item.ends
                return
            self._marks += mark
            first = not self._items
            self._items.append((session, item))
            self.waiting += count
        if first:
            self._wake.set()

    def close(self, timeout_s: float = 5.0) -> bool:
        """Write what waits and stop; False where that took longer than ``timeout_s``."""
        self._stopping.set()
        self._wake.set()
        self._thread.join(timeout_s)
        done = not self._thread.is_alive()
        if not done:
            log.error("the recorder could not write everything within %g s", timeout_s)
        return done

    def _run(self) -> None:
        while True:
            self._wake.wait(WRITE_S if self._dirty else None)
            self._stopping.wait(WRITE_S)  # what comes meanwhile is written together
            stopping = self._stopping.is_set()
            self._wake.clear()
            self._write_waiting()
            self._sync()
            if stopping and not self._items:
                for session in list(self._open):
                    self._finish(session)
                return

    def _write_waiting(self) -> None:
        with self._lock:
            items, self._items = self._items, []
        grouped: dict[SessionRecorder, list[Item]] = {}
        for session, item in items:
            grouped.setdefault(session, []).append(item)
        for session, own in grouped.items():
            self._write_session(session, own)
        with self._lock:
            self.waiting -= sum(len(item) for _, item in items)
            self._marks -= sum(item.ends for _, item in items)

    def _write_session(self, session: SessionRecorder, items: list[Item]) -> None:
        left = {"samples": sum(len(item) for item in items), "trials": sum(item.ends for item in items)}
        before = session.files.rows
        try:
            if not session.failed:
                self._open.add(session)
                for part, rows in rows_of(session.name, items):
                    session.files.append(part, rows)
                    before, left[part] = session.files.rows, 0
                if not session.due:
                    session.due = time.monotonic() + SYNC_S
                    self._dirty.append(session)
        except Exception as error:  # the service goes on without this recording, whatever broke
            self._fail(session, error)
        lost = max(0, sum(left.values()) - (session.files.rows - before))
        with self._lock:
            session.lost += lost
            self.lost += lost
        if items[-1].closes:
            self._finish(session)

    def _sync(self) -> None:
        """Sync what is due, the oldest first, for no longer than until the next rows must be written."""
        until = time.monotonic() + WRITE_S
        while self._dirty:
            session, now = self._dirty[0], time.monotonic()
            if session.due > now or now > until:
                return
            self._dirty.pop(0)
            session.due = 0.0
            try:
                session.files.sync()
            except OSError as error:
                self._fail(session, error)

    def _finish(self, session: SessionRecorder) -> None:
        """Close the files of a session that has ended; all of it is then on the disk."""
        if session in self._dirty:
            self._dirty.remove(session)
        try:
            if not session.failed:
                session.files.sync()
            session.files.close()
        except OSError as error:
            self._fail(session, error)
        self._open.discard(session)
        if session.lost:
            log.warning("recording %s: %d events and ends of trials were lost", session.name, session.lost)

    def _fail(self, session: SessionRecorder, error: Exception) -> None:
        """Stop the recording of a session, and log that once; the session itself goes on."""
        with self._lock:
            session.failed = True
            self.failures += 1
        # The sentence of an OSError is about files; that of another error might quote an event.
        reason = error if isinstance(error, OSError) else place_of(error)
        log.error("recording %s stopped: %s", session.name, reason)
        if session in self._dirty:
            self._dirty.remove(session)
        try:
            session.files.close()
        except OSError as again:
            log.error("recording %s: closing its files failed as well: %s", session.name, again)


def about_of(origin: Provenance, begun: datetime) -> dict[str, Any]:
    """The header of a recording."""
    return {"provenance": msgspec.to_builtins(origin), "begun": begun.isoformat(timespec="seconds")}
