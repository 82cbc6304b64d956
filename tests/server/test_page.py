"""The page in a real browser: each view shows what it was told, and nothing else happens."""

from __future__ import annotations

import io
from collections.abc import Iterator

import pytest

from pointpred.datasets import sample
from pointpred.registry import RECOMMENDED, REGISTRY
from tests.server import browser
from tests.server.page_browser import Visitor, until

pytestmark = browser.needed

STATUS = "document.querySelector('#live-card-{} .connection').dataset.state"
SEEN = """
window.seen = { phase: [], delay: [], away: false };
for (const of of ["phase", "delay"]) {
  const shown = document.querySelector(`#view-live [data-of=${of}]`);
  new MutationObserver(() => seen[of].push(shown.textContent)).observe(shown, { childList: true });
}
const invitation = document.querySelector("#live-invitation");
new MutationObserver(() => { seen.away ||= invitation.classList.contains("away"); })
  .observe(invitation, { attributeFilter: ["class"] });
"""
"""Keeps every word that two of the numbers show, and whether the invitation went."""
PAUSE = "new Promise((done) => setTimeout(done, 600))"
"""Longer than the pause that ends a movement, after which the page judges it."""
VERDICT = "JSON.parse(document.querySelector('#live-verdict').dataset.verdict ?? 'null')"
LIGHT = {"endpoint": (194, 65, 12), "second": (126, 34, 206), "past": (37, 99, 168), "target": (63, 125, 79)}


@pytest.fixture
def visitor(one: Visitor, url: str) -> Iterator[Visitor]:
    """Whatever a test does: no complaint, no other host, nothing moves by itself."""
    one.prefer(color_scheme="light")
    one.resize(1280, 720)
    yield one
    assert one.complaints() == []
    assert {address.split("/")[2] for address in one.asked() if "//" in address} == {url.split("/")[2]}
    assert one.shift() < 0.001


def pixels(visitor: Visitor, part: str) -> set[tuple[int, int, int]]:
    """The colours in an element, as it is drawn now."""
    from matplotlib.image import imread

    picture = imread(io.BytesIO(visitor.page.screenshot()))
    left, top, width, height = (round(value) for value in visitor.corner(part))
    shown = (picture[top : top + height, left : left + width, :3] * 255).round().astype(int)
    return {(r, g, b) for r, g, b in shown.reshape(-1, 3).tolist()}


def live(visitor: Visitor, url: str, second: str = "") -> tuple[float, float, float, float]:
    """Open the live view, connected; returns the picture's place."""
    visitor.open(f"{url}#live")
    visitor.wait(f"{STATUS.format(0)} === 'open'")
    if second:
        visitor.value("document.querySelector('#live-more').open = true")
        visitor.choose("#live-predictor-1", second)
        visitor.wait(f"{STATUS.format(1)} === 'open'")
    return visitor.corner("#live-scene")


def test_a_replayed_movement_invites_while_nobody_moves(visitor: Visitor, url: str) -> None:
    live(visitor, url)
    visitor.wait("document.querySelector('#live-scene').dataset.shows === 'demo'")
    assert "Move your mouse here" in visitor.text("#live-invitation")
    visitor.prefer(reduced_motion="reduce", color_scheme="light")
    until(lambda: LIGHT["endpoint"] in pixels(visitor, "#live-scene"), "half of it with its prediction")


def test_predictions_of_two_predictors_are_drawn_while_the_mouse_moves(visitor: Visitor, url: str) -> None:
    left, top, width, height = live(visitor, url, second="linear")
    start, end = (left + 0.2 * width, top + 0.7 * height), (left + 0.7 * width, top + 0.3 * height)
    visitor.value(SEEN)
    visitor.mouse("mouseMoved", *start)
    half = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)

    visitor.gather_colours("#live-scene")

    def drawn() -> bool:
        visitor.reach(start, half, 0.5)
        visitor.reach(half, start, 0.5)
        phases = set(visitor.value("seen.phase"))
        return (
            visitor.colours() >= {LIGHT["endpoint"], LIGHT["second"], LIGHT["past"]}
            and {"ballistic"} < phases
        )

    # a busy machine may draw no frame before the speed peaks: then once more
    until(drawn, "both endpoints, the trail and the phases")
    assert visitor.value("Number(document.querySelector('#live-scene').dataset.drawn)") > 0
    assert set(visitor.value("seen.phase")) <= {"ballistic", "corrective", "still", "–"}
    assert any(words[0].isdigit() for words in visitor.value("seen.delay"))
    assert visitor.value("seen.away")
    judged(visitor, half, end, RECOMMENDED, "linear")


def judged(
    visitor: Visitor, start: tuple[float, float], end: tuple[float, float], *names: str, seconds: float = 0.3
) -> None:
    """Move until the page judges a movement by these: on a busy machine answers may come after that."""

    def found() -> bool:
        visitor.value(PAUSE)
        visitor.reach(start, end, seconds)
        visitor.value(PAUSE)
        verdict = visitor.value(VERDICT) or {"each": []}
        spoke = [one["name"] for one in verdict["each"] if one["lead_s"] is not None]
        return spoke == list(names)

    until(found, f"a movement judged by {names}")


def test_another_predictor_can_be_chosen_live(visitor: Visitor, url: str) -> None:
    left, top, width, height = live(visitor, url)
    offered = visitor.value(
        "[...document.querySelector('#live-predictor-0').options].map(({value}) => value)"
    )
    assert offered == list(REGISTRY)
    visitor.choose("#live-predictor-0", "hold")
    judged(visitor, (left + 30, top + 30), (left + width / 2, top + height / 2), "hold")


def sockets(visitor: Visitor) -> int:
    """How many connections the page holds."""
    visitor.value("0")
    return sum(not one.is_closed() for one in visitor.sockets)


def test_tabs_take_arrow_keys_and_deep_links(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}#circle")
    shown = "[...document.querySelectorAll('[role=tabpanel]')].filter(one => !one.hidden).map(one => one.id)"
    assert visitor.value(shown) == ["view-circle"]
    visitor.value("document.getElementById('tab-circle').focus()")
    keys = [("ArrowRight", "replay"), ("ArrowRight", "assist"), ("ArrowRight", "live")]
    for key, view in [*keys, ("End", "assist"), ("Home", "live")]:
        visitor.press(key)
        assert visitor.value(shown) == [f"view-{view}"]
        assert visitor.value("document.activeElement.id") == f"tab-{view}"
        assert visitor.value("location.hash") == f"#{view}"
        assert visitor.value("document.querySelectorAll('[role=tab][tabindex=\"-1\"]').length") == 3
        if view == "live":  # a socket that is closed before it is open is complained of
            visitor.wait(f"{STATUS.format(0)} === 'open'")
    visitor.value("history.back()")
    visitor.wait(f"{shown}[0] === 'view-assist'")
    until(lambda: sockets(visitor) == 0, "views that are not open have no connection")


def test_the_sample_is_replayed_with_two_predictors(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}#replay")
    visitor.wait("!document.querySelector('#replay-play').disabled")
    visitor.choose("#replay-predictor-1", "minimum-jerk")
    visitor.wait("document.querySelector('#replay-readout').textContent.includes('minimum-jerk')")
    assert f"Movement 1 of {len(sample().trials)}, simulated person" in visitor.text("#replay-readout")
    assert "px from where it ended" in visitor.text("#replay-readout")
    wanted = {LIGHT["past"], LIGHT["target"], LIGHT["second"]}
    until(lambda: pixels(visitor, "#replay-scene") >= wanted, "the movement, its target and the prediction")
    before = visitor.value("Number(document.querySelector('#replay-time').value)")
    visitor.value("document.querySelector('#replay-play').click()")
    visitor.wait(f"Number(document.querySelector('#replay-time').value) > {before} + 200")
    visitor.value(
        "{ const play = document.querySelector('#replay-play');"
        "if (play.textContent === 'Play') play.click();"  # a busy machine finds it at its end
        "play.click(); }"
    )
    assert visitor.text("#replay-play") == "Play"


@pytest.mark.parametrize("view", ["live", "circle", "replay"])
@pytest.mark.parametrize("size", [(1280, 720), (390, 844), (320, 640)])
def test_views_fit_their_window_and_nothing_shifts(
    visitor: Visitor, url: str, view: str, size: tuple[int, int]
) -> None:
    visitor.resize(*size)
    visitor.open(f"{url}#{view}")
    selects = "[...document.querySelectorAll('[role=tabpanel]:not([hidden]) select')]"
    visitor.wait(f"{selects}.every(({{ disabled }}) => !disabled)")
    assert visitor.value("document.documentElement.scrollWidth <= document.documentElement.clientWidth")


def touch(visitor: Visitor, kind: str, *places: tuple[float, float]) -> None:
    points = [{"x": x, "y": y} for x, y in places]
    visitor.hand.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)


def test_a_finger_selects_by_lifting(visitor: Visitor, url: str) -> None:
    visitor.hand.call("Emulation.setTouchEmulationEnabled", enabled=True)
    visitor.open(f"{url}#circle")
    visitor.wait("!document.querySelector('#circle-start').disabled")
    for name, value in (("targets", 3), ("blocks", 1)):
        visitor.value(f"document.querySelector('[name={name}]').value = {value}")
    visitor.value("document.querySelector('#circle-start').click()")
    left, top, *_ = visitor.corner("#circle-scene")
    place = (left + 20, top + 20)
    goal = "JSON.parse(document.querySelector('#circle-scene').dataset.target)"
    for _ in range(4):
        end = tuple(visitor.value(f"(({{ x, y }}) => [{left} + x, {top} + y])({goal})"))
        touch(visitor, "touchStart", place)
        for i in range(1, 13):
            share = i / 12
            touch(
                visitor,
                "touchMove",
                (place[0] + share * (end[0] - place[0]), place[1] + share * (end[1] - place[1])),
            )
        touch(visitor, "touchEnd")
        place = (end[0], end[1])
    visitor.hand.call("Emulation.setTouchEmulationEnabled", enabled=False)
    visitor.wait("!document.querySelector('#circle-result').hidden")
    assert visitor.value("document.querySelector('#circle-status').dataset.state") == "done"
    assert "3 of 3 movements, 0 missed" in visitor.text("#circle-status")
