"""Recordings and predictors to scores: what a trial is, replay, measures, intervals, tables."""

from __future__ import annotations

from typing import Any

import msgspec

from pointpred.scoring.replay import replay
from pointpred.scoring.results import PredictorErrors, ScoredTrial, SetScore
from pointpred.scoring.scorer import Progress, score
from pointpred.scoring.summary import (
    FLOOR,
    Document,
    PredictorSummary,
    SetSummary,
    Unread,
    document,
    summarise,
)
from pointpred.scoring.summary.bootstrap import DRAWS
from pointpred.scoring.table import HEADINGS, footnotes, rows
from pointpred.scoring.trials import Prepared, prepare, resolution

__all__ = [
    "FLOOR",
    "HEADINGS",
    "Document",
    "PredictorErrors",
    "PredictorSummary",
    "Prepared",
    "Progress",
    "ScoredTrial",
    "SetScore",
    "SetSummary",
    "Unread",
    "document",
    "footnotes",
    "prepare",
    "replay",
    "resolution",
    "rows",
    "score",
    "summarise",
    "summary",
]


def summary(score: SetScore, *, draws: int = DRAWS) -> dict[str, Any]:
    """``summarise`` as plain dictionaries."""
    plain: dict[str, Any] = msgspec.to_builtins(summarise(score, draws=draws), str_keys=True)
    return plain
