"""What the summary needs to know of every trial beside its errors: whose it is, and of which groups."""

from __future__ import annotations

from collections.abc import Iterable

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.records import BoolArray
from pointpred.scoring.results import SetScore

EXPERIENCE = ("experience", "skill", "group")
"""Conditions that may say who is experienced and who is a novice."""
LABELS = ("experienced", "novice")


class TrialColumns(msgspec.Struct, frozen=True):
    """A row a trial of a set, some 20 bytes each, whatever the number of predictors."""

    people: tuple[str, ...]
    """Names of the people, sorted."""
    person: NDArray[np.int64]
    """Each trial's place in ``people``."""
    submovements: BoolArray
    clean: BoolArray
    judged: bool
    """Whether the recording itself says of any trial whether it is clean."""
    labels: NDArray[np.int8]
    """(EXPERIENCE, trials): the place in LABELS of what the condition says, -1 for anything else."""
    events: int


def trial_columns(parts: Iterable[SetScore]) -> TrialColumns:
    """The columns of a set that comes in parts, which are looked at one after the other."""
    codes: dict[str, int] = {}
    person: list[NDArray[np.int64]] = [np.empty(0, dtype=np.int64)]
    flags: list[BoolArray] = [np.empty((3, 0), dtype=np.bool_)]
    labels: list[NDArray[np.int8]] = [np.empty((len(EXPERIENCE), 0), dtype=np.int8)]
    events = 0
    for part in parts:
        trials = part.trials
        person.append(
            np.array([codes.setdefault(one.trial.user, len(codes)) for one in trials], dtype=np.int64)
        )
        rows = [(one.submovements, one.clean, one.trial.clean is not None) for one in trials]
        flags.append(np.array(rows, dtype=np.bool_).reshape(-1, 3).T)
        labels.append(
            np.array(
                [[_label(one.trial.condition.get(name)) for one in trials] for name in EXPERIENCE],
                dtype=np.int8,
            )
        )
        events += sum(one.events for one in trials)
    people = sorted(codes)
    places = np.empty(len(codes), dtype=np.int64)
    places[[codes[name] for name in people]] = np.arange(len(people))
    submovements, clean, judged = np.concatenate(flags, axis=1)
    return TrialColumns(
        tuple(people),
        places[np.concatenate(person)],
        submovements,
        clean,
        bool(judged.any()),
        np.concatenate(labels, axis=1),
        events,
    )


def _label(value: object) -> int:
    text = str(value).lower()
    return LABELS.index(text) if text in LABELS else -1
