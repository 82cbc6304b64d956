"""Groups of trials that a summary shows on their own."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.records import BoolArray
from pointpred.scoring.results import SetScore
from pointpred.scoring.summary.sums import EXPERIENCE, LABELS, TrialColumns, trial_columns

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
    """The groups of a set that is in memory; see ``groups``."""
    return groups(trial_columns([score]))


def groups(trials: TrialColumns) -> tuple[Group, ...]:
    """All trials; those with and without sub-movements; clean ones; experienced people and novices.

    A group without a trial is not listed; one with every trial is.
    """
    listed = [
        Group("all trials", np.ones(len(trials.person), dtype=np.bool_)),
        Group("with sub-movements", trials.submovements, DIVIDED),
        Group("without sub-movements", ~trials.submovements, WHOLE),
        Group("clean trials", trials.clean, CLEAN_OWN if trials.judged else CLEAN_RULE),
        *_people(trials),
    ]
    return tuple(group for group in listed if group.mask.any())


def _people(trials: TrialColumns) -> list[Group]:
    """Experienced people and novices: by the recording's conditions, otherwise by their sub-movements."""
    for name, labels in zip(EXPERIENCE, trials.labels, strict=True):
        masks = [labels == place for place in range(len(LABELS))]
        if all(mask.any() for mask in masks):
            return [
                Group(f"{label} people", mask, f"condition {name!r}")
                for label, mask in zip(LABELS, masks, strict=True)
            ]
    if len(trials.people) < 2:
        return []
    share = np.bincount(trials.person, weights=trials.submovements) / np.bincount(trials.person)
    few = (share <= np.median(share))[trials.person]
    if few.all():
        return []
    return [Group("experienced people", few, BY_SHARE), Group("novice people", ~few, BY_SHARE)]
