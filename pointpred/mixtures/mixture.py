"""What a predictor knows of the endpoint beyond one law: places and elsewhere; the regions that follow."""

from __future__ import annotations

from functools import cached_property
from math import nan, pi

import msgspec
import numpy as np

from pointpred.mixtures import contours, density, levels
from pointpred.records import FloatArray
from pointpred.regions import ellipse, probability

POINTS = 2000
"""Points of each part by which probabilities are counted: they are off by less than 0.002."""
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
        return bool(density.density(self.parts, len(self.parts), float(x), float(y)) >= self.threshold)


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
        return np.array(rows, dtype=np.float64).reshape(-1, density.WIDTH)

    def density(self, x: float, y: float) -> float:
        """The density at a place, in 1 / px^2."""
        return density.density(self.table, len(self.parts), float(x), float(y))

    def region(self, level: float) -> LevelSet:
        """The smallest region that holds the endpoint with probability ``level``, as the predictor claims.

        It may have several pieces. Its probability in the mixture is right to within 0.002, its outlines and
        area to within 1 %; the threshold and area of a single part are exact. Raises ParameterError for a
        level outside (0, 1).
        """
        first, table, count = self.parts[0], self.table, len(self.parts)
        tail = first.tail or 2.0 / levels.LOWEST
        content = levels.probability(probability(level), tail, *self.offsets)
        threshold = density.threshold(table, count, content, POINTS)
        outlines = polygons(table, threshold)
        if count == 1:
            major, minor, _ = ellipse(content, *first.scale, first.tail or nan)
            return LevelSet(table, content, threshold, pi * major * minor, outlines)
        return LevelSet(table, content, threshold, abs(sum(map(signed_area, outlines))), outlines)


def polygons(table: FloatArray, threshold: float) -> tuple[FloatArray, ...]:
    """The outlines of the places that are denser than a threshold."""
    points, ends = np.empty((VERTICES, 2)), np.empty(POLYGONS)
    count = contours.outlines(table, len(table), threshold, points, ends)
    last = int(ends[count - 1]) if count else 0
    return tuple(np.split(points[:last], ends[: count - 1].astype(int))) if count else ()


def signed_area(polygon: FloatArray) -> float:
    """The area of a polygon, negative where it turns the other way round, in px^2."""
    x, y = (polygon - polygon[0]).T
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))
