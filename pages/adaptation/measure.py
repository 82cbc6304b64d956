"""What adaptation is worth on people whom no coefficient saw: ``python -m pages.adaptation.measure``.

Trains the learned predictor with each fifth of the people of POINTPRED_RECORDINGS left out in turn, lets it
predict these with and without adaptation, every person's trials in order of recording. Takes minutes;
POINTPRED_FOLDS names a folder that keeps coefficients.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from pages.adaptation.folds import coefficient_folder, coefficients, say
from pages.adaptation.tables import FLOOR, PART, PLAIN, WHOLE, Measured, written
from pages.arguments import parse
from pointpred import Pipeline, build
from pointpred.columns import FloatArray
from pointpred.predictors import AdaptiveKinematicPredictor, KinematicPredictor
from pointpred.recording import Recording
from pointpred.scoring import ktm_protocol as protocol
from pointpred.scoring import prepare, resolution
from pointpred.scoring.replay import replay


def pipelines(recording: Recording, path: Path) -> list[Pipeline]:
    """No prediction, the learned predictor, and both ways of adapting it."""
    settings = resolution(recording, None, None)
    floor = build(FLOOR, **settings)
    predictors = {
        PLAIN: KinematicPredictor(coefficients=path),
        WHOLE: AdaptiveKinematicPredictor(coefficients=path),
        PART: AdaptiveKinematicPredictor(distances=0, coefficients=path),
    }
    joined = [Pipeline(name, floor.differentiator.fresh(), one) for name, one in predictors.items()]
    return [floor, *joined]


def numbered(users: list[str]) -> FloatArray:
    """Place of each trial among those of its user, from 0."""
    counts: dict[str, int] = {}
    order = []
    for user in users:
        order.append(counts.get(user, 0))
        counts[user] = order[-1] + 1
    return np.array(order, dtype=np.float64)


def measure(where: Path) -> list[Measured]:
    """Every set, its people predicted by coefficients that knew none of them."""
    results: dict[str, Measured] = {}
    for part, path in coefficients(where):
        one = results.setdefault(part.name, Measured(part.name, [], {}, {True: {}, False: {}}))
        settings = {k: v for k, v in resolution(part, None, None).items() if v is not None}
        prepared = prepare(part, **settings)
        one.order.append(numbered([scored.trial.user for scored in prepared.trials]))
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
        say(f"{part.name}: {len(prepared.trials)} trials with {path.name}")
    return list(results.values())


if __name__ == "__main__":
    parse(__doc__)
    written(measure(coefficient_folder(os.environ.get("POINTPRED_FOLDS"))))
