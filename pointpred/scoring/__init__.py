"""Recordings and predictors to scores: what a trial is, replay, measures, intervals, tables."""

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
from pointpred.scoring.summary.document import HEADINGS, about_memory, about_targets, footnotes, rows
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
    "about_memory",
    "about_targets",
    "document",
    "footnotes",
    "prepare",
    "replay",
    "resolution",
    "rows",
    "score",
    "summarise",
]
