"""How often the predicted point lies in the target that the movement was for, where the set has one."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.scoring.measures.endpoint import moments
from pointpred.scoring.results import ScoredTrial


def targets(trials: Sequence[ScoredTrial]) -> FloatArray:
    """Centre and width of each trial's target, a row a trial, NaN where one of them is unknown."""
    rows = [(one.trial.target_x, one.trial.target_y, one.trial.target_w) for one in trials]
    table = np.array(rows, dtype=np.float64).reshape(-1, 3)
    table[~(np.isfinite(table).all(axis=1) & (table[:, 2] > 0.0))] = np.nan
    return table


@law
def hits(
    rows: FloatArray,
    answers: FloatArray,
    offsets: NDArray[np.int64],
    arrivals: NDArray[np.int64],
    discs: FloatArray,
    shares: FloatArray,
    out: FloatArray,
) -> None:
    """For each trial and share of the time: 1 where the prediction lies in the target, 0 where it does not.

    The target is the disc with its width as the diameter. Where nothing was answered the cursor's position
    is judged; NaN where the target is not known.
    """
    out[:] = np.nan
    at = np.empty(len(shares), dtype=np.int64)
    for k in range(len(offsets) - 1):
        if discs[k, 0] != discs[k, 0]:
            continue
        first, last = offsets[k] - offsets[0], offsets[k + 1] - offsets[0] - 1
        moments(rows, first, arrivals[k] - offsets[0], last, shares, at)
        for m in range(len(shares)):
            x, y = rows[at[m], 1], rows[at[m], 2]
            if answers[at[m], 1] == answers[at[m], 1]:
                x, y = answers[at[m], 1], answers[at[m], 2]
            out[k, m] = 1.0 if hypot(x - discs[k, 0], y - discs[k, 1]) <= 0.5 * discs[k, 2] else 0.0
