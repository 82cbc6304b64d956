"""Events to motion: position samples become velocity and acceleration."""

from pointpred.differentiators.differentiator import Differentiator
from pointpred.differentiators.homogeneous import HomogeneousDifferentiator

DIFFERENTIATORS: dict[str, type[Differentiator]] = {
    "homogeneous": HomogeneousDifferentiator,
}
"""Names users type, and what they mean."""

__all__ = ["DIFFERENTIATORS", "Differentiator", "HomogeneousDifferentiator"]
