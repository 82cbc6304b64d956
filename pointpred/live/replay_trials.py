"""A recording that is played: which of its trials, why others are left out, and when each event is due."""

from __future__ import annotations

import difflib
import math
import time
from collections.abc import Callable, Sequence

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.recording import Recording, Skip, Trial
from pointpred.records import EventColumns, FloatArray

MOST_AT_ONCE = 256
"""Most events that are handed out together."""


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
