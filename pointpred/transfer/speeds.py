"""Pairs of speeds (V_m, V_c) for identification: by Euler differences or by any differentiator."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from pointpred.errors import EventError, ParameterError
from pointpred.records import METRES_PER_INCH, EventColumns, FloatArray, MotionColumns


class Differentiating(Protocol):
    """The interface of a differentiator used here."""

    def run(self, events: EventColumns) -> MotionColumns:
        """A motion for each event."""
        ...


def euler_speeds(
    events: EventColumns, *, cpi: float, dpi: float = 96.0, window_s: float = 0.02
) -> tuple[FloatArray, FloatArray]:
    """The speeds of hand and cursor in m/s by Euler differences over windows of at least ``window_s``.

    Assumes one trial with counts. Over single reports the rounding to whole pixels dominates, and a rounded
    step is on average longer than the step, so a window near 0 overestimates the speed.

    V_c = sqrt(dx^2 + dy^2) / h, corrected: the printed difference of sqrt(x^2 + y^2), the distance from the
    screen's corner, is not a speed (it is 0 for a movement around the corner).

    Returns (V_m, V_c), one pair a window. Raises EventError without counts and ParameterError.
    Reference: Khalin 2022, section 2.4.1, corrected.

    >>> events = EventColumns.of([0.0, 0.1], [0.0, 3.0], [0.0, 4.0], [0, 30], [0, 40])
    >>> motor, cursor = euler_speeds(events, cpi=1000.0, dpi=100.0)
    >>> float(motor[0].round(6)), float(cursor[0].round(6))  # 0.05 inch and 0.05 inch in 0.1 s
    (0.0127, 0.0127)
    """
    if not (window_s >= 0.0 and cpi > 0.0 and dpi > 0.0):
        raise ParameterError(
            f"window_s must be >= 0 s, cpi and dpi above 0, received {window_s!r}, {cpi!r}, {dpi!r}",
            field="window_s",
        )
    counts = events.table[:, 3:5]
    if np.isnan(counts).any():
        raise EventError("events need counts to tell the speed of the hand")
    rows = _edges(events.t, window_s)
    h = np.diff(events.t[rows])
    path = np.diff(np.cumsum(counts, axis=0)[rows], axis=0) * (METRES_PER_INCH / cpi)
    way = np.diff(events.table[rows, 1:3], axis=0) * (METRES_PER_INCH / dpi)
    return np.hypot(path[:, 0], path[:, 1]) / h, np.hypot(way[:, 0], way[:, 1]) / h


def differentiated_speeds(
    events: EventColumns, motor: Differentiating, cursor: Differentiating, *, spacing_s: float = 0.02
) -> tuple[FloatArray, FloatArray]:
    """The speeds of hand and cursor in m/s, each by a differentiator, thinned to one pair per ``spacing_s``.

    Assumes one trial. ``motor`` is built with the device's cpi, so that it follows the counts; ``cursor``
    without, so that it follows the path on the screen. The same law and gains delay both equally; but a
    curved transfer function of a smoothed speed is not the smoothed function.

    Returns (V_m, V_c) where both have settled.
    Reference: Khalin 2022, section 2.4.1.
    """
    hand, screen = motor.run(events), cursor.run(EventColumns.of(events.t, events.x, events.y))
    settled = (hand.settled == 1.0) & (screen.settled == 1.0)
    rows = _edges(events.t, spacing_s)
    rows = rows[settled[rows]]
    return np.hypot(hand.vx, hand.vy)[rows], np.hypot(screen.vx, screen.vy)[rows]


def _edges(t: FloatArray, spacing_s: float) -> np.ndarray[tuple[int], np.dtype[np.intp]]:
    """Rows that lie at least ``spacing_s`` after each other, and later than each other."""
    rows = [0]
    for row in range(1, len(t)):
        if t[row] - t[rows[-1]] >= spacing_s and t[row] > t[rows[-1]]:
            rows.append(row)
    return np.array(rows[: len(t)], np.intp)
