"""A law of the endpoint that is a mixture: its density, its levels for a person, its regions' contours.

A part is a bivariate Student or normal law: a place where the movement may end, or elsewhere. Probabilities
are counted with points that stand for equal shares of each part: a spiral of equal turns whose squared radii
are the quantiles of the part's own law (Vogel 1979). Contours are found by marching squares (Lorensen, Cline
1987, in two dimensions) on lines that are close together at every part.
"""

from __future__ import annotations

from functools import cached_property
from math import exp, expm1, log, log1p, nan, pi, sqrt

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import FloatArray, FloatTable
from pointpred.regions import ellipse, probability

TURN_COS, TURN_SIN = -0.7373688780783197, 0.6754902942615238
"""The turn from one point of the spiral to the next: the golden angle."""
HALVINGS = 60
DENSITY_LEAST = 1e-280
"""A density below counts as none."""


class PartRow(Layout):
    """A part, a row of a table: its share, centre in px, scale matrix in px^2, tail; 0: a normal law."""

    share: float
    x: float
    y: float
    sxx: float
    sxy: float
    syy: float
    tail: float


@law
def squared_radius(share: float, tail: float) -> float:
    """Squared Mahalanobis distance within which a share of a part's law lies."""
    normal = -2.0 * log1p(-share)
    return float(normal if tail == 0.0 else tail * expm1(normal / tail))


@law
def part_density(part: PartRow, x: float, y: float) -> float:
    """The density of a part at a place, times its share, in 1 / px^2."""
    sxx, sxy, syy, tail = part.sxx, part.sxy, part.syy, part.tail
    determinant = sxx * syy - sxy * sxy
    dx, dy = x - part.x, y - part.y
    far = (syy * dx * dx - 2.0 * sxy * dx * dy + sxx * dy * dy) / determinant
    log_density = -0.5 * far if tail == 0.0 else -0.5 * (tail + 2.0) * log1p(far / tail)
    return float(part.share * exp(log_density) / (2.0 * pi * sqrt(determinant)))


@law
def density(parts: FloatTable, count: int, x: float, y: float) -> float:
    """The density of the mixture at a place, in 1 / px^2."""
    total = 0.0
    for k in range(count):
        total += part_density(PartRow(parts[k]), x, y)
    return total


@law
def densities(parts: FloatTable, count: int, points: int, out: FloatTable) -> None:
    """The density at so many points of each part, a row of ``out`` each."""
    for k in range(count):
        part = PartRow(parts[k])
        wide = sqrt(part.sxx)
        slant = part.sxy / wide
        broad = sqrt(part.syy - slant * slant)
        cos, sin = 1.0, 0.0
        for i in range(points):
            radius = sqrt(squared_radius((i + 0.5) / points, part.tail))
            x = part.x + radius * wide * cos
            y = part.y + radius * (slant * cos + broad * sin)
            out[k, i] = density(parts, count, x, y)
            cos, sin = cos * TURN_COS - sin * TURN_SIN, cos * TURN_SIN + sin * TURN_COS


@law
def share_above(parts: FloatTable, count: int, points: int, known: FloatTable, threshold: float) -> float:
    """The probability of the places that are denser than a threshold; ``known``: by ``densities``."""
    total = 0.0
    for k in range(count):
        above = 0
        for i in range(points):
            above += 1 if known[k, i] > threshold else 0
        total += PartRow(parts[k]).share * above / points
    return total


@law
def content(parts: FloatTable, count: int, x: float, y: float, points: int) -> float:
    """The probability of the places that are denser than a place: exact for a single part."""
    if count == 1:
        part = PartRow(parts[0])
        own, best = part_density(part, x, y), part_density(part, part.x, part.y)
        power = 1.0 if part.tail == 0.0 else part.tail / (part.tail + 2.0)
        return float(1.0 - (own / best) ** power)
    known = np.empty((count, points))
    densities(parts, count, points, known)
    return share_above(parts, count, points, known, density(parts, count, x, y))


@law
def threshold_of(parts: FloatTable, count: int, level: float, points: int) -> float:
    """The density above which places of the probability ``level`` lie: exact for a single part."""
    if count == 1:
        first = PartRow(parts[0])
        far = squared_radius(level, first.tail)
        log_density = -0.5 * far if first.tail == 0.0 else -0.5 * (first.tail + 2.0) * log1p(far / first.tail)
        return part_density(first, first.x, first.y) * exp(log_density)
    known = np.empty((count, points))
    densities(parts, count, points, known)
    most = DENSITY_LEAST  # no place is denser than all parts are at their centres
    for k in range(count):
        part = PartRow(parts[k])
        most += part_density(part, part.x, part.y)
    low, high = log(DENSITY_LEAST), log(most)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if share_above(parts, count, points, known, exp(middle)) > level:
            low = middle
        else:
            high = middle
    return exp(0.5 * (low + high))


LEVELS = (0.5, 0.8)
"""The levels of the regions that are corrected for a person.

Each has an offset, the logarithm of what its squared radius, or that of a normal law, is multiplied by; 0:
what the law claims.
"""
HEAVINESS_LEAST, HEAVINESS_MOST = 1e-6, 40.0
"""Bounds on 2 / tail as a predictor states it: no exponential overflows."""
PROBABILITY_MOST = 1.0 - 1e-9
"""The largest probability of a region."""


@law
def squared_radius_over_tail(level: float, heavy: float) -> float:
    """Squared radius of a level's region over the tail; ``heavy``: 2 / tail.

    The Student law of ``pointpred.regions.reach`` in the form that is compiled here.
    """
    return float(exp(-heavy * log(1.0 - level)) - 1.0)


@law
def corrected_radius(level: float, heavy: float, offset: float) -> float:
    """``squared_radius_over_tail`` of a level with its offset.

    A region that held too few ends grows by the same factor, whatever the tail. One that held too many
    becomes the region of a lower level, whose squared radius under a normal law is smaller by that factor:
    with a heavy tail it shrinks much more. Otherwise the two radii would come nearer to each other than any
    Student law has them.
    """
    lower = exp(min(offset, 0.0))
    return float(exp(max(offset, 0.0)) * (exp(-heavy * log(1.0 - level) * lower) - 1.0))


@law
def heaviness(tail: float) -> float:
    """2 / tail within bounds."""
    return min(max(2.0 / tail, HEAVINESS_LEAST), HEAVINESS_MOST)


@law
def corrected_probability(level: float, tail: float, near: float, far: float) -> float:
    """The probability that the region of a level must have so that it holds that share of the ends.

    ``tail`` of elsewhere; ``near``, ``far``: the offsets of both. On a line between the levels over
    the logarithm of the squared radius of a normal law; never less than that of a lower level.
    """
    radius, half, most = log(-log(1.0 - level)), log(-log(1.0 - LEVELS[0])), log(-log(1.0 - LEVELS[1]))
    part = min(max((radius - half) / (most - half), 0.0), 1.0)
    heavy = heaviness(tail)
    own = corrected_radius(level, heavy, near + part * (far - near))
    if level > LEVELS[0]:
        own = max(own, corrected_radius(LEVELS[0], heavy, near))
    return min(1.0 - exp(-log(1.0 + own) / heavy), PROBABILITY_MOST)


LINES, LINES_OF, LINES_LEAST = 24, 120, 3
"""Lines through each part in each direction: of many parts so many together, and at least three."""
AT_CENTRE = 0.4
"""How far apart lines are at a part's centre, over how far apart they would be if evenly spread."""
CLOSER = 3
"""Steps of false position along an edge of the grid."""
OUTSIDE = 1.0001
"""The outermost lines lie so far out that none of the region is beyond them."""


@law
def reach(part: PartRow, count: int, threshold: float) -> float:
    """Squared Mahalanobis distance beyond which one of the parts is less than its portion of a threshold.

    -1 where it is so at its centre.
    """
    over = part_density(part, part.x, part.y) * count / threshold
    if not over > 1.0:
        return -1.0
    tail = part.tail
    return float(2.0 * log(over) if tail == 0.0 else tail * expm1(2.0 * log(over) / (tail + 2.0)))


@law
def lines_of(parts: FloatTable, count: int, threshold: float, across: int, out: FloatArray) -> int:
    """Lay out the lines of the grid in one direction, ascending; returns how many. ``across``: 0 x, 1 y."""
    total, lines = 0, max(min(LINES, LINES_OF // count), LINES_LEAST)
    for k in range(count):
        part = PartRow(parts[k])
        centre, scale = part.x, part.sxx
        if across == 1:
            centre, scale = part.y, part.syy
        far = reach(part, count, threshold)
        for i in range(lines):
            if far > 0.0:
                at = 2.0 * i / (lines - 1.0) - 1.0
                at *= AT_CENTRE + (1.0 - AT_CENTRE) * at * at
                value = centre + OUTSIDE * at * sqrt(far * scale)
                place = total
                while place > 0 and out[place - 1] > value:
                    out[place] = out[place - 1]
                    place -= 1
                out[place] = value
                total += 1
    return total


@law
def height(parts: FloatTable, count: int, threshold: float, x: float, y: float) -> float:
    """The logarithm of the density over the threshold."""
    return log(max(density(parts, count, x, y), DENSITY_LEAST)) - log(threshold)


@law
def crossing(
    parts: FloatTable,
    count: int,
    threshold: float,
    one: tuple[float, float, float],
    other: tuple[float, float, float],
) -> tuple[float, float]:
    """Where the density is the threshold between two places, each x, y and its height of another sign."""
    x0, y0, h0 = one
    x1, y1, h1 = other
    x, y = x0, y0
    for _ in range(CLOSER):
        part = h0 / (h0 - h1)
        x, y = x0 + part * (x1 - x0), y0 + part * (y1 - y0)
        h = height(parts, count, threshold, x, y)
        if (h > 0.0) == (h0 > 0.0):
            x0, y0, h0 = x, y, h
        else:
            x1, y1, h1 = x, y, h
    return x, y


@law
def edge_of(side: int, i: int, j: int, columns: int, rows: int) -> int:
    """The number of an edge of the cell at column ``i``, row ``j``: 0 below, 1 right, 2 above, 3 left."""
    if side == 0:
        return j * columns + i
    if side == 2:
        return (j + 1) * columns + i
    return rows * columns + j * columns + (i + 1 if side == 1 else i)


@law
def partner(sides: FloatArray, side: int, middle: float) -> int:
    """The side where a contour that enters a cell at ``side`` leaves it.

    ``sides``: -1 where one goes around the cell out of the region, 1 where into it, 0 for neither. In a cell
    with four crossings the region is connected if its middle is inside.
    """
    way = 1 if middle > 0.0 else 3
    for k in range(1, 4):
        other = (side + way * k) % 4
        if sides[other] == 1.0:
            return other
    return side


@law
def follow_cells(
    heights: FloatTable, middles: FloatTable, columns: int, rows: int, following: FloatArray
) -> None:
    """For each edge that a contour crosses the edge that it crosses next, the region on its left; else -1."""
    corners, sides = np.empty(4), np.empty(4)
    for n in range(2 * columns * rows):
        following[n] = -1.0
    for j in range(rows - 1):
        for i in range(columns - 1):
            corners[0], corners[1] = heights[j, i], heights[j, i + 1]
            corners[2], corners[3] = heights[j + 1, i + 1], heights[j + 1, i]
            for side in range(4):
                here, there = corners[side] > 0.0, corners[(side + 1) % 4] > 0.0
                sides[side] = 0.0 if here == there else -1.0 if here else 1.0
            for side in range(4):
                if sides[side] == -1.0:
                    end = partner(sides, side, middles[j, i])
                    start = edge_of(side, i, j, columns, rows)
                    following[start] = edge_of(end, i, j, columns, rows)


@law
def outlines(parts: FloatTable, count: int, threshold: float, points: FloatTable, ends: FloatArray) -> int:
    """Write the contours; returns how many there are.

    ``points``: a row x, y each, the polygons one after another; ``ends``: of each polygon the number of
    points up to its end. A hole turns the other way round. What finds no room is left out.
    """
    xs, ys = np.empty(count * LINES), np.empty(count * LINES)
    columns = lines_of(parts, count, threshold, 0, xs)
    rows = lines_of(parts, count, threshold, 1, ys)
    if columns == 0 or rows == 0:
        return 0
    heights, middles = np.empty((rows, columns)), np.zeros((rows, columns))
    for j in range(rows):
        for i in range(columns):
            heights[j, i] = height(parts, count, threshold, xs[i], ys[j])
    for j in range(rows - 1):
        for i in range(columns - 1):
            middles[j, i] = 0.25 * (
                heights[j, i] + heights[j, i + 1] + heights[j + 1, i] + heights[j + 1, i + 1]
            )
    following = np.empty(2 * columns * rows)
    follow_cells(heights, middles, columns, rows, following)
    total, polygons = 0, 0
    for first in range(2 * columns * rows):
        edge, before = first, total
        while following[edge] >= 0.0 and total < len(points) and polygons < len(ends):
            upright = edge >= columns * rows
            place = edge - columns * rows if upright else edge
            row, column = place // columns, place % columns
            below, beside = (row + 1, column) if upright else (row, column + 1)
            one = xs[column], ys[row], heights[row, column]
            other = xs[beside], ys[below], heights[below, beside]
            points[total, 0], points[total, 1] = crossing(parts, count, threshold, one, other)
            total += 1
            after = int(following[edge])
            following[edge] = -1.0
            edge = after
        if total > before:
            ends[polygons] = total
            polygons += 1
    return polygons


POINTS, POINTS_OF, POINTS_LEAST = 2000, 10_000, 30
"""Points of each part by which probabilities are counted: they are off by less than 0.002. Of more than five
parts so many together, and at least thirty of each: then by less than 0.01."""


@law
def points_of(count: int) -> int:
    """How many points of each of so many parts are enough."""
    return max(min(POINTS, POINTS_OF // count), POINTS_LEAST)


VERTICES, POLYGONS = 20_000, 256
"""Room for the outlines of a region."""


class Part(msgspec.Struct, frozen=True):
    """A law of the endpoint that holds with probability ``share``: centre ``x y`` px and ``scale`` px^2.

    ``scale`` and ``tail`` as in ``Prediction``: a bivariate Student law, or a normal one where ``tail`` is
    ``None``.
    """

    share: float
    x: float
    y: float
    scale: tuple[float, float, float]
    tail: float | None


class LevelSet(msgspec.Struct, frozen=True):
    """The smallest region that has a probability: the places where the density is at least ``threshold``.

    ``content``: its probability; ``threshold`` in 1 / px^2; ``outlines``: closed polygons, a row x, y px a
    vertex; a hole turns the other way round than what is around it.
    """

    parts: FloatArray
    content: float
    threshold: float
    area: float
    """px^2."""
    outlines: tuple[FloatArray, ...]

    def contains(self, x: float, y: float) -> bool:
        """Whether a place lies in the region."""
        return bool(density(self.parts, len(self.parts), float(x), float(y)) >= self.threshold)


class Mixture(msgspec.Struct, frozen=True, dict=True):
    """The law of the endpoint by places and elsewhere: one of the ``parts`` holds, each with its share.

    ``offsets``: how the regions of 50 and 80 % are corrected so that they hold these shares of the person's
    ends; those of other levels lie between. Assumes shares that sum to 1 and the widest part first.

    >>> part = Part(1.0, 300.0, 200.0, (400.0, 0.0, 100.0), None)
    >>> region = Mixture((part,)).region(0.5)
    >>> region.contains(323.0, 200.0), region.contains(324.0, 200.0), round(region.area)
    (True, False, 871)
    """

    parts: tuple[Part, ...]
    offsets: tuple[float, float] = (0.0, 0.0)

    @cached_property
    def table(self) -> FloatArray:
        """The parts as laws take them."""
        rows = [(one.share, one.x, one.y, *one.scale, one.tail or 0.0) for one in self.parts]
        return np.array(rows, dtype=np.float64).reshape(-1, PartRow.length)

    def density(self, x: float, y: float) -> float:
        """The density at a place, in 1 / px^2."""
        return density(self.table, len(self.parts), float(x), float(y))

    def region(self, level: float) -> LevelSet:
        """The smallest region that holds the endpoint with probability ``level``, as the predictor claims.

        It may have several pieces. Its probability in the mixture is right to within 0.002, its outlines and
        area to within 1 %; of more than five parts to within 0.01 and 5 %. The threshold and area of a single
        part are exact. Raises ParameterError for a
        level outside (0, 1).
        """
        first, table, count = self.parts[0], self.table, len(self.parts)
        tail = first.tail or 2.0 / HEAVINESS_LEAST
        content = corrected_probability(probability(level), tail, *self.offsets)
        threshold = threshold_of(table, count, content, points_of(count))
        outlines = polygons(table, threshold)
        if count == 1:
            major, minor, _ = ellipse(content, *first.scale, first.tail or nan)
            return LevelSet(table, content, threshold, pi * major * minor, outlines)
        return LevelSet(table, content, threshold, abs(sum(map(signed_area, outlines))), outlines)


def polygons(table: FloatArray, threshold: float) -> tuple[FloatArray, ...]:
    """The outlines of the places that are denser than a threshold."""
    points, ends = np.empty((VERTICES, 2)), np.empty(POLYGONS)
    count = outlines(table, len(table), threshold, points, ends)
    last = int(ends[count - 1]) if count else 0
    return tuple(np.split(points[:last], ends[: count - 1].astype(int))) if count else ()


def signed_area(polygon: FloatArray) -> float:
    """The area of a polygon, negative where it turns the other way round, in px^2."""
    x, y = (polygon - polygon[0]).T
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))
