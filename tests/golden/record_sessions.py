"""Record sessions with a service that runs, for tests/golden/sessions: simulated people, never real ones.

``python -m tests.golden.record_sessions URL`` from the project's root plays the sessions below to the service
at URL (``ws://127.0.0.1:8765/v1/stream``), with ``--only NAME`` some of them, and writes what it answered.
``--again`` sends the frames of the files that are there and replaces the answers only: for a law that is
meant to change its numbers. A file that was released is never written otherwise: make one with another name.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator

import numpy as np
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect
from websockets.typing import Subprotocol

from pointpred.datasets import sample
from pointpred.protocol.frames import pack_events
from pointpred.records import FloatArray
from tests.golden.exchanges import FOLDER, Exchange, Frame, Step, persons, read, write

SILENCE_S = 1.5
"""Without a further answer for so long, the service has answered a frame."""
PATIENCE_S = 1800.0
"""The longest wait for an answer that must come."""
THINNED = 8
"""One event of so many is kept, which is about 125 Hz."""
PER_FRAME = 12
TARGETS = [
    {"id": f"button {number}", "x": 200.0 + 230.0 * number, "y": 700.0, "width": 60.0, "height": 40.0}
    for number in range(6)
]


def main() -> None:
    """Record."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("url")
    parser.add_argument("--only", action="append", choices=SESSIONS)
    parser.add_argument("--again", action="store_true")
    options = parser.parse_args()
    for name in options.only or SESSIONS:
        path = FOLDER / f"{name}.jsonl"
        about, frames, numbers = SESSIONS[name][0], list(SESSIONS[name][1]()), True
        if options.again:
            exchange = read(path)
            about, numbers = exchange.about, exchange.numbers
            frames = [step.sent for step in exchange.steps]
        elif path.exists():
            raise SystemExit(f"{path} is there: record under another name, or answers only with --again")
        steps, close = record(options.url, frames)
        write(Exchange(about, steps, close, numbers), path)
        print(f"wrote {path.name}: {len(steps)} frames, {sum(len(step.answers) for step in steps)} answers")


def record(url: str, frames: list[Frame]) -> tuple[list[Step], int | None]:
    """Send the frames one by one; returns them with their answers, and the code that ended the session."""
    steps: list[Step] = []
    options = {"compression": None, "proxy": None, "max_queue": None, "ping_interval": None}
    with connect(url, subprotocols=[Subprotocol("pointpred.v1")], **options) as socket:  # type: ignore[arg-type]
        for frame in frames:
            socket.send(frame)
            steps.append(Step(frame, []))
            patience_s = PATIENCE_S if has_answer(frame) else SILENCE_S
            while True:
                try:
                    steps[-1].answers.append(socket.recv(patience_s))
                except TimeoutError:
                    break
                except ConnectionClosed as closed:
                    return steps, closed.rcvd and closed.rcvd.code
                patience_s = SILENCE_S
    return steps, None


def has_answer(frame: Frame) -> bool:
    """Whether the service always answers a frame."""
    if isinstance(frame, bytes):
        return True
    quiet = ('{"type":"reset"', '{"type":"enter"', '{"type":"trial","action":"start"')
    return not frame.startswith(quiet)


def movement(number: int) -> FloatArray:
    """A trial of the embedded sample at a lower rate; the counts of the events between are added up."""
    table = sample().rows(number).table
    kept = np.arange(0, len(table), THINNED)
    counts = np.add.reduceat(table[:, 3:5], kept)
    thinned = table[kept].copy()
    thinned[1:, 3:5] = counts[:-1]
    thinned[0, 3:5] = 0.0
    return thinned


def message(kind: str, **fields: object) -> str:
    """A message as JSON."""
    return json.dumps({"type": kind, **fields}, separators=(",", ":"))


def hello(predictor: str, version: int = 1, **fields: object) -> str:
    """The first message, on the sample's device and screen."""
    about = {"device": {"cpi": 2000.0, "rate_hz": 1000.0}, "screen": {"dpi": 96.0}}
    return message("hello", version=version, predictor=predictor, **about, **fields)


def texts(table: FloatArray) -> Iterator[str]:
    """Events as JSON."""
    for first in range(0, len(table), PER_FRAME):
        rows = [[*row[:5], int(row[5])] for row in table[first : first + PER_FRAME].tolist()]
        yield message("events", events=rows)


def records(table: FloatArray) -> Iterator[bytes]:
    """Events as packed records: one alone, then several a frame."""
    for part in (table[:1], *(table[first : first + PER_FRAME] for first in range(1, len(table), PER_FRAME))):
        yield pack_events(part)


def targets_and_trials() -> Iterator[Frame]:
    """A trial with targets, its score, other settings, a second predictor, the end."""
    trial = sample().trials[0]
    goal = {"x": trial.target_x, "y": trial.target_y, "width": trial.target_w}
    own = {
        "id": "goal",
        "x": trial.target_x - 13.0,
        "y": trial.target_y - 13.0,
        "width": 26.0,
        "height": 26.0,
    }
    yield hello("switched", reply="frame", encoding="json")
    yield message("targets", targets=[*TARGETS, own])
    yield message("configure", precision=0.5)
    yield message("trial", action="start", target=goal)
    yield from texts(movement(0))
    yield message("trial", action="end")
    yield message("targets", targets=[])
    yield message("reset")
    yield message("configure", predictor="linear", parameters={"horizon_s": 0.1}, reply="event")
    yield from texts(movement(1)[:36])
    yield message("bye", reason="done")


def packed() -> Iterator[Frame]:
    """Packed records both ways, one answer an event."""
    yield hello("kinematic", reply="event", encoding="binary")
    yield from records(movement(2))
    yield message("reset")
    yield from records(movement(3)[:60])
    yield message("bye")


def learned() -> Iterator[Frame]:
    """A person is learned, asked for and forgotten; windows are entered, places are asked for."""
    yield hello("kinematic-adaptive", reply="frame", encoding="json", places=True)
    yield message("person")
    yield message("enter", key="editor", x=100.0, y=50.0)
    for number in (4, 5, 6):
        yield from texts(movement(number))
        yield message("reset")
    yield message("person")
    yield message("forget")
    yield message("bye")


def known() -> Iterator[Frame]:
    """A session that goes on with the person of the recorded session ``learned``."""
    (person,) = persons(FOLDER / "learned.jsonl")
    yield hello("kinematic-adaptive", reply="frame", encoding="json", person=person)
    yield message("person")
    yield from texts(movement(7))
    yield message("person", person="")
    yield message("bye")


def assisted() -> Iterator[Frame]:
    """The service moves the cursor."""
    yield hello("switched", reply="frame", encoding="json", assist={"strength": 0.5, "function": "sigmoid"})
    yield from texts(movement(8)[:96])
    yield message("configure", assist={"strength": 0.0, "function": "constant", "gain": 4.0})
    yield from texts(movement(8)[96:])
    yield message("bye")


def refused() -> Iterator[Frame]:
    """Every error after which the session goes on, then one that ends it."""
    yield message("reset")
    yield message("hello", version=3)
    yield message("hello", version=1, predictor="nobody")
    yield hello("hold", parameters={"nobody": 1.0})
    yield hello("hold", surprise=True)
    yield hello("kinematic-adaptive", person="2.AAAA")
    yield hello("hold")
    yield "{"
    yield message("surprise")
    yield message("events", events=[[1.0, 5.0, 6.0, None, None, 0], [0.5, 5.0, 6.0, None, None, 0]])
    yield message("events", events=[[2.0, 5.0]])
    yield '{"type":"events","events":[[3,NaN,6,null,null,0]]}'
    yield message("targets", targets=[{"id": "a", "x": 0.0, "y": 0.0, "width": 0.0, "height": 1.0}])
    yield message("configure", predictor="nobody")
    yield message("person", person="1.damaged")
    yield b"0123456789"
    yield hello("hold")
    yield message("events", events=[[4.0, 7.0, 8.0, None, None, 0]])
    yield message("events", events=[[5.0, 0.0, 0.0, None, None, 0]] * 1025)


def first_version() -> Iterator[Frame]:
    """What the clients of the first service sent: no person, places, assistance or weights."""
    yield hello("switched", reply="event", encoding="json")
    yield message("targets", targets=TARGETS)
    yield message("configure", precision=0.9)
    yield message("trial", action="start", target={"x": 891.664, "y": 817.249, "width": 26.457})
    yield from texts(movement(0)[:120])
    yield message("trial", action="end")
    yield message("reset")
    yield message("events", events=[[9.0, 5.0, 6.0, None, None, 0], [8.0, 5.0, 6.0, None, None, 0]])
    yield message("configure", predictor="hold", reply="frame")
    yield from texts(movement(1)[:48])
    yield message("bye")


def second_version() -> Iterator[Frame]:
    """Packed records of version 2, with targets and the conditions of a trial."""
    yield hello("kinematic-adaptive", version=2, reply="event", encoding="binary")
    yield message("targets", targets=TARGETS)
    yield message("trial", action="start", conditions={"participant": "p7", "block": 2})
    yield from records(movement(2)[:120])
    yield message("trial", action="end", conditions={"participant": "p8"})
    yield message("trial", action="start", conditions={"user": "p7"})
    yield message("targets", targets=[])
    yield from records(movement(3)[:36])
    yield message("bye")


SESSIONS = {
    "targets_and_trials": (
        "JSON, one answer a frame, targets, a scored trial, another predictor",
        targets_and_trials,
    ),
    "packed": ("packed records both ways, one answer an event", packed),
    "learned": ("a person is learned, asked for and forgotten; windows and places", learned),
    "known": ("goes on with the person of the session 'learned'", known),
    "assisted": ("the service moves the cursor", assisted),
    "refused": ("every error after which a session goes on, and one that ends it", refused),
    "first_version": ("recorded with the service of 2026-11-21, the first one of version 1", first_version),
    "second_version": ("packed records of version 2, targets, the conditions of a trial", second_version),
}

if __name__ == "__main__":
    main()
