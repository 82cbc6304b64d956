"""Choices among targets for the results: evidence and predictor both fitted without the set they judge."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pages.held_out import HeldOut
from pages.targets import measure as targets
from pointpred.recording import Recording

Json = dict[str, Any]

WORDS = """Which target a movement is for: circles found again, targets of a block, or a grid of 15 laid over
free movements ([targets.md](targets.md)). The learned predictor was fitted without the set, and so was the
evidence that turns predictions into shares; beside it *nearest to the cursor*, with evidence of its own
(no prediction). Sets whose movements have no targets that tell apart are not among them."""


def measured(sets: Sequence[Recording], held: HeldOut) -> list[Json]:
    """Every set and layout; sets whose predictor cannot be had without them are left out."""
    return targets.measured(sets, held)[0]


def section(sets: Sequence[Json]) -> list[str]:
    """The tables of all sets."""
    if not sets:
        return []
    return [
        "## Targets and decisions",
        WORDS,
        "### Share of movements whose likeliest target is right, %, by time",
        targets.right(list(sets)),
        "### Decisions where 80 % of proposals were right",
        targets.decisions(list(sets), "precision"),
        "### Decisions with the dial at 0.8",
        targets.decisions(list(sets), "dial"),
    ]
