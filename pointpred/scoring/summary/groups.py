"""Groups of trials that a summary shows on their own."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.columns import BoolArray
from pointpred.scoring.results import SetScore

EXPERIENCE = ("experience", "skill", "group")
"""Conditions that may say who is experienced and who is a novice."""

DIVIDED = "highest speed peak less than 5 times the next"
WHOLE = "highest speed peak at least 5 times the next"
BY_SHARE = "median split of people by their share of trials with sub-movements (Khalin 2022, remark 2.3.1)"
CLEAN_OWN = "the recording's own judgement: monotone, no long stop"
CLEAN_RULE = "at least 80 px far, path at most 1.5 times that, no stop on the way over 0.1 s"


class Group(msgspec.Struct, frozen=True):
    """Trials that are shown together; ``mask`` has a row a trial of the set."""

    label: str
    mask: BoolArray
    basis: str = ""
    """The rule that puts trials into the group."""


def groups_of(score: SetScore) -> tuple[Group, ...]:
    """All trials; those with and without sub-movements; clean ones; experienced people and novices.

    A group without a trial is not listed; one with every trial is.
    """
    submovements = np.array([trial.submovements for trial in score.trials], dtype=np.bool_)
    clean = np.array([trial.clean for trial in score.trials], dtype=np.bool_)
    own = any(trial.trial.clean is not None for trial in score.trials)
    groups = [
        Group("all trials", np.ones(len(score.trials), dtype=np.bool_)),
        Group("with sub-movements", submovements, DIVIDED),
        Group("without sub-movements", ~submovements, WHOLE),
        Group("clean trials", clean, CLEAN_OWN if own else CLEAN_RULE),
        *_people(score, submovements),
    ]
    return tuple(group for group in groups if group.mask.any())


def _people(score: SetScore, submovements: BoolArray) -> list[Group]:
    """Experienced people and novices: by the recording's conditions, otherwise by their sub-movements."""
    for name in EXPERIENCE:
        labels = [str(trial.trial.condition.get(name, "")).lower() for trial in score.trials]
        if "novice" in labels and "experienced" in labels:
            return [
                Group(f"{label} people", np.array([one == label for one in labels]), f"condition {name!r}")
                for label in ("experienced", "novice")
            ]
    users, index = np.unique([trial.trial.user for trial in score.trials], return_inverse=True)
    if len(users) < 2:
        return []
    share = np.bincount(index, weights=submovements) / np.bincount(index)
    few = (share <= np.median(share))[index]
    if few.all():
        return []
    return [Group("experienced people", few, BY_SHARE), Group("novice people", ~few, BY_SHARE)]
