"""A real page's mouse along a recorded path: every position, every press, at the recorded pace."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pointpred import EventColumns
from pointpred.errors import ParameterError, SourceError
from pointpred.live.devtools import Page, drive_mouse, open_page
from tests.server import browser
from tests.server.listener import Listener

pytestmark = browser.needed

WATCH = """window.seen = [];
for (const name of ["pointermove", "pointerdown", "pointerup", "click", "auxclick"])
  addEventListener(name, (event) => {
    const whole = event.getCoalescedEvents?.() ?? [];
    for (const one of whole.length ? whole : [event])
      seen.push([name, one.clientX, one.clientY, one.buttons, event.button, event.isTrusted, one.timeStamp]);
  }, true);"""


@pytest.fixture
def page(devtools: str) -> Iterator[Page]:
    with Listener() as listener, open_page(devtools, listener.url, timeout_s=browser.PATIENCE_S) as tab:
        tab.evaluate(WATCH)
        yield tab
        tab.call("Page.close")


def seen(page: Page) -> list[list[Any]]:
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    found: list[list[Any]] = page.evaluate("seen")
    return found


def test_a_path_is_followed_with_its_presses(page: Page) -> None:
    buttons = [0, 0, 1, 1, 1, 3, 2, 0, 4, 0]
    path = EventColumns.of(
        np.arange(10) / 100, 100 + 20.5 * np.arange(10), 5 * np.arange(10), buttons=buttons
    )
    driven = drive_mouse(page, path, speed=math.inf, offset=(10.0, 40.0), scale=0.5)
    assert (driven.moves, driven.presses, driven.releases) == (4, 3, 3)
    pointer = [one for one in seen(page) if one[0].startswith("pointer")]
    pointer.sort(key=lambda one: (one[6], one[1]))  # a stalled page hears moves from after a press before it
    assert [one[1] for one in pointer] == (0.5 * path.x + 10).tolist()
    assert [one[2] for one in pointer] == (0.5 * path.y + 40).tolist()
    assert [one[3] for one in pointer] == buttons
    assert all(one[5] for one in pointer), "the page cannot tell them from a person's"
    assert [one[4] for one in seen(page) if one[0] == "click"] == [0]


def test_the_end_of_loading_is_that_of_the_page_asked_for(page: Page) -> None:
    late = {"method": "Page.lifecycleEvent", "params": {"name": "load", "loaderId": "of the page before"}}
    page.events.append(late)
    assert not page._loaded("of this one")
    here = page.evaluate("location.href")
    page.go(here)
    assert page.evaluate("[document.readyState, window.seen]") == ["complete", None]
    page.go(f"{here}#part")  # nothing is loaded anew
    assert page.evaluate("location.hash") == "#part"


def test_the_recorded_pace_is_kept(page: Page) -> None:
    t = np.linspace(0.0, 0.5, 251)
    path = EventColumns.of(t, 100 + 100 * t, 100 + 0 * t)
    driven = drive_mouse(page, path)
    assert driven.seconds >= 0.5
    assert len(seen(page)) == 251
    assert drive_mouse(page, path, speed=4.0).seconds >= 0.125


def test_no_button_stays_down(page: Page) -> None:
    driven = drive_mouse(page, EventColumns.of([0.0, 0.01], [50, 60], [50, 60], buttons=[0, 1]))
    assert (driven.presses, driven.releases) == (1, 1)
    assert seen(page)[-1][:4] == ["click", 60, 60, 0]


def test_the_command_drives_a_page(devtools: str, command: Callable[..., Any], tmp_path: Path) -> None:
    with Listener() as listener:
        left = command(
            "replay", "--devtools", devtools, "--to", f"{listener.url}/here", "--trial", "p01-0",
            "--speed", "max", "--json", tmp_path / "done.json",
        )  # fmt: skip
        assert left.code == 0, left.err
        assert "/here" in listener.requests
    assert "p01-0: 1375 moves, 1 presses, 1 releases" in left.err
    assert '"moves": 1375' in (tmp_path / "done.json").read_text(encoding="utf-8")


def test_faults_are_said_in_words(page: Page, devtools: str) -> None:
    path = EventColumns.of([0.0], [0], [0])
    for wrong in ({"speed": 0.0}, {"scale": -1.0}, {"speed": math.nan}):
        with pytest.raises(ParameterError, match=f"{next(iter(wrong))} must be positive"):
            drive_mouse(page, path, **wrong)
    with pytest.raises(SourceError, match="the page threw: ReferenceError: nothing is not defined"):
        page.evaluate("nothing")
    with pytest.raises(SourceError, match=r"the browser refused a command: 'Input\.nothing' wasn't found"):
        page.call("Input.nothing")
    with pytest.raises(SourceError, match=r"the page cannot open http://127\.0\.0\.1:1/: net::ERR"):
        open_page(devtools, "http://127.0.0.1:1/")
    assert page.evaluate("1 + 1") == 2
