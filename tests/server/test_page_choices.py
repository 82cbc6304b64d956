"""Targets of the circle that the service proposes: what the page tells it, and how the page shows the answer.

What the service proposes is said in the page in its place.
"""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

HEARD = """
window.told = []; window.answered = []; window.listeners = [];
window.say = (message) => listeners.forEach((listen) => listen({ data: JSON.stringify(message) }));
const Plain = WebSocket;
window.WebSocket = class extends Plain {
  set onmessage(listen) {
    listeners.push(listen);
    super.onmessage = (event) => { answered.push(event.data); listen(event); };
  }
  send(data) { told.push(data); super.send(data); }
};
"""
"""Keeps what the page tells the service and hears, and lets a test say something in its place."""
ORANGE = [194, 65, 12]
RING_PX = 6
PAINT = """new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const canvas = document.querySelector("#circle-scene");
  const named = told.findLast((one) => typeof one === "string" && one.includes('"targets"'));
  const { x, y, width } = JSON.parse(named).targets[TARGET];
  const copy = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, -Math.round(x + width + RING), -Math.round(y + width / 2));
  done([...copy.getImageData(0, 0, 1, 1).data]);
})))""".replace("RING", str(RING_PX))


@pytest.fixture
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    """Somebody who began a run with the prediction shown."""
    with page_browser.service() as url, page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.add_init_script(HEARD)
        opened.prefer(color_scheme="light")
        opened.open(f"{url}?by=service#circle")
        opened.wait("!document.querySelector('#circle-start').disabled")
        opened.value("document.querySelector('[name=shown]').checked = true")
        opened.wait("document.querySelector('#circle-connection').dataset.state === 'open'")
        opened.value("document.querySelector('#circle-start').click()")
        opened.wait('answered.includes(\'{"type":"targets","count":13}\')')  # ends older ones
        yield opened
        assert opened.complaints() == []
        assert opened.shift() < 0.001


def ring(visitor: Visitor, target: int) -> tuple[list[int], float]:
    """Colour and opacity on the ring about a target."""
    *colour, opacity = visitor.value(PAINT.replace("TARGET", str(target)))
    return colour, opacity / 255


def say(visitor: Visitor, target: str, p: float, action: str = "propose") -> None:
    visitor.value(f"say({{ type: 'choice', id: {target!r}, p: {p}, action: {action!r} }})")


def test_a_proposed_target_is_ringed_as_strongly_as_it_is_likely(visitor: Visitor) -> None:
    assert [ring(visitor, target)[1] for target in range(13)] == [0.0] * 13
    for p in (0.25, 0.5, 1.0):
        say(visitor, "3", p)
        colour, opacity = ring(visitor, 3)
        assert opacity == pytest.approx(p, abs=0.01)
        assert colour == pytest.approx(ORANGE, abs=3)
        assert ring(visitor, 4)[1] == 0.0
    say(visitor, "3", 0.0, "retract")
    assert ring(visitor, 3)[1] == 0.0
    say(visitor, "nobody", 1.0)
    say(visitor, "99", 1.0)
    assert [ring(visitor, target)[1] for target in range(13)] == [0.0] * 13


def test_nothing_is_shown_to_who_did_not_ask_for_it_or_is_done(visitor: Visitor) -> None:
    say(visitor, "5", 1.0)
    assert ring(visitor, 5)[1] == 1.0
    visitor.value("document.querySelector('[name=shown]').checked = false")
    assert ring(visitor, 5)[1] == 0.0
    visitor.value("document.querySelector('[name=shown]').checked = true")
    assert ring(visitor, 5)[1] == 1.0
    visitor.value("document.querySelector('#circle-stop').click()")
    assert ring(visitor, 5)[1] == 0.0
    visitor.value("document.querySelector('#circle-start').click()")
    assert ring(visitor, 5)[1] == 0.0
