"""The tables of a report as data frames, for CSV and LaTeX, in the order of the summary."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from pointpred.scoring.results import AXIS_FRACTIONS
from pointpred.scoring.statistics import AnovaSeries
from pointpred.scoring.summary import Measure, SetSummary

if TYPE_CHECKING:
    import pandas as pd

ALONG = {"by-time": "by_time", "by-path": "by_path", "single-axis": "single_axis"}
"""Tables of errors at shares of the movement, and the series that they show."""


def tables_of(summary: SetSummary, anova: AnovaSeries) -> dict[str, tuple[str, pd.DataFrame]]:
    """By the name of its file, the caption of each table and the table; an empty one is left out.

    Errors are shares of the error of ``hold``, on the single axis px or counts of the device.
    """
    import pandas as pd

    people = f"{summary.trials} trials of {summary.users} people"
    level = f"{summary.interval.level:.0%} bootstrap interval over {summary.interval.resampled}"
    made: dict[str, tuple[str, pd.DataFrame]] = {
        "scores": (f"Time-averaged error, {people}; {level}", _scores(summary))
    }
    for name, series in ALONG.items():
        single = name == "single-axis"
        value: Callable[[Measure], float | None] = (lambda m: m.px) if single else (lambda m: m.of_hold)
        rows = [
            {"predictor": p.name} | {f"{at:.0%}": value(m) for at, m in getattr(p, series).items()}
            for p in summary.predictors
        ]
        unit = summary.unit if single else "share of the error of hold"
        made[name] = (f"Error {name.replace('-', ' ')}, {unit}, {people}", pd.DataFrame(rows))
    by_person = [
        {
            "person": user,
            "trials": error.trials,
            "predictor": p.name,
            "error": error.px,
            "of hold": error.of_hold,
        }
        for p in summary.predictors
        for user, error in p.by_user.items()
    ]
    made["people"] = (f"Time-averaged error of each person, {summary.unit}", pd.DataFrame(by_person))
    left_out = [
        {"trial": skip.trial, "person": skip.user, "row": skip.row, "reason": skip.reason}
        for skip in summary.skipped
    ]
    skipped = pd.DataFrame(left_out, columns=["trial", "person", "row", "reason"])
    made["left-out"] = ("Trials that were left out, and why", skipped.astype({"row": "Int64"}))
    pairs = [
        {
            "first": one.first,
            "second": one.second,
            f"difference [{summary.unit}]": one.px,
            "from": one.interval[0],
            "to": one.interval[1],
            "t": one.t,
            "df": one.df,
            "p": one.p,
            "p (Holm)": one.p_holm,
        }
        for one in summary.contrasts
    ]
    made["contrasts"] = ("Predictors compared over people, paired t tests", pd.DataFrame(pairs))
    made["anova"] = ("Analysis of variance of the single-axis error", _anova(anova))
    return {name: (caption, table) for name, (caption, table) in made.items() if len(table)}


def _scores(summary: SetSummary) -> pd.DataFrame:
    import pandas as pd

    rows = []
    for p in summary.predictors:
        low, high = p.time_averaged.interval or (None, None)
        rows.append(
            {
                "predictor": p.name,
                f"error [{summary.unit}]": p.time_averaged.px,
                "of hold": p.time_averaged.of_hold,
                "from": low,
                "to": high,
                "answered": p.coverage,
                "us per event": p.us_per_event,
                "failed trials": len(p.failed),
                "fitted to people of this set": p.seen,
            }
        )
    return pd.DataFrame(rows)


def _anova(anova: AnovaSeries) -> pd.DataFrame:
    """A row a share of the path and a term."""
    import pandas as pd

    rows = [
        {
            "share of the path": f"{at:.0%}",
            "term": " x ".join(effect.factors),
            "F": effect.f,
            "df1": effect.df1,
            "df2": effect.df2,
            "p": effect.p,
            "epsilon": effect.epsilon,
            "p corrected": effect.p_corrected,
            "partial eta2": effect.eta2,
        }
        for at, effects in zip(AXIS_FRACTIONS, anova.effects, strict=False)
        for effect in effects
    ]
    return pd.DataFrame(rows)
