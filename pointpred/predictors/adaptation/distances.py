"""A person's last movement distances, and the belief in each law of the next distance.

Six laws of the next distance stand beside "nothing is known of it": kernels of three widths around the last
distances, with the last few or all of them weighing most. Each finished movement is judged by how likely
each law had made it, and the laws share the belief accordingly; some of it always flows back.
"""

from __future__ import annotations

from math import exp, log, sqrt
from typing import Annotated, NamedTuple

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.predictors.adaptation.moments import SHORTEST_PX
from pointpred.records import LARGEST, FloatArray, FloatTable

CAPACITY = 12
"""Distances that are remembered."""
LEAST = 2
"""With fewer distances the prediction stays as it is."""
WIDTHS = (0.02, 0.08, 0.35)
"""Standard deviations of the kernels, as shares of the distance."""
AGES = (1.5, 12.0)
"""After so many movements a distance weighs 1 / e."""
LAWS = len(WIDTHS) * len(AGES)
UNKNOWN_LOGS = 3.0
"""Where nothing is known the logarithm of the distance lies evenly in a range so wide: a factor of 20."""
UNKNOWN_SHARE = 0.98
"""Initial belief in "nothing is known"."""
FORGET = 0.05
"""Share of the belief that returns to its initial values per movement."""
LEAST_LIKELY = 1e-12
ARC = 0.5
"""A direction that is uncertain bends where the distance ends: its mean lies nearer."""
LOGISTIC = 1.7
"""A logistic law this much narrower resembles a normal one."""
HALVINGS = 10
"""The median is as fine as a thousandth of the span of what the distances ask for."""
NEGLIGIBLE = 1e-4
"""Parts of the product that weigh less than this share are left out."""

OFF_ONE = 1e-6
"""The sum of the belief is off 1 by less."""


class Distances(Layout):
    """What is known of a person's distances."""

    count: Annotated[float, Known("distances held", 0.0, CAPACITY, whole=True)]
    last: Annotated[FloatArray, CAPACITY, Known("distances", 0.0, 4.0 * LARGEST)]
    """The distances in px, the last first."""
    belief: Annotated[FloatArray, LAWS + 1, Known("belief", 0.0, 1.0)]
    """In each law and in none."""
    weights: Annotated[FloatTable, CAPACITY, len(WIDTHS), Known("weights", 0.0, 1.0)]
    """Of each distance under each width."""


LEAST_UNKNOWN = FORGET * UNKNOWN_SHARE
"""The belief in "nothing is known" is never less."""
FINE, TOO_SHORT, TOO_SURE, NO_SHARES = range(4)


@law
def fault(learned: Distances) -> tuple[int, float]:
    """What is wrong with numbers that are each within their bounds, and the number that is wrong."""
    count = int(learned.count)
    if count == 0:
        return FINE, 0.0
    for i in range(count):
        if not learned.last[i] >= SHORTEST_PX:
            return TOO_SHORT, learned.last[i]
    if not learned.belief[LAWS] >= LEAST_UNKNOWN:
        return TOO_SURE, learned.belief[LAWS]
    total = 0.0
    for i in range(len(learned.belief)):
        total += learned.belief[i]
    if not abs(total - 1.0) <= OFF_ONE:
        return NO_SHARES, total
    return FINE, 0.0


def doubt(learned: Distances) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, value = fault(learned.memory)
    return {
        FINE: "",
        TOO_SHORT: f"distances: each must be at least {SHORTEST_PX:g} px, one is {value:g} px",
        TOO_SURE: f"belief: that nothing is known must be at least {LEAST_UNKNOWN:g}, is {value:g}",
        NO_SHARES: f"belief must sum to 1, sums to {value:g}",
    }[wrong]


class Ahead(NamedTuple):
    """A Student law of the way that is left: ``ahead`` px along, widths along and across in px, degrees."""

    ahead: float
    wide: float
    broad: float
    tail: float


@law
def age_weight(age: int, count: int, time: float) -> float:
    """Weight of a distance ``age`` movements old, of ``count``."""
    total = 0.0
    for j in range(count):
        total += exp(-j / time)
    return float(exp(-age / time) / total)


@law
def judge(s: Distances, distance: float) -> None:
    """Share the belief among the laws by how likely each had made a distance."""
    count, total = int(s.count), 0.0
    for k in range(LAWS):
        width, time = WIDTHS[k % len(WIDTHS)], AGES[k // len(WIDTHS)]
        likely = 0.0
        for j in range(count):
            off = log(distance / s.last[j]) / width
            likely += (
                age_weight(j, count, time) * exp(-0.5 * min(off * off, 1000.0)) / (width * sqrt(2.0 * np.pi))
            )
        s.belief[k] *= max(UNKNOWN_LOGS * likely, LEAST_LIKELY)
        total += s.belief[k]
    total += s.belief[LAWS]
    for k in range(LAWS):
        first = (1.0 - UNKNOWN_SHARE) / LAWS
        s.belief[k] = (1.0 - FORGET) * s.belief[k] / total + FORGET * first
    s.belief[LAWS] = (1.0 - FORGET) * s.belief[LAWS] / total + FORGET * UNKNOWN_SHARE


@law
def remember(s: Distances, distance: float) -> None:
    """Take in the distance of a finished movement."""
    if s.count == 0.0:
        s.belief[:LAWS] = (1.0 - UNKNOWN_SHARE) / LAWS
        s.belief[LAWS] = UNKNOWN_SHARE
    if s.count >= LEAST:
        judge(s, distance)
    for j in range(CAPACITY - 1, 0, -1):
        s.last[j] = s.last[j - 1]
    s.last[0] = distance
    s.count = min(s.count + 1.0, CAPACITY)
    count = int(s.count)
    for j in range(count):
        for w in range(len(WIDTHS)):
            weight = 0.0
            for a in range(len(AGES)):
                weight += s.belief[a * len(WIDTHS) + w] * age_weight(j, count, AGES[a])
            s.weights[j, w] = weight


@law
def likelihood(s: Distances, distance: float) -> float:
    """How likely the last distances had made a distance, over what it is where nothing is known."""
    count = int(s.count)
    if count < LEAST:
        return 1.0
    likely = s.belief[LAWS]
    for j in range(count):
        for w in range(len(WIDTHS)):
            off = log(distance / s.last[j]) / WIDTHS[w]
            near = exp(-0.5 * min(off * off, 1000.0)) / (WIDTHS[w] * sqrt(2.0 * np.pi))
            likely += s.weights[j, w] * UNKNOWN_LOGS * near
    return float(likely)


@law
def combine(s: Distances, reached: float, predicted: Ahead) -> tuple[float, float, float]:
    """The way ahead and its width along, by the predicted law and the last distances: (px, px).

    The third value is how likely the law makes the last distances, over what it is where nothing is known.
    ``reached``: px from the start to the cursor. The answer is the median of the product of the law with
    each kernel, a normal law each, and of the law alone where nothing is known.
    """
    ahead, wide, broad, tail = predicted
    count = int(s.count)
    if count < LEAST:
        return ahead, wide, 1.0
    most = count * len(WIDTHS) + 1
    weight, shift, width = np.empty(most), np.empty(most), np.empty(most)
    total, low, high, parts = s.belief[LAWS], 0.0, 0.0, 1
    weight[0], shift[0], width[0] = total, 0.0, wide
    for j in range(count):
        distance = s.last[j]
        gap = distance / sqrt(1.0 + ARC * (broad / distance) ** 2) - reached - ahead
        for w in range(len(WIDTHS)):
            kernel2 = (WIDTHS[w] * distance) ** 2
            both2 = wide * wide + kernel2
            fits = (1.0 + gap * gap / both2 / tail) ** (-0.5 * (tail + 1.0)) / sqrt(2.0 * np.pi * both2)
            part = s.weights[j, w] * UNKNOWN_LOGS * distance * fits
            if part > NEGLIGIBLE * total:
                weight[parts], shift[parts] = part, gap * wide * wide / both2
                width[parts] = wide * sqrt(kernel2 / both2)
                low, high = min(low, shift[parts]), max(high, shift[parts])
                total += part
                parts += 1
    for _ in range(HALVINGS):
        middle, below = 0.5 * (low + high), 0.0
        for k in range(parts):
            off = LOGISTIC * (shift[k] - middle) / width[k]
            below += weight[k] / (1.0 + exp(min(max(off, -50.0), 50.0)))
        if below < 0.5 * total:
            low = middle
        else:
            high = middle
    middle, around = 0.5 * (low + high), 0.0
    for k in range(parts):
        around += weight[k] * (width[k] ** 2 + (shift[k] - middle) ** 2)
    return ahead + middle, min(sqrt(around / total), wide), total
