"""The assist view in a real browser: the mouse is lent, the service moves the cursor, Escape gives it back."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

HEARD = """
window.told = []; window.answered = [];
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  set onmessage(listen) {
    super.onmessage = (event) => { if (typeof event.data === "string") answered.push(JSON.parse(event.data)); listen(event); };
  }
  send(data) { if (typeof data === "string") told.push(JSON.parse(data)); super.send(data); }
};
"""
"""Keeps what the page tells the service and hears."""
HELD = "document.pointerLockElement?.id === 'assist-scene'"
CURSOR = "['x', 'y'].map((of) => Number(document.querySelector('#assist-scene').dataset[of]))"
TARGET = "document.querySelector('#assist-scene').dataset.target.split(',').map(Number)"
LAST = "answered.findLast(({ type }) => type === 'cursor')"


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with page_browser.service() as address:
        yield address


@pytest.fixture
def visitor(tmp_path_factory: pytest.TempPathFactory, url: str) -> Iterator[Visitor]:
    """Somebody who has opened the view; nothing complains, nothing shifts."""
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.call("Page.addScriptToEvaluateOnNewDocument", source=HEARD)
        opened.open(f"{url}#assist")
        opened.wait("!document.querySelector('#assist-take').disabled")
        yield opened
        assert opened.complaints() == []
        assert opened.shift() < 0.001


def lend(visitor: Visitor) -> tuple[float, float]:
    """Click the button; where the mouse is then."""
    left, top, width, height = visitor.corner("#assist-take")
    place = (left + width / 2, top + height / 2)
    visitor.mouse("mouseMoved", *place)
    visitor.click(*place)
    visitor.wait(HELD)
    visitor.wait("document.querySelector('#assist-connection').dataset.state === 'open'")
    return place


def wander(visitor: Visitor, place: tuple[float, float], way: tuple[float, float]) -> tuple[float, float]:
    """Move the mouse by so many px, which are counts while it is lent."""
    end = (place[0] + way[0], place[1] + way[1])
    visitor.reach(place, end, 0.3)
    return end


def test_lent_movement_moves_the_cursor_of_the_service(visitor: Visitor) -> None:
    assert visitor.value("document.querySelector('#assist-connection').textContent") == "Not connected."
    visitor.value("document.querySelector('[name=strength]').value = 0")
    place = lend(visitor)
    before = visitor.wait(f"{CURSOR}.every(Number.isFinite) && {CURSOR}")
    wander(visitor, place, (-100.0, 40.0))
    visitor.wait(f"{LAST} && {LAST}.x < {before[0]} - 40")
    visitor.wait(f"{CURSOR}[0] === {LAST}.x && {CURSOR}[1] === {LAST}.y")
    x, y = visitor.value(CURSOR)
    px = 6.0 * 96.0 / 1000.0  # the gain of the form, 96 px and 1000 counts an inch
    assert x - before[0] == pytest.approx(-100.0 * px, abs=4.0)
    assert y - before[1] == pytest.approx(40.0 * px, abs=4.0)
    print(visitor.text("#assist-said"))
