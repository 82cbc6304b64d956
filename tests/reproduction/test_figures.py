"""The figures of chapter 2 are made, and exactly the numbers named here do not come out as printed."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.reproduction import trials
from pointpred.reproduction.catalogue import LISTED
from pointpred.reproduction.figure import Entry, Value
from tests.reproduction.making import check, compare_with_the_page
from tests.signals import exact, ramp

DIFFERENT: dict[str, set[str]] = {
    "2.12": {
        "error at the end of the path, switched",
        "error at the end of the path, KEP",
        "fractions of 20 at which switched is better",
    },
    "2.13": {
        "error at the end, outliers replaced, switched",
        "error at the end, outliers replaced, KEP",
        "F of the model at 50 %",
        "partial eta squared of the model at 50 %",
        "F of the model at 50 %, outliers replaced",
        "partial eta squared of the model at 50 %, outliers replaced",
    },
}
"""The values that differ from the print, for the reasons in ``Entry.differs``; none where not listed."""

MADE = [
    pytest.param(entry, id=entry.number, marks=[pytest.mark.slow] if entry.slow else [])
    for entry in LISTED
    if entry.make is not None
]


@pytest.mark.parametrize("entry", MADE)
def test_it_is_made_and_drawn_and_differs_where_it_says(entry: Entry) -> None:
    check(entry, DIFFERENT.get(entry.number, set()))
    compare_with_the_page(entry)


def test_every_number_of_chapters_1_and_2_is_listed() -> None:
    lengths = {1: 6, 2: 13}
    assert [entry.number for entry in LISTED] == [
        f"{chapter}.{i + 1}" for chapter, count in lengths.items() for i in range(count)
    ]


def test_a_value_agrees_where_it_rounds_to_the_print() -> None:
    assert Value("x", 0.0938499, "0.0938").agrees
    assert not Value("x", 0.093851, "0.0938").agrees
    assert Value("x", 9.5722e-5, "9.572e-5").agrees
    assert not Value("x", 3.2, "3").agrees


def test_the_filtered_position_of_figure_2_2_runs_on_a_ramp_once_it_has_settled() -> None:
    signal = exact(ramp, 1000.0)
    path = trials.hand_path(signal.events, "x", {"dpi": 96.0})
    filtered = trials.filtered_path(signal.events, "x", path, {"dpi": 96.0})
    assert np.abs(filtered - path).max() > 5e-4
    assert np.abs(filtered - path)[800:].max() < 1e-7
