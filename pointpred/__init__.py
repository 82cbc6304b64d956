"""pointpred predicts where a pointing movement will end while it is still going on."""

from pointpred.columns import EventColumns, MotionColumns, PredictionColumns, RegionColumns
from pointpred.events import Motion, PointerEvent, Prediction
from pointpred.pipeline import Pipeline, run
from pointpred.regions import Region
from pointpred.registry import RECOMMENDED, REGISTRY, build

__version__ = "0.1.0"

__all__ = [
    "RECOMMENDED",
    "REGISTRY",
    "EventColumns",
    "Motion",
    "MotionColumns",
    "Pipeline",
    "PointerEvent",
    "Prediction",
    "PredictionColumns",
    "Region",
    "RegionColumns",
    "build",
    "run",
]
