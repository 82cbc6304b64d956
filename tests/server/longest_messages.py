"""What each message of a client costs at its limits: ``python -m tests.server.longest_messages``.

For each message the processor time on the event loop and, where
another thread does a part of it, there, in ms; the least of several tries. The bounds of
``server/pointpred_server/sessions/costs.py`` come from it.
"""

from __future__ import annotations

import itertools
import json
import time
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from evidence.arguments import parse
from evidence.costs.load.generator import resampled, tables
from evidence.data import Table, keep
from evidence.machine import machine
from pointpred import build
from pointpred.protocol.frames import EVENT, pack_events
from pointpred.protocol.server_messages import Limits
from pointpred_server.sessions.pointing import PointingSession

TRIES = 7
MOVEMENTS = 150
"""Movements that a person is learned from."""
LIMITS = Limits()
Frame = str | bytes


class Longest(NamedTuple):
    """A frame at its limits, and what the session has received before; ``hello`` None: it is the first."""

    hello: Mapping[str, Any] | None
    before: Sequence[Frame]
    frame: Frame


def text(message: Any) -> str:
    """A message as a client writes it."""
    return json.dumps(message, separators=(",", ":"))


def longest(make: Callable[[int], str]) -> str:
    """The longest message of a kind that is within the limit on bytes; ``make``: one of so many parts."""
    least, most = 1, LIMITS.max_frame_bytes
    while least < most:
        middle = (least + most + 1) // 2
        fits = len(make(middle)) <= LIMITS.max_frame_bytes
        least, most = (middle, most) if fits else (least, middle - 1)
    return make(least)


def events(count: int, *, start_s: float = 0.0, step_s: float = 0.001, dx: int | None = None) -> str:
    """Events in JSON."""
    rows = [[round(start_s + i * step_s, 6), i % 500, 0, dx, dx, 0] for i in range(count)]
    return text({"type": "events", "events": rows})


def packed(count: int, *, start_s: float = 0.0, step_s: float = 0.001, late: bool = False) -> bytes:
    """Events as packed records; ``late``: every other one runs backwards."""
    records = np.zeros(count, EVENT)
    t, x, _, dx, dy, _ = EVENT.names
    records[t] = start_s + step_s * np.arange(count)
    if late:
        records[t][1::2] = start_s - 1.0
    records[x] = np.arange(count) % 500
    records[dx] = records[dy] = -32768
    return records.tobytes()


def targets(count: int, **more: Any) -> str:
    """Targets side by side."""
    one = {"y": 0, "width": 1, "height": 1, **more}
    return text({"type": "targets", "targets": [{"id": str(i), "x": i, **one} for i in range(count)]})


def parameters(kind: str, setting: Any, **more: Any) -> str:
    """As many parameters as fit; the last of them is of no kind that a parameter has."""
    head = {"type": kind, **({"version": 1} if kind == "hello" else {}), **more}
    return longest(lambda n: text({**head, "parameters": {**{f"p{i}": 1 for i in range(n)}, "z": setting}}))


def listed(number: str) -> str:
    """As many numbers as fit in one parameter."""
    head = '{"type":"hello","version":1,"parameters":{"a":['
    return longest(lambda n: head + ",".join([number] * n) + "]}}")


@cache
def templates() -> tuple[bytes, ...]:
    """1,000 movements of 15 events with pauses between, within one second's allowance of events."""
    k = np.arange(15)
    way = np.tile(np.polyval((6.0, -15.0, 10.0, 0.0, 0.0, 0.0), k / 14), 1000)
    rows = np.full((len(way), 6), np.nan)
    rows[:, 0] = (np.arange(1000)[:, None] * 0.6 + k * 0.01 + 1.0).ravel()
    rows[:, 1] = way * np.repeat(100.0 + np.arange(1000), 15)
    rows[:, 2] = rows[:, 5] = 0.0
    return tuple(pack_events(rows[at : at + 1000]) for at in range(0, len(rows), 1000))


@cache
def person() -> str:
    """What `kinematic-adaptive` knows after many movements: its places among it."""
    pipeline = build("kinematic-adaptive")
    for table in itertools.islice(tables(), MOVEMENTS):
        for row in resampled(table, 125.0).tolist():
            pipeline.advance(tuple(row))
        pipeline.reset()
    return pipeline.person


def longest_messages() -> dict[str, Longest]:
    """Every kind of message at its limits, by name."""
    fast, new = {"predictor": "kinematic"}, {"predictor": "kinematic-adaptive"}
    known = {**new, "person": person()}
    assisted, counts = {"assist": {}, "device": {"cpi": 800}}, {"dx": 1}
    places, each = {**known, "places": True}, {"reply": "event"}
    substeps = {"parameters": {"gap_s": 0.2, "step_s": 0.001}}
    ktm = {"predictor": "ktm", "parameters": {"templates": 1000}}
    thousand, whole = targets(1000), LIMITS.max_events_per_frame
    mark = {"type": "trial", "action": "start"}
    row = [0, 0, 0, None, None, 0]
    return {
        "hello": Longest(None, (), text({"type": "hello", "version": 1})),
        "hello, person": Longest(None, (), text({"type": "hello", "version": 1, **known})),
        "hello, unknown parameters": Longest(None, (), parameters("hello", 1)),
        "hello, long name": Longest(
            None, (), longest(lambda n: text({"type": "hello", "version": 1, "predictor": "x" * n}))
        ),
        "hello, list of 5e-324": Longest(None, (), listed("5e-324")),
        "hello, list of 1e23": Longest(None, (), listed("1e23")),
        "hello, list of 9007199254740992.5": Longest(None, (), listed("9007199254740992.5")),
        "configure, unknown parameters": Longest({}, (), parameters("configure", 1)),
        "configure, last is wrong": Longest({}, (), parameters("configure", {})),
        "configure, last is NaN": Longest({}, (), parameters("configure", float("nan"))),
        "configure, ktm": Longest({}, (), text({"type": "configure", **ktm})),
        "configure, the person stays": Longest(
            known, (), text({"type": "configure", "parameters": {"sequence": 0}})
        ),
        "person": Longest(new, (), text({"type": "person", "person": known["person"]})),
        "person, refused": Longest(new, (), text({"type": "person", "person": "1." + "A" * 16000})),
        "person, asked": Longest(known, (), text({"type": "person"})),
        "forget": Longest(known, (), text({"type": "forget"})),
        "enter": Longest(known, (), text({"type": "enter", "key": "x" * 1024})),
        "reset": Longest(ktm, templates(), text({"type": "reset"})),
        "reset, targets": Longest(fast, (thousand,), text({"type": "reset"})),
        "targets": Longest({}, (), thousand),
        "targets, again": Longest(fast, (thousand,), thousand),
        "targets, too many": Longest({}, (), longest(targets)),
        "targets, one id": Longest({}, (), longest(lambda n: targets(n, id="a"))),
        "targets of 5e-324": Longest({}, (), longest(lambda n: targets(n, x=5e-324, weight=5e-324))),
        "events": Longest(fast, (), packed(whole)),
        "events, JSON": Longest(fast, (), events(whole)),
        "events, each answered": Longest({**fast, **each}, (), events(whole)),
        "events, late": Longest(fast, (packed(1, start_s=5.0),), packed(whole, start_s=4.0)),
        "events, every other late": Longest(fast, (), packed(whole, start_s=5.0, late=True)),
        "events, one late": Longest(fast, (packed(1, start_s=5.0),), packed(1, start_s=4.0)),
        "events, substeps": Longest(substeps, (), packed(whole, step_s=0.19)),
        "events, assisted": Longest(assisted, (), events(whole, **counts)),
        "events, templates": Longest(ktm, templates(), packed(2, start_s=1e3)),
        "events, one with templates": Longest(ktm, templates(), packed(1, start_s=1e3)),
        "events, places": Longest(places, (), packed(whole)),
        "events, 8 with places": Longest(places, (), packed(8)),
        "events, targets": Longest(fast, (thousand,), packed(whole)),
        "events, one with targets": Longest(fast, (thousand,), packed(1)),
        "events, targets, each answered": Longest({**fast, **each}, (targets(4),), packed(whole)),
        "events, too many": Longest({}, (), longest(lambda n: text({"type": "events", "events": [row] * n}))),
        "events, last is wrong": Longest(
            {}, (), longest(lambda n: text({"type": "events", "events": [row] * n + [[1]]}))
        ),
        "events, last is NaN": Longest(
            {}, (), longest(lambda n: text({"type": "events", "events": [row] * n + [[float("nan")] * 6]}))
        ),
        "events of 5e-324": Longest(
            {}, (), text({"type": "events", "events": [[0, 5e-324, 5e-324, None, None, 0]] * whole})
        ),
        "trial, its end": Longest(fast, (text(mark), packed(1000)), text({**mark, "action": "end"})),
        "no JSON": Longest({}, (), "[" * LIMITS.max_frame_bytes),
        "no JSON, deep": Longest({}, (), '{"a":' * 13_000),
        "a whole number": Longest({}, (), "1" * LIMITS.max_frame_bytes),
        "unknown type": Longest({}, (), longest(lambda n: text({"type": "x", "a": [[]] * n}))),
        "unknown field": Longest({}, (), longest(lambda n: text({"type": "reset", "a": [[]] * n}))),
        "bye": Longest({}, (), longest(lambda n: text({"type": "bye", "reason": "x" * n}))),
    }


def session_before(one: Longest) -> PointingSession:
    """A session that has received all but the frame itself, long enough ago for a full budget."""
    session = PointingSession("name", LIMITS, 0.0)
    first = [] if one.hello is None else [text({"type": "hello", "version": 1, **one.hello})]
    for number, frame in enumerate([*first, *one.before]):
        session.receive(frame, 10.0 * number)
        if session.work is not None:
            session.finish(session.work())
    session.outbox.take()
    assert not session.refusals, session.refusals
    return session


def measure(one: Longest) -> tuple[float, float]:
    """The processor time of a frame on the event loop, and of the work beside it, ms."""
    on_loop, beside = [], []
    for _ in range(TRIES):
        session = session_before(one)
        begun = time.thread_time()
        session.receive(one.frame, 1e4)
        session.outbox.take()
        received = time.thread_time()
        work = session.work and session.work()
        worked = time.thread_time()
        if work is not None:
            session.finish(work)
            session.outbox.take()
        on_loop.append(received - begun + time.thread_time() - worked)
        beside.append(worked - received)
    return 1e3 * min(on_loop), 1e3 * min(beside)


if __name__ == "__main__":
    parse(__doc__)
    measured = {name: (one, *measure(one)) for name, one in longest_messages().items()}
    rows = sorted(
        (
            (name, str(len(one.frame)), f"{on_loop:.2f}", f"{beside:.2f}")
            for name, (one, on_loop, beside) in measured.items()
        ),
        key=lambda row: -float(row[2]),
    )
    keep(
        "costs",
        {"longest_messages": Table.of(("message", "bytes", "on the loop, ms", "beside it, ms"), rows)},
        part="longest_messages",
        machine=machine(load=True),
    )
