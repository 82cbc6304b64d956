"""A page with few registered elements: most movements are for something else."""

from __future__ import annotations

import pytest

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed

LONE = "box('lone', 560, 300, 140, 100)"
ELSEWHERE = [
    ((600, 690), (960, 690)),
    ((960, 690), (960, 100)),
    ((300, 100), (300, 690)),
    ((940, 100), (60, 100)),
]


@pytest.mark.parametrize("name", ["kinematic-adaptive", "minimum-jerk"])
def test_a_lone_element_is_quiet_while_the_pointer_goes_elsewhere(page: IntentPage, name: str) -> None:
    page.make(f"watch({LONE}, {{ predictor: '{name}', once: false }})")
    for start, end in ELSEWHERE:
        page.move(start, end, 0.7)
        page.away()
    assert page.said() == []


@pytest.mark.parametrize("name", ["kinematic-adaptive", "minimum-jerk"])
def test_a_lone_element_is_predicted_when_the_pointer_goes_there(page: IntentPage, name: str) -> None:
    page.make(f"watch({LONE}, {{ predictor: '{name}' }})")
    page.move((40, 40), (620, 340), 0.7)
    assert page.said() == ["lone predicted"]
