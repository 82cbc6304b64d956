"""Predictors that have not seen the people whom they predict."""

from __future__ import annotations

from evidence.held_out import HeldOut
from pointpred import RECOMMENDED, Pipeline, build
from pointpred.predictors import AdaptiveKinematicPredictor
from pointpred.recording import Recording
from pointpred.scoring import resolution


def pipelines(recording: Recording, held: HeldOut, sequence: int) -> dict[str, Pipeline]:
    """For each user a pipeline whose coefficients have not seen them; ``sequence`` as in the predictor."""
    start, own = f"{recording.name} ", build(RECOMMENDED, **resolution(recording, None, None))

    def unseen(fold: int) -> Pipeline:
        predictor = AdaptiveKinematicPredictor(coefficients=held.folds[fold], sequence=sequence)
        return Pipeline(own.name, own.differentiator.fresh(), predictor)

    return {who[len(start) :]: unseen(fold) for who, fold in held.fold_of.items() if who.startswith(start)}
