"""Cards, links in a paragraph and a menu on a page of another site, with recorded movements as its mouse."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Iterator
from itertools import pairwise, product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page

from pointpred import RECOMMENDED, EventColumns, build
from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.recordings import read
from pointpred.records import FloatArray
from pointpred.targets import Chooser, Target
from tests.server import browser
from tests.server.browser import Chromium, move_at
from tests.server.listener import soon
from tests.server.running import Running, running
from tests.server.test_chromium_elsewhere import page_elsewhere

pytestmark = browser.needed

FOLDER = os.environ.get("POINTPRED_RECORDINGS")
RECORDED = pytest.mark.skipif(FOLDER is None, reason="POINTPRED_RECORDINGS names no folder")
MOVEMENTS = 3
LEAST_GAP_S = 0.008
WIDTH, HEIGHT = 1200, 600
"""Where the mouse stays, px: inside the window of the tests' browser."""

WORDS = "Somebody who moves a mouse towards one of these words has mostly decided before it gets there. "


def box(name: str, left: int, top: int, width: int, height: int) -> str:
    where = f"position:absolute;left:{left}px;top:{top}px;width:{width}px;height:{height}px"
    return f'<div id="{name}" class="target" style="{where}"></div>'


LAYOUTS = {
    "cards": "".join(
        box(f"card-{x}-{y}", x, y, 200, 142) for y, x in product((140, 306), (180, 404, 628, 852))
    ),
    "links": '<p style="position:absolute;left:280px;top:160px;width:640px;font:16px/26px monospace">'
    + "".join(
        f'{WORDS[: 40 + 17 * (i % 3)]}<span id="link-{i}" class="target">a link here</span> '
        for i in range(10)
    )
    + "</p>",
    "menu": "".join(box(f"row-{i}", 520, 60 + 24 * i, 180, 24) for i in range(20)),
}
CONNECT = """import("{url}/pointpred.js").then(({{ connect }}) => {{
  window.heard = {{ choice: [], error: [], targets: [] }};
  window.rows = [];
  for (const name of ["pointerrawupdate", "pointerdown", "pointerup"])
    addEventListener(name, ({{ timeStamp, clientX, clientY, buttons }}) =>
      rows.push([timeStamp / 1000, clientX, clientY, buttons]));
  window.over = [];
  addEventListener("pointerover", ({{ timeStamp, target }}) => over.push([timeStamp / 1000, target.id]));
  window.connection = connect();
  for (const name in heard)
    connection.on(name, ({{ id, action, reason, t, count, message, element }}) =>
      heard[name].push({{ id, action, reason, t, count, message, named: element?.id }}));
  for (const one of document.querySelectorAll(".target")) connection.observe(one);
}})"""
RECTANGLES = """[...document.querySelectorAll(".target")].map((one) => {
  const { x, y, width, height } = one.getBoundingClientRect();
  return [one.id, x, y, width, height];
})"""


@pytest.fixture(scope="module")
def site() -> Iterator[str]:
    with page_elsewhere() as origin:
        yield origin


@pytest.fixture(scope="module")
def service(site: str) -> Iterator[Running]:
    with running(allow_origin=(site,)) as here:
        yield here


def people() -> Recording:
    assert FOLDER is not None
    return read(Path(FOLDER) / "humanmovemouse_samples.parquet")


def placed(recording: Recording, targets: list[Target]) -> Iterator[tuple[str, FloatArray]]:
    """Movements moved so that each ends in one of the targets, drawn with a seed, and stays on the page."""
    generator, made = np.random.default_rng(12), 0
    for k in generator.permutation(len(recording.trials)).tolist():
        events = thinned(recording.rows(k).table[:, :3])
        for goal in generator.permutation(len(targets)).tolist():
            one = targets[goal]
            share = generator.uniform(0.2, 0.8, 2)
            end = one.x + one.width * share[0], one.y + one.height * share[1]
            way = events[:, 1:3] + np.round(end - events[-1, 1:3])
            inside = abs(way[0] - (one.x + one.width / 2, one.y + one.height / 2)) <= (
                one.width / 2,
                one.height / 2,
            )
            on_page = (way > 2.0).all() and (way < (WIDTH, HEIGHT)).all()
            if on_page and not inside.all() and np.hypot(*(way[-1] - way[0])) > 120.0:
                yield str(one.id), np.column_stack([events[:, 0] - events[0, 0], way])
                made += 1
                break
        if made == MOVEMENTS:
            return


def thinned(rows: FloatArray) -> FloatArray:
    """A mouse of at most 125 Hz: each event waits for the browser."""
    kept = [0]
    for i, t in enumerate(rows[:, 0].tolist()):
        if t - rows[kept[-1], 0] >= LEAST_GAP_S or i == len(rows) - 1:
            kept.append(i)
    return rows[kept]


def moved(page: Page, way: FloatArray, began: float) -> float:
    """Move and click the page's mouse at the recorded times, one event a sample on any machine.

    Begins at a time in s, and returns when the next movement may begin.
    """
    protocol = page.context.new_cdp_session(page)
    for t, x, y in way.tolist():
        move_at(protocol, x, y, began + t)
    click: dict[str, Any] = {"x": x, "y": y, "button": "left", "clickCount": 1}
    for kind, later_s, buttons in (("mousePressed", 0.02, 1), ("mouseReleased", 0.1, 0)):
        about = {"type": kind, "timestamp": began + t + later_s, "buttons": buttons, **click}
        protocol.send("Input.dispatchMouseEvent", about)
    protocol.detach()
    return float(began + t + 1.0)


def decisions(targets: list[Target], events: EventColumns) -> Iterator[dict[str, Any]]:
    """What a chooser decides over the events."""
    pipeline = build(RECOMMENDED, targets=targets)
    chooser = Chooser(pipeline)
    for row in events.table.tolist():
        pipeline.advance(tuple(row))
        for one in chooser.update():
            yield {"id": one.id, "action": one.action, "reason": one.reason, "t": row[0]}


def until_left(decided: list[dict[str, Any]], over: list[tuple[float, str]]) -> list[dict[str, Any]]:
    """What the page hears of decisions: a target that the mouse is in is retracted when the mouse leaves it.

    ``over``: when the mouse came to which element, s.
    """
    heard = []
    for one in decided:
        t = one["t"]
        under = next((name for came, name in reversed(over) if came <= t), None)
        if one["action"] == "retract" and under == one["id"]:
            t = next((came for came, name in over if came > t and name != under), None)
        if t is not None:
            heard.append({**one, "t": t})
    return heard


def by_target(choices: list[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """The choices of each target: the order between targets at one event is that of two sources."""
    return {id: [one for one in choices if one["id"] == id] for id in {one["id"] for one in choices}}


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize(
    "recorded", [sample, pytest.param(people, marks=RECORDED)], ids=["generated", "people"]
)
def test_a_movement_has_its_choice_at_entry_at_the_latest(
    chromium: Chromium, service: Running, site: str, layout: str, recorded: Any
) -> None:
    """The page hears what a batch of its own events decides; each goal was proposed when it was entered."""
    with chromium.tab(site) as page:
        page.evaluate(f"document.body.innerHTML = {LAYOUTS[layout]!r}")
        page.evaluate(CONNECT.format(url=service.url))
        places = [Target(*row) for row in page.evaluate(RECTANGLES)]
        soon(lambda: page.evaluate("heard.targets.at(-1)?.count") == len(places), "all are targets")
        goals, counts, clock = [], [0], time.time()
        for goal, way in placed(recorded(), places):
            clock = moved(page, way, clock)
            page.evaluate("connection.person()")  # all is answered: the mouse rests after the click
            goals.append(goal)
            counts.append(page.evaluate("rows.length"))
        assert len(goals) == MOVEMENTS
        rows = np.array(page.evaluate("rows"))
        events = EventColumns.of(rows[:, 0], rows[:, 1], rows[:, 2], buttons=rows[:, 3])
        on_grid = [Target(p.id, *(round(64 * v) / 64 for v in (p.x, p.y, p.width, p.height))) for p in places]
        decided = list(decisions(on_grid, events))
        wanted = until_left(decided, page.evaluate("over"))
        soon(lambda: len(page.evaluate("heard.choice")) >= len(wanted), "every choice")
        heard = json.loads(page.evaluate("JSON.stringify(heard.choice)"))  # what is not said is left out
        assert page.evaluate("heard.error") == []
        assert all(one.pop("named") == one["id"] for one in heard)
        assert by_target(heard) == by_target(wanted)
        page.evaluate("connection.close()")
    reasons = []
    for goal, (first, stop) in zip(goals, pairwise(counts), strict=True):
        (place,) = (one for one in on_grid if one.id == goal)
        t, x, y = rows[first:stop, :3].T
        inside = (x >= place.x) & (x < place.x + place.width)  # as the browser draws its edges
        inside &= (y >= place.y) & (y < place.y + place.height)
        entered = t[int(np.argmax(inside))]
        stands = None
        for one in heard:
            if one["id"] == goal and (one["t"] < entered or (one["t"] == entered and one["reason"])):
                stands = one["reason"]
        reasons.append(stands)
        assert stands in ("predicted", "entered"), goal
    if layout == "cards":
        assert reasons.count("predicted") >= MOVEMENTS / 2
