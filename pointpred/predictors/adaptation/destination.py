"""How likely each known place is the destination of the movement, and the endpoint and region that follow.

The law of the endpoint says how likely it makes each place; what the person did before says how likely the
place was before the movement began. Both are taken over what they would be where nothing is known: there the
logarithm of the distance lies evenly in ``distances.UNKNOWN_LOGS``, and the direction in a full turn.
"""

from __future__ import annotations

from math import hypot, pi, sqrt
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout, clear
from pointpred.predictors.adaptation import distances, habits, places
from pointpred.predictors.adaptation.habits import Habits
from pointpred.predictors.adaptation.places import Places
from pointpred.records import FloatArray, FloatTable, SixFloats

NEARNESS = 1.25
"""A place r px from the start counts by 1 / r to this power: of two places the nearer is likelier."""
NEAREST = 2.5
"""Below so many times the size of a place all distances count the same."""
LEAST_SHARE = 1e-4
"""A place that was less likely before the movement is not looked at."""
NEGLIGIBLE = 1e-3
"""A place that is less likely does not move the endpoint."""
STEPS = 10
"""Of the geometric median; each step brings it much nearer."""


class Movement(Layout):
    """Where the movement may go; ``ready`` if the shares before it are laid out."""

    ready: float
    returns: float
    """The share of known places."""
    width: float
    """How far visits end from a place, over its distance."""
    counts: float
    """How much the places count for the endpoint."""
    before: Annotated[FloatArray, places.CAPACITY]
    """The share of each place before the movement."""
    now: Annotated[FloatArray, places.CAPACITY]
    elsewhere: float
    """The share of elsewhere now."""


class Heading(NamedTuple):
    """A Student law of the endpoint: centre in px, direction, widths along and across it in px, tail."""

    x: float
    y: float
    ux: float
    uy: float
    wide: float
    broad: float
    tail: float


@law
def favour_near(s: Movement, held: Places, start: tuple[float, float], near: float) -> None:
    """Shift the shares before the movement towards the places near its start; their sum stays.

    ``near``: how near a place the start is in it, px; that place is no destination.
    """
    before, after = 0.0, 0.0
    for i in range(int(held.count)):
        distance = hypot(held.places[i].x - start[0], held.places[i].y - start[1])
        before += s.before[i]
        nearest = NEAREST * near
        s.before[i] *= max(distance, nearest) ** -NEARNESS if distance > near else 0.0
        after += s.before[i]
    for i in range(int(held.count)):
        s.before[i] *= before / after if after > 0.0 else 0.0


@law
def shift_law(heading: Heading, dx: float, dy: float) -> Heading:
    """A law whose centre is shifted."""
    x, y, ux, uy, wide, broad, tail = heading
    return Heading(x + dx, y + dy, ux, uy, wide, broad, tail)


@law
def scaled(end: Heading, shape: float, factor: float, tail: float) -> SixFloats:
    """The endpoint, the scale matrix times a factor, and a tail.

    ``shape``: covariance of the way along and across, over the product of the widths.
    """
    wide2, broad2 = factor * end.wide * end.wide, factor * end.broad * end.broad
    cross, ux, uy = factor * shape * end.wide * end.broad, end.ux, end.uy
    sxx = wide2 * ux * ux - 2.0 * cross * ux * uy + broad2 * uy * uy
    sxy = (wide2 - broad2) * ux * uy + cross * (ux * ux - uy * uy)
    syy = wide2 * uy * uy + 2.0 * cross * ux * uy + broad2 * ux * ux
    return end.x, end.y, sxx, sxy, syy, tail


@law
def prepare(
    s: Movement,
    held: Places,
    known: Habits,
    scene: tuple[float, float, float],
    start: tuple[float, float],
) -> None:
    """Lay out the share of each place before a movement from ``start``, px from the origin.

    ``scene``: the key, whether the sequence counts, how near a place the start is in it.
    """
    key, with_sequence, near = scene
    out = np.zeros((habits.RULES, places.CAPACITY))
    clear(s)
    s.ready, s.elsewhere = 1.0, 1.0
    if not habits.shares(known, held, key, (start[0], start[1], near), out):
        return
    s.returns = habits.returns(known)
    s.width = habits.usual_width(known)
    for rule in range(habits.RULES):
        weight = habits.rule_weight(known, rule, with_sequence)
        for i in range(places.CAPACITY):
            s.before[i] += weight * out[rule, i]
    favour_near(s, held, start, near)


@law
def likelihood(law_of_end: Heading, x: float, y: float, distance: float, spread: float) -> float:
    """How likely a law makes a place, over what it is where nothing is known.

    ``distance``: of the place from the start, ``spread``: of the visits around it, both px.
    """
    _, _, ux, uy, wide, broad, tail = law_of_end
    dx, dy = x - law_of_end.x, y - law_of_end.y
    along, across = dx * ux + dy * uy, dy * ux - dx * uy
    wide2, broad2 = wide * wide + spread * spread, broad * broad + spread * spread
    far2 = along * along / wide2 + across * across / broad2
    density = (1.0 + far2 / tail) ** (-0.5 * (tail + 2.0)) / (2.0 * pi * sqrt(wide2 * broad2))
    return float(density * 2.0 * pi * distance * distance * distances.UNKNOWN_LOGS)


@law
def weigh(
    s: Movement,
    held: Places,
    start: tuple[float, float],
    law_of_end: Heading,
    elsewhere: tuple[float, float],
) -> None:
    """The share of each place now, and of elsewhere; positions in px from the origin.

    ``elsewhere``: how likely the law makes the last distances, over where nothing is known, and how much the
    places count for the endpoint: 1, and less late in a movement.
    """
    x0, y0 = start
    usual, counts = elsewhere
    s.counts = counts
    count = int(held.count)
    total = (1.0 - s.returns) * usual
    for i in range(count):
        before, share = s.before[i], 0.0
        if before > LEAST_SHARE:
            x, y = held.places[i].x, held.places[i].y
            distance = hypot(x - x0, y - y0)
            spread = s.width * distance
            share = s.returns * before * likelihood(law_of_end, x, y, distance, spread)
        s.now[i] = share
        total += share
    rest = 1.0
    for i in range(count):
        s.now[i] /= total
        rest -= s.now[i]
    s.elsewhere = max(rest, 0.0)


@law
def spread_of(s: Movement, start: tuple[float, float], x: float, y: float) -> float:
    """How far visits of a place end from it, px."""
    return float(s.width * hypot(x - start[0], y - start[1]))


@law
def candidates(
    s: Movement, held: Places, start: tuple[float, float], elsewhere: Heading, out: FloatTable
) -> int:
    """Fill rows of share, position and squared width, px^2: elsewhere, then the places; returns how many."""
    size2 = 0.5 * (elsewhere.wide * elsewhere.wide + elsewhere.broad * elsewhere.broad)
    rest = 1.0 - s.counts * (1.0 - s.elsewhere)
    out[0, 0], out[0, 1], out[0, 2], out[0, 3] = rest, elsewhere.x, elsewhere.y, size2
    count = 1
    for i in range(int(held.count)):
        share = s.counts * s.now[i]
        if share > NEGLIGIBLE:
            x, y = held.places[i].x, held.places[i].y
            spread = spread_of(s, start, x, y)
            out[count, 0], out[count, 1], out[count, 2] = share, x, y
            out[count, 3] = spread * spread
            count += 1
    return count


@law
def geometric_median(rows: FloatTable, count: int) -> tuple[float, float]:
    """The point with the least mean distance from where the movement may end (Weiszfeld), px.

    Distances are softened by the width of each candidate.
    """
    x, y, total = 0.0, 0.0, 0.0
    for k in range(count):
        x += rows[k, 0] * rows[k, 1]
        y += rows[k, 0] * rows[k, 2]
        total += rows[k, 0]
    x, y = x / total, y / total
    for _ in range(STEPS):
        sum_x, sum_y, sum_w = 0.0, 0.0, 0.0
        for k in range(count):
            dx, dy = rows[k, 1] - x, rows[k, 2] - y
            w = rows[k, 0] / sqrt(dx * dx + dy * dy + rows[k, 3])
            sum_x += w * rows[k, 1]
            sum_y += w * rows[k, 2]
            sum_w += w
        x, y = sum_x / sum_w, sum_y / sum_w
    return x, y


@law
def combine(s: Movement, held: Places, start: tuple[float, float], elsewhere: Heading) -> Heading:
    """The law of the endpoint by the places and elsewhere: ``elsewhere`` moved and of another size.

    Its centre is the geometric median; its widths are mean distances from it, along and across: a far place
    that is hardly likely then makes the region little larger.
    """
    rows = np.empty((places.CAPACITY + 1, 4))
    count = candidates(s, held, start, elsewhere, rows)
    if count == 1:
        return elsewhere
    x, y = geometric_median(rows, count)
    _, _, ux, uy, wide, broad, tail = elsewhere
    new_wide, new_broad, total = 0.0, 0.0, 0.0
    for k in range(count):
        dx, dy, share = rows[k, 1] - x, rows[k, 2] - y, rows[k, 0]
        along, across = dx * ux + dy * uy, dy * ux - dx * uy
        wide2, broad2 = (wide * wide, broad * broad) if k == 0 else (rows[k, 3], rows[k, 3])
        new_wide += share * sqrt(along * along + wide2)
        new_broad += share * sqrt(across * across + broad2)
        total += share
    return Heading(x, y, ux, uy, new_wide / total, new_broad / total, tail)
