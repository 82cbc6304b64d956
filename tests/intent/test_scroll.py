"""What a scroll is about to bring."""

from __future__ import annotations

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

SCROLL = """new Promise((done) => { let at = FROM; const next = () => {
  at += 12; document.scrollingElement.scrollTop = at; if (at < TO) requestAnimationFrame(next);
    else done(); }; next(); })"""


def scroll(page: IntentPage, start: int, end: int) -> None:
    page.value(SCROLL.replace("FROM", str(start)).replace("TO", str(end)))
    page.settle()


def test_what_comes_under_the_pointer_fires_before_it_is_there(page: IntentPage) -> None:
    page.make(
        "document.body.style.height = '5000px';"
        "watch(box('under', 300, 560, 200), { threshold: 1 });"
        "onIntent(under, () => heard.push({ id: 'never', reason: '', began: true }), { "
        "threshold: 1, scroll: 'none', predictor: 'minimum-jerk' });"
        "watch(box('aside', 700, 560), { threshold: 1 })"
    )
    page.move((20, 20), (440, 300), 0.3)
    page.away()
    scroll(page, 0, 240)  # the upper edge ends 20 px below the pointer
    assert page.said() == ["under scroll"]


def test_a_container_that_scrolls_counts_as_the_page_does(page: IntentPage) -> None:
    page.make(
        "const list = box('list', 300, 100, 400, 500, 'div'); list.style.overflow = 'auto';"
        "list.innerHTML = '<button id=row "
        'style="position:absolute;top:460px;width:300px;height:40px">row</button><div '
        'style="height:3000px"></div>\';'
        "watch(row, { threshold: 1 })"
    )
    page.move((20, 20), (450, 300), 0.3)
    page.away()
    page.value(SCROLL.replace("document.scrollingElement", "list").replace("FROM", "0").replace("TO", "240"))
    page.settle()
    assert page.said() == ["row scroll"]


def test_what_is_about_to_come_into_view_fires_where_asked_for(page: IntentPage) -> None:
    page.make(
        "document.body.style.height = '5000px'; watch(box('soon', 100, 800), { scroll: 'view' });"
        "watch(box('later', 100, 2500), { scroll: 'view' }); watch(box('other', 400, 800))"
    )
    assert page.said() == []
    scroll(page, 0, 24)
    assert page.said() == ["soon scroll"]
    scroll(page, 24, 1900)
    assert page.said() == ["soon scroll", "later scroll"]


def test_what_was_in_view_before_the_scroll_has_not_come(page: IntentPage) -> None:
    page.make(
        "document.body.style.height = '5000px'; watch(box('seen', 100, 100), { scroll: 'view' });"
        "watch(box('soon', 100, 800), { scroll: 'view' })"
    )
    scroll(page, 0, 12)
    assert page.said() == ["soon scroll"]
    page.make("watch(box('late', 400, 200), { scroll: 'view' })")
    scroll(page, 12, 24)
    assert page.said() == ["soon scroll"], "it was in view when it was registered"
    scroll(page, 24, 1900)
    scroll(page, 1900, 1912)
    page.value("scrollTo(0, 0)")
    page.wait("said().includes('seen scroll')")  # it has gone and comes back
