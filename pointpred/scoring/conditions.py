"""What the trials of a set have in common: the factors an analysis crosses and the groups a table splits."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec
import numpy as np

from pointpred.columns import BoolArray
from pointpred.scoring.results import ScoredTrial, SetScore

FIRST = ("distance", "width", "transfer", "ptf")
"""Factors of the thesis, tried before whatever else a recording knows; a name that begins so counts."""
OUTCOMES = ("hit", "miss", "correct", "error", "clean", "end_", "duration", "onset", "t_", "begins")
"""Conditions that begin so say how or when a trial went: what was measured is no cause of its error."""
MOST_VALUES = 12
"""A number with more values than this is a measurement and no condition, unless its name is in FIRST."""
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
    """How the trials were told apart."""


def factors_of(trials: Sequence[ScoredTrial]) -> dict[str, list[str]]:
    """Every condition that all trials know, as labels with a row a trial, the thesis's factors first.

    Outcomes and measured numbers are not among them. The target's width is a factor where no condition
    says it.
    """
    if not trials:
        return {}
    shared = set.intersection(*(set(trial.trial.condition) for trial in trials))
    shared = {name for name in shared if not name.startswith(OUTCOMES) and not _measured(name, trials)}
    found = {name: [_label(trial.trial.condition[name]) for trial in trials] for name in sorted(shared)}
    widths = [trial.trial.target_w for trial in trials]
    if not any(name.startswith("width") for name in found) and np.isfinite(widths).all():
        found["width"] = [_label(width) for width in widths]
    return {name: found[name] for name in sorted(found, key=_rank)}


def _measured(name: str, trials: Sequence[ScoredTrial]) -> bool:
    """Whether a condition is a number that hardly comes twice."""
    values = {trial.trial.condition[name] for trial in trials}
    words = any(isinstance(value, str) for value in values)
    return len(values) > MOST_VALUES and not words and not name.startswith(FIRST)


def _rank(name: str) -> tuple[int, str]:
    places = [place for place, start in enumerate(FIRST) if name.startswith(start)]
    return (places[0] if places else len(FIRST)), name


def _label(value: str | float) -> str:
    return value if isinstance(value, str) else f"{value:g}"


def groups_of(score: SetScore) -> tuple[Group, ...]:
    """All trials; those with and without sub-movements; clean ones; experienced people and novices.

    A group without a trial is not listed; one that holds every trial is, for it says so.
    """
    submovements = np.array([trial.submovements for trial in score.trials], dtype=np.bool_)
    clean = np.array([trial.clean for trial in score.trials], dtype=np.bool_)
    own = any(trial.trial.clean is not None for trial in score.trials)
    found = [
        Group("all trials", np.ones(len(score.trials), dtype=np.bool_)),
        Group("with sub-movements", submovements, DIVIDED),
        Group("without sub-movements", ~submovements, WHOLE),
        Group("clean trials", clean, CLEAN_OWN if own else CLEAN_RULE),
        *_people(score, submovements),
    ]
    return tuple(group for group in found if group.mask.any())


def _people(score: SetScore, submovements: BoolArray) -> list[Group]:
    """Experienced people and novices: as the recording says, otherwise by their sub-movements."""
    for name in EXPERIENCE:
        said = [str(trial.trial.condition.get(name, "")).lower() for trial in score.trials]
        if "novice" in said and "experienced" in said:
            return [
                Group(f"{label} people", np.array([word == label for word in said]), f"condition {name!r}")
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
