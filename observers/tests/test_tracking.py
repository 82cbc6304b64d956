"""Tracking control: margins of both theorems, what fails by name, the regulator as a stage in the loop."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from evidence.observers.designs import outcome
from pointpred.errors import CertificateError, InfeasibleError, ParameterError, PointpredError
from pointpred_observers import Generator, Persidskii, thesis, trajectory
from pointpred_observers.interconnected.tracking import (
    Followed,
    Regulated,
    closed_loop,
    growing_mode,
    quadrant,
)


def pendulum(seed: int) -> tuple[Persidskii, Generator]:
    """A stable plant with a saturating spring, and the regulator of section 3.8 with Pi = I."""
    rng = np.random.default_rng(seed)
    a, b, c = rng.uniform(0.5, 2.0, 3)
    a0 = np.array([[-a, 1.0], [-1.0, -b]])
    a1, h, c0 = np.array([[-0.5], [0.0]]), np.array([[1.0, 0.0]]), np.array([[1.0, 0.0]])
    bb, g = np.array([[1.0], [0.0]]), np.array([[1.0], [0.2]])
    l0, l1 = np.array([[-c, 0.0]]), np.array([[-0.5]])
    plant = Persidskii(a0, a1, h, "tanh", bb, bb, c0)
    return plant, Generator(a0 + bb @ l0 - g @ c0, a1 + bb @ l1, h, g, l0, l1, bb)


@given(st.integers(0, 2**31))
@settings(max_examples=6)
def test_both_functions_of_lyapunov_decay_along_trajectories(seed: int) -> None:
    plant, regulator = pendulum(seed)
    certificate = thesis.certify_tracking(plant, regulator, np.eye(2))
    assert min(certificate.margins.values()) > 0.0
    again = thesis.theorem_3_2_2(plant, regulator, np.eye(2)).check(certificate.regulator.values)
    assert again == certificate.regulator.margins
    again = thesis.theorem_3_2_3(plant, regulator, np.eye(2)).check(certificate.error.values)
    assert again == certificate.error.margins
    values = certificate.error.values

    def lyapunov(z: Any) -> float:
        s = float((plant.H @ z)[0])
        return float(z @ values["P"] @ z + 2.0 * values["Lambda"][0, 0] * np.log(np.cosh(s)))

    both = trajectory(
        lambda t, one: closed_loop(plant, regulator, t, one),
        [2.0, -1.0, -1.0, 3.0],
        np.arange(0.0, 6.0, 0.1),
        step_s=0.02,
    )
    levels = [lyapunov(one[:2] - one[2:]) for one in both]
    assert (np.diff(levels) < 0.0).all()
    assert levels[-1] < 1e-2 * levels[0]


@given(st.integers(0, 2**31))
@settings(max_examples=10)
def test_the_blocks_are_what_the_derivative_of_the_lyapunov_function_needs(seed: int) -> None:
    """Phi as a quadratic form, against V' written from the differential equations."""
    rng = np.random.default_rng(seed)
    plant, regulator = pendulum(seed)
    plant = Persidskii(plant.A0, plant.A1, plant.H, "tanh", plant.B, None, plant.C0, [[0.4]])
    regulator = Generator(regulator.S0, regulator.S1, None, regulator.G, regulator.L0, regulator.L1)
    g, h, pi = regulator.beside(plant), plant.H, np.eye(2)

    def some(rows: int) -> Any:
        half = rng.normal(size=(rows, rows))
        return half + half.T

    def one(count: int) -> Any:
        return rng.normal(size=count)

    first = thesis.theorem_3_2_2(plant, regulator, pi)
    v = SimpleNamespace(P=some(2), Gamma=some(2), Xi=some(2), Omega=some(1), Lambda=some(1))
    w, f, dz, dw = one(2), one(1), one(2), one(2)
    speed = (g.S0 + g.G @ plant.C0) @ w + (g.S1 + g.G @ plant.C1) @ f + dz + dw
    change = 2.0 * w @ v.P @ speed + 2.0 * f @ v.Lambda @ h @ speed
    left = change + w @ v.Xi @ w + 2.0 * w @ h.T @ v.Omega @ f - dz @ v.Gamma @ dz - dw @ v.Gamma @ dw
    form = np.concatenate([w, f, dz, dw])
    assert form @ first.blocks["Phi"](v) @ form == pytest.approx(left)

    numbers = {name: some(1) for name in ("Lambda", "Omega1", "Omega2", "Upsilon")}
    sector = thesis.SectorBounds(some(2), some(2), *(some(1) for _ in range(4)))
    second = thesis.theorem_3_2_3(plant, regulator, pi, sector)
    v = SimpleNamespace(
        P=some(2), Gamma=some(2), Xi=some(2), gamma1=rng.normal(), gamma2=rng.normal(), **numbers
    )
    z, f, delta, d = one(2), one(1), one(1), one(2)
    speed = (plant.A0 - g.G @ plant.C0) @ z + (plant.A1 - g.G @ plant.C1) @ delta + d
    change = 2.0 * z @ v.P @ speed + 2.0 * f @ v.Lambda @ h @ speed
    left = (
        change
        + z @ v.Xi @ z
        + 2.0 * z @ h.T @ (v.Omega1 @ f + v.Omega2 @ delta)
        + 2.0 * f @ v.Upsilon @ delta
    )
    left += -v.gamma1 * f @ f - v.gamma2 * delta @ delta - d @ v.Gamma @ d
    form = np.concatenate([z, f, delta, d])
    assert form @ second.blocks["Phi"](v) @ form == pytest.approx(left)
    r1 = v.Xi - v.gamma1 * sector.Sigma1 - v.gamma2 * sector.Psi1
    r2 = v.Omega1 - v.gamma1 * sector.Sigma2 - v.gamma2 * sector.Psi2
    r3, r4 = v.Omega2 - v.gamma1 * sector.Sigma3, v.Upsilon - v.gamma1 * sector.Sigma4
    whole = r1 + h.T @ (r2 + r3) @ h
    for name, expected in (("R1", r1), ("R2", r2), ("R3", r3), ("R4", r4), ("R1 + H'(R2 + R3) H", whole)):
        assert np.allclose(second.blocks[name](v), -expected), name


def test_constants_of_the_sector() -> None:
    plant, _ = pendulum(3)
    found = thesis.sector_bounds(plant)
    rng = np.random.default_rng(0)
    for z, w in zip(rng.normal(size=(50, 2)), rng.normal(size=(50, 2)), strict=True):
        delta = plant.f(plant.H @ (z + w)) - plant.f(plant.H @ w)
        assert plant.f(plant.H @ z) @ plant.f(plant.H @ z) <= z @ found.Sigma1 @ z + 1e-12
        assert delta @ delta <= z @ found.Psi1 @ z + 1e-12
    with pytest.raises(CertificateError, match=r"Assumption 3\.2\.4: Sigma1 .* eigenvalue -0\.5"):
        thesis.sector_bounds(plant, Sigma1=0.5 * plant.H.T @ plant.H)
    for slopes, told in [
        ((-1.0, 1.0), "needs an f that increases"),
        ((-1.0, np.inf), "needs bounded slopes"),
    ]:
        with pytest.raises(ParameterError, match=told):
            thesis.sector_bounds(Persidskii(plant.A0, plant.A1, plant.H, "sin", slopes=slopes))


SIZES = (3, 2)
"""States and components of f."""


def form(block: Any, vector: Any) -> float:
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
    return Followed(random.normal(size=(n, n)) - 2.0 * np.eye(n), plant.A1, h, thesis.sector_bounds(plant))


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
    first = Regulated(stable, -random.normal(size=(n, k)), random.normal(size=(k, n)))
    sector = thesis.SectorBounds(np.eye(n), np.eye(n), *[np.zeros((k, k))] * 4)
    second = Followed(stable, 0.5 * random.normal(size=(n, k)), np.eye(k, n), sector)
    for one in (first, second):
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
        sector = thesis.SectorBounds(steepest**2 * one, steepest**2 * one, none, none, none, none)
        assert (Followed(-one, 2.0 * one, one, sector).growing()[1] is not None) == grows
    assert Regulated(-one, 2.0 * one, one).growing()[1] is not None
    assert Regulated(-one, -2.0 * one, one).growing()[1] is None


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
        thesis.certify_tracking(plant, regulator, [[1.0]])
