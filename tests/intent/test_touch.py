"""Fingers."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed


@pytest.fixture
def phone(page: IntentPage) -> Iterator[IntentPage]:
    call = page.visitor.hand.call
    call("Emulation.setTouchEmulationEnabled", enabled=True)
    call("Emulation.setEmitTouchEventsForMouse", enabled=False)
    yield page
    call("Emulation.setTouchEmulationEnabled", enabled=False)


def touch(page: IntentPage, kind: str, *points: tuple[float, float]) -> None:
    page.visitor.hand.call(
        "Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y} for x, y in points]
    )
    page.settle()


def test_a_finger_on_the_element_fires(phone: IntentPage) -> None:
    phone.make(
        "watch(box('on', 100, 100)); watch(box('lit', 300, 100), { policy: 'highlight' });"
        "watch(box('off', 500, 100), { touch: 'none' })"
    )
    for x in (150, 350, 550):
        touch(phone, "touchStart", (x, 130))
        touch(phone, "touchEnd")
    assert phone.said() == ["on touch", "lit touch", "lit ended"]


def test_a_finger_that_scrolls_points_at_nothing(phone: IntentPage) -> None:
    phone.make("document.body.style.height = '3000px'; watch(box('way', 400, 300), { touch: 'none' })")
    touch(phone, "touchStart", (450, 600))
    for y in range(590, 250, -10):
        touch(phone, "touchMove", (450, y))
    touch(phone, "touchEnd")
    assert phone.said() == []


def test_on_a_phone_elements_may_fire_when_they_come_into_view(phone: IntentPage) -> None:
    phone.make(
        "document.body.style.height = '3000px'; watch(box('here', 100, 100), { touch: 'viewport' });"
        "watch(box('below', 100, 2000), { touch: 'viewport' }); watch(box('start', 300, 100))"
    )
    phone.wait("heard.length > 0")
    assert phone.said() == ["here viewport"]
    phone.make("scrollTo(0, 1800)")
    phone.wait("heard.length > 1")
    assert phone.said() == ["here viewport", "below viewport"]


def test_with_a_mouse_coming_into_view_fires_nothing(page: IntentPage) -> None:
    page.make("watch(box('here', 100, 100), { touch: 'viewport' })")
    assert page.said() == []
