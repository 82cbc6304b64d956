"""The two levels whose regions are kept true for a person, and how the offset of each is learned.

Online conformal prediction, a quantile tracker for each level and stage of the time.

Reference: Gibbs, Candes 2021, "Adaptive conformal inference under distribution shift".
"""

from __future__ import annotations

from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Known, Layout
from pointpred.predictors.adaptation.stages import STAGES, bounded, interpolation
from pointpred.predictors.mixture import LEVELS
from pointpred.records import FloatTable

STEP, STEP_OF, STEP_LEAST = 6.0, 5.0, 0.2
"""The step after the n-th movement is STEP / (n + STEP_OF), and never less than STEP_LEAST."""
FURTHEST = 6.0
"""Bound on an offset, the logarithm of what a squared radius or its normal radius is multiplied by."""


class Offsets(Layout):
    """The offsets of a kind of region: of each stage those of the levels."""

    values: Annotated[FloatTable, STAGES, len(LEVELS), Known("radii of the levels", -FURTHEST, FURTHEST)]


@law
def offset(s: Offsets, share: float, which: int) -> float:
    """The offset of a level at a share of the time: on lines between the stages."""
    stage, part = interpolation(share)
    low = s.values[stage, which]
    return float(low + part * (s.values[stage + 1, which] - low))


@law
def step_after(movements: float) -> float:
    """How much is learned from the n-th movement."""
    return max(STEP / (movements + STEP_OF), STEP_LEAST)


@law
def learn(s: Offsets, share: float, which: int, inside: bool, step: float) -> None:
    """Learn from an end inside or outside the region of a level that was stated at a share of the time."""
    stage, part = interpolation(share)
    missed = LEVELS[which] - 1.0 if inside else LEVELS[which]
    s.values[stage, which] = bounded(s.values[stage, which] + step * (1.0 - part) * missed, FURTHEST)
    s.values[stage + 1, which] = bounded(s.values[stage + 1, which] + step * part * missed, FURTHEST)
