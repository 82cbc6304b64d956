"""The errors under a replayed movement: one time for slider and plot, numbers that nothing cuts."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import pytest

from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

THUMB_PX = 16.0
"""The browser's own; its middle stands at the time."""
DRAWN = """
window.drawn = { words: [], lines: [] };
const pen = CanvasRenderingContext2D.prototype;
const plain = { fillText: pen.fillText, moveTo: pen.moveTo, lineTo: pen.lineTo, clearRect: pen.clearRect };
const ours = (one) => one.canvas.id === "replay-errors";
pen.clearRect = function (...box) {
  if (ours(this)) window.drawn = { words: [], lines: [] };
  return plain.clearRect.apply(this, box);
};
pen.fillText = function (text, x, y) {
  const { actualBoundingBoxLeft: left, actualBoundingBoxRight: right, actualBoundingBoxAscent: up,
    actualBoundingBoxDescent: down } = this.measureText(text);
  if (ours(this)) drawn.words.push([text, x - left, y - up, x + right, y + down]);
  return plain.fillText.call(this, text, x, y);
};
let from = null;
pen.moveTo = function (x, y) { from = [x, y]; return plain.moveTo.call(this, x, y); };
pen.lineTo = function (x, y) {
  if (ours(this)) drawn.lines.push([...from, x, y]);
  from = [x, y];
  return plain.lineTo.call(this, x, y);
};
"""
"""Keeps the boxes of the words on the plot, and its lines, since it was last cleared."""


@pytest.fixture(scope="module")
def opened(one: Visitor, url: str) -> Visitor:
    one.page.add_init_script(DRAWN)
    one.open(f"{url}#replay")
    one.wait("!document.querySelector('#replay-play').disabled")
    return one


@pytest.fixture(params=[(1440, 900), (1024, 768), (390, 844)], ids=str)
def visitor(opened: Visitor, request: pytest.FixtureRequest) -> Iterator[Visitor]:
    """Somebody at a replay, in windows of several sizes."""
    opened.resize(*request.param)
    width = "document.querySelector('#replay-errors')"
    opened.wait(f"{width}.width === {width}.clientWidth")
    yield opened
    assert opened.complaints() == []


def go(visitor: Visitor, share: float) -> float:
    """Move the slider; returns the share of the time that it then stands at."""
    at: float = visitor.value(
        "{ const slider = document.querySelector('#replay-time');"
        f"slider.value = Math.round({share} * slider.max);"
        "slider.dispatchEvent(new Event('input')); Number(slider.value) / Number(slider.max) }"
    )
    return at


def test_the_slider_stands_above_its_time_in_the_plot(visitor: Visitor) -> None:
    for share in (0.0, 0.25, 0.6, 1.0):
        at = go(visitor, share)
        left, _, width, _ = visitor.corner("#replay-time")
        thumb = left + THUMB_PX / 2 + at * (width - THUMB_PX)
        plot = visitor.corner("#replay-errors")[0]
        now = float(visitor.value("document.querySelector('#replay-errors').dataset.now"))
        assert plot + 1.0 + now == pytest.approx(thumb, abs=1.5)


def test_numbers_are_whole_apart_and_not_struck_by_lines(visitor: Visitor) -> None:
    go(visitor, 0.5)
    drawn: dict[str, Any] = visitor.value("window.drawn")
    width, height = visitor.value(
        "(({ clientWidth: x, clientHeight: y }) => [x, y])(document.querySelector('#replay-errors'))"
    )
    assert len(drawn["words"]) >= 5
    for _, left, top, right, bottom in drawn["words"]:
        assert left >= 0
        assert top >= 0
        assert right <= width
        assert bottom <= height
    for one, other in itertools.combinations(drawn["words"], 2):
        assert one[3] <= other[1] or other[3] <= one[1] or one[4] <= other[2] or other[4] <= one[2]
    for word, left, top, right, bottom in drawn["words"]:
        for x0, y0, x1, y1 in drawn["lines"]:
            beside = max(x0, x1) < left or min(x0, x1) > right
            assert beside or max(y0, y1) < top or min(y0, y1) > bottom, word


def test_the_time_is_named_and_moved_by_keys(visitor: Visitor) -> None:
    go(visitor, 0.5)
    before = visitor.value("document.querySelector('#replay-errors').dataset.now")
    visitor.value("document.querySelector('#replay-time').focus()")
    visitor.press("ArrowRight")
    assert float(visitor.value("document.querySelector('#replay-errors').dataset.now")) > float(before)
    assert visitor.value("document.querySelector('#replay-time').getAttribute('aria-label')") == "Time"
