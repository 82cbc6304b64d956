"""Theorem 3.2.1: margins recomputed, errors within their bounds, refusals with their reason."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred_observers import Generator, Persidskii, design, stage, trajectory
from pointpred_observers.interconnected.design import DrivenObserver, certified_design
from pointpred_observers.proofs.bounds import decay_of, proved_bound
from pointpred_observers.simulations.signals import SeededSignal
from pointpred_observers.thesis import theorem_3_2_1


def random_pair(seed: int, *, time: str = "continuous") -> tuple[Persidskii, Generator, Any]:
    """A generator that reads itself through Pi = I, so that every equality holds with A0 = S0 and A1 = S1."""
    rng = np.random.default_rng(seed)
    q = int(rng.integers(1, 4))
    half = rng.normal(size=(q, q))
    s0 = half - half.T - 0.2 * np.eye(q) if time == "continuous" else 0.8 * np.linalg.qr(half)[0]
    s1 = (0.2 if time == "continuous" else 0.05) * rng.normal(size=(q, 2))
    c0, c1 = rng.normal(size=(1, q)), 0.1 * rng.normal(size=(1, 2))
    g = 0.1 * rng.normal(size=(q, 1))
    plant = Persidskii(
        s0 + g @ c0, s1 + g @ c1, rng.normal(size=(2, q)), ["sin", "tanh"], None, None, c0, c1, time=time
    )
    return plant, Generator(s0, s1, G=g), np.eye(q)


def audit(design: DrivenObserver) -> float:
    """The largest eigenvalue of d/dt of V along the error of each corner of the slopes, written anew."""
    v, g, plant = design.values, design.generator, design.plant
    m, j = design.gain, plant.H @ design.Pi
    worst = -np.inf
    for a in (-1.0, 1.0):
        for b in (0.0, 1.0):
            d = np.diag([a, b])
            e = g.S0 + g.S1 @ d @ j - m @ (plant.C0 @ design.Pi + plant.C1 @ d @ j)
            whole = np.hstack([e, -g.G, -m, np.eye(g.q)])
            n, p, q = whole.shape[1], plant.p, g.q
            lift = np.eye(q, n)
            supply = np.zeros((n, n))
            supply[:q, :q] = -v["Theta"]
            supply[q : q + p, q : q + p] = supply[q + p : q + 2 * p, q + p : q + 2 * p] = v["Gamma"]
            supply[q + 2 * p :, q + 2 * p :] = v["Xi"]
            if plant.time == "discrete":
                change = whole.T @ v["P"] @ whole - lift.T @ v["P"] @ lift
            else:
                change = lift.T @ v["P"] @ whole + whole.T @ v["P"] @ lift
            worst = max(worst, float(np.linalg.eigvalsh(change - supply).max()))
    return worst


@given(st.integers(0, 2**31), st.sampled_from(["continuous", "discrete"]))
@settings(max_examples=12)
def test_a_design_dissipates_at_every_slope(seed: int, time: str) -> None:
    plant, generator, pi = random_pair(seed, time=time)
    try:
        design = DrivenObserver.design(plant, generator=generator, Pi=pi, decay=0.0)
    except InfeasibleError:
        return  # said with a bound, which is what test_inequalities proves
    assert audit(design) < 1e-6
    again = theorem_3_2_1(plant, generator, pi).check(design.values)
    assert again == design.margins
    assert np.allclose(design.values["P"] @ design.gain, design.values["U"])


@given(st.integers(0, 2**31))
@settings(max_examples=6)
def test_the_error_stays_within_its_bound(seed: int) -> None:
    plant, generator, pi = random_pair(seed)
    try:
        design = DrivenObserver.design(plant, generator=generator, Pi=pi, decay=0.1)
    except InfeasibleError:
        return
    g, m = design.generator, design.gain
    j, q = plant.H @ pi, g.q
    v, w = SeededSignal(seed, 1, 0.05, period_s=0.1), SeededSignal(seed + 1, q, 0.05, period_s=0.1)

    def field(t: float, both: Any) -> Any:
        true, seen = both[:q], both[q:]
        psi = plant.output(t, true)  # the plant follows x = Pi w: Pi = I, eps = 0
        dw = g.S0 @ true + g.S1 @ plant.f(j @ true) + g.G @ psi + w(t)
        y = psi + v(t)
        dz = g.S0 @ seen + g.S1 @ plant.f(j @ seen) + g.G @ y + m @ (y - plant.output(t, seen))
        return np.concatenate([dw, dz])

    rng = np.random.default_rng(seed)
    start = np.concatenate([rng.normal(size=q), np.zeros(q)])
    times = np.arange(0.0, 4.0, 0.1)
    both = trajectory(field, start, times, step_s=0.01)
    errors = np.linalg.norm(both[:, :q] - both[:, q:], axis=1)
    bounds = [design.bound(t, errors[0], v=0.05, w=0.05 * np.sqrt(q)) for t in times]
    assert (errors <= np.array(bounds) + 1e-9).all()
    assert design.bound.decay >= 0.1 - 1e-6


def test_noise_acts_through_g_and_through_the_gain() -> None:
    """e' = -2 e - 2 v + w, V' <= -2 V + (v^2 + v~^2) (1 + 1e-6) + ...: constant noise ends at abs(e) = v."""
    plant = Persidskii([[-2.0]], None, None, "sin", [1.0], None, [1.0])
    generator = Generator([[-1.0]], G=[1.0], L0=[2.0])
    values = {"P": [[1.0]], "Theta": [[2.0 - 1e-6]], "Gamma": [[1.0 + 1e-6]], "Xi": [[1e8]]}
    design = certified_design(plant, generator, [[1.0]], [[1.0]], values)
    system = design.error_system()
    assert np.allclose(system.A, -2.0)
    assert np.allclose(system.B, [[[-2.0, -1.0, 1.0]]])
    stage = design.stage(start=[1.0])
    for t in np.arange(0.0, 12.0, 0.1):  # the generator at rest at 0, but for the noise that the stage reads
        error = abs(float(stage.update(t, [0.25])[0]))
        assert error <= design.bound(t, 1.0, v=0.25)
    assert error == pytest.approx(0.25, rel=1e-6)
    assert design.bound(12.0, 1.0, v=0.25) < 0.2501
    assert design.bound.gains[0] == pytest.approx(np.sqrt(2.0) * design.bound.gains[1])
    without = Persidskii([[-1.0]], None, None, "sin", [1.0], None, [1.0])
    filtered = DrivenObserver.design(without, generator=Generator([[-1.0]], L0=[0.0]), Pi=[[1.0]], decay=0.0)
    assert filtered.bound.gains[0] == filtered.bound.gains[1]


@given(st.integers(0, 2**31), st.sampled_from(["continuous", "discrete"]))
@settings(max_examples=12)
def test_every_gain_covers_what_a_constant_disturbance_leaves(seed: int, time: str) -> None:
    plant, generator, pi = random_pair(seed, time=time)
    try:
        design = DrivenObserver.design(plant, generator=generator, Pi=pi, decay=0.0)
    except InfeasibleError:
        return
    for name, gain in zip(design.bound.disturbances, design.bound.gains, strict=True):
        system = design.error_system().disturbed_by(name)
        for a, b in zip(system.A, system.B, strict=True):
            rest = np.linalg.solve(a if time == "continuous" else np.eye(len(a)) - a, b)
            assert np.linalg.norm(rest, 2) <= gain * (1.0 + 1e-9)


def test_the_stage_of_a_design_estimates_the_generator() -> None:
    plant, generator, pi = random_pair(8)
    design = DrivenObserver.design(plant, generator=generator, Pi=pi, decay=0.0)
    g, j = design.generator, plant.H @ pi
    times = np.cumsum(np.random.default_rng(0).uniform(0.002, 0.02, 1500))

    def field(t: float, w: Any) -> Any:
        return g.S0 @ w + g.S1 @ plant.f(j @ w) + g.G @ plant.output(t, w) + 0.3 * np.cos(t)

    # The generator is driven by something known: E rho with rho = cos t.
    driven = Generator(g.S0, g.S1, G=g.G, E=np.full((g.q, 1), 0.3))
    watched = Persidskii(
        plant.A0, plant.A1, plant.H, plant.f, None, np.full((g.q, 1), 0.3), plant.C0, plant.C1
    )
    stage = DrivenObserver.design(watched, generator=driven, Pi=pi, decay=0.0).stage()
    w = trajectory(field, np.ones(g.q), times, step_s=5e-3)
    rows = [stage.update(t, [*plant.output(t, one), np.cos(t)]) for t, one in zip(times, w, strict=True)]
    errors = np.abs(np.array(rows)[:, : g.q] - w).max(axis=1)
    assert errors[0] > 0.5
    assert errors[-1] < 1e-3
    assert np.allclose(np.array(rows)[:, g.q :], np.array(rows)[:, : g.q] @ pi.T)


def test_the_region_keeps_every_argument_in_the_domain() -> None:
    a0, a1, row = [[-1.0, 1.0], [-1.0, 0.0]], [-0.2, 0.0], [1.0, 0.0]
    plant = Persidskii(a0, a1, row, "cube", C0=row, slopes=(0.0, 12.0), domain=2.0)
    design = DrivenObserver.design(plant, generator=Generator(plant.A0, plant.A1), Pi=np.eye(2), decay=0.0)
    level, radius = design.region(0.5)
    angles = np.linspace(0.0, 2.0 * np.pi, 400)
    circle = np.array([np.cos(angles), np.sin(angles)])
    edge = np.linalg.solve(np.linalg.cholesky(design.values["P"]).T, circle) * np.sqrt(level)
    assert np.abs(plant.H @ edge).max() == pytest.approx(1.5, rel=1e-3)
    ball = radius * circle
    assert np.einsum("ia,ij,ja->a", ball, design.values["P"], ball).max() == pytest.approx(level, rel=1e-3)
    assert design.region([0.5]) == (level, radius)
    with pytest.raises(ParameterError, match="reach must be"):
        design.region(-1.0)
    with pytest.raises(CertificateError, match="the trajectory reaches 2, the slopes hold within 2 only"):
        design.region(2.0)
    everywhere = Persidskii(plant.A0, plant.A1, plant.H, "sin", C0=plant.C0)
    one = DrivenObserver.design(everywhere, generator=Generator(plant.A0, plant.A1), Pi=np.eye(2), decay=0.0)
    assert one.region(9.0) == (np.inf, np.inf)


def test_theorem_3_3_1_as_printed_is_broken_and_with_its_factor_holds() -> None:
    """e' = -e/2 + delta rests at 2 delta; V = 4 e^2 decays as asked with Xi = 0.01 and gamma = 0.9."""
    p, xi, gamma = np.array([[4.0]]), np.array([[0.01]]), 0.9
    assert -1.0 * 4.0 + 0.01 + gamma * 4.0 < 0.0
    printed = 1.0 / np.sqrt(gamma)
    assert printed < 2.0
    bound = proved_bound(p, decay_of(p, xi, "continuous"), {"delta": 4.0 / gamma})
    assert bound(1e9, 0.0, delta=1.0) >= 2.0


@given(st.integers(0, 2**31))
@settings(max_examples=20)
def test_bounds_hold_for_linear_errors(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a = rng.normal(size=(3, 3))
    a -= (np.linalg.eigvalsh(a + a.T).max() / 2 + 0.2) * np.eye(3)
    p = np.eye(3)
    theta = -(a + a.T) * 0.5
    gamma = np.linalg.inv(theta)  # -theta/... : 2 e'w <= e' theta e + w' theta^-1 w
    drive = float(np.linalg.eigvalsh(gamma)[-1])
    bound = proved_bound(p, decay_of(p, theta, "continuous"), {"w": drive})
    rest = -np.linalg.solve(a, np.eye(3)[0])
    for t in (0.1, 1.0, 5.0):
        assert np.linalg.norm(expm(a * t), 2) <= bound(t, 1.0) + 1e-12
    assert np.linalg.norm(rest) <= bound(1e3, 0.0, w=1.0)


@pytest.mark.parametrize("kind", ["full", "reduced", "regulator"])
def test_a_misspelt_option_is_told_what_there_is(kind: str) -> None:
    plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], B=[0.0, 1.0], C0=[1.0, 0.0])
    with pytest.raises(ParameterError, match=f"dekay is no option of kind '{kind}', which has"):
        design(plant, kind, dekay=2.0)
    with pytest.raises(ParameterError, match=rf"strat is no option of kind '{kind}', which has .*start"):
        stage(design(plant, kind), strat=[0.0, 0.0])
