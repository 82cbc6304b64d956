"""Recordings scored in chunks: a plan, an executor, a checkpoint a chunk, and results that stay on disk."""

from __future__ import annotations

import hashlib
import pickle
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from itertools import pairwise
from pathlib import Path
from typing import TypeVar

import msgspec
import numpy as np

import pointpred
from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.recordings.stored import StoredPart, StoredRecording
from pointpred.records import BoolArray, FloatArray
from pointpred.scoring.checkpoints import FolderStore, MemoryStore, PartStore, encode, temporary_store
from pointpred.scoring.executors import Executor
from pointpred.scoring.measures.time_left import clock_s
from pointpred.scoring.replay import answers_to, by_person
from pointpred.scoring.results import SetScore, WorstTrial, WorstTrials
from pointpred.scoring.scorer import (
    Progress,
    ScoredPart,
    Scoring,
    score_part,
    set_without_trials,
    with_trials,
    worst_of,
)
from pointpred.scoring.selection import check_names, counted, names_of
from pointpred.scoring.summary import SetSummary, summarise_parts
from pointpred.scoring.trials import durations_s

CHUNK_EVENTS = 65_536
"""Events in a chunk, about: enough to forget what a chunk costs, few enough for bounded memory."""
IN_MEMORY_CHUNKS = 64
"""With more chunks, results go to a temporary folder: some 4 million events."""

Answer = TypeVar("Answer")
Source = Recording | StoredRecording
"""A recording in memory, or one that stays in its file."""
Chunk = Recording | StoredPart
"""Some of its trials, one after the other."""


def plan(source: Source, pipelines: Mapping[str, Pipeline]) -> list[Chunk]:
    """All trials of a recording in order, in chunks of about CHUNK_EVENTS events.

    Where a predictor learns its person or is given targets, a person's trials are in one chunk, however many
    they are.
    """
    together = any(by_person(pipeline) for pipeline in pipelines.values())
    if isinstance(source, StoredRecording):
        return list(source.parts(CHUNK_EVENTS, by_person=together))
    people = [trial.user for trial in source.trials]
    units = range(len(people))
    if together:
        begins = [k for k in units if k == 0 or people[k] != people[k - 1]]
        if len(begins) != len(set(people)):  # their trials alternate: together they are one chunk
            begins = begins[:1]
        return _cut(source, begins)
    return _cut(source, list(units))


def _cut(source: Recording, units: list[int]) -> list[Chunk]:
    """Parts that begin at some of these trials."""
    bounds = [0]
    for unit in [*units[1:], len(source.trials)]:
        if source.offsets[unit] - source.offsets[bounds[-1]] >= CHUNK_EVENTS:
            bounds.append(unit)
    bounds = sorted({*bounds, len(source.trials)})
    return [source.part(first, stop) for first, stop in pairwise(bounds)]


def events_of(chunk: Chunk) -> int:
    """How many events a chunk has."""
    return len(chunk.events) if isinstance(chunk, Recording) else chunk.stop_row - chunk.first_row


def about(source: Source) -> Recording:
    """Everything of a recording but its trials."""
    if isinstance(source, StoredRecording):
        return source.about
    nothing = source.part(0, 0) if len(source.trials) else source
    return msgspec.structs.replace(
        nothing, offsets=np.zeros(1, dtype=np.int64), skipped=source.skipped, notes=source.notes
    )


def read(chunk: Chunk) -> Recording:
    """The trials of a chunk in memory; raises RecordingError."""
    return chunk if isinstance(chunk, Recording) else chunk.read()


BLOCK_BYTES = 1 << 20


def digest(
    source: Source, pipelines: Mapping[str, Pipeline], chunks: Sequence[Chunk], *settings: object
) -> str:
    """A name for the results of chunks: another recording, predictor, setting or version has another one.

    ``settings``: whatever else changes a result. The seed of the bootstrap does not: it is used at the end.
    """
    whole = hashlib.blake2b(digest_size=16)
    whole.update(_code().encode())
    whole.update(repr(settings).encode())
    for name, pipeline in pipelines.items():
        whole.update(f"{name} {type(pipeline.differentiator)} {type(pipeline.predictor)}".encode())
        whole.update(pickle.dumps(pipeline.fresh(), protocol=5))
        for shared in pipeline.predictor.shared:  # a pickle holds the path of a coefficient file only
            whole.update(shared.tobytes())
    whole.update(repr([events_of(chunk) for chunk in chunks]).encode())
    if isinstance(source, Recording):
        whole.update(msgspec.msgpack.encode((source.name, source.trials, source.provenance)))
        whole.update(source.offsets.tobytes())
        whole.update(source.events.table.tobytes())
    else:
        for path in (source.samples, source.trials):
            with Path(path).open("rb") as file:
                while block := file.read(BLOCK_BYTES):
                    whole.update(block)
    return whole.hexdigest()


@cache
def _code() -> str:
    """A digest of the package's source: a version that is being worked on has many states."""
    whole = hashlib.blake2b(pointpred.__version__.encode(), digest_size=16)
    folder = Path(pointpred.__file__).parent
    for path in sorted(folder.rglob("*.py")):
        whole.update(path.relative_to(folder).as_posix().encode())
        whole.update(path.read_bytes())
    return whole.hexdigest()


class ScoredSet(msgspec.Struct, frozen=True):
    """One recording scored; the rows of its trials are in ``store``, chunk by chunk."""

    about: SetScore
    """Everything that has no row a trial."""
    chunks: Sequence[Chunk]
    store: PartStore
    scoring: Scoring
    pipelines: Mapping[str, Pipeline]
    masks: Sequence[BoolArray] | None = None
    """Which trials of each chunk count; ``None``: all."""

    @property
    def name(self) -> str:
        """The recording's."""
        return self.about.name

    def parts(self) -> Iterator[SetScore]:
        """The set chunk by chunk, from the first one on."""
        for number in range(len(self.chunks)):
            mask = None if self.masks is None else self.masks[number]
            yield counted(with_trials(self.about, [self.store.part(number)]), mask)

    def summary(self) -> SetSummary:
        """Its numbers, with one chunk in memory at a time."""
        return summarise_parts(self.about, self.parts)

    def joined(self, worst: int = 0) -> SetScore:
        """The set in memory, about 1 kB for each trial and predictor, with its ``worst`` trials."""
        whole = with_trials(self.about, map(self.store.part, range(len(self.chunks))))
        mask = None if self.masks is None else np.concatenate(self.masks)
        drawn = self._worst(whole, worst, mask) if worst else None
        return msgspec.structs.replace(counted(whole, mask), worst=drawn)

    def _worst(self, whole: SetScore, count: int, mask: BoolArray | None) -> WorstTrials:
        """The worst trials; the chunks that hold them are read again."""
        errors, numbers = worst_of(whole, count, mask)
        ends = np.cumsum([len(self.store.part(number).trials) for number in range(len(self.chunks))])
        worst = []
        for k in numbers:
            number = int(np.searchsorted(ends, k, side="right"))
            prepared = self.scoring.prepare(read(self.chunks[number]), threads=1)
            own = k - (int(ends[number - 1]) if number else 0)
            answers = answers_to(prepared, self.pipelines[errors.name], own)
            worst.append(
                WorstTrial(whole.trials[k], prepared.rows(own), answers, float(errors.time_averaged[k]))
            )
        return WorstTrials(errors.name, tuple(worst))


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
    and the set holds nothing that was timed (``us_per_event`` is NaN). ``progress``: called with what is
    being done, the events done and all events. Raises RecordingError where a stored recording cannot be
    read or none of its trials counts, ParameterError where ``checkpoints`` cannot be written or be read back.
    """
    if isinstance(source, Recording):
        source = scoring.checked(source)
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
    scores = set_without_trials(whole, pipelines, outcomes, scoring)
    if checkpoints is not None:
        untimed = (msgspec.structs.replace(one, us_per_event=float("nan")) for one in scores.predictors)
        scores = msgspec.structs.replace(scores, predictors=tuple(untimed))
    if scoring.by and not isinstance(source, Recording):
        numbers = range(len(chunks))
        check_names(scoring.by, names_of(one for k in numbers for one in store.part(k).trials), "by")
    masks = scoring.masks(source.name, lambda: (store.part(k).trials for k in range(len(chunks))))
    scores = msgspec.structs.replace(scores, notes=(*scores.notes, *scoring.about_masks(masks)))
    return ScoredSet(scores, chunks, store, scoring, pipelines, masks)


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
    prepared = scoring.prepare(recording, threads)
    part = score_part(recording, prepared, scoring.pipelines(whole), clock, threads=threads)
    return encode(part) if packed else part
