"""Propositions 3.3.1 and 3.3.2 on random systems: invariant to 1e-9, and what fails is named."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from pointpred.errors import InfeasibleError, ParameterError
from pointpred_observers import GradientRegressor, Persidskii, invariant_observer, trajectory

SEEDS = st.integers(0, 2**32 - 1)


def waves(random: np.random.Generator, *shape: int) -> tuple[Any, Any]:
    """A matrix that varies smoothly, and its derivative."""
    still, swing, rate = (
        random.standard_normal(shape),
        random.standard_normal(shape),
        random.uniform(0.5, 2.0),
    )
    return (lambda t: still + swing * np.sin(rate * t), lambda t: swing * rate * np.cos(rate * t))


def system(seed: int, *, time: str = "continuous", through: bool = False) -> tuple[Persidskii, Any, Any, int]:
    """A random plant with Pi and Upsilon that satisfy the equalities; ``through``: f also in the output."""
    random = np.random.default_rng(seed)
    n, p, k = 4, 2, 2
    pi, c0 = random.standard_normal((n - p, n)), random.standard_normal((p, n))
    c1 = np.outer([1.0, 2.0], random.standard_normal(k)) if through else np.zeros((p, k))
    upsilon = (
        np.outer(random.standard_normal(n - p), [2.0, -1.0])
        if through
        else random.standard_normal((n - p, p))
    )
    h = random.standard_normal((k, n - p)) @ (pi + upsilon @ c0)
    a0 = (
        random.standard_normal((n, n)) - 2.0 * np.eye(n)
        if time == "continuous"
        else 0.3 * random.standard_normal((n, n))
    )
    a1, b, q = (random.standard_normal((n, columns)) for columns in (k, 1, 1))
    plant = Persidskii(a0, a1, h, ["sin", "tanh"], b, q, c0, c1, time=time)
    return plant, pi, upsilon, n - p


def joint(plant: Persidskii, observer: Any, t: float, both: np.ndarray) -> np.ndarray:
    """Plant and observer as one system, driven by the same known inputs."""
    x, w = both[: plant.n], both[plant.n :]
    u, rho = np.array([np.cos(t)]), np.array([np.sin(2.0 * t)])
    y = plant.output(t, x)
    return np.concatenate([plant.field(t, x, u, rho), observer.field(t, w, y, np.concatenate([u, rho]))])


@settings(max_examples=20)
@given(seed=SEEDS, through=st.booleans())
@example(seed=184538, through=False)  # its error grows by exp(31 t)
@example(seed=1383541262, through=False)  # and falls by exp(-407 t)
def test_the_observer_stays_on_the_invariant_solution(seed: int, through: bool) -> None:
    plant, pi, upsilon, _ = system(seed, through=through)
    observer = invariant_observer(plant, pi, upsilon, tolerance=1e-7)
    x = np.random.default_rng(seed).standard_normal(plant.n)
    start = np.concatenate([x, pi @ x + upsilon @ plant.output(0.0, x)])
    g = observer.at(0.0)
    # The error's growth a second at most: for longer than ten times its inverse rounding would grow with it.
    growth = np.linalg.eigvalsh(0.5 * (g.S0 + g.S0.T)).max()
    growth += np.linalg.norm(g.S1, 2) * np.linalg.norm(g.J, 2)
    times = np.array([0.0, 0.3, 0.8]) * min(1.0, 10.0 / max(growth, 1.0))
    step_s = min(0.01, 1.0 / np.linalg.norm(g.S0, 2))  # a longer one diverges where the observer is stiff
    states = trajectory(lambda t, s: joint(plant, observer, t, s), start, times, step_s=step_s)
    for t, state in zip(times, states, strict=True):
        wanted = pi @ state[:4] + upsilon @ plant.output(t, state[:4])
        size = max(1.0, np.abs(state).max(), np.abs(observer.at(0.0).S0).max())
        assert np.abs(state[4:] - wanted).max() < 1e-9 * size
    if not through:
        end = times[-1]
        assert observer.estimate(end, states[-1][4:], plant.output(end, states[-1][:4])) == pytest.approx(
            states[-1][:4], rel=1e-6, abs=1e-6
        )


@settings(max_examples=6)
@given(seed=SEEDS)
def test_matrices_that_vary_with_time_keep_it_invariant(seed: int) -> None:
    random = np.random.default_rng(seed)
    a0, _ = waves(random, 3, 3)
    c0, c0_rate = waves(random, 1, 3)
    pi, pi_rate = waves(random, 3, 3)
    upsilon, upsilon_rate = waves(random, 3, 1)
    b, _ = waves(random, 3, 1)
    inner = random.standard_normal((1, 3))

    def z(t: float) -> Any:
        return pi(t) + upsilon(t) @ c0(t)

    moments = np.linspace(0.0, 0.5, 200)
    assume(min(abs(np.linalg.det(z(t))) for t in moments) > 0.2)
    plant = Persidskii(
        a0, waves(random, 3, 1)[0], lambda t: inner @ z(t), "sin", B=waves(random, 3, 1)[0], C0=c0
    )
    rates = {"Pi": pi_rate, "Upsilon": upsilon_rate, "C0": c0_rate}
    observer = invariant_observer(plant, pi, upsilon, B=b, rates=rates, tolerance=1e-8)

    def slope(t: float, both: np.ndarray) -> np.ndarray:
        u = np.array([np.cos(t)])
        inputs = observer.field(t, both[3:], plant.output(t, both[:3]), u)
        return np.concatenate([plant.field(t, both[:3], u), inputs])

    x = random.standard_normal(3)
    states = trajectory(slope, np.concatenate([x, z(0.0) @ x]), [0.0, 0.25, 0.5], tolerance=1e-11)
    for t, state in zip([0.0, 0.25, 0.5], states, strict=True):
        growth = max(1.0, float(np.abs(states).max()), float(np.exp(np.abs(observer.at(t).S0).max() * 0.5)))
        assert np.abs(state[3:] - z(t) @ state[:3]).max() < 1e-9 * growth
    with pytest.raises(
        ParameterError, match="C0, Pi, Upsilon vary in continuous time: give their derivatives"
    ):
        invariant_observer(plant, pi, upsilon, B=b)


@settings(max_examples=20)
@given(seed=SEEDS, varying=st.booleans())
def test_discrete_observers_stay_on_it_too(seed: int, varying: bool) -> None:
    plant, pi, upsilon, _ = system(seed, time="discrete", through=True)
    swing = np.random.default_rng(seed).standard_normal(np.shape(pi))
    given_pi: Any = pi
    if varying:
        shape = np.linalg.lstsq((pi + upsilon @ plant.C0).T, plant.H.T, rcond=None)[0].T

        def given_pi(k: float) -> Any:
            return pi + 0.3 * np.sin(k) * swing

        plant = _tied(plant, given_pi, upsilon, shape)
    observer = invariant_observer(plant, given_pi, upsilon, tolerance=1e-6)
    x = np.random.default_rng(seed).standard_normal(4)
    at = given_pi if callable(given_pi) else lambda k: pi

    def on(k: int, x: np.ndarray) -> np.ndarray:
        return at(k) @ x + upsilon @ plant.output(k, x)

    # Step by step: beside a solution that is not stable rounding grows by (S0 + S1 J)^5.
    w = on(0, x)
    for k in range(5):
        state = joint(plant, observer, k, np.concatenate([x, w]))
        x, w = state[:4], on(k + 1, state[:4])
        assert np.abs(state[4:] - w).max() < 1e-9 * max(1.0, np.abs(state).max())


def _tied(plant: Persidskii, pi: Any, upsilon: np.ndarray, shape: np.ndarray) -> Persidskii:
    """The plant with H = J Z at every index."""
    matrices = plant.matrices(0.0)
    c0 = matrices["C0"]
    return Persidskii(
        f=plant.f, time="discrete", **{**matrices, "H": lambda k: shape @ (pi(k) + upsilon @ c0)}
    )


@settings(max_examples=20)
@given(seed=SEEDS)
def test_with_the_output_inside_f_no_equality_ties_upsilon(seed: int) -> None:
    plant, pi, _, q = system(seed)
    random = np.random.default_rng(seed + 1)
    other = random.standard_normal((q, 2))
    with pytest.raises(InfeasibleError, match=r"J \(Pi \+ Upsilon C0\) - H = 0 cannot hold"):
        invariant_observer(plant, pi, other)
    observer = invariant_observer(plant, pi, other, injection=True, tolerance=1e-7)
    x, u = random.standard_normal(4), random.standard_normal(2)
    z = pi + other @ plant.C0
    moved = observer.field(0.0, z @ x, plant.output(0.0, x), u)
    wanted = z @ plant.field(0.0, x, u[:1], u[1:])
    assert moved == pytest.approx(
        wanted, abs=1e-9 * max(1.0, float(np.abs(observer.at(0.0).S0).max()) * 10.0)
    )


def test_constants_make_the_gradient_estimator() -> None:
    """Section 3.3.4: Pi = I, Upsilon = 0 and B = G D' give S0 = -B D, (3.45)."""
    gain = np.diag([2.0, 0.5])

    def d(t: float) -> np.ndarray:
        return np.array([[1.0, np.sin(t)]])

    plant = Persidskii(np.zeros((2, 2)), None, None, "sin", C0=d)
    observer = invariant_observer(plant, np.eye(2), B=lambda t: gain @ d(t).T)
    s0 = observer.at(0.7).S0
    assert s0 == pytest.approx(-gain @ d(0.7).T @ d(0.7))
    x, times = np.array([3.0, 5.0]), np.linspace(0.0, 1.0, 101)
    states = trajectory(lambda t, w: observer.field(t, w, plant.output(t, x)), [0.0, 0.0], times, step_s=0.01)
    stage = GradientRegressor(2, gain=gain)
    for t in times:
        found = stage.update(d(t), d(t) @ x, t)
    assert found == pytest.approx(states[-1], abs=1e-4)


REFUSED: list[tuple[dict[str, Any], type, str]] = [
    ({"B": [[1.0]]}, InfeasibleError, r"S0 Z \+ B C0 - Z A0 - Z' = 0 cannot hold: its residual is"),
    ({"rates": {"A0": lambda t: t}}, ParameterError, r"rates may name Pi, Upsilon and C0, received \['A0'\]"),
]


@pytest.mark.parametrize(("given", "kind", "message"), REFUSED)
def test_what_cannot_be_is_named(given: dict[str, Any], kind: type, message: str) -> None:
    plant = Persidskii([[0.0, 1.0], [-1.0, -1.0]], None, None, "sin", C0=[1.0, 0.0])
    with pytest.raises(kind, match=message):
        invariant_observer(plant, **{"Pi": [[0.0, 1.0]], "Upsilon": [[-1.0]], **given})


def test_a_state_is_recovered_beside_a_gain_in_which_the_rest_of_the_row_is_rounding() -> None:
    cart = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", None, None, [1.0, 0.0])
    observer = invariant_observer(cart, [[0.0, 1.0]], [[-1e12]])
    onto, straight = observer.recovery(0.0)
    assert onto == pytest.approx(np.array([[0.0], [1.0]]), abs=1e-9)
    assert straight == pytest.approx(np.array([[1.0], [1e12]]), rel=1e-9)
