"""Gradient estimators, integrated exactly over a step: of one parameter (DREM), and of several."""

from __future__ import annotations

from math import expm1

from pointpred.compiled import law
from pointpred.records import FloatArray, FloatTable


@law
def descend(theta: float, mixed: float, phi: float, gamma: float, h: float) -> float:
    """Follow theta' = gamma phi (mixed - phi theta) over ``h`` s with constant mixed and phi.

    Exactly: theta + (1 - exp(-gamma phi^2 h)) (mixed / phi - theta), written so that phi = 0 is harmless.
    No gain is too large: the estimate never passes mixed / phi.
    """
    exponent = gamma * phi * phi * h
    if exponent <= 0.0:
        return theta
    return theta - expm1(-exponent) / phi * (mixed - phi * theta)


@law
def descend_along(theta: FloatArray, w: FloatArray, gain: FloatTable, output: float, h: float) -> None:
    """Follow theta' = G w (output - w'theta) over ``h`` s with w and output constant.

    Exactly: theta moves along G w by (1 - exp(-w'G w h)) / w'G w times the error, so it never passes the
    plane w'theta = output. G is n x n, positive definite; theta stays where G w = 0.
    """
    n = len(theta)
    error, square = output, 0.0
    for i in range(n):
        error -= w[i] * theta[i]
        for j in range(n):
            square += w[i] * gain[i, j] * w[j]
    exponent = square * h
    if exponent <= 0.0:
        return
    share = -expm1(-exponent) / square * error
    for i in range(n):
        for j in range(n):
            theta[i] += share * gain[i, j] * w[j]
