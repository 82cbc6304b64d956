"""Coefficients of the evidence, fitted by ``python -m evidence intent targets``; not to be edited by hand."""

from __future__ import annotations

SLOW = (0, -0.2847, -0.5136, -1.885, 0.007931, -0.3766)
"""Of each feature while the cursor stands."""
FAST = (0.3346, -0.4765, -0.3369, -0.5665, 0.3197, 0)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (-0.07224, -2.993)
"""Score of *none of them*, standing and at the peak."""
UNCLAIMED_SLOW = (0, -0.2753, -0.5252, -1.908, 0.04102, -0.5306)
UNCLAIMED_FAST = (0.0003597, -0.5578, -0.4107, -0.7617, 0.3807, -0.1901)
UNCLAIMED_NONE = (-0.3547, -1.842)
"""The same where the predictor claims no region."""
NEAREST = (-2.659, -0.7306)
"""Of the feature NEAR alone, standing and at the peak, for the nearest target to the cursor."""
NEAREST_NONE = (-5.561, -0.24)
PAGES_SLOW = (0.5715, -0.06125, -0.3979, 0.03605, 0.02572, -0.07829)
PAGES_FAST = (0.5593, -0.2038, -0.07994, 0.2008, -0.07514, 0)
PAGES_NONE = (-2.534, -1.879)
PAGES_UNCLAIMED_SLOW = (0, -0.1784, -0.4685, -0.001198, 0.03061, -1.652)
PAGES_UNCLAIMED_FAST = (0.0001214, -0.3341, -0.31, 0.07046, 0.01493, -0.6832)
PAGES_UNCLAIMED_NONE = (-2.639, -1.233)
"""The same for pages, as cards, links and menus are laid out, by ``python -m evidence intent fit``."""
