"""Entries that are only rounding couple nothing, and an Upsilon that is not needed is 0."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred_observers import Persidskii
from pointpred_observers.numerics.equalities import NO_DIGIT, without_rounding
from pointpred_observers.reduced_order.design import ReducedOrderObserver


def tanks(coupling: float = 0.0) -> Persidskii:
    """Three tanks in a row, of which the last level is measured."""
    flows = [[-1.0, coupling, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, -1.0]]
    slopes = [(0.3, 1.0)] * 3
    return Persidskii(
        np.zeros((3, 3)), flows, np.eye(3), np.arctan, C0=[0.0, 0.0, 1.0], slopes=slopes, domain=1.0
    )


@pytest.mark.parametrize("decay", [0.05, 0.1, 0.15])
def test_the_bound_of_a_cascade_is_small(decay: float) -> None:
    """With its rounding balanced to 1 the overshoot was 3e8."""
    design = ReducedOrderObserver.design(tanks(), decay=decay)
    assert design.certificate.bound.overshoot < 2.0
    assert np.linalg.cond(design.certificate.values["P"]) < 10.0


def test_the_levels_that_are_not_measured_keep_their_zeros() -> None:
    now = ReducedOrderObserver.design(tanks(), decay=0.1).observer.at(0.0)
    assert np.count_nonzero(now.S1) == 3
    assert np.count_nonzero(now.J) == 2


def test_what_decays_by_itself_needs_no_output_and_that_is_the_least() -> None:
    design = ReducedOrderObserver.design(tanks(), decay=0.1)
    assert not design.Upsilon.any()
    assert design.gap == 0.0
    faster = ReducedOrderObserver.design(tanks(), decay=0.5)
    assert np.abs(faster.Upsilon).max() > 0.1
    assert 0.0 < faster.gap < 1.0


@pytest.mark.parametrize("time", ["continuous", "discrete"])
def test_the_output_is_used_where_a_mode_is_too_slow(time: str) -> None:
    plant = Persidskii([[0.9, 0.5], [0.0, 0.8]], C0=[1.0, 0.0], time=time)
    for decay in (0.1, 0.3):  # a mode of 0.8 a step decays by 0.223
        design = ReducedOrderObserver.design(plant, decay=decay)
        unneeded = time == "discrete" and decay == 0.1
        assert design.Upsilon.any() != unneeded
        assert (design.gap == 0.0) == unneeded
        assert design.certificate.bound.decay >= decay * (1.0 - 1e-9)


def test_an_entry_that_has_digits_stays() -> None:
    computed, sizes = np.array([[1e-13, 1e-15, 0.0, -3e-14]]), np.ones((1, 4))
    assert without_rounding(computed, sizes, share=NO_DIGIT).tolist() == [[1e-13, 0.0, 0.0, -3e-14]]
