"""Which trials of a recording are played, and why the others are left out."""

from __future__ import annotations

import difflib
from collections.abc import Sequence

import numpy as np

from pointpred.errors import ParameterError
from pointpred.recording import Recording, Skip
from pointpred.records import EventColumns


def trial_name(recording: Recording, k: int) -> str:
    """The name of a trial within its recording: that of its user, and its own."""
    trial = recording.trials[k]
    return f"{trial.user}-{trial.trial}"


def select_trials(recording: Recording, names: Sequence[str]) -> list[int]:
    """Indices of trials named as USER-TRIAL or by number from 1, or of all; raises ParameterError."""
    places = {trial_name(recording, k): k for k in range(len(recording.trials))}
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


def playable_trials(recording: Recording, names: Sequence[str]) -> tuple[list[int], tuple[Skip, ...]]:
    """Indices of the trials to play, and the skipped trials; all trials are played without names.

    Raises ParameterError for a name that no trial has.
    """
    places = select_trials(recording, names)
    skips = {k: skip for k in places if (skip := skip_of(recording, k)) is not None}
    skipped = (*(() if names else recording.skipped), *skips.values())
    return [k for k in places if k not in skips], skipped


def skip_of(recording: Recording, k: int) -> Skip | None:
    """Why a trial cannot be played event by event; ``None`` where it can."""
    trial, events = recording.trials[k], recording.rows(k)
    reason = _problem(events)
    return None if reason is None else Skip(trial.trial, reason, user=trial.user)


def _problem(events: EventColumns) -> str | None:
    if len(events) == 0:
        return "has no events"
    wrong = np.flatnonzero(~np.isfinite(events.table[:, :3]).all(axis=1))
    if len(wrong):
        return f"event {wrong[0]} of the trial: a value is not finite"
    back = np.flatnonzero(np.diff(events.t) < 0.0)
    if len(back):
        return f"event {back[0] + 1} of the trial: time runs backwards"
    return None
