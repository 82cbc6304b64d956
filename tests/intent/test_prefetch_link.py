"""Links whose pages are loaded ahead."""

from __future__ import annotations

import pytest

from pointpred.errors import SourceError
from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

LINK = """window.link = (id, left, href, more = {}) =>
  Object.assign(box(id, left, 500, 100, 60, 'a'), { href, ...more });"""
RULES = """[...document.querySelectorAll('script[type=speculationrules]')]
  .map((one) => JSON.parse(one.textContent))"""


def test_a_link_is_prefetched_once_by_speculation_rules(page: IntentPage, host: str) -> None:
    page.make(
        "addEventListener('click', (event) => event.preventDefault());"
        f"{LINK} link('a', 600, '/next.html#part'); link('b', 800, '/next.html'); prefetchLink('a', "
        f"{{ predictor: 'minimum-jerk' }})"
    )
    page.move((40, 40), (650, 530), 0.4)
    page.away()
    page.move((650, 530), (850, 530), 0.4)
    assert page.value(RULES) == [
        {"prefetch": [{"source": "list", "urls": [f"{host}/next.html"], "eagerness": "immediate"}]}
    ]
    assert page.ledger()["fired"] == 1, "what was asked of the browser"
    page.visitor.click(850, 530)
    page.settle()
    assert page.ledger()["hit"] == 1, "the page was used, by whichever link"


def test_links_that_must_not_be_loaded_are_left_out(page: IntentPage, host: str) -> None:
    page.make(
        f"{LINK} link('other', 600, 'http://elsewhere.example/'); link('file', 600, '/file.zip', "
        f"{{ download: '' }});"
        "file.setAttribute('download', ''); link('tab', 600, '/tab.html', { target: '_blank' });"
        "link('same', 600, location.href + '#part'); link('mail', 600, 'mailto:somebody@page.example');"
        "link('none', 600, '').removeAttribute('href');"
        "link('out', 600, '/account/Log-Out?next=/'); link('off', 600, '/signoff.php');"
        "link('gone', 600, '/items/3/delete');"
        "link('bye', 600, '/?action=logout'); link('list', 600, '/mail/unsubscribe?id=3');"
        "link('quiet', 600, '/quiet.html').dataset.noPrefetch = '';"
        "prefetchLink('a', { predictor: 'minimum-jerk' })"
    )
    page.move((40, 40), (650, 530), 0.4)
    assert page.value(RULES) == []
    assert page.ledger()["fired"] == 0, "what cannot be loaded is not fired"


def test_prerender_and_other_origins_are_choices(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('other', 600, 'http://elsewhere.example/');"
        "window.stopLink = prefetchLink(other, { predictor: 'minimum-jerk', action: 'prerender', "
        "origins: ['http://elsewhere.example'] })"
    )
    page.move((40, 40), (650, 530), 0.4)
    assert page.value(RULES) == [
        {"prerender": [{"source": "list", "urls": ["http://elsewhere.example/"], "eagerness": "immediate"}]}
    ]
    page.value("stopLink()")


def cross(page: IntentPage, *places: float) -> list[str]:
    """Move the mouse over links, resting in each; returns the paths that the browser was asked for."""
    for x in places:
        page.move((40, 40), (x, 530), 0.3)
        page.away()
    asked: list[str] = page.value(
        f"{RULES}.map((one) => one.prefetch[0].urls[0].replace(location.origin, ''))"
    )
    return asked


def test_names_of_pages_that_only_mention_it_are_loaded(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('a', 300, '/docs/delete-a-branch.html'); link('b', 600, '/blog/removed.html');"
        "prefetchLink('a', { predictor: 'minimum-jerk' })"
    )
    assert cross(page, 350, 650) == ["/docs/delete-a-branch.html", "/blog/removed.html"]


def test_what_a_pattern_or_a_function_ignores_is_left_out(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('a', 100, '/cart/add'); link('b', 350, '/b.html', {{ rel: 'nofollow' }});"
        "link('c', 600, '/c.html'); const errors = window.errors = [];"
        "link('d', 850, '/d.html');"
        "const onError = ({ message }, firing) => errors.push([message, firing === null]);"
        "prefetchLink('a', { predictor: 'minimum-jerk', onError, ignore: ["
        r"/\/cart\//, ({ rel }) => rel === 'nofollow', (link, { pathname }) => {"
        " if (pathname === '/d.html') throw new Error('mine'); return false; }] })"
    )
    assert cross(page, 150, 400, 650, 900) == ["/c.html"]
    assert ["mine", True] in page.value("errors"), "what cannot be judged is left out, and no firing holds"


def test_a_global_pattern_ignores_every_page(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('a', 100, '/account/1'); link('b', 350, '/account/2'); link('c', 600, '/c.html');"
        "prefetchLink('a', { predictor: 'minimum-jerk', ignore: [/account/g, /nothing/y] })"
    )
    assert cross(page, 150, 400, 650, 150, 400) == ["/c.html"]
    assert page.visitor.complaints() == []


def test_an_address_that_is_taken_back_loads_nothing(page: IntentPage) -> None:
    page.make(
        "box('card', 300, 500); let isGone = false;"
        "prefetchLink('button', { predictor: 'minimum-jerk', href: () => (isGone ? null : '/card.html'),"
        " enabled: () => (isGone = true) })"
    )
    assert cross(page, 350) == []
    assert page.visitor.complaints() == []


def test_no_more_pages_than_the_limit_are_loaded(page: IntentPage) -> None:
    page.make(
        f"{LINK} for (const i of [1, 2, 3]) link(`a${{i}}`, 250 * i, `/${{i}}.html`);"
        "prefetchLink('a', { predictor: 'minimum-jerk', limit: 2 })"
    )
    assert cross(page, 300, 550, 800) == ["/1.html", "/2.html"]
    assert page.ledger()["fired"] == 2


def test_an_address_function_gives_any_element_a_page(page: IntentPage) -> None:
    page.make(
        "box('card', 300, 500).dataset.page = '/card.html#top'; box('none', 600, 500);"
        "prefetchLink('button', { predictor: 'minimum-jerk', href: ({ dataset }) => dataset.page })"
    )
    assert cross(page, 350, 650) == ["/card.html"]


def test_links_in_pictures_and_maps_count(page: IntentPage) -> None:
    page.make(
        "document.body.insertAdjacentHTML('beforeend', `<svg style='position:absolute;left:100px;top:500px'"
        " width=100 height=60><a href='/drawn.html'><rect width=100 height=60 /></a></svg>"
        "<map name=sea><area shape=rect coords='0,0,60,60' href='/west.html'>"
        "<area shape=circle coords='170,30,30' href='/east.html'>"
        "<area shape=poly coords='70,0,130,0,130,60,70,60' href='/mid.html'></map>"
        "<img usemap=#sea width=200 height=60 style='position:absolute;left:600px;top:500px'"
        " src=\"data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' width='200' height='60'/>\">`);"
        "addEventListener('click', (event) => event.preventDefault());"
        "window.stopAll = prefetchLink(document.querySelectorAll('a, area'), {"
        " predictor: 'minimum-jerk', threshold: 1, dwell_s: 0 })"
    )
    page.value("frames(10)")
    assert cross(page, 150, 630) == ["/drawn.html", "/west.html"]
    assert cross(page, 770) == ["/drawn.html", "/west.html", "/mid.html", "/east.html"]
    page.visitor.click(770, 530)
    page.settle()
    assert page.ledger()["hit"] == 1
    page.value("stopAll()")
    assert page.value("trackers.size") == 0


def test_one_that_is_no_link_leaves_none_registered(page: IntentPage) -> None:
    page.make(f"{LINK} link('first', 300, '/first.html'); box('bad', 500, 100)")
    with pytest.raises(SourceError, match='needed, received <button id="bad">'):
        page.value("prefetchLink('a, button', { predictor: 'minimum-jerk' })")
    assert page.value("trackers.size") == 0


def test_links_that_are_added_later_are_watched(page: IntentPage) -> None:
    page.make(
        f"{LINK} window.stopWatch = prefetchLink('a', {{ predictor: 'minimum-jerk', watch: true }});"
        "link('later', 300, '/later.html'); link('turned', 600, 'mailto:somebody@page.example')"
    )
    page.wait("trackers.size === 1")
    page.settle()
    assert cross(page, 350, 650) == ["/later.html"]
    page.make("turned.href = '/turned.html'")
    page.value("new Promise((done) => setTimeout(done, 200))")
    assert cross(page, 350, 650) == ["/later.html", "/turned.html"]
    page.value("later.remove()")
    page.value("new Promise((done) => setTimeout(done, 200))")
    page.value("stopWatch()")
    assert page.value("trackers.size") == 0
    page.make("link('last', 800, '/last.html')")
    page.value("new Promise((done) => setTimeout(done, 200))")
    assert page.value("trackers.size") == 0


def test_rules_make_room_so_that_every_page_is_asked_for(page: IntentPage) -> None:
    page.make(
        "for (let i = 0; i < 60; i += 1)"
        " box(`q${i}`, 10 + 95 * (i % 10), 200 + 60 * Math.floor(i / 10), 60, 40, 'a').href = `/n${i}.html`;"
        "prefetchLink('a', { predictor: 'minimum-jerk', dwell_s: 0 })"
    )
    for row in range(6):
        page.move((0, 220 + 60 * row), (990, 220 + 60 * row), 1.2)
        page.away()
    assert page.ledger()["fired"] == 60
    assert page.value(f"{RULES}.length") == 40


def test_pages_that_nobody_asked_for_are_not_remembered_for_good(page: IntentPage) -> None:
    assert page.value("""import('/pointpred/intent/pages.js').then(({ pageOf }) => {
      const [asked, other] = ['asked', 'other'].map(pageOf);
      asked.askedAt = performance.now();
      for (let i = 0; i < 1000; i += 1) pageOf(String(i));
      return [pageOf('asked') === asked, pageOf('other') === other]; })""") == [True, False]


def test_a_page_that_the_browser_has_forgotten_is_asked_for_again(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('a', 600, '/next.html'); prefetchLink('a', {{ predictor: 'minimum-jerk', again_s: 1 }})"
    )
    assert cross(page, 650, 650) == ["/next.html"]
    page.make("const now = performance.now(); performance.now = () => now + 301000")
    assert cross(page, 650) == ["/next.html"]
    assert page.ledger()["fired"] == 2


CHANGING = (
    "/cart/?remove_item=abc123&_wpnonce=1",
    "/wp-admin/post.php?post=3&action=trash",
    "/cart/add/3",
    "/cart?add=3",
    "/cart/?add-to-cart=3",
    "/addtocart?id=3",
    "/remove_from_cart/3",
    "/cart/change?line=1&quantity=0",
    "/page?action=rollback",
    "/delete_item",
    "/items/3/delete",
    "/exit",
    "/end-session",
    "/log/out",
    "/user_logout",
    "/index.php?route=account/logout",
)
KEPT = (
    "/page?next=/logout",
    "/page?next=https%3A%2F%2Fa.example%2Flogout",
    "/knowledge/how-to-log-out",
    "/docs/delete-a-branch.html",
    "/blog/removed.html",
    "/blog/exits.html",
    "/cart/address",
    "/cart",
    "/docs/adding-carts",
)


def judged(page: IntentPage, *links: str) -> list[str]:
    """Of links in HTML, the addresses that are registered, so that they can be loaded."""
    page.make(
        "window.add = (html) => document.body.insertAdjacentHTML('beforeend', html);"
        "window.taken = []; const seen = [];"
        f"for (const html of {list(links)!r}) add(html);"
        "prefetchLink('a', { ignore: (link) => { taken.push(link.getAttribute('href')); return false; } })"
    )
    taken: list[str] = page.value("[...new Set(taken)]")
    return taken


def test_addresses_that_change_something_are_left_out(page: IntentPage) -> None:
    links = [f"<a href='{address}'>a</a>" for address in CHANGING + KEPT]
    assert judged(page, *links) == list(KEPT)


def test_links_that_ask_otherwise_than_by_a_plain_get_are_left_out(page: IntentPage, host: str) -> None:
    assert judged(
        page,
        "<a href='/a' data-method=delete>a</a>",
        "<a href='/b' data-turbo-method=post>a</a>",
        f"<a href='{host.replace('http://', 'http://user:pw@')}/c'>a</a>",
        "<a href='/d' data-turbo-method=get>a</a>",
    ) == ["/d"]


def test_a_link_that_is_crossed_is_not_loaded(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('a', 600, '/next.html'); const {{ setTimeout: before }} = window;"
        "window.setTimeout = (call, ms) => before(call, ms === 65 ? 2000 : ms);"  # the machine may be slow
        "prefetchLink('a', { predictor: 'minimum-jerk', threshold: 1 })"
    )
    page.move((650, 40), (650, 690), 0.3)
    assert page.value(RULES) == []
    page.away()
    page.move((650, 690), (650, 530), 0.3)
    page.wait("document.querySelector('script[type=speculationrules]') !== null")  # where the pointer stays


def test_an_address_that_is_none_is_left_out(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('bad', 300, 'http://'); link('good', 600, '/good.html');"
        "prefetchLink('a', { predictor: 'minimum-jerk', watch: true })"
    )
    assert cross(page, 350, 650) == ["/good.html"]
    assert page.visitor.complaints() == []


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ("{ origins: ['shop.example'] }", "origins .* shop.example"),
        ("{ origins: 'mailto:a@b.example' }", "origins .* mailto:a@b.example"),
        ("{ limit: '1' }", "limit must be a number"),
        ("{ policy: 'highlight' }", "prefetchLink takes no policy"),
        ("null", "options must be an object, received null"),
    ],
)
def test_options_that_cannot_be_used_are_named(page: IntentPage, options: str, message: str) -> None:
    with pytest.raises(SourceError, match=message):
        page.value(f"prefetchLink('a', {options})")


def test_an_origin_is_that_of_its_address(page: IntentPage) -> None:
    page.make(
        f"{LINK} link('other', 300, 'http://elsewhere.example/a');"
        "prefetchLink('a', { predictor: 'minimum-jerk', origins: 'HTTP://elsewhere.example/shop/' })"
    )
    assert cross(page, 350) == ["http://elsewhere.example/a"]


def test_the_target_of_all_links_counts(page: IntentPage) -> None:
    assert judged(page, "<base target=_blank>", "<a href='/a'>a</a>", "<a href='/b' target=_self>b</a>") == [
        "/b"
    ]


def test_links_without_an_id_have_the_name_of_their_path(page: IntentPage) -> None:
    page.make(
        "document.body.insertAdjacentHTML('beforeend', `<a href='/next.html?page=2'"
        " style='position:absolute;left:600px;top:500px;width:100px;height:60px'>a</a>`);"
        "prefetchLink('a', { predictor: 'minimum-jerk' })"
    )
    cross(page, 650)
    assert list(page.ledger()["names"]) == ["/next.html"]


def test_without_speculation_rules_a_link_element_asks(page: IntentPage, host: str) -> None:
    page.visitor.page.add_init_script("HTMLScriptElement.supports = () => false")
    again = IntentPage(page.visitor, host)
    again.make(f"{LINK} link('a', 600, '/next.html'); prefetchLink('a', {{ predictor: 'minimum-jerk' }})")
    again.move((40, 40), (650, 530), 0.4)
    assert again.value("[...document.querySelectorAll('link[rel=prefetch]')].map(({ href }) => href)") == [
        f"{host}/next.html"
    ]


def test_two_link_elements_load_at_a_time(page: IntentPage, host: str) -> None:
    page.visitor.page.add_init_script("HTMLScriptElement.supports = () => false")
    page.visitor.page.route("**/slow*.html", lambda route: None)  # never answered
    again = IntentPage(page.visitor, host)
    again.make(
        f"{LINK} for (const i of [1, 2, 3]) link(`a${{i}}`, 250 * i, `/slow${{i}}.html`);"
        "prefetchLink('a', { predictor: 'minimum-jerk' })"
    )
    cross(again, 300, 550, 800)
    links = "[...document.querySelectorAll('link[rel=prefetch]')]"
    assert again.value(f"{links}.length") == 2
    again.value(f"{links}[0].dispatchEvent(new Event('load'))")
    assert again.value(f"{links}.length") == 3
    page.visitor.page.unroute_all()


def test_a_load_that_tells_nothing_holds_no_place_for_good(page: IntentPage, host: str) -> None:
    page.visitor.page.add_init_script("HTMLScriptElement.supports = () => false")
    page.visitor.page.route("**/slow*.html", lambda route: None)  # never answered
    again = IntentPage(page.visitor, host)
    again.make(
        f"{LINK} for (const i of [1, 2, 3]) link(`a${{i}}`, 250 * i, `/slow${{i}}.html`);"
        "window.timers = []; const { setTimeout: before } = window;"
        "window.setTimeout = (call, ms) => (ms >= 1000 ? timers.push([call, ms]) : before(call, ms));"
        "prefetchLink('a', { predictor: 'minimum-jerk' })"
    )
    cross(again, 300, 550, 800)
    links = "[...document.querySelectorAll('link[rel=prefetch]')]"
    again.value(f"{{ for (const one of {links}) one.remove(); }}")
    again.value("{ for (const [call, ms] of timers.splice(0)) if (ms === 30000) call(); }")
    assert again.value(f"{links}.map(({{ href }}) => href)") == [f"{host}/slow3.html"]
    page.visitor.page.unroute_all()


def test_links_that_are_spent_are_removed(page: IntentPage, host: str) -> None:
    page.visitor.page.add_init_script("HTMLScriptElement.supports = () => false")
    again = IntentPage(page.visitor, host)
    again.make(
        f"{LINK} link('a', 300, '/1.html'); link('b', 600, '/2.html');"
        "prefetchLink('a', { predictor: 'minimum-jerk' })"
    )
    cross(again, 350)
    again.make("const now = performance.now(); performance.now = () => now + 301000")
    cross(again, 650)
    assert again.value("[...document.querySelectorAll('link[rel=prefetch]')].map(({ href }) => href)") == [
        f"{host}/2.html"
    ]


def test_links_are_left_alone_where_nothing_can_be_loaded_ahead(page: IntentPage, host: str) -> None:
    page.visitor.page.add_init_script(
        "HTMLScriptElement.supports = () => false; DOMTokenList.prototype.supports = () => false"
    )
    again = IntentPage(page.visitor, host)
    again.make(f"{LINK} link('a', 600, '/next.html'); window.stopAll = prefetchLink('a')")
    assert again.value("trackers.size") == 0
    again.move((40, 40), (650, 530), 0.4)
    assert again.ledger()["fired"] == 0
    again.value("stopAll()")
