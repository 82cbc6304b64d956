"""The example page in a real browser: it fetches a page while the mouse is on its way to the link."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page

from pointpred import RECOMMENDED, EventColumns, build
from pointpred.targets import Chooser, Target
from tests.server import browser
from tests.server.browser import Chromium, move_at
from tests.server.listener import Listener, soon

pytestmark = browser.needed


@pytest.fixture
def chromium(tmp_path: Path) -> Iterator[Chromium]:
    with browser.running(tmp_path / "profile") as running:
        yield running


def stamped(page: Page, events: EventColumns) -> None:
    """Move a page's mouse along events at their own times, one sample a dispatch on any machine."""
    began, protocol = time.time(), page.context.new_cdp_session(page)
    for t, x, y in events.table[:, :3].tolist():
        move_at(protocol, x, y, began + t)


def proposed(events: EventColumns, listener: Listener) -> set[str]:
    """What the same events propose among the targets that were told."""
    targets = [Target(**one) for one in listener.messages("targets")[-1]["targets"]]
    pipeline, changes = build(RECOMMENDED, targets=targets), []
    chooser = Chooser(pipeline)
    for event in events.events():
        pipeline.update(event)
        changes += chooser.update()
    return {str(change.id) for change in changes if change.action == "propose"}


def test_the_example_prefetches_before_the_cursor_is_there(chromium: Chromium, listener: Listener) -> None:
    """It prefetches what a batch of the same events says that the mouse is heading for."""
    with chromium.tab(f"{listener.url}/web/page/example.html") as page:
        place = "(a) => [a.pathname, a.getBoundingClientRect().toJSON()]"
        places = dict(page.evaluate(f"[...document.querySelectorAll('nav a')].map({place})"))
        goal = places["/v1/predictors"]
        soon(lambda: len(listener.messages("targets")[-1:]) == 1, "the cards are targets")
        assert {one["id"] for one in listener.messages("targets")[-1]["targets"]} == set(places)
        x, y = goal["x"] + goal["width"] / 2, goal["y"] + goal["height"] / 2
        t = np.arange(0.0, 1.2, 0.008)
        share = 10 * (t / 1.2) ** 3 - 15 * (t / 1.2) ** 4 + 6 * (t / 1.2) ** 5
        movement = EventColumns.of(t, x - 150 + 150 * share, y - 300 + 300 * share)
        ahead = movement.rows(0, int(np.argmax(movement.y > goal["y"] - 5)))  # never reaches the link
        assert len(ahead) > 50
        stamped(page, ahead)
        soon(lambda: len(listener.events()) == len(ahead), "every sample was heard")
        soon(lambda: "/v1/predictors" in listener.requests, "the link was prefetched")
        assert page.evaluate("document.getElementById('status').textContent").startswith("Prefetched: ")
        heard = listener.events()
        assert [len(frame) for frame in listener.binary()] == [heard.itemsize] * len(heard)
        resolution_s = 1e-4  # of the times of events in a page that is not isolated
        assert np.diff(heard["t"]) == pytest.approx(np.diff(ahead.t), abs=resolution_s)
        wanted = proposed(EventColumns.of(heard["t"], heard["x"], heard["y"]), listener)
        soon(lambda: wanted <= set(listener.requests), f"{wanted} were prefetched")
        assert set(listener.requests) & set(places) == wanted
