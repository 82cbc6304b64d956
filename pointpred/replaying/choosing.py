"""Which trials of a recording are played, and why the others are left out."""

from __future__ import annotations

import difflib
from collections.abc import Sequence

import numpy as np

from pointpred.columns import EventColumns
from pointpred.errors import ParameterError
from pointpred.recording import Recording, Skip


def named(recording: Recording, k: int) -> str:
    """A trial's name among all: its user's and its own."""
    trial = recording.trials[k]
    return f"{trial.user}-{trial.trial}"


def chosen(recording: Recording, names: Sequence[str]) -> list[int]:
    """Places of trials given as USER-TRIAL or counted from 1, all where none is; raises ParameterError."""
    places = {named(recording, k): k for k in range(len(recording.trials))}
    found = []
    for name in names:
        if name in places:
            found.append(places[name])
        elif name.isdigit() and 1 <= int(name) <= len(places):
            found.append(int(name) - 1)
        else:
            near = difflib.get_close_matches(name, places, 1) or list(places)[:1]
            raise ParameterError(
                f"unknown trial {name!r}: trials are named as {near[0] if near else 'USER-TRIAL'!r} "
                f"or counted from 1 to {len(places)}"
            )
    return list(dict.fromkeys(found)) if names else list(range(len(recording.trials)))


def playable(recording: Recording, names: Sequence[str]) -> tuple[list[int], tuple[Skip, ...]]:
    """Places of the trials to play, and the trials left out; all trials where no name is given.

    Raises ParameterError for a name of no trial.
    """
    places = chosen(recording, names)
    skips = {k: skip for k in places if (skip := unplayable(recording, k)) is not None}
    left_out = (*(() if names else recording.skipped), *skips.values())
    return [k for k in places if k not in skips], left_out


def unplayable(recording: Recording, k: int) -> Skip | None:
    """Why a trial cannot be played event by event."""
    trial, events = recording.trials[k], recording.rows(k)
    reason = _fault(events)
    return None if reason is None else Skip(trial.trial, reason, user=trial.user)


def _fault(events: EventColumns) -> str | None:
    if len(events) == 0:
        return "has no events"
    wrong = np.flatnonzero(~np.isfinite(events.table[:, :3]).all(axis=1))
    if len(wrong):
        return f"event {wrong[0]} of the trial: a value is not finite"
    back = np.flatnonzero(np.diff(events.t) < 0.0)
    if len(back):
        return f"event {back[0] + 1} of the trial: time runs backwards"
    return None
