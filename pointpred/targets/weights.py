"""Coefficients of the evidence, fitted by ``python -m benchmarks.targets_fit``; not to be edited by hand."""

from __future__ import annotations

SLOW = (0.1, -0.3, -0.3, 0.0, 0.0, -1.0)
"""Of each feature while the cursor stands."""
FAST = (0.1, -0.3, -0.3, 0.0, 0.0, -1.0)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (-5.0, -5.0)
"""Score of *none of them*, standing and at the peak."""
