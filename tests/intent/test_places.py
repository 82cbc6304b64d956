"""Places of a page that nobody registered: proposed, withdrawn, stored, forgotten."""

from __future__ import annotations

import pytest

from pointpred.errors import SourceError
from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

FOLLOW = """{ window.followed = onPlace(({ id, place, reason, p, signal }) => {
  heard.push({ id: String(id), reason, p, x: place.x, y: place.y, size: place.size, began: true });
  window.newest = signal;
  return () => heard.push({ id: String(id), began: false });
}, OPTIONS) }"""
LEFT, RIGHT = (150.0, 300.0), (750.0, 300.0)


def follow(page: IntentPage, options: str = "{}") -> None:
    page.value(FOLLOW.replace("OPTIONS", options))
    page.value("followed.ready")


def back_and_forth(page: IntentPage, count: int) -> None:
    for number in range(count):
        page.move(*((LEFT, RIGHT) if number % 2 == 0 else (RIGHT, LEFT)), 0.4)
        page.away()


def predicted(page: IntentPage) -> list[float]:
    return [
        float(x) for x in page.value("heard.filter((one) => one.reason === 'predicted').map(({ x }) => x)")
    ]


def test_a_place_fires_before_the_pointer_is_there(page: IntentPage) -> None:
    follow(page, "{ precision: 0.4 }")
    back_and_forth(page, 8)
    page.value("{ heard.length = 0 }")
    back_and_forth(page, 1)
    first = page.value("heard.find((one) => one.reason === 'predicted')")
    assert first["x"] == pytest.approx(750.0, abs=15.0)
    assert first["y"] == pytest.approx(300.0, abs=15.0)
    assert (first["size"] >= 16.0, first["p"] >= 0.4) == (True, True)
    page.value("followed.stop()")
    assert page.value("newest.aborted") is True
    assert page.value("heard.at(-1).began") is False
    page.value("{ heard.length = 0 }")
    back_and_forth(page, 1)
    assert page.value("heard.length") == 0


def test_what_is_stored_is_known_at_the_next_visit_and_can_be_forgotten(page: IntentPage) -> None:
    page.value("localStorage.clear()")
    follow(page, "{ precision: 0.4, store: 'me' }")
    back_and_forth(page, 8)
    page.value("followed.stop()")
    stored = page.value("localStorage.getItem('me')")
    assert stored == page.value("followed.person") != ""
    follow(page, "{ precision: 0.4, store: 'me' }")
    page.value("{ heard.length = 0 }")
    assert page.value("followed.person") == stored
    back_and_forth(page, 1)
    assert predicted(page) != []
    page.value("followed.forget()")
    assert page.value("[localStorage.getItem('me'), followed.person]") == [None, ""]
    page.value("{ heard.length = 0 }")
    back_and_forth(page, 1)
    assert predicted(page) == []
    page.value("{ followed.forget(); followed.stop() }")
    assert page.value("localStorage.getItem('me')") is None


def test_a_person_forgotten_in_another_tab_is_forgotten_here(page: IntentPage) -> None:
    page.value("localStorage.clear()")
    follow(page, "{ precision: 0.4, store: 'me' }")
    back_and_forth(page, 4)
    page.value("{ dispatchEvent(new Event('pagehide')) }")
    assert page.value("localStorage.getItem('me')") == page.value("followed.person") != ""
    page.value("{ window.tab = document.body.appendChild(document.createElement('iframe')) }")
    page.value("{ tab.contentWindow.localStorage.setItem('other', '1') }")
    page.value("{ tab.contentWindow.localStorage.removeItem('other') }")
    page.value("frames(3)")
    assert page.value("followed.person") != ""
    page.value("{ tab.contentWindow.localStorage.removeItem('me') }")
    page.wait("followed.person === ''")
    page.value("{ dispatchEvent(new Event('pagehide')); followed.stop() }")
    assert page.value("localStorage.getItem('me')") is None


def test_it_stops_where_nothing_can_be_stored(page: IntentPage) -> None:
    page.value("localStorage.clear()")
    follow(page, "{ precision: 0.4, store: 'me' }")
    back_and_forth(page, 8)
    page.value(
        "{ Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError') } }"
    )
    page.value("{ addEventListener('error', (event) => event.preventDefault()) }")
    page.value("followed.stop()")
    page.value("{ heard.length = 0 }")
    back_and_forth(page, 2)
    assert page.value("heard.length") == 0


def test_without_a_name_nothing_is_stored(page: IntentPage) -> None:
    page.value("localStorage.clear()")
    follow(page)
    back_and_forth(page, 2)
    page.value("followed.stop()")
    assert page.value("localStorage.length") == 0


def test_places_are_scrolled_with_the_page(page: IntentPage) -> None:
    page.value("{ document.body.style.height = '3000px' }")
    follow(page, "{ precision: 0.4 }")
    back_and_forth(page, 8)
    page.value("window.scrollTo(0, 100)")
    page.wait("window.scrollY === 100")
    page.value("frames(3)")
    page.value("{ heard.length = 0 }")
    page.move((150.0, 200.0), (750.0, 200.0), 0.4)
    first = page.value("heard.find((one) => one.reason === 'predicted')")
    assert (first["x"], first["y"]) == (pytest.approx(750.0, abs=15.0), pytest.approx(200.0, abs=15.0))
    page.value("followed.stop()")


def test_a_scroll_ends_the_movement_so_that_places_are_where_they_are_now(page: IntentPage) -> None:
    page.value("{ document.body.style.height = '3000px' }")
    follow(page, "{ precision: 0.4 }")
    back_and_forth(page, 8)
    page.value("addEventListener('scroll', () => { heard.length = 0 })")
    page.value("addEventListener('pointermove', ({ clientX }) => clientX > 400 && scrollTo(0, 100))")
    page.move((150.0, 300.0), (750.0, 200.0), 0.5)
    assert page.value("scrollY") == 100
    found = page.value("heard.filter(({ began, x }) => began && x > 500).map(({ y }) => y)")
    assert found
    assert found == pytest.approx([200.0] * len(found), abs=15.0)
    page.value("followed.stop()")


@pytest.mark.parametrize(
    ("call", "message"),
    [
        ("onPlace(3)", "onPlace needs a function to call, received 3"),
        (
            "onPlace(() => 0, { precison: 1 })",
            "unknown option precison; known: precision, page, ",
        ),
        ("onPlace(() => 0, { precision: 1 })", "precision must be a number in"),
        ("onPlace(() => 0, { page: 3 })", "page must be a string, received 3"),
    ],
)
def test_what_cannot_be_used_is_refused(page: IntentPage, call: str, message: str) -> None:
    with pytest.raises(SourceError, match=message):
        page.value(call)


@pytest.mark.parametrize(
    "broken",
    [
        "Object.defineProperty(window, 'localStorage', {"
        " get() { throw new DOMException('denied', 'SecurityError'); } })",
        "Storage.prototype.getItem = Storage.prototype.setItem = Storage.prototype.removeItem ="
        " () => { throw new DOMException('full', 'QuotaExceededError'); }",
    ],
)
def test_places_work_without_the_store(page: IntentPage, broken: str) -> None:
    page.make(f"{broken}; window.places = onPlace(() => {{}}, {{ store: 'x' }})")
    assert page.value("places.ready.then(() => 'ready')") == "ready"
    page.value("dispatchEvent(new StorageEvent('storage', { key: 'x', newValue: null }))")
    page.value("places.forget(); places.stop()")
    assert page.visitor.complaints() == []
