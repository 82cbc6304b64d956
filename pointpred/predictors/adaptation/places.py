"""Where a person's movements ended, as places: merged, counted, forgotten; at most 64.

A place belongs to a window or page, named by a key, and lies relative to its origin. Beside the places stands
the history: which place each of the last movements went to.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.records import LARGEST, FloatArray

CAPACITY = 64
"""Places that are remembered."""
MOVEMENTS = 128
"""Movements whose place is remembered."""
MOST_ENDED = 1024 * MOVEMENTS
"""Movements are counted up to here, then from the last whole round of the history again."""
KEEP = 0.97
"""Forgetting factor of the visits per movement."""
LIGHTEST = 1e-9
"""The least weight of a place: however long it was not visited, weights can be divided by their sum."""
NOWHERE = -1.0
"""In the history: a place that has been forgotten."""
NEAR_SHARE = 0.03
"""An end so near a place is a visit of it: share of the movement's distance."""
STEADIEST = 0.1
"""A visit draws its place at least this share of the way to where it ended: places may drift."""
LARGEST_KEY = 2.0**53
FURTHEST = 4.0 * LARGEST

POSITION = Known("position of a place", -FURTHEST, FURTHEST)


class Place(Layout):
    """A place relative to the origin of its window."""

    key: Annotated[float, Known("key of a place", 0.0, LARGEST_KEY, whole=True)]
    x: Annotated[float, POSITION]
    """Position, px."""
    y: Annotated[float, POSITION]
    visits: Annotated[float, Known("visits of a place", 0.0, 1.001 / (1.0 - KEEP))]
    """Visits with earlier ones forgotten."""


class Places(Layout):
    """What is known of a person's places; the history is a ring of their numbers."""

    count: Annotated[float, Known("places held", 0.0, CAPACITY, whole=True)]
    ended: Annotated[float, Known("movements ended", 0.0, MOST_ENDED - 1.0, whole=True)]
    places: Annotated[Sequence[Place], CAPACITY]
    history: Annotated[FloatArray, MOVEMENTS, Known("history", NOWHERE, CAPACITY - 1.0, whole=True)]


FINE, TOO_LIGHT, NO_SUCH_PLACE = 0, 41, 42


@law
def fault(learned: Places) -> tuple[int, float]:
    """What is wrong with numbers that are each within their bounds, and the number that is wrong."""
    count = int(learned.count)
    for i in range(count):
        if not learned.places[i].visits >= LIGHTEST:
            return TOO_LIGHT, learned.places[i].visits
    for age in range(int(min(learned.ended, MOVEMENTS))):
        if learned.history[age] >= count:
            return NO_SUCH_PLACE, learned.history[age]
    return FINE, 0.0


def doubt(learned: Places) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, value = fault(learned.memory)
    return {
        FINE: "",
        TOO_LIGHT: f"visits of a place must be at least {LIGHTEST:g}, are {value:g}",
        NO_SUCH_PLACE: f"history must name a place that is held, names {value:g} of {learned.count:g}",
    }[wrong]


@law
def nearest(s: Places, key: float, point: tuple[float, float], near: float) -> int:
    """The place of this key nearest to a point, at most ``near`` px from it; -1 where there is none."""
    x, y = point
    best, closest = -1, near
    for i in range(int(s.count)):
        place = s.places[i]
        away = hypot(place.x - x, place.y - y)
        if place.key == key and away <= closest:
            best, closest = i, away
    return best


@law
def visited(s: Places, age: int) -> int:
    """Where a movement ended, ``age`` movements before the last one: the place, -1 where it is unknown."""
    ended = int(s.ended)
    if age >= min(ended, MOVEMENTS):
        return -1
    return int(s.history[(ended - 1 - age) % MOVEMENTS])


@law
def new_place(s: Places) -> int:
    """A free place; where there is none the one with the fewest visits is forgotten, in the history too."""
    count = int(s.count)
    if count < CAPACITY:
        s.count = count + 1.0
        return count
    free = 0
    for i in range(CAPACITY):
        if s.places[i].visits < s.places[free].visits:
            free = i
    for age in range(MOVEMENTS):
        if s.history[age] == free:
            s.history[age] = NOWHERE
    return free


@law
def visit(s: Places, key: float, end: tuple[float, float], near: float) -> None:
    """Take in the end of a movement: a visit of the nearest place within ``near`` px, or a new place."""
    x, y = end
    for i in range(int(s.count)):
        s.places[i].visits = max(KEEP * s.places[i].visits, LIGHTEST)
    number = nearest(s, key, end, near)
    if number < 0:
        number = new_place(s)
        new = s.places[number]
        new.key, new.visits = key, 0.0
        new.x, new.y = x, y
    place = s.places[number]
    place.visits += 1.0
    share = max(1.0 / place.visits, STEADIEST)
    place.x += share * (x - place.x)
    place.y += share * (y - place.y)
    s.history[int(s.ended) % MOVEMENTS] = number
    s.ended += 1.0
    if s.ended == MOST_ENDED:
        s.ended -= MOVEMENTS
