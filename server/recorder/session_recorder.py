"""The recorder's side of a session: what a session reports here, another thread writes to disk later."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby

import msgspec
import numpy as np

from pointpred.protocol.client_messages import Goal, Hello
from pointpred.recorder.files import SessionFiles, prediction_rows, sample_rows, trial_row
from pointpred.records import EventColumns, FloatArray, PredictionColumns

NOTHING: FloatArray = np.empty((0, 6))


class Item(msgspec.Struct, frozen=True):
    """Events with their predictions, or the start or end of a trial, or the end of the session."""

    events: FloatArray = NOTHING
    predictions: FloatArray = NOTHING
    trial: str | None = None
    """The trial the events belong to, or the one that has ended."""
    predictor: str = ""
    parameters: str | None = None
    starts: bool = False
    ends: bool = False
    target: tuple[float, float, float] | None = None
    samples: int = 0
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

    def trial(self, action: str, target: Goal | None = None) -> None:
        """A trial starts, which drops one that was running, or it ends."""
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


def rows_of(user: str, items: Sequence[Item]) -> Iterator[tuple[str, bytes]]:
    """The rows to append, file by file: a trial comes after its samples."""
    with_events = [item for item in items if len(item)]
    if with_events:
        marks = [(item.trial, len(item)) for item in with_events]
        yield (
            "samples",
            sample_rows(user, merged(marks), np.concatenate([item.events for item in with_events])),
        )
    marked = [item for item in items if item.starts or item.ends]
    if marked:
        ended = [item for item in marked if item.ends]
        yield (
            "trials",
            b"".join(trial_row(user, item.trial or "", item.target, item.samples) for item in ended),
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
