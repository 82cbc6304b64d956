"""How long a person's movements took lately: a clock, and how much of the time left it gives.

The clock knows the median of the last durations and nothing of the movement; the predictor knows the movement
and nothing of the person. Five mixtures of both are judged by every finished movement; the best one is a term
of the time left.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.records import LATEST_S, FloatArray

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


class Durations(Layout):
    """What is known of a person's durations."""

    count: Annotated[float, Known("durations held", 0.0, CAPACITY, whole=True)]
    last: Annotated[FloatArray, CAPACITY, Known("durations", 0.0, 4.0 * LATEST_S)]
    """The durations in s, the last first."""
    median: Annotated[float, Known("median", 0.0, 4.0 * LATEST_S)]
    errors: Annotated[FloatArray, len(SHARES), Known("errors", 0.0, 1e30)]
    """Sums of the errors of the mixtures, as shares of the durations."""
    movements: Annotated[float, Known("movements", 0.0, 1.001 / (1.0 - KEEP))]
    """How many movements these are of."""
    best: Annotated[float, Known("clock's share", 0.0, 1.0)]


FINE, NO_DURATION, OTHER_MEDIAN = 0, 11, 12


@law
def mixture(s: Durations, share: float, since: float, left: float) -> float:
    """The time left in s, of which the clock says a share; ``left``: what the predictor says."""
    by_clock = max(s.median - since, 0.0)
    return float(max((1.0 - share) * left + share * by_clock, LEAST * left))


@law
def mix(s: Durations, since: float, left: float) -> float:
    """The time left by the best mixture; what the predictor says before any movement is known."""
    if s.count == 0.0:
        return left
    return mixture(s, s.best, since, left)


@law
def judge(s: Durations, since: float, predicted: float, left: float, duration: float) -> None:
    """Add the errors of the mixtures at one moment of a finished movement."""
    for k in range(len(SHARES)):
        off = mixture(s, SHARES[k], since, predicted) - left
        s.errors[k] += abs(off) / duration


@law
def forget(s: Durations) -> None:
    """Discount the errors of earlier movements."""
    for k in range(len(SHARES)):
        s.errors[k] *= KEEP
    s.movements = KEEP * s.movements + 1.0


@law
def value_of_rank(s: Durations, rank: int) -> float:
    """The duration that would stand at a place if they were sorted."""
    count = int(s.count)
    for i in range(count):
        before = 0
        for j in range(count):
            if s.last[j] < s.last[i] or (s.last[j] == s.last[i] and j < i):
                before += 1
        if before == rank:
            return float(s.last[i])
    return np.nan


@law
def median(s: Durations) -> float:
    """The median of the durations, bit for bit that of ``np.median``."""
    count = int(s.count)
    upper = value_of_rank(s, count // 2)
    return upper if count % 2 else (value_of_rank(s, count // 2 - 1) + upper) / 2.0


@law
def fault(learned: Durations) -> tuple[int, float]:
    """What is wrong with numbers that are each within their bounds, and the number that is wrong."""
    for i in range(int(learned.count)):
        if not learned.last[i] > 0.0:
            return NO_DURATION, learned.last[i]
    if learned.count > 0.0 and learned.median != median(learned):
        return OTHER_MEDIAN, learned.median
    return FINE, 0.0


def doubt(learned: Durations) -> str:
    """``fault`` in words; empty for nothing."""
    wrong, value = fault(learned.memory)
    return {
        FINE: "",
        NO_DURATION: f"durations: each must be above 0 s, one is {value:g} s",
        OTHER_MEDIAN: f"median must be that of the durations, is {value:g} s",
    }[wrong]


@law
def remember(s: Durations, duration: float) -> None:
    """Take in the duration of a finished movement, and choose the mixture again."""
    count = int(min(s.count + 1.0, CAPACITY))
    for j in range(count - 1, 0, -1):
        s.last[j] = s.last[j - 1]
    s.count, s.last[0] = count, duration
    s.median = median(s)
    usual = s.errors[0] / max(s.movements, 1.0)
    least = np.inf
    for k in range(len(SHARES)):
        error = s.errors[k] + FIRST_OF * FIRST[k] * usual
        if error < least:
            least, s.best = error, SHARES[k]
