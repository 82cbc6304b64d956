"""The scalar gradient estimator, integrated exactly: what remains of DREM once the parameters are apart."""

from __future__ import annotations

from math import expm1

from pointpred.compiled import law


@law
def descend(theta: float, mixed: float, phi: float, gamma: float, h: float) -> float:
    """Follow theta' = gamma phi (mixed - phi theta) over ``h`` s with mixed and phi held.

    Exactly: theta + (1 - exp(-gamma phi^2 h)) (mixed / phi - theta), written so that phi = 0 is harmless.
    No gain is too large: the estimate never passes mixed / phi.
    """
    exponent = gamma * phi * phi * h
    if exponent <= 0.0:
        return theta
    return theta - expm1(-exponent) / phi * (mixed - phi * theta)
