"""The page with a device attached to the service: what it does is drawn, what is lost is told."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from pointpred import PointerEvent
from pointpred.live.follow import silence
from pointpred.protocol.server_messages import Curve
from pointpred.transfer import ConstantGain, PixelTransfer, TransferLearner
from tests.devices.live_fakes import reach
from tests.server import browser, page_browser
from tests.server.live_attached import Attachment, attached, followed, play
from tests.server.page_browser import Visitor, until
from tests.server.running import Running, running
from tests.server.test_page import LIGHT, pixels

pytestmark = browser.needed

SEEN = """
window.seen = { phase: [], left: [] };
for (const of in seen) {
  const shown = document.querySelector(`#live-device [data-of=${of}]`);
  new MutationObserver(() => seen[of].push(shown.textContent)).observe(shown, { childList: true });
}
"""
DRAWN = "Number(document.querySelector('#device-scene').dataset.drawn ?? 0)"
EVENTS = "Number(document.querySelector('#device-scene').dataset.events ?? 0)"
STATE = "document.querySelector('#device-status').dataset.state"


@pytest.fixture(scope="module")
def service() -> Iterator[tuple[Running, Attachment]]:
    with attached() as (here, made), followed(made):
        yield here, made


@pytest.fixture
def visitor(one: Visitor, service: tuple[Running, Attachment]) -> Iterator[Visitor]:
    """Somebody who looks at the attached device; nothing is complained of, and nothing moves by itself."""
    one.prefer(color_scheme="light")
    one.resize(1280, 720)
    one.open(f"{service[0].url}#live")
    one.wait(f"{STATE} === 'attached'")
    one.wait("document.querySelector('#live-card-0 .connection').dataset.state === 'open'")
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001


def to_the_device(visitor: Visitor) -> None:
    visitor.value("document.querySelector('#live-device').scrollIntoView()")


def test_its_movements_and_predictions_are_drawn(
    visitor: Visitor, service: tuple[Running, Attachment]
) -> None:
    _, made = service
    assert visitor.text("#device-name") == "a made-up mouse"
    assert "motor space" in visitor.text("#device-description")
    assert "800 counts per inch" in visitor.text("#device-description")
    to_the_device(visitor)
    visitor.value(SEEN)
    visitor.gather_colours("#device-scene")

    def drawn() -> bool:
        play(made, (2500.0, -900.0))
        seen = {LIGHT["past"], LIGHT["endpoint"]} <= visitor.colours()
        return seen and "ballistic" in visitor.value("seen.phase")

    # a loaded machine may look when all is over, or draw no frame while the speed is high
    until(drawn, "the trail, a predicted endpoint and its phase")
    assert visitor.value(DRAWN) > 0
    visitor.wait("seen.phase.at(-1) === '–'")
    shown, before = visitor.value(EVENTS), made.session.reports
    play(made, (250.0, -90.0), 0.1)  # so few that none gives way to newer ones
    until(lambda: made.session.reports - before > 100, "the session to take its reports")
    until(lambda: visitor.value(EVENTS) - shown >= made.session.reports - before, "every event to arrive")
    reports = "#live-device [data-of=reports]"
    until(lambda: visitor.text(reports) == str(made.session.reports), "the page to count every report")
    assert visitor.text("#live-device [data-of=delay]").endswith(" ms")


def test_losses_and_an_unplugged_device_are_told(
    visitor: Visitor, service: tuple[Running, Attachment]
) -> None:
    mouse = service[1].mouse
    losses = "document.querySelector('#live-device [data-of=losses]')"
    visitor.wait(f"{losses}.textContent === 'none'")
    mouse.unreadable, mouse.plugged = 3, False
    try:
        visitor.wait(f"{losses}.title === '3 unreadable'")
        visitor.wait(f"{STATE} === 'unplugged'")
    finally:
        mouse.unreadable, mouse.plugged = 0, True
    visitor.wait(f"{STATE} === 'attached'")


def test_silence_is_told(visitor: Visitor, service: tuple[Running, Attachment]) -> None:
    session, said = service[1].session, service[1].session.note
    session.note = lambda: silence(session.source)
    to_the_device(visitor)
    try:
        status = "document.querySelector('#device-status').textContent"
        visitor.wait(f"{status}.includes('/dev/nowhere')")
        fits = "document.documentElement.scrollWidth <= document.documentElement.clientWidth"
        assert visitor.value(fits)
    finally:
        session.note = said
    visitor.wait(f"{STATE} === 'attached'")


def test_another_view_lets_it_go_and_coming_back_finds_it(
    visitor: Visitor, service: tuple[Running, Attachment]
) -> None:
    viewers = service[1].feed._viewers
    for _ in range(3):
        visitor.value("document.getElementById('tab-replay').click()")
        until(lambda: not viewers, "nobody to look on")
        visitor.value("document.getElementById('tab-live').click()")
        visitor.value("new Promise((done) => setTimeout(done, 1))")  # a socket may be on its way
    until(lambda: len(viewers) == 1, "somebody to look on")
    before = visitor.value(EVENTS)

    def followed_again() -> bool:  # the one who looks on may have been a connection that was about to end
        play(service[1], (300.0, 100.0), 0.1)
        return bool(visitor.value(EVENTS) > before)

    until(followed_again, "its movement to be shown again")
    until(lambda: len(viewers) == 1, "one viewer, however often the view was opened")


def test_keys_lead_to_it(visitor: Visitor) -> None:
    for _ in range(8):
        visitor.press("Tab")
        if visitor.value("document.activeElement.id") == "device-link":
            break
    assert visitor.value("document.activeElement.id") == "device-link"
    assert visitor.value("getComputedStyle(document.activeElement).outlineStyle") == "solid"
    visitor.value("document.activeElement.click()")
    assert visitor.value("document.activeElement.id") == "live-device-title"
    top = "document.querySelector('#live-device-title').getBoundingClientRect().top"
    visitor.wait(f"{top} >= 0 && {top} < 720")


@pytest.mark.parametrize("size", [(1280, 720), (390, 844)])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_nothing_is_wider_than_the_window_or_covers_anything(
    visitor: Visitor, size: tuple[int, int], theme: str
) -> None:
    visitor.prefer(color_scheme=theme)
    visitor.resize(*size)
    to_the_device(visitor)
    assert visitor.value("document.documentElement.scrollWidth <= document.documentElement.clientWidth")
    parts = [
        "#device-status",
        "#device-view .picture",
        "#device-view .side",
        "#device-gain",
        "#device-gain-summary",
    ]
    found = f"{json.dumps(parts)}.map((part) => document.querySelector(part).getBoundingClientRect())"
    boxes = visitor.value(f"{found}.map(({{ x, y, width, height }}) => [x, y, width, height])")  # all at once
    for i, (left, top, width, height) in enumerate(boxes):
        for x, y, wide, high in boxes[i + 1 :]:
            apart = x >= left + width or left >= x + wide or y >= top + height or top >= y + high
            assert apart, (parts[i], size)


def learnt() -> TransferLearner:
    """What a constant gain of 4 teaches."""
    learner, moved = TransferLearner(cpi=1000.0, dpi=96.0), PixelTransfer(ConstantGain(4.0), cpi=1000.0)
    x = y = 0.0
    for k, length in enumerate(np.linspace(300.0, 6000.0, 24)):
        for report in reach(2.0 * k, (length * (-1) ** k, 0.5 * length), 0.7):
            dx, dy = moved.update((report.t, report.dx, report.dy))
            x, y = x + dx, y + dy
            learner.update(PointerEvent(report.t, x, y, report.dx, report.dy))
    return learner


def test_the_gain_curve_is_drawn_with_the_speeds_that_were_shown(
    visitor: Visitor, service: tuple[Running, Attachment]
) -> None:
    curve = learnt().curve()
    assert curve.excited is not None
    visitor.value("document.querySelector('#device-gain').scrollIntoView()")
    before = pixels(visitor, "#device-gain")
    assert LIGHT["endpoint"] not in before
    service[1].feed.curve = Curve(curve.words, curve)
    visitor.wait("document.querySelector('#device-gain').dataset.points === '41'")
    low, high = curve.excited
    said = visitor.text("#device-gain-summary")
    assert said.startswith(f"Identified between {low:.3f} and {high:.3f} m/s of the hand")
    assert said.endswith("Closest: constant.")
    until(lambda: pixels(visitor, "#device-gain") - before > {LIGHT["endpoint"]}, "the curve to be drawn")


def test_where_nothing_is_learnt_the_reason_stands(
    visitor: Visitor, service: tuple[Running, Attachment]
) -> None:
    service[1].feed.curve = Curve("a transfer function is learnt from counts and the screen's cursor")
    shown = "document.querySelector('#device-gain-summary').textContent"
    visitor.wait(f"{shown} === 'A transfer function is learnt from counts and the screen\\'s cursor.'")


def test_the_picture_follows_a_device_that_no_window_bounds(visitor: Visitor) -> None:
    rng = np.random.default_rng(5)
    walks = np.cumsum(rng.normal(0.0, 120.0, (300, 2)), axis=0)
    windows = [walks[max(0, i - 20) : i + 1].tolist() for i in range(len(walks))]
    code = f"""import('/web/page/device/camera.js').then(({{ Camera }}) => {{
      const camera = new Camera();
      return {json.dumps(windows)}.map((points) => {{
        camera.follow(points, 800, 400);
        return [camera.scale, ...points.map((point) => camera.place(point))];
      }});
    }})"""
    scales = []
    for scale, *places in visitor.value(code):
        scales.append(scale)
        assert all(0 <= x <= 800 and 0 <= y <= 400 for x, y in places)
    assert max(scales) <= 1.0
    changes = np.count_nonzero(np.diff(scales))
    assert 0 < changes < 60


def test_without_a_device_the_page_says_how_to_attach_one(one: Visitor) -> None:
    with running() as here:
        one.open(here.url)
        one.wait(f"{STATE} === 'none'")
        assert "pointpred live --serve" in one.text("#device-status")
        assert one.value("getComputedStyle(document.querySelector('#device-link')).visibility") == "hidden"
        assert one.value("document.querySelector('#device-view').hidden")
        assert one.complaints() == []
        assert one.shift() < 0.001


def test_a_lost_service_is_shown_and_tried_again(tmp_path: Path) -> None:
    with page_browser.visitor(tmp_path) as visitor:
        with attached() as (here, _):
            visitor.open(here.url)
            visitor.wait(f"{STATE} === 'attached'")
        until(lambda: visitor.value(STATE) == "waiting", "the loss to be shown")
