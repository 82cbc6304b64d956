"""The two levels whose regions are kept true for a person, and how the offset of each is learned.

Online conformal prediction, a quantile tracker for each level and stage of the time.

Reference: Gibbs, Candes 2021, "Adaptive conformal inference under distribution shift".
"""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.predictors.adaptation.stages import STAGES, interpolation
from pointpred.predictors.mixture import LEVELS
from pointpred.records import FloatArray
from pointpred.stage import Slot

STEP, STEP_OF, STEP_LEAST = 6.0, 5.0, 0.2
"""The step after the n-th movement is STEP / (n + STEP_OF), and never less than STEP_LEAST."""
FURTHEST = 6.0
"""Bound on an offset, the logarithm of what a squared radius or its normal radius is multiplied by."""
OFFSETS = STAGES * len(LEVELS)
"""Offsets of a kind of region: of each stage those of the levels."""
SLOT = Slot("radii of the levels", OFFSETS, -FURTHEST, FURTHEST)


@law
def offset(memory: FloatArray, at: int, share: float, which: int) -> float:
    """The offset of a level at a share of the time: on lines between the stages."""
    stage, part = interpolation(share)
    low = at + len(LEVELS) * stage + which
    return float(memory[low] + part * (memory[low + len(LEVELS)] - memory[low]))


@law
def step_after(movements: float) -> float:
    """How much is learned from the n-th movement."""
    return max(STEP / (movements + STEP_OF), STEP_LEAST)


@law
def add(memory: FloatArray, slot: int, change: float) -> None:
    """Change an offset, within its bounds."""
    memory[slot] = min(max(memory[slot] + change, -FURTHEST), FURTHEST)


@law
def learn(memory: FloatArray, at: int, share: float, which: int, inside: bool, step: float) -> None:
    """Learn from an end inside or outside the region of a level that was stated at a share of the time."""
    stage, part = interpolation(share)
    missed = LEVELS[which] - 1.0 if inside else LEVELS[which]
    low = at + len(LEVELS) * stage + which
    add(memory, low, step * (1.0 - part) * missed)
    add(memory, low + len(LEVELS), step * part * missed)
