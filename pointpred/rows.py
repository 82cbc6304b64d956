"""A record as a row of floats, and back: the one place where both are written down.

Laws, tables and binary frames hold rows; users hold the records of ``events``. What a record leaves out as
``None`` is NaN in a row. A law takes a row as a plain tuple and names its parts by one of the classes here.
"""

from __future__ import annotations

from math import nan
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from pointpred.compiled import law
from pointpred.records import PHASES, Motion, PointerEvent, Prediction


class EventRow(NamedTuple):
    """A ``PointerEvent``: ``t`` s, ``x y`` px, ``dx dy`` counts or NaN, ``buttons`` as a whole number."""

    t: float
    x: float
    y: float
    dx: float
    dy: float
    buttons: float


class MotionRow(NamedTuple):
    """A ``Motion``: ``t`` s, ``x y`` px, ``vx vy`` m/s, ``ax ay`` m/s^2; the last three are 0 or 1."""

    t: float
    x: float
    y: float
    vx: float
    vy: float
    ax: float
    ay: float
    settled: float
    start: float
    counts: float


class PredictionRow(NamedTuple):
    """A ``Prediction``: ``x y`` px, ``sxx sxy syy`` px^2, ``remaining_s`` s, ``phase`` as in ``PHASES``.

    ``x`` is NaN where nothing is justified, ``t`` is NaN where the row before it was refused.
    """

    t: float
    x: float
    y: float
    sxx: float
    sxy: float
    syy: float
    remaining_s: float
    phase: float
    tail: float
    remaining_spread: float


Row = tuple[float, ...]
"""A row as laws hand it on: building a named one for Python would cost a law a microsecond."""
SixFloats = tuple[float, float, float, float, float, float]
TenFloats = tuple[float, float, float, float, float, float, float, float, float, float]

REFUSED: TenFloats = (nan, nan, nan, nan, nan, nan, nan, nan, nan, nan)
"""The answer of a law to a row that it refuses; its memory is then unchanged."""


@law
def event_at(table: npt.NDArray[np.float64], i: int) -> SixFloats:
    """A row of a table of events as a tuple."""
    r = table[i]
    return r[0], r[1], r[2], r[3], r[4], r[5]


@law
def row_at(table: npt.NDArray[np.float64], i: int) -> TenFloats:
    """A row of a table of motions or of predictions as a tuple."""
    r = table[i]
    return r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], r[9]


@law
def endpoint(t: float, x: float, y: float, phase: float) -> TenFloats:
    """The row of a prediction that claims an endpoint and nothing else; ``x`` is NaN where it claims none."""
    return t, x, y, nan, nan, nan, nan, phase, nan, nan


def event_row(event: PointerEvent) -> SixFloats:
    """The row of an event."""
    dx, dy = event.dx, event.dy
    return (
        float(event.t),
        float(event.x),
        float(event.y),
        nan if dx is None else float(dx),
        nan if dy is None else float(dy),
        float(event.buttons),
    )


def event_of(row: Row) -> PointerEvent:
    """The event of a row."""
    t, x, y, dx, dy, buttons = row
    return PointerEvent(t, x, y, dx if dx == dx else None, dy if dy == dy else None, int(buttons))


def motion_row(motion: Motion) -> TenFloats:
    """The row of a motion."""
    speeds = float(motion.vx), float(motion.vy), float(motion.ax), float(motion.ay)
    marks = float(motion.settled), float(motion.start), float(motion.counts)
    return float(motion.t), float(motion.x), float(motion.y), *speeds, *marks


def motion_of(row: Row) -> Motion:
    """The motion of a row."""
    t, x, y, vx, vy, ax, ay, settled, start, counts = row
    return Motion(t, x, y, vx, vy, ax, ay, bool(settled), bool(start), bool(counts))


def prediction_row(prediction: Prediction | None, t: float = nan) -> TenFloats:
    """The row of a prediction; of ``None``, at ``t`` s, one that holds nothing else."""
    if prediction is None:
        return t, nan, nan, nan, nan, nan, nan, nan, nan, nan
    sxx, sxy, syy = (nan, nan, nan) if prediction.scale is None else prediction.scale
    left, tail, spread = prediction.remaining_s, prediction.tail, prediction.remaining_spread
    return (
        float(prediction.t),
        float(prediction.x),
        float(prediction.y),
        float(sxx),
        float(sxy),
        float(syy),
        nan if left is None else float(left),
        float(PHASES.index(prediction.phase)),
        nan if tail is None else float(tail),
        nan if spread is None else float(spread),
    )


def prediction_of(row: Row) -> Prediction | None:
    """The prediction of a row; ``None`` where it claims no endpoint."""
    t, x, y, sxx, sxy, syy, remaining_s, phase, tail, spread = row
    if x != x:
        return None
    return Prediction(
        t,
        x,
        y,
        (sxx, sxy, syy) if sxx == sxx else None,
        PHASES[int(phase)],
        remaining_s if remaining_s == remaining_s else None,
        tail if tail == tail else None,
        spread if spread == spread else None,
    )
