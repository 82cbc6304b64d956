"""Tracking control: margins of both theorems, what fails by name, the regulator as a stage in the loop."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred_observers import Generator, Persidskii, trajectory
from pointpred_observers.interconnected.tracking import closed_loop
from pointpred_observers.thesis import (
    SectorBounds,
    certify_tracking,
    regulator_stage,
    sector_bounds,
    theorem_3_2_2,
    theorem_3_2_3,
)


def pendulum(seed: int) -> tuple[Persidskii, Generator]:
    """A stable plant with a saturating spring, and the regulator of section 3.8 with Pi = I."""
    rng = np.random.default_rng(seed)
    a, b, c = rng.uniform(0.5, 2.0, 3)
    a0 = np.array([[-a, 1.0], [-1.0, -b]])
    a1, h, c0 = np.array([[-0.5], [0.0]]), np.array([[1.0, 0.0]]), np.array([[1.0, 0.0]])
    bb, l0, l1, g = (
        np.array([[1.0], [0.0]]),
        np.array([[-c, 0.0]]),
        np.array([[-0.5]]),
        np.array([[1.0], [0.2]]),
    )
    plant = Persidskii(a0, a1, h, "tanh", bb, bb, c0)
    return plant, Generator(a0 + bb @ l0 - g @ c0, a1 + bb @ l1, h, g, l0, l1, bb)


@given(st.integers(0, 2**31))
@settings(max_examples=6)
def test_both_functions_of_lyapunov_decay_along_trajectories(seed: int) -> None:
    plant, regulator = pendulum(seed)
    certificate = certify_tracking(plant, regulator, np.eye(2))
    assert min(certificate.margins.values()) > 0.0
    again = theorem_3_2_2(plant, regulator, np.eye(2)).check(certificate.regulator.values)
    assert again == certificate.regulator.margins
    again = theorem_3_2_3(plant, regulator, np.eye(2)).check(certificate.error.values)
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

    first = theorem_3_2_2(plant, regulator, pi)
    v = SimpleNamespace(P=some(2), Gamma=some(2), Xi=some(2), Omega=some(1), Lambda=some(1))
    w, f, dz, dw = one(2), one(1), one(2), one(2)
    speed = (g.S0 + g.G @ plant.C0) @ w + (g.S1 + g.G @ plant.C1) @ f + dz + dw
    change = 2.0 * w @ v.P @ speed + 2.0 * f @ v.Lambda @ h @ speed
    left = change + w @ v.Xi @ w + 2.0 * w @ h.T @ v.Omega @ f - dz @ v.Gamma @ dz - dw @ v.Gamma @ dw
    form = np.concatenate([w, f, dz, dw])
    assert form @ first.blocks["Phi"](v) @ form == pytest.approx(left)

    numbers = {name: some(1) for name in ("Lambda", "Omega1", "Omega2", "Upsilon")}
    sector = SectorBounds(some(2), some(2), *(some(1) for _ in range(4)))
    second = theorem_3_2_3(plant, regulator, pi, sector)
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


def test_the_regulator_as_a_stage_closes_the_loop() -> None:
    plant, regulator = pendulum(1)
    stage = regulator_stage(plant, regulator, start=[0.5, -0.5], step_s=1e-3)
    h = 2e-3

    def reference(t: float) -> Any:
        return [np.sin(2.0 * t)]

    x, times = np.array([1.0, 1.0]), np.arange(0.0, 4.0, h)
    for t in times:
        u = stage.update(t, [*plant.output(t, x), *reference(t)])
        x = trajectory(lambda s, one: plant.field(s, one, u, reference(s)), x, [t, t + h], step_s=h)[-1]  # noqa: B023
    exact = trajectory(
        lambda t, one: closed_loop(plant, regulator, t, one, rho=reference(t)),
        [1.0, 1.0, 0.5, -0.5],
        [0.0, 4.0],
    )[-1]  # fmt: skip
    assert np.abs(x - exact[:2]).max() < 5e-3  # the input is held for h: of first order in h


def test_the_plant_follows_its_reference() -> None:
    plant, regulator = pendulum(2)
    times = np.arange(0.0, 12.0, 0.5)
    both = trajectory(
        lambda t, one: closed_loop(plant, regulator, t, one, rho=[np.sin(t)]),
        [3.0, 0.0, 0.0, 0.0],
        times,
    )
    errors = np.linalg.norm(both[:, :2] - both[:, 2:], axis=1)
    assert errors[-1] < 1e-4 * errors[0]


def test_an_equality_that_fails_is_named_with_its_residual() -> None:
    plant, regulator = pendulum(3)
    wrong = Generator(
        regulator.S0 + np.eye(2),
        regulator.S1,
        regulator.J,
        regulator.G,
        regulator.L0,
        regulator.L1,
        regulator.E,
    )
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.1: A0 Pi .* = 0 fails, its residual is 1"):
        certify_tracking(plant, wrong, np.eye(2))


def test_the_assumption_that_fails_is_named() -> None:
    plant, _ = pendulum(3)
    unstable = Persidskii(plant.A0 + 4.0 * np.eye(2), plant.A1, plant.H, "tanh", plant.B, plant.B, plant.C0)
    none = np.zeros((1, 2))
    regulator = Generator(unstable.A0, unstable.A1, plant.H, np.zeros((2, 1)), none, [[0.0]], plant.B)
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.3: .*; Assumption 3\.2\.6: "):
        certify_tracking(unstable, regulator, np.eye(2))


def test_constants_of_the_sector() -> None:
    plant, _ = pendulum(3)
    found = sector_bounds(plant)
    rng = np.random.default_rng(0)
    for z, w in zip(rng.normal(size=(50, 2)), rng.normal(size=(50, 2)), strict=True):
        delta = plant.f(plant.H @ (z + w)) - plant.f(plant.H @ w)
        assert plant.f(plant.H @ z) @ plant.f(plant.H @ z) <= z @ found.Sigma1 @ z + 1e-12
        assert delta @ delta <= z @ found.Psi1 @ z + 1e-12
    with pytest.raises(CertificateError, match=r"Assumption 3\.2\.4: Sigma1 .* eigenvalue -0\.5"):
        sector_bounds(plant, Sigma1=0.5 * plant.H.T @ plant.H)
    with pytest.raises(ParameterError, match="the constants are Sigma1"):
        sector_bounds(plant, Sigma=np.eye(2))
    for slopes, told in [
        ((-1.0, 1.0), "needs an f that increases"),
        ((-1.0, np.inf), "needs bounded slopes"),
    ]:
        with pytest.raises(ParameterError, match=told):
            sector_bounds(Persidskii(plant.A0, plant.A1, plant.H, "sin", slopes=slopes))


def test_a_regulator_without_j_cannot_run() -> None:
    plant, regulator = pendulum(3)
    bare = Generator(regulator.S0, regulator.S1, None, regulator.G, regulator.L0, regulator.L1, regulator.E)
    with pytest.raises(ParameterError, match="a regulator needs J"):
        regulator_stage(plant, bare)
    with pytest.raises(ParameterError, match="a regulator needs J"):
        closed_loop(plant, bare, 0.0, np.zeros(4))
