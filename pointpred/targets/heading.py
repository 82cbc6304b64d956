"""Which target a movement heads for: what is known of the person and of it, how likely each target is."""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, hypot, inf, nan
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout, clear, places
from pointpred.predictors.adaptation import moments, region_widening, time_left
from pointpred.predictors.adaptation.arrival_intervals import Intervals
from pointpred.predictors.adaptation.moments import LEAST_S, NEAR_PX, NEAR_SHARE, SAMPLES_LEAST
from pointpred.records import FloatArray, FloatTable, SixFloats, TenFloats
from pointpred.targets import arrival, cursor, past, posterior
from pointpred.targets.posterior import Coefficients
from pointpred.targets.rectangles import (
    CENTRE_X,
    CENTRE_Y,
    HEIGHT,
    LOG_WEIGHT,
    NOBODY,
    WIDTH,
    holder,
)

MOST = 32
"""Moments of a movement that are remembered."""
SHORTEST_PX = 3.0
"""From a shorter movement nothing is learned: the hand trembles at a click."""


class Settings(Layout):
    """The share of movements to none of the targets at first; 1 where the person is learned."""

    elsewhere: float
    learn: float


class Person(Layout):
    """What is known of the person: the targets taken, the regions, the durations, the time left."""

    past: past.Past
    regions: region_widening.Radii
    durations: arrival.Durations
    time_left: time_left.Sums
    intervals: Intervals


class Moment(Layout):
    """What was known at a moment, and the ellipse that was stated."""

    t: float
    x: float
    y: float
    sxx: float
    sxy: float
    syy: float
    tail: float
    answer: Annotated[FloatArray, 10]
    cursor: cursor.State


class Movement(Layout):
    """The movement, if one has started: its samples, the share of none before it, what was stated."""

    samples: float
    elsewhere: float
    released: float
    """1 where the last event released a button."""
    remaining_s: float
    """The time left that was stated last, s."""
    claimed: float
    elsewhere_law: Annotated[FloatArray, 6]
    """Whether an endpoint was stated last, and the law of a movement to none of the targets then."""
    series: moments.Series
    moments: Annotated[Sequence[Moment], MOST]
    time_left: time_left.Movement


class Memory(Layout):
    """Settings, what is known of the person, the cursor, the movement."""

    settings: Settings
    person: Person
    cursor: cursor.State
    movement: Movement


ELSEWHERE = 0.02
"""The share of movements to none of the targets, unless given."""
_AT = dict(places(Memory))
LENGTH, CURSOR, NONE = Memory.length, _AT["cursor.known"], _AT["movement.elsewhere"]
"""For JavaScript that makes a memory, looks at the cursor, and says how often no target is meant."""

Targets = tuple[FloatTable, FloatArray, FloatTable, FloatArray]
"""The table of the targets, the caller's weights as logarithms, the keys of ``past``; how likely each is, and
none of them."""


@law
def taken(rows: FloatTable, x: float, y: float) -> int:
    """The target that a movement was for that ended here; -1: none of them.

    The one that holds the place, or one that people who aim at it may have missed by half its size.
    """
    best = holder(rows, x, y)
    if best != NOBODY:
        return best
    least = 1.0
    for i in range(len(rows)):
        row = rows[i]
        off = max(abs(row[CENTRE_X] - x) / row[WIDTH], abs(row[CENTRE_Y] - y) / row[HEIGHT])
        if off < least:
            best, least = i, off
    return best


@law
def arrived(movement: Movement, x: float, y: float, near: float, end: float) -> float:
    """When the cursor came near its end (x, y) for good, s."""
    for k in range(int(movement.series.count) - 1, -1, -1):
        m = movement.moments[k]
        if hypot(m.cursor.x - x, m.cursor.y - y) > near:
            return end
        end = m.t
    return end


@law
def ended(memory: Memory, rows: FloatTable) -> float:
    """When the movement that is over came to its end, s; NaN where nothing is learned from it."""
    s, movement = memory.cursor, memory.movement
    distance = hypot(s.x - s.x0, s.y - s.y0)
    end = arrived(movement, s.x, s.y, max(NEAR_PX, NEAR_SHARE * distance), s.t)
    whole = movement.samples >= SAMPLES_LEAST and distance >= SHORTEST_PX and end - s.t0 >= LEAST_S
    return float(end if memory.settings.learn == 1.0 and whole and len(rows) > 0 else nan)


@law
def learn_target(memory: Memory, targets: Targets) -> None:
    """The movement has ended where the cursor is: learn which target was taken, and forget it."""
    s = memory.cursor
    rows, own, keys, _ = targets
    end = ended(memory, rows)
    if end == end:
        past.learn(memory.person.past, own, keys, taken(rows, s.x, s.y))
    clear(memory.movement)


@law
def begin(memory: Memory, targets: Targets) -> None:
    """A movement begins: lay out how likely each target is before it."""
    rows, own, keys, shares = targets
    none = past.elsewhere(memory.person.past, memory.settings.elsewhere)
    past.weigh(memory.person.past, own, keys, rows)
    memory.movement.elsewhere, total = none, none
    shares[len(rows)] = none
    for i in range(len(rows)):
        shares[i] = (1.0 - none) * exp(rows[i, LOG_WEIGHT]) if rows[i, LOG_WEIGHT] > -inf else 0.0
        total += shares[i]
    for i in range(len(shares)):
        shares[i] /= total


@law
def follow(memory: Memory, event: SixFloats, targets: Targets) -> None:
    """Take in an event. Where a movement begins with it, learn which target the last one took."""
    t, x, y, _, _, buttons = event
    s, movement = memory.cursor, memory.movement
    pressed = float(int(buttons) & 1)
    if cursor.begins(s, t, pressed):
        learn_target(memory, targets)
        begin(memory, targets)
    movement.samples += 1.0 if t > s.t or movement.samples == 0.0 else 0.0
    movement.released = 1.0 if cursor.follow(s, t, x, y, pressed) else 0.0


@law
def weigh(memory: Memory, answer: TenFloats, targets: Targets, coefficients: Coefficients) -> None:
    """Write how likely each target is after the last event, by the prediction made at it."""
    rows, _, _, shares = targets
    movement = memory.movement
    posterior.scores(memory.cursor, rows, answer, coefficients, movement.elsewhere, shares)
    posterior.normalise(shares)
    movement.remaining_s, movement.claimed = answer[6], 0.0
