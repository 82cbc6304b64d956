"""Rates, gains and margins of the examples beside computations with 40 digits."""

from __future__ import annotations

import pytest

from evidence.observers.designs import EXAMPLES, compared

LONG = ("6", "7")


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] if name in LONG else [])
        for name in EXAMPLES
        if name != "camera"
    ],
)
def test_the_numbers_of_an_example_have_their_digits(name: str) -> None:
    for example, what, ours, wanted in compared(name):
        assert ours == pytest.approx(wanted, rel=1e-6), f"example {example}: {what}"
