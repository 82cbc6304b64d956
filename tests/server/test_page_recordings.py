"""What the tiles of the live view stand for: recordings that load ahead, counted by `onIntent`'s ledger."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from pointpred_server.page import REPOSITORY
from tests.server import browser
from tests.server.page_browser import Visitor, until

pytestmark = browser.needed

ROOT = Path(__file__).parents[2]
SCENE = "document.querySelector('#live-scene').dataset"
BUTTON = "document.querySelector('#live-links').children[{}]"
COUNTS = """Object.fromEntries([...document.querySelectorAll('#live-loaded [data-of]')]
  .map((one) => [one.dataset.of, parseFloat(one.textContent)]))"""
NOTHING = {"fired": 0, "hit": 0, "wasted": 0, "early": None}
PAUSE = "new Promise((done) => setTimeout(done, 700))"
"""Longer than the pause that ends a movement."""


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at the live view; nothing is complained of, nothing shifts, no other host is asked."""
    one.prefer()
    one.resize(1280, 720)
    one.open(f"{url}#live")
    one.wait(f"{SCENE}.shows === 'demo'")
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001
    assert {address.split("/")[2] for address in one.asked() if "//" in address} == {url.split("/")[2]}


def shown(visitor: Visitor, number: int) -> dict[str, Any]:
    """The state of a recording, its words and whether its drawing is there."""
    button = BUTTON.format(number)
    found: dict[str, Any] = visitor.value(
        f"({{ state: {button}.dataset.state, words: {button}.querySelector('span').textContent,"
        f" drawn: {button}.querySelector('path').hasAttribute('d') }})"
    )
    return found


def middle(visitor: Visitor, number: int) -> tuple[float, float]:
    """The middle of the tile of a recording."""
    left, top, width, _ = visitor.corner(f"#live-links button:nth-child({number + 1})")
    return left + width / 2, top + 28


def somewhere(visitor: Visitor) -> tuple[float, float]:
    left, top, width, height = visitor.corner("#live-scene")
    return left + 0.15 * width, top + 0.3 * height


def test_a_recording_loads_before_it_is_clicked_and_is_counted_as_used(visitor: Visitor) -> None:
    goal = middle(visitor, 3)

    def loaded() -> bool:
        visitor.value(PAUSE)
        visitor.reach(somewhere(visitor), goal, 0.5)
        found: bool = visitor.value(f"['loading', 'loaded'].includes({BUTTON.format(3)}.dataset.state)")
        return found

    until(loaded, "a recording that loads while the pointer is on its way")
    visitor.click(*goal)
    visitor.wait(f"{BUTTON.format(3)}.dataset.state === 'hit'")
    visitor.wait(f"{BUTTON.format(3)}.querySelector('path').hasAttribute('d')")
    assert re.fullmatch(r"\d\.\d\d s early", shown(visitor, 3)["words"])
    counts = visitor.value(COUNTS)
    assert counts["hit"] == 1
    assert counts["wasted"] == counts["fired"] - 1
    visitor.value(PAUSE)
    assert shown(visitor, 3)["state"] == "hit", "it stays until the next movement"
    assert visitor.value(COUNTS)["early"] >= 0.0


def test_what_is_loaded_and_not_used_is_counted_as_wasted_and_loads_anew(visitor: Visitor) -> None:
    goal = middle(visitor, 1)
    visitor.mouse("mouseMoved", *somewhere(visitor))
    visitor.wait(f"{SCENE}.shows === 'pointer'")

    def wasted() -> bool:
        visitor.reach(somewhere(visitor), goal, 0.4)
        visitor.value(PAUSE)
        return bool(shown(visitor, 1)["state"] == "wasted")

    until(wasted, "a recording that was loaded in vain")
    assert shown(visitor, 1)["words"] == "not used"
    counts = visitor.value(COUNTS)
    assert counts["hit"] == 0
    assert counts["wasted"] == counts["fired"] > 0
    visitor.mouse("mouseMoved", goal[0] + 300, goal[1] - 200)
    visitor.wait(f"{BUTTON.format(1)}.dataset.state === 'idle'")
    assert shown(visitor, 1) == {"state": "idle", "words": "not loaded", "drawn": False}


def test_the_simulated_hand_loads_and_clicks_and_is_not_counted_as_a_person(visitor: Visitor) -> None:
    used = f"[...{BUTTON.format(0)}.parentElement.children].some(({{ dataset }}) => dataset.state === 'hit')"
    visitor.wait(used)
    counts = visitor.value(COUNTS)
    assert counts["hit"] >= 1
    assert counts["early"] > 0.0
    visitor.mouse("mouseMoved", *somewhere(visitor))
    visitor.wait(f"{SCENE}.shows === 'pointer'")
    assert visitor.value(COUNTS) == NOTHING
    assert not visitor.value(used)


def test_where_less_motion_is_asked_for_a_recording_is_shown_loaded_and_nothing_counted(
    visitor: Visitor, url: str
) -> None:
    visitor.prefer(reduced_motion="reduce")
    visitor.open(f"{url}#live")
    visitor.wait("document.querySelectorAll('#live-links [data-state=loaded] path[d]').length === 1")
    visitor.value(PAUSE)
    assert visitor.value(COUNTS) == NOTHING


def test_a_key_loads_a_recording_and_uses_it(visitor: Visitor) -> None:
    visitor.value("document.querySelector('#tab-live').focus()")

    def reached() -> bool:
        visitor.press("Tab")
        return bool(visitor.value(f"document.activeElement === {BUTTON.format(0)}"))

    until(reached, "the focus on the first recording")
    visitor.wait(f"{BUTTON.format(0)}.dataset.state === 'loaded'")
    visitor.press("Enter")
    visitor.wait(f"{BUTTON.format(0)}.dataset.state === 'hit'")
    assert visitor.value(COUNTS)["hit"] == 1


def test_no_frame_stays_around_a_tile_when_the_movement_is_over(visitor: Visitor) -> None:
    goal = middle(visitor, 3)
    visitor.value(
        "window.framed = false, new MutationObserver(() => "
        f"framed ||= {SCENE}.shows === 'pointer' && {SCENE}.ahead !== '')"
        ".observe(document.querySelector('#live-scene'), { attributeFilter: ['data-ahead'] })"
    )

    def framed() -> bool:
        visitor.value(PAUSE)
        visitor.reach(somewhere(visitor), goal, 0.5)
        found: bool = visitor.value("framed")
        return found

    until(framed, "a tile that is framed on the way")
    visitor.wait(f"{SCENE}.ahead === ''")
    assert visitor.value(f"{SCENE}.shows") == "pointer"


def test_the_snippet_is_copied_and_is_a_program_that_works(visitor: Visitor) -> None:
    visitor.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    visitor.page.bring_to_front()
    visitor.page.click("#snippet-copy")
    visitor.wait("document.querySelector('#snippet-copy').textContent === 'Copied'")
    copied: str = visitor.page.evaluate("navigator.clipboard.readText()")
    first, body = copied.split(";", 1)
    assert first == 'import { prefetchLink }\n  from "pointpred/intent"'
    loaded = "import('/web/lib/intent/index.js')"
    program = f"{loaded}.then(({{ prefetchLink }}) => {{\n{body}\n}}).then(() => 'registered')"
    assert visitor.value(program) == "registered"
    visitor.wait("document.querySelector('#snippet-copy').textContent === 'Copy'")


def test_links_lead_to_documents_of_the_repository(visitor: Visitor) -> None:
    links = visitor.value("[...document.links].map(({ href }) => href)")
    assert REPOSITORY in links
    documents = [link.removeprefix(f"{REPOSITORY}/blob/main/") for link in links if link != REPOSITORY]
    assert len(documents) == 2
    assert all((ROOT / document).is_file() for document in documents), documents
