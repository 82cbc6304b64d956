"""How long a person's movements took lately: a clock, and how much of the time left is told by it.

The clock knows the median of the last durations and nothing of the movement; the predictor knows the movement
and nothing of the person. Five mixtures of both are judged by every finished movement; the best one answers.
"""

from __future__ import annotations

import numpy as np

from pointpred.columns import FloatArray
from pointpred.compiled import law
from pointpred.events import LATEST_S
from pointpred.stage import Slot

KEPT = 12
SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""How much the clock says in each mixture."""
KEEP = 0.97
"""What stays, with each movement, of what earlier ones said of the mixtures."""
FIRST = (1.0, 0.92, 0.88, 0.9, 0.97)
"""Errors of the mixtures that are believed at first, against that of the first."""
FIRST_OF = 5.0
"""Movements that this belief counts for."""
LEAST = 0.05
"""Share of what the predictor says that is said at least: the clock runs out before late movements end."""

# Layout, relative to `at`: how many durations; the durations in s, the last first; their median; sums of
# the errors of the mixtures, as shares of the durations; how many movements these are of; the best's share.
HELD, DURATIONS = 0, 1
MEDIAN = DURATIONS + KEPT
ERRORS = MEDIAN + 1
COUNT = ERRORS + len(SHARES)
BEST = COUNT + 1
LEARNED = BEST + 1

SLOTS = (
    Slot("durations held", 1, 0.0, KEPT, whole=True),
    Slot("durations", KEPT, 0.0, 4.0 * LATEST_S),
    Slot("median", 1, 0.0, 4.0 * LATEST_S),
    Slot("errors", len(SHARES), 0.0, 1e30),
    Slot("movements", 1, 0.0, 1.001 / (1.0 - KEEP)),
    Slot("clock's share", 1, 0.0, 1.0),
)
"""What is known of a person's durations, in the order of the layout."""


def doubt(known: FloatArray) -> str:
    """What is wrong with numbers that are within the bounds of their slots; empty for nothing."""
    held = int(known[HELD])
    durations = known[DURATIONS : DURATIONS + held]
    if held and not durations.min() > 0.0:
        return f"durations: each of the {held} that are held must be above 0 s"
    if held and known[MEDIAN] != np.median(durations):
        return f"median must be that of the durations, {np.median(durations):g} s, is {known[MEDIAN]:g} s"
    return ""


@law
def mixture(memory: FloatArray, at: int, share: float, since: float, left: float) -> float:
    """The time left in s, of which the clock says a share; ``left``: what the predictor says."""
    by_clock = max(memory[at + MEDIAN] - since, 0.0)
    return float(max((1.0 - share) * left + share * by_clock, LEAST * left))


@law
def mixed(memory: FloatArray, at: int, since: float, left: float) -> float:
    """The time left by the best mixture; what the predictor says before any movement is known."""
    if memory[at + HELD] == 0.0:
        return left
    return mixture(memory, at, memory[at + BEST], since, left)


@law
def judge(memory: FloatArray, at: int, since: float, said: float, left: float, duration: float) -> None:
    """Add the errors of the mixtures at one moment of a finished movement."""
    for k in range(len(SHARES)):
        off = mixture(memory, at, SHARES[k], since, said) - left
        memory[at + ERRORS + k] += abs(off) / duration


@law
def forget(memory: FloatArray, at: int) -> None:
    """A movement has ended: what earlier ones said counts less."""
    for k in range(len(SHARES)):
        memory[at + ERRORS + k] *= KEEP
    memory[at + COUNT] = KEEP * memory[at + COUNT] + 1.0


@law
def ranked(values: FloatArray, at: int, count: int, rank: int) -> float:
    """The value that would stand at a place if the values were sorted."""
    for i in range(at, at + count):
        before = 0
        for j in range(at, at + count):
            if values[j] < values[i] or (values[j] == values[i] and j < i):
                before += 1
        if before == rank:
            return float(values[i])
    return np.nan


@law
def middle(values: FloatArray, at: int, count: int) -> float:
    """The median of some values, bit for bit that of ``np.median``, which takes a second to compile."""
    upper = ranked(values, at, count, count // 2)
    return upper if count % 2 else (ranked(values, at, count, count // 2 - 1) + upper) / 2.0


@law
def remember(memory: FloatArray, at: int, duration: float) -> None:
    """Take the duration of a finished movement in, and choose the mixture anew."""
    held = int(min(memory[at + HELD] + 1.0, KEPT))
    for j in range(held - 1, 0, -1):
        memory[at + DURATIONS + j] = memory[at + DURATIONS + j - 1]
    memory[at + HELD], memory[at + DURATIONS] = held, duration
    memory[at + MEDIAN] = middle(memory, at + DURATIONS, held)
    usual = memory[at + ERRORS] / max(memory[at + COUNT], 1.0)
    least = np.inf
    for k in range(len(SHARES)):
        error = memory[at + ERRORS + k] + FIRST_OF * FIRST[k] * usual
        if error < least:
            least, memory[at + BEST] = error, SHARES[k]
