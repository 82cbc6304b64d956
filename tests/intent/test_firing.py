"""When a registered element fires, and when it does so again."""

from __future__ import annotations

import pytest

from pointpred.errors import SourceError
from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

ROW = "for (const i of [0, 1, 2, 3, 4]) box(`b${i}`, 60 + 180 * i, 560);"


def test_it_fires_before_the_pointer_is_there_and_says_why(page: IntentPage) -> None:
    page.make(f"{ROW} for (const i of [0, 1, 2, 3, 4]) watch(document.getElementById(`b${{i}}`))")
    page.move((40, 40), (470, 590))
    heard = page.value("heard")
    assert [one["id"] for one in heard] == ["b2"]
    assert heard[0]["reason"] == "predicted"
    assert 0.0 < heard[0]["p"] <= 1.0
    assert heard[0]["remaining_s"] is None or 0.0 < heard[0]["remaining_s"] < 0.5
    assert 0.0 < heard[0]["t"] < page.value("performance.now() / 1000")


def test_one_that_is_not_predicted_fires_when_the_pointer_goes_in(page: IntentPage) -> None:
    page.make("watch(box('wide', 0, 300, 1000, 40), { threshold: 1 })")
    page.move((500, 40), (500, 600), 0.3)
    assert page.said() == ["wide entered"]


def test_it_fires_once_unless_asked_for_more(page: IntentPage) -> None:
    page.make("watch(box('once', 700, 500)); watch(box('each', 200, 500), { once: false })")
    for _ in range(2):
        page.move((450, 40), (750, 530), 0.4)
        page.away()
        page.move((750, 530), (250, 530), 0.4)
        page.away()
    said = page.said()
    assert said.count("once predicted") + said.count("once entered") == 1
    assert sum(one.startswith("each") for one in said) >= 2


def test_what_a_firing_began_ends_before_the_next(page: IntentPage) -> None:
    page.make(
        "window.order = []; window.given = [];"
        "window.stopEach = onIntent(box('each', 500, 500), ({ signal }) => {"
        " const number = given.push(signal); order.push(number); return () => order.push(-number);"
        "}, { predictor: 'minimum-jerk', once: false })"
    )
    for _ in range(3):
        page.move((40, 40), (550, 530), 0.3)
        page.away()
        page.move((550, 530), (40, 40), 0.3)
        page.away()
    page.value("stopEach()")
    order = page.value("order")
    assert order[:6] == [1, -1, 2, -2, 3, -3]
    assert sum(order) == 0
    assert page.value("given.every(({ aborted }) => aborted)") is True


def test_it_fires_again_after_a_time(page: IntentPage) -> None:
    page.make(
        "watch(box('late', 500, 500), { again_s: 0.3 }); watch(box('later', 500, 400), { again_s: 60 })"
    )
    for _ in range(2):
        page.move((40, 40), (550, 530), 0.3)
        page.away()
        page.move((550, 530), (40, 40), 0.3)
        page.away()
    said = page.said()
    fired = [one.split()[0] for one in said if not one.endswith("ended")]
    assert fired.count("late") == 2
    assert said.count("late ended") == 1
    assert fired.count("later") <= 1


def test_slop_widens_the_element_on_each_side(page: IntentPage) -> None:
    page.make(
        "watch(box('wide', 400, 300), { hitSlop: { left: 80 }, threshold: 1 });"
        "watch(box('plain', 400, 500), { threshold: 1 })"
    )
    page.move((350, 20), (350, 680), 0.4)  # 50 px to the left of both
    assert page.said() == ["wide entered"]
    page.away()
    page.move((550, 680), (550, 20), 0.4)  # 50 px to the right
    assert page.said() == ["wide entered"]


def test_of_equal_elements_the_prior_decides(page: IntentPage) -> None:
    """Two that lie one upon the other have the same evidence."""
    page.make(
        "window.less = register(box('less', 600, 500), { predictor: 'minimum-jerk' });"
        "window.more = register(box('more', 600, 500), { predictor: 'minimum-jerk', priority: 3 });"
        "window.never = register(box('never', 600, 500), { predictor: 'minimum-jerk', priority: 0 })"
    )
    page.move((40, 40), (500, 420), 0.4)
    less, more, never = page.value("[less.share, more.share, never.share]")
    assert more == pytest.approx(3 * less, rel=1e-9)
    assert never == 0.0
    assert less > 0.05
    assert page.said() == []


@pytest.mark.parametrize("threshold", [0.1, 0.9])
def test_a_higher_threshold_fires_less_and_later(page: IntentPage, threshold: float) -> None:
    page.make(
        f"{ROW} for (const one of document.querySelectorAll('button'))"
        f" watch(one, {{ threshold: {threshold} }})"
    )
    page.move((40, 40), (470, 590), 0.8)
    others = {one.split()[0] for one in page.said()} - {"b2"}
    assert "b2" in {one.split()[0] for one in page.said()}
    assert bool(others) is (threshold < 0.5)


def test_stopping_leaves_no_listener(page: IntentPage) -> None:
    """The browser itself is asked."""

    def listeners() -> list[str]:
        thing = page.visitor.hand.call("Runtime.evaluate", expression="window")["result"]["objectId"]
        found = page.visitor.hand.call("DOMDebugger.getEventListeners", objectId=thing)["listeners"]
        return sorted(one["type"] for one in found)

    before = listeners()
    page.make("watch(box('a', 100, 100)); watch(box('b', 300, 100), { policy: 'highlight' })")
    assert len(listeners()) > len(before)
    page.make("stops.a(); stops.a()")
    assert len(listeners()) > len(before)
    page.make("stops.b()")
    assert listeners() == before
    page.move((20, 20), (350, 130), 0.3)
    assert page.said() == []
    page.make("watch(box('c', 300, 300))")  # another one begins anew
    page.move((350, 130), (350, 330), 0.3)
    assert len(page.said()) == 1


def test_an_error_of_the_page_keeps_no_other_from_being_called(page: IntentPage) -> None:
    page.make(
        "window.errors = []; addEventListener('error', (event) => { errors.push(event.message); "
        "event.preventDefault(); });"
        "box('goal', 600, 500); onIntent(goal, () => { throw new Error('mine'); }, { "
        "predictor: 'minimum-jerk' }); watch(goal)"
    )
    page.move((40, 40), (650, 530))
    assert len(page.said()) == 1
    assert page.value("errors") == ["Uncaught Error: mine"]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        ("onIntent(document.body)", "a function is needed, received undefined"),
        ("onIntent('#a', () => {})", "an element is needed, received #a"),
        ("watch(document.body, { treshold: 1 })", "unknown option treshold; known: policy, "),
        ("watch(document.body, { threshold: 2 })", "threshold must be a number in [0.000001, 1], received 2"),
        ("watch(document.body, { threshold: 0 })", "threshold must be a number in [0.000001, 1], received 0"),
        ("watch(document.body, { hitSlop: '8' })", "hitSlop top must be a number in [0, 10000], received 8"),
        ("watch(document.body, { hitSlop: { up: 8 } })", "unknown side up of hitSlop"),
        ("watch(document.body, { enabled: 1 })", "enabled must be a boolean or a function, received 1"),
        (
            "const frame = document.createElement('iframe'); document.body.append(frame);"
            "onIntent(frame.contentDocument.body, () => {})",
            "<body> is in a frame: load pointpred there",
        ),
        (
            "watch(document.body, { hitSlop: { top: -1 } })",
            "hitSlop top must be a number in [0, 10000], received -1",
        ),
        (
            "watch(document.body, { policy: 'both' })",
            "policy must be prefetch or highlight, received both",
        ),
        ("prefetchLink(document.body)", "a link (<a href> or <area href>) is needed, received <body>"),
        ("prefetchLink('a', { watched: true })", "unknown option watched; known: policy, "),
        ("prefetchLink(document.links, { watch: true })", "watch needs a selector, received "),
        ("prefetchLink('a', { limit: 0 })", "limit must be a number from 1 on, received 0"),
        ("prefetchLink('a', { ignore: '/a' })", "ignore must be a RegExp, a function or a list of these"),
    ],
)
def test_mistakes_are_named(page: IntentPage, call: str, words: str) -> None:
    with pytest.raises(SourceError) as error:
        page.value(call)
    assert words in str(error.value)


def test_elements_of_a_list_are_registered_all_or_none(page: IntentPage) -> None:
    page.make(
        "box('one', 100, 100); box('two', 300, 100); window.called = [];"
        "window.again = ({ element }) => called.push(element.id);"
        "window.options = { predictor: 'minimum-jerk' };"
        "window.stopBoth = onIntent(document.querySelectorAll('button'), again, options)"
    )
    with pytest.raises(SourceError, match="an element is needed, received null"):
        page.value("onIntent([one, null], again, options)")
    page.move((40, 40), (150, 130), 0.3)
    page.move((150, 130), (350, 130), 0.3)
    assert page.value("called") == ["one", "two"]
    page.value("stopBoth()")
    assert page.value("trackers.size") == 0


def test_it_fires_only_while_it_is_enabled(page: IntentPage) -> None:
    page.make(
        "window.isOn = false; box('asked', 600, 500);"
        "watch(asked, { enabled: (element) => isOn && element === asked });"
        "watch(box('off', 300, 500), { enabled: false })"
    )
    page.move((40, 40), (650, 530), 0.4)
    page.move((650, 530), (350, 530), 0.4)
    assert page.said() == []
    assert page.ledger()["fired"] == 0
    page.make("isOn = true")
    page.away()
    page.move((350, 530), (650, 530), 0.4)
    assert [one.split()[0] for one in page.said()] == ["asked"]


def test_dwell_leaves_out_what_the_pointer_only_crosses(page: IntentPage) -> None:
    page.make(
        "for (const element of [box('near', 200, 300), box('far', 600, 300)])"
        " for (const policy of ['highlight', 'prefetch'])"
        " watch(element, { threshold: 1, dwell_s: 0.3, policy })"
    )
    page.move((40, 330), (650, 330), 0.5)
    page.wait("heard.length === 2")
    assert page.said() == ["far entered", "far entered"]
    page.value("new Promise((done) => setTimeout(done, 400))")
    assert page.said() == ["far entered", "far entered"]


def test_a_firing_says_what_was_compared_with_its_threshold(page: IntentPage) -> None:
    page.make(
        "window.firings = []; window.told = []; onLedger((one) => told.push(one));"
        f"{ROW} for (const policy of ['prefetch', 'highlight'])"
        " onIntent(b2, (one) => { firings.push(one); },"
        " { predictor: 'minimum-jerk', policy, threshold: policy === 'prefetch' ? 0.4 : 0.6 })"
    )
    page.move((40, 40), (470, 590))
    found = page.value(
        "firings.map(({ policy, reason, score, threshold }) => [policy, reason, score, threshold])"
    )
    assert {(policy, reason): threshold for policy, reason, _, threshold in found} == {
        ("prefetch", "predicted"): 0.4,
        ("highlight", "predicted"): 0.6,
    }
    assert all(threshold <= score <= 1.0 for _, _, score, threshold in found)
    assert page.value("told.map(({ score, threshold }) => [score, threshold])") == [one[2:] for one in found]


def test_nothing_was_compared_for_what_was_entered(page: IntentPage) -> None:
    page.make(
        "onIntent(box('goal', 500, 300), (one) => { window.firing = one; },"
        " { threshold: 1, predictor: 'minimum-jerk' })"
    )
    page.move((40, 40), (550, 330), 0.3)
    assert page.value("[firing.reason, firing.score, firing.threshold]") == ["entered", None, None]


def test_errors_of_the_page_go_where_it_wants_them(page: IntentPage) -> None:
    page.make(
        "window.errors = [];"
        "const onError = (error, firing) => errors.push([error.message, firing?.element.id]);"
        "const fails = [() => { throw new Error('at once'); }, async () => { throw new Error('later'); },"
        " () => () => { throw new Error('at the end'); }];"
        "const goal = box('goal', 600, 500);"
        "window.ends = fails.map((fail) => onIntent(goal, fail, { predictor: 'minimum-jerk', onError }))"
    )
    page.move((40, 40), (650, 530))
    page.value("ends.forEach((end) => end())")
    assert page.value("errors") == [["at once", "goal"], ["later", "goal"], ["at the end", "goal"]]


def test_one_time_in_the_future_is_forgotten_at_once(page: IntentPage) -> None:
    page.make(
        "watch(box('goal', 500, 500), { once: false });"
        "const odd = new PointerEvent('pointermove', { isPrimary: true, pointerType: 'mouse', clientX: 5,"
        " clientY: 5, bubbles: true });"
        "Object.defineProperty(odd, 'timeStamp', { value: performance.now() + 60000 });"
        "document.body.dispatchEvent(odd)"
    )
    page.away()
    page.move((40, 40), (550, 530), 0.4)
    assert page.said() == ["goal predicted"]


def test_what_the_signal_of_a_firing_ended_is_no_error(page: IntentPage) -> None:
    page.visitor.page.route("**/slow", lambda route: None)  # never answered
    page.make(
        "window.errors = []; for (const kind of ['error', 'unhandledrejection'])"
        " addEventListener(kind, (event) => {"
        " errors.push(String(event.message ?? event.reason)); event.preventDefault(); });"
        "window.failed = []; const given = { predictor: 'minimum-jerk', policy: 'highlight' };"
        "box('goal', 600, 500); onIntent(goal, ({ signal }) => fetch('/slow', { signal }), given);"
        "onIntent(goal, ({ signal }) => fetch('/slow', { signal }),"
        " { ...given, onError: (error) => failed.push(error) });"
        "onIntent(goal, ({ signal }) => new Promise((_, reject) => signal.addEventListener('abort',"
        " () => reject(new Error('mine')))), given)"
    )
    page.move((40, 40), (650, 530))
    page.away()
    page.move((650, 530), (40, 40))
    page.away()
    page.visitor.page.unroute_all()
    assert page.ledger()["withdrawn"] >= 3
    assert set(page.value("errors")) == {"Uncaught Error: mine"}
    assert page.value("failed") == []


def test_an_element_without_weight_never_fires(page: IntentPage) -> None:
    page.make(
        "watch(box('never', 600, 500), { priority: 0 });"
        "watch(box('dark', 300, 500), { priority: 0, policy: 'highlight' })"
    )
    page.move((40, 40), (650, 530))
    page.away()
    page.move((650, 530), (350, 530))
    page.value("never.focus()")
    page.visitor.page.keyboard.press("Tab")
    page.away()
    assert page.said() == []


def test_where_parts_of_the_browser_are_missing_nothing_is_registered(page: IntentPage, host: str) -> None:
    """As in the documents of jsdom, which tests of components run in."""
    missing = "for (const one of ['IntersectionObserver', 'reportError']) delete window[one];"
    page.make(
        f"{missing} box('a', 600, 500); box('b', 300, 500, 100, 60, 'a').href = 'http://';"
        "window.stopAll = onIntent(a, () => {}); window.stopLinks = prefetchLink('a', { watch: true });"
        "window.handle = register(a)"
    )
    assert page.value("[trackers.size, handle.share, handle.element.id]") == [0, 0, "a"]
    page.value("handle.ready")
    page.value("[stopAll(), stopLinks(), handle.stop()].length")
    assert page.visitor.complaints() == []


@pytest.mark.parametrize("framework", ["vue", "svelte"])
def test_a_directive_with_nothing_to_call_registers_nothing(page: IntentPage, framework: str) -> None:
    bound = {
        "vue": "vIntent.mounted(a, { value }); const update = (value) => vIntent.updated(a, { value });"
        "const stop = () => vIntent.unmounted(a);",
        "svelte": "const { update, destroy: stop } = intent(a, value);",
    }[framework]
    assert page.value(f"""import('/pointpred/frameworks/{framework}.js').then(({{ vIntent, intent }}) => {{
      const a = box('a', 600, 500), counts = [], value = undefined;
      const count = () => counts.push(trackers.size);
      {bound} count();
      const call = () => {{}};
      for (const next of [null, call, undefined, {{ callback: call, policy: 'highlight' }}, {{}}]) {{
        update(next); count(); }}
      stop(); count(); return counts; }})""") == [0, 0, 1, 0, 1, 0, 0]


def test_null_is_no_options(page: IntentPage) -> None:
    page.make(
        "onIntent(box('a', 600, 500), () => heard.push({ id: 'a', reason: 'fired', began: true }), null)"
    )
    page.move((40, 40), (650, 530))
    assert page.said() == ["a fired"]


def test_a_promise_is_no_answer_whether_an_element_is_enabled(page: IntentPage) -> None:
    page.make(
        "window.failed = []; watch(box('goal', 600, 500), { enabled: async () => false,"
        " onError: ({ message }) => failed.push(message) })"
    )
    page.move((40, 40), (650, 530))
    assert page.said() == []
    assert page.value("failed") == []


def test_an_element_that_says_it_is_disabled_does_not_fire(page: IntentPage) -> None:
    page.make(
        "watch(box('prefetch', 600, 500)); watch(box('highlight', 300, 500), { policy: 'highlight' });"
        "for (const one of [prefetch, highlight]) one.setAttribute('aria-disabled', 'true')"
    )
    page.move((40, 40), (650, 530))
    page.away()
    page.move((650, 530), (350, 530))
    page.away()
    assert page.said() == []
