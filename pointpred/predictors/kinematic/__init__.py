"""The learned predictor: what a movement has shown so far, through a small network."""

from pointpred.predictors.kinematic.predictor import KinematicPredictor

__all__ = ["KinematicPredictor"]
