"""Clients that cost the service as much as a session's limits allow, each in another way."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

import pointpred.datasets
from benchmarks.load.generator import Fragment, Message
from benchmarks.load.movements import hello, resampled, tables
from pointpred import build
from pointpred.protocol.packed import pack_events
from pointpred.records import FloatArray

MESSAGES_PER_S, EVENTS_PER_S, FRAGMENTS_PER_S = 450.0, 19_000.0, 4500.0
"""What a client tries first, somewhat below the limits of a session."""
MOVEMENTS = 150
"""Movements that a person is learned from."""


class CostlyClient(msgspec.Struct, frozen=True):
    """A client that sends these messages again and again; ``rate`` messages a second at most."""

    name: str
    rate: float
    greeting: tuple[Message, ...]
    messages: tuple[Message, ...]


def text(kind: str, **fields: Any) -> str:
    """A message as JSON."""
    return json.dumps({"type": kind, **fields}, separators=(",", ":"))


RESET = text("reset")


def movement(events: int) -> FloatArray:
    """Recorded movements as one, at 1 kHz."""
    parts = itertools.islice(tables(), 1 + events // 300)
    rows = np.concatenate([resampled(table, 1000.0) for table in parts])[:events]
    rows[:, 0] = np.arange(1, len(rows) + 1) / 1000.0
    return rows


def frames(rows: FloatArray, size: int) -> Iterator[FloatArray]:
    """Tables of ``size`` events."""
    return (rows[at : at + size] for at in range(0, len(rows), size))


def as_text(rows: FloatArray) -> str:
    """Events as JSON."""
    return text("events", events=[[*row[:3], None, None, int(row[5])] for row in rows.tolist()])


def targets(first: int, count: int = 1000) -> str:
    """As many targets as a session may have."""
    places = [{"id": str(i), "x": first + i % 40 * 30, "y": i // 40 * 30} for i in range(count)]
    return text("targets", targets=[{**place, "width": 20, "height": 20} for place in places])


def fragments(message: str, count: int) -> Iterator[Fragment]:
    """A text in so many fragments; where it is shorter, the last ones are empty."""
    size = -(-len(message) // count)
    for which in range(count):
        yield Fragment(message[which * size : (which + 1) * size].encode(), which, count)


@cache
def templates() -> tuple[bytes, ...]:
    """1,000 movements of 15 events with pauses between, within one second's allowance of events."""
    k = np.arange(15)
    way = np.tile(np.polyval((6.0, -15.0, 10.0, 0.0, 0.0, 0.0), k / 14), 1000)
    rows = np.full((len(way), 6), np.nan)
    rows[:, 0] = (np.arange(1000)[:, None] * 0.6 + k * 0.01 + 1.0).ravel()
    rows[:, 1] = way * np.repeat(100.0 + np.arange(1000), 15)
    rows[:, 2] = rows[:, 5] = 0.0
    return tuple(pack_events(part) for part in frames(rows, 1000))


@cache
def person() -> str:
    """What `kinematic-adaptive` knows after many movements: its places among it."""
    pipeline = build("kinematic-adaptive")
    for table in itertools.islice(tables(), MOVEMENTS):
        for row in resampled(table, 125.0).tolist():
            pipeline.advance(tuple(row))
        pipeline.reset()
    return pipeline.person


def costly_clients() -> list[CostlyClient]:
    """All of them."""
    known = person()
    rows = movement(4000)
    packed = [pack_events(part) for part in frames(rows, 2)]
    late = pack_events(movement(8))
    long = [as_text(part) for part in frames(rows, 800)]
    adaptive = hello("kinematic-adaptive", person=known, places=True)
    far = movement(1)
    far[:, 0] = 1e6
    moved = rows.copy()
    moved[:, 3:5] = 1.0
    substeps = {"gap_s": 0.2, "step_s": 0.001}
    unknown = {f"nothing{i}": 0 for i in range(3500)}
    return [
        CostlyClient(
            "1,000 targets replaced", MESSAGES_PER_S, (hello("switched"),), (targets(0), targets(9))
        ),
        CostlyClient("1,001 targets, refused", MESSAGES_PER_S, (hello("switched"),), (targets(0, 1001),)),
        CostlyClient(
            "messages in 64 fragments", FRAGMENTS_PER_S, (hello("switched"),), tuple(fragments(RESET, 64))
        ),
        CostlyClient(
            "events with 1,000 targets",
            EVENTS_PER_S / 32,
            (hello("switched"), targets(0)),
            (RESET, *(pack_events(part) for part in frames(rows, 16))),
        ),
        CostlyClient(
            "events with 1,000 targets, frames of 1,000",
            1.0,
            (hello("switched"), targets(0)),
            (RESET, pack_events(rows[:1000])),
        ),
        CostlyClient(
            "`ktm` with 1,000 templates, frames of 2",
            EVENTS_PER_S / 2,
            (
                hello("ktm", parameters={"templates": 1000}),
                *templates(),
            ),
            (RESET, *packed[:1000]),
        ),
        CostlyClient(
            "`kinematic-adaptive`, frames of 1",
            EVENTS_PER_S,
            (hello("kinematic-adaptive", person=known),),
            (RESET, *(pack_events(part) for part in frames(rows, 1))),
        ),
        CostlyClient(
            "assisted with 200 sub-steps, frames of 1",
            EVENTS_PER_S,
            (hello("switched", parameters=substeps, assist={}, device={"cpi": 800}),),
            (RESET, *(pack_events(part) for part in frames(moved, 1))),
        ),
        CostlyClient(
            "late events, frames of 8", EVENTS_PER_S / 8, (hello("switched"), pack_events(far)), (late,)
        ),
        CostlyClient("JSON of 800 events", EVENTS_PER_S / 800, (hello("kinematic", "json"),), (RESET, *long)),
        CostlyClient("JSON that is cut off", MESSAGES_PER_S, (hello("switched"),), (long[0][:-9],)),
        CostlyClient(
            "`configure`, another predictor",
            MESSAGES_PER_S,
            (hello("switched"),),
            tuple(text("configure", predictor=name) for name in ("kinematic", "ktm", "kinematic-adaptive")),
        ),
        CostlyClient(
            "`configure`, 3,500 unknown parameters",
            MESSAGES_PER_S,
            (hello("switched"),),
            (text("configure", parameters=unknown),),
        ),
        CostlyClient(
            "trials of 1,000 events, scored",
            EVENTS_PER_S / 1000 * 4,
            (hello("switched"),),
            (RESET, text("trial", action="start"), pack_events(rows[:1000]), text("trial", action="end")),
        ),
        CostlyClient(
            "a person replaced",
            MESSAGES_PER_S,
            (hello("kinematic-adaptive"),),
            (text("person", person=known),),
        ),
        CostlyClient(
            "events with places",
            EVENTS_PER_S / 8 / 64,
            (adaptive,),
            (RESET, *(pack_events(part) for part in frames(rows, 64))),
        ),
    ]


def upload() -> bytes:
    """A recording for ``/v1/score``: the embedded sample."""
    folder = Path(pointpred.datasets.__file__).parent
    return (folder / "simulated_circle_samples.parquet").read_bytes()
