"""The trial that a client marks: its events are kept until it ends, then scored as the scorer does."""

from __future__ import annotations

from array import array
from collections.abc import Callable

import numpy as np
from msgspec import structs

from pointpred.pipeline import Pipeline
from pointpred.protocol.client_messages import Conditions, Goal
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.scores import score_of
from pointpred.protocol.server_messages import Score
from pointpred.recording import Recording, Trial
from pointpred.recordings.trials import TRIAL_COLUMNS
from pointpred.records import EventColumns, FloatArray
from pointpred.registry import build
from pointpred.scoring import prepare, replay
from pointpred_server.sessions.target_tracker import Outcome

MOST_EVENTS = 20_000
"""A longer trial is not scored: 20 s at 1 kHz. Memory stays bounded, and scoring takes 60 ms at most."""


class TrialBuffer:
    """The events of the running trial."""

    def __init__(self) -> None:
        self.running = False
        self._names: tuple[str, ...] | None = None  # of the conditions of the session's first trial
        self._conditions: Conditions = {}
        self._forget()

    def start(self, goal: Goal | None, conditions: Conditions) -> None:
        """A trial starts; one that was running is dropped. Raises ProtocolError, nothing changed."""
        self._check(conditions)
        self._forget(goal)
        self._conditions = conditions
        self.running = True

    def described(self, conditions: Conditions) -> Conditions:
        """All that the running trial was, once its end has added these; raises ProtocolError."""
        self._check(conditions)
        known = self._conditions | conditions
        self._names = tuple(known) if self._names is None else self._names
        return known

    def _check(self, conditions: Conditions) -> None:
        """Raise ProtocolError for a name that cannot be a column of the session's recorded trials."""
        for name in conditions:
            if name in TRIAL_COLUMNS:
                sentence = f"{name!r} is a column of every table of trials; taken: {', '.join(TRIAL_COLUMNS)}"
            elif self._names is not None and name not in self._names:
                those = ", ".join(self._names) or "none"
                sentence = f"{name!r} is no condition of this session's first trial, which had: {those}"
            else:
                continue
            raise ProtocolError("bad_field", sentence, f"$.conditions.{name}", field=name)

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
