"""Reduced-order designs that rounding leaves undecided: their axes, and a search that begins on the edge."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from evidence.observers.designs import outcome
from evidence.observers.plants import hiding
from pointpred.errors import UndecidedError
from pointpred_observers import Persidskii, invariant_observer
from pointpred_observers.proofs import matrix_inequalities
from pointpred_observers.proofs.solver import Answer
from pointpred_observers.proofs.stationary import filter_start
from pointpred_observers.reduced_order import design
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.reduced_order.upsilon import split
from pointpred_observers.thesis import certify_convergence


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


def test_what_is_undecided_is_tried_again_in_those_axes(monkeypatch: pytest.MonkeyPatch) -> None:
    plant, tried = hidden(0, 0.1), []

    def rounded(observer: Any, **options: Any) -> Any:
        tried.append(observer._given["Pi"])
        if len(tried) % 2:
            raise UndecidedError("rounding")
        return certify_convergence(observer, **options)

    monkeypatch.setattr(design, "certify_convergence", rounded)
    assert ReducedOrderObserver.design(plant, decay=0.5).observer._given["Pi"] is tried[1]
    assert not np.allclose(tried[0], tried[1])
    tried.clear()
    given = design._unmeasured(plant)
    ReducedOrderObserver.design(plant, Pi=given, decay=0.5)
    assert [one is given for one in tried] == [True, True]


def test_a_search_may_begin_at_any_condition_number(monkeypatch: pytest.MonkeyPatch) -> None:
    """The P of a design is enough where the solver has no answer: Xi meets the decay to the last digit."""
    none = Answer("stalled", None, -np.inf, None)
    monkeypatch.setattr(matrix_inequalities, "run", lambda problem, **options: none)
    plant = Persidskii(np.diag([-1.0, -2.0, -2.0]), None, None, "tanh", C0=[1.0, 0.0, 0.0])
    observer = invariant_observer(plant, np.eye(3)[1:], np.zeros((2, 1)))
    turn = np.array([[0.8, -0.6], [0.6, 0.8]])
    p = turn @ np.diag([1.0, 1e10]) @ turn.T
    certificate = certify_convergence(observer, decay=0.5, near={"P": 0.5 * (p + p.T)})
    assert 0.5 <= certificate.bound.decay <= 0.50001


@pytest.mark.slow
@pytest.mark.parametrize("seed", [3, 13])
def test_nearly_unobservable_plants_are_designed(seed: int) -> None:
    """Problems of the table of designs with P of a condition number of 1e10 in other axes."""
    what, gap = outcome("`design_reduced_order`, linear", "nearly unobservable", seed)
    assert what == "designed"
    assert gap is not None
    assert gap < 1e-2
