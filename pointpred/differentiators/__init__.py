"""Events to motion: position samples become velocity and acceleration."""

from pointpred.differentiators.difference import BackwardDifferentiator
from pointpred.differentiators.differentiator import Differentiator
from pointpred.differentiators.fading import FadingMemoryDifferentiator
from pointpred.differentiators.homogeneous import HomogeneousDifferentiator
from pointpred.differentiators.kalman import KalmanDifferentiator
from pointpred.differentiators.reduced_order import ReducedOrderDifferentiator

DIFFERENTIATORS: dict[str, type[Differentiator]] = {
    "homogeneous": HomogeneousDifferentiator,
    "kalman": KalmanDifferentiator,
    "fading-memory": FadingMemoryDifferentiator,
    "reduced-order": ReducedOrderDifferentiator,
    "difference": BackwardDifferentiator,
}
"""Names users type, and what they mean."""

__all__ = [
    "DIFFERENTIATORS",
    "BackwardDifferentiator",
    "Differentiator",
    "FadingMemoryDifferentiator",
    "HomogeneousDifferentiator",
    "KalmanDifferentiator",
    "ReducedOrderDifferentiator",
]
