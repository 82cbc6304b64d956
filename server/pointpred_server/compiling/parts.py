"""What is compiled, in parts: each is what one kind of request needs, and running it once compiles it."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from pointpred.compiled import awaits_compiling
from pointpred.differentiators import DIFFERENTIATORS, HomogeneousDifferentiator
from pointpred.pipeline import joint_of, last_of, run
from pointpred.predictors import Predictor
from pointpred.predictors.adaptation import predictor as adaptation
from pointpred.predictors.adaptation.time_left import Pace
from pointpred.protocol.client_messages import Configure, Hello, Targets, TrialMark
from pointpred.protocol.decoding import decode_client_message
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import EVENT, unpack_events
from pointpred.records import EventColumns, Place, PointerEvent
from pointpred.registry import RECOMMENDED, REGISTRY, build
from pointpred.scoring.measures import endpoint
from pointpred.targets import Chooser, Ledger, PlaceChooser, around, choice_law
from pointpred.transfer import assistance
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.settings import Settings

Frame = dict[str, Any] | bytes

TARGETS, ASSISTANCE, TRIALS, PLACES = "targets", "assistance", "trials", "places"
PIECES = tuple(f"{RECOMMENDED}, {what}" for what in ("of anybody", "of a person", "whole", "motions"))
"""Pieces of the recommended predictor: two processes compile about half each."""
FIRST = (*PIECES, RECOMMENDED)
"""What the first answer needs. Nothing else is compiled at the same time, which would delay it."""


class Part(NamedTuple):
    """A name, what runs it, laws that show whether it is compiled, and the parts to be compiled before it."""

    name: str
    run: Callable[[], None]
    laws: tuple[Any, ...]
    after: tuple[str, ...] = ()

    @property
    def awaits(self) -> bool:
        """Whether it would be compiled when it is run, and kept for other processes."""
        return any(awaits_compiling(law) for law in self.laws)


def differentiator_part(name: str) -> str:
    """The name of the part for sessions that choose this differentiator."""
    return f"differentiator {name}"


def parts() -> list[Part]:
    """Every part, in the order in which a first start compiles them."""
    usual = {entry.differentiator for entry in REGISTRY.values()}
    first_of = {entry.predictor: name for name, entry in reversed(REGISTRY.items())}
    return [
        *_pieces(),
        _predictor(RECOMMENDED, PIECES),
        Part(TARGETS, choose, (choice_law.step, choice_law.walk, choice_law.changes), FIRST),
        Part(
            PLACES,
            propose_places,
            (choice_law.step_with_shares, choice_law.changes, adaptation.list_places),
            FIRST,
        ),
        Part(ASSISTANCE, assist, (assistance.guarded_step,), FIRST),
        Part(TRIALS, score_trial, (endpoint.measure,), FIRST),
        *(
            # Names of one class have the same laws: two processes would compile them twice.
            _predictor(name, (*FIRST, *({first_of[entry.predictor]} - {name})))
            for name, entry in REGISTRY.items()
            if name != RECOMMENDED
        ),
        *(
            Part(differentiator_part(name), partial(predict, "hold", name), (kind.step, kind.loop), FIRST)
            for name, kind in DIFFERENTIATORS.items()
            if name not in usual
        ),
    ]


def _predictor(name: str, after: tuple[str, ...] = ()) -> Part:
    kind, pipeline = REGISTRY[name].predictor, build(name)
    laws = type(pipeline.differentiator).step, kind.step
    joint = [joint_of(*laws, pipeline.compiled)]
    joint += [last_of(*laws, kind.follow)] if pipeline.compiled else []
    return Part(name, partial(predict, name), (*joint, kind.step, kind.loop), after)


def _pieces() -> Iterable[Part]:
    """The predictor under the recommended one, what it adds, both together, and their differentiator."""
    whole: Any = REGISTRY[RECOMMENDED].predictor
    beneath: Any = whole.__mro__[1]
    of_anybody, of_a_person, together, motions = PIECES
    return (
        Part(of_anybody, lambda: beneath().advance(MOTION), (beneath.step,)),
        Part(of_a_person, _adapt, (adaptation.conclude, adaptation.adapt)),
        Part(together, partial(_follow, whole), (whole.step, whole.loop), (of_anybody, of_a_person)),
        Part(motions, _move, (HomogeneousDifferentiator.step, HomogeneousDifferentiator.loop)),
    )


MOTION = (0.0, 5.0, 2.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0)
"""A row of ``MotionColumns``."""


def _adapt() -> None:
    memory = np.zeros(adaptation.LENGTH)
    adaptation.conclude(memory)
    adaptation.adapt(memory, (0.0, 5.0, 2.0, 1.0, 0.0, 1.0, 0.1, 1.0, 1.0, 1.0), Pace(1.0, 0.0))


def _follow(kind: Callable[[], Predictor]) -> None:
    kind().advance(MOTION)
    kind().walk(np.zeros(1, np.bool_), np.array([MOTION]))


def _move() -> None:
    table = unpack_events(bytes(EVENT.itemsize))
    differentiator = build(RECOMMENDED).differentiator
    differentiator.update(PointerEvent(0.0, 5.0, 2.0))
    differentiator.fresh().walk_all(np.zeros(1, np.bool_), table)


def predict(name: str, differentiator: str | None = None) -> None:
    """Run one predictor over a few events: one by one, as columns, and to the end of a movement."""
    chosen: dict[str, Any] = {} if differentiator is None else {"differentiator": differentiator}
    pipeline = build(name, cpi=1000.0, **chosen)
    for event in _events():
        pipeline.update(event)
    pipeline.reset()  # one that learns its person concludes the movement
    columns = EventColumns.of_events(_events())
    run(pipeline.fresh(), columns)
    pipeline.fresh().push(columns.table, want="last")
    pipeline.fresh().predictor.advance(MOTION)  # behind another differentiator the two laws are not one


def choose() -> None:
    """Decide among targets, event by event and over columns."""
    pipeline, chooser = build("hold"), Chooser([around("any", 200.0, 80.0, 20.0)])
    for event in _events():
        chooser.update(pipeline.update(event), event)
    chooser.expect([Place(200.0, 80.0, 0.1, 0.1, 1.0, 0, 10.0)])
    columns = EventColumns.of_events(_events())
    chooser.reset()
    chooser.follow(columns.table, run(pipeline.fresh(), columns).table)
    note(chooser.ledger)


def note(ledger: Ledger) -> None:
    """What follows from a change of mind, in each of its kinds."""
    ledger.propose(0.0, "any")
    ledger.enter(0.0, "any")
    ledger.retract(0.0, "any")
    ledger.finish(0.0, "any")
    choice_law.changes((0, 1), (1, 0))


def propose_places() -> None:
    """Decide among the places of a person, and name a window."""
    pipeline, chooser = build(RECOMMENDED), PlaceChooser()
    pipeline.enter("any")
    for event in _events():
        chooser.update(pipeline.places, pipeline.update(event), event)
    note(chooser.ledger)


def _events() -> list[PointerEvent]:
    return [PointerEvent(0.01 * i, 5.0 * i, 2.0 * i, 4.0, 2.0) for i in range(4)]


HELLO: dict[str, Any] = {"type": "hello", "version": 1, "predictor": "hold", "device": {"cpi": 1000}}


def score_trial() -> None:
    """A trial that a client marks, with its target."""
    goal = {"x": 400, "y": 100, "width": 40}
    events = {"type": "events", "events": [reach(i) for i in range(60)]}
    mark = {"type": "trial", "action": "start"}
    run_session([HELLO, mark, events, {**mark, "action": "end", "target": goal}])


def assist() -> None:
    """A session whose cursor the service moves."""
    run_session([{**HELLO, "assist": {}}, {"type": "events", "events": [reach(0)]}])


def run_session(frames: Sequence[Frame]) -> None:
    """Send frames to a session, and do the work that they lead to."""
    session = PointingSession("warm", Settings().limits, 0.0)
    for frame in frames:
        session.receive(frame if isinstance(frame, bytes) else json.dumps(frame), 0.0)
        while session.work is not None:
            session.finish(session.work())
        session.outbox.take()


def reach(i: int) -> list[float]:
    """An event of a movement of 400 px in half a second, in JSON's order."""
    s = min(i / 50, 1.0)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    return [i / 100, 400 * way, 100 * way, 4, 1, 0]


def parts_for(frame: str | bytes) -> list[str]:
    """Names of the parts that a client's frame needs; those of events came with the messages before them."""
    if isinstance(frame, bytes):
        return []
    try:
        message = decode_client_message(frame)
    except ProtocolError:
        return []  # the session answers what is wrong
    if isinstance(message, Hello | Configure):
        names = [] if message.predictor is None else [message.predictor]
        if isinstance(chosen := message.parameters.get("differentiator"), str):
            names.append(differentiator_part(chosen))
        names += [ASSISTANCE] if message.assist is not None else []
        return [*names, PLACES] if message.places else names
    if isinstance(message, Targets):
        return [TARGETS] if message.targets else []
    return [TRIALS] if isinstance(message, TrialMark) and message.action == "end" else []
