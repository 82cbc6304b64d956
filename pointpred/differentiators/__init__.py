"""Events to motion: position samples become velocity and acceleration."""

from pointpred.differentiators.difference import BackwardDifferentiator
from pointpred.differentiators.differentiator import Differentiator
from pointpred.differentiators.homogeneous import HomogeneousDifferentiator
from pointpred.differentiators.kalman import KalmanDifferentiator

DIFFERENTIATORS: dict[str, type[Differentiator]] = {
    "homogeneous": HomogeneousDifferentiator,
    "kalman": KalmanDifferentiator,
    "difference": BackwardDifferentiator,
}
"""Names users type, and what they mean."""

__all__ = [
    "DIFFERENTIATORS",
    "BackwardDifferentiator",
    "Differentiator",
    "HomogeneousDifferentiator",
    "KalmanDifferentiator",
]
