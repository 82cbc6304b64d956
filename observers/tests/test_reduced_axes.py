"""Reduced-order designs that rounding leaves undecided: their axes, and a search that begins on the edge."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from evidence.observers.designs import outcome
from evidence.observers.plants import hiding
from pointpred_observers import Persidskii
from pointpred_observers.proofs.stationary import filter_start
from pointpred_observers.reduced_order import design
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.reduced_order.upsilon import split


def hidden(seed: int, share: float) -> Persidskii:
    """A linear plant of 4 states whose slowest mode reaches the output with this share."""
    random = np.random.default_rng(seed)
    a = random.normal(size=(4, 4)) / 2.0
    return Persidskii(a, None, None, "tanh", C0=hiding(a, random.normal(size=(1, 4)), share))


def graded(p: Any) -> float:
    """The condition number of P with its diagonal scaled to 1."""
    d = 1.0 / np.sqrt(np.diag(p))
    return float(np.linalg.cond(p * d * d[:, None]))


@pytest.mark.parametrize("seed", range(4))
def test_in_the_axes_of_the_filter_a_barely_observable_state_is_a_coordinate(seed: int) -> None:
    plant = hidden(seed, 1e-3)
    plain, turned = design._unmeasured(plant), design._turned(plant, 0.5)
    assert turned is not None
    assert np.allclose(turned @ turned.T, np.eye(3), atol=1e-12)
    assert np.allclose(plant.C0 @ turned.T, 0.0, atol=1e-12)
    sizes = []
    for pi in (plain, turned):
        parts = split(plant, pi)
        start = filter_start(parts.drift, parts.seen, 0.5, "continuous")
        assert start is not None
        sizes.append(graded(start[0]))
    assert sizes[1] < 10.0
    assert sizes[1] < 1e-3 * sizes[0]


@pytest.mark.slow
@pytest.mark.parametrize("seed", [3, 13])
def test_nearly_unobservable_plants_are_designed(seed: int) -> None:
    """Problems of the table of designs with P of a condition number of 1e10 in other axes."""
    what, gap = outcome("`design_reduced_order`, linear", "nearly unobservable", seed)
    assert what == "designed"
    assert gap is not None
    assert gap < 1e-2


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
