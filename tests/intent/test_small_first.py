"""The recommended predictor is loaded once the page is idle; a small one predicts until then."""

from __future__ import annotations

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

WHEN_IDLE = "window.requestIdleCallback = (done) => { window.isIdle = done; }"
LOADED = "performance.getEntriesByType('resource').some(({ name }) => name.endsWith('kinematic.js'))"
PREDICTOR = "[...trackers.values()][0].source.opened?.predictor"
WATCH = (
    "watch(box('goal', 600, 500), { predictor: undefined, once: false }); register(box('other', 100, 500))"
)

SOURCE = """
Promise.all(["source", "page-source", "small-first", "usual-stages"].map((name) => `intent/${name}`)
  .concat("prediction/build", "laws/registry")
  .map((name) => import(`/pointpred/${name}.js`)))
  .then(async ([{ Source }, { inPage }, { smallFirst }, { usualStages }, { build }, { REGISTRY }]) => {
    const predictorOf = (name) => inPage(name, () => usualStages(REGISTRY, name));
    const said = [];
    const source = new Source(smallFirst(predictorOf("minimum-jerk"), predictorOf("kinematic-adaptive")));
    while (source.opened === null) await new Promise((done) => setTimeout(done, 5));
    const pipelines = { small: await build("minimum-jerk"), learned: await build("kinematic-adaptive") };
    const add = (number, i) => {
      const u = i / 50, row = [number + i / 100, 100 + 700 * u * u * (3 - 2 * u), 50, NaN, NaN, 0];
      const answer = String(source.add(row, i === 0));
      const same = Object.entries(pipelines).filter(([, one]) => String(one.advance(row)) === answer);
      return [source.opened.predictor, ...same.map(([name]) => name)];
    };
    for (let i = 0; i < 30; i += 1) said.push(add(1, i));
    isIdle();
    await source.ready;
    for (let i = 30; i < 50; i += 1) said.push(add(1, i));
    pipelines.learned = pipelines.learned.fresh();
    for (let i = 0; i < 50; i += 1) said.push(add(2, i));
    source.close();
    return said;
  })"""


def test_the_learned_predictor_takes_over_between_movements(page: IntentPage) -> None:
    page.value(WHEN_IDLE)
    said = page.value(SOURCE)
    assert all(one[0] == "minimum-jerk" and "small" in one for one in said[:50]), "also once it is loaded"
    assert all(one[0] == "kinematic-adaptive" and "learned" in one for one in said[50:])


def test_the_small_predictor_fires_before_the_learned_one_is_loaded(page: IntentPage) -> None:
    page.value(WHEN_IDLE)
    page.value(f"{{ {WATCH} }}")
    page.wait(f"{PREDICTOR} === 'minimum-jerk'")
    page.value("frames(3)")
    page.visitor.reach((40, 40), (650, 530), 0.5, paced=True)
    page.wait("said().length > 0")
    assert page.said() == ["goal predicted"]
    assert page.value(LOADED) is False
    page.value("isIdle()")
    page.settle()
    assert page.value(LOADED) is True
    assert page.value(PREDICTOR) == "minimum-jerk", "the movement is not over"
    page.away()
    page.move((650, 530), (60, 100), 0.5)
    assert page.value(PREDICTOR) == "kinematic-adaptive"
    page.away()
    page.move((60, 100), (650, 530), 0.5)
    assert [one.split()[1] != "ended" for one in page.said()] == [True, False, True]


def test_what_the_person_took_is_known_after_the_predictor_has_changed(page: IntentPage) -> None:
    """Shares before a movement shows anything: the element that was taken is likelier than its neighbour."""
    page.value(WHEN_IDLE)
    page.value(f"{{ {WATCH} }}")
    page.wait(f"{PREDICTOR} === 'minimum-jerk'")
    page.value("frames(3)")
    for start in ((40, 40), (900, 60)):
        page.visitor.reach(start, (650, 530), 0.5, paced=True)
        page.away()
        page.visitor.reach((650, 530), start, 0.5, paced=True)
        page.away()
    page.value("isIdle()")
    page.settle()
    page.visitor.reach((40, 40), (42, 41), 0.1, paced=True)
    page.settle()
    assert page.value(PREDICTOR) == "kinematic-adaptive"
    share = "[...trackers.values()][0].share(document.getElementById('{}'))"
    assert page.value(share.format("goal")) > 1.5 * page.value(share.format("other"))
