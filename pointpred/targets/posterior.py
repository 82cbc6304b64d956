"""Probabilities over rectangles: the score of each target, and of none of them, as a compiled law."""

from __future__ import annotations

from math import exp, inf, log, nan

import numpy as np

from pointpred.compiled import law
from pointpred.records import LARGEST, FloatArray, Row
from pointpred.targets import coefficients as fitted
from pointpred.targets import cursor, evidence
from pointpred.targets.evidence import Law, feature, situation, unclaimed
from pointpred.targets.rectangles import LOG_WEIGHT

FEATURES = evidence.FEATURES
SET = 2 * FEATURES + 2
"""Coefficients of each feature standing, of each at the peak of the speed, and of none of them at both."""
COEFFICIENTS = 2 * SET
"""One set for a law that the predictor claims, and one for a law that stands in for it."""

FITTED: FloatArray = np.array(
    [
        *(*fitted.SLOW, *fitted.FAST, *fitted.NONE),
        *(*fitted.UNCLAIMED_SLOW, *fitted.UNCLAIMED_FAST, *fitted.UNCLAIMED_NONE),
    ]
)
"""The coefficients that come with pointpred."""
FITTED_PAGES: FloatArray = np.array(
    [
        *(*fitted.PAGES_SLOW, *fitted.PAGES_FAST, *fitted.PAGES_NONE),
        *(*fitted.PAGES_UNCLAIMED_SLOW, *fitted.PAGES_UNCLAIMED_FAST, *fitted.PAGES_UNCLAIMED_NONE),
    ]
)
"""Those for a prefetch: sharpest early in a movement over cards, links and menus."""
FITTED_NEAREST: FloatArray = np.zeros(COEFFICIENTS)
"""Coefficients of the distance from the cursor alone: the nearest target, as something to compare with."""
for _first in (0, SET):
    FITTED_NEAREST[[_first + evidence.NEAR, _first + FEATURES + evidence.NEAR]] = fitted.NEAREST
    FITTED_NEAREST[_first + 2 * FEATURES : _first + SET] = fitted.NEAREST_NONE

PRECISION, ELSEWHERE, LEAST_LEAD_S, LEAST_WAY_PX = range(4)
"""Places of a chooser's settings."""

FITTED_NONE, FITTED_TARGETS = 0.25, 16.0
"""Values in the fit: the share of movements to none of the targets, and the number of targets."""

FLATTEST = 1e-12
"""The least determinant of a region over that of one with axes along x and y: below it, it is a line."""
TAILS = (1e-3, LARGEST)
"""Bounds on the degrees of freedom of a law."""


@law
def lawful(predicted: Law) -> bool:
    """Whether a predicted law can be used: a region of finite size, and a tail that is one, or none."""
    _, _, sxx, sxy, syy, tail = predicted
    if not (
        0.0 < sxx <= LARGEST * LARGEST and 0.0 < syy <= LARGEST * LARGEST and abs(sxy) <= LARGEST * LARGEST
    ):
        return False
    return sxx * syy - sxy * sxy > FLATTEST * sxx * syy and (tail != tail or TAILS[0] <= tail <= TAILS[1])


@law
def scores(
    memory: FloatArray,
    table: FloatArray,
    answer: Row,
    coefficients: FloatArray,
    elsewhere: float,
    out: FloatArray,
) -> None:
    """The logarithm of each target's share, up to a constant; behind them that of none of them.

    ``answer`` is a ``PredictionRow``; a point beyond the bounds of positions, and a law that is
    not ``lawful``, are as if not claimed. A target of weight 0 is not looked at.
    """
    _, x, y, sxx, sxy, syy, _, _, tail, _ = answer
    claimed = abs(x) <= LARGEST and abs(y) <= LARGEST
    if not claimed:  # no prediction: the cursor itself
        x, y = memory[cursor.X], memory[cursor.Y]
    first, predicted = 0, Law(x, y, sxx, sxy, syy, tail)
    if not claimed or not lawful(predicted):
        sxx, sxy, syy = unclaimed(memory, x, y)
        first, predicted = SET, Law(x, y, sxx, sxy, syy, nan)
    now, weight = situation(memory), np.empty(FEATURES)
    fast = min(memory[cursor.SPEED] / memory[cursor.PEAK], 1.0) if memory[cursor.PEAK] > 0.0 else 0.0
    for j in range(FEATURES):
        weight[j] = (1.0 - fast) * coefficients[first + j] + fast * coefficients[first + FEATURES + j]
    count, mass = len(table), weight[0] != 0.0
    usual = log(FITTED_TARGETS * (1.0 - elsewhere) / (1.0 - FITTED_NONE))
    for i in range(count):
        if table[i, LOG_WEIGHT] == -inf:
            out[i] = -inf
            continue
        f0, f1, f2, f3, f4, f5 = feature(table[i], now, predicted, mass)
        score = weight[0] * f0 + weight[1] * f1 + weight[2] * f2
        out[i] = table[i, LOG_WEIGHT] + usual + score + weight[3] * f3 + weight[4] * f4 + weight[5] * f5
    at = first + 2 * FEATURES
    none = (1.0 - fast) * coefficients[at] + fast * coefficients[at + 1]
    out[count] = none + log(elsewhere / FITTED_NONE)


@law
def normalise(out: FloatArray) -> None:
    """Scores become shares of one; the last score is finite."""
    most = -inf
    for i in range(len(out)):
        most = max(most, out[i])
    total = 0.0
    for i in range(len(out)):
        out[i] = exp(out[i] - most)
        total += out[i]
    for i in range(len(out)):
        out[i] /= total
