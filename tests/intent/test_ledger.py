"""The ledger: what fired, what was used, what it cost, how early."""

from __future__ import annotations

import pytest

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed


def test_a_click_is_a_hit_with_its_lead_and_the_others_are_waste(page: IntentPage) -> None:
    page.make(
        "window.told = []; window.stopTelling = onLedger((entry) => told.push(entry));"
        "for (let i = 0; i < 6; i += 1) watch(box(`b${i}`, 100 + 100 * i, 300, 90, 60), { "
        "name: i < 3 ? 'near' : 'far' })"
    )
    page.move((50, 330), (645, 330), 0.5)
    assert len(page.said()) == 6
    page.visitor.click(645, 330)
    page.settle()
    told = page.ledger()
    assert (told["fired"], told["hit"], told["wasted"], told["withheld"]) == (6, 1, 5, 0)
    assert told["names"]["near"]["hit"] == 0
    assert told["names"]["far"]["hit"] == 1
    fired = next(one for one in page.value("heard") if one["id"] == "b5")
    hit = page.value(
        "told.filter(({ kind }) => kind === 'hit').map(({ name, t, lead_s, reason, "
        "policy }) => [name, t, lead_s, reason, policy])"
    )
    assert hit == [["far", pytest.approx(fired["t"] + hit[0][2]), hit[0][2], fired["reason"], "prefetch"]]
    assert told["lead_s"]["count"] == 1
    assert told["lead_s"]["least"] == told["lead_s"]["median"] == told["lead_s"]["most"] == hit[0][2] > 0.0
    page.visitor.click(645, 330)
    page.settle()
    assert page.ledger()["hit"] == 1, "a firing is used once"
    page.visitor.click(145, 330)
    page.settle()
    told = page.ledger()
    assert (told["hit"], told["wasted"]) == (2, 4), "what is used late is used"
    page.make("stopTelling(); watch(box('another', 700, 600))")
    count = page.value("told.length")
    page.move((145, 330), (750, 630), 0.4)
    assert page.value("told.length") == count


def test_a_key_that_acts_as_a_click_is_a_hit(page: IntentPage) -> None:
    page.make("watch(box('first', 100, 100))")
    page.visitor.press("Tab")
    page.wait("heard.length === 1")
    page.value("first.click()")
    assert page.ledger()["hit"] == 1


def test_memory_is_bounded(page: IntentPage) -> None:
    page.make(
        "window.done = import('/pointpred/intent/registration.js').then(({ ledger: book }) => {"
        " for (let i = 0; i < 3000; i += 1) { const element = document.createElement('b');"
        "  const about = { element: new WeakRef(element), name: `n${i}`, policy: 'prefetch' };"
        "  const one = { about, subject: () => element };"
        "  book.fire(one, { reason: 'predicted', p: 1, t: i });"
        "  book.activate(one, i + i / 1000); } })"
    )
    page.value("done")
    told = page.ledger()
    assert told["fired"] == told["hit"] == 3000
    assert len(told["names"]) == 500
    assert told["lead_s"]["count"] == 1000
    assert told["lead_s"]["least"] == pytest.approx(2.0)
    assert told["lead_s"]["median"] == pytest.approx(2.4995)


def test_a_listener_that_throws_keeps_no_callback_from_being_called(page: IntentPage) -> None:
    page.make("onLedger(() => { throw new Error('of the listener'); }); watch(box('goal', 600, 500))")
    page.move((40, 40), (650, 530), 0.5)
    assert len(page.said()) == 1


def test_the_end_of_a_highlight_leaves_the_prefetch_of_the_same_element(page: IntentPage) -> None:
    page.make("""const goal = box('goal', 600, 500);
      onIntent(goal, ({ signal }) => { window.prefetched = signal; }, { predictor: 'minimum-jerk' });
      watch(goal, { policy: 'highlight' })""")
    page.move((40, 40), (650, 530), 0.5)
    page.move((650, 530), (40, 40), 0.5)
    page.wait("said().includes('goal ended')")
    assert page.value("prefetched.aborted") is False
    assert page.ledger()["withdrawn"] >= 1  # a busy machine moves in jerks


def test_what_was_predicted_and_what_was_entered_are_apart(page: IntentPage) -> None:
    page.make("watch(box('crossed', 300, 300), { threshold: 1 }); watch(box('goal', 600, 300))")
    page.move((40, 330), (650, 330), 0.5)
    page.visitor.click(650, 330)
    page.settle()
    told = page.ledger()
    assert told["reasons"] == {
        "predicted": {"fired": 1, "hit": 1, "wasted": 0},
        "entered": {"fired": 1, "hit": 0, "wasted": 1},
    }
    assert told["names"]["crossed"]["reasons"] == {"entered": {"fired": 1, "hit": 0, "wasted": 1}}


def test_the_right_button_opens_a_menu_and_the_middle_one_a_link(page: IntentPage) -> None:
    page.make("watch(box('goal', 600, 300))")
    page.move((40, 40), (650, 330), 0.4)
    for button, buttons, hit in (("right", 2, 0), ("middle", 4, 1)):
        for kind, pressed in (("mousePressed", buttons), ("mouseReleased", 0)):
            page.visitor.hand.call(
                "Input.dispatchMouseEvent",
                type=kind,
                x=650,
                y=330,
                button=button,
                buttons=pressed,
                clickCount=1,
            )
        page.settle()
        assert page.ledger()["hit"] == hit
