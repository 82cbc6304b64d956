"""The trials on which the best predictor errs most, replayed, so that they can be drawn."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pointpred.pipeline import Pipeline
from pointpred.scoring.replay import answers_to
from pointpred.scoring.results import PredictorErrors, SetScore, WorstTrial, WorstTrials
from pointpred.scoring.summary import FLOOR
from pointpred.scoring.trials import Prepared


def worst_trials(
    score: SetScore, prepared: Prepared, pipelines: Mapping[str, Pipeline], count: int
) -> WorstTrials:
    """The ``count`` trials with the largest time-averaged error of the set's best predictor.

    The best is the one with the lowest mean error apart from ``hold``, which stands in where there is no
    other, or nothing to be better than. Trials in which the pipeline failed are left out.
    """
    errors, chosen = worst_of(score, count)
    return WorstTrials(
        errors.name,
        tuple(
            WorstTrial(
                score.trials[k],
                prepared.rows(k),
                answers_to(prepared, pipelines[errors.name], k),
                float(errors.time_averaged[k]),
            )
            for k in chosen
        ),
    )


def worst_of(score: SetScore, count: int) -> tuple[PredictorErrors, list[int]]:
    """The set's best predictor, and the numbers of the trials on which it errs most, the worst first."""
    errors = _best(score)
    failed = {(skip.user, skip.trial) for skip in errors.failed}
    order = np.argsort(-errors.time_averaged, kind="stable").tolist()
    names = [(one.trial.user, one.trial.trial) for one in score.trials]
    return errors, [k for k in order if names[k] not in failed][:count]


def _best(score: SetScore) -> PredictorErrors:
    floor = next(errors for errors in score.predictors if errors.name == FLOOR)
    others = [errors for errors in score.predictors if errors is not floor]
    if not others or not score.trials or floor.time_averaged.mean() == 0.0:
        return floor
    return min(others, key=lambda errors: float(errors.time_averaged.mean()))
