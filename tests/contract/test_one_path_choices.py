"""The same events give the same choices and shares bit for bit: in a batch, one by one, over the socket."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import cache
from math import isfinite
from typing import Any

import pytest

from pointpred import EventColumns, PointerEvent, build, run
from pointpred.clock import Instant
from pointpred.datasets import sample
from pointpred.targets import Chooser, Target, around
from pointpred.targets.aim import Aim
from pointpred_server.sessions.pointing import PointingSession
from tests.contract.test_one_path import LIMITS, binary_frame, hello, resolution, text_frame, trials
from tests.server.running import PATIENCE_S, Running, running

NAMES = ("hold", "kalman", "switched-direction")
PRECISION = 0.5
Said = tuple[list[tuple[Any, ...]], list[list[tuple[str, float]]]]
"""Choices as (t, id, p, action, reason), and after each event the likeliest targets."""


@cache
def targets() -> tuple[Target, ...]:
    """Every place that the sample's trials went to."""
    found = {(one.target_x, one.target_y): one.target_w for one in sample().trials if isfinite(one.target_x)}
    return tuple(around(str(i), *place, width) for i, (place, width) in enumerate(sorted(found.items())))


class Batch:
    """A pipeline told whole trials: their predictions first, then the targets of each event by these."""

    def __init__(self, name: str) -> None:
        cpi, dpi = resolution()
        self.plain, self.aim, self.places = build(name, cpi=cpi, dpi=dpi), Aim(), ()
        self.aim.register(targets())

    def events(self, rows: EventColumns) -> Iterator[PointerEvent]:
        """The events of a trial, each when the aim has taken it."""
        for row, answer in zip(rows.table.tolist(), run(self.plain, rows).table.tolist(), strict=True):
            self.aim.given(tuple(row), tuple(answer))
            yield PointerEvent(*row[:3])

    def reset(self) -> None:
        self.plain.reset()
        self.aim.reset()


class Single:
    """A pipeline that is updated with one event after another."""

    def __init__(self, name: str) -> None:
        cpi, dpi = resolution()
        self.pipeline, self.places = build(name, cpi=cpi, dpi=dpi, targets=targets()), ()
        self.aim, self.reset = self.pipeline.aim, self.pipeline.reset

    def events(self, rows: EventColumns) -> Iterator[PointerEvent]:
        """The events of a trial, each when the pipeline has taken it."""
        for event in rows.events():
            self.pipeline.update(event)
            yield event


def followed(pipeline: Batch | Single) -> Iterator[Said]:
    """What a chooser says of each trial; what stands at the end of one is retracted by the reset."""
    chooser = Chooser(pipeline, precision=PRECISION)
    for rows in trials():
        pipeline.reset()
        choices: list[tuple[Any, ...]] = []
        shares: list[list[tuple[str, float]]] = []
        for event in pipeline.events(rows):
            choices += [(event.t, *change[:4]) for change in chooser.update()]
            shares.append([(str(id), p) for id, p in pipeline.aim.likeliest()])
        proposed = [id for id in (chooser.standing, chooser.entered) if id is not None]
        choices += [(event.t, id, 0.0, "retract", None) for id in proposed]
        chooser.reset()
        yield choices, shares


@cache
def in_a_batch(name: str) -> tuple[Said, ...]:
    """The reference: predictions of whole trials first, then the choices."""
    return tuple(followed(Batch(name)))


def one_by_one(name: str) -> tuple[Said, ...]:
    return tuple(followed(Single(name)))


Exchange = Callable[[str | bytes], list[str | bytes]]
"""Sends a frame, and returns all it brings: up to the answer to a message that follows it."""


def listed() -> str:
    told = [
        {"id": one.id, "x": one.x, "y": one.y, "width": one.width, "height": one.height} for one in targets()
    ]
    return json.dumps({"type": "targets", "targets": told})


def talking(name: str, encoding: str, frame: int, exchange: Exchange) -> tuple[Said, ...]:
    """Every trial through a session; a packed prediction has no room for shares."""
    exchange(hello(name, encoding))
    exchange(json.dumps({"type": "configure", "precision": PRECISION}))
    exchange(listed())
    form = binary_frame if encoding == "binary" else text_frame
    found = []
    for rows in trials():
        frames: list[str | bytes] = [form(rows.table[i : i + frame]) for i in range(0, len(rows), frame)]
        answers = [answer for one in (*frames, '{"type":"reset"}') for answer in exchange(one)]
        said = [json.loads(answer) for answer in answers if isinstance(answer, str)]
        fields = ("t", "id", "p", "action", "reason")
        choices = [tuple(m[field] for field in fields) for m in said if m["type"] == "choice"]
        told = [m["targets"] for m in said if m["type"] == "prediction"]
        found.append((choices, [[(one["id"], one["p"]) for one in each] for each in told]))
    return tuple(found)


def expected(name: str, encoding: str) -> tuple[Said, ...]:
    return tuple((c, s if encoding == "json" else []) for c, s in in_a_batch(name))


@pytest.mark.parametrize("name", NAMES)
def test_one_by_one(name: str) -> None:
    assert one_by_one(name) == in_a_batch(name)


@pytest.mark.parametrize("frame", [1, 8, 32])
@pytest.mark.parametrize("encoding", ["json", "binary"])
@pytest.mark.parametrize("name", NAMES)
def test_session(name: str, encoding: str, frame: int) -> None:
    session = PointingSession("session", LIMITS, Instant(0.0))

    def exchange(frame: str | bytes) -> list[str | bytes]:
        session.receive(frame, Instant(0.0))
        return session.outbox.take()

    assert talking(name, encoding, frame, exchange) == expected(name, encoding)


@pytest.fixture(scope="module")
def service() -> Iterator[Running]:
    with running(max_events_per_s=10**8) as here:
        yield here


@pytest.mark.parametrize("encoding", ["json", "binary"])
@pytest.mark.parametrize("name", NAMES)
def test_socket(service: Running, name: str, encoding: str) -> None:
    with service.connect() as socket:

        def exchange(frame: str | bytes) -> list[str | bytes]:
            socket.send(frame)
            if isinstance(frame, str) and '"hello"' in frame:
                return [socket.recv(PATIENCE_S)]
            socket.send('{"type":"bad"}')  # answered by an error, after everything else
            answers: list[str | bytes] = []
            while not (answers and '"unknown_type"' in str(answers[-1])):
                answers.append(socket.recv(PATIENCE_S))
            return answers[:-1]

        assert talking(name, encoding, 32, exchange) == expected(name, encoding)


def test_the_reference_proposes_and_retracts_and_predictors_differ() -> None:
    """Otherwise equality would say little."""
    for name in NAMES:
        actions = [choice[3] for choices, _ in in_a_batch(name) for choice in choices]
        assert {*actions} == {"propose", "retract"}
        reasons = {choice[4] for choices, _ in in_a_batch(name) for choice in choices}
        assert reasons == {"predicted", "entered", None}
    assert len({str(in_a_batch(name)) for name in NAMES}) == len(NAMES)
