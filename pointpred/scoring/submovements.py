"""Does a trial have sub-movements? The thesis's rule on the peaks of the speed."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointpred.columns import BoolArray, EventColumns, FloatArray
from pointpred.compiled import law
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.scoring.chunks import in_threads

PEAK_RATIO = 5.0
"""A trial is free of sub-movements when its highest speed peak is at least so many times every other."""


@law
def divide(motions: FloatArray, offsets: NDArray[np.int64], out: BoolArray) -> None:
    """Whether the second highest speed peak of each trial exceeds a fifth of the highest.

    A peak is a sample faster than the one before and not slower than the one after; the first and the last
    sample of a trial are none.
    """
    for k in range(len(offsets) - 1):
        highest, second = 0.0, 0.0
        before, now = 0.0, 0.0
        for i in range(offsets[k], offsets[k + 1]):
            after = (motions[i, 3] ** 2 + motions[i, 4] ** 2) ** 0.5
            if i > offsets[k] + 1 and before < now and now >= after:
                if now > highest:
                    highest, second = now, highest
                elif now > second:
                    second = now
            before, now = now, after
        out[k] = PEAK_RATIO * second > highest


def submovements(
    events: EventColumns, offsets: NDArray[np.int64], *, threads: int | None = None, **resolution: Any
) -> BoolArray:
    """Which trials have sub-movements; rows ``offsets[i]`` up to ``offsets[i + 1]`` are trial i.

    Assumes that the differentiator's speed shows one peak a sub-movement; it smooths the ripple of a
    hand or of a coarse clock only as far as its gains do, so noisy recordings count more sub-movements.

    The speed is the length of the velocity that the homogeneous differentiator with the thesis's gains
    finds, restarted at each row marked ``begin``. ``resolution``: ``cpi`` and ``dpi`` as for ``build``.

    Reference: Khalin 2022, section 2.6.3 (ratio 5).
    """

    def work(first: int, stop: int) -> BoolArray:
        rows = events.rows(int(offsets[first]), int(offsets[stop]))
        out = np.zeros(stop - first, dtype=np.bool_)
        divide(pattern.fresh().run(rows).table, offsets[first : stop + 1] - offsets[first], out)
        return out

    pattern = HomogeneousDifferentiator(**resolution)
    return np.concatenate([np.empty(0, dtype=np.bool_), *in_threads(work, offsets, threads)])
