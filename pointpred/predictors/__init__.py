"""Motion to prediction: where the movement will end."""

from pointpred.predictors.hold import HoldPredictor
from pointpred.predictors.predictor import Predictor

__all__ = ["HoldPredictor", "Predictor"]
