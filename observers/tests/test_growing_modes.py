"""A motion that grows refuses tracking, and is what excludes every choice of the matrices."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from evidence.observers.designs import outcome
from pointpred.errors import InfeasibleError, PointpredError
from pointpred_observers import Generator, Persidskii
from pointpred_observers.interconnected.regulated import Followed, Regulated, growing_mode, quadrant
from pointpred_observers.thesis import SectorBounds, certify_tracking, sector_bounds

SIZES = (3, 2)
"""States and components of f."""


def form(block: Any, vector: Any) -> float:
    """v* block v."""
    return float((vector.conj() @ block @ vector).real)


def definite(random: np.random.Generator, rows: int) -> Any:
    half = random.normal(size=(rows, rows))
    return half @ half.T


def regulated(random: np.random.Generator) -> Regulated:
    n, k = SIZES
    return Regulated(*(random.normal(size=shape) for shape in ((n, n), (n, k), (k, n))))


def followed(random: np.random.Generator) -> Followed:
    n, k = SIZES
    h = random.normal(size=(k, n))
    plant = Persidskii(-np.eye(n), random.normal(size=(n, k)), h, "tanh")
    return Followed(random.normal(size=(n, n)) - 2.0 * np.eye(n), plant.A1, h, sector_bounds(plant))


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=10)
def test_a_motion_that_grows_violates_assumption_3_2_3_for_all_matrices(seed: int) -> None:
    random = np.random.default_rng(seed)
    one, (n, k) = regulated(random), SIZES
    mode = one.growing()[1]
    if mode is None:
        return
    vector = np.concatenate([mode.state, mode.value, np.zeros(2 * n)])
    for _ in range(10):
        values = {name: definite(random, n) for name in ("P", "Gamma", "Xi")}
        values |= {name: np.diag(random.exponential(size=k)) for name in ("Omega", "Lambda")}
        phi = one.inequalities().blocks["Phi"](SimpleNamespace(**values))
        assert form(phi, vector) > 0.0


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=10)
def test_a_motion_that_grows_violates_assumption_3_2_6_for_all_matrices(seed: int) -> None:
    random = np.random.default_rng(seed)
    one, (n, k) = followed(random), SIZES
    mode = one.growing()[1]
    if mode is None:
        return
    vector = np.concatenate([mode.state, np.zeros(k), mode.value, np.zeros(n)])
    for _ in range(10):
        first, second = random.exponential(size=2)
        values: dict[str, Any] = {name: definite(random, n) for name in ("P", "Gamma")}
        values |= {
            name: np.diag(random.exponential(size=k)) for name in ("Lambda", "Omega1", "Omega2", "Upsilon")
        }
        values["Xi"] = definite(random, n) + first * one.sector.Sigma1 + second * one.sector.Psi1
        phi = one.inequalities().blocks["Phi"](SimpleNamespace(gamma1=first, gamma2=second, **values))
        assert form(phi, vector) > 0.0


@pytest.mark.parametrize("seed", [1, 4, 5, 7])
def test_what_has_matrices_has_no_motion_that_grows(seed: int) -> None:
    random = np.random.default_rng(seed)
    n, k = SIZES
    stable = random.normal(size=(n, n)) - 2.5 * np.eye(n)
    for one in (
        Regulated(stable, -random.normal(size=(n, k)), random.normal(size=(k, n))),
        Followed(
            stable,
            0.5 * random.normal(size=(n, k)),
            np.eye(k, n),
            SectorBounds(np.eye(n), np.eye(n), *[np.zeros((k, k))] * 4),
        ),
    ):
        try:
            one.inequalities().solve()
        except PointpredError:
            continue
        assert one.growing()[1] is None


def test_slopes_beyond_the_sector_do_not_count() -> None:
    """x' = -x + 2 f, f = d x: unstable from d = 1/2, which a sector of 0.4 excludes."""
    one = np.ones((1, 1))
    none = np.zeros((1, 1))
    for steepest, grows in ((0.4, False), (0.6, True)):
        sector = SectorBounds(steepest**2 * one, steepest**2 * one, none, none, none, none)
        assert (Followed(-one, 2.0 * one, one, sector).growing()[1] is not None) == grows
    assert Regulated(-one, 2.0 * one, one).growing()[1] is not None
    assert Regulated(-one, -2.0 * one, one).growing()[1] is None


def test_an_f_that_does_not_act_or_has_no_slope_leaves_the_linear_part() -> None:
    one, none = np.ones((1, 1)), np.zeros((1, 1))
    flat = SectorBounds(*[none] * 6)
    for rate, grows in ((-1.0, False), (1.0, True)):
        a = rate * one
        for system in (Regulated(a, none, one), Regulated(a, one, none), Followed(a, one, one, flat)):
            assert (system.growing()[1] is not None) == grows


def test_growth_within_rounding_proves_nothing() -> None:
    """An eigenvalue of 1e-12 beside entries of 1: the rounding of x' could as well make it negative."""
    for rate, grows in ((1e-12, False), (1e-4, True)):
        a = np.array([[rate, 0.0], [1.0, -1.0]])
        mode = growing_mode(a, np.zeros((2, 1)), np.ones((1, 2)), [quadrant(1.0)], lambda mode: True)
        assert (mode is not None) == grows


@pytest.mark.parametrize("seed", [2, 7])
def test_stiff_regulators_that_no_multipliers_decide_are_refused(seed: int) -> None:
    """Problems of the table of designs; only complex slopes refuse the first of them."""
    assert outcome("`certify_tracking`", "stiff", seed) == ("refused", None)


def test_the_refusal_names_eigenvalue_and_slopes() -> None:
    plant = Persidskii([[-1.0]], [2.0], [1.0], "tanh", [1.0], None, [1.0])
    regulator = Generator([[-1.0]], [2.0], None, [0.0], [0.0], [0.0])
    first = r"3\.2\.3: S \+ S~ D J has the eigenvalue 55\.2341 at D = diag\(28\.1171\), must lie left of 0"
    second = r"3\.2\.6: A~0 \+ A~1 D H has the eigenvalue 0\.199999 at D = diag\(0\.599999\), must lie left"
    with pytest.raises(InfeasibleError, match=f"{first}.*{second}"):
        certify_tracking(plant, regulator, [[1.0]])
