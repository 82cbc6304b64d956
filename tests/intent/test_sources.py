"""Predictions come from the page or from a service: the calls are the same."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest

from pointpred.errors import SourceError
from pointpred.registry import REGISTRY
from tests.intent.page import IntentPage
from tests.server import browser
from tests.server.listener import Listener, soon
from tests.server.page_browser import Visitor

pytestmark = browser.needed

COMPARE = """
Promise.all(["intent/page-source", "intent/usual-stages", "prediction/build", "laws/registry"]
  .concat("laws/only/NAME").map((name) => import(`/pointpred/${name}.js`)))
  .then(async ([{ inPage }, { usualStages }, { build }, { REGISTRY }, { loadStages }]) => {
    const load = ALONE ? loadStages : () => usualStages(REGISTRY, "NAME");
    const [small, whole] = await Promise.all([inPage("NAME", load).open(), build("NAME")]);
    const different = [];
    let claims = 0;
    for (let i = 0; i < 400; i += 1) {
      const u = (i % 100) / 100, way = u * u * u * (10 - 15 * u + 6 * u * u);
      const t = i / 125 + (i >= 200 ? 1 : 0), pressed = i % 100 === 99 ? 1 : 0;
      const row = [t, 100 + 700 * way, 50 + 300 * way * way, NaN, NaN, pressed];
      const [one, other] = [small.add(row), whole.advance(row)];
      claims += one !== null && one[1] === one[1];
      if (String(one) !== String(other)) different.push([i, one, other]);
    }
    return [claims, different.length];
  })"""


@pytest.mark.parametrize("alone", [True, False], ids=["alone", "of all"])
@pytest.mark.parametrize("name", REGISTRY)
def test_the_source_of_a_page_predicts_what_build_does(page: IntentPage, name: str, alone: bool) -> None:
    claims, different = page.value(COMPARE.replace("NAME", name).replace("ALONE", json.dumps(alone)))
    assert claims > 70, "some claim nothing before the peak of the speed"
    assert different == 0


@pytest.mark.parametrize("name", ["kinematic-adaptive", "kinematic", "minimum-jerk"])
def test_a_predictor_is_loaded_when_it_is_needed(page: IntentPage, name: str) -> None:
    loaded = "performance.getEntriesByType('resource').map(({ name }) => name.split('/').at(-1))"
    assert "kinematic.js" not in page.value(loaded)
    page.make(f"watch(box('goal', 600, 500), {{ predictor: '{name}' }})")
    needed = "kinematic.js" if name.startswith("kinematic") else "minimum_jerk.js"
    page.wait(f"{loaded}.includes('{needed}')")
    page.move((40, 40), (650, 530), 0.5)
    assert page.said() == ["goal predicted"]
    assert ("kinematic.js" in page.value(loaded)) is name.startswith("kinematic")


def test_a_handle_says_when_its_predictor_is_loaded(page: IntentPage) -> None:
    resolved = "performance.getEntriesByType('resource').some(({ name }) => name.endsWith('kinematic.js'))"
    assert page.value(f"register(box('goal', 600, 500)).ready.then(() => {resolved})") is True
    with pytest.raises(SourceError, match="predictor must be hold or linear or"):
        page.value("register(box('other', 100, 500), { predictor: 'linnear' })")


@pytest.fixture
def served(visitor: Visitor) -> Iterator[tuple[IntentPage, Listener]]:
    with Listener() as listener:
        yield IntentPage(visitor, listener.url, package="/web/lib"), listener


def test_a_service_predicts_and_the_calls_are_the_same(served: tuple[IntentPage, Listener]) -> None:
    page, listener = served
    options = json.dumps({"service": listener.url, "predictor": "minimum-jerk"})
    page.make(
        f"watch(box('goal', 600, 500), {options}); watch(box('other', 100, 500), {options});"
        f"watch(box('lit', 800, 100), {{ ...{options}, policy: 'highlight' }})"
    )
    assert len(listener.messages("hello")) == 1, "one connection for all of them"
    page.move((40, 40), (650, 530), 0.5)
    page.away()
    page.move((650, 530), (850, 130), 0.5)
    page.wait("heard.length >= 2")
    soon(lambda: len(listener.events()) > 20, "the events")
    assert page.said()[0] == "goal predicted"
    assert any(one.startswith("lit") for one in page.said())
    page.value("for (const stop of Object.values(stops)) stop()")
    soon(lambda: len(listener.messages("bye")) == 1, "the last to stop closes the connection")


def test_without_the_service_entries_still_fire(served: tuple[IntentPage, Listener]) -> None:
    page, listener = served
    page.make(
        "watch(box('goal', 600, 500),"
        f" {{ service: '{listener.url}', predictor: 'minimum-jerk', threshold: 1 }})"
    )
    listener.stop()
    page.move((40, 40), (650, 530), 0.5)
    assert page.said() == ["goal entered"]
