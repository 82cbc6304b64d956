"""Scoring in chunks: first how long every trial took, then every chunk beside the set's clock."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TypeVar

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.recording import Recording
from pointpred.scoring.batch import part_file
from pointpred.scoring.batch.digests import digest
from pointpred.scoring.batch.part_store import FolderStore, MemoryStore, PartStore, temporary_store
from pointpred.scoring.batch.plan import Chunk, Source, about, events_of, plan, read
from pointpred.scoring.batch.scored_set import ScoredSet
from pointpred.scoring.executors import Executor
from pointpred.scoring.measures.time_left import clock_s
from pointpred.scoring.scorer import ScoredPart, Scoring, score_part, set_without_trials
from pointpred.scoring.trials import durations_s, prepare

Progress = Callable[[str, int, int], None]
"""Called with what is being done, the events done and all events."""
Answer = TypeVar("Answer")

IN_MEMORY_CHUNKS = 64
"""With more chunks, results go to a temporary folder: some 4 million events."""


def score_in_chunks(
    source: Source,
    scoring: Scoring,
    executor: Executor,
    *,
    checkpoints: Path | None = None,
    progress: Progress | None = None,
) -> ScoredSet:
    """Score one recording, chunk by chunk, wherever the executor works.

    The same recording and settings give the same numbers, bit for bit, whatever the executor, its workers and
    the order in which they end. With ``checkpoints``, a folder, each chunk's result is kept there as soon
    as it is there; a later call with the same recording, settings and version goes on from what it finds,
    and the set holds nothing that was timed (``us_per_event`` is NaN). Raises RecordingError where a stored
    recording cannot be read, ParameterError where ``checkpoints`` cannot be written or be read back.
    """
    whole = about(source)
    pipelines = scoring.pipelines(whole)
    chunks = plan(source, pipelines)
    store = _store(source, scoring, chunks, checkpoints)
    run = _Run(source.name, chunks, executor, progress)
    clock = float("nan")
    if any(pipeline.predictor.claims_time for pipeline in pipelines.values()):
        missing = [number for number in range(len(chunks)) if store.durations(number) is None]
        run.each("durations", _durations, missing, store.put_durations)
        clock = clock_s(np.concatenate([np.empty(0), *_read_all(store.durations, chunks)]))
    threads = executor.inner_threads if len(chunks) == 1 else 1
    work = partial(_score, scoring, whole, clock, store.packed, threads)
    missing = [number for number in range(len(chunks)) if store.outcome(number) is None]
    run.each("", work, missing, store.put)
    outcomes = _read_all(store.outcome, chunks)
    scores = set_without_trials(whole, pipelines, outcomes, scoring.seed)
    if checkpoints is not None:
        untimed = (msgspec.structs.replace(one, us_per_event=float("nan")) for one in scores.predictors)
        scores = msgspec.structs.replace(scores, predictors=tuple(untimed))
    return ScoredSet(scores, chunks, store, scoring, pipelines)


def _read_all(read: Callable[[int], Answer | None], chunks: Sequence[Chunk]) -> list[Answer]:
    """What the store has of every chunk; raises ParameterError where it no longer has something."""
    answers = []
    for number in range(len(chunks)):
        answer = read(number)
        if answer is None:
            message = f"checkpoint {number} can no longer be read; score once more"
            raise ParameterError(message, field="checkpoints")
        answers.append(answer)
    return answers


class _Run(msgspec.Struct, frozen=True):
    """The chunks of a set and who works on them."""

    name: str
    chunks: Sequence[Chunk]
    executor: Executor
    progress: Progress | None

    def each(
        self,
        what: str,
        function: Callable[[Chunk], Answer],
        missing: Sequence[int],
        keep: Callable[[int, Answer], None],
    ) -> None:
        """Call a function for the chunks that are missing, and keep each answer as it comes."""
        name = f"{self.name}: {what}" if what else self.name
        total = sum(map(events_of, self.chunks))
        done = total - sum(events_of(self.chunks[number]) for number in missing)
        if self.progress is not None:
            self.progress(name, done, total)
        for place, answer in self.executor.each(function, (self.chunks[number] for number in missing)):
            keep(missing[place], answer)
            done += events_of(self.chunks[missing[place]])
            if self.progress is not None:
                self.progress(name, done, total)


def _store(source: Source, scoring: Scoring, chunks: Sequence[Chunk], checkpoints: Path | None) -> PartStore:
    if checkpoints is not None:
        key = digest(source, scoring.pipelines(about(source)), chunks, scoring.cpi, scoring.dpi)
        return FolderStore(checkpoints / key)
    return MemoryStore() if len(chunks) <= IN_MEMORY_CHUNKS else temporary_store()


def _durations(chunk: Chunk) -> FloatArray:
    return durations_s(read(chunk))


def _score(
    scoring: Scoring, whole: Recording, clock: float, packed: bool, threads: int, chunk: Chunk
) -> ScoredPart | bytes:
    """The pure function over chunks."""
    recording = read(chunk)
    prepared = prepare(recording, cpi=scoring.cpi, dpi=scoring.dpi, threads=threads)
    part = score_part(recording, prepared, scoring.pipelines(whole), clock, threads=threads)
    return part_file.encode(part) if packed else part
