"""The trial that a client marks: its events are kept until it ends, then scored as the scorer does."""

from __future__ import annotations

from array import array
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from msgspec import structs

from pointpred.columns import EventColumns, FloatArray
from pointpred.pipeline import Pipeline
from pointpred.protocol.client_messages import Goal
from pointpred.protocol.scores import score_of
from pointpred.protocol.server_messages import Score
from pointpred.recording import Recording, Trial
from pointpred.registry import build
from pointpred.scoring import prepare, replay

MOST_EVENTS = 100_000
"""A longer trial is not scored: 12 s at 8 kHz, and memory stays bounded."""


class TrialKeeper:
    """Keeps the events of the running trial."""

    def __init__(self) -> None:
        self.running = False
        self._forget()

    def start(self, goal: Goal | None) -> None:
        """A trial starts; one that was running is given up."""
        self._forget(goal)
        self.running = True

    def add(self, table: FloatArray) -> None:
        """Keep events while a trial runs."""
        if self.running:
            self._count += len(table)
            if self._count <= MOST_EVENTS:
                self._numbers.frombytes(table.tobytes())

    def end(self, goal: Goal | None, pipeline: Pipeline, cpi: float | None, dpi: float) -> Scoring:
        """What makes the trial's score; it shares nothing with what comes after, so any thread may run it."""
        goal, count, numbers = goal or self.goal, self._count, self._numbers
        self._forget()
        self.running = False
        return partial(_scored, numbers, count, goal, pipeline.fresh(), cpi, dpi)

    def _forget(self, goal: Goal | None = None) -> None:
        self._numbers = array("d")
        self._count = 0
        self.goal = goal
        """The target that the running trial was said to have."""


Scoring = Callable[[], Score]
"""Takes milliseconds, and a tenth of a second for the longest trial."""


def _scored(
    numbers: array[float], count: int, goal: Goal | None, pipeline: Pipeline, cpi: float | None, dpi: float
) -> Score:
    """A trial's score by the offline protocol, in which pipelines begin at the movement's onset."""
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


def with_account(scoring: Scoring, account: dict[str, Any]) -> Score:
    """A score, and what came of the proposals."""
    return structs.replace(scoring(), **account)
