"""At every door a problem in other units has the same answer, and the design is the same, scaled back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from evidence.observers.designs import gap
from evidence.observers.plants import DOORS, Problem
from pointpred.errors import InfeasibleError, UndecidedError

SEEDS = st.integers(0, 2**32 - 1)
MOVED = {
    "`design_observer`": lambda found, one: found.gain * one.x[:, None] / one.y / one.t,
    "`design_observer`, discrete": lambda found, one: found.gain * one.x[:, None] / one.y,
    "`design_reduced_order`, linear": lambda found, one: rate(found.certificate, one),
    "`design_reduced_order`, `injection=True`": lambda found, one: rate(found.certificate, one),
    "`design_reduced_order`, discrete": lambda found, one: found.certificate.bound.decay,
    "`certify_convergence`": lambda found, one: rate(found, one),
    "`certify_tracking`": lambda found, one: shape(found.error.values["P"] / one.x / one.x[:, None]),
    "`certify_interlaced`": lambda found, one: found.L * one.x[:, None] / one.y[0] / one.t,
    "`UnknownInputObserver.design`": lambda found, one: min(found.certificate.largest_decay / one.t, 1e9),
}
"""Of each answer something that does not depend on the units once it is scaled back."""


def shape(p: Any) -> Any:
    return p / p[0, 0]


def rate(certificate: Any, one: Problem) -> float:
    return float(certificate.bound.decay / one.t)


def problem(seed: int, units: bool) -> Problem:
    one = Problem("random", np.random.default_rng(seed), largest=4)
    if units:
        random = np.random.default_rng(seed + 1)
        one.x = 10.0 ** random.uniform(-6.0, 6.0, one.n)
        one.y = 10.0 ** random.uniform(-6.0, 6.0, one.p)
        one.t = 10.0 ** random.uniform(-5.0, 5.0)
    return one


def answer(door: str, one: Problem) -> Any:
    try:
        found = DOORS[door](one)
        if (gap(found) or 0.0) > 0.1:
            return "no minimum"  # what the answer says itself
        return MOVED[door](found, one)
    except (InfeasibleError, UndecidedError) as refused:
        return type(refused)


@pytest.mark.slow
@pytest.mark.parametrize("door", list(DOORS))
@given(SEEDS)
@example(329)  # a gain of 1e12, with which rounding passed for a design of `design_observer`
@settings(max_examples=15, deadline=None)
def test_units_change_nothing(door: str, seed: int) -> None:
    """States and outputs in units up to 1e6 times larger or smaller, time in units up to 1e5 times."""
    first, second = answer(door, problem(seed, False)), answer(door, problem(seed, True))
    if isinstance(first, str) or isinstance(second, str):
        assert isinstance(first, type) == isinstance(second, type)
    elif isinstance(first, type):
        assert isinstance(second, type)  # refused or undecided, but no design
    else:
        assert second == pytest.approx(first, rel=1e-2, abs=1e-3 * float(np.abs(first).max()))


@pytest.mark.parametrize("door", list(DOORS))
def test_a_design_of_each_door_in_other_units(door: str) -> None:
    """The same on one problem, for every run of the tests."""
    plain = ((seed, answer(door, problem(seed, False))) for seed in range(20))
    seed, first = next((seed, one) for seed, one in plain if not isinstance(one, type | str))
    second = answer(door, problem(seed, True))
    assert second == pytest.approx(first, rel=1e-2, abs=1e-3 * float(np.abs(first).max()))
