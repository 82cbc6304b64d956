"""Coefficients of the evidence, fitted by ``python -m evidence intent targets``; not to be edited by hand."""

from __future__ import annotations

SLOW = (0, -0.2953, -0.5472, -1.49, 0.01136, -1.019)
"""Of each feature while the cursor stands."""
FAST = (0.6085, -0.4512, -0.326, -0.2933, 0.1657, -0.05681)
"""Of each feature at the peak of the speed; between the two they change in proportion."""
NONE = (-0.3788, -1.403)
AROUND = (0.4075, 0.8281)
"""Of *none of them*, and of what falls to all targets, standing and at the peak."""
UNCLAIMED_SLOW = (0, -0.2782, -0.517, -2.055, 0.0877, -0.3149)
UNCLAIMED_FAST = (0.0003341, -0.547, -0.4361, -0.7146, 0.3147, -0.2426)
UNCLAIMED_NONE = (-0.6077, -1.204)
UNCLAIMED_AROUND = (-0.1719, 0.1326)
"""The same where the predictor claims no region."""
NEAREST = (-2.612, -0.6827)
"""Of the feature NEAR alone, standing and at the peak, for the nearest target to the cursor."""
NEAREST_NONE = (-5.491, 0.02083)
PAGES_SLOW = (0.3016, -0.1244, -0.4561, -0.01862, -0.03106, -0.4446)
PAGES_FAST = (0.5945, -0.2008, -0.09255, 0.1306, -0.0288, 0)
PAGES_NONE = (-2.041, -1.813)
PAGES_AROUND = (0, 0)
PAGES_UNCLAIMED_SLOW = (0, -0.1987, -0.491, -0.0658, 0.001723, -1.418)
PAGES_UNCLAIMED_FAST = (2.236e-05, -0.3598, -0.3276, -0.05819, 0.07053, -0.5739)
PAGES_UNCLAIMED_NONE = (-2.091, -0.8464)
PAGES_UNCLAIMED_AROUND = (0, 0)
"""The same for pages, as cards, links and menus are laid out, by ``python -m evidence intent fit``."""
