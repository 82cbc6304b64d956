"""The mean gain of a transfer function in each band of speed, and a polynomial through them.

Pointing visits low speeds far more often than high ones, and a sum over samples weighs metres per second, not
gains. In separate bands the speeds can be weighed afterwards, for example so that the largest relative error
of the gain is small (Lawson's algorithm). A band without new samples forgets nothing.
"""

from __future__ import annotations

from typing import NamedTuple

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray

BANDS = 20
ROUNDS = 6
"""Rounds of reweighting: the largest error falls quickly, further rounds fit noise."""
TRUSTED = 0.02
"""Relative error at which a band's trust is one half."""


@law
def states(n: int) -> int:
    """Floats of all bands: for each the sum of w_1 y and those of w_1 w_i, w_1 the regressor of c_1."""
    return BANDS * (1 + n)


class Bands(msgspec.Struct, frozen=True):
    """The mean gain measured in each band of speed, and its standard error."""

    speeds: FloatArray
    gains: FloatArray
    errors: FloatArray

    @property
    def trust(self) -> FloatArray:
        """In [0, 1]: one half if the gain is known to 2 %."""
        shares: FloatArray = 1.0 / (1.0 + (self.errors / self.gains / TRUSTED) ** 2)
        return shares


class Model(NamedTuple):
    """``n`` coefficients, which of them is c_1, and the forgetting factor per sample."""

    n: int
    linear: int
    forgetting: float


@law
def learn(memory: FloatArray, model: Model, band: float, row: FloatArray, output: float) -> None:
    """Add output = row . c to a band, a real number; outside the bands nothing happens."""
    if not 0.0 <= band < BANDS:
        return
    n, linear, forgetting = model
    place = int(band) * (1 + n)
    reference = row[linear]
    memory[place] = forgetting * memory[place] + reference * output
    for j in range(n):
        memory[place + 1 + j] = forgetting * memory[place + 1 + j] + reference * row[j]


def visited(memory: FloatArray, n: int, linear: int) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Bands with a positive gain: their numbers, the sums of w_1 w_1 and of w_1 y, and those of w_1 w_i."""
    table = memory[: states(n)].reshape(BANDS, 1 + n)
    weight, product = table[:, 1 + linear], table[:, 0]
    rows = np.flatnonzero((weight > 0.0) & (product > 0.0))
    return rows.astype(np.float64), weight[rows], product[rows], table[rows, 1:]


def trusted(
    memory: FloatArray, n: int, linear: int, noise: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Bands with a positive gain: (their numbers, their equations row . c = 1, trust in [0, 1]).

    ``noise`` is the standard deviation of the outputs.
    """
    numbers, weight, product, sums = visited(memory, n, linear)
    uncertainty = noise * np.sqrt(weight) / product
    return numbers, sums / product[:, None], 1.0 / (1.0 + (uncertainty / TRUSTED) ** 2)


def balance(rows: FloatArray, trust: FloatArray) -> FloatArray:
    """The coefficients for which the largest relative error of a band's gain is small.

    Least squares, repeated with weights that grow with the error (Lawson 1961).
    """
    weights = trust / trust.sum()
    lengths = np.linalg.norm(rows, axis=0)
    for _ in range(ROUNDS):
        root = np.sqrt(weights)
        coefficients = np.linalg.lstsq(rows / lengths * root[:, None], root, rcond=None)[0]
        error = np.abs(rows @ (coefficients / lengths) - 1.0)
        weights = weights * np.sqrt(np.maximum(error, 1e-12))
        weights /= weights.sum()
    balanced: FloatArray = coefficients / lengths
    return balanced
