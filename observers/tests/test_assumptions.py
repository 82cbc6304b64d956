"""Assumptions 3.2.2, 3.2.3, 3.2.6 and 4.4.2 beside simulations, eigenvalues and the thesis's examples."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointpred_observers as o
from observers.tests.kept_designs import DRIVEN as OVEN
from pointpred.errors import CertificateError, InfeasibleError
from pointpred_observers import thesis
from pointpred_observers.examples import academic
from pointpred_observers.interconnected.assumptions import joined
from pointpred_observers.triangular.forms import enclosure

sp = pytest.importorskip("sympy")
W1, W2, U = sp.symbols("w1 w2 u")
X = X1, X2, X3, X4 = sp.symbols("x1:5")
OSCILLATOR = o.SymbolicGenerator((W1, W2), (W2, -W1))


def test_example_1_satisfies_3_2_2_near_the_origin_and_not_far_from_it() -> None:
    plant, generator = academic()
    inside = o.Persidskii(f="sin", **plant.matrices(0.0), slopes=(float(np.cos(0.5)), 1.0), domain=0.5)
    near = thesis.assumption_3_2_2(inside, generator)
    assert near.domain == 0.5
    assert min(near.margins.values()) > 0.0
    with pytest.raises(
        InfeasibleError, match=r"Assumption 3\.2\.2: .* at D = diag\(-1\), must lie left of 0"
    ):
        thesis.assumption_3_2_2(plant, generator)


@given(st.integers(0, 2**31))
@settings(max_examples=6)
def test_the_plant_approaches_its_map_within_the_bound(seed: int) -> None:
    """A reciprocal interconnection: the output is fed back, G is not 0."""
    rng = np.random.default_rng(seed)
    a, g = -np.diag(rng.uniform(0.5, 2.0, 2)) + [[0.0, 0.5], [-0.5, 0.0]], 0.3 * rng.normal(size=(2, 1))
    c = np.array([[1.0, 0.0]])
    plant = o.Persidskii(a, [-0.5, 0.2], [1.0, 0.0], "tanh", np.eye(2), None, c)
    l0 = 0.2 * rng.normal(size=(2, 2))
    generator = o.Generator(a + l0 - g @ c, [-0.5, 0.2], [[1.0, 0.0]], g, l0)
    map_ = np.eye(2)
    found = thesis.assumption_3_2_2(plant, generator, map_)
    push = 0.2 * rng.normal(size=2)

    def field(t: float, both: Any) -> Any:
        return thesis.closed_loop(plant, generator, t, both, d=push * np.sin(t))

    start = rng.normal(size=4)
    times = np.arange(0.0, 6.0, 0.25)
    both = o.trajectory(field, start, times, step_s=0.02)
    for t, one in zip(times, both, strict=True):
        bound = found.bound(
            float(t), float(np.linalg.norm(start[:2] - start[2:])), d=float(np.linalg.norm(push))
        )
        assert np.linalg.norm(one[:2] - one[2:]) <= bound + 1e-12


def test_a_linear_plant_satisfies_3_2_2_exactly_if_it_is_stable() -> None:
    rng = np.random.default_rng(8)
    for _ in range(6):
        a = rng.normal(size=(3, 3)) - rng.uniform(0.0, 2.5) * np.eye(3)
        plant = o.Persidskii(a, None, None, "sin", B=[1.0, 0.0, 0.0])
        if np.linalg.eigvals(a).real.max() < 0.0:
            assert min(thesis.assumption_3_2_2(plant).margins.values()) > 0.0
        else:
            with pytest.raises(InfeasibleError, match="the error system has the eigenvalue"):
                thesis.assumption_3_2_2(plant)


def test_assumption_3_2_3_by_hand() -> None:
    """S = -1, S~ = -2, J = 1: the entries of Phi are written out."""
    plant = o.Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
    regulator = o.Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0])
    p, gamma, xi, omega, lift = 2.0, 99.0, 1.0, 4.0, 1.0
    across = -2.0 * p - lift + omega
    phi = np.array(
        [
            [-2.0 * p + xi, across, p, p],
            [across, -4.0 * lift, lift, lift],
            [p, lift, -gamma, 0.0],
            [p, lift, 0.0, -gamma],
        ]
    )
    printed = {"P": p, "Gamma": gamma, "Xi": xi, "Omega": omega, "Lambda": lift}
    margins = thesis.assumption_3_2_3(plant, regulator, [[1.0]]).check(printed)
    assert margins["Phi"] == pytest.approx(-np.linalg.eigvalsh(phi)[-1])
    with pytest.raises(CertificateError, match=r"Assumption 3\.2\.3: Phi has the eigenvalue"):
        thesis.assumption_3_2_3(plant, regulator, [[1.0]]).check(printed | {"Xi": 4.0})


def nine(stiffness: float = 3.0) -> Any:
    y1, y2, y3, y4 = sp.symbols("y1:5")
    spring = 3 * y3 + stiffness * y3**3 + sp.Rational(3, 5) * y4
    rows = (y2, -spring, y4, -2 * spring + sp.Rational(3, 5) * (y1 - y3) + 2 * (y2 - y4) - U)
    plant = o.SymbolicSystem((y1, y2, y3, y4), rows, U, outputs=(y3,))
    return o.interlaced(plant, OSCILLATOR, 2, W1 + W2, degree=3), y3


def test_example_9_satisfies_4_4_2_in_a_region() -> None:
    steady, y3 = nine()
    found = thesis.assumption_4_4_2(steady, {y3: (-0.3, 0.3)})
    assert found.C.tolist() == [[1.0, 1.0]]
    low, high = found.terms["y3**2"]
    assert -1e-12 < low <= 0.0
    assert high == pytest.approx(0.09, rel=1e-3)
    assert min(found.certificate.margins.values()) > 0.0
    slope = steady.system.field[1].diff(y3)
    assert float(slope.subs(y3, 0.3)) == pytest.approx(found.certificate.system.A[:, 1, 2].min(), rel=1e-3)


@pytest.mark.parametrize("expression", ["x*y - x**2*sin(z)", "exp(x)*y/(2 + z)", "x**3", "sqrt(2 + x*y*z)"])
def test_an_enclosure_holds_every_value_and_little_more(expression: str) -> None:
    symbols = sp.symbols("x y z")
    box = dict(zip(symbols, [(-1.0, 1.5), (0.2, 1.0), (-0.5, 1.0)], strict=True))
    function = sp.sympify(expression)
    low, high = enclosure(function, box)
    grid = np.meshgrid(*(np.linspace(*side, 25) for side in box.values()))
    values = np.broadcast_to(sp.lambdify(symbols, function)(*grid), grid[0].shape)
    least, most = float(values.min()), float(values.max())
    assert low <= least
    assert most <= high
    assert high - low <= 1.35 * (most - least)


def test_two_solutions_of_example_9_approach_each_other_within_the_bound() -> None:
    steady, y3 = nine()
    found = thesis.assumption_4_4_2(steady, {str(y3): (-0.3, 0.3)})
    system = steady.system
    rows = sp.lambdify([*system.states, U], system.field)
    push = sp.lambdify((W1, W2), steady.input)
    starts = [np.array([0.02, 0.0, 0.05, -0.02]), np.array([-0.05, 0.03, -0.04, 0.02])]
    times = np.arange(0.0, 15.0, 0.5)
    runs = [
        o.trajectory(
            lambda t, x: rows(*x, push(0.05 * np.cos(t), -0.05 * np.sin(t))), one, times, step_s=0.02
        )
        for one in starts
    ]
    assert max(np.abs(run[:, 2]).max() for run in runs) < 0.3
    first = float(np.linalg.norm(starts[0] - starts[1]))
    for t, one, other in zip(times, *runs, strict=True):
        assert np.linalg.norm(one - other) <= found.bound(float(t), first) + 1e-9


@pytest.mark.slow
def test_example_8_converges_too_slowly_at_rest_for_an_exponential_bound() -> None:
    rows = (-X1 + X2**2 * X3, -X2 + X3, -(X3**3) + X4, -X4 + (1 + X3**2) * U)
    steady = o.interlaced(o.SymbolicSystem(X, rows, U, outputs=(X3,)), OSCILLATOR, 2, W1, degree=3)
    region = {X2: (-0.1, 0.1), X3: (-0.1, 0.1), W1: (-0.1, 0.1), W2: (-0.1, 0.1)}
    with pytest.raises(InfeasibleError, match=r"Assumption 4\.4\.2: the error system has the eigenvalue"):
        thesis.assumption_4_4_2(steady, region)


@pytest.mark.parametrize(("force", "degree"), [(X1**3, 3), (sp.sin(X1), 1)])
def test_the_residual_of_a_truncated_steady_state_is_a_disturbance(force: Any, degree: int) -> None:
    """x1' = -x1 - x1^3 + x2: started on the series, x1 leaves it by what the residual makes of it."""
    plant = o.SymbolicSystem((X1, X2), (-X1 - force + X2, -X2 + U), U, outputs=(X2,))
    steady = o.interlaced(plant, OSCILLATOR, 1, W1, degree=degree)
    assert not steady.exact
    found = thesis.assumption_4_4_2(steady, {X1: (-0.8, 0.8), W1: (-1.0, 1.0), W2: (-1.0, 1.0)})
    function: Any = steady.function()
    rows = sp.lambdify([X1, X2, U], steady.system.field)

    def w(t: Any) -> Any:
        return np.array([np.cos(t), -np.sin(t)])

    times = np.arange(0.0, 20.0, 0.5)
    run = o.trajectory(lambda t, x: rows(*x, function(w(t))[2]), function(w(0.0))[:2], times, step_s=0.1)
    errors = np.linalg.norm(run - function(w(times))[:2].T, axis=1)
    assert np.abs(run[:, 0]).max() < 0.8
    assert errors.max() > 1e-3
    assert (errors <= [found.bound(float(t), 0.0) for t in times]).all()
    assert found.bound.rest == found.residual * found.bound.gains[0]


TURNING = [[0.0, 1.0], [-4.0, 0.0]]


def test_assumption_1_3_1_holds_for_an_oscillator_and_a_stable_plant() -> None:
    found = thesis.assumption_1_3_1(OVEN, o.Generator(TURNING, L0=[1.0, 0.0]))
    # tanh has the slope 1 at 0: the linear part is ((-1, 0.5), (-1, -2)).
    assert found.decay == pytest.approx(1.5)
    assert np.allclose(sorted(one.imag for one in found.eigenvalues), [-2.0, 2.0])
    assert found.assumed == ()
    turning = o.Generator(TURNING, [0.0, -1.0], [[1.0, 0.0]], None, [1.0, 0.0])
    assert thesis.assumption_1_3_1(OVEN, turning).assumed == ("the generator is neutrally stable",)
    sampled = thesis.assumption_1_3_1(o.c2d(OVEN, 0.1), o.Generator([[0.6, 0.8], [-0.8, 0.6]], L0=[1.0, 0.0]))
    assert sampled.decay == pytest.approx(0.15, rel=0.05)


STILL = o.Generator([[0.0]], L0=[1.0])
LINEAR = o.Persidskii([[-1.0, 0.0], [0.0, -2.0]], None, None, "sin", [1.0, 1.0], None, [1.0, 1.0])


@pytest.mark.parametrize(
    ("plant", "generator", "told"),
    [
        (LINEAR, o.Generator([[0.5]], L0=[1.0]), "a motion of the eigenvalue 0.5 grows"),
        (LINEAR, o.Generator([[-0.5]], L0=[1.0]), "a motion of the eigenvalue -0.5 decays"),
        (LINEAR, o.Generator([[0.0, 1.0], [0.0, 0.0]], L0=[1.0, 0.0]), "the eigenvalue .* is multiple"),
        (LINEAR, o.Generator([[0.0, 1e6, 0.0], [-1e6, 0.0, 0.0], [0.0, 0.0, 1.0]]), "eigenvalue 1 grows"),
        (LINEAR, o.Generator([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1e-5]]), "-1e-05 decays"),
        (LINEAR, o.Generator(np.zeros((2, 2)), L0=[1.0, 0.0]), "eigenvalue 0 of the generator never shows"),
        (o.c2d(LINEAR, 0.1), o.Generator([[1.1]], L0=[1.0]), r"a motion of the eigenvalue 1\.1 grows"),
        (o.Persidskii([[1.0]], B=[1.0], C0=[1.0]), STILL, "the eigenvalue 1, must lie left of 0"),
        (o.Persidskii(LINEAR.A0, B=[1.0, 0.0], C0=[1.0, 1.0]), STILL, "eigenvalue -2 is reached by no input"),
        (o.Persidskii(LINEAR.A0, B=[1.0, 1.0], C0=[0.0, 1.0]), STILL, "eigenvalue -1 of the .* never shows"),
    ],
)  # fmt: skip
def test_what_assumption_1_3_1_excludes_is_named(
    plant: o.Persidskii, generator: o.Generator, told: str
) -> None:
    with pytest.raises(InfeasibleError, match=rf"Assumption 1\.3\.1: .*{told}"):
        thesis.assumption_1_3_1(plant, generator)


def test_the_observer_of_remark_3_2_2_is_the_one_that_is_printed() -> None:
    """Its field from the remark, and its estimates from far beyond x = Pi w."""
    generator = o.Generator(TURNING, [0.3, 0.0], [[0.0, 1.0]], [0.2, 0.1], [1.0, 0.0], [0.5])
    found, (n, q) = thesis.remark_3_2_2(OVEN, generator, decay=0.5), (2, 2)
    assert min(found.margins.values()) > 0.0
    assert found.bound.decay >= 0.5
    g, f = generator.beside(OVEN), OVEN.f
    lx, lw = found.gain[:n], found.gain[n:] - g.G

    def printed(x: Any, w: Any, y: Any) -> Any:
        missing = y - OVEN.C0 @ x
        u = g.L0 @ w + g.L1 @ f(g.J @ w)
        dx = OVEN.A0 @ x + OVEN.A1 @ f(OVEN.H @ x) + OVEN.B @ u + lx @ missing
        return np.concatenate([dx, g.S0 @ w + g.S1 @ f(g.J @ w) + g.G @ y + lw @ missing])

    joint, rng = joined(OVEN, generator), np.random.default_rng(0)
    z, y = rng.normal(size=n + q), rng.normal(size=1)
    assert np.allclose(
        joint.field(0.0, z) + found.gain @ (y - joint.output(0.0, z)), printed(z[:n], z[n:], y), atol=1e-12
    )

    def field(t: float, both: Any) -> Any:
        true, other = both[: n + q], both[n + q :]
        return np.concatenate([joint.field(t, true), printed(other[:n], other[n:], joint.output(t, true))])

    times = np.arange(0.0, 12.0, 0.5)
    both = o.trajectory(field, [3.0, -2.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], times)
    errors = np.linalg.norm(both[:, : n + q] - both[:, n + q :], axis=1)
    assert all(e <= found.bound(t, errors[0]) for t, e in zip(times, errors, strict=True))
    assert errors[-1] < 1e-2 * errors[0]


def test_remark_3_2_2_without_gains_needs_a_generator_whose_motions_meet() -> None:
    none = (np.zeros((2, 1)), np.zeros((2, 1)))
    damped = o.Generator([[0.0, 1.0], [-4.0, -1.0]], L0=[1.0, 0.0])
    assert not thesis.remark_3_2_2(OVEN, damped, gains=none, decay=0.1).gain.any()
    with pytest.raises(InfeasibleError):
        thesis.remark_3_2_2(OVEN, o.Generator(TURNING, L0=[1.0, 0.0]), gains=none, decay=0.1)
