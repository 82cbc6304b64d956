"""How long a person's movements took lately: a clock, and how much of the time left it gives.

The clock knows the median of the last durations and nothing of the movement; the predictor knows the movement
and nothing of the person. Five mixtures of both are judged by every finished movement; the best one is a term
of the time left.
"""

from __future__ import annotations

import numpy as np

from pointpred.compiled import law, layout
from pointpred.records import LATEST_S, FloatArray
from pointpred.stage import Slot, offsets

CAPACITY = 12
"""Durations that are remembered."""
SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Weight of the clock in each mixture."""
KEEP = 0.97
"""Forgetting factor of the mixtures' errors per movement."""
FIRST = (1.0, 0.92, 0.88, 0.9, 0.97)
"""Errors of the mixtures that are believed at first, against that of the first."""
FIRST_OF = 5.0
"""Movements that this belief counts for."""
LEAST = 0.05
"""The least answer, as a share of the predictor's: the clock runs out before late movements end."""

# Layout, relative to `at`: how many durations; the durations in s, the last first; their median; sums of
# the errors of the mixtures, as shares of the durations; how many movements these are of; the best's share.
COUNT, DURATIONS, MEDIAN, ERRORS, MOVEMENTS, BEST, LEARNED = offsets(1, CAPACITY, 1, len(SHARES), 1, 1)

SLOTS = (
    Slot("durations held", 1, 0.0, CAPACITY, whole=True),
    Slot("durations", CAPACITY, 0.0, 4.0 * LATEST_S),
    Slot("median", 1, 0.0, 4.0 * LATEST_S),
    Slot("errors", len(SHARES), 0.0, 1e30),
    Slot("movements", 1, 0.0, 1.001 / (1.0 - KEEP)),
    Slot("clock's share", 1, 0.0, 1.0),
)
"""What is known of a person's durations, in the order of the layout."""


FINE, NO_DURATION, OTHER_MEDIAN = 0, 11, 12


@law
def mixture(memory: FloatArray, at: int, share: float, since: float, left: float) -> float:
    """The time left in s, of which the clock says a share; ``left``: what the predictor says."""
    by_clock = max(memory[at + MEDIAN] - since, 0.0)
    return float(max((1.0 - share) * left + share * by_clock, LEAST * left))


@law
def mix(memory: FloatArray, at: int, since: float, left: float) -> float:
    """The time left by the best mixture; what the predictor says before any movement is known."""
    if memory[at + COUNT] == 0.0:
        return left
    return mixture(memory, at, memory[at + BEST], since, left)


@law
def judge(memory: FloatArray, at: int, since: float, predicted: float, left: float, duration: float) -> None:
    """Add the errors of the mixtures at one moment of a finished movement."""
    for k in range(len(SHARES)):
        off = mixture(memory, at, SHARES[k], since, predicted) - left
        memory[at + ERRORS + k] += abs(off) / duration


@law
def forget(memory: FloatArray, at: int) -> None:
    """Discount the errors of earlier movements."""
    for k in range(len(SHARES)):
        memory[at + ERRORS + k] *= KEEP
    memory[at + MOVEMENTS] = KEEP * memory[at + MOVEMENTS] + 1.0


@layout
def value_of_rank(values: FloatArray, at: int, count: int, rank: int) -> float:
    """The value that would stand at a place if the values were sorted."""
    for i in range(at, at + count):
        before = 0
        for j in range(at, at + count):
            if values[j] < values[i] or (values[j] == values[i] and j < i):
                before += 1
        if before == rank:
            return float(values[i])
    return np.nan


@layout
def median(values: FloatArray, at: int, count: int) -> float:
    """The median of some values, bit for bit that of ``np.median``, which takes a second to compile."""
    upper = value_of_rank(values, at, count, count // 2)
    return upper if count % 2 else (value_of_rank(values, at, count, count // 2 - 1) + upper) / 2.0


@layout
def fault(learned: FloatArray) -> tuple[int, float]:
    """What is wrong with numbers that are within the bounds of their slots, and the number that is wrong."""
    count = int(learned[COUNT])
    for i in range(count):
        if not learned[DURATIONS + i] > 0.0:
            return NO_DURATION, learned[DURATIONS + i]
    if count > 0 and learned[MEDIAN] != median(learned, DURATIONS, count):
        return OTHER_MEDIAN, learned[MEDIAN]
    return FINE, 0.0


def doubt(learned: FloatArray) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, value = fault(learned)
    return {
        FINE: "",
        NO_DURATION: f"durations: each must be above 0 s, one is {value:g} s",
        OTHER_MEDIAN: f"median must be that of the durations, is {value:g} s",
    }[wrong]


@law
def remember(memory: FloatArray, at: int, duration: float) -> None:
    """Take in the duration of a finished movement, and choose the mixture again."""
    count = int(min(memory[at + COUNT] + 1.0, CAPACITY))
    for j in range(count - 1, 0, -1):
        memory[at + DURATIONS + j] = memory[at + DURATIONS + j - 1]
    memory[at + COUNT], memory[at + DURATIONS] = count, duration
    memory[at + MEDIAN] = median(memory, at + DURATIONS, count)
    usual = memory[at + ERRORS] / max(memory[at + MOVEMENTS], 1.0)
    least = np.inf
    for k in range(len(SHARES)):
        error = memory[at + ERRORS + k] + FIRST_OF * FIRST[k] * usual
        if error < least:
            least, memory[at + BEST] = error, SHARES[k]
