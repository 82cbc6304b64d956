"""Sums over the trials of each person and group, from which every number of a summary is made.

Trials are added one by one in the set's order. The sums are therefore the same bits however the set was cut
into parts, and memory does not grow with the number of trials.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.columns import BoolArray, FloatArray
from pointpred.compiled import law
from pointpred.scoring.measures import regions, time_left
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.results import (
    AXIS_FRACTIONS,
    PATH_FRACTIONS,
    TIME_FRACTIONS,
    PredictorErrors,
    SetScore,
)
from pointpred.scoring.summary.groups import Group
from pointpred.scoring.summary.trial_columns import TrialColumns
from pointpred.stage import offsets

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
            add_trials(
                columns_of(errors)[: stop - first], trials.person[first:stop], inside[:, first:stop], mine
            )
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
def add_trials(columns: FloatArray, person: NDArray[np.int64], inside: BoolArray, sums: FloatArray) -> None:
    """Add the columns of each trial to the sums of its person in each group that it is in."""
    for k in range(len(person)):
        for g in range(len(inside)):
            if inside[g, k]:
                for c in range(columns.shape[1]):
                    sums[g, person[k], c] += columns[k, c]


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
            flat = claims.reshape(len(out), -1)
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
