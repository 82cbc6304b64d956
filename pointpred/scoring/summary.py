"""A scored set as numbers to print: the JSON document of the command line."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import msgspec
import numpy as np

from pointpred.columns import BoolArray, FloatArray
from pointpred.errors import ParameterError
from pointpred.scoring.bootstrap import DRAWS, LEVEL, ratio_intervals
from pointpred.scoring.claims import claims
from pointpred.scoring.claims import number as _number
from pointpred.scoring.conditions import Group, groups_of
from pointpred.scoring.results import (
    AXIS_FRACTIONS,
    PATH_FRACTIONS,
    TIME_FRACTIONS,
    PredictorErrors,
    SetScore,
)

VERSION = 1
FLOOR = "hold"
"""No prediction: every other error is judged beside its error."""

SERIES = {"by_time": TIME_FRACTIONS, "by_path": PATH_FRACTIONS, "single_axis": AXIS_FRACTIONS}
WITH_INTERVAL = 1 + len(TIME_FRACTIONS) + len(PATH_FRACTIONS)
"""Measures that have an interval: all but the single-axis ones, which the statistics look after."""

Json = dict[str, Any]


def document(scores: Iterable[SetScore]) -> Json:
    """Scored sets as the JSON document that ``pointpred score --json`` prints."""
    return {"version": VERSION, "sets": [summary(score) for score in scores]}


def summary(score: SetScore, *, draws: int = DRAWS) -> Json:
    """One scored set as plain dictionaries and lists; ``None`` where a number means nothing.

    Every measure is {px, of_hold, skill, interval}: the mean error over trials, its ratio to the mean error
    of ``hold``, 1 - ratio, and the ratio's interval over people (``None`` on the single axis). Each predictor
    says it for all trials, and under ``groups`` for those that are clean, with and without sub-movements, of
    experienced people and of novices, as far as the set has them; ``by_user`` holds the time-averaged error
    of each person. Claims, for each group too, ``None`` where there are none: ``calibration`` is the share of
    time with a region, the shares of that time with the endpoint inside those of 50, 80 and 95 %, their
    ranked probability score in px, and the shares of trials at each decile of the time; ``time_left`` the
    absolute error in s, that of a clock which knows the set's median time, their ratio, and the same shares
    for intervals; ``hits`` the share of trials whose prediction lies in the target, by time.
    ``seen``: the predictor was fitted to people of this set, its errors are too low.
    ``unit`` is ``counts`` where the recording holds no cursor: all ``px`` are then counts.
    Raises ParameterError when the set was scored without ``hold``.
    """
    floor = [errors for errors in score.predictors if errors.name == FLOOR]
    if not floor:
        raise ParameterError(f"a summary needs the predictor {FLOOR!r} among those scored")
    groups = groups_of(score) or (Group("all trials", np.ones(0, dtype=np.bool_)),)
    users = np.array([trial.trial.user for trial in score.trials], dtype=str)
    parts = [_describe(score, floor[0], users, group, draws) for group in groups]
    return {
        "name": score.name,
        "simulated": score.simulated,
        "unit": score.unit,
        "trials": len(score.trials),
        "users": len(np.unique(users)),
        "events": sum(trial.events for trial in score.trials),
        "skipped": [msgspec.structs.asdict(skip) for skip in score.skipped],
        "notes": list(score.notes),
        "interval": {
            "level": LEVEL,
            "resampled": "users" if len(np.unique(users)) > 1 else "trials",
            "draws": draws,
            "seed": score.seed,
        },
        "groups": {
            _key(group): {"label": group.label, "basis": group.basis, "trials": int(group.mask.sum())}
            for group in groups[1:]
        },
        "predictors": [
            {
                "name": errors.name,
                "seen": errors.seen,
                "coverage": _number(errors.coverage.mean() if len(users) else np.nan),
                "us_per_event": _number(errors.us_per_event),
                "failed": [msgspec.structs.asdict(skip) for skip in errors.failed],
                **parts[0][place],
                "groups": {
                    _key(group): part[place] for group, part in zip(groups[1:], parts[1:], strict=True)
                },
                "by_user": _by_user(errors, floor[0], users),
            }
            for place, errors in enumerate(score.predictors)
        ],
    }


def _key(group: Group) -> str:
    return group.label.replace("-", "").replace(" ", "_")


def _ratio(error: float, floor: float) -> float:
    return error / floor if floor > 0.0 else float("nan")


def _table(errors: PredictorErrors, mask: BoolArray) -> FloatArray:
    """Every error of the chosen trials side by side: time-averaged, then SERIES."""
    series = [getattr(errors, name)[mask] for name in SERIES]
    return np.column_stack([errors.time_averaged[mask], *series])


def _describe(
    score: SetScore, floor: PredictorErrors, users: np.ndarray[Any, Any], group: Group, draws: int
) -> list[Json]:
    """For each predictor the measures of one group of trials."""
    tables = [_table(errors, group.mask) for errors in score.predictors]
    below = _table(floor, group.mask)
    who = users[group.mask].tolist()
    sure = [table[:, :WITH_INTERVAL] for table in tables]
    bounds = ratio_intervals(np.hstack(sure), below[:, :WITH_INTERVAL], who, seed=score.seed, draws=draws)
    described = []
    for place, (errors, table) in enumerate(zip(score.predictors, tables, strict=True)):
        reach = slice(place * WITH_INTERVAL, (place + 1) * WITH_INTERVAL)
        told = claims(errors, group.mask, who, seed=score.seed, draws=draws)
        described.append(_measures(table, below, bounds.low[reach], bounds.high[reach]) | told)
    return described


def _measures(table: FloatArray, below: FloatArray, low: FloatArray, high: FloatArray) -> Json:
    """The measures of one predictor in one group."""
    nothing = np.full(table.shape[1], np.nan)
    px = table.mean(axis=0) if len(table) else nothing
    floor = below.mean(axis=0) if len(table) else nothing
    cells = []
    for i in range(len(px)):
        ratio = _ratio(px[i], floor[i])
        interval = [_number(low[i]), _number(high[i])] if i < WITH_INTERVAL else [None]
        cell: Json = {"px": _number(px[i]), "of_hold": _number(ratio), "skill": _number(1.0 - ratio)}
        cells.append(cell | {"interval": None if None in interval else interval})
    named: Json = {"time_averaged": cells[0]}
    first = 1
    for name, fractions in SERIES.items():
        named[name] = dict(zip(map(str, fractions), cells[first : first + len(fractions)], strict=True))
        first += len(fractions)
    return named


def _by_user(errors: PredictorErrors, floor: PredictorErrors, users: np.ndarray[Any, Any]) -> Json:
    """The time-averaged error of each person."""
    found = {}
    for user in np.unique(users).tolist():
        mask = users == user
        px, below = errors.time_averaged[mask].mean(), floor.time_averaged[mask].mean()
        found[user] = {
            "trials": int(mask.sum()),
            "px": _number(px),
            "of_hold": _number(_ratio(px, below)),
        }
    return found
