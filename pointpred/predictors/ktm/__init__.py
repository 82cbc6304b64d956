"""Kinematic template matching: speed profiles of earlier movements as templates."""

from pointpred.predictors.ktm.predictor import TemplatePredictor

__all__ = ["TemplatePredictor"]
