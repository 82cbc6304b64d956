"""Where a person's movements ended, as places: merged, counted, forgotten; at most 64.

A place belongs to a window or page, named by a key, and lies relative to its origin. Beside the places stands
the history: which place each of the last movements went to.
"""

from __future__ import annotations

from math import hypot

from pointpred.compiled import law, layout
from pointpred.records import LARGEST, FloatArray
from pointpred.stage import Slot, offsets

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

# A place, relative to its own place in the memory: its key, position in px from the origin, visits with
# earlier ones forgotten.
KEY, X, Y, WEIGHT, WIDTH = range(5)
# Layout, relative to `at`: how many places; how many movements ended; the places; the history as a ring.
COUNT, ENDED, PLACES, HISTORY, LEARNED = offsets(1, 1, WIDTH * CAPACITY, MOVEMENTS)

SLOTS = (
    Slot("places held", 1, 0.0, CAPACITY, whole=True),
    Slot("movements ended", 1, 0.0, MOST_ENDED - 1.0, whole=True),
    *(
        Slot("key of a place", 1, 0.0, LARGEST_KEY, whole=True),
        Slot("position of a place", 2, -FURTHEST, FURTHEST),
        Slot("visits of a place", 1, 0.0, 1.001 / (1.0 - KEEP)),
    )
    * CAPACITY,
    Slot("history", MOVEMENTS, NOWHERE, CAPACITY - 1.0, whole=True),
)
"""What is known of a person's places, in the order of the layout."""

FINE, TOO_LIGHT, NO_SUCH_PLACE = 0, 41, 42


@layout
def fault(learned: FloatArray) -> tuple[int, float]:
    """What is wrong with numbers that are within the bounds of their slots, and the number that is wrong."""
    count = int(learned[COUNT])
    for i in range(count):
        if not learned[PLACES + WIDTH * i + WEIGHT] >= LIGHTEST:
            return TOO_LIGHT, learned[PLACES + WIDTH * i + WEIGHT]
    for age in range(int(min(learned[ENDED], MOVEMENTS))):
        if learned[HISTORY + age] >= count:
            return NO_SUCH_PLACE, learned[HISTORY + age]
    return FINE, 0.0


def doubt(learned: FloatArray) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, value = fault(learned)
    return {
        FINE: "",
        TOO_LIGHT: f"visits of a place must be at least {LIGHTEST:g}, are {value:g}",
        NO_SUCH_PLACE: f"history must name a place that is held, names {value:g} of {learned[COUNT]:g}",
    }[wrong]


@law
def nearest(memory: FloatArray, at: int, key: float, point: tuple[float, float], near: float) -> int:
    """The place of this key nearest to a point, at most ``near`` px from it; -1 where there is none."""
    x, y = point
    best, closest = -1, near
    for i in range(int(memory[at + COUNT])):
        place = at + PLACES + WIDTH * i
        away = hypot(memory[place + X] - x, memory[place + Y] - y)
        if memory[place + KEY] == key and away <= closest:
            best, closest = i, away
    return best


@law
def visited(memory: FloatArray, at: int, age: int) -> int:
    """Where a movement ended, ``age`` movements before the last one: the place, -1 where it is unknown."""
    ended = int(memory[at + ENDED])
    if age >= min(ended, MOVEMENTS):
        return -1
    return int(memory[at + HISTORY + (ended - 1 - age) % MOVEMENTS])


@law
def new_place(memory: FloatArray, at: int) -> int:
    """A free place; where there is none the one with the fewest visits is forgotten, in the history too."""
    count = int(memory[at + COUNT])
    if count < CAPACITY:
        memory[at + COUNT] = count + 1.0
        return count
    free = 0
    for i in range(CAPACITY):
        if memory[at + PLACES + WIDTH * i + WEIGHT] < memory[at + PLACES + WIDTH * free + WEIGHT]:
            free = i
    for age in range(MOVEMENTS):
        if memory[at + HISTORY + age] == free:
            memory[at + HISTORY + age] = NOWHERE
    return free


@law
def visit(memory: FloatArray, at: int, key: float, end: tuple[float, float], near: float) -> None:
    """Take in the end of a movement: a visit of the nearest place within ``near`` px, or a new place."""
    x, y = end
    for i in range(int(memory[at + COUNT])):
        place = at + PLACES + WIDTH * i
        memory[place + WEIGHT] = max(KEEP * memory[place + WEIGHT], LIGHTEST)
    number = nearest(memory, at, key, end, near)
    if number < 0:
        number = new_place(memory, at)
        place = at + PLACES + WIDTH * number
        memory[place + KEY], memory[place + WEIGHT] = key, 0.0
        memory[place + X], memory[place + Y] = x, y
    place = at + PLACES + WIDTH * number
    memory[place + WEIGHT] += 1.0
    share = max(1.0 / memory[place + WEIGHT], STEADIEST)
    memory[place + X] += share * (x - memory[place + X])
    memory[place + Y] += share * (y - memory[place + Y])
    memory[at + HISTORY + int(memory[at + ENDED]) % MOVEMENTS] = number
    memory[at + ENDED] += 1.0
    if memory[at + ENDED] == MOST_ENDED:
        memory[at + ENDED] -= MOVEMENTS
