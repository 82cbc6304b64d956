"""From errors of single trials to the numbers of a set: means, ratios to ``hold``, intervals over people."""

from __future__ import annotations

from collections.abc import Iterable
from math import nan

import numpy as np
from numpy.typing import NDArray

from pointpred.columns import BoolArray, FloatArray
from pointpred.errors import ParameterError
from pointpred.scoring.results import (
    AXIS_FRACTIONS,
    PATH_FRACTIONS,
    TIME_FRACTIONS,
    PredictorErrors,
    SetScore,
)
from pointpred.scoring.summary.bootstrap import DRAWS, LEVEL, ratio_intervals
from pointpred.scoring.summary.claims import claims
from pointpred.scoring.summary.document import (
    VERSION,
    Document,
    GroupSummary,
    Measure,
    Measures,
    PredictorSummary,
    Resampling,
    SetSummary,
    Unread,
    UserError,
    interval,
    number,
)
from pointpred.scoring.summary.groups import Group, groups_of

FLOOR = "hold"
"""No prediction: every other error is judged beside its error."""

SERIES = {"by_time": TIME_FRACTIONS, "by_path": PATH_FRACTIONS, "single_axis": AXIS_FRACTIONS}
WITH_INTERVAL = 1 + len(TIME_FRACTIONS) + len(PATH_FRACTIONS)
"""Measures that have an interval: all but the single-axis ones, which the analysis of variance covers."""

Users = NDArray[np.str_]


def document(scores: Iterable[SetScore], unread: Iterable[Unread] = ()) -> Document:
    """Scored sets as the document that ``pointpred score --json`` prints; ``unread``: what was left out."""
    return Document(VERSION, tuple(summarise(score) for score in scores), tuple(unread))


def summarise(score: SetScore, *, draws: int = DRAWS) -> SetSummary:
    """The numbers of one scored set: over all trials, and over each group of trials.

    ``draws``: of the bootstrap behind each interval. Raises ParameterError when the set was scored without
    ``hold``.
    """
    floor = next((errors for errors in score.predictors if errors.name == FLOOR), None)
    if floor is None:
        raise ParameterError(f"a summary needs the predictor {FLOOR!r} among those scored", field="score")
    everything, *groups = groups_of(score) or (Group("all trials", np.ones(0, dtype=np.bool_)),)
    users = np.array([trial.trial.user for trial in score.trials], dtype=str)
    whole = _measures(score, floor, users, everything, draws)
    parts = {_key(group): _measures(score, floor, users, group, draws) for group in groups}
    people = len(np.unique(users))
    return SetSummary(
        name=score.name,
        simulated=score.simulated,
        unit=score.unit,
        trials=len(score.trials),
        users=people,
        events=sum(trial.events for trial in score.trials),
        skipped=score.skipped,
        notes=score.notes,
        interval=Resampling(LEVEL, "users" if people > 1 else "trials", draws, score.seed),
        groups={_key(one): GroupSummary(one.label, one.basis, int(one.mask.sum())) for one in groups},
        predictors=tuple(
            PredictorSummary(
                name=errors.name,
                seen=errors.seen,
                coverage=number(errors.coverage.mean() if len(users) else nan),
                us_per_event=number(errors.us_per_event),
                failed=errors.failed,
                time_averaged=whole[place].time_averaged,
                by_time=whole[place].by_time,
                by_path=whole[place].by_path,
                single_axis=whole[place].single_axis,
                calibration=whole[place].calibration,
                time_left=whole[place].time_left,
                hits=whole[place].hits,
                groups={key: part[place] for key, part in parts.items()},
                by_user=_by_user(errors, floor, users),
            )
            for place, errors in enumerate(score.predictors)
        ),
    )


def _key(group: Group) -> str:
    return group.label.replace("-", "").replace(" ", "_")


def _ratio(error: float, floor: float) -> float:
    return error / floor if floor > 0.0 else nan


def _table(errors: PredictorErrors, mask: BoolArray) -> FloatArray:
    """Every error of the chosen trials side by side: time-averaged, then SERIES."""
    series = [getattr(errors, name)[mask] for name in SERIES]
    return np.column_stack([errors.time_averaged[mask], *series])


def _measures(
    score: SetScore, floor: PredictorErrors, users: Users, group: Group, draws: int
) -> list[Measures]:
    """For each predictor the measures of one group of trials."""
    tables = [_table(errors, group.mask) for errors in score.predictors]
    below = _table(floor, group.mask)
    who: list[str] = users[group.mask].tolist()
    above = np.hstack([table[:, :WITH_INTERVAL] for table in tables])
    bounds = ratio_intervals(above, below[:, :WITH_INTERVAL], who, seed=score.seed, draws=draws)
    measures = []
    for place, (errors, table) in enumerate(zip(score.predictors, tables, strict=True)):
        reach = slice(place * WITH_INTERVAL, (place + 1) * WITH_INTERVAL)
        cells = iter(_cells(table, below, bounds.low[reach], bounds.high[reach]))
        claimed = claims(errors, group.mask, who, seed=score.seed, draws=draws)
        measures.append(
            Measures(
                next(cells),
                {share: next(cells) for share in TIME_FRACTIONS},
                {share: next(cells) for share in PATH_FRACTIONS},
                {share: next(cells) for share in AXIS_FRACTIONS},
                *claimed,
            )
        )
    return measures


def _cells(table: FloatArray, below: FloatArray, low: FloatArray, high: FloatArray) -> list[Measure]:
    """A measure for each column of ``table``; ``below`` holds the errors of ``hold`` on the same trials."""
    nothing = np.full(table.shape[1], nan)
    px = table.mean(axis=0) if len(table) else nothing
    floor = below.mean(axis=0) if len(table) else nothing
    ratios = [_ratio(error, least) for error, least in zip(px, floor, strict=True)]
    bounds = [interval(*pair) for pair in zip(low, high, strict=True)] + [None] * (len(px) - WITH_INTERVAL)
    return [
        Measure(number(error), number(ratio), number(1.0 - ratio), pair)
        for error, ratio, pair in zip(px, ratios, bounds, strict=True)
    ]


def _by_user(errors: PredictorErrors, floor: PredictorErrors, users: Users) -> dict[str, UserError]:
    """The time-averaged error of each person."""
    people = {}
    for user in np.unique(users).tolist():
        mask = users == user
        px, below = errors.time_averaged[mask].mean(), floor.time_averaged[mask].mean()
        people[user] = UserError(int(mask.sum()), number(px), number(_ratio(px, below)))
    return people
