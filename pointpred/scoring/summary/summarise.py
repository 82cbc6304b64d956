"""From errors of single trials to the numbers of a set: means, ratios to ``hold``, intervals over people."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import nan
from typing import NamedTuple

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred.scoring.measures import regions
from pointpred.scoring.measures.endpoint import DECILES
from pointpred.scoring.results import (
    AXIS_FRACTIONS,
    PATH_FRACTIONS,
    TIME_FRACTIONS,
    PredictorErrors,
    SetScore,
)
from pointpred.scoring.statistics import EVERY_PAIR, LEAST_USERS, Contrast, contrasts
from pointpred.scoring.summary import sums
from pointpred.scoring.summary.bootstrap import DRAWS, LEVEL, drawn_totals, ratio_bounds
from pointpred.scoring.summary.document import (
    VERSION,
    Calibration,
    Document,
    GroupSummary,
    Hits,
    HitShare,
    InsideAtTime,
    Interval,
    Measure,
    Measures,
    Number,
    PredictorSummary,
    Repeats,
    Resampling,
    SetSummary,
    TimeLeft,
    Unread,
    UserError,
    interval,
    number,
    or_nan,
)
from pointpred.scoring.summary.sums import (
    WITH_INTERVAL,
    Group,
    Parts,
    Sums,
    TrialColumns,
    groups,
    rows_of,
    sums_of,
    trial_columns,
)

FLOOR = "hold"
"""No prediction: every other error is judged beside its error."""
SERIES = {"by_time": TIME_FRACTIONS, "by_path": PATH_FRACTIONS, "single_axis": AXIS_FRACTIONS}

RATIOS = (
    (sums.INSIDE, sums.INSIDE_MADE, sums.CELLS),
    (sums.LEFT_INSIDE, sums.LEFT_MADE, sums.CELLS),
    (sums.HITS, sums.HITS_MADE, sums.TIMES),
    (sums.LEFT, sums.CLOCK, 1),
)
"""Columns that are divided by columns, and how many; each ratio has an interval."""


class Totals(msgspec.Struct, frozen=True):
    """The sums of one predictor over the trials of a group."""

    trials: int
    sums: FloatArray
    """(WIDTH,)"""
    low: FloatArray
    high: FloatArray
    """(WIDTH,): bounds of the ratios of RATIOS, at the places of what is divided"""


class Ratio(NamedTuple):
    """Sum over sum of one column."""

    share: Number
    interval: Interval
    trials: int
    """Trials with such a claim."""


def claims(
    errors: PredictorErrors, totals: Totals
) -> tuple[Calibration | None, TimeLeft | None, Hits | None]:
    """What became of the claims in a group of trials; ``errors`` says which there are in the set."""
    if not totals.trials:
        return None, None, None
    inside, times, hits, (clock,) = (_ratios(totals, *columns) for columns in RATIOS)
    by_time = dict(zip(TIME_FRACTIONS, (HitShare(one.share, one.interval) for one in hits), strict=True))
    return (
        None if errors.calibration is None else _calibration(errors, totals, inside),
        None if errors.time_left is None else _time_left(errors, totals, clock, times),
        None if errors.hits is None or not hits[0].trials else Hits(hits[0].trials, by_time),
    )


def _ratios(totals: Totals, above: int, below: int, count: int) -> list[Ratio]:
    return [
        Ratio(
            number(totals.sums[above + i] / totals.sums[below + i]) if totals.sums[below + i] > 0.0 else None,
            interval(totals.low[above + i], totals.high[above + i]),
            int(totals.sums[below + i]),
        )
        for i in range(count)
    ]


def _levels(values: FloatArray) -> dict[float, Number]:
    return {level: number(value) for level, value in zip(regions.LEVELS, values, strict=True)}


def _by_time(cells: list[Ratio]) -> dict[float, InsideAtTime]:
    """At each decile of the time the share of each level inside; ``cells`` has a row a decile and level."""
    rows = (cells[sums.LEVELS * k : sums.LEVELS * (k + 1)] for k in range(len(DECILES)))
    return {
        share: InsideAtTime(
            row[0].trials,
            {level: one.share for level, one in zip(regions.LEVELS, row, strict=True)},
            {level: one.interval for level, one in zip(regions.LEVELS, row, strict=True)},
        )
        for share, row in zip(DECILES, rows, strict=True)
    }


def _calibration(errors: PredictorErrors, totals: Totals, cells: list[Ratio]) -> Calibration | None:
    """Means over the trials in which any region was claimed."""
    claimed = totals.sums[sums.REGIONS]
    if not claimed:
        return None
    means = totals.sums[sums.REGION : sums.TIMED] / claimed
    return Calibration(
        number(totals.sums[sums.CLAIMED] / totals.trials),
        _levels(means[: sums.LEVELS]),
        number(means[sums.LEVELS]),
        None if errors.inside_by_time is None else _by_time(cells),
    )


def _time_left(errors: PredictorErrors, totals: Totals, clock: Ratio, cells: list[Ratio]) -> TimeLeft:
    """The error beside the clock's; shares inside where any intervals were claimed."""
    spread = totals.sums[sums.SPREADS]
    return TimeLeft(
        number(totals.sums[sums.TIMED] / totals.trials),
        number(totals.sums[sums.LEFT] / totals.trials),
        number(totals.sums[sums.CLOCK] / totals.trials),
        clock.share,
        clock.interval,
        _levels(totals.sums[sums.SPREAD :] / spread) if spread else None,
        _by_time(cells) if errors.time_inside_by_time is not None and spread else None,
    )


def document(scores: Iterable[SetScore], unread: Iterable[Unread] = ()) -> Document:
    """Scored sets as the document that ``pointpred score --json`` prints; ``unread``: what was left out."""
    return Document(VERSION, tuple(summarise(score) for score in scores), tuple(unread))


def summarise(score: SetScore, *, draws: int = DRAWS) -> SetSummary:
    """The numbers of one scored set: over all trials, and over each group of trials.

    ``draws``: of the bootstrap behind each interval. Raises ParameterError when the set was scored without
    ``hold``.
    """
    return summarise_parts(score, lambda: [score], draws=draws)


def summarise_parts(about: SetScore, parts: Parts, *, draws: int = DRAWS) -> SetSummary:
    """``summarise`` of a set whose trials come in parts: the same numbers, whatever the parts are.

    ``about`` says everything of the set but what has a row a trial; of its predictors' arrays only
    matters which there are. ``parts`` is called several times. Memory: one part, and 1.4 kB for each person,
    group and predictor; where a group has one person, also 1.4 kB for each of its trials.
    """
    names = [errors.name for errors in about.predictors]
    if FLOOR not in names:
        raise ParameterError(f"a summary needs the predictor {FLOOR!r} among those scored", field="score")
    trials = trial_columns(parts(), about.by)
    everything, *others = groups(trials) or (Group("all trials", np.ones(0, dtype=np.bool_)),)
    summed = sums_of(parts, trials, (everything, *others), len(names))
    floor = names.index(FLOOR)
    whole, *rest = (
        _measures(about, parts, group, summed, place, floor, draws)
        for place, group in enumerate((everything, *others))
    )
    count = len(trials.person)
    by_user = [_by_user(summed, trials, place, floor) for place in range(len(names))]
    pairs, why = _contrasts(about, by_user)
    return SetSummary(
        name=about.name,
        simulated=about.simulated,
        unit=about.unit,
        trials=count,
        users=len(trials.people),
        candidates=about.candidates,
        events=trials.events,
        skipped=about.skipped,
        notes=(*about.notes, *why),
        interval=Resampling(LEVEL, "users" if len(trials.people) > 1 else "trials", draws, about.seed),
        groups={
            one.key: GroupSummary(one.label, one.basis, int(one.mask.sum()), one.column, one.level)
            for one in others
        },
        predictors=tuple(
            PredictorSummary(
                name=errors.name,
                seen=errors.seen,
                coverage=number(
                    summed.predictors[place][0, :, sums.COVERAGE].sum() / count if count else nan
                ),
                us_per_event=number(errors.us_per_event),
                failed=errors.failed,
                time_averaged=whole[place].time_averaged,
                by_time=whole[place].by_time,
                by_path=whole[place].by_path,
                single_axis=whole[place].single_axis,
                calibration=whole[place].calibration,
                time_left=whole[place].time_left,
                hits=whole[place].hits,
                groups={one.key: part[place] for one, part in zip(others, rest, strict=True)},
                by_user=by_user[place],
                learns=errors.learns,
                ablates=errors.ablates,
            )
            for place, errors in enumerate(about.predictors)
        ),
        contrasts=pairs,
        repeats=Repeats(*trials.repeats) if any(one.learns for one in about.predictors) else None,
    )


def _contrasts(
    about: SetScore, by_user: Sequence[dict[str, UserError]]
) -> tuple[tuple[Contrast, ...], list[str]]:
    """The comparisons that were asked for, and why there are none."""
    if not about.contrast:
        return (), []
    names = [errors.name for errors in about.predictors]
    errors = {
        name: np.array([or_nan(one.px) for one in people.values()])
        for name, people in zip(names, by_user, strict=True)
        if name in about.contrast or about.contrast == EVERY_PAIR
    }
    people = len(by_user[0])
    if people < LEAST_USERS:
        return (), [f"no contrasts: at least {LEAST_USERS} people are needed, the set has {people}"]
    wanted = None if about.contrast == EVERY_PAIR else about.contrast
    return contrasts(errors, wanted), []


def _ratio(error: float, floor: float) -> float:
    return error / floor if floor > 0.0 else nan


def _measures(
    about: SetScore, parts: Parts, group: Group, summed: Sums, place: int, floor: int, draws: int
) -> list[Measures]:
    """For each predictor the measures of one group of trials."""
    present = summed.trials[place] > 0
    count = int(summed.trials[place].sum())
    drawn_trials = int(present.sum()) == 1  # people cannot be drawn where there is one

    def units(predictor: int) -> FloatArray:
        """What is drawn: the sums of each person, or the trials of the only one."""
        if drawn_trials:
            return rows_of(parts, group.mask, predictor)
        people: FloatArray = summed.predictors[predictor][place, present]
        return people

    below = units(floor)[:, :WITH_INTERVAL]
    floor_px = _means(summed.predictors[floor][place], count)
    measures = []
    for predictor, errors in enumerate(about.predictors):
        totals = Totals(
            count,
            summed.predictors[predictor][place].sum(axis=0),
            *_bounds(units(predictor), below, about.seed, draws),
        )
        px = _means(summed.predictors[predictor][place], count)
        cells = iter(_cells(px, floor_px, totals))
        measures.append(
            Measures(
                next(cells),
                {share: next(cells) for share in TIME_FRACTIONS},
                {share: next(cells) for share in PATH_FRACTIONS},
                {share: next(cells) for share in AXIS_FRACTIONS},
                *claims(errors, totals),
            )
        )
    return measures


def _means(people: FloatArray, count: int) -> FloatArray:
    """Mean errors of a predictor in px, from the sums of people."""
    total: FloatArray = people[:, sums.ERRORS : sums.COVERAGE].sum(axis=0)
    means: FloatArray = total / count if count else np.full(total.shape, nan)
    return means


def _bounds(units: FloatArray, below: FloatArray, seed: int, draws: int) -> tuple[FloatArray, FloatArray]:
    """Bounds of each ratio of a predictor at the place of what is divided, NaN for the rest."""
    low, high = np.full((2, sums.WIDTH), nan)
    if len(units) < 2:
        return low, high
    above = np.concatenate([np.arange(WITH_INTERVAL), *(first + np.arange(n) for first, _, n in RATIOS)])
    under = np.concatenate([first + np.arange(n) for _, first, n in RATIOS])
    totals = drawn_totals(np.hstack([units[:, above], below, units[:, under]]), seed, draws)
    low[above], high[above] = ratio_bounds(totals[:, : len(above)], totals[:, len(above) :])
    return low, high


def _cells(px: FloatArray, floor: FloatArray, totals: Totals) -> list[Measure]:
    """A measure for each error; ``floor`` holds those of ``hold`` on the same trials."""
    bounds = [interval(totals.low[i], totals.high[i]) for i in range(WITH_INTERVAL)]
    ratios = [_ratio(error, least) for error, least in zip(px, floor, strict=True)]
    return [
        Measure(number(error), number(ratio), number(1.0 - ratio), pair)
        for error, ratio, pair in zip(px, ratios, bounds + [None] * (len(px) - WITH_INTERVAL), strict=True)
    ]


def _by_user(summed: Sums, trials: TrialColumns, predictor: int, floor: int) -> dict[str, UserError]:
    """The time-averaged error of each person."""
    counts = summed.trials[0] if len(summed.trials) else np.zeros(0, dtype=np.int64)
    own, below = (summed.predictors[one][0, :, sums.ERRORS] / counts for one in (predictor, floor))
    return {
        user: UserError(int(counts[k]), number(own[k]), number(_ratio(own[k], below[k])))
        for k, user in enumerate(trials.people)
    }
