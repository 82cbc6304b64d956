"""A recording to a service over its socket, and whether it answers as the batch does."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from pointpred.client import Connection, connect
from pointpred.columns import EventColumns, FloatArray, PredictionColumns
from pointpred.pipeline import Pipeline, run
from pointpred.protocol.client_messages import Goal
from pointpred.protocol.frames import packable
from pointpred.protocol.server_messages import Score
from pointpred.protocol.token_bucket import TokenBucket
from pointpred.recording import Recording, Skip
from pointpred.registry import RECOMMENDED, build
from pointpred.replaying.choosing import playable
from pointpred.replaying.local import local_scores
from pointpred.replaying.pacing import due

Progress = Callable[[str, int, int], None]
SHARE = 0.9
"""Of the events a second that a service allows, so that its clock and ours may differ."""


class ReplayedTrial(msgspec.Struct, frozen=True):
    """One trial as the service answered it; ``unlike`` counts the predictions that differ in any bit."""

    user: str
    trial: str
    events: int
    predictions: int
    unlike: int
    score: Score
    local: Score
    seconds: float

    @property
    def agrees(self) -> bool:
        """Each bit of every prediction heard, and the score, are as in the batch."""
        return self.unlike == 0 and self.score == self.local

    @property
    def gave_way(self) -> int:
        """Predictions that the service replaced by newer ones before it could send them."""
        return self.events - self.predictions


class Replayed(msgspec.Struct, frozen=True):
    """A recording played to a service."""

    recording: str
    predictor: str
    trials: tuple[ReplayedTrial, ...]
    skipped: tuple[Skip, ...]

    @property
    def agrees(self) -> bool:
        """Every trial agrees with the batch bit for bit."""
        return all(trial.agrees for trial in self.trials)


def replay_to(
    url: str,
    recording: Recording,
    *,
    predictor: str = RECOMMENDED,
    speed: float = 1.0,
    trials: Sequence[str] = (),
    cpi: float | None = None,
    dpi: float | None = None,
    coefficients: tuple[str, Path] | None = None,
    token: str | None = None,
    progress: Progress | None = None,
) -> Replayed:
    """Play trials to the service at ``url`` and compare every answer with the local batch.

    ``speed``: 1 as recorded, 2 twice as fast, infinity as fast as the service's limits allow. ``trials``:
    USER-TRIAL, or places counted from 1; all unless given. ``cpi`` and ``dpi`` replace what the recording
    says. ``coefficients``: the name that the service has for a file of coefficients, and the same file here.
    Each trial is marked, so that the service scores it. Another user begins another session: a predictor that
    learns its person meets each knowing nobody. Raises ParameterError, SourceError, ServiceError.
    """
    said = recording.provenance
    cpi, dpi = said.cpi if cpi is None else cpi, said.dpi if dpi is None else dpi
    named = {} if coefficients is None else {"coefficients": coefficients[0]}
    own: dict[str, Any] = {} if coefficients is None else {"coefficients": coefficients[1]}
    pipeline = build(predictor, cpi=cpi, dpi=dpi, **own)
    played, left_out = playable(recording, trials)
    local = local_scores(recording, played, pipeline, cpi=cpi, dpi=dpi)
    total, done, answers = sum(len(recording.rows(k)) for k in played), 0, []
    for _, turn in groupby(played, key=lambda k: recording.trials[k].user):
        with connect(
            url,
            predictor=predictor,
            parameters=named,
            device=None if cpi is None else {"cpi": cpi},
            screen={"dpi": dpi},
            reply="event",
            encoding="binary" if packable(recording.events) else "json",
            token=token,
        ) as connection:
            player = _Player(connection, pipeline.fresh(), speed)
            for k in turn:
                answers.append(player.play(recording, k, local[k]))
                done += len(recording.rows(k))
                if progress is not None:
                    progress(recording.name, done, total)
    return Replayed(recording.name, predictor, tuple(answers), left_out)


class _Player:
    """Plays trials on one connection."""

    def __init__(self, connection: Connection, pipeline: Pipeline, speed: float) -> None:
        self.connection = connection
        self.pipeline = pipeline
        self.speed = speed
        most = SHARE * connection.limits.max_events_per_s
        self._rate = TokenBucket(most, time.monotonic())

    def play(self, recording: Recording, k: int, local: Score) -> ReplayedTrial:
        """One trial, marked; its answers beside those of the batch."""
        about, events = recording.trials[k], recording.rows(k)
        goal = (about.target_x, about.target_y, about.target_w)
        began = time.perf_counter()
        self.connection.trial("start", Goal(*goal) if all(map(math.isfinite, goal)) else None)
        heard = self._stream(events)
        seconds = time.perf_counter() - began
        score = self.connection.trial("end")
        assert score is not None
        self.pipeline.reset()  # as the session at a start: what it knows of the person stays
        batch = run(self.pipeline, EventColumns(events.table))
        return ReplayedTrial(
            about.user, about.trial, len(events), len(heard), unlike(heard, batch), score, local, seconds
        )

    def _stream(self, events: EventColumns) -> PredictionColumns:
        """Every prediction; without a pace to keep, a frame waits for the answers to the last one."""
        parts = []
        for first, stop in due(events.t, self.speed):
            while not self._rate.take(stop - first, time.monotonic()):
                time.sleep((stop - first) / self._rate.most)
            self.connection.send(events.rows(first, stop))
            parts.append(self.connection.columns() if math.isinf(self.speed) else self.connection.poll())
        parts.append(self.connection.columns())
        return PredictionColumns(np.concatenate([part.table for part in parts]))


def unlike(heard: PredictionColumns, batch: PredictionColumns) -> int:
    """How many predictions heard differ in any bit from the batch's for the same event.

    Where some gave way to newer ones, each is compared with the next row of its time.
    """
    rows = np.arange(len(batch)) if len(heard) == len(batch) else _rows(heard, batch)
    wanted, own = _told(batch.table[rows]), _told(heard.table[: len(rows)])
    differ = (wanted.view(np.int64) != own.view(np.int64)) & ~(np.isnan(wanted) & np.isnan(own))
    return int(differ.any(axis=1).sum()) + len(heard) - len(rows)


def _told(table: FloatArray) -> FloatArray:
    """What goes over the wire: no spread, no tail without a region; of no prediction, its time."""
    told = table[:, :9].copy()
    told[np.isnan(told[:, 3]), 8] = np.nan
    told[np.isnan(told[:, 1]), 1:] = np.nan
    return told


def _rows(heard: PredictionColumns, batch: PredictionColumns) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    found, place = [], 0
    for t in heard.t.tolist():
        place += int(np.searchsorted(batch.t[place:], t))
        if place == len(batch) or batch.t[place] != t:
            break
        found.append(place)
        place += 1
    return np.array(found, dtype=np.int64)
