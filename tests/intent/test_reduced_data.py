"""Nothing is loaded ahead for somebody who saves data."""

from __future__ import annotations

import pytest

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

OVERRIDE = """window.network = Object.assign(new EventTarget(), {});
Object.defineProperty(navigator, "connection", { get: () => network, configurable: true });"""


@pytest.mark.parametrize(
    "network", ["{ saveData: true }", "{ effectiveType: '2g' }", "{ effectiveType: 'slow-2g' }"]
)
def test_prefetches_are_withheld_and_counted_once(page: IntentPage, network: str) -> None:
    page.make(
        f"{OVERRIDE} Object.assign(network, {network});"
        "watch(box('goal', 600, 500)); watch(goal, { policy: 'highlight', name: 'lit' });"
        "watch(box('anyway', 800, 500), { saveData: 'ignore' })"
    )
    page.move((40, 40), (650, 530), 0.4)
    page.away()
    page.move((650, 530), (850, 530), 0.4)
    names = [one["id"] for one in page.value("heard") if one["began"]]
    assert names.count("goal") == 1, "only the highlight"
    assert names.count("anyway") == 1
    told = page.ledger()
    assert told["withheld"] == told["names"]["goal"]["withheld"] == 1
    assert told["names"]["goal"]["fired"] == 0
    page.make("for (const name of Object.keys(network)) delete network[name]")
    page.away()
    page.move((850, 530), (40, 40), 0.4)
    page.away()
    page.move((40, 40), (650, 530), 0.4)
    assert page.ledger()["names"]["goal"]["fired"] == 1, "the connection is better now"


def test_3g_and_4g_are_fast_enough(page: IntentPage) -> None:
    page.make(f"{OVERRIDE} network.effectiveType = '3g'; watch(box('goal', 600, 500))")
    page.move((40, 40), (650, 530), 0.4)
    assert len(page.said()) == 1
