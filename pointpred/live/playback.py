"""A recording instead of a device: its events come at the recorded times, and each trial starts afresh."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import Literal, Self

import msgspec
import numpy as np

from pointpred.devices.cursor_paths import Space
from pointpred.devices.source import ClosedOnExit, Report
from pointpred.errors import ParameterError
from pointpred.live.replay_trials import Pacing, PlayedTrial
from pointpred.pipeline import Pipeline
from pointpred.records import FloatArray, PointerEvent, Prediction

GAP_S = 0.5
"""Pause before a trial whose times begin before those of the trial before it ended."""
GAP_MOST_S = 1.0
"""A longer pause between two trials is shortened to this."""

Begin = Literal["", "trial", "person"]


class PlayedEvent(PointerEvent, frozen=True, kw_only=True):
    """An event as a session shows it, on times that grow from trial to trial, and as it was ``recorded``.

    ``begin``: the first event of a ``trial``, or of another ``person``.
    """

    recorded: PointerEvent
    begin: Begin = ""


class PlayedReport(Report, frozen=True, kw_only=True, gc=False):
    """An event on its way through a session."""

    event: PlayedEvent


class PlayedSource(ClosedOnExit):
    """A ``DeviceSource`` that plays trials one after another.

    ``speed``: 1 as recorded, 2 twice as fast, infinity without waiting. The first ``take`` that may wait
    begins, once ``hold`` returns false; ``ended`` is true when everything was taken. A trial whose
    times do not follow those before it is shown later, and computed with the times as recorded. Memory: the
    recording, and 8 bytes an event. Raises ParameterError for a speed that is not positive, or no trial.
    """

    lost = unreadable = resynchronised = 0
    plugged = True

    def __init__(
        self,
        name: str,
        path: str,
        trials: Sequence[PlayedTrial],
        *,
        speed: float = 1.0,
        words: str = "seconds",
        clock: Callable[[], float] = time.perf_counter,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        if not trials:
            raise ParameterError(f"{path}: no trial to play")
        self.name = name
        self.path = path
        self.clock = f"the recording's own: {words}"
        self.trials = len(trials)
        self.hold: Callable[[], bool] = lambda: False
        self.ended = False
        self.playing = ""
        """Which trial the newest event belongs to, and its place among all."""
        due_s, shifts_s = _timeline(trials)
        self._pacing = Pacing(due_s, speed, clock=clock, sleep=sleep)
        self._reports = _reports(trials, shifts_s)
        self._sleep = sleep

    @property
    def pace(self) -> str:
        """How many trials are played, and how fast, in words."""
        many = f"{self.trials} trials" if self.trials != 1 else "1 trial"
        speed = self._pacing.speed
        if math.isinf(speed):
            return f"{many}, without waiting"
        words = "as recorded" if speed == 1.0 else f"{speed:g} times as fast as recorded"
        return f"{many}, {words}"

    def take(self, timeout_s: float) -> list[Report]:
        """The events that are due, after waiting at most ``timeout_s`` for the next one."""
        if self.ended or (not self._pacing.begun and (timeout_s <= 0.0 or self.hold())):
            self._sleep(timeout_s)
            return []
        taken = list(islice(self._reports, len(self._pacing.take(timeout_s))))
        if taken:
            self.playing = taken[-1][0]
        self.ended = self._pacing.ended
        return [report for _, report in taken]

    def close(self) -> None:
        """Nothing is open."""


class PlayedPath:
    """A ``CursorPath`` of recorded positions."""

    space: Space = "screen"

    def __init__(self, words: str) -> None:
        self.words = words

    def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
        """The event that each report carries."""
        return [report.event for report in reports if isinstance(report, PlayedReport)]


class PlayedPipeline:
    """A stage around a pipeline that computes with the recorded times.

    It forgets the movement where a trial begins, and the person where another one does, as the scorer does.
    """

    def __init__(self, pipeline: Pipeline) -> None:
        self._pipeline = pipeline

    def update(self, event: PointerEvent, /) -> Prediction | None:
        """What the pipeline predicts, at the event's shown time; raises what the pipeline raises."""
        if not isinstance(event, PlayedEvent):
            return self._pipeline.update(event)
        if event.begin == "person":
            self._pipeline = self._pipeline.fresh()
        elif event.begin == "trial":
            self._pipeline.reset()
        one = self._pipeline.update(event.recorded)
        return one if one is None or event.t == event.recorded.t else msgspec.structs.replace(one, t=event.t)

    def reset(self) -> None:
        """Forget the movement."""
        self._pipeline.reset()

    def fresh(self) -> Self:
        """The same without any memory."""
        return type(self)(self._pipeline.fresh())


def _timeline(trials: Sequence[PlayedTrial]) -> tuple[FloatArray, list[float]]:
    """When each event is due at speed 1, and how much later than recorded each trial is shown, s."""
    due_s: list[FloatArray] = []
    shifts_s: list[float] = []
    shown_s = -math.inf
    for trial in trials:
        t, first_s = trial.events.t, float(trial.events.t[0])
        shift_s = 0.0 if first_s >= shown_s else shown_s + GAP_S - first_s
        start_s = float(due_s[-1][-1]) + min(first_s + shift_s - shown_s, GAP_MOST_S) if due_s else 0.0
        due_s.append(start_s + (t - first_s))
        shifts_s.append(shift_s)
        shown_s = float(t[-1]) + shift_s
    return np.concatenate(due_s), shifts_s


def _reports(trials: Sequence[PlayedTrial], shifts_s: Sequence[float]) -> Iterator[tuple[str, Report]]:
    """In which trial each event is, and the event."""
    user = None
    for place, (trial, shift_s) in enumerate(zip(trials, shifts_s, strict=True), 1):
        begin: Begin = "trial" if trial.about.user == user else "person"
        where = f"{trial.name}, {place} of {len(trials)}"
        for event in trial.events.events():
            yield where, _report(event, event.t + shift_s, begin)
            begin = ""
        user = trial.about.user


def _report(event: PointerEvent, shown_s: float, begin: Begin) -> PlayedReport:
    place = shown_s, event.x, event.y, event.dx, event.dy, event.buttons
    shown = PlayedEvent(*place, recorded=event, begin=begin)
    return PlayedReport(shown_s, event.dx or 0.0, event.dy or 0.0, event.buttons, event=shown)
