"""Predictors scored on recordings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import msgspec

from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.predictors import KinematicPredictor
from pointpred.recording import Recording
from pointpred.registry import build
from pointpred.scoring.replay import replay
from pointpred.scoring.results import SetScore
from pointpred.scoring.summary import FLOOR
from pointpred.scoring.trials import prepare, resolution
from pointpred.scoring.worst import worst_trials

Progress = Callable[[str, int, int], None]
"""Called with the set's name, the events replayed so far and all events to replay for it."""

IN_COUNTS = "positions are counts of the device and not pixels: what is called px is counts"


class _Run(msgspec.Struct, frozen=True):
    """What every recording of a run is scored with."""

    patterns: dict[str, str | Pipeline]
    """Names of the registry and pipelines, by name."""
    parameters: Mapping[str, Mapping[str, Any]]
    threads: int | None
    progress: Progress | None
    cpi: float | None
    dpi: float | None
    seed: int
    worst: int


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
) -> list[SetScore]:
    """Score predictors on recordings, each by itself: distances differ, and errors are never pooled.

    ``predictors``: names of the registry, or pipelines used as patterns; ``hold`` is always scored, and
    first. ``parameters``: keyword arguments of ``build`` by name. ``cpi`` and ``dpi`` (counts and px per
    inch) replace those of a recording. ``threads``: one for each processor by default. ``seed``: of the
    resampling behind the intervals. ``worst``: how many of the trials with the largest errors of the best
    predictor are kept to be drawn.

    Recordings may come one by one from a generator. Where one cannot be scored, ``failed`` is called with it
    and the error, and the others are scored; without ``failed`` the error is raised. Raises ParameterError
    for an unknown name or one that appears twice, and for a ``cpi`` or ``dpi`` out of bounds.

    >>> from pointpred.columns import EventColumns
    >>> from pointpred.recording import Trial
    >>> path = EventColumns.of(t=[0.0, 0.1, 0.2, 0.3], x=[0, 1, 60, 101], y=[0, 0, 0, 0])
    >>> one = score([Recording.of("one", [path], [Trial("ann", "1")])], ["hold"])[0]
    >>> one.predictors[0].time_averaged.tolist()  # 0.05 s at 100 px, 0.05 s at 41 px
    [70.5]
    """
    names = [p.name if isinstance(p, Pipeline) else p for p in predictors]
    for name in names:
        if names.count(name) > 1:
            message = f"each predictor at most once, received {name!r} {names.count(name)} times"
            raise ParameterError(message, field="predictors", value=name)
    patterns = {FLOOR: FLOOR} | dict(zip(names, predictors, strict=True))
    run = _Run(patterns, parameters or {}, threads, progress, cpi, dpi, seed, worst)
    _pipelines(run, {"cpi": cpi, "dpi": 96.0 if dpi is None else dpi})  # a wrong name is no recording's fault
    scores = []
    for recording in recordings:
        try:
            scores.append(_score(recording, run))
        except Exception as error:
            if failed is None:
                raise
            failed(recording, error)
    return scores


def _score(recording: Recording, run: _Run) -> SetScore:
    """Score one recording."""
    settings = resolution(recording, run.cpi, run.dpi)
    pipelines = _pipelines(run, settings)
    prepared = prepare(recording, **settings, threads=run.threads)
    total, events_done = len(prepared.events) * len(pipelines), 0

    def advance(events: int) -> None:
        nonlocal events_done
        events_done += events
        if run.progress is not None:
            run.progress(recording.name, events_done, total)

    counted = recording.provenance.unit == "counts"
    scored = SetScore(
        recording.name,
        prepared.trials,
        prepared.skipped,
        tuple(
            msgspec.structs.replace(
                replay(prepared, pipeline, threads=run.threads, progress=advance),
                seen=_fitted_to(recording.name, pipeline),
            )
            for pipeline in pipelines.values()
        ),
        simulated=recording.provenance.simulated,
        seed=run.seed,
        notes=(*recording.notes, IN_COUNTS) if counted else recording.notes,
        unit="counts" if counted else "px",
    )
    if not run.worst:
        return scored
    return msgspec.structs.replace(scored, worst=worst_trials(scored, prepared, pipelines, run.worst))


def _pipelines(run: _Run, settings: Mapping[str, Any]) -> dict[str, Pipeline]:
    return {
        name: build(p, **settings, **run.parameters.get(p, {})) if isinstance(p, str) else p
        for name, p in run.patterns.items()
    }


def _fitted_to(name: str, pipeline: Pipeline) -> bool:
    """Whether a pipeline was fitted to a set of this name, whatever folder stands before it."""
    predictor = pipeline.predictor
    return isinstance(predictor, KinematicPredictor) and predictor.saw(name.rpartition("/")[2])
