"""The browser client in a real browser, driven through its DevTools; the real session hears it."""

from __future__ import annotations

import json
import math
import re
import time
from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Error, Page

from pointpred.live.devtools import Page as DevTools
from pointpred.live.devtools import drive_mouse
from pointpred.protocol.server_messages import Limits
from pointpred.records import EventColumns
from tests.server import browser
from tests.server.browser import Chromium
from tests.server.listener import Listener, soon

pytestmark = browser.needed

CONNECT = """import("/pointpred.js").then(({ connect }) => {
  window.heard = { prediction: [], state: [], error: [], welcome: [], score: [], targets: [] };
  window.connection = connect(undefined, OPTIONS);
  for (const name in heard) connection.on(name, (message) => heard[name].push(message));
})"""


@pytest.fixture
def listener() -> Iterator[Listener]:
    with Listener(limits=Limits(idle_s=3600.0)) as service:  # targets are not said again to stay
        yield service


def connected(page: Page, options: str = "{}") -> None:
    page.evaluate(CONNECT.replace("OPTIONS", options))
    soon(lambda: page.evaluate("connection.state") == "open", "the connection is open")


SLOW = """addEventListener("pointerrawupdate", () => {
  const end = performance.now() + 20;
  while (performance.now() < end);
})"""
"""The page takes a while over each dispatch: what comes meanwhile is coalesced, however slowly it is sent."""


def path(count: int, press: tuple[int, int] = (0, 0)) -> EventColumns:
    """Positions that all differ, in steps of a quarter of a pixel; the button is held over some rows."""
    i = np.arange(count)
    held = ((i >= press[0]) & (i < press[1])).astype(float)
    return EventColumns.of(i / 1000, 100 + 1.5 * i, 100 + 0.25 * i, buttons=held)


@pytest.mark.parametrize("encoding", ["binary", "json"])
def test_500_coalesced_events_arrive_and_none_is_lost(
    page: Page, hand: DevTools, listener: Listener, encoding: str
) -> None:
    connected(page, f"{{ encoding: '{encoding}' }}")
    page.evaluate(SLOW)
    sent = path(500, press=(200, 300))
    began = time.perf_counter()
    driven = drive_mouse(hand, sent, speed=math.inf)
    assert (driven.moves, driven.presses, driven.releases) == (498, 1, 1)
    soon(lambda: page.evaluate("connection.sent") == 500, "500 events were sent")

    def rows() -> list[list[float]]:
        if encoding == "binary":
            return [[*list(row)[:3], row[5]] for row in listener.events().tolist()]
        return [[*row[:3], row[5]] for m in listener.messages("events") for row in m["events"]]

    soon(lambda: len(rows()) == 500, "500 events were heard")
    heard = np.array(rows())
    assert np.array_equal(heard[:, 1], sent.x)
    assert np.array_equal(heard[:, 2], sent.y)
    assert np.array_equal(heard[:, 3], sent.buttons)
    assert (np.diff(heard[:, 0]) >= 0.0).all()
    messages = len(listener.binary()) or len(listener.messages("events"))
    assert messages < 500, "nothing was coalesced"
    soon(lambda: page.evaluate("heard.prediction.length") == messages, "one prediction a message")
    last = page.evaluate("heard.prediction.at(-1)")
    assert set(last) == {"type", "t", "x", "y", "region", "phase", "remaining_s", "remaining_spread"}
    assert last["t"] == heard[-1, 0]
    assert math.isfinite(last["x"])
    assert last["phase"] in ("still", "ballistic", "corrective")
    assert 0.0 < page.evaluate("connection.delayMs") < 1000.0 * (time.perf_counter() - began)
    assert page.evaluate("[heard.error, connection.dropped]") == [[], 0]


def test_a_dispatch_is_split_where_the_limits_say_so(chromium: Chromium) -> None:
    with (
        Listener(limits=Limits(max_events_per_frame=7)) as listener,
        chromium.tab(listener.url) as page,
    ):
        connected(page)
        page.evaluate("connection.send(Array.from({ length: 20 }, (_, i) => [i, i, 0, null, null, 0]))")
        page.evaluate("connection.send([{ t: 20, x: -1.5, y: 2, dx: -3, dy: 32767, buttons: 5 }])")
        soon(lambda: len(listener.events()) == 21, "21 events")
        assert [len(frame) // 30 for frame in listener.binary()] == [7, 7, 6, 1]
        assert listener.events()[-1].tolist() == (20.0, -1.5, 2.0, -3, 32767, 5)


def test_binary_predictions_are_the_objects_that_json_gives(page: Page) -> None:
    sent = "connection.send(Array.from({ length: 60 }, (_, i) => [i / 60, i * i, i, null, null, 0]))"
    found = []
    for encoding in ("binary", "json"):
        for predictor in ("switched", "minimum-jerk"):
            connected(page, f"{{ reply: 'event', encoding: '{encoding}', predictor: '{predictor}' }}")
            page.evaluate(sent)
            soon(lambda: page.evaluate("heard.prediction.length") == 60, "60 predictions")
            found.append(page.evaluate("heard.prediction"))
            page.evaluate("connection.close()")
    assert found[:2] == found[2:]
    assert any(one["x"] is None for one in found[1])
    assert any(one["x"] is not None for one in found[1])


def test_it_comes_back_when_the_service_does(page: Page, listener: Listener) -> None:
    connected(page, "{ targets: [{ id: 'a', x: 1, y: 2, width: 3, height: 4 }], pointer: false, queue: 5 }")
    page.evaluate("connection.configure({ predictor: 'hold' })")
    soon(lambda: page.evaluate("heard.welcome.length") == 2, "the change was taken")
    listener.stop()
    soon(lambda: page.evaluate("connection.state") == "waiting", "the loss was noticed")
    page.evaluate("connection.send(Array.from({ length: 8 }, (_, i) => [i, i, 0, null, null, 0]))")
    with Listener(listener.port) as again:
        soon(lambda: len(again.events()) == 5, "what waited was sent")
        assert [hello["predictor"] for hello in again.messages("hello")] == ["hold"]
        assert [one["targets"][0]["id"] for one in again.messages("targets")] == ["a"]
        assert again.events()["t"].tolist() == [3.0, 4.0, 5.0, 6.0, 7.0]  # the oldest gave way, counted
        assert page.evaluate("connection.dropped") == 3
        states = page.evaluate("heard.state")
        assert states[:3] == ["open", "waiting", "connecting"]
        assert states[-1] == "open"
        page.evaluate("connection.close()")
        soon(lambda: len(again.messages("bye")) == 1, "bye")


def test_a_refused_hello_waits_for_another(page: Page, listener: Listener) -> None:
    page.evaluate(CONNECT.replace("OPTIONS", "{ predictor: 'swiched' }"))
    soon(lambda: page.evaluate("connection.state") == "refused", "the refusal")
    assert page.evaluate("heard.error.map(({ code }) => code)") == ["unknown_predictor"]
    page.evaluate("connection.configure({ predictor: 'switched' })")
    soon(lambda: page.evaluate("connection.state") == "open", "the second hello")
    page.evaluate("connection.configure({ predictor: 'nobody' })")
    soon(lambda: page.evaluate("heard.error.length") == 2, "the second refusal")
    listener.stop()
    with Listener(listener.port) as again:
        soon(lambda: len(again.messages("hello")) == 1, "the session was resumed")
        assert again.messages("hello")[0]["predictor"] == "switched"


def test_an_observed_element_is_followed(page: Page, hand: DevTools, listener: Listener) -> None:
    page.evaluate("document.body.style.height = '3000px'")
    page.evaluate("box.style = 'position: absolute; left: 40px; top: 50px; width: 60px; height: 70px'")
    connected(page)

    def told() -> object:
        return [tuple(one.values()) for one in listener.messages("targets")[-1]["targets"]]

    def becomes(*wanted: tuple[str, float, float, float, float]) -> None:
        soon(lambda: listener.messages("targets") and told() == list(wanted), f"targets {wanted}")

    assert page.evaluate("connection.observe(box)") == "box"
    becomes(("box", 40, 50, 60, 70))
    page.evaluate("box.style.left = '400px'")
    becomes(("box", 400, 50, 60, 70))
    page.evaluate("box.style.height = '30px'")
    becomes(("box", 400, 50, 60, 30))
    page.evaluate("scrollTo(0, 20)")
    becomes(("box", 400, 30, 60, 30))
    page.evaluate("scrollTo(0, 2000)")
    becomes()  # out of view
    page.evaluate("connection.targets([{ id: 'own', x: 1, y: 2, width: 3, height: 4 }]); scrollTo(0, 0)")
    becomes(("own", 1, 2, 3, 4), ("box", 400, 50, 60, 30))
    before = len(listener.messages("targets"))
    drive_mouse(hand, path(50), speed=math.inf)
    soon(lambda: len(listener.events()) == 50, "50 events")
    page.evaluate("new Promise((done) => setTimeout(done, 600))")
    assert len(listener.messages("targets")) == before  # nothing changed, nothing was said
    page.evaluate("connection.unobserve(box)")
    becomes(("own", 1, 2, 3, 4))


@pytest.mark.parametrize("encoding", ["binary", "json"])
def test_a_prediction_names_the_target_that_is_likeliest(page: Page, encoding: str) -> None:
    boxes = [
        {"id": id, "x": x, "y": 0, "width": 40, "height": 40} for id, x in (("left", -500), ("right", 400))
    ]
    options = f"pointer: false, predictor: 'minimum-jerk', reply: 'event', encoding: '{encoding}'"
    connected(page, f"{{ {options}, targets: {json.dumps(boxes)} }}")
    soon(lambda: page.evaluate("heard.targets.length") == 1, "the targets")
    reach = [[i / 100, 420 * (i / 60) ** 2 * (3 - i / 30), 20, None, None, 0] for i in range(60)]
    page.evaluate(f"connection.send({json.dumps(reach)})")
    soon(lambda: page.evaluate("heard.prediction.length") == 60, "the predictions")
    found = page.evaluate("heard.prediction.map(({ target }) => target)")
    assert (found[0], found[-1], set(found)) == (None, "right", {None, "right"})


def test_a_trial_is_scored(page: Page, listener: Listener) -> None:
    connected(page, "{ pointer: false }")
    page.evaluate("box.style = 'position: absolute; left: 90px; top: 0; width: 20px; height: 30px'")
    page.evaluate("connection.trial('start', box)")
    page.evaluate(
        "connection.send(Array.from({ length: 60 }, (_, i) => [i / 60, i * i / 36, 15, null, null, 0]))"
    )
    page.evaluate("connection.trial('end', null, { block: 2, participant: 'p7' })")
    soon(lambda: page.evaluate("heard.score.length") == 1, "the score")
    assert listener.messages("trial")[1]["conditions"] == {"block": 2, "participant": "p7"}
    assert listener.messages("trial")[0]["target"] == {"x": 100, "y": 15, "width": 20}
    assert page.evaluate("heard.score[0].time_averaged_px") > 0.0


def test_mistakes_are_named(page: Page) -> None:
    connected(page, "{ pointer: false }")
    for call, said in {
        "connection.send([[0, NaN, 0]])": "t, x and y must be finite",
        "connection.send([[0, 0, 0, 40000, 0, 0]])": "counts must be whole numbers within 32767",
        "connection.on('predictions', () => {})": "unknown event predictions; known: prediction",
    }.items():
        with pytest.raises(Error, match=re.escape(said)):
            page.evaluate(call)


def test_a_click_during_a_stall_stays_in_its_place(page: Page, hand: DevTools, listener: Listener) -> None:
    """The browser merges moves from before the click with those from after it, and delivers them first."""
    connected(page)
    sent = path(400, press=(150, 250))
    page.evaluate(
        "setTimeout(() => { const end = performance.now() + 600; while (performance.now() < end); }, 50)"
    )
    drive_mouse(hand, sent)
    soon(lambda: len(listener.events()) == 400, "400 events")
    heard = listener.events()
    assert np.array_equal(heard["x"], sent.x)
    assert np.array_equal(heard["buttons"], sent.buttons)
    assert (np.diff(heard["t"]) >= 0.0).all()
    assert page.evaluate("heard.error") == []


def test_closed_while_it_connects_it_leaves_no_complaint(page: Page, listener: Listener) -> None:
    """A browser warns of a connection that is closed before it is there; so it is closed once it is."""
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    page.evaluate(
        """import("/pointpred.js").then(({ connect }) => {
          for (let i = 0; i < 20; i++) connect().close();
          window.last = connect();
        })"""
    )
    soon(lambda: page.evaluate("window.last?.state") == "open", "a later connection is open")
    assert [one for one in said if "WebSocket" in one] == []
