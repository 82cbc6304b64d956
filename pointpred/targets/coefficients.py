"""Coefficients of the evidence, fitted by ``python -m evidence intent targets``; not to be edited by hand."""

from __future__ import annotations

SLOW = (0, -0.291, -0.538, -1.481, 0.01996, -1.092)
"""Of each feature while the cursor stands."""
FAST = (0.6517, -0.4384, -0.3252, -0.2088, 0.1403, -0.1039)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (-0.6458, -1.732)
AROUND = (0.3475, 0.7895)
"""Of *none of them*, and of what falls to all targets, standing and at the peak."""
UNCLAIMED_SLOW = (0, -0.2804, -0.5189, -2.041, 0.1073, -0.2959)
UNCLAIMED_FAST = (0.0003708, -0.5464, -0.4339, -0.7272, 0.315, -0.2122)
UNCLAIMED_NONE = (-0.6068, -1.309)
UNCLAIMED_AROUND = (-0.1188, 0.06853)
"""The same where the predictor claims no region."""
NEAREST = (-2.612, -0.6827)
"""Of the feature NEAR alone, standing and at the peak, for the nearest target to the cursor."""
NEAREST_NONE = (-5.491, 0.0209)
PAGES_SLOW = (0.3016, -0.1244, -0.4561, -0.01862, -0.03106, -0.4446)
PAGES_FAST = (0.5945, -0.2008, -0.09255, 0.1306, -0.0288, 0)
PAGES_NONE = (-2.041, -1.813)
PAGES_AROUND = (0, 0)
PAGES_UNCLAIMED_SLOW = (0, -0.1987, -0.491, -0.0658, 0.001723, -1.418)
PAGES_UNCLAIMED_FAST = (2.236e-05, -0.3598, -0.3276, -0.05819, 0.07053, -0.5739)
PAGES_UNCLAIMED_NONE = (-2.091, -0.8464)
PAGES_UNCLAIMED_AROUND = (0, 0)
"""The same for pages, as cards, links and menus are laid out, by ``python -m evidence intent fit``."""
