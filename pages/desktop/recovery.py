"""How soon after a change a predictor is as good as on a desktop where nothing changed."""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from pointpred.records import FloatArray

BLOCK = 10
"""Movements that an error is taken over."""
RECOVERED = 0.02
"""How far a share of hold's error may lie above that of the steady desktop."""
RESAMPLES, SEED = 1000, 0


def shares(errors: FloatArray, floor: FloatArray) -> FloatArray:
    """Each person's error over that of ``hold``, in the 10 movements from each one on.

    Both are (people, movements), NaN where a movement was not scored; (people, movements - 9).
    """
    sums = [sliding_window_view(np.nan_to_num(one), BLOCK, axis=1).sum(axis=2) for one in (errors, floor)]
    return np.asarray(sums[0] / sums[1])


def movements_until(changed: FloatArray, steady: FloatArray, change: int) -> int | None:
    """Movements after the change until the next ten are within 0.02 of the steady desktop's.

    ``changed`` and ``steady`` are ``shares``; the median over people is compared at the same movement number.
    ``None`` where the session ends before.
    """
    apart = np.median(changed, axis=0) - np.median(steady, axis=0)
    recovered = np.flatnonzero(apart[change:] <= RECOVERED)
    return int(recovered[0]) if len(recovered) else None


def interval(changed: FloatArray, steady: FloatArray, change: int) -> tuple[int | None, int | None]:
    """The 95 % interval of ``movements_until`` when people are drawn again; ``None`` beyond the session."""
    generator, people = np.random.default_rng(SEED), len(changed)
    counts = []
    for _ in range(RESAMPLES):
        drawn = generator.integers(people, size=people)
        count = movements_until(changed[drawn], steady[drawn], change)
        counts.append(np.inf if count is None else count)
    low, high = np.quantile(counts, [0.025, 0.975], method="nearest")
    return (int(low) if np.isfinite(low) else None), (int(high) if np.isfinite(high) else None)
