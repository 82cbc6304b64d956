"""Kinematic endpoint prediction: a polynomial of speed over distance, and its first zero."""

from pointpred.predictors.kep.predictor import KinematicEndpointPredictor

__all__ = ["KinematicEndpointPredictor"]
