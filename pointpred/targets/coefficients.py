"""Coefficients of the evidence, fitted by ``python -m evidence intent targets``; not to be edited by hand."""

from __future__ import annotations

SLOW = (0, -0.3077, -0.5336, -1.368, 0.0313, -1.155)
"""Of each feature while the cursor stands."""
FAST = (0.6033, -0.4542, -0.3237, -0.289, 0.1675, -0.0721)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (-0.6747, -1.433)
AROUND = (0.4183, 0.8188)
"""Of *none of them*, and of what falls to all targets, standing and at the peak."""
UNCLAIMED_SLOW = (0, -0.2835, -0.4975, -1.928, 0.131, -0.4188)
UNCLAIMED_FAST = (0.0004356, -0.5241, -0.4552, -0.6656, 0.3, -0.2734)
UNCLAIMED_NONE = (-1.075, -1.256)
UNCLAIMED_AROUND = (-0.2205, 0.1252)
"""The same where the predictor claims no region."""
NEAREST = (-2.809, -0.736)
"""Of the feature NEAR alone, standing and at the peak, for the nearest target to the cursor."""
NEAREST_NONE = (-5.158, -0.08867)
PAGES_SLOW = (0.3016, -0.1244, -0.4561, -0.01862, -0.03106, -0.4446)
PAGES_FAST = (0.5945, -0.2008, -0.09255, 0.1306, -0.0288, 0)
PAGES_NONE = (-2.041, -1.813)
PAGES_AROUND = (0, 0)
PAGES_UNCLAIMED_SLOW = (0, -0.1987, -0.491, -0.0658, 0.001723, -1.418)
PAGES_UNCLAIMED_FAST = (2.236e-05, -0.3598, -0.3276, -0.05819, 0.07053, -0.5739)
PAGES_UNCLAIMED_NONE = (-2.091, -0.8464)
PAGES_UNCLAIMED_AROUND = (0, 0)
"""The same for pages, as cards, links and menus are laid out, by ``python -m evidence intent fit``."""
