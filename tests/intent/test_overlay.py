"""The overlay for developers."""

from __future__ import annotations

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

HOST = "[...document.documentElement.children].find((one) => one.shadowRoot)"
SHADOW = f"({HOST})?.shadowRoot"


def test_it_shows_what_is_predicted_and_takes_nothing_from_the_page(page: IntentPage) -> None:
    page.make(
        "window.clicks = 0; for (let i = 0; i < 5; i += 1) watch(box(`b${i}`, 100 + 150 * i, 500), "
        "{ hitSlop: 10 });"
        "document.body.addEventListener('click', () => { clicks += 1; });"
        "window.hiding = showOverlay(); hiding.then((hide) => { window.hide = hide; })"
    )
    page.wait("window.hide !== undefined")
    page.move((40, 40), (750, 530), 0.4)
    page.visitor.click(750, 530)
    page.settle()
    assert page.value("clicks") == 1, "clicks go through it"
    shown = page.value(f"[...{SHADOW}.querySelectorAll('dd')].map((one) => one.textContent)")
    told = page.ledger()
    assert shown[:4] == [str(told[name]) for name in ("fired", "hit", "wasted", "withheld")]
    assert shown[4] == f"{told['lead_s']['median']:.2f} s"
    entries = page.value(f"[...{SHADOW}.querySelectorAll('li')].map((one) => one.dataset.kind)")
    assert entries[0] == "hit"
    drawn = page.value(
        f"(() => {{ const canvas = {SHADOW}.querySelector('canvas');"
        "const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);"
        "return data.some((one) => one > 0); })()"
    )
    assert drawn
    assert page.value("showOverlay().then((again) => again === hide)")
    page.value("hide()")
    assert page.value(f"{SHADOW} === undefined")
    page.move((750, 530), (100, 100), 0.2)
    assert page.value("document.querySelectorAll('canvas').length") == 0


def test_it_is_loaded_only_when_it_is_asked_for(page: IntentPage) -> None:
    loaded = "performance.getEntriesByType('resource').some(({ name }) => name.includes('overlay'))"
    assert page.value(loaded) is False
    page.value("showOverlay().then((hide) => hide())")
    assert page.value(loaded) is True
