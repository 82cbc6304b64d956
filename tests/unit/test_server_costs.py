"""What a message may cost: at its limits, in a second, and where it is done."""

from __future__ import annotations

import json
import sys
from typing import Any

import pytest

from evidence.data import stored
from pointpred.predictors.ktm import TemplatePredictor
from pointpred.protocol.server_messages import Limits
from pointpred_server.sessions.costs import TEXT_BYTE_S
from pointpred_server.sessions.quota import SHARE
from pointpred_server.sessions.viewing import ViewingSession
from tests.server.longest_messages import longest_messages, packed, session_before, targets, text
from tests.unit.talking import Talk, events, hello

MESSAGES = longest_messages()
CALLS_MOST = 6000
"""Calls of functions, Python's and C's, on the event loop: a millisecond or two."""


def calls(name: str) -> int:
    """How many functions are called on the loop for a message."""
    one = MESSAGES[name]
    session_before(one).receive(one.frame, 1e4)  # what is done once
    session, count = session_before(one), 0

    def note(frame: object, event: str, argument: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        session.receive(one.frame, 1e4)
        session.outbox.take()
    finally:
        sys.setprofile(before)
    return count


@pytest.mark.parametrize("name", list(MESSAGES))
def test_no_message_at_its_limits_holds_the_loop(name: str) -> None:
    assert calls(name) <= CALLS_MOST


def test_no_message_at_its_limits_held_the_loop_for_2_ms_when_it_was_measured() -> None:
    table = stored("costs", "longest_messages").tables["longest_messages"]
    at = table.columns.index("on the loop, ms")
    assert len(table.rows) > 40
    assert [row[0] for row in table.rows if float(row[at]) >= 2.0] == []


def test_no_message_repeated_as_often_as_allowed_takes_much_more_than_its_share() -> None:
    """By the times that were measured, and what is taken from the budgets of a second for one message."""
    table = stored("costs", "longest_messages").tables["longest_messages"]
    shares = {}
    for name, _, on_loop_ms, beside_ms in table.rows:
        session = session_before(MESSAGES[name])
        budgets = session._quota.costs, session._quota.events, session._quota._messages
        for budget in budgets:
            budget.take(0.0, 1e4)
        session.receive(MESSAGES[name].frame, 1e4)
        if session.work is not None:
            session.finish(session.work())
        if session.close is None:
            most = min(budget.most / max(budget.most - budget.left, 1e-9) for budget in budgets)
            shares[name] = most * (float(on_loop_ms) + float(beside_ms)) / 1e3
    assert len(shares) > 40
    assert {name: share for name, share in shares.items() if share > 1.25 * SHARE} == {}


@pytest.mark.parametrize("name", ["hello, list of 5e-324", "events of 5e-324", "targets of 5e-324"])
def test_numbers_that_take_long_to_decode_are_refused_before_they_are(name: str) -> None:
    one = MESSAGES[name]
    session = session_before(one)
    session.receive(one.frame, 1e4)
    (answer,) = session.outbox.take()
    assert json.loads(answer)["code"] == "bad_field"
    assert "exponents" in json.loads(answer)["message"]
    assert session.close is None


def test_ids_that_look_like_such_numbers_and_small_coordinates_are_taken() -> None:
    talk = Talk()
    many = [{"id": f"4e12{i}", "x": 6.123e-17, "y": 1e-9, "width": 1, "height": 1} for i in range(900)]
    assert talk.say({"type": "targets", "targets": many}) == [{"type": "targets", "count": 900}]
    assert len(talk.say(events(*[[i * 1e-3, 6.123e-17, 1.2e-16, None, None, 0] for i in range(1000)]))) == 1


def test_at_most_64_parameters() -> None:
    talk = Talk()
    error = talk.error({"type": "configure", "parameters": {f"p{i}": 1 for i in range(65)}})
    assert (error["code"], error["path"], error["recoverable"]) == ("too_many", "$.parameters", True)
    assert "64" in error["message"]
    assert "65" in error["message"]


def test_a_session_remembers_at_most_a_megabyte() -> None:
    talk = Talk()
    error = talk.error(
        {"type": "configure", "predictor": "ktm", "parameters": {"templates": 1000, "longest_s": 30.0}}
    )
    assert (error["code"], error["field"], error["path"]) == (
        "bad_field",
        "templates",
        "$.parameters.templates",
    )
    assert TemplatePredictor(templates=1000, longest_s=30.0).memory_bytes > 2**20, "offline it may be more"
    assert talk.goes_on()


ADAPTIVE = hello("kinematic-adaptive")
KNOWN = hello(**dict(MESSAGES["configure, the person stays"].hello or {}))
SECOND: dict[str, tuple[dict[str, Any], list[Any], Any, int, int]] = {
    "targets": (hello(), [], targets(1000), 120, 300),
    "targets, too many": (hello(), [], MESSAGES["targets, too many"].frame, 100, 150),
    "targets, one id": (hello(), [], MESSAGES["targets, one id"].frame, 100, 150),
    "unknown parameters": (hello(), [], MESSAGES["configure, unknown parameters"].frame, 150, 250),
    "late events": (hello(), [packed(1, start_s=5.0)], packed(1), 2000, 5000),
    "person": (ADAPTIVE, [], MESSAGES["person"].frame, 200, 260),
    "configure": (KNOWN, [], MESSAGES["configure, the person stays"].frame, 200, 260),
    "one event": (hello("ktm", parameters={"templates": 1000}), [targets(0)], packed(1), 4000, 6500),
}
"""What is sent first, and again and again, and how often it may come in a second, at least and at most."""


@pytest.mark.parametrize("kind", list(SECOND))
def test_costly_messages_end_a_session_that_sends_too_many_a_second(kind: str) -> None:
    greet, before, frame, least, most = SECOND[kind]
    talk = Talk(greet=greet)
    for one in before:
        talk.say(one, 200.0)
    sent, heard = 0, []
    while talk.closed is None:
        heard = talk.say(frame, 200.0)
        sent += 1
    assert talk.closed == 1008
    assert heard[-1]["code"] == "too_fast"
    assert f"{SHARE:g} s of the processor" in heard[-1]["message"]
    assert least < sent < most


def test_a_page_may_register_a_thousand_targets_at_each_refresh_for_ever() -> None:
    talk = Talk()
    for k in range(120):
        talk.say(targets(1000), 10.0 + k / 60)
        assert talk.closed is None


def test_a_clock_that_jumped_back_costs_no_connection() -> None:
    talk = Talk()
    talk.say(packed(1, start_s=1e4), 0.0)
    for k in range(3000):
        talk.say(packed(1), k / 1000)
        assert talk.closed is None


@pytest.mark.parametrize("encoding", ["json", "binary"])
def test_a_long_assisted_frame_is_work_aside_and_answered_the_same(encoding: str) -> None:
    rows = [[i * 1e-3, 0.0, 0.0, 3, 1, 0] for i in range(1024)]
    heard = []
    for size in (1024, 64):
        talk = Talk(greet=hello("kinematic", encoding=encoding, assist={}, device={"cpi": 800}))
        talk.session.receive(text(events(*rows[:1])), 0.0)
        for place in range(1, 1024, size):
            talk.session.receive(text(events(*rows[place : place + size])), 0.0)
            assert (talk.session.work is not None) == (size == 1024)
            if talk.session.work is not None:
                talk.session.finish(talk.session.work())
        heard.append(talk.hear()[-2:])
    assert heard[0] == heard[1]


def test_what_is_wrong_with_a_long_frame_is_answered_after_the_work() -> None:
    talk = Talk(greet=hello(assist={}, device={"cpi": 800}))
    rows = [[i * 1e-3, 0.0, 0.0, None if i == 700 else 3, None if i == 700 else 1, 0] for i in range(1024)]
    talk.session.receive(text(events(*rows)), 0.0)
    assert talk.session.work is not None
    talk.session.finish(talk.session.work())
    (error,) = talk.hear()
    assert (error["code"], error["path"]) == ("bad_field", "$.events[700][3]")
    assert talk.session.refusals == {"bad_field": 1}


def test_a_viewer_pays_for_long_texts_too() -> None:
    viewer, sent = ViewingSession("name", Limits(), 0.0), 0
    while viewer.close is None:
        viewer.receive(MESSAGES["targets, too many"].frame, 0.0)
        sent += 1
    assert viewer.close.code == 1008
    assert 200 < sent < 250


def test_a_text_that_is_decoded_to_be_joined_pays_for_that() -> None:
    alone, joined = Talk(), Talk()
    frame = MESSAGES["targets, too many"].frame
    alone.session.receive(frame, 0.0)
    assert joined.session.receive_together([frame, frame], 0.0) == 1
    used = alone.session._quota.costs.left - joined.session._quota.costs.left
    assert used == pytest.approx(TEXT_BYTE_S * len(frame))
