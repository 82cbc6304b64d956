"""Score every predictor on every set at hand: ``make results``.

Sets are the embedded sample and the recordings in the folder that POINTPRED_RECORDINGS names. Each is
written to ``evidence/results/data/SET.json``; ``make docs`` shows them. What has learned from recordings is
judged by coefficients that did not see the set, or the person: ``evidence.held_out`` fits them, which takes
minutes once.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from evidence import held_out, sets
from evidence.arguments import parse
from evidence.held_out import HeldOut
from evidence.results.records import FOLDER, SetResults, write
from evidence.results.scores import scored
from pointpred import REGISTRY
from pointpred.recording import Recording
from pointpred.scoring import summarise

SEED = 0


def results_of(recording: Recording, predictors: Sequence[str], held: HeldOut) -> SetResults:
    """Every predictor on one set."""
    began = time.monotonic()
    print(f"scoring {recording.name}: {len(recording.events)} events", flush=True)
    summary = summarise(scored(recording, predictors, held, SEED))
    print(f"{recording.name}: {time.monotonic() - began:.0f} s", flush=True)
    versions = {name: version(name) for name in ("pointpred", "numpy", "numba")}
    return SetResults(versions, summary)


def measure(folder: Path | None, predictors: Sequence[str], out: Path = FOLDER) -> dict[str, str]:
    """Score every set and keep its results; returns why files could not be read, by name."""
    unread: dict[str, str] = {}
    learns = any(name in held_out.trained_predictors() for name in predictors)
    held = held_out.held_out(folder if learns else None)
    for recording in sets.recordings(folder, unread):
        print(f"wrote {write(results_of(recording, predictors, held), out)}")
    return unread


if __name__ == "__main__":
    parse(__doc__)
    for reason in measure(sets.folder(), list(REGISTRY)).values():
        print(f"not read: {reason}")
