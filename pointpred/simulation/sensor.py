"""The mouse's sensor and the screen: counts at each poll, whole pixels through the transfer function."""

from __future__ import annotations

from math import hypot, trunc

import numpy as np

from pointpred.compiled import law
from pointpred.records import BoolArray, EventColumns, FloatArray
from pointpred.simulation import slots
from pointpred.transfer import assistance, functions, pixels

MEAN_LATE_S = 60e-6
MOST_LATE_S = 0.8e-3
"""Largest delay of a stamp after its poll, s; delays are exponential with mean ``MEAN_LATE_S``."""
STAMP_S = 2.0**-17
"""Stamps are whole ticks of a clock at 131072 Hz (7.6 us): exact as floats, and small in a file."""


@law
def count(position_m: float, metres_per_count: float, counted: float) -> float:
    """Whole counts an axis has moved since the last report; the remainder carries over."""
    return float(trunc(position_m / metres_per_count - counted))


@law
def assist(memory: FloatArray, own_px: float, hat_x: float, hat_y: float) -> tuple[float, float]:
    """The pull of the assisted transfer function over one report period, px; 0 without an estimate."""
    off_x, off_y = hat_x - memory[slots.X], hat_y - memory[slots.Y]
    rho, strength = memory[slots.RHO], memory[slots.STRENGTH]
    share = assistance.pull(rho, strength, memory[slots.PERIOD_S], own_px, off_x, off_y)
    return (share * off_x, share * off_y) if share > 0.0 else (0.0, 0.0)


@law
def report(memory: FloatArray, hat_x: float, hat_y: float) -> tuple[float, float]:
    """Poll the sensor: the counts of both axes; the cursor moves by whole pixels.

    With an estimate of the endpoint the cursor is pulled to it (Remark 2.2.1).
    """
    unit = memory[slots.METRES_PER_COUNT]
    dx = count(memory[slots.U], unit, memory[slots.COUNTED_X])
    dy = count(memory[slots.V], unit, memory[slots.COUNTED_Y])
    memory[slots.COUNTED_X] += dx
    memory[slots.COUNTED_Y] += dy
    gain = functions.gain(memory, slots.FUNCTION, hypot(dx, dy) * unit / memory[slots.PERIOD_S])
    scale = gain * memory[slots.PX_PER_METRE] * unit
    pull_x, pull_y = assist(memory, scale * hypot(dx, dy), hat_x, hat_y)
    memory[slots.X] += pixels.carry(memory, slots.CARRY, scale * dx)
    memory[slots.Y] += pixels.carry(memory, slots.CARRY + 1, scale * dy)
    # A common fraction would be dropped at every poll in which the hand moves against the pull.
    memory[slots.X] += pixels.carry(memory, slots.PULLED, pull_x)
    memory[slots.Y] += pixels.carry(memory, slots.PULLED + 1, pull_y)
    return dx, dy


def lateness(generator: np.random.Generator, reports: int) -> FloatArray:
    """How late each report is stamped (s): exponential, bounded."""
    return np.asarray(np.minimum(generator.exponential(MEAN_LATE_S, reports), MOST_LATE_S))


def reported(polls: FloatArray, idle_reports: bool) -> EventColumns:
    """The polls that make an event: the first, motion, a change of a button; all with ``idle_reports``."""
    table = polls.copy()
    table[:, 0] = np.round(table[:, 0] / STAMP_S) * STAMP_S
    if idle_reports:
        return EventColumns(table)
    events: BoolArray = (table[:, 3] != 0.0) | (table[:, 4] != 0.0)
    events[1:] |= np.diff(table[:, 5]) != 0.0
    events[:1] = True
    return EventColumns(table[events])
