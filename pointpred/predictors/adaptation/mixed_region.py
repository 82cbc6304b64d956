"""The law of the endpoint as places and elsewhere have it, and its levels for one person.

Elsewhere is the Student law that is stated, without what places add to it; a place is a normal law as wide as
its visits scatter. The places whose densities hold a share of the probability are its regions: where a person
returns to places these are several small ones, where the ellipse of one law must hold what lies between them.
"""

from __future__ import annotations

import numpy as np

from pointpred.compiled import law
from pointpred.predictors import mixture
from pointpred.predictors.adaptation import destination, levels, places
from pointpred.predictors.mixture import LEVELS, PartRow, corrected_probability
from pointpred.records import FloatArray, SixFloats
from pointpred.stage import Slot, offsets

MOST_PLACES = 4
"""Places that are told apart from elsewhere."""
LEAST = 0.02
"""A place that is less likely counts as elsewhere."""
LEAST_SPREAD = 0.5
"""Visits scatter at least so far, px."""
POINTS = 32
"""Points of each part by which it is judged whether the end lay inside."""

LEARNED = levels.OFFSETS
SLOTS: tuple[Slot, ...] = (levels.SLOT,)
"""What is known of a person's levels, in the order of the layout."""

# The mixture at a moment: how many parts; the parts as ``mixture`` has them, elsewhere first; the offsets of
# both levels.
COUNT, PARTS, OFFSETS, MIXTURE = offsets(1, PartRow.length * (MOST_PLACES + 1), len(LEVELS))
# The movement, relative to its place: whether a law is claimed now, at which share of the time, and
# elsewhere's law: centre, scale matrix, tail; the mixture that is written when somebody asks for it.
CLAIMED, TIME, ELSEWHERE, ASKED, STATES = offsets(1, 1, 6, MIXTURE)


@law
def likeliest(memory: FloatArray, place_memory: int, going: int, below: float) -> int:
    """The likeliest place that is less likely than ``below``; -1 where there is none above ``LEAST``."""
    best, most = -1, LEAST
    for i in range(int(memory[place_memory + places.COUNT])):
        share = memory[going + destination.NOW + i]
        if most < share < below:
            best, most = i, share
    return best


@law
def claim(memory: FloatArray, now: int, share: float, elsewhere: SixFloats) -> None:
    """Remember elsewhere's law at a share of the time: its centre, scale matrix and tail."""
    memory[now + CLAIMED], memory[now + TIME] = 1.0, share
    for i in range(len(elsewhere)):
        memory[now + ELSEWHERE + i] = elsewhere[i]


@law
def write_part(part: PartRow, share: float, centre: tuple[float, float], spread: float) -> None:
    """Write a place: a normal law of a standard deviation in px."""
    part.share = share
    part.x, part.y = centre
    part.sxx, part.sxy = spread * spread, 0.0
    part.syy, part.tail = spread * spread, 0.0


@law
def write(
    memory: FloatArray,
    known: tuple[int, int, int],
    now: int,
    at: int,
    origin: tuple[float, float],
    start: tuple[float, float],
) -> None:
    """Write the mixture as it is now, and what its regions must hold of it.

    ``known``: where the levels, the places and their shares stand; ``origin`` of the scene on the screen,
    ``start`` of the movement from there, both in px.
    """
    person, place_memory, going = known
    count, rest, below = 1, 1.0, 2.0
    number = likeliest(memory, place_memory, going, below)
    while number >= 0 and count <= MOST_PLACES:
        below = memory[going + destination.NOW + number]
        place = place_memory + places.PLACES + places.WIDTH * number
        x, y = memory[place + places.X], memory[place + places.Y]
        spread = max(destination.spread_of(memory, going, start, x, y), LEAST_SPREAD)
        centre = x + origin[0], y + origin[1]
        write_part(PartRow(memory, at + PARTS + PartRow.length * count), below, centre, spread)
        rest -= below
        count += 1
        number = likeliest(memory, place_memory, going, below)
    elsewhere = PartRow(memory, at + PARTS)
    memory[at + COUNT], elsewhere.share = count, max(rest, 0.0)
    for i in range(ASKED - ELSEWHERE):
        elsewhere.memory[1 + i] = memory[now + ELSEWHERE + i]
    for which in range(len(LEVELS)):
        memory[at + OFFSETS + which] = levels.offset(memory, person, memory[now + TIME], which)


@law
def judge(
    memory: FloatArray, person: int, at: int, end: tuple[float, float], share: float, step: float
) -> None:
    """Learn whether the end lay inside the regions that were stated at a share of the time."""
    count = int(memory[at + COUNT])
    parts = np.empty((MOST_PLACES + 1, PartRow.length))
    for k in range(count):
        for i in range(PartRow.length):
            parts[k, i] = memory[at + PARTS + PartRow.length * k + i]
    within = mixture.content(parts, count, end[0], end[1], POINTS)
    tail, near, far = PartRow(parts[0]).tail, memory[at + OFFSETS], memory[at + OFFSETS + 1]
    for which in range(len(LEVELS)):
        inside = within <= corrected_probability(LEVELS[which], tail, near, far)
        levels.learn(memory, person, share, which, inside, step)
