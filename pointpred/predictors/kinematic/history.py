"""Past cursor positions on a grid of equal times, independent of the sampling rate."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, hypot
from typing import Annotated, NamedTuple

from pointpred.compiled import law
from pointpred.layout import Layout, clear

TICK_S = 0.008
TICKS = 66
"""Ticks remembered: the longest lag of half a second, and the two that a position between ticks needs."""
STILL_GAP_S = 0.1
"""Between events farther apart the device was still: the cursor jumped at the end."""


class Tick(Layout):
    """Place in px from the movement's start, and the path over the ticks up to here in px."""

    x: float
    y: float
    path: float


class Head(Layout):
    """How many ticks have been, and the last of them."""

    count: float
    last: Tick


class State(Layout):
    """The last ticks: that of number n stands at n modulo TICKS."""

    head: Head
    ticks: Annotated[Sequence[Tick], TICKS]


class Point(NamedTuple):
    """Where the cursor is: ``t`` s since the movement's start, ``x y`` px from it, ``path`` px travelled."""

    t: float
    x: float
    y: float
    path: float


@law
def begin(s: State) -> None:
    """Remember the start: tick 0 is the origin."""
    s.head.count = 1.0
    clear(s.head.last)
    clear(s.ticks[0])


@law
def extend(s: State, last: tuple[float, float, float], now: tuple[float, float, float]) -> Point:
    """Fill the ticks after the last one up to now, on the line from the last event (t, x, y) to this one.

    At most as many as there are places. Returns where the cursor is, with the path over the ticks.
    """
    last_t, last_x, last_y = last
    t, x, y = now
    count = int(s.head.count)
    newest = floor(t / TICK_S)
    old = s.head.last
    for number in range(max(count, newest + 1 - TICKS), newest + 1):
        share = 0.0
        if t - last_t <= STILL_GAP_S:
            share = min(max((number * TICK_S - last_t) / (t - last_t), 0.0), 1.0)
        tick = s.ticks[number % TICKS]
        tick.x, tick.y = last_x + share * (x - last_x), last_y + share * (y - last_y)
        old.path += hypot(tick.x - old.x, tick.y - old.y)
        tick.path = old.path
        old.x, old.y = tick.x, tick.y
    s.head.count = max(count, newest + 1)
    return Point(t, x, y, old.path + hypot(x - old.x, y - old.y))


@law
def past(s: State, now: Point, ago: float) -> tuple[float, float, float]:
    """Place and path ``ago`` seconds before now: between two ticks on a line, the start before it."""
    then = now.t - ago
    if then <= 0.0:
        return 0.0, 0.0, 0.0
    count = int(s.head.count)
    number = floor(then / TICK_S)
    if number > count - 1:
        return now.x, now.y, now.path
    before = s.ticks[number % TICKS]
    if number == count - 1:
        span = now.t - number * TICK_S
        share = (then - number * TICK_S) / span if span > 0.0 else 1.0
        after_x, after_y, after_path = now.x, now.y, now.path
    else:
        share = (then - number * TICK_S) / TICK_S
        after = s.ticks[(number + 1) % TICKS]
        after_x, after_y, after_path = after.x, after.y, after.path
    return (
        before.x + share * (after_x - before.x),
        before.y + share * (after_y - before.y),
        before.path + share * (after_path - before.path),
    )
