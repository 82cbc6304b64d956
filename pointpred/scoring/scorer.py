"""Predictors scored on recordings, whole or in parts: a part holds some trials, and all parts are the set."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, KeysView, Mapping, Sequence
from functools import reduce
from operator import or_
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError, RecordingError
from pointpred.extras import require
from pointpred.pipeline import Pipeline
from pointpred.predictors import KinematicPredictor
from pointpred.recording import Recording, Skip
from pointpred.records import BoolArray
from pointpred.registry import ablation, build, settings_in
from pointpred.scoring.measures.time_left import clock_s
from pointpred.scoring.measures.trial_measures import Claimed, TrialMeasures
from pointpred.scoring.predictions import PredictedElsewhere
from pointpred.scoring.replay import (
    GivenTargets,
    Measured,
    SharedMotions,
    answers_to,
    given_targets,
    measure,
)
from pointpred.scoring.results import (
    WITH_TARGETS,
    PredictorErrors,
    ScoredTrial,
    SetScore,
    WorstTrial,
    WorstTrials,
)
from pointpred.scoring.selection import SCORED, Where, check_selection, counted, names_of, where_of
from pointpred.scoring.statistics import EVERY_PAIR
from pointpred.scoring.summary import FLOOR
from pointpred.scoring.target_layouts import with_candidates
from pointpred.scoring.trials import Prepared, prepare, resolution

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
    candidates: dict[str, int] | None = None
    """As in ``SetScore``."""


class PartOutcome(msgspec.Struct, frozen=True):
    """What a part adds to its set beside the rows of its trials."""

    unread: tuple[Skip, ...]
    unscored: tuple[Skip, ...]
    claimed: tuple[Claimed, ...]
    failed: tuple[tuple[Skip, ...], ...]
    events: tuple[int, ...]
    seconds: tuple[float, ...]
    candidates: dict[str, int] | None = None


def score_part(
    recording: Recording,
    prepared: Prepared,
    pipelines: Mapping[str, Pipeline],
    clock: float,
    *,
    threads: int | None = 1,
    progress: Callable[[int], None] | None = None,
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
        None if prepared.candidates is None else prepared.candidates.kinds,
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
        part.candidates,
    )


def set_without_trials(
    about: Recording, pipelines: Mapping[str, Pipeline], outcomes: Sequence[PartOutcome], scoring: Scoring
) -> SetScore:
    """Everything of a set but what has a row a trial: ``about`` needs no trials, outcomes have an order.

    Where no trial has candidates, predictors that are given targets are left out.
    """
    in_counts = about.provenance.unit == "counts"
    kinds: Counter[str] = Counter()
    for one in outcomes:
        kinds.update(one.candidates or {})
    predictors = []
    for place, pipeline in enumerate(pipelines.values()):
        if isinstance(pipeline, GivenTargets) and not kinds:
            continue
        events = sum(one.events[place] for one in outcomes)
        seconds = sum(one.seconds[place] for one in outcomes)
        timed = events > 0 and not isinstance(pipeline, PredictedElsewhere)
        errors = TrialMeasures.empty(0).predictor_errors(
            pipeline.name,
            1e6 * seconds / events if timed else float("nan"),
            tuple(skip for one in outcomes for skip in one.failed[place]),
            reduce(or_, (one.claimed[place] for one in outcomes), NO_CLAIM),
        )
        predictors.append(
            msgspec.structs.replace(
                errors,
                seen=_fitted_to(about.name, pipeline),
                learns=pipeline.learns,
                ablates=scoring.ablated.get(pipeline.name, ""),
            )
        )
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
        seed=scoring.seed,
        notes=(*about.notes, IN_COUNTS) if in_counts else about.notes,
        unit="counts" if in_counts else "px",
        candidates=dict(kinds) if any(isinstance(one, GivenTargets) for one in pipelines.values()) else None,
        by=scoring.by,
        contrast=scoring.contrast,
    )


def with_trials(about: SetScore, parts: Iterable[ScoredPart]) -> SetScore:
    """The set with the rows of the trials of some of its parts."""
    listed = list(parts)
    predictors = []
    for errors in about.predictors:
        measures = [one.measures for part in listed for one in part.measured if one.name == errors.name]
        names = TrialMeasures.__struct_fields__
        joined = TrialMeasures(*(np.concatenate([getattr(one, name) for one in measures]) for name in names))
        claimed = Claimed(
            regions=errors.calibration is not None,
            times=errors.time_left is not None,
            intervals=errors.time_inside_by_time is not None,
            targets=errors.hits is not None,
        )
        rows = joined.predictor_errors(errors.name, errors.us_per_event, errors.failed, claimed)
        about_rows = {name: getattr(errors, name) for name in ("seen", "learns", "ablates")}
        predictors.append(msgspec.structs.replace(rows, **about_rows))
    trials = tuple(trial for part in listed for trial in part.trials)
    return msgspec.structs.replace(about, trials=trials, predictors=tuple(predictors))


def _fitted_to(name: str, pipeline: Pipeline) -> bool:
    """Whether a pipeline was fitted to a set of this name, whatever folder stands before it."""
    predictor = pipeline.predictor
    return isinstance(predictor, KinematicPredictor) and predictor.saw(name.rpartition("/")[2])


def worst_trials(
    score: SetScore, prepared: Prepared, pipelines: Mapping[str, Pipeline], count: int, mask: BoolArray | None
) -> WorstTrials:
    """The ``count`` trials with the largest time-averaged error of the set's best predictor.

    ``mask``: which trials of ``score`` count; ``None``: all. The best is the one with the lowest mean error
    apart from ``hold``, which stands in where there is no other, or nothing to be better than. Trials in
    which the pipeline failed are left out.
    """
    errors, chosen = worst_of(score, count, mask)
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


def worst_of(score: SetScore, count: int, mask: BoolArray | None) -> tuple[PredictorErrors, list[int]]:
    """The set's best predictor, and the numbers of the trials on which it errs most, the worst first.

    ``mask``: which trials count.
    """
    best = _best(counted(score, mask)).name
    errors = next(one for one in score.predictors if one.name == best)
    failed = {(skip.user, skip.trial) for skip in errors.failed}
    order = np.argsort(-errors.time_averaged, kind="stable").tolist()
    names = [(one.trial.user, one.trial.trial) for one in score.trials]
    return errors, [k for k in order if (mask is None or mask[k]) and names[k] not in failed][:count]


def _best(score: SetScore) -> PredictorErrors:
    floor = next(errors for errors in score.predictors if errors.name == FLOOR)
    others = [errors for errors in score.predictors if errors is not floor]
    if not others or not score.trials or floor.time_averaged.mean() == 0.0:
        return floor
    return min(others, key=lambda errors: float(errors.time_averaged.mean()))


Progress = Callable[[str, int, int], None]
"""Called with the set's name, the events replayed so far and all events to replay for it."""


class Scoring(msgspec.Struct, frozen=True):
    """What every recording of a run is scored with."""

    patterns: dict[str, str | Pipeline]
    """Names of the registry with what is set, and pipelines, by name; ``hold`` first."""
    parameters: Mapping[str, Mapping[str, Any]] = {}
    """Keyword arguments of ``build`` by name."""
    cpi: float | None = None
    dpi: float | None = None
    seed: int = 0
    targets: bool = False
    """Each predictor a second time, given the targets of the trials."""
    where: Where | None = None
    """Which trials count; a predictor that learns sees the others, too."""
    by: tuple[str, ...] = ()
    contrast: tuple[str, ...] = ()
    """As in ``SetScore``."""

    def prepare(self, recording: Recording, threads: int | None) -> Prepared:
        """The trials of a recording or a part of it, with their candidates where these are asked for."""
        prepared = prepare(recording, cpi=self.cpi, dpi=self.dpi, threads=threads)
        return with_candidates(prepared) if self.targets else prepared

    def pipelines(self, recording: Recording) -> dict[str, Pipeline]:
        """Fresh pipelines for a recording."""
        return self._built(resolution(recording, self.cpi, self.dpi))

    @property
    def ablated(self) -> dict[str, str]:
        """By predictors that are others without their memory of ends and distances: those others."""
        without: dict[str, str] = {}
        for name in self.patterns:
            if (other := ablation(name)) in self.patterns:
                without |= {f"{other}{more}": f"{name}{more}" for more in ("", WITH_TARGETS)}
        return without

    def check(self) -> KeysView[str]:
        """The names of all that is scored; raises ParameterError for what is wrong whatever the recording."""
        return self._built({"cpi": self.cpi, "dpi": 96.0 if self.dpi is None else self.dpi}).keys()

    def _built(self, settings: Mapping[str, Any]) -> dict[str, Pipeline]:
        pipelines = {}
        for name, p in self.patterns.items():
            pipeline = p if isinstance(p, Pipeline) else self._build(name, p, settings)
            pipelines[name] = pipeline
            if self.targets and not isinstance(pipeline, PredictedElsewhere):
                given = given_targets(pipeline)
                pipelines[given.name] = given
        return pipelines

    def checked(self, recording: Recording) -> Recording:
        """A recording with notes, before it is scored; raises for what does not fit it."""
        check_selection(recording.trials, self.where, self.by)
        tables = (one for one in self.patterns.values() if isinstance(one, PredictedElsewhere))
        notes = [note for one in tables for note in one.check(recording)]
        return msgspec.structs.replace(recording, notes=(*recording.notes, *notes))

    def masks(
        self, name: str, parts: Callable[[], Iterable[Sequence[ScoredTrial]]]
    ) -> list[BoolArray] | None:
        """Which trials of each part of a set count; ``None``: all. Raises RecordingError where none does."""
        if self.where is None:
            return None
        names = names_of(one for trials in parts() for one in trials)
        masks = [self.where.mask(trials, names) for trials in parts()]
        if not any(mask.any() for mask in masks):
            message = f"{name}: no trial that can be scored fits where {self.where.text}"
            for own in SCORED:
                if f"{own}_condition" in names and own in self.where.text:
                    message += f". {own} is what scoring measures; the recording's own is {own}_condition"
            raise RecordingError(message)
        return masks

    def about_masks(self, masks: Sequence[BoolArray] | None) -> tuple[str, ...]:
        """What a set says of the trials that count."""
        if self.where is None or masks is None:
            return ()
        kept, every = sum(int(mask.sum()) for mask in masks), sum(map(len, masks))
        return (self.where.about(kept, every),)

    def _build(self, name: str, spelled: str, settings: Mapping[str, Any]) -> Pipeline:
        """A pipeline by its name in the registry and what is set behind it."""
        known, said = settings_in(spelled)
        pipeline = build(known, **settings, **{**self.parameters.get(known, {}), **said})
        pipeline.name = name
        return pipeline


def with_ablations(predictors: Sequence[str]) -> list[str]:
    """The names, each that remembers ends and distances followed by the same without this memory."""
    names = [one for name in predictors for one in (name, ablation(name)) if one is not None]
    return list(dict.fromkeys(names))


def scoring_with(
    predictors: Sequence[str | Pipeline],
    *,
    parameters: Mapping[str, Mapping[str, Any]] | None = None,
    cpi: float | None = None,
    dpi: float | None = None,
    seed: int = 0,
    targets: bool = False,
    where: str = "",
    by: Sequence[str] = (),
    contrast: Sequence[str] = (),
) -> Scoring:
    """The settings of a run, checked; raises ParameterError as ``score`` does."""
    names = [p.name if isinstance(p, Pipeline) else p for p in predictors]
    for name in names:
        if names.count(name) > 1:
            message = f"each predictor at most once, received {name!r} {names.count(name)} times"
            raise ParameterError(message, field="predictors", value=name)
    patterns = {FLOOR: FLOOR} | dict(zip(names, predictors, strict=True))
    rule, pair = where_of(where) if where else None, tuple(contrast)
    scoring = Scoring(patterns, parameters or {}, cpi, dpi, seed, targets, rule, tuple(by), pair)
    scored = scoring.check()
    if pair and pair != EVERY_PAIR and (len(set(pair)) != 2 or not scored >= set(pair)):
        message = f"contrast needs two of the predictors scored, {', '.join(scored)}, or all"
        raise ParameterError(f"{message}, received {', '.join(pair)}", field="contrast", value=pair)
    if pair:
        require("report", "a contrast")
    return scoring


def score(
    recordings: Iterable[Recording],
    predictors: Sequence[str | Pipeline],
    *,
    threads: int | None = None,
    progress: Progress | None = None,
    cpi: float | None = None,
    dpi: float | None = None,
    seed: int = 0,
    failed: Callable[[Recording, Exception], None] | None = None,
    parameters: Mapping[str, Mapping[str, Any]] | None = None,
    worst: int = 0,
    targets: bool = False,
    where: str = "",
    by: Sequence[str] = (),
    contrast: Sequence[str] = (),
) -> list[SetScore]:
    """Score predictors on recordings, each by itself: distances differ, and errors are never pooled.

    ``predictors``: names of the registry, also with what is set, as ``"kinematic-adaptive:places=0"``, or
    pipelines used as patterns; ``hold`` is always scored, and first. ``parameters``: keyword arguments of
    ``build`` by name. ``cpi`` and ``dpi`` (counts and px per inch) replace those of a recording.
    ``threads``: one for each processor by default. ``seed``: of the resampling behind the intervals.
    ``worst``: how many of the trials with the largest errors of the best predictor are kept to be drawn.
    ``targets``: each predictor is scored a second time as ``NAME + targets``, given all targets of a trial's
    block, and learning the person; ``SetScore.candidates`` says which.

    ``where``: only trials that fit this rule count, as ``"phase != practice"``; predictors that learn see the
    others, too. ``by``: columns whose levels the summary has as groups. ``contrast``: two predictors that it
    compares over people, or ``["all"]`` for every pair.

    Recordings may come one by one from a generator. Where one cannot be scored, ``failed`` is called with it
    and the error, and the others are scored; without ``failed`` the error is raised. Raises ParameterError
    for an unknown name or one that appears twice, and for a ``cpi`` or ``dpi`` out of bounds.

    >>> from pointpred.records import EventColumns
    >>> from pointpred.recording import Trial
    >>> path = EventColumns.of(t=[0.0, 0.1, 0.2, 0.3], x=[0, 1, 60, 101], y=[0, 0, 0, 0])
    >>> one = score([Recording.of("one", [path], [Trial("ann", "1")])], ["hold"])[0]
    >>> one.predictors[0].time_averaged.tolist()  # 0.05 s at 100 px, 0.05 s at 41 px
    [70.5]
    """
    scoring = scoring_with(
        predictors, parameters=parameters, cpi=cpi, dpi=dpi, seed=seed, targets=targets,
        where=where, by=by, contrast=contrast,
    )  # fmt: skip
    scores = []
    for recording in recordings:
        try:
            scores.append(_score(recording, scoring, threads, progress, worst))
        except Exception as error:  # as the caller asked: raised, or passed on and the others are scored
            if failed is None:
                raise
            failed(recording, error)
    return scores


def _score(
    recording: Recording, scoring: Scoring, threads: int | None, progress: Progress | None, worst: int
) -> SetScore:
    """Score one recording, as the only part of its set."""
    pipelines = scoring.pipelines(recording)
    recording = scoring.checked(recording)
    prepared = scoring.prepare(recording, threads)
    total, events_done = len(prepared.events) * len(pipelines), 0

    def advance(events: int) -> None:
        nonlocal events_done
        events_done += events
        if progress is not None:
            progress(recording.name, events_done, total)

    clock = clock_s([trial.arrival_s for trial in prepared.trials])
    whole = score_part(recording, prepared, pipelines, clock, threads=threads, progress=advance)
    about = msgspec.structs.replace(recording, skipped=())
    scored = with_trials(set_without_trials(about, pipelines, [outcome(whole)], scoring), [whole])
    masks = scoring.masks(scored.name, lambda: [scored.trials])
    mask = None if masks is None else masks[0]
    drawn = worst_trials(scored, prepared, pipelines, worst, mask) if worst else None
    notes = (*scored.notes, *scoring.about_masks(masks))
    return msgspec.structs.replace(counted(scored, mask), worst=drawn, notes=notes)
