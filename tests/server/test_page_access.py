"""Who can use the page: contrast in both themes, a focus that shows, keys for everything, and no service."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator

import pytest

from pointpred_server.page import WEB
from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

TEXT = ("text", "quiet", "endpoint")
"""Colours of words; the others are colours of marks and lines."""
MARKS = ("past", "future", "endpoint", "second", "none", "target", "edge", "focus", "ballistic", "corrective")
GROUNDS = ("ground", "panel")


def themes() -> dict[str, dict[str, str]]:
    """The colours of the light theme, and of the dark one, by name."""
    sheet = (WEB / "page" / "style.css").read_text(encoding="utf-8")
    light, dark = re.findall(r":root \{(.*?)\}", sheet, re.DOTALL)[:2]
    return {
        name: dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6});", block))
        for name, block in (("light", light), ("dark", dark))
    }


def luminance(colour: str) -> float:
    """Relative luminance, WCAG 2.2."""
    channels = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_contrast_of_known_colours() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.005)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_words_have_contrast_aa_and_marks_three_to_one(theme: str) -> None:
    colours = themes()[theme]
    for (names, least), ground in itertools.product(((TEXT, 4.5), (MARKS, 3.0)), GROUNDS):
        for name in names:
            reached = contrast(colours[name], colours[ground])
            assert reached >= least, f"{name} on {ground}, {theme}: {reached:.2f}"


@pytest.fixture(scope="module")
def visitor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Visitor]:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as opened:
        yield opened


STOPS = {
    "live": {"tab-live", "place", "live-predictor-0", "live-predictor-1", "snippet", "snippet-copy"}
    | {f"recording-{number}" for number in range(1, 6)},
    "circle": {
        "tab-circle",
        "place",
        "targets",
        "distance",
        "width",
        "blocks",
        "participant",
        "circle-predictor",
        "shown",
        "circle-start",
    },
    "replay": {
        "tab-replay",
        "place",
        "replay-predictor-0",
        "replay-predictor-1",
        "replay-trials",
        "replay-file",
    }
    | {"replay-play", "replay-time", "replay-previous", "replay-next"},
    "assist": {"tab-assist", "place", "assist-predictor", "cpi", "gain", "strength", "alternate"}
    | {"assist-capture", "assist-clear"},
}


@browser.needed
@pytest.mark.parametrize("view", STOPS)
def test_every_control_is_reached_by_tab_and_shows_its_focus(visitor: Visitor, url: str, view: str) -> None:
    visitor.open(f"{url}#{view}")
    selects = "[...document.querySelectorAll('[role=tabpanel]:not([hidden]) select')]"
    visitor.wait(f"{selects}.every(({{ disabled }}) => !disabled)")
    line = "document.querySelector('[role=tabpanel]:not([hidden]) .connection')"
    visitor.wait(f"{line}?.dataset.state !== 'connecting'")
    visitor.value("document.querySelector('#live-more').open = true")
    reached = set()
    active = "document.activeElement"
    shown = f"getComputedStyle({active}.type === 'file' ? {active}.parentElement : {active}).outlineStyle"
    for _ in range(len(STOPS[view]) + 5):
        visitor.press("Tab")
        stop = visitor.value("document.activeElement.id || document.activeElement.name || ''")
        reached.add(stop)
        if stop:
            assert visitor.value(shown) == "solid", stop
    assert STOPS[view] <= reached


@browser.needed
def test_every_control_has_a_name(visitor: Visitor, url: str) -> None:
    visitor.open(url)
    tree = visitor.hand.call("Accessibility.getFullAXTree")["nodes"]
    wanted = {
        "button",
        "combobox",
        "listbox",
        "slider",
        "spinbutton",
        "checkbox",
        "tab",
        "image",
        "progressbar",
    }
    found = [node for node in tree if node.get("role", {}).get("value") in wanted and not node["ignored"]]
    assert len(found) > 5
    assert [node for node in found if not node.get("name", {}).get("value")] == []


@browser.needed
def test_escape_stops_a_run(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}#circle")
    visitor.wait("!document.querySelector('#circle-start').disabled")
    visitor.value("document.querySelector('#circle-start').click()")
    state = "document.querySelector('#circle-status').dataset.state"
    assert visitor.value(state) == "waiting"
    visitor.press("Escape")
    assert visitor.value(state) == "stopped"


@browser.needed
def test_settings_out_of_bounds_are_named(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}#circle")
    visitor.wait("!document.querySelector('#circle-start').disabled")
    wrong = [
        ("targets", "12", ["Targets", "3", "41", "odd"]),
        ("blocks", "", ["Blocks", "1", "50"]),
        ("distance", "3000", ["Distance"]),
    ]
    for name, value, named in wrong:
        field = f"document.querySelector('[name={name}]')"
        kept = visitor.value(f"{field}.value")
        visitor.value(f"{field}.value = {value!r}")
        visitor.value("document.querySelector('#circle-start').click()")
        assert visitor.value("document.querySelector('#circle-status').dataset.state") == "invalid"
        assert visitor.value("document.activeElement.name") == name
        assert all(word in visitor.text("#circle-status") for word in named)
        visitor.value(f"{field}.value = {kept!r}")


@browser.needed
def test_the_page_says_when_the_service_is_gone(visitor: Visitor) -> None:
    with page_browser.service() as url:
        visitor.open(f"{url}?by=service#live")
        visitor.wait("document.querySelector('#live-card-0 .connection').dataset.state === 'open'")
    visitor.wait("document.querySelector('#live-card-0 .connection').dataset.state === 'waiting'")


@browser.needed
def test_less_motion_is_respected(visitor: Visitor, url: str) -> None:
    visitor.prefer(reduced_motion="reduce")
    visitor.open(f"{url}#live")
    visitor.wait("document.querySelector('#live-scene').dataset.shows === 'demo'")
    same = "document.querySelector('#live-scene').toDataURL()"
    first = visitor.value(same)
    visitor.value("new Promise((done) => setTimeout(done, 400))")
    assert visitor.value(same) == first
    visitor.prefer(reduced_motion="no-preference")
    visitor.wait(f"{same} !== {first!r}")
