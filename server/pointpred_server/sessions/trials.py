"""The trial that a client marks: its events are kept until it ends, then scored as the scorer does."""

from __future__ import annotations

from array import array
from collections.abc import Callable

import numpy as np
from msgspec import structs

from pointpred.pipeline import Pipeline
from pointpred.protocol.client_messages import Goal
from pointpred.protocol.scores import score_of
from pointpred.protocol.server_messages import Score
from pointpred.recording import Recording, Trial
from pointpred.records import EventColumns, FloatArray
from pointpred.registry import build
from pointpred.scoring import prepare, replay
from pointpred_server.sessions.target_tracker import Outcome

MOST_EVENTS = 100_000
"""A longer trial is not scored: 12 s at 8 kHz, and memory stays bounded."""


class TrialBuffer:
    """The events of the running trial."""

    def __init__(self) -> None:
        self.running = False
        self._forget()

    def start(self, goal: Goal | None) -> None:
        """A trial starts; one that was running is dropped."""
        self._forget(goal)
        self.running = True

    def add(self, table: FloatArray) -> None:
        """Add events of the trial that runs."""
        self.count += len(table)
        if self.count <= MOST_EVENTS:
            self._numbers.frombytes(table.tobytes())

    def end(
        self,
        goal: Goal | None,
        pipeline: Pipeline,
        cpi: float | None,
        dpi: float,
        outcome: Outcome | None = None,
    ) -> Callable[[], Score]:
        """What scores the trial, with how good the proposals were: it shares nothing with the session.

        That takes milliseconds, and a tenth of a second for the longest trial.
        """
        goal, count, numbers = goal or self.goal, self.count, self._numbers
        self._forget()
        self.running = False
        fresh = pipeline.fresh()

        def score() -> Score:
            found = _score(numbers, count, goal, fresh, cpi, dpi)
            return found if outcome is None else structs.replace(found, **outcome._asdict())

        return score

    def _forget(self, goal: Goal | None = None) -> None:
        self._numbers = array("d")
        self.count = 0
        """Events of the running trial."""
        self.goal = goal
        """The target of the running trial, where its start named one."""


def _score(
    numbers: array[float], count: int, goal: Goal | None, pipeline: Pipeline, cpi: float | None, dpi: float
) -> Score:
    """The score of a trial as offline, where pipelines are reset at the onset of the movement."""
    if count > MOST_EVENTS:
        return Score(count, reason=f"has {count} events, at most {MOST_EVENTS} are scored")
    about = Trial("session", "trial", *((goal.x, goal.y, goal.width) if goal else ()))
    table = np.frombuffer(numbers).reshape(-1, 6)
    recording = Recording.of("trial", [EventColumns(table)], [about])
    prepared = prepare(recording, cpi=cpi, dpi=dpi, threads=1)
    if prepared.skipped:
        return Score(count, reason=prepared.skipped[0].reason)
    errors, floor = (
        replay(prepared, each, threads=1) for each in (pipeline, build("hold", cpi=cpi, dpi=dpi))
    )
    return score_of(prepared, 0, errors, floor)
