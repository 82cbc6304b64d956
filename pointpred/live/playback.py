"""A recording instead of a device: which of its trials are played, and its events at the recorded times."""

from __future__ import annotations

import difflib
import math
import time
from collections.abc import Callable, Hashable, Iterator, Sequence
from itertools import islice
from typing import Literal, Self

import msgspec
import numpy as np

from pointpred.devices.cursor_paths import PositionReport
from pointpred.devices.source import ClosedOnExit, Report
from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording, Skip, Trial
from pointpred.records import EventColumns, FloatArray, PointerEvent, Prediction

GAP_S = 0.5
"""Pause before a trial whose times begin before those of the trial before it ended."""
GAP_MOST_S = 1.0
"""A longer pause between two trials is shortened to this."""

MOST_AT_ONCE = 256
"""Most events that are handed out together."""
Begin = Literal["", "trial", "person"]


class PlayedTrial(msgspec.Struct, frozen=True):
    """A trial to play, and its events, at least one, in the order of their times."""

    about: Trial
    events: EventColumns

    @property
    def name(self) -> str:
        """Its name within the recording: that of its user, and its own."""
        return f"{self.about.user}-{self.about.trial}"


def playable_trials(recording: Recording, names: Sequence[str]) -> tuple[list[PlayedTrial], tuple[Skip, ...]]:
    """The trials to play, and the skipped trials; all trials are played without names.

    Raises ParameterError for a name that no trial has.
    """
    trials, skipped = [], [] if names else list(recording.skipped)
    for k in select_trials(recording, names):
        about, events = recording.trials[k], recording.rows(k)
        if reason := _problem(events):
            skipped.append(Skip(about.trial, reason, user=about.user))
        else:
            trials.append(PlayedTrial(about, events))
    return trials, tuple(skipped)


def select_trials(recording: Recording, names: Sequence[str]) -> list[int]:
    """Indices of trials named as USER-TRIAL or by number from 1, or of all; raises ParameterError."""
    places = {f"{trial.user}-{trial.trial}": k for k, trial in enumerate(recording.trials)}
    selected = []
    for name in names:
        if name in places:
            selected.append(places[name])
        elif name.isdigit() and 1 <= int(name) <= len(places):
            selected.append(int(name) - 1)
        else:
            near = difflib.get_close_matches(name, places, 1) or list(places)[:1]
            raise ParameterError(
                f"unknown trial {name!r}: trials are named as {near[0] if near else 'USER-TRIAL'!r} "
                f"or counted from 1 to {len(places)}",
                field="trials",
                value=name,
            )
    return list(dict.fromkeys(selected)) if names else list(range(len(recording.trials)))


def _problem(events: EventColumns) -> str:
    """Why events cannot be played one by one; empty where they can."""
    if len(events) == 0:
        return "has no events"
    wrong = np.flatnonzero(~np.isfinite(events.table[:, :3]).all(axis=1))
    if len(wrong):
        return f"event {wrong[0]} of the trial: a value is not finite"
    back = np.flatnonzero(np.diff(events.t) < 0.0)
    if len(back):
        return f"event {back[0] + 1} of the trial: time runs backwards"
    return ""


class Pacing:
    """Hands out rows when they are due: at the recorded times, faster, or as fast as they are taken.

    ``at_s``: when each row is due at speed 1, growing; ``speed`` 2 takes half the time, infinity never waits.
    The first ``take`` begins. Rows that became due while the last ones were used come together, at most
    ``most``. Raises ParameterError for a speed that is not positive.

    >>> pacing = Pacing(np.array([0.0, 0.001, 0.002]), math.inf, most=2)
    >>> pacing.take(), pacing.take(), pacing.take()
    (range(0, 2), range(2, 3), range(3, 3))
    """

    def __init__(
        self,
        at_s: FloatArray,
        speed: float = 1.0,
        *,
        most: int = MOST_AT_ONCE,
        clock: Callable[[], float] = time.perf_counter,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        if not speed > 0.0:
            raise ParameterError(f"speed must be positive, received {speed!r}")
        self.speed = speed
        self.begun = False
        self._at_s, self._most, self._clock, self._sleep = at_s, most, clock, sleep
        self._began_s, self._next = 0.0, 0

    @property
    def ended(self) -> bool:
        """Whether every row was handed out."""
        return self._next == len(self._at_s)

    def take(self, timeout_s: float = math.inf) -> range:
        """The rows that are due, after waiting at most ``timeout_s`` for the next; none after the last."""
        if not self.begun:
            self.begun, self._began_s = True, self._clock()
        first = stop = self._next
        if math.isinf(self.speed):
            stop += self._most
        elif not self.ended:
            beginning_s, next_s = float(self._at_s[0]), float(self._at_s[first])
            wait_s = self._began_s + (next_s - beginning_s) / self.speed - self._clock()
            if wait_s > 0.0:
                self._sleep(min(wait_s, timeout_s))
            passed_s = beginning_s + (self._clock() - self._began_s) * self.speed
            stop = int(np.searchsorted(self._at_s, passed_s, side="right"))
            stop = max(stop, first + (wait_s <= timeout_s))
        self._next = min(stop, first + self._most, len(self._at_s))
        return range(first, self._next)


class PlayedEvent(PointerEvent, frozen=True, kw_only=True):
    """An event as a session shows it, on times that grow from trial to trial, and as it was ``recorded``.

    ``begin``: the first event of a ``trial``, or of another ``person``.
    """

    recorded: PointerEvent
    begin: Begin = ""


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

    @property
    def shares(self) -> dict[Hashable, float]:
        """As ``Pipeline.shares``."""
        return self._pipeline.shares

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
            shown_s = event.t + shift_s
            row = shown_s, event.x, event.y, event.dx, event.dy, event.buttons
            shown = PlayedEvent(*row, recorded=event, begin=begin)
            report = PositionReport(shown_s, event.dx or 0.0, event.dy or 0.0, event.buttons, event=shown)
            yield where, report
            begin = ""
        user = trial.about.user
