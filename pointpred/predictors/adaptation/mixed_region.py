"""The law of the endpoint as places and elsewhere have it, and its levels for one person.

Elsewhere is the Student law that is stated, without what places add to it; a place is a normal law as wide as
its visits scatter. The places whose densities hold a share of the probability are its regions: where a person
returns to places these are several small ones, where the ellipse of one law must hold what lies between them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.predictors import mixture
from pointpred.predictors.adaptation import destination, levels
from pointpred.predictors.adaptation.places import Places
from pointpred.predictors.mixture import LEVELS, PartRow, corrected_probability
from pointpred.records import FloatArray, SixFloats

MOST_PLACES = 4
"""Places that are told apart from elsewhere."""
LEAST = 0.02
"""A place that is less likely counts as elsewhere."""
LEAST_SPREAD = 0.5
"""Visits scatter at least so far, px."""
POINTS = 32
"""Points of each part by which it is judged whether the end lay inside."""


class Mixture(Layout):
    """The mixture at a moment: how many parts, these as ``mixture`` has them, the offsets of the levels."""

    count: float
    rows: Annotated[Sequence[PartRow], MOST_PLACES + 1]
    """The parts, elsewhere first."""
    offsets: Annotated[FloatArray, len(LEVELS)]


class Movement(Layout):
    """What is claimed now, if anything is."""

    claimed: float
    time: float
    """The share of the time."""
    elsewhere: Annotated[FloatArray, 6]
    """Its law: centre, scale matrix, tail."""
    asked: Mixture
    """Written when somebody asks for it."""


@law
def likeliest(held: Places, going: destination.Movement, below: float) -> int:
    """The likeliest place that is less likely than ``below``; -1 where there is none above ``LEAST``."""
    best, most = -1, LEAST
    for i in range(int(held.count)):
        share = going.now[i]
        if most < share < below:
            best, most = i, share
    return best


@law
def claim(s: Movement, share: float, elsewhere: SixFloats) -> None:
    """Remember elsewhere's law at a share of the time: its centre, scale matrix and tail."""
    s.claimed, s.time = 1.0, share
    for i in range(len(elsewhere)):
        s.elsewhere[i] = elsewhere[i]


@law
def write_part(part: PartRow, share: float, centre: tuple[float, float], spread: float) -> None:
    """Write a place: a normal law of a standard deviation in px."""
    part.share = share
    part.x, part.y = centre
    part.sxx, part.sxy = spread * spread, 0.0
    part.syy, part.tail = spread * spread, 0.0


@law
def write(
    offsets: levels.Offsets,
    held: Places,
    going: destination.Movement,
    now: Movement,
    to: Mixture,
    origin: tuple[float, float],
    start: tuple[float, float],
) -> None:
    """Write the mixture as it is now, and what its regions must hold of it.

    ``origin`` of the scene on the screen, ``start`` of the movement from there, both in px.
    """
    count, rest, below = 1, 1.0, 2.0
    number = likeliest(held, going, below)
    while number >= 0 and count <= MOST_PLACES:
        below = going.now[number]
        place = held.places[number]
        spread = max(destination.spread_of(going, start, place.x, place.y), LEAST_SPREAD)
        write_part(to.rows[count], below, (place.x + origin[0], place.y + origin[1]), spread)
        rest -= below
        count += 1
        number = likeliest(held, going, below)
    elsewhere = to.rows[0]
    to.count, elsewhere.share = count, max(rest, 0.0)
    for i in range(len(now.elsewhere)):
        elsewhere.memory[1 + i] = now.elsewhere[i]
    for which in range(len(LEVELS)):
        to.offsets[which] = levels.offset(offsets, now.time, which)


@law
def judge(
    offsets: levels.Offsets, stated: Mixture, end: tuple[float, float], share: float, step: float
) -> None:
    """Learn whether the end lay inside the regions that were stated at a share of the time."""
    count = int(stated.count)
    parts = np.empty((MOST_PLACES + 1, PartRow.length))
    for k in range(count):
        for i in range(PartRow.length):
            parts[k, i] = stated.rows[k].memory[i]
    within = mixture.content(parts, count, end[0], end[1], POINTS)
    tail, near, far = stated.rows[0].tail, stated.offsets[0], stated.offsets[1]
    for which in range(len(LEVELS)):
        inside = within <= corrected_probability(LEVELS[which], tail, near, far)
        levels.learn(offsets, share, which, inside, step)
