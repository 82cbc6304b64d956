"""Links whose pages are loaded ahead."""

from __future__ import annotations

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

LINK = """window.link = (id, left, href, more = {}) =>
  Object.assign(box(id, left, 500, 100, 60, 'a'), { href, ...more });"""
RULES = """[...document.querySelectorAll('script[type=speculationrules]')]
  .map((one) => JSON.parse(one.textContent))"""


def test_a_link_is_prefetched_once_by_speculation_rules(page: IntentPage, host: str) -> None:
    page.make(
        f"{LINK} link('a', 600, '/next.html#part'); link('b', 800, '/next.html'); prefetchLink('a', "
        f"{{ predictor: 'minimum-jerk' }})"
    )
    page.move((40, 40), (650, 530), 0.4)
    page.away()
    page.move((650, 530), (850, 530), 0.4)
    assert page.value(RULES) == [
        {"prefetch": [{"source": "list", "urls": [f"{host}/next.html"], "eagerness": "immediate"}]}
    ]
    assert page.ledger()["fired"] == 2


def test_links_that_must_not_be_loaded_are_left_out(page: IntentPage, host: str) -> None:
    page.make(
        f"{LINK} link('other', 600, 'http://elsewhere.example/'); link('file', 600, '/file.zip', "
        f"{{ download: '' }});"
        "file.setAttribute('download', ''); link('tab', 600, '/tab.html', { target: '_blank' });"
        "link('same', 600, location.href + '#part'); link('mail', 600, 'mailto:somebody@page.example');"
        "link('none', 600, '').removeAttribute('href');"
        "prefetchLink('a', { predictor: 'minimum-jerk' })"
    )
    page.move((40, 40), (650, 530), 0.4)
    assert page.value(RULES) == []
    assert page.ledger()["fired"] == 0, "what cannot be loaded is not fired"


def test_prerender_and_other_origins_are_choices(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('other', 600, 'http://elsewhere.example/');"
        "window.stopLink = prefetchLink(other, { predictor: 'minimum-jerk', action: 'prerender', "
        "crossOrigin: true })"
    )
    page.move((40, 40), (650, 530), 0.4)
    assert page.value(RULES) == [
        {"prerender": [{"source": "list", "urls": ["http://elsewhere.example/"], "eagerness": "immediate"}]}
    ]
    page.value("stopLink()")


def test_without_speculation_rules_a_link_element_asks(page: IntentPage, host: str) -> None:
    page.visitor.page.add_init_script("HTMLScriptElement.supports = () => false")
    again = IntentPage(page.visitor, host)
    again.make(f"{LINK} link('a', 600, '/next.html'); prefetchLink('a', {{ predictor: 'minimum-jerk' }})")
    again.move((40, 40), (650, 530), 0.4)
    assert again.value("[...document.querySelectorAll('link[rel=prefetch]')].map(({ href }) => href)") == [
        f"{host}/next.html"
    ]
