"""A recording instead of a device: its events come at the recorded times, and each trial starts afresh."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Sequence
from typing import Literal, Self

import msgspec

from pointpred.devices.cursor_paths import Space
from pointpred.devices.source import ClosedOnExit, Report
from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.records import EventColumns, PointerEvent, Prediction

GAP_S = 0.5
"""Pause before a trial whose times begin before those of the trial before it ended."""
GAP_MOST_S = 1.0
"""A longer pause between two trials is shortened to this."""
MOST_AT_ONCE = 256
"""Events handed out together where no pace is kept."""

Begin = Literal["", "trial", "person"]
Sample = tuple[float, ...]
"""A row of ``Accelerations.table``."""


class PlayedTrial(msgspec.Struct, frozen=True):
    """A trial to play: whose it is, its name, and its events, at least one, in the order of their times."""

    user: str
    name: str
    events: EventColumns


class PlayedEvent(PointerEvent, frozen=True, kw_only=True):
    """An event as a session shows it, on times that grow from trial to trial, and as it was ``recorded``.

    ``begin``: the first event of a ``trial``, or of another ``person``. ``samples``: those of an
    accelerometer (s, m/s^2) that came before it, on the recorded times.
    """

    recorded: PointerEvent
    begin: Begin = ""
    samples: tuple[Sample, ...] = ()


class PlayedReport(Report, frozen=True, kw_only=True, gc=False):
    """An event on its way through a session."""

    event: PlayedEvent


class PlayedSource(ClosedOnExit):
    """A ``DeviceSource`` that plays trials one after another.

    ``speed``: 1 as recorded, 2 twice as fast, infinity without waiting. The first ``take`` that may wait
    begins, once ``hold`` returns false; ``ended`` is true when everything was taken. A trial whose
    times do not follow those before it is shown later, and computed with the times as recorded. Memory: the
    recording and one event ahead. Raises ParameterError for a speed that is not positive, or no trial.
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
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        if not speed > 0.0:
            raise ParameterError(f"speed must be a positive number, received {speed!r}")
        if not trials:
            raise ParameterError(f"{path}: no trial to play")
        self.name = name
        self.path = path
        self.clock = f"the recording's own: {words}"
        self.trials = len(trials)
        self.speed = speed
        self.hold: Callable[[], bool] = lambda: False
        self.ended = False
        self.playing = ""
        """Which trial the newest event belongs to, and its place among all."""
        self._clock, self._sleep = clock, sleep
        self._schedule = _schedule(trials)
        self._next = next(self._schedule, None)
        self._began: float | None = None

    @property
    def pace(self) -> str:
        """How many trials are played, and how fast, in words."""
        many = f"{self.trials} trials" if self.trials != 1 else "1 trial"
        if math.isinf(self.speed):
            return f"{many}, without waiting"
        speed = "as recorded" if self.speed == 1.0 else f"{self.speed:g} times as fast as recorded"
        return f"{many}, {speed}"

    def take(self, timeout_s: float) -> list[Report]:
        """The events that are due, after waiting at most ``timeout_s`` for the next one."""
        if self._began is None and (timeout_s <= 0.0 or self.hold()):
            self._sleep(timeout_s)
            return []
        if self._began is None:
            self._began = self._clock()
        if self._next is None:
            self._sleep(timeout_s)
            return []
        if (wait_s := self._wait_s(self._next[0])) > 0.0:
            self._sleep(min(wait_s, timeout_s))
        taken: list[Report] = []
        while self._next is not None and len(taken) < MOST_AT_ONCE and self._wait_s(self._next[0]) <= 0.0:
            _, self.playing, report = self._next
            taken.append(report)
            self._next = next(self._schedule, None)
        self.ended = self._next is None
        return taken

    def close(self) -> None:
        """Nothing is open."""

    def _wait_s(self, at_s: float) -> float:
        """How long until what is due ``at_s`` after the beginning, at speed 1."""
        if math.isinf(self.speed):
            return 0.0
        assert self._began is not None
        return self._began + at_s / self.speed - self._clock()


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
    The samples of an accelerometer go to the pipeline before the event that they came before.
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
        for sample in event.samples:
            self._pipeline.sense(*sample)
        one = self._pipeline.update(event.recorded)
        return one if one is None or event.t == event.recorded.t else msgspec.structs.replace(one, t=event.t)

    def reset(self) -> None:
        """Forget the movement."""
        self._pipeline.reset()

    def fresh(self) -> Self:
        """The same without any memory."""
        return type(self)(self._pipeline.fresh())


def _schedule(trials: Sequence[PlayedTrial]) -> Iterator[tuple[float, str, Report]]:
    """When each event is due, s after the beginning at speed 1; in which trial; and the event."""
    due_s, shown_s, user = 0.0, -math.inf, None
    for place, trial in enumerate(trials, 1):
        first_s = float(trial.events.t[0])
        shift_s = 0.0 if first_s >= shown_s else shown_s + GAP_S - first_s
        start_s = due_s if place == 1 else due_s + min(first_s + shift_s - shown_s, GAP_MOST_S)
        begin: Begin = "trial" if trial.user == user else "person"
        where = f"{trial.name}, {place} of {len(trials)}"
        beside = trial.events.accelerations
        taken = 0
        for event, before in zip(trial.events.events(), beside.before.tolist(), strict=True):
            shown_s, due_s = event.t + shift_s, start_s + (event.t - first_s)
            samples = tuple(map(tuple, beside.table[taken:before].tolist()))
            yield due_s, where, _report(event, shown_s, begin, samples)
            begin, taken = "", before
        user = trial.user


def _report(event: PointerEvent, shown_s: float, begin: Begin, samples: tuple[Sample, ...]) -> PlayedReport:
    place = shown_s, event.x, event.y, event.dx, event.dy, event.buttons
    shown = PlayedEvent(*place, recorded=event, begin=begin, samples=samples)
    return PlayedReport(shown_s, event.dx or 0.0, event.dy or 0.0, event.buttons, event=shown)
