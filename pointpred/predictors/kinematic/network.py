"""The small network of the learned predictor: features in, parameters of the answer out; its calibration."""

from __future__ import annotations

from math import exp, floor
from typing import Annotated

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Layout, places
from pointpred.predictors.kinematic import features
from pointpred.records import FloatArray, FloatTable

BASES = 5


class Outputs(Layout):
    """What the network says; widths, tail, time left over the time passed and spread as logarithms."""

    along: float
    """The endpoint from the cursor in reaches, along and across the direction."""
    across: float
    basis: Annotated[FloatArray, BASES]
    """Shares of the ways of the last moments."""
    wide: float
    broad: float
    tail: float
    left: float
    spread: float


ALONG, ACROSS, BASIS, WIDE, BROAD, TAIL, LEFT, SPREAD = (at for _, at in places(Outputs))
"""Where they stand in a row, as training needs it."""
_LAG_ALONG, _LAG_ACROSS = features.PLACE["lag_along"], features.PLACE["across.lag"]
BASIS_ALONG = (
    features.PLACE["v_along"],
    _LAG_ALONG + 2,
    _LAG_ALONG + 4,
    _LAG_ALONG + 7,
    features.PLACE["sub_along"],
)
"""Ways of the last moments: the endpoint may lie where they point to, in any direction."""
BASIS_ACROSS = (
    features.PLACE["across.v"],
    _LAG_ACROSS + 2,
    _LAG_ACROSS + 4,
    _LAG_ACROSS + 7,
    features.PLACE["across.sub"],
)
SIDES = (_LAG_ACROSS + 4, _LAG_ACROSS + 7)
"""Ways across whose sum says to which side a movement bends: a mirror turns it, and nothing else."""
SIDE_SOFT = 0.01
WIDTH_LOGS, TAIL_LOGS, LEFT_LOGS, SPREAD_LOGS = (-9.0, 4.0), (0.3, 4.0), (-6.0, 4.0), (-3.0, 1.5)
"""Bounds on logarithms of outputs."""
HEAD_START_S = 0.05
"""Added to the time passed, of which the time left is a multiple."""
EXTREME = 6.0
"""Inputs are cut at so many standard deviations from their mean."""
GATE_SLOPE = 1.0 / 6.0
"""A unit of a hidden layer lets through a share of its sum, which grows with the sum by this, from 0 to 1."""


class Coefficients(Layout):
    """The coefficients as one array: sizes of both hidden layers, mean and 1 / deviation of each input.

    The rest are weights (row after row, an input each) and offsets of each layer, then the ``Calibration``.
    """

    first: float
    second: float
    mean: Annotated[FloatArray, features.Values.length]
    scale: Annotated[FloatArray, features.Values.length]
    rest: Annotated[FloatArray, None]


@law
def side(values: FloatArray) -> float:
    """To which side the movement bends: between -1 and 1, near 0 while it is straight."""
    bent = values[SIDES[0]] + values[SIDES[1]]
    return float(bent / (bent * bent + SIDE_SOFT * SIDE_SOFT) ** 0.5)


@law
def layer(coefficients: Coefficients, at: int, inputs: FloatArray, sums: FloatArray) -> int:
    """Weighted sums of the inputs; returns where the next layer's weights stand in the rest.

    Inputs one after another, so that compiled and plain runs add in the same order; eight in one pass, so
    that a sum is read and written an eighth as often. The offsets are copied one by one: a slice would
    compile the words of its error.
    """
    width, count = len(sums), len(inputs)
    offset = at + count * width
    for j in range(width):
        sums[j] = coefficients.rest[offset + j]
    for k in range(count // 8):
        p, w = 8 * k, at + 8 * k * width
        a, b, c, d = inputs[p], inputs[p + 1], inputs[p + 2], inputs[p + 3]
        e, f, g, h = inputs[p + 4], inputs[p + 5], inputs[p + 6], inputs[p + 7]
        wa, wb = coefficients.rest[w:offset], coefficients.rest[w + width : offset]
        wc, wd = coefficients.rest[w + 2 * width : offset], coefficients.rest[w + 3 * width : offset]
        we, wf = coefficients.rest[w + 4 * width : offset], coefficients.rest[w + 5 * width : offset]
        wg, wh = coefficients.rest[w + 6 * width : offset], coefficients.rest[w + 7 * width : offset]
        for j in range(width):
            four = sums[j] + a * wa[j] + b * wb[j] + c * wc[j] + d * wd[j]
            sums[j] = four + e * we[j] + f * wf[j] + g * wg[j] + h * wh[j]
    for i in range(count - count % 8, count):
        value, weights = inputs[i], coefficients.rest[at + i * width : offset]
        for j in range(width):
            sums[j] += value * weights[j]
    return offset + width


@law
def activate(sums: FloatArray) -> None:
    """Replace z by z times min(max(z / 6 + 1 / 2, 0), 1) in place."""
    for j in range(len(sums)):
        sums[j] *= min(max(sums[j] * GATE_SLOPE + 0.5, 0.0), 1.0)


@law
def evaluate(coefficients: Coefficients, values: FloatArray, out: FloatArray) -> int:
    """Fill ``out`` from the values of the features; returns where the calibration stands in the rest."""
    mirror = side(values)
    count = len(values)
    inputs = np.empty(count)
    for i in range(count):
        value = values[i] * mirror if i >= features.ODD else values[i]
        value = (value - coefficients.mean[i]) * coefficients.scale[i]
        inputs[i] = min(max(value, -EXTREME), EXTREME)
    first = np.empty(int(coefficients.first))
    second = np.empty(int(coefficients.second))
    at = layer(coefficients, 0, inputs, first)
    activate(first)
    at = layer(coefficients, at, first, second)
    activate(second)
    return layer(coefficients, at, second, out)


# The calibration: factors on the network's regions, fitted to held-out people.
KNOTS = 10
"""Of the share of the time that has passed, as predicted: 0.05, 0.15 ... 0.95."""
WIDTH_FACTOR, TAIL_FACTOR, SPREAD_FACTOR, FACTORS = range(4)
"""Logarithms of what the widths, the tail, the spread of the time left are multiplied by."""


class Calibration(Layout):
    """The factors' logarithms, a row a knot."""

    table: Annotated[FloatTable, KNOTS, FACTORS]


@law
def factor(calibration: Calibration, share: float, which: int) -> float:
    """A factor at a share of the time, on lines between the knots."""
    place = min(max(share * KNOTS - 0.5, 0.0), KNOTS - 1.0)
    knot = min(floor(place), KNOTS - 2)
    low = calibration.table[knot, which]
    high = calibration.table[knot + 1, which]
    return exp(low + (place - knot) * (high - low))
