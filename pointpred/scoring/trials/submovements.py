"""Does a trial have sub-movements? The thesis's rule on the peaks of the speed."""

from __future__ import annotations

from math import hypot
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.records import BoolArray, EventColumns, FloatArray
from pointpred.scoring.spans import in_threads

PEAK_RATIO = 5.0
"""A trial is free of sub-movements when its highest speed peak is at least so many times every other."""
DIP = 2.0
"""Two peaks are two, and no ripple on one, when the speed between them falls to this part of the lower."""


@law
def divided(motions: FloatArray, first: int, stop: int) -> bool:
    """Whether the second highest speed peak of these rows exceeds a fifth of the highest."""
    highest, second = 0.0, 0.0
    rising, extreme = True, 0.0
    for i in range(first, stop):
        speed = hypot(motions[i, 3], motions[i, 4])
        if (rising and speed >= extreme) or (not rising and speed <= extreme):
            extreme = speed
        elif not rising and speed > DIP * extreme:
            rising, extreme = True, speed
        elif rising and DIP * speed < extreme:
            highest, second = max(highest, extreme), max(second, min(highest, extreme))
            rising, extreme = False, speed
    if rising:  # a trial may end before its last peak has passed
        highest, second = max(highest, extreme), max(second, min(highest, extreme))
    return bool(PEAK_RATIO * second > highest)


@law
def divide(motions: FloatArray, offsets: NDArray[np.int64], out: BoolArray) -> None:
    """The same for each trial."""
    for k in range(len(offsets) - 1):
        out[k] = divided(motions, offsets[k], offsets[k + 1])


def submovements(
    events: EventColumns, offsets: NDArray[np.int64], *, threads: int | None = None, **resolution: Any
) -> BoolArray:
    """Which trials have sub-movements; rows ``offsets[i]`` up to ``offsets[i + 1]`` are trial i.

    Assumes that a sub-movement shows as a peak of the speed: pieces that overlap so far that the speed does
    not fall by half between them count as one. Whole pixels make ripples on every peak, which is why the
    fall is asked for; a clock that stutters may still make a peak of its own.

    The speed is the length of the velocity that the homogeneous differentiator with the thesis's gains
    finds, restarted at each row marked ``begin``. ``resolution``: ``cpi`` and ``dpi`` as for ``build``.

    Reference: Khalin 2022, remark 2.3.1 and section 2.6.3 (ratio 5; what a peak is, it does not say).
    """

    def work(first: int, stop: int) -> BoolArray:
        rows = events.rows(int(offsets[first]), int(offsets[stop]))
        out = np.zeros(stop - first, dtype=np.bool_)
        divide(pattern.fresh().run(rows).table, offsets[first : stop + 1] - offsets[first], out)
        return out

    pattern = HomogeneousDifferentiator(**resolution)
    return np.concatenate([np.empty(0, dtype=np.bool_), *in_threads(work, offsets, threads)])
