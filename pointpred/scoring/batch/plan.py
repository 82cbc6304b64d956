"""The chunks of a recording: from the recording and the predictors alone, whoever works on them."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import msgspec
import numpy as np

from pointpred.pipeline import Pipeline
from pointpred.recording import Recording
from pointpred.sources.own.stored import StoredPart, StoredRecording

CHUNK_EVENTS = 65_536
"""Events in a chunk, about: enough to forget what a chunk costs, few enough for bounded memory."""

Source = Recording | StoredRecording
"""A recording in memory, or one that stays in its file."""
Chunk = Recording | StoredPart
"""Some of its trials, one after the other."""


def plan(source: Source, pipelines: Mapping[str, Pipeline]) -> list[Chunk]:
    """All trials of a recording in order, in chunks of about CHUNK_EVENTS events.

    Where a predictor learns its person, a person's trials are in one chunk, however many they are.
    """
    by_person = any(pipeline.learns for pipeline in pipelines.values())
    if isinstance(source, StoredRecording):
        return list(source.parts(CHUNK_EVENTS, by_person=by_person))
    people = [trial.user for trial in source.trials]
    units = range(len(people))
    if by_person:
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
