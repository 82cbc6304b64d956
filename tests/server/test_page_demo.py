"""The page as files: every view works below any path of a static host, and no other host is asked."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from pointpred_server.demo import MOVEMENTS, write_demo
from tests.hosts import file_host
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

PREFIX = "people/pointing/demo/"
FOREIGN = "time,x,y\n" + "".join(f"{i / 50},{i * i},0\n" for i in range(40))
HERE = "Predicted in this page."


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A static host that has the page far below its root."""
    root = tmp_path_factory.mktemp("host")
    folder = root / PREFIX
    folder.mkdir(parents=True)
    write_demo(folder)
    with file_host(root) as origin:
        yield f"{origin}/{PREFIX}"


@pytest.fixture
def visitor(one: Visitor, address: str) -> Iterator[Visitor]:
    """Somebody whose page complains of nothing, moves nothing and asks only for files of the folder."""
    one.resize(1280, 720)
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001
    asked = {url for url in one.asked() if "//" in url}
    assert asked
    assert {url for url in asked if not url.startswith(address)} - {"about:blank"} == set()


def test_live_predicts_and_says_where(visitor: Visitor, address: str) -> None:
    visitor.open(address)
    visitor.wait(f"document.querySelector('#live-card-0 .connection').textContent === '{HERE}'")
    visitor.wait("document.querySelector('#live-scene').dataset.shows === 'demo'")
    assert visitor.value("document.querySelector('header .place').innerText").split() == [
        "Predicted",
        "in",
        "this",
        "page",
    ]
    shown = "[...document.querySelectorAll('#place, #live-device')].map((one) => one.offsetParent)"
    assert visitor.value(shown) == [None, None]
    left, top, width, height = visitor.corner("#live-scene")
    visitor.reach((left + 0.2 * width, top + 0.3 * height), (left + 0.8 * width, top + 0.5 * height), 0.5)
    visitor.wait("Number(document.querySelector('#live-scene').dataset.drawn) > 0")
    visitor.value("document.querySelector('#live-more').open = true")
    visitor.choose("#live-predictor-1", "switched")
    visitor.wait(f"document.querySelector('#live-card-1 .connection').textContent === '{HERE}'")
    assert visitor.value("document.querySelectorAll('#live-parameters-1 input[type=range]').length") > 5


def test_a_circle_is_done_and_its_recording_can_be_saved(visitor: Visitor, address: str) -> None:
    visitor.open(f"{address}#circle")
    visitor.wait("!document.querySelector('#circle-start').disabled")
    for name, value in (("targets", 3), ("blocks", 1)):
        visitor.enter(name, value)
    visitor.value("document.querySelector('#circle-start').click()")
    left, top, *_ = visitor.corner("#circle-scene")
    place = (left + 10.0, top + 10.0)
    for number in range(4):
        goal = visitor.value("JSON.parse(document.querySelector('#circle-scene').dataset.target)")
        end = (left + goal["x"] + 2 * number, top + goal["y"] + number)
        visitor.reach(place, end, 0.3)
        visitor.click(*end)
        place = end
    visitor.wait("!document.querySelector('#circle-result').hidden")
    assert "3 of 3 movements, 0 missed" in visitor.text("#circle-status")
    visitor.wait("document.querySelectorAll('#circle-rows [data-px]').length > 0")
    assert visitor.value("document.querySelector('#circle-samples').href").startswith("blob:")


def test_the_sample_and_its_file_are_replayed_and_other_formats_refused(
    visitor: Visitor, address: str
) -> None:
    visitor.open(f"{address}#replay")
    readout = "document.querySelector('#replay-readout').textContent"
    visitor.wait(f"{readout}.includes('Movement 1 of {MOVEMENTS}')")
    as_sample = visitor.text("#replay-readout")
    assert "px off" in as_sample
    visitor.value(
        "Promise.all([...document.querySelectorAll('#view-replay a[download]')].map(async ({ href }) =>"
        "new File([await (await fetch(href)).blob()], href.split('/').at(-1)))).then((found) => {"
        "const files = new DataTransfer(); for (const one of found) files.items.add(one);"
        "const input = document.querySelector('#replay-file'); input.files = files.files;"
        "input.dispatchEvent(new Event('change')); })"
    )
    visitor.wait("document.querySelector('#replay-source').textContent.includes('It stays in this page.')")
    visitor.wait(f"{readout}.includes('px off')")
    assert visitor.text("#replay-readout") == as_sample
    visitor.give_files({"foreign.csv": FOREIGN})
    visitor.wait("document.querySelector('#replay-source').dataset.state === 'failed'")
    assert "pointpred convert" in visitor.text("#replay-source")
    assert visitor.text("#replay-readout") == as_sample


def test_assist_moves_its_cursor(visitor: Visitor, address: str) -> None:
    visitor.open(f"{address}#assist")
    visitor.wait("!document.querySelector('#assist-capture').disabled")
    left, top, width, height = visitor.corner("#assist-capture")
    place = (left + width / 2, top + height / 2)
    visitor.mouse("mouseMoved", *place)
    visitor.click(*place)
    visitor.wait("document.pointerLockElement?.id === 'assist-scene'")
    visitor.wait(f"document.querySelector('#assist-connection').textContent === '{HERE}'")
    cursor = "Number(document.querySelector('#assist-scene').dataset.x)"
    before = visitor.value(cursor)
    for step in range(1, 31):
        visitor.mouse("mouseMoved", place[0] - 5 * step, place[1])
    visitor.hand.wait_for_results()
    visitor.wait(f"{cursor} < {before} - 10")
    visitor.press("Escape")
    visitor.wait("document.querySelector('#assist-status').dataset.state === 'released'")
