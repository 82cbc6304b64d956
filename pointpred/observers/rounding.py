"""Sums whose terms cancel: what is left of them is rounding."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray

ROUNDING = 1e-12
"""An entry below this share of its terms is rounding."""


def without_rounding(whole: FloatArray, *terms: FloatArray) -> FloatArray:
    """A sum of ``terms`` with zeros for the entries that are rounding; the sizes of the terms count.

    An entry of 1e-17 that should be 0 would count as a coupling when units are chosen, and as an f that
    still acts.

    >>> first, second = np.array([0.1 + 0.2, 0.5]), np.array([-0.3, 0.5])
    >>> without_rounding(first + second, first, second).tolist()
    [0.0, 1.0]
    """
    sizes = sum((np.abs(one) for one in terms), np.zeros_like(whole))
    return np.where(np.abs(whole) <= ROUNDING * sizes, 0.0, whole)
