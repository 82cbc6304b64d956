"""Where the page predicts: in itself unless the service is chosen."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from pointpred import RECOMMENDED, REGISTRY, build, run
from pointpred.datasets import sample
from pointpred.recording import Recording
from pointpred.recordings import write
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

LINES = {"live": "#live-card-0 .connection", "circle": "#circle-connection", "assist": "#assist-connection"}
HERE, THERE = "Predicted in this page.", "Predicted by the service."
CHOSEN = "document.querySelector('#place').value"
READOUT = "#replay-readout"


@pytest.fixture
def visitor(one: Visitor) -> Iterator[Visitor]:
    one.resize(1280, 720)
    yield one
    assert one.complaints() == []
    assert one.shift() < 0.001


def says(visitor: Visitor, view: str, words: str) -> None:
    visitor.wait(f"document.querySelector('{LINES[view]}').textContent === '{words}'")


def sockets(visitor: Visitor) -> set[str]:
    return {address for address in visitor.asked() if address.startswith("ws")}


def move(visitor: Visitor) -> None:
    left, top, width, height = visitor.corner("#live-scene")
    for share in (0.8, 0.3):
        visitor.reach(
            (left + (1 - share) * width, top + 0.3 * height), (left + share * width, top + 0.5 * height), 0.4
        )


def test_the_page_predicts_unless_the_service_is_chosen_which_the_address_keeps(
    visitor: Visitor, url: str
) -> None:
    visitor.open(f"{url}#live")
    says(visitor, "live", HERE)
    move(visitor)
    visitor.wait("Number(document.querySelector('#live-scene').dataset.drawn) > 0")
    assert sockets(visitor) == set()
    assert f"{url}v1/predictors" not in visitor.asked()
    visitor.choose("#place", "service")
    says(visitor, "live", THERE)
    assert len(sockets(visitor)) == 1
    assert visitor.value("location.search + location.hash") == "?by=service#live"
    visitor.page.goto(visitor.value("location.href"))
    says(visitor, "live", THERE)
    visitor.value("location.hash = 'circle'")
    says(visitor, "circle", THERE)
    visitor.choose("#place", "page")
    says(visitor, "circle", HERE)
    assert visitor.value("location.search") == ""
    visitor.value("location.hash = 'live'")
    says(visitor, "live", HERE)


def test_a_changed_place_cancels_a_run_and_predicts_the_replayed_movement_again(
    visitor: Visitor, url: str
) -> None:
    visitor.open(f"{url}#circle")
    visitor.wait("!document.querySelector('#circle-start').disabled")
    visitor.value("document.querySelector('#circle-start').click()")
    visitor.choose("#place", "service")
    visitor.wait("document.querySelector('#circle-status').dataset.state === 'cancelled'")
    says(visitor, "circle", THERE)
    visitor.value("location.hash = 'replay'")
    visitor.wait("!document.querySelector('#replay-play').disabled")
    by_service = visitor.text(READOUT)
    assert "px off" in by_service
    visitor.value(
        "window.computed = 0, new MutationObserver(() => computed += 1).observe("
        f"document.querySelector('{READOUT}'), {{ childList: true }})"
    )
    visitor.choose("#place", "page")
    visitor.wait(f"computed > 1 && document.querySelector('{READOUT}').textContent.includes('px off')")
    assert visitor.text(READOUT) == by_service


@pytest.mark.parametrize("predictor", ["kinematic-adaptive", "switched", "kep-quartic"])
def test_an_opened_file_is_predicted_in_the_page_as_in_python(
    visitor: Visitor, url: str, tmp_path: Path, predictor: str
) -> None:
    visitor.open(f"{url}#replay")
    visitor.wait("!document.querySelector('#replay-play').disabled")
    whole = sample()
    parts = [whole.rows(i) for i in (3, 4)]
    own = Recording.of("study", parts, [whole.trials[i] for i in (3, 4)], provenance=whole.provenance)
    visitor.page.set_input_files("#replay-file", write(own, tmp_path / "study_samples.csv"))
    visitor.wait(f"document.querySelector('{READOUT}').textContent.includes('Movement 1 of 2')")
    predicted = visitor.value(
        "import('/web/page/replay/predictions.js').then(async ({ predictionsAlong }) => {"
        "const { readFiles } = await import('/web/page/replay/csv.js');"
        "const { movements, dpi, cpi } = await readFiles([...document.querySelector('#replay-file').files]);"
        f"return predictionsAlong(movements[1].rows, '{predictor}', {{ dpi, cpi }}); }})"
    )
    assert sockets(visitor) == set()
    expected = run(build(predictor, cpi=own.provenance.cpi, dpi=own.provenance.dpi), parts[1])
    assert np.isfinite(expected.x).any()
    for axis, column in (("x", expected.x), ("y", expected.y)):
        np.testing.assert_allclose(np.array(predicted[axis], dtype=float), column, rtol=0.0, atol=1e-6)


def test_parameters_are_described_as_by_the_service(visitor: Visitor, url: str) -> None:
    visitor.open(url)
    differing = visitor.value(
        "import('/web/page/service/listing.js').then(async ({ describe }) => {"
        "const { predictors } = await (await fetch('/v1/predictors')).json();"
        "const own = await Promise.all(predictors.map(({ name }) => describe(name)));"
        "const text = (one) => JSON.stringify(one, (_, value) =>"
        "value && !Array.isArray(value) && typeof value === 'object'"
        "? Object.fromEntries(Object.entries(value).sort()) : value);"
        "return predictors.filter((one, i) => text(one) !== text(own[i])).map((one, i) => text(one)); })"
    )
    assert differing == []


def test_the_list_of_the_page_is_that_of_the_service(visitor: Visitor, url: str) -> None:
    visitor.open(url)
    own = visitor.value("import('/web/page/service/listing.js').then(({ predictors }) => predictors())")
    assert own["recommended"] == RECOMMENDED
    listed = [(entry.name, entry.title) for entry in REGISTRY.values()]
    assert [(one["name"], one["title"]) for one in own["predictors"]] == listed


def test_every_module_of_the_first_prediction_is_announced_in_the_page(visitor: Visitor, url: str) -> None:
    """A module that is not waits until the one that imports it is there."""
    visitor.open(f"{url}#live")
    says(visitor, "live", HERE)
    visitor.wait("document.querySelector('#live-scene').dataset.shows === 'demo'")
    announced = visitor.value(
        "[...document.querySelectorAll('link[rel=modulepreload]')].map(({ href }) => href)"
    )
    loaded = {address for address in visitor.asked() if address.endswith(".js")}
    assert len(loaded) > 100
    assert loaded == set(announced)


def test_live_predicts_before_the_other_views_are_there(visitor: Visitor, url: str) -> None:
    part, held = "**/web/page/circle/view.js", []
    visitor.page.route(part, lambda route: held.append(route))
    visitor.page.goto("about:blank")
    visitor.page.goto(url, wait_until="commit")
    visitor.wait("document.querySelector('#live-scene')?.dataset.shows === 'demo'")
    says(visitor, "live", HERE)
    assert visitor.value("document.title") != "pointpred: live", "the tabs wait for the other views"
    for route in held:
        route.continue_()
    visitor.page.unroute(part)
    visitor.wait("document.title === 'pointpred: live'")
