"""Motion to prediction: where the movement will end."""

from pointpred.predictors.adaptation.predictor import AdaptiveKinematicPredictor
from pointpred.predictors.delphian import DelphianPredictor, fit_line
from pointpred.predictors.hold import HoldPredictor
from pointpred.predictors.kalman import KalmanPredictor
from pointpred.predictors.kep import KinematicEndpointPredictor
from pointpred.predictors.kinematic.predictor import KinematicPredictor
from pointpred.predictors.ktm import TemplatePredictor, templates_of
from pointpred.predictors.linear import LinearPredictor
from pointpred.predictors.minimum_jerk import MinimumJerkPredictor
from pointpred.predictors.predictor import Predictor
from pointpred.predictors.switched import SwitchedPredictor
from pointpred.predictors.switched_direction import SwitchedDirectionPredictor

__all__ = [
    "AdaptiveKinematicPredictor",
    "DelphianPredictor",
    "HoldPredictor",
    "KalmanPredictor",
    "KinematicEndpointPredictor",
    "KinematicPredictor",
    "LinearPredictor",
    "MinimumJerkPredictor",
    "Predictor",
    "SwitchedDirectionPredictor",
    "SwitchedPredictor",
    "TemplatePredictor",
    "fit_line",
    "templates_of",
]
