"""The time left, given where the movement ends: for one person a sum of what is known.

In mean durations of the person's movements it is a sum of seven terms: what the predictor says, a constant,
the clock of that mean, the difficulty of the way that is left (Fitts: log2(1 + distance / size)), this times
the predictor's and the clock's time, and how near the end is. The weights are learned as in
``predictors.adaptation.time_left``, from the person's finished movements and everybody's weights.
"""

from __future__ import annotations

from math import log
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.predictors.adaptation.time_left import LONGEST, Terms
from pointpred.records import LATEST_S

DIFFICULTY_OF = 4.0
"""A way of this difficulty counts as 1."""


KEEP = 0.98
"""Forgetting factor of the durations per movement."""
LONGER = 3.0
"""No movement counts as longer than so many mean durations."""
MOST = 1.001 / (1.0 - KEEP)


class Durations(Layout):
    """What is known of a person's durations: their sum in s, and how many."""

    total: Annotated[float, Known("sum of durations", 0.0, MOST * 4.0 * LATEST_S)]
    count: Annotated[float, Known("durations", 0.0, MOST)]


@law
def mean(s: Durations) -> float:
    """The mean duration in s; 0 where none is known."""
    return float(s.total / s.count if s.count > 0.0 else 0.0)


@law
def remember(s: Durations, duration: float) -> None:
    """Take in the duration of a finished movement, s."""
    most = LONGER * mean(s) if s.count > 0.0 else duration
    s.total = KEEP * s.total + min(duration, most)
    s.count = KEEP * s.count + 1.0


@law
def terms(predicted: float, since: float, usual: float, left_px: float, size_px: float) -> Terms:
    """What the time left is a sum of, in mean durations, of which each is ``usual`` s.

    ``predicted``: the time left by the predictor, ``since``: since the start, s; ``left_px``: from the cursor
    to the endpoint; ``size_px``: of what it ends in, at least 1.
    """
    own, passed = min(predicted / usual, LONGEST), min(since / usual, LONGEST)
    difficulty = min(log(1.0 + left_px / size_px) / (DIFFICULTY_OF * log(2.0)), LONGEST)
    near = size_px * size_px / (size_px * size_px + left_px * left_px)
    both, with_clock = min(own * difficulty, LONGEST), min(passed * difficulty, LONGEST)
    return own, 1.0, max(1.0 - passed, 0.0), difficulty, both, near, with_clock
