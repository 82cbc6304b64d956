"""Moments of a movement, about evenly spread over it however long it lasts, in a fixed number of places.

When all places are taken, every second moment is dropped and their distance in time doubles.
"""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import ROUNDING_S

APART_S = 0.0071
"""Distance of the moments at first."""
NEAR_PX, NEAR_SHARE = 8.0, 0.03
"""The movement has arrived when the cursor stays so near its end: px, share of the distance."""
SAMPLES_LEAST, LEAST_S = 6, 0.08
"""A movement of fewer samples of different times, or shorter, teaches nothing."""
SHORTEST_PX = 1e-6
"""A shorter distance is none, whatever is set: its logarithm is taken."""


class Series(Layout):
    """How many moments there are, their distance in s, the cursor at the last in px; the moments follow."""

    count: float
    apart: float
    cursor_x: float
    cursor_y: float


@law
def next_moment(s: Series, last_t: float, cursor: tuple[float, float, float], most: int) -> tuple[int, bool]:
    """The number of the moment that a cursor (t, x, y) is written to, -1 for none; whether to thin out first.

    Thinning out moves moment 2 k to k, for each k below that number. Of one time the last is remembered. A
    cursor that stands makes no other moment drop out, however long it stands. ``last_t``: the time of the
    last moment, if there is one; ``most``: moments that are remembered.
    """
    t, x, y = cursor
    count, full = int(s.count), False
    if count == 0 or t != last_t:
        if count == 0:
            s.apart = APART_S
        elif t - last_t < s.apart:
            return -1, False
        if count == most:
            if x == s.cursor_x and y == s.cursor_y:
                return -1, False
            count, full = most // 2, True
            s.apart *= 2.0
        count += 1
        s.count = count
    s.cursor_x, s.cursor_y = x, y
    return count - 1, full


@law
def has_come(s: Series, t: float, span: tuple[float, float], share: float) -> bool:
    """Whether a moment at ``t`` lies before a share of the time between the start and the end in s."""
    start, end = span
    return t - start <= share * (end - start) + ROUNDING_S + 0.5 * s.apart
