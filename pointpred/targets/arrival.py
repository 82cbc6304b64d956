"""The time left, given where the movement ends: for one person a sum of what is known.

In medians of the person's last durations it is a sum of seven terms: what the predictor says, a constant, the
clock of the median, the difficulty of the way that is left (Fitts: log2(1 + distance / size)), this times the
predictor's and the clock's time, and how near the end is. The weights are learned as in
``predictors.adaptation.time_left``, from the person's finished movements and everybody's weights.
"""

from __future__ import annotations

from math import log

from pointpred.compiled import law
from pointpred.predictors.adaptation.time_left import LONGEST, Terms

DIFFICULTY_OF = 4.0
"""A way of this difficulty counts as 1."""


@law
def terms(predicted: float, since: float, median: float, left_px: float, size_px: float) -> Terms:
    """What the time left is a sum of, in medians of the last durations.

    ``predicted``: the time left by the predictor, ``since``: since the start, s; ``left_px``: from the cursor
    to the endpoint; ``size_px``: of what it ends in, at least 1.
    """
    own, passed = min(predicted / median, LONGEST), min(since / median, LONGEST)
    difficulty = min(log(1.0 + left_px / size_px) / (DIFFICULTY_OF * log(2.0)), LONGEST)
    near = size_px * size_px / (size_px * size_px + left_px * left_px)
    both, with_clock = min(own * difficulty, LONGEST), min(passed * difficulty, LONGEST)
    return own, 1.0, max(1.0 - passed, 0.0), difficulty, both, near, with_clock
