"""Moments of a movement, about evenly spread over it however long it lasts, in a fixed number of places.

When all places are taken, every second moment is dropped and their distance in time doubles.
"""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.records import ROUNDING_S, FloatArray
from pointpred.stage import offsets

# The movement, relative to its place: how many moments there are, their distance in time, the cursor at the
# last; then the moments, each of the same width, its time first.
COUNT, APART, CURSOR_X, CURSOR_Y, FIRST = offsets(1, 1, 1, 1)
T = 0
APART_S = 0.0071
"""Distance of the moments at first."""


@law
def new_moment(memory: FloatArray, at: int, cursor: tuple[float, float, float], width: int, most: int) -> int:
    """Where to write the moment of a cursor (t, x, y), its time already written; -1 for nowhere.

    Of one time the last is remembered. A cursor that stands makes no other moment drop out, however long it
    stands. ``width``: floats of a moment; ``most``: moments that are remembered.
    """
    t, x, y = cursor
    count = int(memory[at + COUNT])
    last = at + FIRST + width * (count - 1)
    if count == 0 or t != memory[last + T]:
        if count == 0:
            memory[at + APART] = APART_S
        elif t - memory[last + T] < memory[at + APART]:
            return -1
        if count == most:
            if x == memory[at + CURSOR_X] and y == memory[at + CURSOR_Y]:
                return -1
            count = most // 2
            for k in range(1, count):
                for i in range(width):
                    memory[at + FIRST + width * k + i] = memory[at + FIRST + 2 * width * k + i]
            memory[at + APART] *= 2.0
        memory[at + COUNT] = count + 1.0
        last = at + FIRST + width * count
    memory[at + CURSOR_X], memory[at + CURSOR_Y], memory[last + T] = x, y, t
    return last


@law
def moment_at(
    memory: FloatArray, at: int, k: int, span: tuple[float, float], share: float, width: int
) -> int:
    """The number of the moment at a share of the time between the start and the end in s, from ``k`` on."""
    start, end = span
    due = share * (end - start) + ROUNDING_S + 0.5 * memory[at + APART]
    while k + 1 < memory[at + COUNT] and memory[at + FIRST + width * (k + 1) + T] - start <= due:
        k += 1
    return k
