"""What the browser client is asked to change, whenever it is asked, and what its listeners may do."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page

from pointpred import RECOMMENDED
from tests.server import browser
from tests.server.browser import Chromium
from tests.server.listener import Listener, soon
from tests.server.running import running
from tests.server.test_chromium_client import CONNECT, connected

pytestmark = browser.needed

AFTER_HELLO = """
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  send(data) {
    super.send(data);
    if (String(data).includes('"hello"')) window.greeting?.();
  }
};
"""
"""Acts when hello is on the wire and its answer is not yet there."""


def wishes(listener: Listener) -> list[dict]:
    """What was asked for in ``configure`` messages."""
    return [{k: v for k, v in one.items() if k != "type"} for one in listener.messages("configure")]


def test_a_change_between_hello_and_welcome_is_asked_for(page: Page, listener: Listener) -> None:
    change = "() => { greeting = null; connection.configure({ predictor: 'hold' }); }"
    page.evaluate(f"{AFTER_HELLO} window.greeting = {change}; 0")
    connected(page)
    soon(lambda: wishes(listener) == [{"predictor": "hold"}], "the change was sent")
    soon(lambda: page.evaluate("connection.welcome.predictor") == "hold", "it holds")
    page.evaluate(f"window.greeting = {change.replace('hold', 'linear')}; 0")
    listener.stop()
    with Listener(listener.port) as again:
        soon(lambda: wishes(again) == [{"predictor": "linear"}], "the same in a session opened again")
        assert [hello["predictor"] for hello in again.messages("hello")] == ["hold"]
        soon(lambda: page.evaluate("connection.welcome.predictor") == "linear", "it holds")


def test_a_refused_change_before_welcome_is_not_repeated(page: Page, listener: Listener) -> None:
    change = "() => { greeting = null; connection.configure({ predictor: 'nobody' }); }"
    page.evaluate(f"{AFTER_HELLO} window.greeting = {change}; 0")
    connected(page)
    soon(lambda: page.evaluate("heard.error.length") == 1, "the refusal")
    listener.stop()
    with Listener(listener.port) as again:
        soon(lambda: len(again.messages("hello")) == 1, "the session was resumed")
        assert again.messages("hello")[0]["predictor"] == RECOMMENDED


def test_precision_is_asked_for_in_every_session(page: Page, listener: Listener) -> None:
    page.evaluate(CONNECT.replace("OPTIONS", "{}") + ".then(() => connection.configure({ precision: 0.9 }))")
    soon(lambda: wishes(listener) == [{"precision": 0.9}], "what was asked for before there was a session")
    page.evaluate("connection.configure({ precision: 0.8 })")
    soon(lambda: page.evaluate("heard.welcome.length") == 3, "the change was taken")
    page.evaluate("connection.configure({ precision: 8 })")
    soon(lambda: page.evaluate("heard.error.length") == 1, "the refusal")
    listener.stop()
    with Listener(listener.port) as again:
        soon(lambda: wishes(again) == [{"precision": 0.8}], "what held is asked for again")


def test_what_waited_is_sent_before_anybody_hears_of_the_connection(page: Page, listener: Listener) -> None:
    page.evaluate(
        CONNECT.replace("OPTIONS", "{ pointer: false }") + ".then(() => {"
        "connection.send([[1, 0, 0]]);"
        "connection.on('state', (state) => state === 'open' && connection.send([[2, 0, 0]])); })"
    )
    soon(lambda: len(listener.events()) == 2, "both events")
    assert listener.events()["t"].tolist() == [1.0, 2.0]


@pytest.mark.parametrize("state", ["connecting", "open", "waiting"])
def test_a_listener_may_close_whatever_it_hears(page: Page, listener: Listener, state: str) -> None:
    page.evaluate("window.thrown = []; addEventListener('error', ({ message }) => thrown.push(message))")
    page.evaluate(
        CONNECT.replace("OPTIONS", "{ pointer: false }") + ".then(() => {"
        "connection.send([[1, 0, 0], [2, 1, 1]]);"
        f"connection.on('state', (state) => state === {state!r} && connection.close()); }})"
    )
    if state != "open":
        soon(lambda: page.evaluate("connection.state") == "open", "it is open")
        listener.stop()
    soon(lambda: page.evaluate("connection.state") == "closed", "it is closed")
    with Listener(listener.port) if state != "open" else listener as again:
        page.evaluate("new Promise((done) => setTimeout(done, 500))")  # longer than the first wait
        assert page.evaluate("connection.state") == "closed"
        assert len(again.messages("hello")) == (state == "open")
    assert page.evaluate("thrown") == []


def test_another_token_is_tried(chromium: Chromium) -> None:
    with running(token="the right words") as service, chromium.tab(f"{service.url}/healthz") as page:
        page.evaluate(CONNECT.replace("OPTIONS", "{ token: 'guess' }"))
        soon(lambda: page.evaluate("connection.state") == "refused", "the token was refused")
        page.evaluate("connection.configure({ token: 'the right words', predictor: 'hold' })")
        soon(lambda: page.evaluate("connection.state") == "open", "another was tried")
        assert page.evaluate("connection.welcome.predictor") == "hold"
        assert page.evaluate("heard.error.map(({ code }) => code)") == ["unauthorized"]


def test_options_that_are_undefined_are_as_if_not_given(page: Page, listener: Listener) -> None:
    names = [
        "predictor",
        "parameters",
        "reply",
        "encoding",
        "element",
        "pointer",
        "coordinates",
        "targets",
        "queue",
        "token",
    ]
    connected(page, f"{{ {', '.join(f'{name}: undefined' for name in names)} }}")
    [hello] = listener.messages("hello")
    assert {key: hello[key] for key in ("predictor", "reply", "encoding")} == {
        "predictor": RECOMMENDED,
        "reply": "frame",
        "encoding": "binary",
    }


def test_an_element_observed_twice_stays_a_target(page: Page, listener: Listener) -> None:
    page.evaluate("box.style = 'position: absolute; left: 40px; top: 50px; width: 60px; height: 70px'")
    connected(page)
    page.evaluate("connection.observe(box, 'first')")

    def names() -> list[str]:
        told = listener.messages("targets")
        return [one["id"] for one in told[-1]["targets"]] if told else []

    soon(lambda: names() == ["first"], "it is a target")
    assert page.evaluate("connection.observe(box)") == "first"
    page.evaluate("connection.observe(box, 'second')")
    soon(lambda: names() == ["second"], "it has another name")
    assert [] not in [one["targets"] for one in listener.messages("targets")]
