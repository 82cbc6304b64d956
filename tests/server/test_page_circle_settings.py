"""The circle's settings before a run: Start needs the service, and overlapping targets are warned of."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator

import pytest

from pointpred.simulation.circle import positions
from tests.server import browser, page_browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

START, STATUS = (
    "document.querySelector('#circle-start')",
    "document.querySelector('#circle-status').textContent",
)
WARNING = "document.querySelector('#circle-warning').textContent"
DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Somebody at the circle view, with room for a circle."""
    one.resize(1440, 900)
    one.open(f"{url}#circle")
    one.wait(f"!{START}.disabled")
    yield one
    assert one.complaints() == []


def enter(visitor: Visitor, **settings: float) -> str:
    """Type into settings; returns the warning that the page then shows."""
    for name, value in settings.items():
        visitor.enter(name, value)
    visitor.value(DRAWN)
    said: str = visitor.value(WARNING)
    return said


@pytest.mark.parametrize(("targets", "distance", "width"), [(13, 300, 120), (41, 400, 40), (3, 50, 60)])
def test_overlapping_targets_are_warned_of_with_settings_that_do_not(
    visitor: Visitor, targets: int, distance: int, width: int
) -> None:
    """The least distance between centres is worked out by the simulation's own circle."""
    places = positions(float(distance), (0.0, 0.0), targets)
    apart = min(math.dist(one, other) for one, other in itertools.combinations(places, 2))
    said = enter(visitor, targets=targets, distance=distance, width=width)
    wide, least, narrow, far = map(int, re.findall(r"\d+", said))
    assert (wide, least, narrow) == (width, math.floor(apart), math.floor(apart))
    assert enter(visitor, width=narrow) == ""
    assert enter(visitor, width=narrow + 1) != ""
    assert visitor.value(START + ".disabled") is False  # a warning, no refusal
    scaled = [min(math.dist(places[0], one) for one in places[1:]) * d / distance for d in (far - 1, far)]
    assert scaled[0] < width <= scaled[1]


def test_the_usual_settings_do_not_overlap(visitor: Visitor) -> None:
    assert visitor.value(WARNING) == ""
    visitor.resize(390, 844)
    visitor.value(DRAWN)
    assert visitor.value(WARNING) == ""


def test_start_waits_for_the_service_and_says_so(tmp_path_factory: pytest.TempPathFactory) -> None:
    with page_browser.visitor(tmp_path_factory.mktemp("profile")) as visitor:
        with page_browser.service() as url:
            visitor.open(f"{url}?by=service#circle")
            visitor.wait(f"!{START}.disabled")
            before = visitor.value(STATUS)
        visitor.wait(f"{START}.disabled")
        visitor.wait("document.querySelector('#circle-status').dataset.state === 'down'")
        with page_browser.service(port=int(url.rstrip("/").rpartition(":")[2])):
            visitor.wait(f"!{START}.disabled")
            assert visitor.value(STATUS) == before
