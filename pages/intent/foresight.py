"""ForesightJS's rule for a mouse: a straight line through the last positions meets an element's rectangle.

A port of npm's js.foresight 4.2.1 with its defaults: 8 positions, 120 ms ahead, no hit slop, each element
once. ``MousePredictor``, ``predictNextMousePosition`` and ``lineSegmentIntersectsRect`` of its source.
"""

from __future__ import annotations

from math import ceil, inf

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.targets.prefetch import contact

POSITIONS, AHEAD_S = 8, 0.12
FRAME_S = 1.0 / 60.0
"""It looks at the last position once a frame."""


@law
def frame_end(events: FloatArray, i: int, frame_s: float) -> float:
    """When the frame ends whose last event this is, s; infinite where another event of it follows.

    Frames are counted from the first event; without any (``frame_s`` 0) every event ends its own.
    """
    if frame_s == 0.0:
        return float(events[i, 0])
    begin = events[0, 0]
    number = max(ceil((events[i, 0] - begin) / frame_s - 1e-9), 1)
    due = begin + number * frame_s
    return due if i + 1 == len(events) or events[i + 1, 0] > due + 1e-9 * frame_s else inf


@law
def fire(events: FloatArray, table: FloatArray, frame_s: float, fired_at: FloatArray) -> None:
    """When each target first fires, s, into ``fired_at``; infinite where it never does.

    ``frame_s``: the last event of each frame is looked at, when the frame ends; 0 for every event.
    """
    kept = np.zeros((POSITIONS, 3))
    count = 0
    fired_at[:] = inf
    for i in range(len(events)):
        now, x, y = frame_end(events, i, frame_s), events[i, 1], events[i, 2]
        if now == inf:
            continue
        kept[count % POSITIONS, 0] = now
        kept[count % POSITIONS, 1] = x
        kept[count % POSITIONS, 2] = y
        count += 1
        first = count % POSITIONS if count >= POSITIONS else 0
        dt = now - kept[first, 0]
        dx = AHEAD_S * (x - kept[first, 1]) / dt if dt > 0.0 else 0.0
        dy = AHEAD_S * (y - kept[first, 2]) / dt if dt > 0.0 else 0.0
        for k in range(len(table)):
            if fired_at[k] == inf and contact(x, y, dx, dy, table[k]) <= 1.0:
                fired_at[k] = now
