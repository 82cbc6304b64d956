"""Where the cursor was: positions on a grid of equal times, so that the sampling rate leaves no trace."""

from __future__ import annotations

from math import floor, hypot

from pointpred.columns import FloatArray
from pointpred.compiled import law

TICK_S = 0.008
KEPT = 66
"""Ticks kept: the longest lag of half a second, and the two that a position between ticks needs."""
STILL_GAP_S = 0.1
"""Between events farther apart the device was still: the cursor jumped at the end."""

# State, relative to `at`: how many ticks have been; place and path of the last; then x, y, path of each kept.
COUNT, LAST_X, LAST_Y, LAST_PATH, RING = 0, 1, 2, 3, 4
HEAD = RING
STATES = RING + 3 * KEPT


@law
def begin(memory: FloatArray, at: int) -> None:
    """Remember the start: tick 0 is the origin."""
    memory[at + COUNT] = 1.0
    memory[at + LAST_X : at + RING + 3] = 0.0


@law
def extend(
    memory: FloatArray, at: int, since: float, last_x: float, last_y: float, t: float, x: float, y: float
) -> None:
    """Fill the ticks after the last one up to ``t``, on the line from the last event's place to (x, y).

    At most as many as are kept; ``since`` is the time of the last event, all relative to the start.
    """
    count = int(memory[at + COUNT])
    last = floor(t / TICK_S)
    old_x, old_y, path = memory[at + LAST_X], memory[at + LAST_Y], memory[at + LAST_PATH]
    for tick in range(max(count, last + 1 - KEPT), last + 1):
        share = 0.0
        if t - since <= STILL_GAP_S:
            share = min(max((tick * TICK_S - since) / (t - since), 0.0), 1.0)
        new_x, new_y = last_x + share * (x - last_x), last_y + share * (y - last_y)
        path += hypot(new_x - old_x, new_y - old_y)
        slot = at + RING + 3 * (tick % KEPT)
        memory[slot], memory[slot + 1], memory[slot + 2] = new_x, new_y, path
        old_x, old_y = new_x, new_y
    memory[at + COUNT] = max(count, last + 1)
    memory[at + LAST_X], memory[at + LAST_Y], memory[at + LAST_PATH] = old_x, old_y, path


@law
def travelled(memory: FloatArray, at: int, x: float, y: float) -> float:
    """Path in px from the start over the ticks to (x, y)."""
    return float(memory[at + LAST_PATH] + hypot(x - memory[at + LAST_X], y - memory[at + LAST_Y]))


@law
def past(
    memory: FloatArray, at: int, t: float, x: float, y: float, path: float, ago: float
) -> tuple[float, float, float]:
    """Place and path ``ago`` seconds before ``t``: between two ticks on a line, the start before it."""
    then = t - ago
    if then <= 0.0:
        return 0.0, 0.0, 0.0
    count = int(memory[at + COUNT])
    tick = floor(then / TICK_S)
    if tick > count - 1:
        return x, y, path
    slot = at + RING + 3 * (tick % KEPT)
    if tick == count - 1:
        span = t - tick * TICK_S
        share = (then - tick * TICK_S) / span if span > 0.0 else 1.0
        after_x, after_y, after_path = x, y, path
    else:
        share = (then - tick * TICK_S) / TICK_S
        after = at + RING + 3 * ((tick + 1) % KEPT)
        after_x, after_y, after_path = memory[after], memory[after + 1], memory[after + 2]
    return (
        memory[slot] + share * (after_x - memory[slot]),
        memory[slot + 1] + share * (after_y - memory[slot + 1]),
        memory[slot + 2] + share * (after_path - memory[slot + 2]),
    )
