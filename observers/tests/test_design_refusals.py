"""Designs that are refused, each with its reason."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers import Generator, Persidskii
from pointpred_observers.interconnected.design import DrivenObserver, FullOrderObserver
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import undetectable


@given(st.integers(0, 2**31), st.sampled_from(["continuous", "discrete"]))
@settings(max_examples=25)
def test_undetectable_modes_are_those_of_the_hidden_block(seed: int, time: str) -> None:
    rng = np.random.default_rng(seed)
    seen, hidden = rng.normal(size=(2, 2)), np.array([[0.9, 0.7], [-0.7, 0.9]])
    whole = np.block([[seen, np.zeros((2, 2))], [rng.normal(size=(2, 2)), hidden]])
    turn = np.linalg.qr(rng.normal(size=(4, 4)))[0]
    c = np.array([[1.0, 0.4, 0.0, 0.0]])
    found = undetectable(turn @ whole @ turn.T, c @ turn.T, time)
    assert sorted(one.imag for one in found) == pytest.approx([-0.7, 0.7], abs=1e-6)
    assert undetectable(turn @ whole @ turn.T, np.eye(4), time) == []


@pytest.mark.parametrize(
    ("s0", "told"),
    [
        (
            [[1.0, 0.0], [0.0, -2.0]],
            r"\(A0, C0\) is not detectable: the mode of the eigenvalue 1 never shows",
        ),
        ([[0.0, 3.0], [-3.0, 0.0]], r"the mode of the eigenvalue 0[+-]3j never shows"),
    ],
)
def test_a_hidden_mode_is_named_before_any_solver(
    s0: Any, told: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "cvxpy", None)
    plant = Persidskii(s0, None, None, "sin", C0=[0.0, 0.0])
    with pytest.raises(InfeasibleError, match=told):
        DrivenObserver.design(plant, generator=Generator(s0), Pi=np.eye(2), decay=0.0)


def test_infeasible_is_said_where_no_single_gain_serves_all_slopes() -> None:
    # Each corner is detectable alone; f swaps the sign with which the state shows in the output.
    plant = Persidskii([[1.0]], [[0.0]], [[1.0]], "sin", C1=[[1.0]])
    with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
        DrivenObserver.design(plant, generator=Generator([[1.0]], [[0.0]]), Pi=[[1.0]], decay=0.0)


@pytest.mark.parametrize(
    ("plant", "pi", "told"),
    [
        (Persidskii([[-1.0]], [1.0], [1.0], "cube", C0=[1.0]), [[1.0]], "a design needs bounded slopes"),
        (Persidskii([[-1.0]], [1.0], [1.0], np.sin, C0=[1.0]), [[1.0]], "a design needs slopes"),
        (Persidskii(lambda t: [[-1.0]], [1.0], [1.0], "sin", C0=[1.0]), [[1.0]], "A0 vary: use plant.at"),
        (Persidskii([[-1.0]], [1.0], [1.0], "sin", C0=[1.0]), [[1.0, 2.0]], r"Pi has shape \(1, 2\)"),
        (Persidskii([[-1.0]], [1.0], [1.0], "sin", C0=[1.0]), [[2.0]], "J must be H Pi, differs by 1"),
        (
            Persidskii([[-1.0]], np.ones((1, 9)), np.ones((9, 1)), "sin", C0=[1.0]),
            [[1.0]],
            "at most 8 components",
        ),
    ],
)
def test_designs_that_cannot_start(plant: Persidskii, pi: Any, told: str) -> None:
    generator = Generator([[-1.0]], np.ones((1, plant.k)), J=np.ones((plant.r, 1)))
    with pytest.raises(ParameterError, match=told):
        DrivenObserver.design(plant, generator=generator, Pi=pi, decay=0.0)


@pytest.mark.parametrize("scale", [1e-8, 1.0, 1e8])
@pytest.mark.parametrize("shown", [1e-8, 1.0, 1e8])
def test_detectable_is_detectable_in_every_unit(scale: float, shown: float) -> None:
    a = scale * np.array([[1.0, 1.0], [0.0, -2.0]])
    assert undetectable(a, [[shown, 0.0]]) == []
    assert undetectable(a.T, [[0.0, shown]]) == []
    hidden = undetectable(scale * np.diag([1.0, -2.0]), [[0.0, shown]])
    assert [one / scale for one in hidden] == pytest.approx([1.0 + 0.0j])


def test_a_wrong_map_is_refused_with_its_residual() -> None:
    plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0])
    generator = Generator([[0.0]], L0=[2.0])
    told = r"Assumption 3\.2\.1: A0 Pi - Pi G C0 Pi - Pi S0 \+ B L0 = 0 fails, its residual is 0\.25"
    with pytest.raises(InfeasibleError, match=told):
        DrivenObserver.design(plant, generator=generator, Pi=[[1.75]], decay=1.0)
    assert DrivenObserver.design(plant, generator=generator, Pi=[[2.0]], decay=1.0).gain.shape == (1, 1)


@pytest.mark.parametrize("decay", [-0.1, np.inf, np.nan])
def test_a_decay_is_finite_and_not_negative(decay: float) -> None:
    plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0])
    with pytest.raises(ParameterError, match="decay must be finite and not below 0"):
        DrivenObserver.design(plant, generator=Generator([[0.0]], L0=[1.0]), Pi=[[1.0]], decay=decay)


def test_a_bound_knows_its_disturbances() -> None:
    plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0])
    bound = DrivenObserver.design(plant, generator=Generator([[0.0]], L0=[1.0]), Pi=[[1.0]], decay=1.0).bound
    assert bound(0.0, 1.0, v=1.0) > bound(0.0, 1.0)
    with pytest.raises(ParameterError, match="the disturbances are v, eps, w, received noise"):
        bound(0.0, 1.0, noise=1.0)


def test_slopes_without_bound_are_named_by_every_design() -> None:
    cubic = Persidskii([[0.0, 1.0], [0.0, -1.0]], [0.0, -1.0], [0.0, 1.0], "cube", C0=[1.0, 0.0])
    for design in (ReducedOrderObserver.design, FullOrderObserver.design):
        with pytest.raises(ParameterError, match="needs bounded slopes"):
            design(cubic)


MOTOR = [[0.0, 1.0, 0.0], [0.0, -1.0, 5.0], [0.0, -5.0, -100.0]]


@pytest.mark.parametrize(("factor", "decay"), [(1.0, 1e20), (1.0, 1e300), (1e298, 5.0), (1e-300, 5.0)])
@pytest.mark.parametrize("door", [ReducedOrderObserver.design, FullOrderObserver.design, Regulator.design])
def test_numbers_that_cannot_be_computed_with_are_refused(door: Any, factor: float, decay: float) -> None:
    plant = Persidskii(factor * np.array(MOTOR), None, None, "sin", [0.0, 0.0, 100.0], None, [1.0, 0.0, 0.0])
    # at 1e20 1/s some processors still compute, and prove that no matrices of a size that floats hold will do
    proved = InfeasibleError if decay == 1e20 else ParameterError
    with pytest.raises((ParameterError, proved), match=r"too many powers of ten apart|no choice satisfies"):
        door(plant, decay=decay)


@pytest.mark.parametrize(
    ("plant", "pair"),
    [
        (Persidskii([[0.0, 1.0], [0.0, 0.5]], C0=[0.0, 1.0]), r"^\(A0, C0\) is not detectable"),
        (
            Persidskii([[0.0, 0.0], [0.0, -1.0]], [0.0, 1.0], [0.0, 1.0], "tanh", C0=[0.0, 1.0]),
            r"^\(A0 \+ A1 D H, C0 \+ C1 D H\), D = diag\(0\), is not detectable",
        ),
    ],
)
def test_a_full_order_observer_is_refused_in_the_words_of_its_plant(plant: Persidskii, pair: str) -> None:
    with pytest.raises(InfeasibleError, match=pair):
        FullOrderObserver.design(plant)


def test_a_decay_of_zero_is_refused() -> None:
    plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], C0=[1.0, 0.0])
    with pytest.raises(ParameterError, match="decay must be finite and above 0, received 0"):
        FullOrderObserver.design(plant, decay=0.0)
