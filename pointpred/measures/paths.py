"""Measures of the shape of one path, whatever its speed. Positions are px, y grows downwards."""

from __future__ import annotations

from math import hypot, inf, log, nan
from typing import NamedTuple

import numpy as np

from pointpred.records import FloatArray, IntArray

STEPS = 101
"""Positions of a time-normalised path."""
OFF_AXIS_PX, TURN_PX = 5.0, 10.0
"""MacKenzie's software counts crossings of the task axis from so far off it, and turns of so far."""
WINDOW, LAG = 2, 3
"""Sample entropy compares windows of two values, each third of the series, as mousetrap does."""


def reversals(values: FloatArray, least: float = 0.0) -> IntArray:
    """Where values turn: the indices of highest and lowest values between moves of more than ``least``.

    They are the extremes that stay when topological persistence removes those of at most ``least``.

    >>> reversals(np.array([0.0, 5.0, 4.0, 9.0, 1.0])).tolist()
    [1, 2, 3]
    >>> reversals(np.array([0.0, 5.0, 4.0, 9.0, 1.0]), 2.0).tolist()
    [3]
    """
    steps = np.diff(values)
    moving = np.flatnonzero(steps)
    turned = np.diff(np.sign(steps[moving])) != 0
    turns: IntArray = moving[1:][turned].astype(np.int64)
    if least <= 0.0 or not len(turns):
        return turns
    found: list[int] = []
    rising, falling, low, high = True, True, 0, 0  # both until the first move
    for at in (*turns.tolist(), len(values) - 1):
        value = values[at]
        if rising and value > values[high]:
            high = at
        if falling and value < values[low]:
            low = at
        if rising and values[high] - value > least:
            found += [] if falling else [high]
            rising, falling, low = False, True, at
        elif falling and value - values[low] > least:
            found += [] if rising else [low]
            rising, falling, high = True, False, at
    return np.array(found, dtype=np.int64)


def flips(positions: FloatArray) -> int:
    """How often the direction along one axis changes; samples that rest are passed over.

    Reference: Freeman and Ambady 2010, MouseTracker; as ``x_flips`` of mousetrap without a threshold.
    """
    return len(reversals(positions))


def deviations(x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Of each sample the way along the straight line from start to end, and the distance from it, px.

    The distance is positive above the line where the path ends higher than it starts, and below it where it
    ends lower, as mousetrap has it. NaN where start and end are one.
    """
    dx, dy = float(x[-1] - x[0]), float(y[-1] - y[0])
    length = hypot(dx, dy)
    if length == 0.0:
        return np.full(len(x), nan), np.full(len(x), nan)
    along = ((x - x[0]) * dx + (y - y[0]) * dy) / length
    right = ((y - y[0]) * dx - (x - x[0]) * dy) / length
    return along, right if (dx < 0.0) != (dy > 0.0) else -right


def maximum_deviation(deviation: FloatArray) -> float:
    """The deviation from the straight line that is largest in magnitude, with its sign, px (MAD).

    Reference: Freeman and Ambady 2010; Kieslich et al. 2019, mousetrap: ``MAD``.
    """
    return float(deviation[np.argmax(np.abs(deviation))])


def area_under_curve(along: FloatArray, deviation: FloatArray) -> float:
    """The area between path and straight line, px²; areas of opposite sides cancel (AUC).

    Reference: Freeman and Ambady 2010; Kieslich et al. 2019, mousetrap: ``AUC``.
    """
    return float(np.trapezoid(deviation, along))


def time_normalised(t: FloatArray, x: FloatArray, y: FloatArray, steps: int = STEPS) -> FloatArray:
    """A path at equal steps of time, by linear interpolation: (steps, 3), t s, x and y px.

    Reference: Spivey, Grosjean and Knoblich 2005; 101 steps as MouseTracker and mousetrap.

    >>> time_normalised(np.array([0.0, 1.0, 3.0]), np.array([0.0, 4.0, 8.0]), np.zeros(3), 4)[:, 1].tolist()
    [0.0, 4.0, 6.0, 8.0]
    """
    times = np.linspace(t[0], t[-1], steps)
    return np.column_stack([times, np.interp(times, t, x), np.interp(times, t, y)])


def sample_entropy(values: FloatArray, tolerance: float) -> float:
    """How irregular a series is, nats: -log of the chance that similar windows stay similar.

    ``values``: the steps between positions of a time-normalised path, of which each third is used, in
    windows of two. ``tolerance``: two windows are similar if they differ by less at each place. Infinite
    where none stays similar, NaN where none is.

    Reference: Dale, Kehoe and Spivey 2007; Hehman, Stolier and Freeman 2015; as ``mt_sample_entropy`` of
    mousetrap computes it by pracma, which leaves the last pair out of the longer windows.
    """
    series = values[::LAG]
    count = len(series) - WINDOW
    if count < 2:
        return nan
    apart = np.abs(series[:, None] - series[None, :])
    shorter = np.maximum(apart[:count, :count], apart[1 : count + 1, 1 : count + 1])
    longer = np.maximum(shorter, apart[2 : count + 2, 2 : count + 2])
    before, after = np.triu_indices(count, 1)
    similar = int(np.count_nonzero(shorter[before, after] < tolerance))
    still = int(np.count_nonzero(longer[before[:-1], after[:-1]] < tolerance))
    if not similar:
        return nan
    return log(similar / still) if still else inf


class Accuracy(NamedTuple):
    """The seven measures of MacKenzie, Kauppinen and Silfverberg 2001, of one path to one target."""

    tre: int
    """Target re-entries: how often the path enters the target after it had been inside."""
    tac: int
    """Task axis crossings: how often it changes from one side of the axis to the other, 5 px off it."""
    mdc: int
    """Movement direction changes: turns of the distance from the axis, by more than 10 px."""
    odc: int
    """Orthogonal direction changes: turns of the way along the axis, by more than 10 px."""
    mv_px: float
    """Movement variability: standard deviation of the distance from the axis, with n - 1."""
    me_px: float
    """Movement error: mean of its magnitude."""
    mo_px: float
    """Movement offset: its mean; positive to the right of the axis as seen on the way to the target."""


def accuracy(
    x: FloatArray,
    y: FloatArray,
    source: tuple[float, float],
    target: tuple[float, float],
    width: float,
    *,
    off_axis_px: float = OFF_AXIS_PX,
    turn_px: float = TURN_PX,
) -> Accuracy:
    """How a path went along the task axis, from ``source`` to the centre of a round target of ``width``.

    The paper has no thresholds; they are those of MacKenzie's own software (AccuracyMeasures, GoFitts), and
    0 does without. That software leaves single and double samples out of TRE, MDC and ODC, which depends on
    how often a device reports, and rounds positions.

    Reference: MacKenzie, Kauppinen and Silfverberg 2001, Accuracy measures for evaluating computer pointing
    devices. ``source`` must differ from ``target``.
    """
    length = hypot(target[0] - source[0], target[1] - source[1])
    ux, uy = (target[0] - source[0]) / length, (target[1] - source[1]) / length
    along = (x - source[0]) * ux + (y - source[1]) * uy
    off = (y - source[1]) * ux - (x - source[0]) * uy
    inside = np.hypot(x - target[0], y - target[1]) <= width / 2.0
    entries = int(np.count_nonzero(inside[1:] & ~inside[:-1]))
    sides = np.sign(off[np.abs(off) > off_axis_px])
    return Accuracy(
        max(0, entries - int(not inside[0])),
        int(np.count_nonzero(np.diff(sides))),
        len(reversals(off, turn_px)),
        len(reversals(along, turn_px)),
        float(np.std(off, ddof=1)) if len(off) > 1 else nan,
        float(np.mean(np.abs(off))),
        float(np.mean(off)),
    )
