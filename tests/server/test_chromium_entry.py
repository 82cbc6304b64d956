"""What the browser client proposes by itself: an element that is entered, focused or touched."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page

from tests.server import browser
from tests.server.listener import Listener, soon

pytestmark = browser.needed

PAGE = """document.body.innerHTML = `<div id=first tabindex=0><button id=inner>go</button></div>
  <div id=second tabindex=0></div><button id=free>free</button>`;
for (const [name, left, top, width, height] of [["first", 100, 100, 200, 142], ["inner", 20, 80, 60, 24],
    ["second", 324, 100, 200, 142], ["free", 700, 100, 60, 24]])
  document.getElementById(name).style.cssText =
    `position:absolute;left:${left}px;top:${top}px;width:${width}px;height:${height}px`"""
CONNECT = """import("/pointpred.js").then(({ connect }) => {
  window.heard = [];
  window.known = 0;
  window.connection = connect(URL, OPTIONS);
  connection.on("choice", ({ id, p, action, reason, element }) =>
    heard.push([action, id, reason, element?.id, p]));
  connection.on("targets", ({ count }) => { window.known = count; });
  for (const name of ["first", "second"]) connection.observe(document.getElementById(name));
})"""
NOWHERE = "'http://127.0.0.1:9'"
"""Nobody listens at the port of discard."""


@pytest.fixture
def page(page: Page) -> Page:
    page.evaluate(PAGE)
    return page


def connected(page: Page, url: str = "undefined", options: str = "{}") -> None:
    page.evaluate(CONNECT.replace("URL", url).replace("OPTIONS", options))
    if url == "undefined":
        soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")


def heard(page: Page) -> list[list[Any]]:
    return [row[:3] for row in page.evaluate("heard")]


@pytest.mark.parametrize("url", ["undefined", NOWHERE], ids=["open", "no service"])
def test_the_keyboards_focus_proposes_an_element(page: Page, url: str) -> None:
    connected(page, url)
    for _ in range(4):  # first, the button inside it, second, the button that nobody observes
        page.keyboard.press("Tab")
    assert page.evaluate("heard") == [
        ["propose", "first", "focus", "first", 1],
        ["retract", "first", None, "first", 0],
        ["propose", "second", "focus", "second", 1],
        ["retract", "second", None, "second", 0],
    ]
    assert page.evaluate("connection.proposed") is None


def test_a_click_is_no_focus_of_the_keyboard(page: Page) -> None:
    connected(page, NOWHERE, "{ pointer: false }")
    page.mouse.click(150, 120)
    assert page.evaluate("document.activeElement.id") == "first"
    assert heard(page) == []


@pytest.mark.parametrize("url", ["undefined", NOWHERE], ids=["open", "no service"])
def test_a_finger_proposes_an_element_and_lifting_it_ends_that(page: Page, url: str) -> None:
    protocol = page.context.new_cdp_session(page)
    protocol.send("Emulation.setTouchEmulationEnabled", {"enabled": True})
    connected(page, url)
    if url == "undefined":
        soon(lambda: page.evaluate("known") == 2, "the service knows both")
    points = [{"x": 400, "y": 150}]
    protocol.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": points})
    assert heard(page)[:1] == [["propose", "second", "touch"]]
    protocol.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    said: list[list[Any]] = []

    def ended() -> bool:
        said[:] = heard(page)  # looked at once: a service may still answer
        return said[-1][0] == "retract"

    soon(ended, "the end of the touch")
    first, *later = said
    assert first == ["propose", "second", "touch"]
    assert later[-1] == ["retract", "second", None]
    # A service that answers after the finger was lifted has still seen it enter.
    assert len(later) == 1 or (
        url == "undefined" and later[:2] == [later[-1], ["propose", "second", "entered"]]
    )


def finger(page: Page, kind: str, number: int, on: str) -> None:
    more = f"{{ pointerId: {number}, pointerType: 'touch', bubbles: true, composed: true }}"
    page.evaluate(
        f"document.getElementById('{on}').dispatchEvent(new PointerEvent('pointer{kind}', {more})) && 0"
    )


def test_a_finger_stays_while_another_is_lifted(page: Page) -> None:
    connected(page, NOWHERE)
    for kind, number, on, said in (
        ("down", 1, "first", [["propose", "first", "touch"]]),
        ("down", 2, "second", [["propose", "second", "touch"]]),
        ("down", 3, "inner", []),  # two fingers on one element
        ("up", 1, "first", []),
        ("cancel", 3, "inner", [["retract", "first", None]]),
        ("up", 2, "second", [["retract", "second", None]]),
    ):
        before = len(heard(page))
        finger(page, kind, number, on)
        assert heard(page)[before:] == said, (kind, number)


def test_fingers_whose_end_is_never_heard_are_bounded(page: Page) -> None:
    connected(page, NOWHERE)
    for number in range(40):
        finger(page, "down", number, "second" if number else "first")
    assert heard(page) == [
        ["propose", "first", "touch"],
        ["propose", "second", "touch"],
        ["retract", "first", None],
    ]


def test_without_a_service_the_mouse_proposes_what_it_enters(page: Page) -> None:
    connected(page, NOWHERE)
    page.mouse.move(50, 50)
    assert heard(page) == []
    page.mouse.move(150, 120)
    page.mouse.move(130, 190)  # over the button inside it
    assert heard(page) == [["propose", "first", "entered"]]
    page.mouse.move(400, 150)
    assert heard(page)[1:] == [["retract", "first", None], ["propose", "second", "entered"]]
    page.evaluate("connection.unobserve(document.getElementById('second'))")
    assert heard(page)[3:] == [["retract", "second", None]]
    assert page.evaluate("heard.at(-1)[3]") == "second"
    page.evaluate("connection.observe(document.getElementById('second'))")
    assert heard(page)[4:] == [["propose", "second", "entered"]]
    page.evaluate("connection.close()")
    assert heard(page)[5:] == [["retract", "second", None]]
    page.mouse.move(150, 120)
    assert len(heard(page)) == 6


def test_entry_goes_on_when_the_service_goes_and_comes_back(page: Page, listener: Listener) -> None:
    """What the mouse is in stays proposed when the session is lost, and is not proposed twice afterwards."""
    connected(page)
    page.evaluate("connection.configure({ precision: 1 })")  # nothing is predicted
    soon(lambda: len(listener.messages("targets")[-1:]) == 1, "both are targets")
    page.mouse.move(50, 50)  # of a mouse that first appears in a target the page itself says so
    page.mouse.move(150, 120)
    soon(lambda: heard(page) == [["propose", "first", "entered"]], "the service says so")
    assert page.evaluate("heard")[0][4] < 1.0  # its share: the page itself would say 1
    listener.stop()
    soon(lambda: page.evaluate("connection.state") == "waiting", "the loss")
    assert page.evaluate("connection.proposed") == "first"
    page.mouse.move(400, 150)
    assert heard(page) == [
        ["propose", "first", "entered"],
        ["retract", "first", None],
        ["propose", "second", "entered"],
    ]
    with Listener(listener.port) as again:
        soon(lambda: page.evaluate("connection.state") == "open", "the session is opened again")
        soon(lambda: len(again.messages("targets")[-1:]) == 1, "both are targets again")
        before = len(again.events())
        page.mouse.move(410, 150)
        soon(lambda: len(again.events()) > before, "the service knows where the mouse is")
        page.mouse.move(600, 300)
        soon(lambda: page.evaluate("connection.proposed") is None, "the mouse has left")
        assert heard(page)[3:] == [["retract", "second", None]]


def answered(page: Page) -> None:
    """Wait until the service has answered every event; without one there is nothing to wait for."""
    page.evaluate("connection.person()")


@pytest.mark.parametrize("url", ["undefined", NOWHERE], ids=["open", "no service"])
def test_what_is_entered_stays_until_it_is_left_by_the_mouse_or_by_scrolling(page: Page, url: str) -> None:
    page.evaluate("document.body.style.padding = '9px 3000px'")
    connected(page, url, "{ encoding: 'json' }")
    if url == "undefined":
        page.evaluate("connection.configure({ precision: 1 })")  # nothing is predicted
        soon(lambda: page.evaluate("known") == 2, "the service knows both")
    page.mouse.move(150, 120)
    answered(page)
    entered = ["propose", "first", "entered"]
    assert heard(page) == [entered]
    page.mouse.click(150, 120)
    page.mouse.move(151, 120)
    answered(page)
    assert heard(page) == [entered]
    page.evaluate("scrollTo(224, 0)")  # the second comes to where the mouse rests
    there = [entered, ["retract", "first", None], ["propose", "second", "entered"]]
    soon(lambda: len(heard(page)) >= 3, "the change of targets")
    page.mouse.move(152, 120)
    answered(page)
    assert heard(page) == there
    page.mouse.move(152, 20)
    answered(page)
    assert heard(page)[3:] == [["retract", "second", None]]
    page.mouse.move(152, 120)
    answered(page)
    assert heard(page)[4:] == [["propose", "second", "entered"]]


SAY = """window.say = null;
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  set onmessage(listen) {
    window.say = (message) => listen({ data: JSON.stringify(message) });
    super.onmessage = listen;
  }
};
for (const [around, left, top] of [[document.body, 600, 100], [document.getElementById("second"), 140, 90]]) {
  const frame = document.createElement("iframe");
  frame.style.cssText = `position:absolute;left:${left}px;top:${top}px;width:50px;height:40px`;
  around.append(frame);
}
"""
PREDICT = """say({ type: "choice", id: "second", p: 0.9, action: "propose", reason: "predicted",
  t: performance.now() / 1000 })"""
OUTSIDE = {
    "a frame": "",
    "another window": "dispatchEvent(new Event('blur'))",
    "out of the document": "document.body.dispatchEvent(new PointerEvent('pointerout', { bubbles: true }))",
}


def test_a_prediction_is_retracted_while_the_pointer_is_elsewhere(page: Page) -> None:
    """Not that of a target that the pointer is in; the next event brings it back, where it still holds."""
    page.evaluate(SAY)
    connected(page)
    page.evaluate("connection.configure({ precision: 1 })")
    page.mouse.move(50, 50)
    page.evaluate(PREDICT)
    page.mouse.move(51, 50)
    answered(page)
    page.mouse.move(480, 210)  # the frame inside the second
    assert heard(page) == [["propose", "second", "predicted"]]
    page.mouse.move(52, 50)
    answered(page)
    assert page.evaluate("connection.proposed") == "second"
    for way in OUTSIDE.values():
        before = len(heard(page))
        if way:
            page.evaluate(f"{way} && 0")
        else:
            page.mouse.move(620, 120)
        assert heard(page)[before:] == [["retract", "second", None]], way
        page.mouse.move(51, 50)
        answered(page)
        assert heard(page)[before + 1 :] == [["propose", "second", "predicted"]], way


def test_pointer_false_hears_no_mouse(page: Page) -> None:
    connected(page, NOWHERE, "{ pointer: false }")
    page.mouse.move(150, 120)
    assert heard(page) == []
