"""Elements that move, come, go, are scrolled, hidden or covered."""

from __future__ import annotations

from tests.intent.page import IntentPage
from tests.server import browser
from tests.server.page_browser import until

pytestmark = browser.needed


def test_a_moved_element_fires_where_it_is_now(page: IntentPage) -> None:
    page.make("watch(box('goal', 100, 500), { threshold: 1 })")
    page.make("goal.style.left = '700px'")
    page.wait("measured('goal').row[0] === 750")  # although nothing else happens
    page.move((40, 40), (150, 530), 0.3)
    assert page.said() == []
    page.away()
    page.move((150, 530), (750, 530), 0.3)
    assert page.said() == ["goal entered"]


def test_an_element_that_moves_all_the_time_is_followed(page: IntentPage) -> None:
    page.make(
        "watch(box('goal', 600, 500), { threshold: 1 });"
        "window.rise = (px) => { goal.style.transform = `translateY(${-px}px)`; "
        "if (px < 300) requestAnimationFrame(() => rise(px + 15)); }"
    )
    page.value("rise(0)")  # 20 frames, of the 30 of the movement
    page.move((40, 40), (650, 230), 0.6)
    assert page.said() == ["goal entered"]


def test_a_removed_element_rests_until_it_comes_back(page: IntentPage) -> None:
    page.make("window.goal = box('goal', 600, 500); watch(goal); goal.remove()")
    page.move((40, 40), (650, 530), 0.4)
    assert page.said() == []
    page.away()
    page.make("document.body.append(goal)")
    page.move((650, 530), (40, 40), 0.4)
    page.away()
    page.move((40, 40), (650, 530), 0.4)
    assert len(page.said()) == 1


def test_a_scrolled_element_is_where_the_scroll_has_put_it(page: IntentPage) -> None:
    page.make(
        "document.body.style.height = '3000px'; watch(box('goal', 600, 1500), { threshold: 1, "
        "scroll: 'none' })"
    )
    page.move((40, 40), (650, 530), 0.3)
    assert page.said() == []
    page.make("scrollTo(0, 1000)")
    page.away()
    page.move((40, 40), (650, 530), 0.3)
    assert page.said() == ["goal entered"]


def test_hidden_elements_do_not_count(page: IntentPage) -> None:
    page.make(
        "watch(box('none', 600, 500)); none.style.display = 'none';"
        "watch(box('unseen', 600, 500)); unseen.style.visibility = 'hidden';"
        "watch(box('clear', 600, 500)); clear.style.opacity = '0';"
        "watch(box('empty', 600, 500, 0, 0, 'div'))"
    )
    page.move((40, 40), (590, 490), 0.4)
    assert page.said() == []
    page.make("clear.style.opacity = '1'")
    page.wait("!measured('clear').isHidden")
    page.move((590, 490), (40, 40), 0.4)
    page.away()
    page.move((40, 40), (590, 490), 0.4)
    assert page.said() == ["clear predicted"]


def test_an_element_below_a_dialog_does_not_fire(page: IntentPage) -> None:
    page.make(
        "watch(box('below', 600, 500)); watch(box('lit', 600, 300), { policy: 'highlight' });"
        "const dialog = document.createElement('dialog'); dialog.style = 'width: 900px; height: 600px';"
        "document.body.append(dialog); dialog.showModal(); window.dialog = dialog"
    )
    page.move((40, 40), (650, 530), 0.4)
    page.away()
    page.move((650, 530), (650, 330), 0.4)
    assert page.said() == []
    page.make("dialog.close()")
    page.away()
    page.move((650, 330), (650, 530), 0.4)
    assert "below" in {one.split()[0] for one in page.said()}


def test_elements_that_nobody_holds_are_given_back(page: IntentPage) -> None:
    page.make(
        "for (let i = 0; i < 50; i += 1) { const one = box(`x${i}`, 100, 100); watch(one); "
        "stops = {}; signals = {};"
        "(window.references ??= []).push(new WeakRef(one)); }"
        "document.body.replaceChildren()"
    )

    def remaining() -> int:
        page.visitor.hand.call("HeapProfiler.collectGarbage")
        return int(page.value("references.filter((one) => one.deref()).length"))

    until(lambda: remaining() <= 1, "the elements to be collected")


def test_nothing_is_held_after_the_last_stop(page: IntentPage) -> None:
    page.make(
        "const link = (id, left) => Object.assign(box(id, left, 500, 100, 60, 'a'), { href: `/${id}.html` });"
        "const given = { predictor: 'minimum-jerk' };"
        "window.stopAll = [prefetchLink([link('fired', 600), link('other', 300)], given),"
        " onIntent(box('plain', 100, 300), () => 0, { ...given, again_s: 0.1 })];"
    )
    page.move((40, 40), (650, 530), 0.4)
    page.away()
    page.move((650, 530), (150, 330), 0.4)
    assert page.value("ledger()")["fired"] >= 2
    page.make(
        "window.references = [fired, other, plain].map((one) => [one.id, new WeakRef(one)]);"
        "for (const stop of stopAll) stop(); window.stopAll = null; document.body.replaceChildren()"
    )
    page.move((150, 330), (160, 340), 0.2)

    def remaining() -> list[str]:
        page.visitor.hand.call("HeapProfiler.collectGarbage")
        kept: list[str] = page.value("references.filter(([, one]) => one.deref()).map(([id]) => id)")
        return kept

    until(lambda: remaining() == [], "the elements to be collected", 20.0)
