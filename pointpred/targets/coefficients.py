"""Coefficients of the evidence, fitted by ``python -m evidence intent targets``; not to be edited by hand."""

from __future__ import annotations

SLOW = (0, -0.2328, -0.4561, -1.789, 0.05295, -0.5663)
"""Of each feature while the cursor stands."""
FAST = (0.2747, -0.4731, -0.3258, -0.6721, 0.3524, 0)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (-0.3208, -2.712)
"""Score of *none of them*, standing and at the peak."""
UNCLAIMED_SLOW = (0, -0.2239, -0.4621, -1.803, 0.06911, -0.6918)
UNCLAIMED_FAST = (0.0004115, -0.5252, -0.3819, -0.7671, 0.3922, -0.2329)
UNCLAIMED_NONE = (-0.5535, -1.907)
"""The same where the predictor claims no region."""
NEAREST = (-2.865, -0.7696)
"""Of the feature NEAR alone, standing and at the peak, for the nearest target to the cursor."""
NEAREST_NONE = (-5.336, -0.3403)
PAGES_SLOW = (0.5715, -0.06125, -0.3979, 0.03605, 0.02572, -0.07829)
PAGES_FAST = (0.5593, -0.2038, -0.07994, 0.2008, -0.07514, 0)
PAGES_NONE = (-2.534, -1.879)
PAGES_UNCLAIMED_SLOW = (0, -0.1784, -0.4685, -0.001198, 0.03061, -1.652)
PAGES_UNCLAIMED_FAST = (0.0001214, -0.3341, -0.31, 0.07046, 0.01493, -0.6832)
PAGES_UNCLAIMED_NONE = (-2.639, -1.233)
"""The same for pages, as cards, links and menus are laid out, by ``python -m evidence intent fit``."""
