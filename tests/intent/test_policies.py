"""Prefetch fires several and withdraws nothing; highlight has one at a time, and ends."""

from __future__ import annotations

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed


def test_a_highlight_ends_when_the_movement_turns_to_another(page: IntentPage) -> None:
    page.make(
        "watch(box('west', 100, 500), { policy: 'highlight' }); watch(box('east', 800, 500), { "
        "policy: 'highlight' })"
    )
    for start, end in [((500, 100), (850, 530)), ((850, 530), (150, 530)), ((150, 530), (150, 300))]:
        page.move(start, end, 0.5)
        page.away()
    said = page.said()
    assert said[0].split()[0] == "east"
    assert {"east ended", "west ended"} <= set(said)
    begun: list[str] = []
    for name, word in (one.split() for one in said):
        if word == "ended":
            begun.remove(name)
        else:
            begun.append(name)
        assert len(begun) <= 2
    assert begun == []


def test_what_the_page_chooses_before_highlights_are_loaded_is_highlighted(page: IntentPage) -> None:
    loaded = "performance.getEntriesByType('resource').some(({ name }) => name.endsWith('highlights.js'))"
    page.make("watch(box('plain', 100, 500))")
    assert page.value(loaded) is False
    page.make("watch(box('goal', 600, 500), { policy: 'highlight' }); goal.focus()")
    page.wait("said().length > 0")
    page.value("goal.blur()")
    assert page.said() == ["goal focus", "goal ended"]


def test_a_prefetch_is_not_withdrawn(page: IntentPage) -> None:
    page.make("watch(box('west', 100, 500)); watch(box('east', 800, 500))")
    for start, end in [((500, 100), (850, 530)), ((850, 530), (150, 530)), ((150, 530), (150, 300))]:
        page.move(start, end, 0.5)
        page.away()
    assert sorted(one.split()[0] for one in page.said()) == ["east", "west"]
    assert not any("ended" in one for one in page.said())
    assert page.ledger()["withdrawn"] == 0


def test_the_signal_of_a_highlight_is_aborted_when_it_ends(page: IntentPage) -> None:
    page.make("watch(box('lit', 600, 300), { policy: 'highlight' })")
    page.move((40, 40), (650, 330), 0.4)
    assert page.value("signals.lit.aborted") is False
    page.away()
    page.move((650, 330), (40, 600), 0.4)
    assert page.value("signals.lit.aborted") is True
    assert page.said()[-1] == "lit ended"


def test_stopping_ends_a_highlight(page: IntentPage) -> None:
    page.make("watch(box('lit', 600, 300), { policy: 'highlight' })")
    page.move((40, 40), (650, 330), 0.4)
    page.make("stops.lit()")
    assert page.said()[-1] == "lit ended"
    assert page.value("signals.lit.aborted") is True


def test_a_highlight_ends_when_its_element_goes(page: IntentPage) -> None:
    page.make("watch(box('lit', 700, 300), { policy: 'highlight' })")
    page.move((40, 40), (600, 300), 0.4)  # short of it
    assert page.said() == ["lit predicted"]
    page.make("lit.remove()")
    page.wait("said().at(-1) === 'lit ended'")


def test_every_target_on_the_way_has_fired_when_the_pointer_is_in_it(page: IntentPage) -> None:
    page.make("for (let i = 0; i < 8; i += 1) watch(box(`b${i}`, 100 + 100 * i, 300, 90, 60))")
    page.move((50, 330), (950, 330), 0.6)
    assert {one.split()[0] for one in page.said()} == {f"b{i}" for i in range(8)}
    assert len(page.said()) == 8


def test_a_highlight_ends_when_the_pointer_stops_beside_its_element(page: IntentPage) -> None:
    page.make("watch(box('lit', 700, 300), { policy: 'highlight' }); watch(box('near', 400, 300))")
    page.move((40, 40), (600, 300), 0.4)
    assert "lit predicted" in page.said()
    page.wait("said().at(-1) === 'lit ended'", patience_s=5.0)
    assert page.value("signals.lit.aborted")


def test_what_an_async_callback_returns_cleans_up(page: IntentPage) -> None:
    page.make(
        "window.cleaned = 0; window.open = []; box('lit', 600, 300);"
        "onIntent(lit, async () => { await new Promise((done) => open.push(done));"
        " return () => { cleaned += 1; }; },"
        " { predictor: 'minimum-jerk', policy: 'highlight' })"
    )
    page.move((40, 40), (650, 330), 0.4)
    page.value("open.shift()()")
    assert page.value("cleaned") == 0
    page.away()
    page.move((650, 330), (40, 600), 0.4)
    assert page.value("cleaned") == 1, "it is called when the highlight ends"
    page.away()
    page.move((40, 600), (650, 330), 0.4)
    page.away()
    page.move((650, 330), (40, 600), 0.4)
    assert page.value("cleaned") == 1
    page.value("open.shift()()")
    page.wait("cleaned === 2")  # it comes when the highlight has ended: at once


def test_attributes_carry_the_state_where_asked_for(page: IntentPage) -> None:
    marks = "[lit.getAttribute('data-target'), lit.getAttribute('data-predicted')]"
    page.make(
        "watch(box('lit', 600, 300), { policy: 'highlight', attributes: true });"
        "watch(box('plain', 300, 300), { policy: 'highlight' })"
    )
    page.move((40, 40), (640, 330), 0.4)
    assert page.value(marks) == ["predicted", ""]
    page.away()
    page.move((640, 330), (350, 330), 0.4)
    page.wait(f"{marks}.every((one) => one === null)")
    assert page.value("plain.hasAttribute('data-target')") is False


def test_highlights_that_cannot_be_loaded_are_told_once_and_tried_again(page: IntentPage) -> None:
    page.visitor.page.route("**/highlights.js", lambda route: route.abort())
    page.value(
        "{ window.told = []; for (const name of ['error', 'unhandledrejection'])"
        " addEventListener(name, (event) => { told.push(event.type); event.preventDefault(); }) }"
    )
    page.make("watch(box('goal', 600, 500), { policy: 'highlight' })")
    page.move((40, 40), (650, 530), 0.4)
    page.move((650, 530), (40, 40), 0.4)
    assert page.said() == []
    assert page.value("told") == ["error"]
    page.visitor.page.unroute_all()
    for _ in range(2):
        page.away()
        page.move((40, 40), (650, 530), 0.4)
        page.away()
        page.move((650, 530), (40, 40), 0.4)
    assert "goal ended" in page.said()
