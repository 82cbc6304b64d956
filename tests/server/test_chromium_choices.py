"""Choices in the browser client: with their elements, withdrawn where the session is lost."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page

from tests.server import browser
from tests.server.listener import Listener, soon

pytestmark = browser.needed

CONNECT = """import("/pointpred.js").then(({ connect }) => {
  window.heard = [];
  const box = document.getElementById("box");
  box.style = "position: absolute; left: 380px; top: 80px; width: 40px; height: 40px";
  window.connection = connect(undefined, { pointer: false, predictor: "minimum-jerk", encoding: "ENCODING" });
  connection.configure({ precision: 0.5 });
  connection.observe(box, "goal");
  connection.on("choice", ({ action, id, element, t }) => heard.push([action, id, element === box, t]));
})"""
MOVE = """for (let i = 0; i < 40; i += 1) {
  const u = i / 60;
  connection.send([[i / 100, 400 * u * u * (3 - 2 * u), 100]]);
}"""
BOTH = """[document.getElementById("box"), "goal"].map((named) => connection.probability(named))"""


@pytest.fixture
def page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    with browser.running(tmp_path_factory.mktemp("profile")) as chromium, chromium.tab() as tab:
        yield tab


@pytest.mark.parametrize("encoding", ["binary", "json"])
def test_a_choice_names_its_element_and_ends_with_the_session(page: Page, encoding: str) -> None:
    with Listener() as listener:
        page.goto(listener.url)
        page.evaluate(CONNECT.replace("ENCODING", encoding))
        soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")
        soon(lambda: bool(listener.messages("targets")[-1:]), "the element is a target")
        page.evaluate(MOVE)
        soon(lambda: page.evaluate("connection.proposed") == "goal", "the element is proposed")
        said = page.evaluate("heard")
        assert [row[:3] for row in said] == [["propose", "goal", True]]
        assert 0.0 <= said[0][3] <= 0.39
        assert 0.5 <= page.evaluate("connection.probability('goal')") <= 1.0
        by_element, by_id = page.evaluate(BOTH)  # asked at once: answers go on arriving
        assert by_element == by_id
        assert page.evaluate("connection.probability('another')") == 0
    soon(lambda: page.evaluate("connection.proposed") is None, "what is lost proposes nothing")
    assert page.evaluate("heard")[-1] == ["retract", "goal", True, None]
    assert page.evaluate("connection.probability('goal')") == 0


def test_choices_about_the_past_wait_for_the_next_movement(page: Page) -> None:
    """What waited for a connection is sent, but a proposal it makes is announced by a later event only."""
    with Listener() as listener:
        page.goto(listener.url)
        page.evaluate(CONNECT.replace("ENCODING", "binary"))
        soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")
    soon(lambda: page.evaluate("connection.state") == "waiting", "the loss was noticed")
    page.evaluate("connection.on('prediction', ({ t }) => { window.last = t; }); 0")
    page.evaluate(MOVE)
    with Listener(listener.port) as again:
        soon(lambda: len(again.events()) == 40, "what waited was sent")
        soon(lambda: page.evaluate("window.last === 0.39"), "all of it was answered")
        assert page.evaluate("heard") == []
        page.evaluate("connection.send([[0.4, 400 * (4 / 6) ** 2 * (3 - 8 / 6), 100]])")
        soon(lambda: page.evaluate("heard.length") > 0, "the proposal that stands is announced")
        assert page.evaluate("heard[0].slice(0, 2)") == ["propose", "goal"]
