"""Factors on the network's regions, fitted to held-out people, by the predicted share of the time."""

from __future__ import annotations

from math import exp, floor

from pointpred.compiled import law
from pointpred.records import FloatArray

KNOTS = 10
"""Of the share of the time that has passed, as predicted: 0.05, 0.15 ... 0.95."""
WIDTH, TAIL, SPREAD, FACTORS = range(4)
"""Logarithms of what the widths, the tail, the spread of the time left are multiplied by."""


@law
def factor(coefficients: FloatArray, at: int, share: float, which: int) -> float:
    """A factor at a share of the time, on lines between the knots."""
    place = min(max(share * KNOTS - 0.5, 0.0), KNOTS - 1.0)
    knot = min(floor(place), KNOTS - 2)
    low = coefficients[at + FACTORS * knot + which]
    high = coefficients[at + FACTORS * (knot + 1) + which]
    return exp(low + (place - knot) * (high - low))
