"""Pipelines under other names, and one predictor of a scored set."""

from __future__ import annotations

from pointpred.pipeline import Pipeline
from pointpred.scoring import SetScore
from pointpred.scoring.results import PredictorErrors


def named(name: str, pattern: Pipeline) -> Pipeline:
    """The same pipeline under another name."""
    return Pipeline(name, pattern.differentiator, pattern.predictor)


def find(scored: SetScore, name: str) -> PredictorErrors:
    """The errors of one predictor."""
    return next(errors for errors in scored.predictors if errors.name == name)
