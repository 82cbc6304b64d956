"""Coefficients of the evidence, fitted by ``python -m pages.targets.measure``; not to be edited by hand."""

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
PAGES_SLOW = (0.007443, -0.1337, -0.4188, 0.05134, 0.05939, -1.288)
PAGES_FAST = (0.5313, -0.3073, -0.06355, 0.01958, 0.03213, 0)
PAGES_NONE = (-2.22, -2.093)
PAGES_UNCLAIMED_SLOW = (0, -0.1249, -0.4109, 0.03059, 0.08159, -1.488)
PAGES_UNCLAIMED_FAST = (0, -0.4625, -0.2371, -0.006573, 0.04915, -0.7289)
PAGES_UNCLAIMED_NONE = (-2.372, -1.483)
"""The same for pages, as cards, links and menus are laid out, by ``python -m pages.intent.fit``."""
