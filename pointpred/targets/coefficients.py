"""Coefficients of the evidence, fitted by ``python -m evidence intent targets``; not to be edited by hand."""

from __future__ import annotations

SLOW = (0, -0.3066, -0.49, -1.485, 0.02719, -0.9111)
"""Of each feature while the cursor stands."""
FAST = (0.5877, -0.4726, -0.3215, -0.2528, 0.1177, -0.09325)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (-0.8728, -1.422)
AROUND = (0.2136, 0.815)
"""Of *none of them*, and of what falls to all targets, standing and at the peak."""
UNCLAIMED_SLOW = (0, -0.2966, -0.4696, -1.845, 0.05997, -0.4758)
UNCLAIMED_FAST = (0.0001748, -0.5646, -0.4291, -0.5543, 0.171, -0.2724)
UNCLAIMED_NONE = (-1.358, -1.322)
UNCLAIMED_AROUND = (-0.1863, 0.1166)
"""The same where the predictor claims no region."""
NEAREST = (-2.784, -0.691)
"""Of the feature NEAR alone, standing and at the peak, for the nearest target to the cursor."""
NEAREST_NONE = (-5.55, -0.03847)
PAGES_SLOW = (0.3016, -0.1244, -0.4561, -0.01862, -0.03106, -0.4446)
PAGES_FAST = (0.5945, -0.2008, -0.09255, 0.1306, -0.0288, 0)
PAGES_NONE = (-2.041, -1.813)
PAGES_AROUND = (0, 0)
PAGES_UNCLAIMED_SLOW = (0, -0.1987, -0.491, -0.0658, 0.001723, -1.418)
PAGES_UNCLAIMED_FAST = (2.236e-05, -0.3598, -0.3276, -0.05819, 0.07053, -0.5739)
PAGES_UNCLAIMED_NONE = (-2.091, -0.8464)
PAGES_UNCLAIMED_AROUND = (0, 0)
"""The same for pages, as cards, links and menus are laid out, by ``python -m evidence intent fit``."""
