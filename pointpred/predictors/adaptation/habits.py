"""Which of the known places a person goes to next, before the movement shows it.

Four rules answer: how often each place was visited, which were visited lately, how many movements ago a place
was visited when the person returned to it, and where the person went from here. Each finished movement shares
a visit among the rules by how likely each had made its end; the weights of the rules are these visits, with
earlier ones forgotten. In the same way the person's share of movements to a new place is learned, and how far
from a place the visits of it end.
"""

from __future__ import annotations

from math import exp, hypot, log
from typing import Annotated

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.predictors.adaptation import distances, places
from pointpred.predictors.adaptation.places import Places
from pointpred.records import FloatArray, FloatTable

OFTEN, LATELY, AFTER_SO_MANY, FROM_HERE, RULES = range(5)
FIRST_RULES = (1.0, 0.15, 0.15, 0.15)
"""Initial weights of the rules, up to a factor."""
FIRST_RULES_OF = 8.0
"""Visits that these count for."""
KEEP = 0.95
"""Forgetting factor of the visits per movement."""
RETURNS, RETURNS_OF = 0.05, 1.0
"""Initial share of movements to a known place, and the movements that it counts for."""
WIDTHS = (0.02, 0.05, 0.1)
"""Standard deviations of the ends around a place, as shares of the distance to it."""
WIDTHS_OF = 3.0
"""Visits that the first belief in each width, the same for all, counts for together."""
LATE_AGE, LATE_ELSE = 3.0, 0.1
"""After so many movements a visit weighs 1 / e for LATELY; what OFTEN says counts as so many visits there."""
LAGS, LAG_KEEP = 16, 0.95
"""Returns after up to so many movements are counted, and how each is forgotten with the next."""
AGE = 60.0
"""After so many movements what followed a place weighs 1 / e for FROM_HERE."""
OFTEN_OF = 0.7
"""For the last two rules what OFTEN says counts for so many visits."""
LEAST_LOG = -200.0
"""Logarithms of densities are cut here."""

MOST = 1.001 / (1.0 - KEEP)
VISITS = Known("visits to known and to new places", 0.0, MOST)


class Habits(Layout):
    """What is known of a person's habits: visits to known places and to new ones, of each rule and width."""

    known: Annotated[float, VISITS]
    new: Annotated[float, VISITS]
    rules: Annotated[FloatArray, RULES, Known("visits as each rule has them", 0.0, MOST)]
    widths: Annotated[FloatArray, len(WIDTHS), Known("visits as each width has them", 0.0, MOST)]
    lags: Annotated[FloatArray, LAGS, Known("returns", 0.0, MOST)]
    """Returns after 1, 2 ... movements."""


@law
def blend(out: FloatTable, rule: int, base: int, count: int, weight: float) -> None:
    """Shares of a rule from its counts, with those of another rule for so many visits."""
    total = weight
    for i in range(count):
        total += out[rule, i]
    for i in range(count):
        out[rule, i] = (out[rule, i] + weight * out[base, i]) / total


@law
def count_often(held: Places, key: float, out: FloatTable) -> float:
    """The share of each place of a key by its visits; returns the sum of the visits."""
    count, total = int(held.count), 0.0
    for i in range(count):
        if held.places[i].key == key:
            out[OFTEN, i] = held.places[i].visits
            total += out[OFTEN, i]
    for i in range(count):
        out[OFTEN, i] = out[OFTEN, i] / total if total > 0.0 else 0.0
    return total


@law
def count_last(s: Habits, held: Places, out: FloatTable) -> None:
    """Recent visits, and returns after as many movements as each place was visited ago."""
    for age in range(places.MOVEMENTS):
        number = places.visited(held, age)
        if number >= 0 and out[OFTEN, number] > 0.0:
            out[LATELY, number] += exp(-age / LATE_AGE)
    for age in range(LAGS - 1, -1, -1):  # the most recent visit of a place is written last
        number = places.visited(held, age)
        if number >= 0 and out[OFTEN, number] > 0.0:
            out[AFTER_SO_MANY, number] = s.lags[age]


@law
def count_following(held: Places, here: int, out: FloatTable) -> None:
    """Where the person went from this place."""
    for age in range(places.MOVEMENTS - 1):
        after, before = places.visited(held, age), places.visited(held, age + 1)
        if before == here and after >= 0 and out[OFTEN, after] > 0.0:
            out[FROM_HERE, after] += exp(-age / AGE)


@law
def shares(s: Habits, held: Places, key: float, start: tuple[float, float, float], out: FloatTable) -> bool:
    """The share of each place by each rule, a row each; whether there is any.

    ``start``: of the movement in px from the origin, and how near a place it is in that place. ``out``:
    zeros, RULES rows of ``places.CAPACITY``. Places of another key have no share.
    """
    if count_often(held, key, out) == 0.0:
        return False
    count = int(held.count)
    count_last(s, held, out)
    blend(out, LATELY, OFTEN, count, LATE_ELSE)
    blend(out, AFTER_SO_MANY, OFTEN, count, OFTEN_OF)
    x, y, near = start
    here = places.nearest(held, key, (x, y), near)
    if here >= 0:
        count_following(held, here, out)
    blend(out, FROM_HERE, OFTEN, count, OFTEN_OF)
    return True


@law
def rule_weight(s: Habits, rule: int, with_sequence: float) -> float:
    """The weight of a rule among all; without the sequence only of OFTEN and LATELY."""
    most = RULES if with_sequence == 1.0 else AFTER_SO_MANY
    if rule >= most:
        return 0.0
    total = 0.0
    first = FIRST_RULES_OF / (FIRST_RULES[0] + FIRST_RULES[1] + FIRST_RULES[2] + FIRST_RULES[3])
    for k in range(most):
        total += s.rules[k] + first * FIRST_RULES[k]
    return float((s.rules[rule] + first * FIRST_RULES[rule]) / total)


@law
def returns(s: Habits) -> float:
    """The share of movements that go to a known place."""
    return float((s.known + RETURNS * RETURNS_OF) / (s.known + s.new + RETURNS_OF))


@law
def width_weight(s: Habits, width: int) -> float:
    """The weight of a width among all."""
    total = WIDTHS_OF
    for k in range(len(WIDTHS)):
        total += s.widths[k]
    return float((s.widths[width] + WIDTHS_OF / len(WIDTHS)) / total)


@law
def usual_width(s: Habits) -> float:
    """How far from a place its visits end, as a share of the distance to it: the geometric mean."""
    log_width = 0.0
    for k in range(len(WIDTHS)):
        log_width += width_weight(s, k) * log(WIDTHS[k])
    return exp(log_width)


@law
def share_visit(s: Habits, likely: FloatTable, with_sequence: float, elsewhere: float) -> None:
    """Share one visit among rules, widths and "a new place" by how likely each had made the end.

    ``likely``: a row a rule, a column a width, over the density where nothing is known; ``elsewhere``: the
    same of the movements to new places.
    """
    known = returns(s)
    new = (1.0 - known) * elsewhere
    total = new
    for rule in range(RULES):
        for width in range(len(WIDTHS)):
            prior = known * rule_weight(s, rule, with_sequence) * width_weight(s, width)
            likely[rule, width] *= prior
            total += likely[rule, width]
    s.new = KEEP * s.new + new / total
    s.known = KEEP * s.known + (1.0 - new / total)
    for rule in range(RULES):
        s.rules[rule] *= KEEP
    for width in range(len(WIDTHS)):
        s.widths[width] *= KEEP
    for rule in range(RULES):
        for width in range(len(WIDTHS)):
            s.rules[rule] += likely[rule, width] / total
            s.widths[width] += likely[rule, width] / total


@law
def density_ratio(far2: float, distance2: float, width: float) -> float:
    """How likely a place makes an end, over what it is where nothing is known.

    ``far2``: squared distance of the end from the place, ``distance2``: of the place from the start, px^2.
    Where nothing is known the logarithm of the distance r lies evenly in ``distances.UNKNOWN_LOGS`` = L, the
    direction in a full turn: a density of 1 / (2 pi r^2 L), against the place's normal law of deviation
    ``width`` r.
    """
    if distance2 == 0.0:
        return 0.0
    width2 = width * width
    return exp(max(-0.5 * far2 / distance2 / width2, LEAST_LOG)) * distances.UNKNOWN_LOGS / width2


@law
def learn(
    s: Habits,
    held: Places,
    scene: tuple[float, float, float],
    movement: tuple[float, float, float, float],
    elsewhere: float,
) -> None:
    """Learn from a movement, before its end is taken in as a visit.

    ``scene``: the key, whether the sequence counts, how near a place the start is in it; ``movement``: start
    and end, px from the origin.
    ``elsewhere``: how likely the last distances had made its distance, over that where nothing is known.
    """
    key, with_sequence, near = scene
    x0, y0, x, y = movement
    out = np.zeros((RULES, places.CAPACITY))
    if not shares(s, held, key, (x0, y0, near), out):
        return
    likely = np.zeros((RULES, len(WIDTHS)))
    for i in range(int(held.count)):
        px, py = held.places[i].x, held.places[i].y
        distance2, far2 = (px - x0) ** 2 + (py - y0) ** 2, (px - x) ** 2 + (py - y) ** 2
        for width in range(len(WIDTHS)):
            ratio = density_ratio(far2, distance2, WIDTHS[width])
            for rule in range(RULES):
                likely[rule, width] += out[rule, i] * ratio
    share_visit(s, likely, with_sequence, elsewhere)
    number = places.nearest(held, key, (x, y), places.NEAR_SHARE * hypot(x - x0, y - y0))
    for age in range(LAGS):
        if number >= 0 and places.visited(held, age) == number:
            for k in range(LAGS):
                s.lags[k] *= LAG_KEEP
            s.lags[age] += 1.0
            return
