"""A scored set as rows of text: the table that a terminal shows."""

from __future__ import annotations

from pointpred.scoring.summary import PredictorSummary, SetSummary

HEADINGS = (
    "predictor",
    "share of hold's error",
    "95 % interval",
    "clean",
    "time 30 %",
    "time 50 %",
    "time 70 %",
    "time 90 %",
    "path 50 %",
    "path 75 %",
    "path 90 %",
    "answers",
    "us/event",
)
"""Columns of the table of a set. All but the last two are errors as a share of the error of ``hold``."""


SEEN = "fitted to people of this set: too good; see docs/evidence/results.md"


def footnotes(summary: SetSummary) -> list[str]:
    """Warnings about predictors whose errors are too low, a line each."""
    return [f"{one.name}: {SEEN}" for one in summary.predictors if one.seen]


def rows(summary: SetSummary) -> list[tuple[str, ...]]:
    """The table of a set from its ``summary``: a row of text a predictor, a cell for each of HEADINGS."""
    several = summary.trials > 1  # one trial drawn again and again is no interval
    return [_row(predictor, several) for predictor in summary.predictors]


def _row(predictor: PredictorSummary, several: bool) -> tuple[str, ...]:
    interval = predictor.time_averaged.interval if several else None
    clean = predictor.groups.get("clean_trials")
    chosen = [
        *(predictor.by_time[fraction] for fraction in (0.3, 0.5, 0.7, 0.9)),
        *(predictor.by_path[fraction] for fraction in (0.5, 0.75, 0.9)),
    ]
    return (
        predictor.name,
        _text(predictor.time_averaged.of_hold),
        "-" if interval is None else f"{interval[0]:.2f} to {interval[1]:.2f}",
        _text(None if clean is None else clean.time_averaged.of_hold),
        *(_text(cell.of_hold) for cell in chosen),
        "-" if predictor.coverage is None else f"{predictor.coverage:.0%}",
        _text(predictor.us_per_event),
    )


def _text(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f}"
