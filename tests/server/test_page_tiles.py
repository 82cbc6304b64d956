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

SCENE = """(async (message) => {
  const scene = document.querySelector("#live-scene");
  const frame = () => new Promise((done) => requestAnimationFrame(done));
  if (message) say(message);
  await frame();
  await frame();
  const { shows, ahead, regions } = scene.dataset;
  const copy = new OffscreenCanvas(scene.width, scene.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(scene, 0, 0);
  const named = told.findLast((one) => typeof one === "string" && one.includes('"targets"'));
  const at = ({ x, y }) => [...copy.getImageData(Math.round(x + 10), Math.round(y + 10), 1, 1).data];
  const colours = Object.fromEntries(JSON.parse(named).targets.map((tile) => [tile.id, at(tile)]));
  return { shows, ahead, opacity: JSON.parse(regions)[0]?.opacity ?? 0, colours };
})(MESSAGE)"""
"""The picture two frames after a message in the service's place: and each tile's colour."""


@pytest.fixture
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.service() as url, page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        opened.page.add_init_script(HEARD)
        opened.prefer(color_scheme="light")
        opened.open(f"{url}?by=service#live")
        opened.wait("document.querySelector('#live-card-0 .connection').dataset.state === 'open'")
        opened.wait('answered.includes(\'{"type":"targets","count":5}\')')
        opened.choose("#live-predictor-0", "switched")  # it draws no region over the tiles
        yield opened
        assert opened.complaints() == []
        assert opened.shift() < 0.001


SETTLED = """new Promise((done) => {
  const newest = (list, kind) => JSON.parse(list.findLast((one) => one.includes(`"${kind}"`)) ?? null);
  const end = performance.now() + 3000;
  const ask = () => {
    const sent = newest(told, "events");
    const answered = sent !== null && newest(window.answered, "prediction")?.t === sent.events.at(-1)[0];
    if (answered || performance.now() > end) done(answered);
    else requestAnimationFrame(ask);
  };
  requestAnimationFrame(ask);
})"""
"""Whether the newest movement is answered; a movement during which the connection broke never is."""


def tiles(visitor: Visitor) -> list[dict[str, Any]]:
    told = visitor.value("told.findLast((one) => typeof one === 'string' && one.includes('\"targets\"'))")
    found: list[dict[str, Any]] = json.loads(told)["targets"]
    return found


def scene(visitor: Visitor, message: dict[str, Any] | None = None) -> dict[str, Any]:
    """The picture of the pointer: it goes to the demonstration four seconds after the last movement."""
    left, top, *_ = visitor.corner("#live-scene")

    def pointer() -> dict[str, Any] | None:
        found: dict[str, Any] = visitor.value(SCENE.replace("MESSAGE", json.dumps(message)))
        if found["shows"] == "pointer":
            return found
        visitor.mouse("mouseMoved", left + 200, top + 100)
        visitor.mouse("mouseMoved", left + 201, top + 100)
        visitor.value(SETTLED)
        return None

    return until(pointer, "the picture of the pointer")


def test_tiles_are_lit_as_strongly_as_they_are_likely_and_not_at_rest(visitor: Visitor) -> None:
    shares = {tile["id"]: round(0.1 + 0.15 * i, 2) for i, tile in enumerate(tiles(visitor))}
    likely = [{"id": id, "p": p} for id, p in shares.items()]
    said = {"type": "prediction", "t": 0, "x": 300.0, "y": 40.0, "phase": "ballistic", "targets": likely}

    def tints(found: dict[str, Any]) -> dict[str, float]:
        return {id: colour[3] / 255 for id, colour in found["colours"].items()}

    def drawn() -> dict[str, Any] | None:
        found = scene(visitor, said)
        return found if found["opacity"] == 1 else None  # a slow machine may already let it fade

    assert tints(until(drawn, "a prediction that is drawn")) == pytest.approx(shares, abs=0.02)
    until(lambda: set(tints(scene(visitor)).values()) == {0.0}, "no tint without answers")
    until(drawn, "another one")
    assert set(tints(scene(visitor, {**said, "phase": "still"})).values()) == {0.0}


def test_a_proposed_tile_is_framed_and_what_came_of_it_is_counted(visitor: Visitor) -> None:
    left, top, *_ = visitor.corner("#live-scene")
    one, two = tiles(visitor)[0], tiles(visitor)[4]
    for tile, action in ((two, "propose"), (two, "retract"), (one, "propose")):
        visitor.value(f"say({{ type: 'choice', id: '{tile['id']}', p: 0.75, action: '{action}', t: 0 }})")
    likely = {"type": "prediction", "t": 0, "x": 300.0, "y": 40.0, "phase": "ballistic"}
    likely["targets"] = [{"id": one["id"], "p": 0.75}]

    def framed() -> list[int] | None:
        found = scene(visitor, likely)
        return found["colours"][one["id"]] if found["opacity"] == 1 and found["ahead"] == one["id"] else None

    *colour, opacity = until(framed, "the picture with the proposed tile")
    assert opacity / 255 == pytest.approx(0.75, abs=0.02)
    assert colour == pytest.approx(ORANGE, abs=3)
    place = (left + one["x"] + one["width"] / 2, top + one["y"] + one["height"] / 2)
    visitor.mouse("mouseMoved", *place)
    visitor.click(*place)

    def untinted() -> bool:
        found: dict[str, Any] = visitor.value(SCENE.replace("MESSAGE", json.dumps(likely)))
        if found["shows"] != "pointer":
            visitor.mouse("mouseMoved", place[0] - 3, place[1])
            visitor.click(*place)
        return found["shows"] == "pointer" and found["opacity"] == 1 and found["colours"][one["id"]][3] == 0

    until(untinted, "nothing is tinted while the pointer rests where the movement ended")
    counted = "document.querySelector('#live-ledger').textContent"
    visitor.wait(f"{counted}.startsWith('Proposed in time: 1 of 1 movement, ')")
    assert visitor.value(counted).endswith(" ms early; 1 of 2 proposals wrong.")
