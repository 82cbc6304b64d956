"""Coefficients of the evidence, fitted by ``python -m benchmarks.targets_fit``; not to be edited by hand."""

from __future__ import annotations

SLOW = (4.173e-06, -0.1442, -0.475, -2.618, -0.1758, -0.8516)
"""Of each feature while the cursor stands."""
FAST = (0, -0.6032, -0.3794, -1.561, 0.5242, -1.295)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (0.8756, -4.391)
"""Score of *none of them*, standing and at the peak."""
NEAREST = (-3.211, -2.15)
"""Of the feature NEAR alone, standing and at the peak, for the nearest target to the cursor."""
NEAREST_NONE = (-5.122, -3.006)
