"""The contours of a mixture's density: closed polygons around the places that are denser than a threshold.

Marching squares (Lorensen, Cline 1987, in two dimensions) on lines that are close together at every part.
"""

from __future__ import annotations

from math import expm1, log, sqrt

import numpy as np

from pointpred.compiled import law
from pointpred.mixtures.density import (
    LEAST,
    SXX,
    SYY,
    TAIL,
    X,
    Y,
    density,
    part_density,
)
from pointpred.records import FloatArray

LINES = 24
"""Lines through each part in each direction."""
AT_CENTRE = 0.4
"""How far apart lines are at a part's centre, over how far apart they would be if evenly spread."""
CLOSER = 3
"""Steps of false position along an edge of the grid."""
OUTSIDE = 1.0001
"""The outermost lines lie so far out that none of the region is beyond them."""


@law
def reach(parts: FloatArray, count: int, k: int, threshold: float) -> float:
    """Squared Mahalanobis distance beyond which a part is less than its portion of a threshold.

    -1 where it is so at its centre.
    """
    over = part_density(parts, k, parts[k, X], parts[k, Y]) * count / threshold
    if not over > 1.0:
        return -1.0
    tail = parts[k, TAIL]
    return float(2.0 * log(over) if tail == 0.0 else tail * expm1(2.0 * log(over) / (tail + 2.0)))


@law
def lines_of(parts: FloatArray, count: int, threshold: float, across: int, out: FloatArray) -> int:
    """Lay out the lines of the grid in one direction, ascending; returns how many. ``across``: 0 x, 1 y."""
    centre, scale, total = X, SXX, 0
    if across == 1:
        centre, scale = Y, SYY
    for k in range(count):
        far = reach(parts, count, k, threshold)
        for i in range(LINES):
            if far > 0.0:
                at = 2.0 * i / (LINES - 1.0) - 1.0
                at *= AT_CENTRE + (1.0 - AT_CENTRE) * at * at
                value = parts[k, centre] + OUTSIDE * at * sqrt(far * parts[k, scale])
                place = total
                while place > 0 and out[place - 1] > value:
                    out[place] = out[place - 1]
                    place -= 1
                out[place] = value
                total += 1
    return total


@law
def height(parts: FloatArray, count: int, threshold: float, x: float, y: float) -> float:
    """The logarithm of the density over the threshold."""
    return log(max(density(parts, count, x, y), LEAST)) - log(threshold)


@law
def crossing(
    parts: FloatArray,
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
    heights: FloatArray, middles: FloatArray, columns: int, rows: int, following: FloatArray
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
def outlines(parts: FloatArray, count: int, threshold: float, points: FloatArray, ends: FloatArray) -> int:
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
