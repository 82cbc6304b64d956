"""Velocity and acceleration by somebody who sees ahead: what no differentiator can be."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.ndimage import gaussian_filter1d

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.records import METRES_PER_INCH, EventColumns, FloatArray, MotionRow

SMOOTH_S = 0.008
"""Standard deviation of the weights, so that 20 ms ahead count."""
STEP_S = 0.0005
VX, VY, AX, AY = (MotionRow._fields.index(name) for name in ("vx", "vy", "ax", "ay"))


class Smoother(HomogeneousDifferentiator):
    """The path of the counts, smoothed to both sides and differentiated; the rest is that of its parent.

    For whole trials only, each of which begins with a row marked ``begin``.
    """

    def walk_events(self, events: EventColumns) -> FloatArray:
        """The motions of whole trials."""
        table = super().walk_events(events)
        begins = [*events.begin.nonzero()[0].tolist(), len(events)]
        for first, stop in pairwise(begins):
            t = events.t[first:stop]
            grid = np.arange(t[0], t[-1] + STEP_S, STEP_S)
            for counts, speed, push in ((events.dx, VX, AX), (events.dy, VY, AY)):
                place = (
                    np.cumsum(np.nan_to_num(counts[first:stop])) * METRES_PER_INCH / float(self.cpi or 0.0)
                )
                path = np.interp(grid, t, place)
                for column, order in ((speed, 1), (push, 2)):
                    smooth = gaussian_filter1d(path, SMOOTH_S / STEP_S, order=order, mode="nearest")
                    table[first:stop, column] = np.interp(t, grid, smooth / STEP_S**order)
        return table
