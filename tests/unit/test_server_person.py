"""A session that goes on with what another one knew of its person."""

from __future__ import annotations

import math
from typing import Any

import pytest

from pointpred import RECOMMENDED
from pointpred.person import LARGEST
from pointpred_server.sessions.quota import BUILDING, MESSAGES_PER_S
from tests.building import rows_of_reach
from tests.unit.talking import Talk, events, hello

NAME = "kinematic-adaptive"
assert NAME == RECOMMENDED


def move(talk: Talk, px: float) -> list[dict[str, Any]]:
    """A movement, finished; one prediction an event."""
    said = talk.say(events(*rows_of_reach(px)))
    talk.say({"type": "reset"})
    return said


def person(talk: Talk, **known: str) -> str:
    (answer,) = talk.say({"type": "person", **known})
    assert answer.keys() == {"type", "person"}
    assert answer["type"] == "person"
    return str(answer["person"])


def open_session(**more: Any) -> Talk:
    return Talk(greet=hello(NAME, reply="event", **more))


WAYS = [300.0, 420.0, 360.0, 500.0, 390.0, 310.0]


def test_another_session_goes_on_bit_for_bit() -> None:
    whole, first = open_session(), open_session()
    said = [move(whole, px) for px in WAYS]
    for px in WAYS[:3]:
        move(first, px)
    known = person(first)
    second = open_session(person=known)
    assert person(second) == known
    assert [move(second, px) for px in WAYS[3:]] == said[3:]
    assert person(second) == person(whole)
    assert move(open_session(), WAYS[3]) != said[3]


def test_asking_changes_nothing_even_in_the_middle_of_a_movement() -> None:
    asked, plain = open_session(), open_session()
    for px in WAYS:
        rows = rows_of_reach(px)
        said = asked.say(events(*rows[:30]))
        before = person(asked)
        assert person(asked) == before
        said += asked.say(events(*rows[30:]))
        asked.say({"type": "reset"})
        assert said == move(plain, px)
    assert person(asked) == person(plain)


def test_a_person_may_be_set_and_forgotten_in_a_session() -> None:
    talk = open_session()
    for px in WAYS[:3]:
        move(talk, px)
    known = person(talk)
    talk.say(events(*rows_of_reach(1000.0)[:20]))
    assert person(talk, person="") == ""
    assert move(talk, 390.0) == move(open_session(), 390.0)  # of the movement before nothing is left
    assert person(talk, person=known) == known
    assert move(talk, 390.0) == move(open_session(person=known), 390.0)


@pytest.mark.parametrize("predictor", ["hold", "kinematic", "switched", "ktm"])
def test_who_learns_nothing_that_can_be_saved_knows_nobody(predictor: str) -> None:
    talk = Talk(greet=hello(predictor, reply="event"))
    move(talk, 300.0)
    assert person(talk) == ""
    assert person(talk, person="") == ""


KNOWN = open_session()
for way in WAYS:
    move(KNOWN, way)
PERSON = person(KNOWN)


@pytest.mark.parametrize(
    ("wrong", "predictor"),
    [
        ("nobody", NAME),
        (PERSON[:-1], NAME),
        ("1." + "A" * LARGEST, NAME),
        (7, NAME),
        (PERSON, "hold"),
        (PERSON, "kinematic"),
    ],
)
def test_a_person_that_cannot_be_taken_is_a_bad_field(wrong: Any, predictor: str) -> None:
    error = Talk(greet=False).error(hello(predictor, person=wrong))
    assert (error["code"], error["path"], error["recoverable"]) == ("bad_field", "$.person", True)
    talk = Talk(greet=hello(predictor, reply="event"))
    move(talk, 300.0)
    before = person(talk)
    error = talk.error({"type": "person", "person": wrong})
    assert (error["code"], error["path"], error["recoverable"]) == ("bad_field", "$.person", True)
    assert person(talk) == before


def test_it_is_no_parameter() -> None:
    error = Talk(greet=False).error(hello(NAME, parameters={"person": PERSON}))
    assert (error["code"], error["path"]) == ("bad_field", "$.parameters.person")


def test_it_comes_after_hello() -> None:
    assert Talk(greet=False).error({"type": "person"})["code"] == "out_of_place"


def test_other_parameters_keep_the_person_and_another_predictor_does_not() -> None:
    talk = open_session(person=PERSON)
    talk.say({"type": "configure", "parameters": {"shortest_px": 20}})
    assert person(talk) == PERSON
    talk.say({"type": "configure", "predictor": NAME})
    assert person(talk) == PERSON
    talk.say({"type": "configure", "parameters": {"adapt": 0}})
    assert person(talk) == ""
    talk = open_session(person=PERSON)
    talk.say({"type": "configure", "predictor": "hold"})
    assert person(talk) == ""
    talk.say({"type": "configure", "predictor": NAME})
    assert person(talk) == ""


def test_bringing_a_person_counts_as_what_it_builds() -> None:
    talk = open_session(person=PERSON)
    most = MESSAGES_PER_S // BUILDING
    answers = [talk.say({"type": "person", "person": PERSON}) for _ in range(most)]
    assert [one[0]["type"] for one in answers[:-1]] == ["person"] * (most - 1)  # hello was one as well
    assert (answers[-1][0]["code"], talk.closed) == ("too_fast", 1008)


def test_the_score_of_a_trial_knows_nobody() -> None:
    """Trials are scored with a fresh pipeline, so what a session knew of the person does not flatter them."""

    def score(talk: Talk) -> float:
        talk.say({"type": "trial", "action": "start"})
        talk.say(events(*rows_of_reach(380.0)))
        (answer,) = talk.say({"type": "trial", "action": "end"})
        return float(answer["time_averaged_px"])

    with_person, without = score(open_session(person=PERSON)), score(open_session())
    assert with_person == without
    assert math.isfinite(without)
