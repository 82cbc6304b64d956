"""Error systems: H-infinity norms, L2 gains and decay beside closed forms and simulations."""

from __future__ import annotations

from math import asinh, pi, sqrt
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointpred_observers as o
from evidence.observers.designs import EXAMPLES, compared
from observers.tests import kept_designs as kept
from pointpred.errors import InfeasibleError
from pointpred_observers.files import decoded, encoded
from pointpred_observers.interconnected.design import DrivenObserver, FullOrderObserver
from pointpred_observers.interconnected.regulator import Regulator
from pointpred_observers.proofs.error_system import h_infinity, sloped_system
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import assumption_3_2_2, design_state_feedback
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.unknown_input.observer import UnknownInputObserver

RESONANCES = [(3.0, 0.1), (0.2, 0.4), (1e3, 0.01)]


def stable(rng: np.random.Generator, n: int, *, discrete: bool = False) -> np.ndarray:
    a = rng.normal(size=(n, n))
    values = np.linalg.eigvals(a)
    if discrete:
        return a * (0.9 / np.abs(values).max())
    return a - (float(values.real.max()) + rng.uniform(0.05, 1.0)) * np.eye(n)


def linear(a: Any, b: Any, c: Any, time: str = "continuous") -> o.ErrorSystem:
    a, b, c = (np.asarray(one, np.float64) for one in (a, b, c))
    return o.ErrorSystem(a[None], b[None], c, ("",), {"d": b.shape[1]}, time)


@pytest.mark.parametrize(("frequency", "damping"), RESONANCES)
def test_the_norm_of_a_resonance_is_known(frequency: float, damping: float) -> None:
    a = np.array([[0.0, 1.0], [-(frequency**2), -2.0 * damping * frequency]])
    norm, at = h_infinity(a, np.array([[0.0], [frequency**2]]), np.array([[1.0, 0.0]]))
    assert norm == pytest.approx(0.5 / (damping * sqrt(1.0 - damping**2)), rel=1e-9)
    assert at == pytest.approx(frequency * sqrt(1.0 - 2.0 * damping**2), rel=1e-4)


@pytest.mark.parametrize("pole", [0.5, -0.5, 0.99, 0.0])
def test_the_norm_of_a_discrete_lag_is_known(pole: float) -> None:
    norm, at = h_infinity(np.array([[pole]]), np.eye(1), np.eye(1), "discrete")
    assert norm == pytest.approx(1.0 / (1.0 - abs(pole)), rel=1e-9)
    assert pole == 0.0 or at == pytest.approx(0.0 if pole > 0.0 else pi, abs=1e-6)


@given(st.integers(0, 2**31), st.integers(1, 6), st.booleans())
@settings(max_examples=15)
def test_no_frequency_exceeds_the_norm_and_one_reaches_it(seed: int, n: int, discrete: bool) -> None:
    rng = np.random.default_rng(seed)
    a, b, c = stable(rng, n, discrete=discrete), rng.normal(size=(n, 2)), rng.normal(size=(2, n))
    norm, at = h_infinity(a, b, c, "discrete" if discrete else "continuous")

    def gain(w: float) -> float:
        place = np.exp(1j * w) if discrete else 1j * w
        return float(np.linalg.norm(c @ np.linalg.solve(place * np.eye(n) - a, b), 2))

    grid = np.linspace(0.0, pi, 400) if discrete else np.concatenate([[0.0], np.geomspace(1e-3, 1e3, 400)])
    assert max(map(gain, grid)) <= norm * (1.0 + 1e-8)
    assert gain(at) == pytest.approx(norm, rel=1e-8)


@pytest.mark.parametrize("time", ["continuous", "discrete"])
def test_the_proved_gain_of_a_linear_system_is_its_norm(time: str) -> None:
    rng = np.random.default_rng(11)
    for n in (1, 2, 4):
        a = stable(rng, n, discrete=time == "discrete")
        units, tick = 10.0 ** rng.uniform(-3.0, 3.0, n), 1e4 if time == "continuous" else 1.0
        a, b, c = (
            tick * a * units / units[:, None],
            rng.normal(size=(n, 1)) / units[:, None],
            rng.normal(size=(1, n)) * units,
        )
        found = o.l2_gain(linear(a, b, c, time))
        assert found.lower <= found.upper <= 1.002 * found.lower
        assert min(found.margins.values()) > 0.0


@given(st.integers(0, 2**31))
@settings(max_examples=5)
def test_no_signal_is_amplified_more_than_the_proved_gain(seed: int) -> None:
    rng = np.random.default_rng(seed)
    system = sloped_system(
        np.array([[0.0, 1.0], [-2.0, -1.0]]), np.array([[0.0], [-1.0]]), np.array([[1.0, 0.0]]),
        {"d": np.array([[0.0], [1.0]])}, slopes=((0.0, 1.0),), time="continuous",
    ).seen_as([[1.0, 0.0]])  # fmt: skip
    found = o.l2_gain(system)
    w, h = rng.uniform(0.5, 3.0), 0.05
    times = np.arange(0.0, 40.0, h)

    def push(t: float) -> float:
        return float(np.sin(w * t) * np.exp(-0.1 * t) * 5.0)

    states = o.trajectory(
        lambda t, x: [x[1], -2.0 * x[0] - x[1] - np.tanh(x[0]) + push(t)], [0.0, 0.0], times, step_s=h
    )
    ratio = np.linalg.norm(states[:, 0]) / np.linalg.norm([push(t) for t in times])
    assert ratio <= found.upper
    assert found.lower <= found.upper <= 1.4 * found.lower


@given(st.integers(0, 2**31), st.booleans())
@settings(max_examples=8)
def test_errors_stay_below_the_bound_for_slopes_that_change(seed: int, discrete: bool) -> None:
    rng = np.random.default_rng(seed)
    time = "discrete" if discrete else "continuous"
    a = np.array([[0.5, 0.3], [-0.2, 0.4]]) if discrete else np.array([[-1.0, 2.0], [-1.0, -2.0]])
    f, h = np.array([[0.2], [0.1]]), np.array([[1.0, -1.0]])
    system = sloped_system(a, f, h, {"d": np.eye(2)}, slopes=((-0.5, 1.0),), time=time)
    found = o.certify_decay(system)
    assert min(found.margins.values()) > 0.0
    phases, pushes = rng.uniform(0.0, 6.0, 3), 0.3 * rng.normal(size=2)

    def field(t: float, e: Any) -> Any:
        slope = 0.25 + 0.75 * np.sin(2.0 * t + phases[0])
        return (a + slope * f @ h) @ e + pushes * np.sin(t + phases[1])

    start = rng.normal(size=2)
    times = np.arange(0, 30) if discrete else np.arange(0.0, 8.0, 0.25)
    errors = o.trajectory(field, start, times, time=time)
    largest = float(np.linalg.norm(pushes))
    for t, e in zip(times, errors, strict=True):
        assert np.linalg.norm(e) <= found.bound(float(t), float(np.linalg.norm(start)), d=largest) + 1e-12


def test_the_decay_of_a_normal_system_is_certified_up_to_its_eigenvalue() -> None:
    system = linear(np.array([[-1.0, 5.0], [-5.0, -1.0]]), np.eye(2), np.eye(2))
    found = o.certify_decay(system, decay=0.99)
    assert found.bound.overshoot == pytest.approx(1.0, abs=1e-3)
    with pytest.raises(InfeasibleError):
        o.certify_decay(system, decay=1.01)
    with pytest.raises(InfeasibleError, match=r"eigenvalue 0\.5 at D = diag\(1\.5\), must lie left of 0"):
        o.certify_decay(
            sloped_system(
                -np.eye(1), np.eye(1), np.eye(1), {"d": np.eye(1)}, slopes=((0.0, 1.5),), time="continuous"
            )
        )


def test_a_certificate_of_a_decay_near_the_edge_keeps_its_margin() -> None:
    """A feedback's closed loop decays by little more than is certified."""
    plant = o.Persidskii(
        [[0.441, 0.302], [-0.0346, -1.208]], B=[0.2177, -1.088], C0=[-0.683, -0.777], time="discrete"
    )
    assert design_state_feedback(plant, decay=0.1).certificate.margins["V'"] > 5e-6


def test_the_error_system_of_an_observer_is_what_its_error_does() -> None:
    plant = o.Persidskii(
        [[-1.0, 0.5], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.0], lambda s: np.array([asinh(s[0])]), [0.0, 1.0],
        C0=[[1.0, 0.0]], slopes=(0.3, 1.0), domain=3.0,
    )  # fmt: skip
    generator = o.Generator([[0.0, 1.0], [-1.0, -0.2]], [0.0, -0.5], [[1.0, 0.0]])
    pi_map = np.eye(2)
    design = DrivenObserver.design(
        o.Persidskii(generator.S0, [0.0, -0.5], plant.H, plant.f, C0=plant.C0, domain=3.0),
        generator=generator,
        Pi=pi_map,
        decay=0.5,
    )
    system = design.error_system()
    g, m = design.generator, design.gain
    rng = np.random.default_rng(2)
    for _ in range(20):
        w, other, v, eps, dist = (rng.normal(size=k) for k in (2, 2, 1, 1, 2))
        true = g.S0 @ w + g.S1 @ plant.f(plant.H @ w) + dist
        y = plant.C0 @ w + eps + v
        copy = g.S0 @ other + g.S1 @ plant.f(plant.H @ other) + m @ (y - plant.C0 @ other)
        slope = (plant.f(plant.H @ w) - plant.f(plant.H @ other)) / (plant.H @ (w - other))
        share = float((slope[0] - 0.3) / 0.7)
        a = (1.0 - share) * system.A[0] + share * system.A[1]
        assert a @ (w - other) + system.B[0] @ np.concatenate([v, eps, dist]) == pytest.approx(true - copy)
    assert list(system.disturbances) == ["v", "eps", "w"]
    assert o.l2_gain(system.disturbed_by("v")).upper <= o.l2_gain(system).upper * 1.001


def test_the_error_system_of_a_reduced_observer_is_what_its_error_does() -> None:
    plant = o.Persidskii(
        [[0.0, 1.0], [0.0, -0.1]], [0.0, -2.0], [1.0, 0.0], "sin", [0.0, 1.0], None, [1.0, 0.0]
    )
    design = ReducedOrderObserver.design(plant, Pi=[[0.0, 1.0]], decay=3.0)
    system, observer, rng = design.error_system(), design.observer, np.random.default_rng(3)
    now = observer.at(0.0)
    for _ in range(20):
        x, u, v, delta = rng.normal(size=2), rng.normal(size=1), 0.1 * rng.normal(size=1), rng.normal(size=1)
        e = rng.normal(size=1)
        w = observer.invariant(0.0, x) + e
        moved = observer.field(0.0, w, plant.output(0.0, x) + v, u) + delta - now.Z @ plant.field(0.0, x, u)
        inner = now.J @ e + now.R @ v
        slope = (plant.f(plant.H @ x + inner) - plant.f(plant.H @ x)) / inner
        share = 0.5 * (float(slope[0]) + 1.0)
        a = (1.0 - share) * system.A[0] + share * system.A[1]
        b = (1.0 - share) * system.B[0] + share * system.B[1]
        assert a @ e + b @ np.concatenate([delta, v]) == pytest.approx(moved)


def test_the_error_system_of_an_unknown_input_observer_has_its_zeros() -> None:
    system = o.ParameterVaryingSystem(
        lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]), lambda p: np.array([[1.0], [0.0]]), np.eye(1, 2)
    )
    observer = UnknownInputObserver.design(system, o.Box({"k": (-3.0, -1.0)}), decay=0.5)
    errors = observer.error_system()
    assert errors.names == ("k = -3", "k = -1")
    for a, zero in zip(errors.A, (-3.0, -1.0), strict=True):
        assert np.abs(np.linalg.eigvals(a) - zero).min() < 1e-9
    assert o.certify_decay(errors, decay=0.5).bound.decay == 0.5


def test_the_error_system_of_an_interlaced_observer() -> None:
    steady = o.interlaced(kept.SYMBOLIC, kept.CIRCLE, upper=1, first=kept.W1, degree=2)
    observer = InterlacedObserver.design(steady, decay=0.3, gain=[[1.0], [0.0]])
    system = observer.error_system()
    assert system.A[0] == pytest.approx(np.array([[-1.0, 1.0], [-1.0, 0.0]]))
    # From noise to w1^: (s + ...) / (s^2 + s + 1), whose gain at 1 rad/s is 1.
    found = o.l2_gain(system.seen_as([[1.0, 0.0]]))
    assert found.lower == pytest.approx(1.0, rel=1e-6)
    assert found.frequency == pytest.approx(1.0, rel=1e-3)


def test_every_proof_with_slopes_of_a_domain_is_local() -> None:
    """Equal bounds leave one corner, outside the domain the slopes are others: there 4 is not attracted."""
    f, one = {"slopes": (1.0, 1.0), "domain": 1.0}, [1.0]
    plant = o.Persidskii([[1.0]], [-3.0], one, "saturation", one, None, one, **f)
    assert plant.field(0.0, [4.0])[0] > 0.0
    observer, regulator = FullOrderObserver.design(plant), Regulator.design(plant)
    system = observer.error_system()
    # A second state, not measured, upon which f of the first acts.
    a0, a1, h = [[-1.0, 1.0], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.3]
    fast = o.Persidskii(a0, a1, h, plant.f, C0=[1.0, 0.0], domain=1.0)
    local = [
        assumption_3_2_2(plant),
        system,
        o.certify_decay(system),
        o.l2_gain(system.disturbed_by("v")),
        ReducedOrderObserver.design(fast, decay=0.5).error_system(),
        design_state_feedback(plant, L1=[[0.0]]).certificate,
        decoded(encoded(Regulator.design(plant, L1=[[0.0]]))).feedback.certificate,
        regulator.observer.plant,
    ]
    assert [one.domain for one in local] == [1.0] * len(local)
    cancelled = design_state_feedback(plant, L1=[[3.0]]).certificate
    assert cancelled.domain == cancelled.system.domain == np.inf


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
