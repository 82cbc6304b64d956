"""How long a screen takes to move its cursor: the shift at which cursor and counts agree best."""

from __future__ import annotations

import numpy as np

from pointpred.errors import EventError, ParameterError
from pointpred.records import EventColumns, FloatArray

STEP_S, SPAN_S, GAP_S = 0.001, 0.01, 0.1
LEAST = 200
"""Fewer steps of motion than these say nothing."""


def estimate_delay(events: EventColumns, *, most_s: float = 0.1) -> float:
    """The time in s by which the cursor follows the counts, for ``Pairing(delay_s=...)``.

    Assumes one delay throughout, and movements that start, stop and turn; a steady motion looks alike at
    every shift. A transfer function that bends hardly matters: only the shape over time is compared. The
    screen's edge and whatever else moves the cursor mislead.

    The shift d in [0, ``most_s``] with the greatest sum, over stretches without a pause of 0.1 s, of
    (x(t) - x(t - 10 ms)) times the counts between t - d - 10 ms and t - d; refined by a parabola.

    Returns seconds, a step of 1 ms refined. Raises EventError where events have no counts or hold less than
    0.2 s of motion, ParameterError for a ``most_s`` outside [0.001, 1].

    >>> t = np.arange(0.0, 2.0, 0.001)
    >>> hand = 300.0 * (1.0 - np.cos(3.0 * np.pi * t))
    >>> late = np.interp(t - 0.007, t, hand)
    >>> counts = np.diff(hand, prepend=0.0)
    >>> round(estimate_delay(EventColumns.of(t, 2.0 * late, 0.0 * t, counts, 0.0 * t)), 4)
    0.007
    """
    if not STEP_S <= most_s <= 1.0:
        raise ParameterError(f"most_s must lie in [{STEP_S:g}, 1] s, received {most_s!r}")
    if np.isnan(events.table[:, 3:5]).any():
        raise EventError("events need counts to tell how the cursor follows them")
    shifts = round(most_s / STEP_S) + 1
    products, moved = np.zeros(shifts), 0
    ends = np.flatnonzero(np.diff(events.t) > GAP_S) + 1
    for rows in np.split(np.arange(len(events)), ends):
        cursor, counts = _steps(events.table[rows], shifts)
        moved += int((np.abs(counts).sum(axis=1) > 0.0).sum())
        for shift in range(min(shifts, len(counts))):
            products[shift] += float(np.sum(cursor[shift:] * counts[: len(counts) - shift]))
    if moved < LEAST:
        raise EventError(
            f"events need {LEAST * STEP_S:g} s of motion between pauses, received {moved * STEP_S:g} s"
        )
    return _peak(products) * STEP_S


def _steps(table: FloatArray, after: int) -> tuple[FloatArray, FloatArray]:
    """Displacements over 10 ms of cursor and counts on a grid of 1 ms; before and ``after`` all is still."""
    if len(table) < 2:
        return np.zeros((0, 2)), np.zeros((0, 2))
    paths = np.column_stack([table[:, 1:3], np.cumsum(table[:, 3:5], axis=0)])
    last = np.append(np.diff(table[:, 0]) > 0.0, True)
    t, paths = table[last, 0], paths[last]
    span = round(SPAN_S / STEP_S)
    grid = np.arange(-span, (t[-1] - t[0]) / STEP_S + after) * STEP_S + t[0]
    even = np.column_stack([np.interp(grid, t, path) for path in paths.T])
    steps = even[span:] - even[:-span]
    return steps[:, :2], steps[:, 2:]


def _peak(curve: FloatArray) -> float:
    """Where a curve is greatest, between its points by a parabola through the three around it."""
    top = int(curve.argmax())
    if not 0 < top < len(curve) - 1:
        return float(top)
    before, at, after = curve[top - 1 : top + 2].tolist()
    bend = before - 2.0 * at + after
    return top if bend == 0.0 else top + 0.5 * (before - after) / bend
