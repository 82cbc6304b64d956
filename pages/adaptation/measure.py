"""What adaptation is worth: ``python -m pages.adaptation.measure [FOLDER]``.

Lets the learned predictor, fitted to other people, predict the movements in POINTPRED_RECORDINGS without
adaptation and with parts of it, every person's movements in order of recording. Takes minutes.
FOLDER: coefficients as ``python -m pages.held_out FOLDER`` writes them; unless given, those of the cache.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from pages.adaptation.tables import FLOOR, ORDERED, PLACED, PLAIN, UNPLACED, Measured, written
from pages.arguments import parse
from pages.held_out import HeldOut, held_out, stored
from pointpred import Pipeline, build
from pointpred.predictors import AdaptiveKinematicPredictor, KinematicPredictor
from pointpred.recording import Recording
from pointpred.records import FloatArray
from pointpred.scoring import Prepared, prepare, resolution
from pointpred.scoring import ktm_protocol as protocol
from pointpred.scoring.replay import replay
from pointpred.training import data

NEAR_PX, LAST = 40.0, 64
"""An end repeats where one of so many earlier ones of the person lies so near."""


def parts(recording: Recording, coefficients: HeldOut) -> Iterator[tuple[Recording, Path]]:
    """The recording of each fold of its people, and the coefficients that were fitted to none of them."""
    folds = np.array([coefficients.fold_of[f"{recording.name} {one.user}"] for one in recording.trials])
    for fold in np.unique(folds).tolist():
        rows = np.flatnonzero(folds == fold).tolist()
        trials = [recording.trials[k] for k in rows]
        yield (
            Recording.of(recording.name, [recording.rows(k) for k in rows], trials),
            coefficients.folds[fold],
        )


def pipelines(recording: Recording, path: Path) -> list[Pipeline]:
    """No prediction, the learned predictor, and it with more and more parts of the adaptation."""
    floor = build(FLOOR, **resolution(recording, None, None))
    predictors = {
        PLAIN: KinematicPredictor(coefficients=path),
        UNPLACED: AdaptiveKinematicPredictor(places=0, coefficients=path),
        PLACED: AdaptiveKinematicPredictor(sequence=0, coefficients=path),
        ORDERED: AdaptiveKinematicPredictor(coefficients=path),
    }
    return [floor, *(Pipeline(name, floor.differentiator.fresh(), one) for name, one in predictors.items())]


def numbered(users: list[str]) -> FloatArray:
    """Place of each trial among those of its user, from 0."""
    counts: dict[str, int] = {}
    order = []
    for user in users:
        order.append(counts.get(user, 0))
        counts[user] = order[-1] + 1
    return np.array(order, dtype=np.float64)


def repeated(prepared: Prepared) -> FloatArray:
    """For each trial whether it ends near an earlier end of its user; NaN for the first of a user."""
    earlier: dict[str, list[FloatArray]] = {}
    result = []
    for k, scored in enumerate(prepared.trials):
        rows = prepared.rows(k)
        end, ends = np.array([rows.x[-1], rows.y[-1]]), earlier.setdefault(scored.trial.user, [])
        away = np.linalg.norm(np.array(ends[-LAST:]) - end, axis=1) if ends else np.array([np.nan])
        result.append(np.nan if np.isnan(away).any() else float(away.min() <= NEAR_PX))
        ends.append(end)
    return np.array(result)


def without_set(coefficients: HeldOut) -> list[Measured]:
    """Every set as a whole, predicted by coefficients that were fitted to the other sets."""
    results = []
    for recording in data.read_sets(data.folder()):
        settings = {k: v for k, v in resolution(recording, None, None).items() if v is not None}
        prepared = prepare(recording, **settings)
        order = numbered([scored.trial.user for scored in prepared.trials])
        patterns = pipelines(recording, coefficients.set_out[recording.name])
        errors = {one.name: [replay(prepared, one, threads=1)] for one in patterns}
        results.append(Measured(recording.name, [order], [repeated(prepared)], errors, {}))
        print(
            f"{recording.name}: {len(prepared.trials)} trials, the set left out", file=sys.stderr, flush=True
        )
    return results


def measure(coefficients: HeldOut) -> list[Measured]:
    """Every set, its people predicted by coefficients that knew none of them."""
    results: dict[str, Measured] = {}
    for recording in data.read_sets(data.folder()):
        for part, path in parts(recording, coefficients):
            one = results.setdefault(part.name, Measured(part.name, [], [], {}, {True: {}, False: {}}))
            settings = {k: v for k, v in resolution(part, None, None).items() if v is not None}
            prepared = prepare(part, **settings)
            one.order.append(numbered([scored.trial.user for scored in prepared.trials]))
            one.repeated.append(repeated(prepared))
            for pipeline in pipelines(part, path):
                one.errors.setdefault(pipeline.name, []).append(replay(prepared, pipeline, threads=1))
            for monotone, reads in one.template.items():
                selection = protocol.select(prepared, only_monotone=monotone, share=1.0)
                if selection.tested:
                    matched = protocol.with_library(selection)
                    reads.setdefault(matched.name, []).append(matched.errors)
                    for pipeline in pipelines(part, path):
                        errors = protocol.without_library(selection, pipeline).errors
                        reads.setdefault(pipeline.name, []).append(errors)
            print(f"{part.name}: {len(prepared.trials)} trials with {path.name}", file=sys.stderr, flush=True)
    return list(results.values())


if __name__ == "__main__":
    named = parse(__doc__, metavar="FOLDER", most=1)
    known = stored(Path(named[0])) if named else held_out(data.folder())
    written(measure(known), without_set(known))
