"""Plays a recording to a service over its socket, and checks that it answers as the batch does."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from msgspec import structs

from pointpred.client import Connection, connect
from pointpred.clock import now
from pointpred.live.playback import Pacing, PlayedTrial, playable_trials
from pointpred.pipeline import Pipeline, run
from pointpred.protocol.client_messages import Goal
from pointpred.protocol.frames import packable
from pointpred.protocol.scores import score_of
from pointpred.protocol.server_messages import Score
from pointpred.protocol.token_bucket import TokenBucket
from pointpred.recording import Recording, Skip
from pointpred.records import EventColumns, FloatArray, PredictionColumns
from pointpred.registry import RECOMMENDED, build
from pointpred.scoring import prepare, replay

Progress = Callable[[str, int, int], None]
SHARE = 0.9
"""The part of a service's limit on events a second that is used, so that its clock and ours may differ."""


class ReplayedTrial(msgspec.Struct, frozen=True, kw_only=True):
    """One trial as the service answered it, and as the local batch does.

    ``gave_way``: predictions that the service replaced by newer ones before it could send them; ``unlike``:
    those received that differ from the batch's in any bit; ``agree``: none does, nor the score.
    """

    user: str
    trial: str
    events: int
    predictions: int
    gave_way: int
    unlike: int
    seconds: float
    agree: bool
    score: Score
    batch: Score


class Replayed(msgspec.Struct, frozen=True, kw_only=True):
    """A recording played to a service; ``agree``: every trial agrees with the batch bit for bit."""

    version: int = 1
    recording: str
    predictor: str
    agree: bool
    trials: tuple[ReplayedTrial, ...]
    skipped: tuple[Skip, ...]


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
    USER-TRIAL, or numbers from 1; all by default. ``cpi`` and ``dpi`` replace those of the recording.
    ``coefficients``: the name that the service has for a file of coefficients, and the same file here.
    Each trial is marked, so that the service scores it. Another user begins another session: a predictor that
    learns its person meets each knowing nobody. Raises ParameterError, SourceError, ServiceError.
    """
    origin = recording.provenance
    cpi, dpi = origin.cpi if cpi is None else cpi, origin.dpi if dpi is None else dpi
    parameters = {} if coefficients is None else {"coefficients": coefficients[0]}
    own: dict[str, Any] = {} if coefficients is None else {"coefficients": coefficients[1]}
    pipeline = build(predictor, cpi=cpi, dpi=dpi, **own)
    played, skipped = playable_trials(recording, trials)
    local = batch_scores(played, pipeline, cpi=cpi, dpi=dpi)
    total, done, answers = sum(len(one.events) for one in played), 0, []
    for _, turn in groupby(zip(played, local, strict=True), key=lambda pair: pair[0].about.user):
        with connect(
            url,
            predictor=predictor,
            parameters=parameters,
            device=None if cpi is None else {"cpi": cpi},
            screen={"dpi": dpi},
            reply="event",
            encoding="binary" if packable(recording.events) else "json",
            token=token,
        ) as connection:
            player = _Player(connection, pipeline.fresh(), speed)
            for one, score in turn:
                answers.append(player.play(one, score))
                done += len(one.events)
                if progress is not None:
                    progress(recording.name, done, total)
    return Replayed(
        recording=recording.name,
        predictor=predictor,
        agree=all(one.agree for one in answers),
        trials=tuple(answers),
        skipped=skipped,
    )


class _Player:
    """Plays trials on one connection."""

    def __init__(self, connection: Connection, pipeline: Pipeline, speed: float) -> None:
        self.connection = connection
        self.pipeline = pipeline
        self.speed = speed
        most = SHARE * connection.limits.max_events_per_s
        self._rate = TokenBucket(most, now())

    def play(self, one: PlayedTrial, local: Score) -> ReplayedTrial:
        """Play one trial, marked, and compare the answers with those of the batch."""
        about, events = one.about, one.events
        goal = (about.target_x, about.target_y, about.target_w)
        began = time.perf_counter()
        self.connection.trial("start", Goal(*goal) if all(map(math.isfinite, goal)) else None)
        received = self._stream(events)
        seconds = time.perf_counter() - began
        score = self.connection.trial("end")
        assert score is not None
        self.pipeline.reset()  # as the session does: what it knows of the person stays
        differ = unlike(received, run(self.pipeline, EventColumns(events.table)))
        return ReplayedTrial(
            user=about.user,
            trial=about.trial,
            events=len(events),
            predictions=len(received),
            gave_way=len(events) - len(received),
            unlike=differ,
            seconds=seconds,
            agree=differ == 0 and score == local,
            score=score,
            batch=local,
        )

    def _stream(self, events: EventColumns) -> PredictionColumns:
        """Every prediction; at infinite speed a frame waits for the answers to the last one."""
        parts, pacing = [], Pacing(events.t, self.speed)
        while due := pacing.take():
            while not self._rate.take(len(due), now()):
                time.sleep(len(due) / self._rate.most)
            self.connection.send(events.rows(due.start, due.stop))
            parts.append(self.connection.columns() if math.isinf(self.speed) else self.connection.poll())
        parts.append(self.connection.columns())
        return PredictionColumns(np.concatenate([part.table for part in parts]))


def unlike(received: PredictionColumns, batch: PredictionColumns) -> int:
    """How many received predictions differ in any bit from the batch's for the same event.

    Where newer ones replaced some, each is compared with the next row of its time.
    """
    rows = np.arange(len(batch)) if len(received) == len(batch) else _rows(received, batch)
    expected, own = _sent_part(batch.table[rows]), _sent_part(received.table[: len(rows)])
    differ = (expected.view(np.int64) != own.view(np.int64)) & ~(np.isnan(expected) & np.isnan(own))
    return int(differ.any(axis=1).sum()) + len(received) - len(rows)


def _sent_part(table: FloatArray) -> FloatArray:
    """What goes over the wire: no spread, no tail without a region; only the time without a prediction."""
    sent = table[:, :9].copy()
    sent[np.isnan(sent[:, 3]), 8] = np.nan
    sent[np.isnan(sent[:, 1]), 1:] = np.nan
    return sent


def _rows(
    received: PredictionColumns, batch: PredictionColumns
) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """The row of the batch for each received prediction, up to the first that has none."""
    rows, place = [], 0
    for t in received.t.tolist():
        place += int(np.searchsorted(batch.t[place:], t))
        if place == len(batch) or batch.t[place] != t:
            break
        rows.append(place)
        place += 1
    return np.array(rows, dtype=np.int64)


def batch_scores(
    played: Sequence[PlayedTrial], pipeline: Pipeline, *, cpi: float | None, dpi: float
) -> list[Score]:
    """The offline score of each trial, as the service sends scores.

    Each trial gets a user of its own, as a service scores a marked trial with a predictor that knows nobody.
    """
    trials = [structs.replace(one.about, user=str(place)) for place, one in enumerate(played)]
    prepared = prepare(Recording.of("replay", [one.events for one in played], trials), cpi=cpi, dpi=dpi)
    errors, floor = replay(prepared, pipeline), replay(prepared, build("hold", cpi=cpi, dpi=dpi))
    scored = {id(one.trial): row for row, one in enumerate(prepared.trials)}
    reasons = {(skip.user, skip.trial): skip.reason for skip in prepared.skipped}
    return [
        score_of(prepared, scored[id(trial)], errors, floor)
        if id(trial) in scored
        else Score(len(one.events), reason=reasons[trial.user, trial.trial])
        for one, trial in zip(played, trials, strict=True)
    ]
