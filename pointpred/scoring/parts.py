"""A set that is scored in parts: each holds some of its trials; together they are the set."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from operator import or_

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline
from pointpred.predictors import KinematicPredictor
from pointpred.recording import Recording, Skip
from pointpred.scoring.measures.trial_measures import Claimed, TrialMeasures
from pointpred.scoring.replay import Measured, Progress, SharedMotions, measure
from pointpred.scoring.results import ScoredTrial, SetScore
from pointpred.scoring.trials import Prepared

IN_COUNTS = "positions are counts of the device and not pixels: what is called px is counts"
NO_CLAIM = Claimed(regions=False, times=False, intervals=False, targets=False)


class ScoredPart(msgspec.Struct, frozen=True):
    """Some trials of a set, measured with every predictor."""

    trials: tuple[ScoredTrial, ...]
    unread: tuple[Skip, ...]
    """Trials that the reader left out."""
    unscored: tuple[Skip, ...]
    """Trials that cannot be scored."""
    measured: tuple[Measured, ...]


class PartOutcome(msgspec.Struct, frozen=True):
    """What a part adds to its set beside the rows of its trials."""

    unread: tuple[Skip, ...]
    unscored: tuple[Skip, ...]
    claimed: tuple[Claimed, ...]
    failed: tuple[tuple[Skip, ...], ...]
    events: tuple[int, ...]
    seconds: tuple[float, ...]


def score_part(
    recording: Recording,
    prepared: Prepared,
    pipelines: Mapping[str, Pipeline],
    clock: float,
    *,
    threads: int | None = 1,
    progress: Progress | None = None,
) -> ScoredPart:
    """Measure the trials of a part with every pipeline; ``clock``: the set's median duration, s."""
    motions = SharedMotions(prepared) if threads == 1 else None
    return ScoredPart(
        prepared.trials,
        recording.skipped,
        prepared.skipped[len(recording.skipped) :],
        tuple(
            measure(prepared, pipeline, clock, threads=threads, progress=progress, motions=motions)
            for pipeline in pipelines.values()
        ),
    )


def outcome(part: ScoredPart) -> PartOutcome:
    """What a part adds to its set beside the rows of its trials."""
    return PartOutcome(
        part.unread,
        part.unscored,
        tuple(one.measures.claimed() for one in part.measured),
        tuple(one.failed for one in part.measured),
        tuple(one.events for one in part.measured),
        tuple(one.seconds for one in part.measured),
    )


def set_without_trials(
    about: Recording, pipelines: Mapping[str, Pipeline], outcomes: Sequence[PartOutcome], seed: int
) -> SetScore:
    """Everything of a set but what has a row a trial: ``about`` needs no trials, outcomes have an order."""
    counted = about.provenance.unit == "counts"
    predictors = []
    for place, pipeline in enumerate(pipelines.values()):
        events = sum(one.events[place] for one in outcomes)
        seconds = sum(one.seconds[place] for one in outcomes)
        errors = TrialMeasures.empty(0).predictor_errors(
            pipeline.name,
            1e6 * seconds / events if events else float("nan"),
            tuple(skip for one in outcomes for skip in one.failed[place]),
            reduce(or_, (one.claimed[place] for one in outcomes), NO_CLAIM),
        )
        predictors.append(msgspec.structs.replace(errors, seen=_fitted_to(about.name, pipeline)))
    return SetScore(
        about.name,
        (),
        (
            *about.skipped,
            *(skip for one in outcomes for skip in one.unread),
            *(skip for one in outcomes for skip in one.unscored),
        ),
        tuple(predictors),
        simulated=about.provenance.simulated,
        seed=seed,
        notes=(*about.notes, IN_COUNTS) if counted else about.notes,
        unit="counts" if counted else "px",
    )


def with_trials(about: SetScore, parts: Iterable[ScoredPart]) -> SetScore:
    """The set with the rows of the trials of some of its parts."""
    listed = list(parts)
    predictors = []
    for place, errors in enumerate(about.predictors):
        measures = [part.measured[place].measures for part in listed]
        names = TrialMeasures.__struct_fields__
        joined = TrialMeasures(*(np.concatenate([getattr(one, name) for one in measures]) for name in names))
        claimed = Claimed(
            regions=errors.calibration is not None,
            times=errors.time_left is not None,
            intervals=errors.time_inside_by_time is not None,
            targets=errors.hits is not None,
        )
        rows = joined.predictor_errors(errors.name, errors.us_per_event, errors.failed, claimed)
        predictors.append(msgspec.structs.replace(rows, seen=errors.seen))
    trials = tuple(trial for part in listed for trial in part.trials)
    return msgspec.structs.replace(about, trials=trials, predictors=tuple(predictors))


def _fitted_to(name: str, pipeline: Pipeline) -> bool:
    """Whether a pipeline was fitted to a set of this name, whatever folder stands before it."""
    predictor = pipeline.predictor
    return isinstance(predictor, KinematicPredictor) and predictor.saw(name.rpartition("/")[2])
