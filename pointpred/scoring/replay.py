"""A pipeline over every trial of a set: spans of whole trials as columns, in threads."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from functools import partial
from itertools import chain

import msgspec
import numpy as np

from pointpred.differentiators import Differentiator
from pointpred.pipeline import Pipeline, run
from pointpred.recording import Skip
from pointpred.records import FloatArray, PredictionColumns
from pointpred.scoring.measures import endpoint
from pointpred.scoring.measures.time_left import clock_s
from pointpred.scoring.measures.trial_measures import TrialMeasures, measure_trials
from pointpred.scoring.predictions import PredictedElsewhere
from pointpred.scoring.results import WITH_TARGETS, PredictorErrors
from pointpred.scoring.spans import each_in_threads, spans, users
from pointpred.scoring.trials import Prepared


class GivenTargets(Pipeline):
    """A pipeline that is told before each trial what it can be for: ``Prepared.candidates``."""


def given_targets(pattern: Pipeline) -> GivenTargets:
    """The same pipeline, fresh, with the targets of each trial."""
    fresh = pattern.fresh()
    given = GivenTargets(pattern.name + WITH_TARGETS, fresh.differentiator, fresh.predictor)
    given.aim = fresh.aim
    return given


def by_person(pipeline: Pipeline) -> bool:
    """Whether the trials of a person stay together: they teach, or tell what the targets of a block are."""
    return pipeline.learns or isinstance(pipeline, GivenTargets)


class _Span(msgspec.Struct, frozen=True):
    """Trials ``first`` up to ``stop``, measured."""

    first: int
    stop: int
    measures: TrialMeasures
    failed: tuple[Skip, ...]
    events: int
    seconds: float


class SharedMotions:
    """The motions of a set's trials, made once for all pipelines that have the same differentiator.

    Memory: 80 bytes an event for each differentiator. For one thread.
    """

    def __init__(self, prepared: Prepared) -> None:
        self._events = prepared.events
        self._known: dict[tuple[object, ...], tuple[FloatArray, float]] = {}

    def of(self, differentiator: Differentiator, first: int, stop: int) -> tuple[FloatArray, float]:
        """The motions of rows ``first`` up to ``stop``, which begin a trial, and the seconds they took."""
        fresh = differentiator.fresh()
        key = (type(fresh), fresh.remembered(), first, stop)
        if key not in self._known:
            events = self._events.rows(first, stop)
            before = time.thread_time()
            motions = fresh.walk(events.begin, events.table)
            self._known[key] = motions, time.thread_time() - before
        return self._known[key]


class Measured(msgspec.Struct, frozen=True):
    """What one pipeline came to in some trials, a row a trial."""

    name: str
    measures: TrialMeasures
    failed: tuple[Skip, ...]
    events: int
    seconds: float
    """Processor time within ``run``."""


def replay(
    prepared: Prepared,
    pipeline: Pipeline,
    *,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
) -> PredictorErrors:
    """Run a pipeline over every trial, reset at each onset, and measure its errors.

    The pipeline given is a pattern: fresh ones do the work. One that learns goes through all trials of a
    user in the recording's order, and meets each user knowing nobody. The answers are those that ``update``
    would give event by event, bit for bit. One of ``given_targets`` has the candidates of each trial. A trial
    in which a pipeline fails (it raises, or answers what is not finite) is scored as if it had never answered
    there, and stands in ``failed``. ``threads``: one for each processor unless given. ``progress``: called
    with the number of events just replayed, from the thread that asked. The cost is the processor time of the
    threads within ``run``, not the wall's.
    """
    clock = clock_s([trial.arrival_s for trial in prepared.trials])
    measured = measure(prepared, pipeline, clock, threads=threads, progress=progress)
    us_per_event = 1e6 * measured.seconds / measured.events if measured.events else float("nan")
    claimed = measured.measures.claimed()
    return measured.measures.predictor_errors(pipeline.name, us_per_event, measured.failed, claimed)


def measure(
    prepared: Prepared,
    pipeline: Pipeline,
    clock: float,
    *,
    threads: int | None = None,
    progress: Callable[[int], None] | None = None,
    motions: SharedMotions | None = None,
) -> Measured:
    """``replay`` beside a clock of its own, s: where the trials are some of a set's, the set's clock.

    ``motions``: shared with other pipelines, with one thread only. Their cost counts for each of them.
    """
    with contextlib.suppress(Exception):  # what fails here fails again below, where it is reported
        run(pipeline.fresh(), prepared.events.rows(0, 1))  # machine code is loaded before time is taken
    whole = TrialMeasures.empty(len(prepared.trials))
    failed: list[Skip] = []
    events, seconds = 0, 0.0
    work = partial(_replay_in_turn, prepared, pipeline, clock, motions)
    for span in chain.from_iterable(each_in_threads(work, _turns(prepared, pipeline), threads)):
        whole.put(span.first, span.measures)
        failed.extend(span.failed)
        events += span.events
        seconds += span.seconds
        if progress is not None:
            progress(span.events)
    return Measured(pipeline.name, whole, tuple(failed), events, seconds)


def answers_to(prepared: Prepared, pipeline: Pipeline, trial: int) -> PredictionColumns:
    """What ``replay`` scored of one trial: one that learns has seen the trials of that user before it."""
    pipeline = pipeline.fresh()
    if isinstance(pipeline, PredictedElsewhere):
        return pipeline.answers(prepared, trial, trial + 1)
    if pipeline.learns:
        user = prepared.trials[trial].trial.user
        for k in range(trial):
            if prepared.trials[k].trial.user == user:
                with contextlib.suppress(Exception):  # reported by ``replay``
                    _register(prepared, pipeline, k)
                    run(pipeline, prepared.rows(k))
    _register(prepared, pipeline, trial)
    return run(pipeline, prepared.rows(trial))


def _register(prepared: Prepared, pipeline: Pipeline, trial: int) -> None:
    """Tell a pipeline that is given targets those of a trial, once it has learned from the last one."""
    if isinstance(pipeline, GivenTargets) and prepared.candidates is not None:
        pipeline.reset()
        pipeline.register(prepared.candidates.targets[trial])


def _turns(prepared: Prepared, pipeline: Pipeline) -> list[list[tuple[int, int]]]:
    """Ranges of trials that one fresh pipeline replays in turn."""
    if by_person(pipeline):
        return users([scored.trial.user for scored in prepared.trials], prepared.offsets)
    return [[span] for span in spans(prepared.offsets)]


def _replay_in_turn(
    prepared: Prepared,
    pattern: Pipeline,
    clock: float,
    motions: SharedMotions | None,
    ranges: list[tuple[int, int]],
) -> list[_Span]:
    """Replay ranges of trials with one pipeline, one range after the other."""
    pipeline = pattern.fresh()
    if isinstance(pipeline, GivenTargets):
        return [_replay_span(prepared, pipeline, clock, k, k + 1) for span in ranges for k in range(*span)]
    return [_replay_span(prepared, pipeline, clock, first, stop, motions) for first, stop in ranges]


def _replay_span(
    prepared: Prepared,
    pipeline: Pipeline,
    clock: float,
    first: int,
    stop: int,
    motions: SharedMotions | None = None,
) -> _Span:
    """Replay trials ``first`` up to ``stop`` in one call; where that fails, each on its own."""
    rows = int(prepared.offsets[first]), int(prepared.offsets[stop])
    events, shared_s = prepared.events.rows(*rows), 0.0
    before = time.thread_time()
    try:
        _register(prepared, pipeline, first)
        if isinstance(pipeline, PredictedElsewhere):
            answers = pipeline.answers(prepared, first, stop)
        elif motions is None:
            answers = run(pipeline, events)
        else:
            table, shared_s = motions.of(pipeline.differentiator, *rows)
            before = time.thread_time()
            answers = PredictionColumns(pipeline.push(events, motions=table))
    except Exception as error:  # a pipeline may be anyone's: whatever it raises is reported, not raised
        if stop - first > 1:
            twins = (pipeline if pipeline.learns else pipeline.fresh() for _ in range(first, stop))
            return _join(
                [_replay_span(prepared, twin, clock, k, k + 1) for k, twin in enumerate(twins, first)]
            )
        if isinstance(error, MemoryError):  # the machine's, not the pipeline's
            raise
        reason = f"{type(error).__name__}: {error}"
        return _unanswered(prepared, clock, first, reason, time.thread_time() - before)
    seconds = time.thread_time() - before + shared_s
    measures, faults = measure_trials(prepared, first, stop, events, answers, clock)
    failed: list[Skip] = []
    for k in np.flatnonzero(faults != endpoint.SOUND).tolist():
        reason = f"event {faults[k]}: the prediction is not finite"
        alone = _unanswered(prepared, clock, first + k, reason, 0.0)
        measures.put(k, alone.measures)
        failed.extend(alone.failed)
    return _Span(first, stop, measures, tuple(failed), len(events), seconds)


def _unanswered(prepared: Prepared, clock: float, trial: int, reason: str, seconds: float) -> _Span:
    """A trial in which the pipeline failed, measured as one without any answer."""
    events = prepared.rows(trial)
    nothing = PredictionColumns(np.full((len(events), len(PredictionColumns.names)), np.nan))
    measures, _ = measure_trials(prepared, trial, trial + 1, events, nothing, clock)
    who = prepared.trials[trial].trial
    skip = Skip(who.trial, reason, user=who.user)
    return _Span(trial, trial + 1, measures, (skip,), len(events), seconds)


def _join(parts: list[_Span]) -> _Span:
    first = parts[0].first
    joined = TrialMeasures.empty(parts[-1].stop - first)
    for span in parts:
        joined.put(span.first - first, span.measures)
    return _Span(
        first,
        parts[-1].stop,
        joined,
        tuple(skip for span in parts for skip in span.failed),
        sum(span.events for span in parts),
        sum(span.seconds for span in parts),
    )
