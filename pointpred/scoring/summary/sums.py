"""Sums over the trials of each person and group, from which every number of a summary is made.

Trials are added one by one in the set's order. The sums are therefore the same bits however the set was cut
into parts, and memory does not grow with the number of trials.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from math import prod
from sys import intern

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.records import BoolArray, BoolTable, FloatArray, FloatTable, IntArray
from pointpred.scoring.measures import regions, time_left
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.results import (
    AXIS_FRACTIONS,
    PATH_FRACTIONS,
    TIME_FRACTIONS,
    PredictorErrors,
    SetScore,
)
from pointpred.scoring.selection import known_of, label, levels_of
from pointpred.stage import offsets

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
    repeats: tuple[float, float] = (0.0, 0.0)
    """Shares of trials whose end, and whose distance, repeats an earlier one of the person."""
    by: dict[str, tuple[str, ...]] = {}
    """Of each column whose levels are groups: the level of each trial."""


def trial_columns(parts: Iterable[SetScore], by: Sequence[str] = ()) -> TrialColumns:
    """The columns of a set that comes in parts, which are looked at one after the other."""
    levels: dict[str, list[str]] = {name: [] for name in by}
    codes: dict[str, int] = {}
    person: list[NDArray[np.int64]] = [np.empty(0, dtype=np.int64)]
    flags: list[BoolArray] = [np.empty((5, 0), dtype=np.bool_)]
    labels: list[NDArray[np.int8]] = [np.empty((len(EXPERIENCE), 0), dtype=np.int8)]
    events = 0
    for part in parts:
        trials = part.trials
        person.append(
            np.array([codes.setdefault(one.trial.user, len(codes)) for one in trials], dtype=np.int64)
        )
        rows = [
            (one.submovements, one.clean, one.trial.clean is not None, one.end_repeats, one.distance_repeats)
            for one in trials
        ]
        flags.append(np.array(rows, dtype=np.bool_).reshape(-1, 5).T)
        labels.append(
            np.array(
                [[_label(one.trial.condition.get(name)) for one in trials] for name in EXPERIENCE],
                dtype=np.int8,
            )
        )
        events += sum(one.events for one in trials)
        for one in map(known_of, trials) if by else ():
            for name in by:
                levels[name].append(label(one.get(name)))
    people = sorted(codes)
    places = np.empty(len(codes), dtype=np.int64)
    places[[codes[name] for name in people]] = np.arange(len(people))
    submovements, clean, judged, *again = np.concatenate(flags, axis=1)
    ends, distances = (float(one.mean()) if len(one) else 0.0 for one in again)
    return TrialColumns(
        tuple(people),
        places[np.concatenate(person)],
        submovements,
        clean,
        bool(judged.any()),
        np.concatenate(labels, axis=1),
        events,
        (ends, distances),
        {name: tuple(map(intern, column)) for name, column in levels.items()},
    )


def _label(value: object) -> int:
    text = str(value).lower()
    return LABELS.index(text) if text in LABELS else -1


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
    column: str = ""
    level: str = ""
    """Where the group is a level of a column."""

    @property
    def key(self) -> str:
        """What the group is called in the document."""
        return self.label if self.column else self.label.replace("-", "").replace(" ", "_")


def groups_of(score: SetScore) -> tuple[Group, ...]:
    """The groups of a set that is in memory; see ``groups``."""
    return groups(trial_columns([score]))


def groups(trials: TrialColumns) -> tuple[Group, ...]:
    """All trials; with and without sub-movements; clean ones; experienced people and novices; levels.

    A group without a trial is not listed; one with every trial is.
    """
    listed = [
        Group("all trials", np.ones(len(trials.person), dtype=np.bool_)),
        Group("with sub-movements", trials.submovements, DIVIDED),
        Group("without sub-movements", ~trials.submovements, WHOLE),
        Group("clean trials", trials.clean, CLEAN_OWN if trials.judged else CLEAN_RULE),
        *_people(trials),
        *(group for name, levels in trials.by.items() for group in _levels(name, levels)),
    ]
    return tuple(group for group in listed if group.mask.any())


def _levels(name: str, column: Sequence[str]) -> Iterator[Group]:
    """A group a level of a column."""
    cells = np.array(column, dtype=object)
    for level in levels_of(name, column):
        yield Group(f"{name} = {level}", cells == level, f"--by {name}", name, level)


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


Parts = Callable[[], Iterable[SetScore]]
"""Gives a set's parts in order, each time from the first one on."""

LEVELS = len(regions.LEVELS)
CELLS = len(DECILES) * LEVELS
TIMES, PATHS, AXES = len(TIME_FRACTIONS), len(PATH_FRACTIONS), len(AXIS_FRACTIONS)

# What is summed of a trial: errors in px; coverage; claims that held and claims that were made, of regions,
# of the time left, and of targets hit; share of the time with a region; whether there was one, and then the
# shares inside it and the ranked score; share of the time with a time left, its error, that of the clock;
# whether there was an interval, and then the shares inside it.
(
    ERRORS,
    COVERAGE,
    INSIDE,
    INSIDE_MADE,
    LEFT_INSIDE,
    LEFT_MADE,
    HITS,
    HITS_MADE,
    CLAIMED,
    REGIONS,
    REGION,
    TIMED,
    LEFT,
    CLOCK,
    SPREADS,
    SPREAD,
    WIDTH,
) = offsets(1 + TIMES + PATHS + AXES, 1, *4 * (CELLS,), TIMES, TIMES, 1, 1, LEVELS + 1, 1, 1, 1, 1, LEVELS)
WITH_INTERVAL = 1 + TIMES + PATHS
"""Errors that have an interval: all but the single-axis ones, which the analysis of variance covers."""


class Sums(msgspec.Struct, frozen=True):
    """Of one set: a number of trials and sums for each group and person."""

    trials: NDArray[np.int64]
    """(groups, people)"""
    predictors: tuple[FloatArray, ...]
    """(groups, people, WIDTH) for each predictor"""


def sums_of(parts: Parts, trials: TrialColumns, groups: Sequence[Group], predictors: int) -> Sums:
    """Add up every trial of a set."""
    people = len(trials.people)
    inside = np.array([group.mask for group in groups], dtype=np.bool_).reshape(len(groups), -1)
    sums = tuple(np.zeros((len(groups), people, WIDTH)) for _ in range(predictors))
    first = 0
    for part in parts():
        stop = first + len(part.trials)
        for errors, mine in zip(part.predictors, sums, strict=True):
            some = np.ascontiguousarray(inside[:, first:stop])
            columns = columns_of(errors)[: stop - first]
            add_trials(columns, trials.person[first:stop], some, mine.reshape(-1, WIDTH))
        first = stop
    counts = [np.bincount(trials.person[mask], minlength=people) for mask in inside]
    return Sums(np.array(counts, dtype=np.int64).reshape(len(groups), people), sums)


def rows_of(parts: Parts, mask: BoolArray, predictor: int) -> FloatArray:
    """The columns of one predictor for the trials of ``mask``, (trials, WIDTH)."""
    rows, first = [np.empty((0, WIDTH))], 0
    for part in parts():
        stop = first + len(part.trials)
        rows.append(columns_of(part.predictors[predictor])[: stop - first][mask[first:stop]])
        first = stop
    return np.concatenate(rows)


@law
def add_trials(columns: FloatTable, person: IntArray, inside: BoolTable, sums: FloatTable) -> None:
    """Add the columns of each trial to the sums of its person in each group that it is in.

    ``sums``: a row a person, for one group after the other.
    """
    people = len(sums) // len(inside)
    for k in range(len(person)):
        for g in range(len(inside)):
            if inside[g, k]:
                for c in range(columns.shape[1]):
                    sums[g * people + person[k], c] += columns[k, c]


def columns_of(errors: PredictorErrors) -> FloatArray:
    """What is summed of each trial, (trials, WIDTH); 0 where a predictor claims nothing."""
    out = np.zeros((len(errors.time_averaged), WIDTH))
    out[:, ERRORS] = errors.time_averaged
    out[:, ERRORS + 1 : COVERAGE] = np.hstack([errors.by_time, errors.by_path, errors.single_axis])
    out[:, COVERAGE] = errors.coverage
    for held, made, claims in (
        (INSIDE, INSIDE_MADE, errors.inside_by_time),
        (LEFT_INSIDE, LEFT_MADE, errors.time_inside_by_time),
        (HITS, HITS_MADE, errors.hits),
    ):
        if claims is not None:
            flat = claims.reshape(len(out), prod(claims.shape[1:]))  # there may be no trial: no -1
            out[:, held : held + flat.shape[1]] = np.nan_to_num(flat, nan=0.0)
            out[:, made : made + flat.shape[1]] = np.isfinite(flat)
    if errors.calibration is not None:
        with_region = errors.calibration[:, regions.CLAIMED] > 0.0
        out[:, CLAIMED], out[:, REGIONS] = errors.calibration[:, regions.CLAIMED], with_region
        out[with_region, REGION:TIMED] = errors.calibration[with_region, regions.INSIDE :]
    if errors.time_left is not None:
        left = errors.time_left
        with_spread = left[:, time_left.SPREAD] > 0.0
        out[:, TIMED], out[:, LEFT] = left[:, time_left.CLAIMED], left[:, time_left.ERROR]
        out[:, CLOCK], out[:, SPREADS] = left[:, time_left.CLOCK], with_spread
        out[with_spread, SPREAD:] = left[with_spread, time_left.INSIDE :]
    return out
