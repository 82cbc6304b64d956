"""The page when something goes wrong: no service, another window, files and settings that do not fit."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from pointpred.datasets import sample
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

STATUS, READOUT = "#circle-status", "#replay-readout"
STATE = f"document.querySelector('{STATUS}').dataset.state"
TABLE = "user,trial,t_s,x_px,y_px\n" + "".join(f"u,one,{i / 50},{i * i},0\n" for i in range(40))
STALLED = "Blob.prototype.text = () => new Promise(() => {})"
"""Files whose content never comes."""


@pytest.fixture
def visitor(one: Visitor) -> Iterator[Visitor]:
    """Somebody whose page is laid out as before whatever went wrong."""
    one.prefer(color_scheme="light")
    one.resize(1280, 720)
    yield one
    refuse(one)
    assert one.shift() < 0.001


def refuse(visitor: Visitor, *addresses: str) -> None:
    """Let requests for these addresses fail, and no others."""
    visitor.hand.call("Network.enable")
    visitor.hand.call("Network.setBlockedURLs", urls=list(addresses))


def press(visitor: Visitor, part: str) -> None:
    visitor.value(f"document.querySelector({part!r}).click()")


def circle(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}#circle")
    visitor.wait("!document.querySelector('#circle-start').disabled")


def test_a_view_first_opened_without_the_service_works_once_it_is_back(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}healthz")
    refuse(visitor, "*/v1/*")
    visitor.hand.call("Network.setCacheDisabled", cacheDisabled=True)
    visitor.open(f"{url}?by=service#live")
    refuse(visitor, "*/v1/*", "*/web/page/circle*")
    press(visitor, "#tab-circle")
    visitor.wait(f"document.querySelector('{STATUS}').dataset.failed === 'true'")
    refuse(visitor)
    visitor.wait("!document.querySelector('#circle-start').disabled")


def test_a_file_that_stalls_leaves_what_is_shown(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}#replay")
    visitor.wait("!document.querySelector('#replay-play').disabled")
    visitor.value(STALLED)
    visitor.give_files({"slow.csv": TABLE})
    visitor.wait("document.querySelector('#replay-source').dataset.state === 'reading'")
    press(visitor, "#replay-next")
    count = len(sample().trials)
    visitor.wait(f"document.querySelector('{READOUT}').textContent.includes('Movement 2 of {count}')")
    assert visitor.value("document.querySelector('#replay-trials').options.length") == count


def test_a_first_movement_that_did_not_come_can_be_asked_for_again(visitor: Visitor, url: str) -> None:
    refuse(visitor, "*/v1/samples/*")
    visitor.open(f"{url}#replay")
    visitor.wait("!document.querySelector('#replay-retry').hidden")
    assert "Movement 1" in visitor.text(READOUT)
    assert visitor.value("document.querySelector('#replay-play').disabled")
    refuse(visitor)
    press(visitor, "#replay-retry")
    visitor.wait("!document.querySelector('#replay-play').disabled")
    assert "Movement 1 of" in visitor.text(READOUT)
    assert visitor.value("document.querySelector('#replay-retry').hidden")


def test_a_run_whose_circle_no_longer_fits_is_stopped(visitor: Visitor, url: str) -> None:
    circle(visitor, url)
    press(visitor, "#circle-start")
    visitor.resize(1270, 715)
    visitor.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    assert visitor.value(STATE) == "waiting"
    visitor.resize(390, 844)
    visitor.wait(f"{STATE} === 'stopped'")
    assert visitor.text(STATUS) != "Stopped.", "the reason is given"


def test_rows_and_words_do_not_move_what_stands_beside_them(visitor: Visitor, url: str) -> None:
    circle(visitor, url)
    places = (
        "[...document.querySelectorAll('#view-circle .rows th, #view-circle .rows')]"
        ".map((one) => one.getBoundingClientRect().toJSON())"
    )
    before = visitor.value(places)
    visitor.value(
        "{ const row = document.querySelector('#circle-rows').insertRow();"
        "for (const words of ['50.41', '12.34 s', '1234.5', '1234.5', '-12.34'])"
        "row.insertCell().append(words);"
        "row.className = 'missed';"
        "document.querySelector('#circle-status').textContent = 'word '.repeat(99); }"
    )
    assert visitor.value(places) == before


def test_a_distance_of_the_pages_own_follows_the_targets(visitor: Visitor, url: str) -> None:
    visitor.resize(390, 844)
    circle(visitor, url)
    for targets in (3, 41):
        visitor.enter("targets", targets)
        press(visitor, "#circle-start")
        assert visitor.value(STATE) == "waiting"
        press(visitor, "#circle-stop")
    visitor.enter("distance", 900)
    visitor.enter("targets", 3)
    press(visitor, "#circle-start")
    assert visitor.value(STATE) == "invalid"
    assert visitor.value("document.activeElement.name") == "distance"


def test_a_refused_setting_is_seen_and_reached(visitor: Visitor, url: str) -> None:
    circle(visitor, url)
    for name, value in (("distance", 3000), ("targets", 12)):
        visitor.enter(name, value)
        press(visitor, "#circle-start")
        field = f"document.querySelector('[name={name}]')"
        assert visitor.value("document.activeElement.name") == name
        assert visitor.value(f"{field}.getAttribute('aria-invalid')") == "true"
        assert visitor.value(f"{field}.getAttribute('aria-describedby')") == "circle-status"
        assert visitor.value(f"getComputedStyle({field}).borderTopColor") == "rgb(194, 65, 12)"
    visitor.enter("targets", 13)
    visitor.enter("distance", 300)
    visitor.wait(
        "document.querySelectorAll('[aria-invalid=true], [aria-describedby=circle-status]').length === 0"
    )
