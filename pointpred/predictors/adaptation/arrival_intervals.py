"""Keeps the intervals of the arrival true for one person: those of 50 and 80 %.

The interval of a level reaches as far in the logarithm of the time left as a normal law of the stated spread
says. Each finished movement is judged at shares of its time: did the arrival lie inside the interval of 50 %
that was stated there, and inside that of 80 %? The spread grows where intervals held too few arrivals and
shrinks where they held too many (online conformal prediction). There is one spread for both levels: where
the errors are not normal, their misses cancel.

Reference: Gibbs, Candes 2021, "Adaptive conformal inference under distribution shift".
"""

from __future__ import annotations

from math import exp, log
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.predictors.adaptation.stages import bounded, interpolation_among
from pointpred.records import FloatArray

LEVELS = (0.5, 0.8)
DEVIATIONS = (0.6744897501960817, 1.2815515655446004)
"""Deviations of a normal law within which its middle LEVELS lie."""
STAGES = 3
"""Of the share of the time that has passed: 1/6, 3/6 and 5/6."""
SPREAD = 0.6
"""The spread at first."""
SHARES = (2.0 / 3.0, 4.0 / 3.0)
"""Weights of the levels: a miss of the second costs more, because most errors have heavier tails."""
STEP, STEP_OF, STEP_LEAST = 12.0, 5.0, 0.15
"""The step after the n-th movement is STEP / (n + STEP_OF), and never less than STEP_LEAST."""
FURTHEST = 3.0
"""Bound on the logarithm of what the spread is multiplied by."""
MOVEMENTS_MOST = 1e6
"""The count stops here: the step has long been at its least."""


class Intervals(Layout):
    """What is known of a person's intervals."""

    movements: Annotated[float, Known("movements with intervals", 0.0, MOVEMENTS_MOST, whole=True)]
    """Movements so far."""
    offsets: Annotated[FloatArray, STAGES, Known("spreads", -FURTHEST, FURTHEST)]
    """At each stage, the logarithm of what the spread is multiplied by."""


@law
def spread(s: Intervals, share: float) -> float:
    """Standard deviation of the logarithm of the time left at a share of the time: lines between stages."""
    stage, part = interpolation_among(share, STAGES)
    low = s.offsets[stage]
    return float(SPREAD * exp(low + part * (s.offsets[stage + 1] - low)))


@law
def next_step(s: Intervals) -> float:
    """Count a finished movement; returns its step."""
    s.movements = min(s.movements + 1.0, MOVEMENTS_MOST)
    return float(max(STEP / (s.movements + STEP_OF), STEP_LEAST))


@law
def judge(s: Intervals, share: float, step: float, claim: tuple[float, float], left: float) -> None:
    """Change the spread by one moment: ``claim``, the time left in s and its spread; ``left`` what was left.

    A stage learns from the share of the true time that it stands for, whatever share was predicted there.
    """
    off, missed = abs(log(left / claim[0])), 0.0
    for k in range(len(LEVELS)):
        inside = off <= DEVIATIONS[k] * claim[1]
        missed += SHARES[k] * (LEVELS[k] - 1.0 if inside else LEVELS[k])
    stage, part = interpolation_among(share, STAGES)
    for side in range(2):
        change = step * missed * (part if side == 1 else 1.0 - part)
        s.offsets[stage + side] = bounded(s.offsets[stage + side] + change, FURTHEST)
