"""The same events give the same predictions bit for bit: one by one, whole, in chunks, over the socket."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import cache
from itertools import pairwise
from struct import Struct
from typing import Any

import numpy as np
import pytest

from pointpred import REGISTRY, EventColumns, PredictionColumns, build, run
from pointpred.clock import Instant
from pointpred.datasets import sample
from pointpred.protocol.server_messages import Limits
from pointpred.records import PHASES, FloatArray
from pointpred_server.sessions.pointing import PointingSession
from tests.server.running import PATIENCE_S, Running, running

LIMITS = Limits(max_events_per_s=10**9)
EVENT = Struct("<dddhhH")
PREDICTIONS = {1: Struct("<dddddddBd"), 2: Struct("<dddddddBddh")}
NAN = float("nan")
TRIALS = 4
"""Trials taken from the embedded sample; a reset lies between them."""


@cache
def trials() -> tuple[EventColumns, ...]:
    recording = sample()
    picked = np.linspace(0, len(recording.trials) - 1, TRIALS).astype(int)
    return tuple(recording.rows(int(number)) for number in picked)


def resolution() -> tuple[float | None, float]:
    said = sample().provenance
    return said.cpi, said.dpi or 96.0


@cache
def whole(name: str) -> tuple[bytes, ...]:
    """The reference: each trial as one table, marked ``begin``."""
    cpi, dpi = resolution()
    pipeline = build(name, cpi=cpi, dpi=dpi)
    return tuple(packed(run(pipeline, rows)) for rows in trials())


def packed(predictions: PredictionColumns) -> bytes:
    """Predictions as the bytes of their numbers; of a row without one only the time counts."""
    table = predictions.table.copy()
    table[np.isnan(table[:, 1]), 1:] = NAN
    table[np.isnan(table)] = NAN
    return table.tobytes()


@cache
def told(name: str, version: int = 2) -> tuple[bytes, ...]:
    """The reference; in packed records of version 1 without the spread of the time left."""
    tables = [np.frombuffer(rows).reshape(-1, len(PredictionColumns.names)).copy() for rows in whole(name)]
    for table in tables:
        table[:, 9] = NAN if version == 1 else table[:, 9]
    return tuple(packed(PredictionColumns(table)) for table in tables)


def one_by_one(name: str) -> Iterator[bytes]:
    cpi, dpi = resolution()
    pipeline = build(name, cpi=cpi, dpi=dpi)
    for rows in trials():
        pipeline.reset()
        found = []
        for event in rows.events():
            p = pipeline.update(event)
            none = (NAN, NAN, NAN)
            if p is None:
                found.append((event.t, *none, *none, NAN, NAN, NAN))
                continue
            region, rest = p.scale or none, NAN if p.remaining_s is None else p.remaining_s
            claims = (NAN if claim is None else claim for claim in (p.tail, p.remaining_spread))
            found.append((p.t, p.x, p.y, *region, rest, float(PHASES.index(p.phase)), *claims))
        yield packed(PredictionColumns(np.array(found)))


def in_chunks(name: str) -> Iterator[bytes]:
    cpi, dpi = resolution()
    pipeline, random = build(name, cpi=cpi, dpi=dpi), np.random.default_rng(5)
    for rows in trials():
        pipeline.reset()
        cuts = np.unique([0, len(rows), *random.integers(0, len(rows), 20)])
        parts = [run(pipeline, rows.rows(a, b)).table for a, b in pairwise(cuts)]
        yield packed(PredictionColumns(np.concatenate(parts)))


def hello(name: str, encoding: str, version: int = 2) -> str:
    cpi, dpi = resolution()
    device = {} if cpi is None else {"device": {"cpi": cpi}}
    words = {"type": "hello", "version": version, "predictor": name, "reply": "event"}
    return json.dumps({**words, "encoding": encoding, **device, "screen": {"dpi": dpi}})


def text_frame(table: FloatArray) -> str:
    rows = [[None if v != v else v for v in row[:5]] + [int(row[5])] for row in table.tolist()]
    return json.dumps({"type": "events", "events": rows})


def binary_frame(table: FloatArray) -> bytes:
    frame = b""
    for t, x, y, dx, dy, buttons in table.tolist():
        counts = (-32768, -32768) if dx != dx else (int(dx), int(dy))
        frame += EVENT.pack(t, x, y, *counts, int(buttons))
    return frame


def row_of(answer: str | bytes, version: int) -> list[tuple[float, ...]]:
    """The numbers of an answer frame; no target is registered."""
    if isinstance(answer, bytes):
        records = [tuple(map(float, record)) for record in PREDICTIONS[version].iter_unpack(answer)]
        assert version == 1 or {record[10] for record in records} == {-1.0}
        return [(*record, NAN) if version == 1 else record[:10] for record in records]
    said: dict[str, Any] = json.loads(answer)
    assert said["type"] == "prediction"
    region = said["region"] or {}
    numbers = [said["t"], said["x"], said["y"], *(region.get(k) for k in ("sxx", "sxy", "syy"))]
    phase = 0.0 if said["phase"] is None else float(PHASES.index(said["phase"]))
    tail = NAN if region.get("tail") is None else region["tail"]
    spread = NAN if said["remaining_spread"] is None else said["remaining_spread"]
    assert "target" not in said
    return [(*(NAN if n is None else n for n in (*numbers, said["remaining_s"])), phase, tail, spread)]


Exchange = Callable[[list[str | bytes], int], list[Any]]
"""Sends frames that bring so many answers, and returns these."""


def talking(
    name: str, encoding: str, frame: int, exchange: Exchange, at_once: int = 1, version: int = 2
) -> Iterator[bytes]:
    """Every trial through a session, ``at_once`` frames before an answer is read."""
    exchange([hello(name, encoding, version)], 1)
    for rows in trials():
        exchange(['{"type": "reset"}'], 0)
        form = binary_frame if encoding == "binary" else text_frame
        frames = [form(rows.table[first : first + frame]) for first in range(0, len(rows), frame)]
        found: list[tuple[float, ...]] = []
        for first in range(0, len(frames), at_once):
            sent = frames[first : first + at_once]
            events = min(len(rows), (first + at_once) * frame) - first * frame
            for answer in exchange(sent, len(sent) if encoding == "binary" else events):
                found += row_of(answer, version)
        yield packed(PredictionColumns(np.array(found)))


def session(name: str, encoding: str, frame: int, version: int = 2) -> Iterator[bytes]:
    one = PointingSession("session", LIMITS, Instant(0.0))

    def exchange(frames: list[str | bytes], count: int) -> list[Any]:
        for frame in frames:
            one.receive(frame, Instant(0.0))
        answers = one.outbox.take()
        assert len(answers) == count
        return answers

    return talking(name, encoding, frame, exchange, version=version)


@pytest.mark.parametrize("name", REGISTRY)
def test_one_by_one(name: str) -> None:
    assert tuple(one_by_one(name)) == whole(name)


@pytest.mark.parametrize("name", REGISTRY)
def test_in_chunks(name: str) -> None:
    assert tuple(in_chunks(name)) == whole(name)


@pytest.mark.parametrize("frame", [1, 8, 32])
@pytest.mark.parametrize("encoding", ["json", "binary"])
@pytest.mark.parametrize("name", REGISTRY)
def test_session(name: str, encoding: str, frame: int) -> None:
    assert tuple(session(name, encoding, frame)) == told(name)


@pytest.mark.parametrize("frame", [1, 32])
@pytest.mark.parametrize("name", REGISTRY)
def test_session_of_version_1(name: str, frame: int) -> None:
    assert tuple(session(name, "binary", frame, version=1)) == told(name, version=1)


@pytest.fixture(scope="module")
def service() -> Iterator[Running]:
    with running(max_events_per_s=10**8) as here:
        yield here


@pytest.mark.parametrize(
    ("encoding", "frame", "at_once"), [("json", 32, 2), ("binary", 1, 64), ("binary", 32, 2)]
)
@pytest.mark.parametrize("name", REGISTRY)
def test_socket(service: Running, name: str, encoding: str, frame: int, at_once: int) -> None:
    """Frames sent in a burst are answered each: only a client that does not read misses predictions."""
    with service.connect() as socket:

        def exchange(frames: list[str | bytes], count: int) -> list[Any]:
            for frame in frames:
                socket.send(frame)
            return [socket.recv(PATIENCE_S) for _ in range(count)]

        assert tuple(talking(name, encoding, frame, exchange, at_once)) == told(name)


def test_the_sample_has_counts_and_predictors_that_differ() -> None:
    """Otherwise equality would say little."""
    assert sum(len(rows) for rows in trials()) > 1000
    assert any((rows.dx == rows.dx).any() for rows in trials())
    assert len({whole(name) for name in REGISTRY}) == len(REGISTRY)
