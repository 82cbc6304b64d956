"""The browser client in a real browser: it goes on with the person where another session stopped."""

from __future__ import annotations

import json
from typing import Any

from playwright.sync_api import Page

from pointpred import EventColumns, Pipeline, build, run
from tests.server import browser
from tests.server.listener import Listener, soon
from tests.server.test_chromium_client import CONNECT

pytestmark = browser.needed

NAME = "kinematic-adaptive"
WAYS = [300.0, 420.0, 360.0, 500.0]
WITH_PERSON = CONNECT.replace("prediction: []", "prediction: [], person: []")


def reach(px: float) -> list[list[float]]:
    shares = [min(i / 50, 1.0) for i in range(60)]
    return [
        [i / 100, round(px * (10 * s**3 - 15 * s**4 + 6 * s**5)), 0, None, None, 0]
        for i, s in enumerate(shares)
    ]


def taught(count: int) -> Pipeline:
    """A pipeline that nobody interrupts, after some movements."""
    pipeline = build(NAME)
    for px in WAYS[:count]:
        run(pipeline, columns(px))
        pipeline.reset()
    return pipeline


def columns(px: float) -> EventColumns:
    rows = reach(px)
    return EventColumns.of(*([row[k] for row in rows] for k in range(3)))


def connected(page: Page, **options: Any) -> None:
    options = {"predictor": NAME, "reply": "event", "pointer": False, **options}
    page.evaluate(WITH_PERSON.replace("OPTIONS", json.dumps(options)))
    soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")


def move(page: Page, px: float) -> list[float]:
    """A movement, finished: the endpoints said along it."""
    page.evaluate(f"heard.prediction.length = 0; connection.send({json.dumps(reach(px))})")
    soon(lambda: page.evaluate("heard.prediction.length") == 60, "every prediction")
    page.evaluate("connection.reset()")
    return [float(x) for x in page.evaluate("heard.prediction.map(({ x }) => x)")]


def test_a_session_opened_again_knows_the_person(page: Page, listener: Listener) -> None:
    connected(page)
    for px in WAYS[:2]:
        move(page, px)
    known = taught(2).person
    soon(lambda: page.evaluate("heard.person.at(-1)?.person") == known, "the client asked by itself")
    listener.stop()
    with Listener(listener.port) as again:
        soon(lambda: len(again.messages("hello")) == 1, "the session was resumed")
        assert again.messages("hello")[0]["person"] == known
        soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")
        for k in (2, 3):
            assert move(page, WAYS[k]) == run(taught(k), columns(WAYS[k])).x.tolist()
        assert page.evaluate("connection.person()") == taught(4).person
        page.evaluate("connection.close()")
    assert page.evaluate("connection.person()") == taught(4).person  # what was heard last


def test_a_page_may_say_whom_it_knows(page: Page, listener: Listener) -> None:
    known = taught(3).person
    connected(page, person=known)
    assert page.evaluate("connection.person()") == known
    assert page.evaluate("heard.person.length") == 0  # nothing new
    assert move(page, WAYS[3]) == run(taught(3), columns(WAYS[3])).x.tolist()
    assert page.evaluate("connection.person('')") == ""
    assert page.evaluate("heard.person.at(-1)") == {"type": "person", "person": ""}
    assert page.evaluate(f"connection.person({json.dumps(known)})") == known
    refused = "connection.person('1.nobody').catch((error) => error.name)"
    assert page.evaluate(refused) == "RangeError"
    assert page.evaluate("heard.error.at(-1).path") == "$.person"
    assert page.evaluate("connection.person()") == known


def test_a_person_that_the_service_does_not_take_is_dropped(page: Page, listener: Listener) -> None:
    connected(page, person="1.nobody")
    assert [error["path"] for error in page.evaluate("heard.error")] == ["$.person"]
    assert page.evaluate("heard.person") == [{"type": "person", "person": ""}]
    assert [hello.get("person") for hello in listener.messages("hello")] == ["1.nobody", None]


def test_another_predictor_is_not_given_the_person(page: Page, listener: Listener) -> None:
    connected(page, person=taught(3).person)
    page.evaluate("connection.configure({ predictor: 'linear' })")
    soon(lambda: page.evaluate("connection.welcome.predictor") == "linear", "it predicts")
    listener.stop()
    with Listener(listener.port) as again:
        soon(lambda: page.evaluate("connection.state") == "open" and again.messages("hello"), "opened again")
        (hello,) = again.messages("hello")
        assert (hello["predictor"], hello.get("person")) == ("linear", None)


def test_whom_the_page_names_without_a_session_is_said_in_the_next(page: Page, listener: Listener) -> None:
    connected(page)
    listener.stop()
    soon(lambda: page.evaluate("connection.state") == "waiting", "the session is lost")
    known = taught(3).person
    assert page.evaluate(f"connection.person({json.dumps(known)})") == known
    with Listener(listener.port) as again:
        soon(lambda: page.evaluate("connection.state") == "open" and again.messages("hello"), "opened again")
        assert again.messages("hello")[0]["person"] == known
