"""The recorder's side of a session: what is said here goes to disk later, by another thread."""

from __future__ import annotations

from collections.abc import Callable

import msgspec

from pointpred.columns import EventColumns, PredictionColumns
from pointpred.protocol.client_messages import Goal, Hello
from pointpred.server.recorder.batch import Item
from pointpred.server.recorder.files import SessionFiles


class SessionRecorder:
    """What a session says to its recording; nothing here waits, and nothing here raises."""

    def __init__(self, put: Put, files: SessionFiles, hello: Hello) -> None:
        self.name = files.name
        self.files = files
        self.lost = 0
        """Events that were not recorded."""
        self.failed = False
        self.due = 0.0
        """When the files must be synced next; 0 while nothing waits for it."""
        self._put = put
        self._trials = 0
        self._running: str | None = None
        self._goal: Goal | None = None
        self._samples = 0
        self.configure(hello)

    def configure(self, hello: Hello) -> None:
        """The predictor and its parameters from now on, and what help moves the cursor."""
        self._predictor = hello.predictor
        said = {**hello.parameters, "assist": hello.assist} if hello.assist else hello.parameters
        self._parameters = msgspec.json.encode(said).decode() if said else None

    def events(self, table: EventColumns, predictions: PredictionColumns) -> None:
        """Record the events that a pipeline took in, and what it answered to each."""
        self._samples += len(table)
        item = Item(
            table.table.copy(), predictions.table.copy(), self._running, self._predictor, self._parameters
        )
        self._put(self, item)

    def trial(self, action: str, target: Goal | None = None) -> None:
        """A trial starts, giving up one that was running, or it ends."""
        if action == "start":
            self._trials += 1
            self._running, self._goal, self._samples = str(self._trials), target, 0
            self._put(self, Item(starts=True))
        elif self._running is not None:
            goal = target or self._goal
            place = (goal.x, goal.y, goal.width) if goal else None
            self._put(self, Item(trial=self._running, ends=True, target=place, samples=self._samples))
            self._running = None

    def close(self) -> None:
        """The session has ended."""
        self._put(self, Item(closes=True))


Put = Callable[[SessionRecorder, Item], None]
