"""What the keyboard is about to reach, and what has the focus."""

from __future__ import annotations

from tests.intent.page import START, IntentPage
from tests.server import browser

pytestmark = browser.needed

FOUR = "for (let i = 0; i < 5; i += 1) box(`b${i}`, 100, 40 + 80 * i);"


def test_tab_fires_what_the_next_presses_reach(page: IntentPage) -> None:
    page.make(f"{FOUR} for (const one of document.querySelectorAll('button')) watch(one)")
    page.visitor.press("Tab")
    page.wait("heard.length >= 3")
    assert sorted(page.said()) == ["b0 focus", "b1 tab", "b2 tab"]
    page.visitor.press("Tab")
    page.wait("heard.length >= 4")
    assert page.said()[3:] == ["b3 tab"]


def test_how_far_ahead_is_a_choice(page: IntentPage) -> None:
    page.make(
        f"{FOUR} watch(b1, {{ keyboard: 0 }}); watch(b2, {{ keyboard: 1 }}); watch(b3, {{ keyboard: 3 }})"
    )
    page.visitor.press("Tab")
    page.wait("heard.length >= 1")
    page.settle()
    assert page.said() == ["b3 tab"]
    page.visitor.press("Tab")
    page.wait("heard.length >= 3")
    assert sorted(page.said()[1:]) == ["b1 focus", "b2 tab"]


def test_the_order_is_the_browsers(page: IntentPage) -> None:
    """A positive tabindex comes first; what is disabled, hidden,
    inert or taken out of the order is left out."""
    page.make(
        "for (const id of ['first', 'off', 'gone', 'inert', 'out', 'second']) box(id, 100, 40);"
        "box('early', 100, 500).tabIndex = 1; off.disabled = true; gone.style.visibility = 'hidden';"
        "document.getElementById('inert').inert = true; out.tabIndex = -1;"
        "for (const one of document.querySelectorAll('button')) watch(one)"
    )
    page.visitor.press("Tab")
    page.wait("heard.length >= 3")
    page.settle()
    assert sorted(page.said()) == ["early focus", "first tab", "second tab"]


def test_what_says_that_it_is_disabled_does_not_fire(page: IntentPage) -> None:
    """It can have the focus, so that it counts as a press; what takes no pointer events fires."""
    page.make(
        "for (const id of ['off', 'tinted', 'beyond', 'bare']) box(id, 100, 40);"
        "bare.style.pointerEvents = 'none';"
        "for (const one of [off, tinted, beyond]) one.setAttribute('aria-disabled', 'true');"
        "watch(off); watch(tinted, { policy: 'highlight' }); watch(beyond); watch(bare)"
    )
    for _ in range(4):
        page.visitor.press("Tab")
        page.settle()
    page.wait("said().length >= 1")
    assert page.said() == ["bare tab"]


def test_a_card_around_the_link_counts(page: IntentPage) -> None:
    page.make(
        "box('card', 100, 40, 200, 100, 'div').innerHTML = '<a id=link href=#there>there</a>'; watch(card);"
        "watch(card, { policy: 'highlight' })"
    )
    page.visitor.press("Tab")
    page.wait("heard.length >= 2")
    assert sorted(page.said()) == ["card focus", "card focus"]
    page.value("link.blur()")
    page.wait("said().includes('card ended')")


def test_the_mouse_moves_no_focus(page: IntentPage) -> None:
    page.make("watch(box('far', 600, 500)); box('other', 100, 100)")
    page.visitor.click(150, 130)
    page.settle()
    assert page.said() == []


def test_what_cannot_be_loaded_is_told_once_and_tried_again(page: IntentPage) -> None:
    page.visitor.page.route("**/later.js", lambda route: route.abort())
    page.visitor.open(page.visitor.page.url)
    page.value(START.replace(', "later"', ""))
    page.value(
        "{ window.told = []; for (const name of ['error', 'unhandledrejection'])"
        " addEventListener(name, (event) => { told.push(event.type); event.preventDefault(); }) }"
    )
    page.make("for (const i of [0, 1, 2, 3, 4]) watch(box(`b${i}`, 60 + 180 * i, 560), { keyboard: 1 })")
    for _ in range(2):
        page.visitor.press("Tab")
        page.value("frames(10)")
    assert page.said() == ["b0 focus", "b1 focus"]
    assert page.value("told") == ["error"]
    page.visitor.page.unroute_all()
    page.visitor.press("Tab")
    page.wait("said().includes('b3 tab')")
