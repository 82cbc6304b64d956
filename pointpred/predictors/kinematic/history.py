"""Past cursor positions on a grid of equal times, independent of the sampling rate."""

from __future__ import annotations

from math import floor, hypot
from typing import NamedTuple

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.stage import offsets

TICK_S = 0.008
TICKS = 66
"""Ticks remembered: the longest lag of half a second, and the two that a position between ticks needs."""
STILL_GAP_S = 0.1
"""Between events farther apart the device was still: the cursor jumped at the end."""

# State, relative to `at`: how many ticks have been; place and path of the last; then x, y, path of each tick.
COUNT, LAST_X, LAST_Y, LAST_PATH, RING, STATES = offsets(1, 1, 1, 1, 3 * TICKS)
HEAD = RING


class Point(NamedTuple):
    """Where the cursor is: ``t`` s since the movement's start, ``x y`` px from it, ``path`` px travelled."""

    t: float
    x: float
    y: float
    path: float


@law
def begin(memory: FloatArray, at: int) -> None:
    """Remember the start: tick 0 is the origin."""
    memory[at + COUNT] = 1.0
    memory[at + LAST_X : at + RING + 3] = 0.0


@law
def extend(
    memory: FloatArray, at: int, last: tuple[float, float, float], now: tuple[float, float, float]
) -> Point:
    """Fill the ticks after the last one up to now, on the line from the last event (t, x, y) to this one.

    At most as many as there are places. Returns where the cursor is, with the path over the ticks.
    """
    last_t, last_x, last_y = last
    t, x, y = now
    count = int(memory[at + COUNT])
    newest = floor(t / TICK_S)
    old_x, old_y, path = memory[at + LAST_X], memory[at + LAST_Y], memory[at + LAST_PATH]
    for tick in range(max(count, newest + 1 - TICKS), newest + 1):
        share = 0.0
        if t - last_t <= STILL_GAP_S:
            share = min(max((tick * TICK_S - last_t) / (t - last_t), 0.0), 1.0)
        new_x, new_y = last_x + share * (x - last_x), last_y + share * (y - last_y)
        path += hypot(new_x - old_x, new_y - old_y)
        slot = at + RING + 3 * (tick % TICKS)
        memory[slot], memory[slot + 1], memory[slot + 2] = new_x, new_y, path
        old_x, old_y = new_x, new_y
    memory[at + COUNT] = max(count, newest + 1)
    memory[at + LAST_X], memory[at + LAST_Y], memory[at + LAST_PATH] = old_x, old_y, path
    return Point(t, x, y, path + hypot(x - old_x, y - old_y))


@law
def past(memory: FloatArray, at: int, now: Point, ago: float) -> tuple[float, float, float]:
    """Place and path ``ago`` seconds before now: between two ticks on a line, the start before it."""
    then = now.t - ago
    if then <= 0.0:
        return 0.0, 0.0, 0.0
    count = int(memory[at + COUNT])
    tick = floor(then / TICK_S)
    if tick > count - 1:
        return now.x, now.y, now.path
    slot = at + RING + 3 * (tick % TICKS)
    if tick == count - 1:
        span = now.t - tick * TICK_S
        share = (then - tick * TICK_S) / span if span > 0.0 else 1.0
        after_x, after_y, after_path = now.x, now.y, now.path
    else:
        share = (then - tick * TICK_S) / TICK_S
        after = at + RING + 3 * ((tick + 1) % TICKS)
        after_x, after_y, after_path = memory[after], memory[after + 1], memory[after + 2]
    return (
        memory[slot] + share * (after_x - memory[slot]),
        memory[slot + 1] + share * (after_y - memory[slot + 1]),
        memory[slot + 2] + share * (after_path - memory[slot + 2]),
    )
