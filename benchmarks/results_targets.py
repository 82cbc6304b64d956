"""Choices among targets for the results: evidence and predictor both fitted without the set they judge."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from benchmarks import targets, targets_fit
from benchmarks.held_out import HeldOut, seen, trained
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.scoring.target_choice import score_targets, target_summary
from pointpred.targets.evidence import NEAR

Json = dict[str, Any]

WORDS = """Which target a movement is for: circles found again, targets of a block, or a grid of 15 laid over
free movements ([targets.md](targets.md)). The learned predictor was fitted without the set, and so was the
evidence that turns predictions into shares; beside it *nearest to the cursor*, with evidence of its own
(no prediction). Sets whose movements have no targets that tell apart are not among them."""


def unseen(recording: Recording, name: str, held: HeldOut) -> str | Pipeline | None:
    """The predictor as it is without the recording; ``None`` where there is none."""
    if name not in trained() or recording.name not in seen():
        return name
    return held.of_set(name, recording)


def measured(sets: Sequence[Recording], held: HeldOut) -> list[Json]:
    """Every set and layout; sets whose predictor cannot be had without them are left out."""
    sets = [one for one in sets if one.name in targets_fit.SETS or one.provenance.simulated]
    claiming = {one.name: unseen(one, targets_fit.CLAIMING, held) for one in sets}
    usable = [one for one in sets if claiming[one.name] is not None]
    if len(usable) < 2:
        return []  # nothing to fit the evidence to
    cases = {}
    for one in usable:
        pattern = claiming[one.name]
        assert pattern is not None
        cases[one.name] = (
            targets_fit.cases(one, (pattern,)),
            targets_fit.cases(one, (targets_fit.SILENT,)),
        )
    found = []
    for recording in usable:
        others = [case for name, case in cases.items() if name != recording.name]
        ours, near = targets_fit.coefficients(others), targets_fit.coefficients(others, [NEAR])
        judged = [unseen(recording, name, held) for name in targets.SHOWN]
        for part in targets.apart(recording):
            print(f"choosing among targets: {part.name}", flush=True)
            names = [one for one in judged if one is not None]
            scored = score_targets(part, names, coefficients=ours, nearest=near)
            found += [target_summary(one) for one in scored]
    return found


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
