"""Where the movement ends, given what can be pointed at: a mixture of elsewhere and the registered targets.

Elsewhere is the law that the predictor states, or one that stands in for it. For a target it is known where
people end: about its centre, with a deviation of its size over 4.133 (MacKenzie 1992). What the predictor
says of the endpoint tells where in the target, which matters once the target is larger than what is still
uncertain. The endpoint is the point of the least expected distance. The shares are those by which proposals
are decided.
"""

from __future__ import annotations

from math import hypot, sqrt
from typing import NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.predictors.mixture import PartRow
from pointpred.records import FloatArray, FloatTable, TenFloats
from pointpred.targets import cursor, posterior
from pointpred.targets.posterior import EFFECTIVE, Law
from pointpred.targets.rectangles import CENTRE_X, CENTRE_Y, HEIGHT, WIDTH

WIDER, NARROWEST = 2.0, 0.25
"""Where in a target it ends, the predicted law says as if its variances were so many times larger, and larger
by this share of the target's own: late in a movement predictors are surer than they are right."""
NEGLIGIBLE = 1e-3
"""A target that is less likely does not move the endpoint; of many, one below half an even share."""
STEPS = 8
"""Of the geometric median; each step brings it much nearer."""
LEAST_PX2 = 1.0
"""Distances are softened by at least this square."""
RADII2, TAIL = 0.5, 3.0
"""The ellipse is a Student law of this tail; its variances are this share of the squared mean distances."""


class Ellipse(NamedTuple):
    """The mixture as one Student law: centre px, scale matrix px^2, tail."""

    x: float
    y: float
    sxx: float
    sxy: float
    syy: float
    tail: float


@law
def elsewhere(s: cursor.State, answer: TenFloats) -> Law:
    """The law of a movement that goes to none of the targets: that of the answer, or one that stands in."""
    _, x, y, sxx, sxy, syy, _, _, tail, _ = answer
    stated = Law(x, y, sxx, sxy, syy, tail)
    if posterior.lawful(stated):
        return stated
    sxx, sxy, syy = posterior.unclaimed(s, x, y)
    return Law(x, y, sxx, sxy, syy, np.nan)


@law
def write_target(row: FloatArray, predicted: Law, share: float, part: PartRow) -> None:
    """Write the law of the endpoint of a movement to a target: normal, between its centre and the prediction.

    The target's law times the predicted one, of which a Student law far from the centre counts as wide.
    """
    x, y, sxx, sxy, syy, tail = predicted
    across, down = (row[WIDTH] / EFFECTIVE) ** 2, (row[HEIGHT] / EFFECTIVE) ** 2
    dx, dy = x - row[CENTRE_X], y - row[CENTRE_Y]
    least_x, least_y = (1.0 + NARROWEST) * across, (1.0 + NARROWEST) * down
    wide = WIDER
    if tail == tail:
        a, b, c = wide * sxx + least_x, wide * sxy, wide * syy + least_y
        far2 = (c * dx * dx - 2.0 * b * dx * dy + a * dy * dy) / (a * c - b * b)
        wide *= (tail + far2) / (tail + 2.0)
    a, b, c = wide * sxx + least_x, wide * sxy, wide * syy + least_y
    scaled = 1.0 / (a * c - b * b)
    part.share = share
    part.x = row[CENTRE_X] + across * (c * dx - b * dy) * scaled
    part.y = row[CENTRE_Y] + down * (a * dy - b * dx) * scaled
    part.sxx = across - across * across * c * scaled
    part.sxy = across * down * b * scaled
    part.syy = down - down * down * a * scaled
    part.tail = 0.0


@law
def mixture(table: FloatTable, shares: FloatArray, predicted: Law, least: float, out: FloatTable) -> int:
    """Write the parts of the mixture, as ``predictors.mixture`` has them: elsewhere, then the targets.

    Returns how many. Targets of a share below ``least`` count for elsewhere. ``out`` has a row more than
    there are targets.
    """
    count, rest = 1, 1.0
    for i in range(len(table)):
        if shares[i] >= least:
            write_target(table[i], predicted, shares[i], PartRow(out[count]))
            rest -= shares[i]
            count += 1
    first = PartRow(out[0])
    first.share = max(rest, 0.0)
    first.x, first.y = predicted.x, predicted.y
    first.sxx, first.sxy, first.syy = predicted.sxx, predicted.sxy, predicted.syy
    first.tail = predicted.tail if predicted.tail == predicted.tail else 0.0
    return count


@law
def geometric_median(parts: FloatTable, count: int) -> tuple[float, float]:
    """The point of the least expected distance (Weiszfeld), px, softened by the size of each part."""
    x, y = 0.0, 0.0
    for k in range(count):
        part = PartRow(parts[k])
        x += part.share * part.x
        y += part.share * part.y
    for _ in range(STEPS):
        sum_x, sum_y, total = 0.0, 0.0, 0.0
        for k in range(count):
            part = PartRow(parts[k])
            dx, dy = part.x - x, part.y - y
            weight = part.share / sqrt(dx * dx + dy * dy + max(0.5 * (part.sxx + part.syy), LEAST_PX2))
            sum_x += weight * part.x
            sum_y += weight * part.y
            total += weight
        x, y = sum_x / total, sum_y / total
    return x, y


@law
def ellipse(parts: FloatTable, count: int, centre: tuple[float, float], way: tuple[float, float]) -> Ellipse:
    """The mixture as one law about its median, its axes along and across the way of the movement.

    Its widths are mean distances, so that a far target that is hardly likely makes it little larger.
    """
    x, y = centre
    size = hypot(way[0], way[1])
    ux, uy = (way[0] / size, way[1] / size) if size > 0.0 else (1.0, 0.0)
    wide, broad = 0.0, 0.0
    for k in range(count):
        part = PartRow(parts[k])
        dx, dy = part.x - x, part.y - y
        along, across = dx * ux + dy * uy, dy * ux - dx * uy
        cross = 2.0 * part.sxy * ux * uy
        wide += part.share * sqrt(along * along + part.sxx * ux * ux + cross + part.syy * uy * uy)
        broad += part.share * sqrt(across * across + part.sxx * uy * uy - cross + part.syy * ux * ux)
    wide2, broad2 = RADII2 * wide * wide, RADII2 * broad * broad
    sxx, syy = wide2 * ux * ux + broad2 * uy * uy, wide2 * uy * uy + broad2 * ux * ux
    return Ellipse(x, y, sxx, (wide2 - broad2) * ux * uy, syy, TAIL)
