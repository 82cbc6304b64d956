"""The learned predictor for one person: it learns from each movement that they finish."""

from pointpred.predictors.adaptation.predictor import AdaptiveKinematicPredictor

__all__ = ["AdaptiveKinematicPredictor"]
