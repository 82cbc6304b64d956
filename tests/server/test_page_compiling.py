"""What the page says while a first start compiles: a stub answers in the place of /v1/compiling."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest

from pointpred.registry import RECOMMENDED, REGISTRY
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

COUNT = len(REGISTRY)
LEFT = {"done": 1, "of": COUNT, "next": "ktm", "ready": [RECOMMENDED], "recommended": RECOMMENDED}
OTHER = {**LEFT, "ready": ["hold"]}
DONE = {"done": COUNT, "of": COUNT, "next": None, "ready": list(REGISTRY), "recommended": RECOMMENDED}
STUB = """
window.compiling = %s;
const ask = window.fetch;
window.fetch = async (address, options) =>
  String(address).endsWith("/v1/compiling") ? Response.json(window.compiling) : ask(address, options);
"""
LINE = "document.querySelector('#view-live .connection').textContent"
UNCUT = """(() => {
  const line = document.querySelector('PART');
  const said = line.textContent;
  line.textContent = 'LONG';
  const fits = line.scrollHeight <= line.clientHeight && line.scrollWidth <= line.clientWidth;
  line.textContent = said;
  return fits;
})()"""
LINES = {"live": "#view-live .connection", "circle": "#circle-connection", "assist": "#assist-connection"}
CIRCLE = "document.querySelector('#circle-connection').textContent"
STATE = "document.querySelector('#view-{} .connection').dataset.compiling"
LABELS = "[...document.querySelector('#view-live select').options].map(({label}) => label)"


@pytest.fixture
def visitor(one: Visitor) -> Iterator[Visitor]:
    one.hand.call("Page.enable")
    script = one.hand.call("Page.addScriptToEvaluateOnNewDocument", source=STUB % json.dumps(LEFT))
    yield one
    one.hand.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])


def test_the_page_says_what_is_compiled_and_what_can_be_used(visitor: Visitor, url: str) -> None:
    visitor.open(f"{url}?by=service")
    visitor.wait(f"{LINE}.includes('1 of {COUNT}, ktm')")
    visitor.wait(f"{STATE.format('live')} === 'ready'")
    longest = visitor.value(LINE).replace("ktm", "differentiators")
    for view, part in LINES.items():
        visitor.value(f"location.hash = {view!r}")
        for size in ((1440, 900), (1024, 768), (390, 844)):
            visitor.resize(*size)
            assert visitor.value(UNCUT.replace("PART", part).replace("LONG", longest)), (part, size)
    visitor.value("location.hash = 'circle'")
    visitor.wait(f"{STATE.format('circle')} === 'ready' && {CIRCLE}.includes('1 of {COUNT}, ktm')")
    visitor.value("location.hash = 'live'")
    visitor.wait(f"{STATE.format('live')} === 'ready'")
    assert visitor.shift() < 0.001
    visitor.choose("#view-live select", "ktm")
    visitor.wait(f"{STATE.format('live')} === 'compiling'")
    visitor.wait(f"{LABELS}.length === {COUNT} && {LABELS}.some((label) => label.includes('not compiled'))")
    labels = visitor.value(LABELS)
    assert [label for label in labels if "not compiled yet" not in label] == [RECOMMENDED]
    visitor.choose("#view-live select", RECOMMENDED)
    visitor.wait(f"{STATE.format('live')} === 'ready'")
    visitor.choose("#place", "page")
    visitor.wait(f"{LINE} === 'Predicted in this page.'")
    assert sorted(visitor.value(LABELS)) == sorted(REGISTRY), "nothing is compiled in the page"
    visitor.choose("#place", "service")
    visitor.wait(f"{STATE.format('live')} === 'ready'")
    visitor.value(f"window.compiling = {json.dumps(OTHER)}, 0")
    visitor.wait(f"{STATE.format('live')} === 'compiling'")
    visitor.value(f"window.compiling = {json.dumps(DONE)}, 0")
    visitor.wait(f"{LINE} === 'Predicted by the service.'")
    assert sorted(visitor.value(LABELS)) == sorted(REGISTRY)
