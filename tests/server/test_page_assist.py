"""The assist view in a real browser: the mouse is lent, the service moves the cursor, Escape ends it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

HEARD = """
window.told = []; window.answered = []; window.sentAt = null;
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  set onmessage(listen) {
    super.onmessage = (event) => {
      if (typeof event.data === "string") answered.push(JSON.parse(event.data));
      listen(event);
    };
  }
  send(data) {
    if (typeof data === "string") told.push(JSON.parse(data));
    else window.sentAt = new DataView(data).getFloat64(data.byteLength - 30, true);
    super.send(data);
  }
};
"""
"""Keeps what the page tells the service and hears, and the time of the newest event."""
STATE = "document.querySelector('#assist-status').dataset.state"
COUNTS = "document.querySelector('#assist-scene').dataset.counts"
CAPTURED = "document.pointerLockElement?.id === 'assist-scene'"
CURSOR = "['x', 'y'].map((of) => Number(document.querySelector('#assist-scene').dataset[of]))"
TARGET = "document.querySelector('#assist-scene').dataset.target.split(',').map(Number)"
ROWS = "[...document.querySelectorAll('#assist-results tbody tr')]"
DONE = f"{ROWS}.map((row) => +row.cells[1].textContent)"
LAST = "answered.findLast(({ type }) => type === 'cursor')"
FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
SHOWN = f"{CURSOR}[0] === {LAST}.x && {CURSOR}[1] === {LAST}.y"
ANSWERED = f"{FRAMES}.then(() => {LAST}?.t === sentAt && {SHOWN})"
"""Whether the page has seen the mouse, and shows where the newest event has brought the cursor."""


@pytest.fixture(scope="module")
def one(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.add_init_script(HEARD)
        yield opened


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody who has opened the view; nothing complains, nothing shifts."""
    one.open(f"{url}?by=service#assist")
    one.wait("!document.querySelector('#assist-capture').disabled")
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001


def capture(visitor: Visitor) -> tuple[float, float]:
    """Click the button; where the mouse is then."""
    left, top, width, height = visitor.corner("#assist-capture")
    place = (left + width / 2, top + height / 2)
    visitor.mouse("mouseMoved", *place)
    visitor.click(*place)
    visitor.wait(CAPTURED)
    visitor.wait("document.querySelector('#assist-connection').dataset.state === 'open'")
    return place


def move_by(visitor: Visitor, place: tuple[float, float], way: tuple[float, float]) -> tuple[float, float]:
    """Move the mouse by so many px, which are counts while it is captured."""
    end = (place[0] + way[0], place[1] + way[1])
    visitor.reach(place, end, 0.3)
    return end


def test_captured_movement_moves_the_cursor_of_the_service(visitor: Visitor) -> None:
    assert visitor.value("document.querySelector('#assist-connection').dataset.state ?? null") is None
    visitor.value("document.querySelector('[name=strength]').value = 0")
    place = capture(visitor)
    before = visitor.wait(f"{CURSOR}.every(Number.isFinite) && {CURSOR}")
    move_by(visitor, place, (-100.0, 40.0))
    visitor.wait(ANSWERED)
    x, y = visitor.value(CURSOR)
    px = 6.0 * 96.0 / 1000.0  # the gain of the form, 96 px and 1000 counts an inch
    assert x - before[0] == pytest.approx(-100.0 * px, abs=4.0)
    assert y - before[1] == pytest.approx(40.0 * px, abs=4.0)


def test_escape_releases_the_mouse_and_ends_the_session(visitor: Visitor) -> None:
    place = capture(visitor)
    move_by(visitor, place, (-60.0, 0.0))
    visitor.press("Escape")
    visitor.wait(f"!({CAPTURED})")
    visitor.wait(f"{STATE} === 'released'")
    assert visitor.value("document.querySelector('#assist-connection').dataset.state") == "closed"
    assert visitor.value("told.at(-1).type") == "bye"
    count = visitor.value("told.length")
    move_by(visitor, place, (-60.0, 0.0))
    assert visitor.value("told.length") == count


def point(visitor: Visitor, place: tuple[float, float], done: int) -> tuple[float, float]:
    """Go to the target and click; where the mouse is then. With it, so many are done."""
    for _ in range(40):
        x, y = visitor.value(CURSOR)
        goal = visitor.value(TARGET)
        off = (goal[0] - x, goal[1] - y)
        if max(map(abs, off)) < 8:
            break
        scale = 0.6 / 1.92  # a little less than what is left: help may add half of it
        place = move_by(visitor, place, (off[0] * scale, off[1] * scale))
        visitor.wait(ANSWERED)
    visitor.click(*place)
    visitor.wait(f"{DONE}[0] + {DONE}[1] === {done} && {TARGET}.join() !== '{goal[0]},{goal[1]}'")
    return place


def test_targets_are_clicked_with_help_and_without_it(visitor: Visitor) -> None:
    """Each click asks for the help of the next target; the table tells both kinds apart."""
    visitor.choose("#assist-predictor", "switched-direction")  # it claims no region, so that help never fades
    visitor.value("document.querySelector('#assist-form [name=gain]').value = 20")
    place = capture(visitor)  # a high gain, so that the mouse stays in the window
    for done in range(1, 5):
        place = point(visitor, place, done)
    assert visitor.value(DONE) == [2, 2]
    asked = visitor.value("told.flatMap(({ assist }) => assist ? [assist.strength] : [])")
    assert [sorted(asked[pair : pair + 2]) for pair in (0, 2)] == [[0, 0.5], [0, 0.5]]
    for done in range(5, 11):
        if visitor.value(f"{LAST}.added_px") > 20:
            break
        place = point(visitor, place, done)  # a hand that halts on a busy machine is helped less
    assert visitor.value(f"{LAST}.added_px") > 20


def test_the_keyboard_reaches_everything_and_captures_the_mouse(visitor: Visitor) -> None:
    stops = set()
    for _ in range(12):
        visitor.press("Tab")
        stops.add(visitor.value("document.activeElement.id || document.activeElement.name || ''"))
    wanted = {"tab-assist", "assist-predictor", "cpi", "gain", "strength", "alternate", "assist-capture"}
    assert wanted | {"assist-clear"} <= stops
    visitor.value("document.querySelector('#assist-capture').focus()")
    visitor.page.bring_to_front()
    visitor.press("Enter")
    visitor.wait(CAPTURED)


def test_another_view_releases_the_mouse(visitor: Visitor) -> None:
    capture(visitor)
    visitor.value("location.hash = '#replay'")
    visitor.wait(f"!({CAPTURED})")


def test_wrong_numbers_are_marked_and_nothing_is_captured(visitor: Visitor) -> None:
    visitor.value("document.querySelector('#assist-form [name=cpi]').value = 3")
    visitor.value("document.querySelector('#assist-capture').click()")
    assert visitor.value(STATE) == "invalid"
    assert visitor.value("document.querySelector('#assist-form [aria-invalid=true]').name") == "cpi"
    assert all(word in visitor.text("#assist-status") for word in ("Counts per inch", "50", "50000"))
    assert not visitor.value(CAPTURED)


def test_a_browser_without_pointer_lock_is_named(visitor: Visitor, url: str) -> None:
    without = "delete Element.prototype.requestPointerLock;"
    visitor.hand.call("Page.enable")
    script = visitor.hand.call("Page.addScriptToEvaluateOnNewDocument", source=without)
    visitor.open(f"{url}#assist")
    visitor.hand.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])
    visitor.wait(f"{STATE} === 'unsupported'")
    assert visitor.value("document.querySelector('#assist-capture').disabled")


def test_raw_counts_are_requested_and_their_kind_is_shown(visitor: Visitor) -> None:
    """The browser of the tests has no raw counts; in its place one that says it has."""
    capture(visitor)
    visitor.wait(f"{COUNTS} === 'accelerated'")
    visitor.press("Escape")
    visitor.wait(f"!({CAPTURED})")
    visitor.value("""{ const plain = Element.prototype.requestPointerLock;
      Element.prototype.requestPointerLock = function (options) {
        window.wished = options;
        return plain.call(this);
      }; }""")
    capture(visitor)
    assert visitor.value("wished.unadjustedMovement") is True
    visitor.wait(f"{COUNTS} === 'raw'")


def test_a_service_that_goes_away_releases_the_mouse(tmp_path_factory: pytest.TempPathFactory) -> None:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as visitor:
        with page_browser.service() as address:
            visitor.open(f"{address}?by=service#assist")
            visitor.wait("!document.querySelector('#assist-capture').disabled")
            place = capture(visitor)
            move_by(visitor, place, (-60.0, 0.0))
        visitor.wait(f"{STATE} === 'released'")
        assert not visitor.value(CAPTURED)
