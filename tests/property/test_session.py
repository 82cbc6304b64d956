"""Whatever comes over the wire, in whatever order: a session answers, or ends with a documented code."""

from __future__ import annotations

import json
from math import isnan
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from pointpred import REGISTRY
from pointpred.clock import Instant
from pointpred.protocol.decoding import decode_server_message
from pointpred.protocol.server_messages import ErrorMessage, Limits, Score
from pointpred_server.sessions.pointing import PointingSession
from tests.unit.talking import NO_COUNTS, PREDICTION, events, hello, packed

CODES = {1000, 1001, 1008, 1009, 1011, 1013}
LIMITS = Limits(max_frame_bytes=4096, max_events_per_frame=20, max_events_per_s=200, max_targets=3)
decode = decode_server_message

number = st.floats(allow_nan=True) | st.integers() | st.sampled_from([0, 1e9, 1e9 + 1, -1e9, 5e-324])
value = number | st.none() | st.booleans() | st.text(max_size=5)
json_value = st.recursive(
    value,
    lambda inside: st.lists(inside, max_size=6) | st.dictionaries(st.text(max_size=5), inside),
    max_leaves=9,
)
place = st.floats(-1e4, 1e4) | st.floats(-1e9, 1e9)
time = st.floats(0, 10) | st.floats(-1e9, 1e9)
count = st.none() | st.integers(-40000, 40000)
good_row = st.tuples(time, place, place, count, count, st.integers(0, 65535)).map(
    lambda row: (*row[:3], None, None, row[5]) if None in row[3:5] else row
)
any_row = st.tuples(value, value, value, value, value, value) | st.lists(value, max_size=7)
target = st.fixed_dictionaries(
    {"id": st.text(max_size=3), "x": number, "y": number, "width": number, "height": number}
)
settings = st.dictionaries(
    st.sampled_from(["threshold", "gap_s", "order", "differentiator", "gains", "cpi", "what"]),
    json_value,
    max_size=2,
)
field = st.one_of(
    st.tuples(st.just("events"), st.lists(good_row | any_row, max_size=22)),
    st.tuples(st.just("targets"), st.lists(target, max_size=4)),
    st.tuples(st.sampled_from(["action"]), st.sampled_from(["start", "end", "x"])),
    st.tuples(st.sampled_from(["target", "device", "screen"]), target | json_value),
    st.tuples(st.just("parameters"), settings),
    st.tuples(st.just("predictor"), st.sampled_from([*REGISTRY, "x"])),
    st.tuples(st.just("reply"), st.sampled_from(["frame", "event", "x"])),
    st.tuples(st.just("encoding"), st.sampled_from(["json", "binary", "x"])),
    st.tuples(st.sampled_from(["version", "precision"]), st.just(1) | number),
    st.tuples(st.just("reason"), st.text(max_size=5)),
)
kinds = st.sampled_from(["hello", "events", "targets", "trial", "configure", "reset", "bye", "x"])
message = st.builds(lambda kind, fields: {"type": kind, **dict(fields)}, kinds, st.lists(field, max_size=3))
well_made = st.one_of(
    st.lists(good_row, max_size=21).map(lambda rows: events(*rows)),
    st.sampled_from(["start", "end"]).map(lambda action: {"type": "trial", "action": action}),
    st.just({"type": "reset"}),
    st.sampled_from(list(REGISTRY)).map(lambda name: {"type": "configure", "predictor": name}),
)
frame = st.one_of(
    well_made.map(json.dumps),
    message.map(json.dumps),
    json_value.map(json.dumps),
    st.text(),
    st.binary(max_size=100),
    st.lists(st.binary(min_size=30, max_size=30), max_size=22).map(b"".join),
    st.sampled_from([" " * 5000, b"\0" * 5000, "[" * 4000]),
)
greetings = st.sampled_from(list(REGISTRY)).flatmap(
    lambda name: st.sampled_from(
        [None, hello(name), hello(name, reply="event"), hello(name, encoding="binary", reply="event")]
    )
)


def check(answer: str | bytes) -> Any:
    """Every answer is a packed prediction or one of the messages of the server."""
    if isinstance(answer, bytes):
        assert len(answer) % PREDICTION.size == 0
        return list(PREDICTION.iter_unpack(answer))
    return decode(answer)


@given(greetings, st.lists(st.tuples(frame, st.floats(0, 3)), max_size=12), st.booleans())
def test_any_frames_are_answered_or_end_the_session(
    greet: dict[str, Any] | None, frames: list[tuple[str | bytes, float]], reads: bool
) -> None:
    session, now = PointingSession("s", LIMITS, Instant(0.0)), 0.0
    if greet:
        session.receive(json.dumps(greet), Instant(now))
    for sent, pause in frames:
        now += pause
        session.tick(Instant(now))
        session.receive(sent, Instant(now))
        answers = [check(answer) for answer in session.outbox.take()] if reads else []
        errors = [a for a in answers if isinstance(a, ErrorMessage)]
        assert all(e.recoverable for e in errors) or session.state == "closed"
        assert (session.close is not None) == (session.state == "closed")
    if session.close is not None:
        assert session.close.code in CODES
        assert len(session.close.reason.encode()) <= 123
        return
    session.outbox.take()
    session.receive(json.dumps(hello()), Instant(now))
    session.receive('{"type": "reset"}', Instant(now))
    session.outbox.take()
    session.receive(json.dumps(events([1.0, 2.0, 3.0, None, None, 0])), Instant(now + 5.0))
    (answer,) = session.outbox.take()
    assert answer
    assert not isinstance(check(answer), ErrorMessage)


def same(one: Any, packed_row: tuple[float, ...]) -> bool:
    """Whether a JSON prediction says what a packed one says, bit for bit."""
    scale = one.scale
    place = [one.t, one.x, one.y, *((scale.sxx, scale.sxy, scale.syy) if scale else (None,) * 3)]
    wanted = [*place, one.remaining_s, scale.tail if scale else None]
    phase = ("still", "ballistic", "corrective")[int(packed_row[7])]
    numbers = (*packed_row[:7], packed_row[8])
    alike = all(w == p or (w is None and isnan(p)) for w, p in zip(wanted, numbers, strict=True))
    return alike and (one.phase in (phase, None))


@given(st.sampled_from(list(REGISTRY)), st.lists(st.lists(good_row, max_size=6), max_size=6), st.booleans())
def test_events_in_json_and_packed_give_the_same_predictions(
    name: str, frames: list[list[tuple[Any, ...]]], marks: bool
) -> None:
    device = {"device": {"cpi": 800}, "reply": "event"}
    text, binary = (PointingSession("s", Limits(), Instant(0.0)) for _ in range(2))
    text.receive(json.dumps(hello(name, **device)), Instant(0.0))
    binary.receive(json.dumps(hello(name, encoding="binary", **device)), Instant(0.0))
    for session in (text, binary):
        session.outbox.take()
        if marks:
            session.receive('{"type": "trial", "action": "start"}', Instant(0.0))
    for rows in frames:
        fitting = [
            (*row[:3], *(None if n is None else max(NO_COUNTS + 1, min(32767, n)) for n in row[3:5]), row[5])
            for row in rows
        ]
        text.receive(json.dumps(events(*fitting)), Instant(0.0))
        binary.receive(packed(*fitting), Instant(0.0))
        told = [check(answer) for answer in text.outbox.take()]
        bare = [check(answer) for answer in binary.outbox.take()]
        assert [e for e in told if isinstance(e, ErrorMessage)] == [
            e for e in bare if isinstance(e, ErrorMessage)
        ]
        records = [row for rows in bare if isinstance(rows, list) for row in rows]
        said = [one for one in told if not isinstance(one, ErrorMessage)]
        assert all(same(one, row) for one, row in zip(said, records, strict=True))
    if marks:
        for session in (text, binary):
            session.receive('{"type": "trial", "action": "end"}', Instant(0.0))
        (first,), (second,) = (map(check, session.outbox.take()) for session in (text, binary))
        assert isinstance(first, Score)
        assert first == second
