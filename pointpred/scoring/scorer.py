"""Predictors scored on recordings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import msgspec

from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.registry import build
from pointpred.scoring.measures.time_left import clock_s
from pointpred.scoring.results import SetScore
from pointpred.scoring.scorer import outcome, score_part, set_without_trials, with_trials, worst_trials
from pointpred.scoring.summary import FLOOR
from pointpred.scoring.trials import prepare, resolution

Progress = Callable[[str, int, int], None]
"""Called with the set's name, the events replayed so far and all events to replay for it."""


class Scoring(msgspec.Struct, frozen=True):
    """What every recording of a run is scored with."""

    patterns: dict[str, str | Pipeline]
    """Names of the registry and pipelines, by name; ``hold`` first."""
    parameters: Mapping[str, Mapping[str, Any]] = {}
    """Keyword arguments of ``build`` by name."""
    cpi: float | None = None
    dpi: float | None = None
    seed: int = 0

    def pipelines(self, recording: Recording) -> dict[str, Pipeline]:
        """Fresh pipelines for a recording."""
        return self._built(resolution(recording, self.cpi, self.dpi))

    def check(self) -> None:
        """Raise ParameterError for what is wrong whatever the recording."""
        self._built({"cpi": self.cpi, "dpi": 96.0 if self.dpi is None else self.dpi})

    def _built(self, settings: Mapping[str, Any]) -> dict[str, Pipeline]:
        return {
            name: build(p, **settings, **self.parameters.get(p, {})) if isinstance(p, str) else p
            for name, p in self.patterns.items()
        }


def scoring_with(
    predictors: Sequence[str | Pipeline],
    *,
    parameters: Mapping[str, Mapping[str, Any]] | None = None,
    cpi: float | None = None,
    dpi: float | None = None,
    seed: int = 0,
) -> Scoring:
    """The settings of a run, checked; raises ParameterError as ``score`` does."""
    names = [p.name if isinstance(p, Pipeline) else p for p in predictors]
    for name in names:
        if names.count(name) > 1:
            message = f"each predictor at most once, received {name!r} {names.count(name)} times"
            raise ParameterError(message, field="predictors", value=name)
    patterns = {FLOOR: FLOOR} | dict(zip(names, predictors, strict=True))
    scoring = Scoring(patterns, parameters or {}, cpi, dpi, seed)
    scoring.check()
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

    >>> from pointpred.records import EventColumns
    >>> from pointpred.recording import Trial
    >>> path = EventColumns.of(t=[0.0, 0.1, 0.2, 0.3], x=[0, 1, 60, 101], y=[0, 0, 0, 0])
    >>> one = score([Recording.of("one", [path], [Trial("ann", "1")])], ["hold"])[0]
    >>> one.predictors[0].time_averaged.tolist()  # 0.05 s at 100 px, 0.05 s at 41 px
    [70.5]
    """
    scoring = scoring_with(predictors, parameters=parameters, cpi=cpi, dpi=dpi, seed=seed)
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
    prepared = prepare(recording, cpi=scoring.cpi, dpi=scoring.dpi, threads=threads)
    total, events_done = len(prepared.events) * len(pipelines), 0

    def advance(events: int) -> None:
        nonlocal events_done
        events_done += events
        if progress is not None:
            progress(recording.name, events_done, total)

    clock = clock_s([trial.arrival_s for trial in prepared.trials])
    whole = score_part(recording, prepared, pipelines, clock, threads=threads, progress=advance)
    about = msgspec.structs.replace(recording, skipped=())
    scored = with_trials(set_without_trials(about, pipelines, [outcome(whole)], scoring.seed), [whole])
    if not worst:
        return scored
    return msgspec.structs.replace(scored, worst=worst_trials(scored, prepared, pipelines, worst))
