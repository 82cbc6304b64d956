"""Recordings and predictors to scores: what a trial is, replay, measures, intervals, tables."""

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
from pointpred.scoring.results import PredictorErrors, ScoredTrial, SetScore
from pointpred.scoring.summary import (
    FLOOR,
    Document,
    PredictorSummary,
    SetSummary,
    Unread,
    document,
    summarise,
)
from pointpred.scoring.summary.bootstrap import DRAWS
from pointpred.scoring.table import HEADINGS, footnotes, rows
from pointpred.scoring.trials import Prepared, prepare, resolution
from pointpred.scoring.worst import worst_trials

Progress = Callable[[str, int, int], None]
"""Called with the set's name, the events replayed so far and all events to replay for it."""

IN_COUNTS = ("positions are counts of the device and not pixels: what is called px is counts",)

__all__ = [
    "FLOOR",
    "HEADINGS",
    "Document",
    "PredictorErrors",
    "PredictorSummary",
    "Prepared",
    "Progress",
    "ScoredTrial",
    "SetScore",
    "SetSummary",
    "Unread",
    "document",
    "footnotes",
    "prepare",
    "replay",
    "rows",
    "score",
    "summarise",
    "summary",
]


def summary(score: SetScore, *, draws: int = DRAWS) -> dict[str, Any]:
    """``summarise`` as plain dictionaries."""
    plain: dict[str, Any] = msgspec.to_builtins(summarise(score, draws=draws), str_keys=True)
    return plain


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
    """Score predictors on recordings, each recording on its own: distances differ, errors are never pooled.

    ``predictors``: names of the registry, or pipelines as patterns; ``hold`` is always scored and first.
    ``parameters``: what ``build`` is given for a name. ``cpi`` and ``dpi`` (counts and px per inch) replace
    what a recording says of itself. ``threads``: one a processor unless given. ``seed`` fixes the resampling
    behind the intervals. Raises ParameterError for an unknown name or a name given twice, and for a ``cpi``
    or ``dpi`` out of bounds. Recordings may come one by one from a generator; one that cannot be scored is
    told to ``failed`` and the others are scored, or its error is raised where nobody listens. ``worst``:
    how many trials with the largest errors of the best predictor are kept to be drawn.

    >>> from pointpred.columns import EventColumns
    >>> from pointpred.recording import Trial
    >>> path = EventColumns.of(t=[0.0, 0.1, 0.2, 0.3], x=[0, 1, 60, 101], y=[0, 0, 0, 0])
    >>> one = score([Recording.of("one", [path], [Trial("ann", "1")])], ["hold"])[0]
    >>> one.predictors[0].time_averaged.tolist()  # 0.05 s at 100 px, 0.05 s at 41 px
    [70.5]
    """
    given = [p.name if isinstance(p, Pipeline) else p for p in predictors]
    for name in given:
        if given.count(name) > 1:
            raise ParameterError(f"each predictor at most once, received {name!r} {given.count(name)} times")
    chosen = {FLOOR: FLOOR} | dict(zip(given, predictors, strict=True))
    known = parameters or {}
    for predictor in chosen.values():
        if isinstance(predictor, str):
            build(predictor, cpi=cpi, dpi=96.0 if dpi is None else dpi, **known.get(predictor, {}))
    scores = []
    for recording in recordings:
        try:
            scores.append(_score(recording, chosen, known, threads, progress, cpi, dpi, seed, worst))
        except Exception as error:
            if failed is None:
                raise
            failed(recording, error)
    return scores


def _score(
    recording: Recording,
    chosen: dict[str, str | Pipeline],
    known: Mapping[str, Mapping[str, Any]],
    threads: int | None,
    progress: Progress | None,
    cpi: float | None,
    dpi: float | None,
    seed: int,
    worst: int,
) -> SetScore:
    """Score one recording."""
    settings = resolution(recording, cpi, dpi)
    counted = recording.provenance.unit == "counts"
    pipelines = [
        p if isinstance(p, Pipeline) else build(p, **settings, **known.get(p, {})) for p in chosen.values()
    ]
    prepared = prepare(recording, **settings, threads=threads)
    total, done = len(prepared.events) * len(pipelines), 0

    def advance(events: int) -> None:
        nonlocal done
        done += events
        if progress is not None:
            progress(recording.name, done, total)

    scored = SetScore(
        recording.name,
        prepared.trials,
        prepared.skipped,
        tuple(
            msgspec.structs.replace(
                replay(prepared, pipeline, threads=threads, progress=advance),
                seen=_seen(pipeline, recording.name),
            )
            for pipeline in pipelines
        ),
        simulated=recording.provenance.simulated,
        seed=seed,
        notes=(*recording.notes, *IN_COUNTS[:counted]),
        unit="counts" if counted else "px",
    )
    if not worst:
        return scored
    patterns = {pipeline.name: pipeline for pipeline in pipelines}
    return msgspec.structs.replace(scored, worst=worst_trials(scored, prepared, patterns, worst))


def _seen(pipeline: Pipeline, name: str) -> bool:
    """Whether a pipeline has learned from the set, known by its name without the folder put before it."""
    predictor = pipeline.predictor
    return isinstance(predictor, KinematicPredictor) and predictor.saw(name.rpartition("/")[2])
