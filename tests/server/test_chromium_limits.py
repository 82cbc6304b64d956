"""The browser client within the limits: bytes of targets, events a second, what waits meanwhile."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
from playwright.sync_api import Page

from pointpred.protocol.server_messages import Limits
from tests.server import browser
from tests.server.listener import Listener, soon
from tests.server.test_chromium_client import CONNECT, connected

pytestmark = browser.needed

ROWS = "Array.from({{ length: {} }}, (_, i) => [i / 1000, i, 0, null, null, 0])"
MOST_PER_S = 2000


@pytest.fixture
def listener() -> Iterator[Listener]:
    limits = Limits(
        max_events_per_s=MOST_PER_S, max_targets=1000, idle_s=3600.0
    )  # targets are not said again to stay
    with Listener(limits=limits) as service:
        yield service


@pytest.mark.parametrize("letter", ["a", "ä", "\N{GRINNING FACE}"])
def test_targets_that_exceed_a_frame_are_cut_by_their_bytes(
    page: Page, listener: Listener, letter: str
) -> None:
    connected(page, "{ pointer: false }")
    page.evaluate(
        "window.given = Array.from({ length: 1000 }, (_, i) => ({ id: `" + letter * 3 + "${i}`,"
        "x: 1000 + i / 64, y: 700 + i / 3, width: 90 + 1 / 64, height: 1e-4 }));"
        "connection.targets(given)"
    )
    soon(lambda: page.evaluate("heard.targets.length") == 1, "the service took the targets")
    [text] = [frame for frame in listener.frames if isinstance(frame, str) and '"targets"' in frame]
    told = json.loads(text)["targets"]
    size = len(text.encode())
    assert size <= listener.limits.max_frame_bytes < size + 120, "as many as there is room for"
    assert [one["id"] for one in told] == [f"{letter * 3}{i}" for i in range(len(told))]
    assert all(abs(one["y"] - (700 + i / 3)) <= 1 / 128 for i, one in enumerate(told))
    assert all(64 * value % 1 == 0 for one in told for value in (one["x"], one["y"], one["width"]))
    assert {one["height"] for one in told} == {1 / 64}
    [error] = page.evaluate("heard.error")
    assert (error["code"], error["path"]) == ("too_many", "$.targets")
    assert error["message"].startswith(f"{1000 - len(told)} targets ")
    page.evaluate("connection.targets(given.map((one) => ({ ...one, x: one.x + 1 })))")
    soon(lambda: page.evaluate("heard.targets.length") == 2, "they moved")
    assert page.evaluate("heard.error.length") == 1, "nothing is said twice"
    assert page.evaluate("heard.state") == ["open"]


def test_after_a_loss_no_more_is_sent_at_once_than_the_service_takes_in_a_second(
    page: Page, listener: Listener
) -> None:
    connected(page, "{ pointer: false }")
    listener.stop()
    soon(lambda: page.evaluate("connection.state") == "waiting", "the loss was noticed")
    page.evaluate(f"connection.send({ROWS.format(5000)})")
    with Listener(listener.port, Limits(max_events_per_s=MOST_PER_S)) as again:
        soon(lambda: page.evaluate("connection.state") == "open", "the service is back")
        page.evaluate("connection.send([[9, 0, 0], [9, 1, 0], [9, 2, 0], [9, 3, 0]])")
        soon(lambda: len(again.events()) and again.events()["t"][-1] == 9.0, "the newest events")
        sent, dropped = page.evaluate("[connection.sent, connection.dropped]")
        assert MOST_PER_S / 2 <= sent <= MOST_PER_S
        assert sent == len(again.events())
        assert sent + dropped == 5004
        assert again.events()["t"][-5] == 4.999, "the oldest gave way"
        assert page.evaluate("heard.error") == []


def test_any_number_of_events_may_wait(page: Page, listener: Listener) -> None:
    page.evaluate("import('/pointpred.js')")
    listener.stop()
    page.evaluate(CONNECT.replace("OPTIONS", "{ pointer: false, queue: 10 }"))
    page.evaluate(f"connection.send({ROWS.format(300_000)})")
    assert page.evaluate("connection.dropped") == 299_990
    page.evaluate("connection.close()")


def test_what_is_sent_while_the_connection_ends_is_kept(page: Page, listener: Listener) -> None:
    """The browser takes events for a closing socket, and lets them fall."""
    page.evaluate(
        "const Plain = WebSocket; window.WebSocket ="
        "class extends Plain { constructor(...given) { super(...given); window.socket = this; } }; 0"
    )
    connected(page, "{ pointer: false }")
    said = f"socket.close(); connection.send({ROWS.format(7)}); connection.trial('start');"
    assert page.evaluate(f"{said} [connection.state, connection.sent]") == ["open", 0]
    soon(lambda: len(listener.messages("hello")) == 2, "it came back")
    soon(lambda: len(listener.events()) == 7, "what was kept is sent")
    soon(lambda: len(listener.messages("trial")) == 1, "in its order")
    assert page.evaluate("[connection.sent, connection.dropped]") == [7, 0]


def test_what_waits_in_the_browser_is_bounded(page: Page, listener: Listener) -> None:
    page.evaluate(
        "const Plain = WebSocket; window.WebSocket = class extends Plain {"
        "get bufferedAmount() { return window.stuck ? 2 ** 24 : super.bufferedAmount; } }; 0"
    )
    connected(page, "{ pointer: false }")
    page.evaluate(f"window.stuck = true; connection.send({ROWS.format(7)})")
    assert page.evaluate("[connection.sent, connection.dropped]") == [0, 7]
    page.evaluate("window.stuck = false; connection.send([[5, 1, 1]])")
    soon(lambda: len(listener.events()) == 1, "it goes on")
    assert page.evaluate("[connection.sent, connection.dropped]") == [1, 7]
