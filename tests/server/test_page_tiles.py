"""Tiles of the live view: what the page tells the service of them, how they light up, what is counted."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import pytest

from tests.server import browser, page_browser
from tests.server.page_browser import Visitor, until
from tests.server.test_page_choices import HEARD, ORANGE

pytestmark = browser.needed

PAINT = """new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const canvas = document.querySelector("#live-scene");
  const copy = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, -PLACE_X, -PLACE_Y);
  done([...copy.getImageData(0, 0, 1, 1).data]);
})))"""


@pytest.fixture
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.service() as url, page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.call("Page.addScriptToEvaluateOnNewDocument", source=HEARD)
        opened.prefer(prefers_color_scheme="light")
        opened.open(f"{url}#live")
        opened.wait("document.querySelector('#live-card-0 .connection').dataset.state === 'open'")
        opened.wait('answered.includes(\'{"type":"targets","count":5}\')')
        opened.choose("#live-predictor-0", "switched")  # it draws no region over the tiles
        yield opened
        assert opened.complaints() == []
        assert opened.shift() < 0.001


ANSWERED = """new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))).then(() => {
  const newest = (list, kind) => JSON.parse(list.findLast((one) => one.includes(`"${kind}"`)) ?? null);
  const sent = newest(told, "events");
  return sent !== null && newest(answered, "prediction")?.t === sent.events.at(-1)[0];
})"""


def tiles(visitor: Visitor) -> list[dict[str, Any]]:
    told = visitor.value("told.findLast((one) => typeof one === 'string' && one.includes('\"targets\"'))")
    found: list[dict[str, Any]] = json.loads(told)["targets"]
    return found


def tint(visitor: Visitor, tile: dict[str, Any]) -> tuple[list[int], float]:
    """Colour and opacity in a corner of a tile."""
    x, y = (str(round(tile[axis] + 10)) for axis in "xy")
    *colour, opacity = visitor.value(PAINT.replace("PLACE_X", x).replace("PLACE_Y", y))
    return colour, opacity / 255


SETTLED = """(async () => {
  const named = (list, kind) => JSON.parse(list.findLast((one) => one.includes(`"${kind}"`)) ?? null);
  const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const scene = document.querySelector("#live-scene");
  await frames();
  const { t, targets } = named(answered, "prediction") ?? {}, drawn = scene.dataset.drawn;
  await frames();
  const shares = Object.fromEntries((targets ?? []).map(({ id, p }) => [id, p]));
  const copy = new OffscreenCanvas(scene.width, scene.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(scene, 0, 0);
  const tints = named(told, "targets").targets.map(({ id, x, y }) =>
    [id, copy.getImageData(Math.round(x + 10), Math.round(y + 10), 1, 1).data[3] / 255]);
  const newest = t === named(told, "events")?.events.at(-1)[0];
  const still = scene.dataset.shows === "pointer" && scene.dataset.drawn === drawn;
  return newest && still ? { shares, tints: Object.fromEntries(tints) } : null;
})()"""
"""Shares and tints, once the newest event is answered, while no endpoint covers a tile."""
SHOWS = "document.querySelector('#live-scene').dataset.shows"


def test_tiles_are_lit_as_strongly_as_the_service_says_that_they_are_likely(visitor: Visitor) -> None:
    left, top, width, height = visitor.corner("#live-scene")
    start, end = (left + 60, top + 60), (left + width / 2, top + height / 2)
    visitor.mouse("mouseMoved", *start)

    def settled() -> dict[str, Any] | None:
        if visitor.value(SHOWS) != "pointer":  # at first, and four seconds after the last movement
            visitor.reach(start, end, 0.4)
        found: dict[str, Any] | None = visitor.value(SETTLED)
        return found if found and len(found["shares"]) == 5 else None

    found = until(settled, "shares of every tile")
    assert found["shares"].keys() == {tile["id"] for tile in tiles(visitor)}
    assert found["tints"] == pytest.approx(found["shares"], abs=0.02)


def test_a_proposed_tile_is_framed_and_what_came_of_it_is_counted(visitor: Visitor) -> None:
    left, top, *_ = visitor.corner("#live-scene")
    one, two = tiles(visitor)[0], tiles(visitor)[4]
    for tile, action in ((two, "propose"), (two, "retract"), (one, "propose")):
        visitor.value(f"say({{ type: 'choice', id: '{tile['id']}', p: 0.75, action: '{action}', t: 0 }})")

    likely = {"type": "prediction", "t": 0, "x": None, "y": None, "targets": [{"id": one["id"], "p": 0.75}]}

    def framed() -> tuple[list[int], float] | None:
        if visitor.value(SHOWS) != "pointer":  # at first, and four seconds after the last movement
            visitor.mouse("mouseMoved", left + 200, top + 100)
            visitor.mouse("mouseMoved", left + 201, top + 100)
            visitor.wait(ANSWERED)
        visitor.value(f"say({json.dumps(likely)})")
        found = tint(visitor, one)
        shown = visitor.value(f"[{SHOWS}, document.querySelector('#live-scene').dataset.ahead]")
        return found if shown == ["pointer", one["id"]] else None

    colour, opacity = until(framed, "the picture with the proposed tile")
    assert opacity == pytest.approx(0.75, abs=0.02)
    assert colour == pytest.approx(ORANGE, abs=3)
    place = (left + one["x"] + one["width"] / 2, top + one["y"] + one["height"] / 2)
    visitor.mouse("mouseMoved", *place)
    visitor.click(*place)
    visitor.value(f"say({json.dumps(likely)})")

    def untinted() -> bool:
        if visitor.value(SHOWS) != "pointer":
            visitor.mouse("mouseMoved", place[0] - 3, place[1])
            visitor.click(*place)
        opacity = tint(visitor, one)[1]
        return bool(opacity == 0 and visitor.value(SHOWS) == "pointer")

    until(untinted, "nothing is tinted while the pointer rests where the movement ended")
    counted = "document.querySelector('#live-ledger').textContent"
    visitor.wait(f"{counted}.startsWith('Proposed in time: 1 of 1 movement, ')")
    assert visitor.value(counted).endswith(" ms early; 1 of 2 proposals wrong.")
