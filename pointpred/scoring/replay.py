"""A pipeline over every trial of a set: chunks of whole trials as columns, in threads."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from functools import partial
from itertools import chain

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.columns import EventColumns, FloatArray, PredictionColumns
from pointpred.pipeline import Pipeline, run
from pointpred.recording import Skip
from pointpred.scoring import calibration, metrics
from pointpred.scoring.chunks import each_in_threads, spans, users
from pointpred.scoring.results import PredictorErrors
from pointpred.scoring.trials import Prepared

Progress = Callable[[int], None]
"""Called with the number of events just replayed, from the thread that asked for the replay."""


class _Chunk(msgspec.Struct, frozen=True):
    """Trials ``first`` up to ``stop``, measured."""

    first: int
    stop: int
    measures: FloatArray
    regions: FloatArray
    failed: tuple[Skip, ...]
    events: int
    seconds: float


def replay(
    prepared: Prepared, pipeline: Pipeline, *, threads: int | None = None, progress: Progress | None = None
) -> PredictorErrors:
    """Run a pipeline over every trial, reset at each onset, and measure its errors.

    The pipeline given is a pattern: fresh ones do the work. One that learns goes through all trials of a
    user in the recording's order, and meets each user knowing nobody. The answers are those that ``update``
    would give event by event, bit for bit. A trial in which a pipeline fails (it raises, or answers what is
    not finite) is scored as if it had never answered there, and stands in ``failed``. ``threads``: one for
    each processor unless given. The cost is the processor time of the threads within ``run``, not the wall's.
    """
    with contextlib.suppress(Exception):  # what fails here fails again below, where it is reported
        run(pipeline.fresh(), prepared.events.rows(0, 1))  # machine code is loaded before time is taken
    measures = np.empty((len(prepared.trials), metrics.MEASURES))
    regions = np.empty((len(prepared.trials), calibration.WIDTH))
    failed: list[Skip] = []
    events, seconds = 0, 0.0
    work = partial(_replay_in_turn, prepared, pipeline)
    for chunk in chain.from_iterable(each_in_threads(work, _turns(prepared, pipeline), threads)):
        measures[chunk.first : chunk.stop] = chunk.measures
        regions[chunk.first : chunk.stop] = chunk.regions
        failed.extend(chunk.failed)
        events += chunk.events
        seconds += chunk.seconds
        if progress is not None:
            progress(chunk.events)
    return PredictorErrors(
        pipeline.name,
        time_averaged=measures[:, metrics.TIME_AVERAGED].copy(),
        by_time=measures[:, metrics.BY_TIME : metrics.BY_PATH].copy(),
        by_path=measures[:, metrics.BY_PATH : metrics.SINGLE_AXIS].copy(),
        single_axis=measures[:, metrics.SINGLE_AXIS :].copy(),
        coverage=measures[:, metrics.COVERAGE].copy(),
        us_per_event=1e6 * seconds / events if events else float("nan"),
        calibration=regions if (regions[:, calibration.CLAIMED] > 0.0).any() else None,
        failed=tuple(failed),
    )


def answers_to(prepared: Prepared, pipeline: Pipeline, trial: int) -> PredictionColumns:
    """What ``replay`` scored of one trial: one that learns has seen the trials of that user before it."""
    pipeline = pipeline.fresh()
    if pipeline.learns:
        user = prepared.trials[trial].trial.user
        for k in range(trial):
            if prepared.trials[k].trial.user == user:
                with contextlib.suppress(Exception):  # reported by ``replay``
                    run(pipeline, prepared.rows(k))
    return run(pipeline, prepared.rows(trial))


def _turns(prepared: Prepared, pipeline: Pipeline) -> list[list[tuple[int, int]]]:
    """Ranges of trials that one fresh pipeline replays in turn."""
    if pipeline.learns:
        return users([scored.trial.user for scored in prepared.trials], prepared.offsets)
    return [[span] for span in spans(prepared.offsets)]


def _replay_in_turn(prepared: Prepared, pattern: Pipeline, ranges: list[tuple[int, int]]) -> list[_Chunk]:
    """Replay ranges of trials with one pipeline, one range after the other."""
    pipeline = pattern.fresh()
    return [_replay_chunk(prepared, pipeline, first, stop) for first, stop in ranges]


def _replay_chunk(prepared: Prepared, pipeline: Pipeline, first: int, stop: int) -> _Chunk:
    """Replay trials ``first`` up to ``stop`` in one call; where that fails, each on its own."""
    events = prepared.events.rows(int(prepared.offsets[first]), int(prepared.offsets[stop]))
    before = time.thread_time()
    try:
        answers = run(pipeline, events)
    except Exception as error:  # a pipeline may be anyone's: whatever it raises is reported, not raised
        if stop - first > 1:
            twins = (pipeline if pipeline.learns else pipeline.fresh() for _ in range(first, stop))
            return _join([_replay_chunk(prepared, twin, k, k + 1) for k, twin in enumerate(twins, first)])
        return _unanswered(prepared, first, f"{type(error).__name__}: {error}", time.thread_time() - before)
    seconds = time.thread_time() - before
    measures, regions, faults = _measure(prepared, first, stop, events, answers)
    failed: list[Skip] = []
    for k in np.flatnonzero(faults != metrics.SOUND).tolist():
        alone = _unanswered(prepared, first + k, f"event {faults[k]}: the prediction is not finite", 0.0)
        measures[k], regions[k] = alone.measures[0], alone.regions[0]
        failed.extend(alone.failed)
    return _Chunk(first, stop, measures, regions, tuple(failed), len(events), seconds)


def _measure(
    prepared: Prepared, first: int, stop: int, events: EventColumns, answers: PredictionColumns
) -> tuple[FloatArray, FloatArray, NDArray[np.int64]]:
    """The measures and regions of trials ``first`` up to ``stop``, and where answers were not finite."""
    out = np.empty((stop - first, metrics.MEASURES))
    regions = np.empty((stop - first, calibration.WIDTH))
    faults = np.empty(stop - first, dtype=np.int64)
    offsets, arrivals = prepared.offsets[first : stop + 1], prepared.arrivals[first:stop]
    metrics.measure(events.table, answers.table, metrics.FRACTIONS, offsets, arrivals, out, faults)
    calibration.calibrate(events.table, answers.table, offsets, arrivals, regions)
    return out, regions, faults


def _unanswered(prepared: Prepared, trial: int, reason: str, seconds: float) -> _Chunk:
    """A trial in which the pipeline failed, measured as one without any answer."""
    events = prepared.rows(trial)
    nothing = PredictionColumns(np.full((len(events), len(PredictionColumns.names)), np.nan))
    measures, regions, _ = _measure(prepared, trial, trial + 1, events, nothing)
    who = prepared.trials[trial].trial
    skip = Skip(who.trial, reason, user=who.user)
    return _Chunk(trial, trial + 1, measures, regions, (skip,), len(events), seconds)


def _join(chunks: list[_Chunk]) -> _Chunk:
    return _Chunk(
        chunks[0].first,
        chunks[-1].stop,
        np.concatenate([chunk.measures for chunk in chunks]),
        np.concatenate([chunk.regions for chunk in chunks]),
        tuple(skip for chunk in chunks for skip in chunk.failed),
        sum(chunk.events for chunk in chunks),
        sum(chunk.seconds for chunk in chunks),
    )
