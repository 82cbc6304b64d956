"""Proposition 3.2.1 and Corollary 3.2.1 on random systems, and what is said where no Pi exists."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers import Generator, Persidskii, steady_state_map, trajectory
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.thesis import certify_tracking, closed_loop, residuals


def matched(
    seed: int, *, feedback: bool = False, time: str = "continuous"
) -> tuple[Persidskii, Generator, Any]:
    """A random plant and generator made so that a known Pi satisfies every equality."""
    rng = np.random.default_rng(seed)
    n, q = int(rng.integers(2, 5)), int(rng.integers(1, 3))
    k, m, p, z = 2, 2, 1, 1
    scale = 0.3 if time == "discrete" else 1.0
    pi = rng.normal(size=(n, q))
    a0 = scale * (rng.normal(size=(n, n)) - (0.0 if time == "discrete" else 3.0) * np.eye(n))
    half = rng.normal(size=(q, q))
    s0 = half - half.T if time == "continuous" else np.linalg.qr(half)[0]
    g = 0.3 * rng.normal(size=(q, p)) if feedback else np.zeros((q, p))
    c0, c1 = rng.normal(size=(p, n)), rng.normal(size=(p, k)) if feedback else np.zeros((p, k))
    l0, l1 = rng.normal(size=(m, q)), rng.normal(size=(m, k))
    s1, e, b = scale * rng.normal(size=(q, k)), rng.normal(size=(q, z)), rng.normal(size=(n, m))
    # A0 and A1 are corrected so that the equalities hold: (A0 + X) Pi = ..., X of least norm.
    left = np.linalg.pinv(pi)
    a0 = a0 + (pi @ s0 + pi @ g @ c0 @ pi - b @ l0 - a0 @ pi) @ left
    a1 = pi @ (s1 + g @ c1) - b @ l1
    h = 0.5 * rng.normal(size=(k, n))
    plant = Persidskii(a0, a1, h, ["sin", "tanh"], b, pi @ e, c0, c1, time=time)
    return plant, Generator(s0, s1, None, g, l0, l1, e), pi


def largest(found: dict[str, Any]) -> float:
    return max(float(np.abs(one).max()) for one in found.values())


@given(st.integers(0, 2**31), st.booleans(), st.sampled_from(["continuous", "discrete"]))
@settings(max_examples=30)
def test_the_map_satisfies_every_equality(seed: int, feedback: bool, time: str) -> None:
    plant, generator, pi = matched(seed, feedback=feedback, time=time)
    assert largest(residuals(plant, generator, pi)) < 1e-10
    found = steady_state_map(plant, generator)
    assert largest(residuals(plant, generator, found.Pi)) < 1e-7
    assert np.allclose(found.J, plant.H @ found.Pi)
    assert max(found.residuals.values()) == largest(residuals(plant, generator, found.Pi))
    every = [found.Pi, *found.others]
    assert found.nullity > 0 or min(np.abs(one - pi).max() for one in every) < 1e-5
    for direction in found.basis:
        step = 1e-4 * direction if feedback else direction
        assert largest(residuals(plant, generator, found.Pi + step)) < 1e-6


@given(st.integers(0, 2**31), st.booleans())
@example(283, False)  # one of its eigenvalues is 1238 a second
@settings(max_examples=8)
def test_the_hyperplane_is_invariant_along_trajectories(seed: int, feedback: bool) -> None:
    plant, generator, _ = matched(seed, feedback=feedback)
    found = steady_state_map(plant, generator)
    q = generator.q
    joined = Generator(
        **{**{n: getattr(generator, n) for n in ("S0", "S1", "G", "L0", "L1", "E")}, "J": found.J}
    )

    def field(t: float, both: Any) -> Any:
        return closed_loop(plant, joined, t, both, rho=[np.sin(3.0 * t)])

    w0 = 0.5 * np.random.default_rng(seed).normal(size=q)
    start = np.concatenate([found.Pi @ w0, w0])
    quick = min(1.0, 20.0 / np.linalg.norm(plant.A0, 2))  # a quicker plant has a shorter time
    times = quick * np.array([0.0, 0.3, 0.7])
    both = trajectory(field, start, times)
    size = max(1.0, float(np.abs(both).max()))
    # What leaves the hyperplane is rounding, and the residual of Pi, enlarged by an unstable plant.
    room = 1e-9 * size * max(1.0, max(found.residuals.values()) * 1e10)
    assert np.abs(both[:, :-q] - both[:, -q:] @ found.Pi.T).max() < room


def test_the_hyperplane_is_invariant_in_discrete_time() -> None:
    plant, generator, pi = matched(11, time="discrete")
    found = steady_state_map(plant, generator)
    j = found.J
    w, x = np.ones(generator.q), pi @ np.ones(generator.q)
    x = found.Pi @ w
    for k in range(30):
        u = generator.L0 @ w + generator.L1 @ plant.f(j @ w)
        rho = [np.cos(k)]
        w_next = generator.S0 @ w + generator.S1 @ plant.f(j @ w) + generator.E @ rho
        x, w = plant.field(k, x, u=u, rho=rho), w_next
        assert np.abs(x - found.Pi @ w).max() < 1e-9


def test_a_riccati_equation_has_several_solutions_and_all_are_told() -> None:
    plant = Persidskii([[0.0]], None, None, "sin", B=[1.0], C0=[1.0])
    found = steady_state_map(plant, Generator([[0.0]], G=[1.0], L0=[1.0]))  # Pi^2 = 1
    assert found.Pi.item() == pytest.approx(1.0)  # A0 - Pi G C0 = -1: the plant follows this one
    assert [one.item() for one in found.others] == pytest.approx([-1.0])
    with pytest.raises(UndecidedError, match=r"Riccati equation .* keeps a residual of 1"):
        steady_state_map(plant, Generator([[0.0]], G=[1.0], L0=[-1.0]))  # Pi^2 = -1


def test_a_map_that_is_not_unique_has_a_basis() -> None:
    plant = Persidskii([[0.0, 0.0], [0.0, -1.0]], None, None, "sin", B=[0.0, 1.0])
    found = steady_state_map(plant, Generator([[0.0]], L0=[3.0]))
    assert found.nullity == 1
    assert np.abs(found.basis[0]).round(9).tolist() == [[1.0], [0.0]]
    assert found.Pi.round(9).tolist() == [[0.0], [3.0]]


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"L0": [[2.0]], "S0": [[-1.0]]}, r"S0 \+ B L0 = 0 cannot hold: the least residual is 2"),
        ({"L1": [[3.0]]}, r"A1 \+ B L1 - Pi \(S1 \+ G C1\) = 0 cannot hold beside A0 .* residual is 3"),
        ({"E": [[5.0]]}, r"Q - Pi E = 0 cannot hold beside"),
        ({"J": [[5.0]]}, r"H Pi - J = 0 cannot hold beside"),
    ],
)  # fmt: skip
def test_an_equality_that_cannot_hold_is_named_with_its_residual(change: dict[str, Any], name: str) -> None:
    plant = Persidskii([[-1.0]], [[0.0]], [[1.0]], "sin", B=[1.0], Q=[1.0])
    sound = {"S0": [[0.0]], "S1": [[0.0]], "L0": [[1.0]], "L1": [[0.0]], "E": [[1.0]]}
    assert steady_state_map(plant, Generator(**sound)).Pi.round(9).tolist() == [[1.0]]
    with pytest.raises(InfeasibleError, match=name):
        steady_state_map(plant, Generator(**{**sound, **change}))


def test_varying_matrices_need_a_constant_map_at_each_time() -> None:
    def a0(t: float) -> Any:
        return [[-2.0 - np.sin(t), 1.0 + np.sin(t)], [0.0, -1.0]]

    plant = Persidskii(a0, None, None, "sin", B=[1.0, 1.0])
    generator = Generator([[0.0]], L0=[1.0])
    times = np.linspace(0.0, 6.0, 7)
    found = steady_state_map(plant, generator, times=times)
    assert found.Pi.round(9).tolist() == [[1.0], [1.0]]
    other = Persidskii(lambda t: [[-1.0 - t, 0.0], [0.0, -1.0]], None, None, "sin", B=[1.0, 1.0])
    with pytest.raises(InfeasibleError, match="cannot hold"):
        steady_state_map(other, generator, times=times)
    with pytest.raises(ParameterError, match=r"\(A0\) varies: give the times at which it is to hold"):
        steady_state_map(other, generator)
    assert steady_state_map(other, generator, times=[0.0]).Pi.round(9).tolist() == [[1.0], [1.0]]


def test_a_plant_keeps_what_it_was_given() -> None:
    a0 = -np.eye(2)
    plant = Persidskii(a0, None, None, "sin")
    a0[0, 0] = 7.0
    assert plant.A0[0, 0] == plant.at(0.0).A0[0, 0] == -1.0


def test_a_varying_plant_is_its_matrices_at_each_time() -> None:
    plant = Persidskii(
        lambda t: [[-1.0 - t]], [1.0], [1.0], "sin", lambda t: [[2.0 * t]], [3.0], lambda t: [[t]], [[1.0]]
    )
    assert plant.varying == ("A0", "B", "C0")
    expected = -3.0 * 0.5 + np.sin(0.5) + 4.0 * 0.7 + 3.0 * 0.2 + 0.1
    assert plant.field(2.0, [0.5], u=0.7, rho=0.2, d=0.1).item() == pytest.approx(expected)
    assert plant.output(2.0, [0.5], v=0.1).item() == pytest.approx(1.0 + np.sin(0.5) + 0.1)
    held = plant.at(2.0)
    assert not held.varying
    assert held.field(9.0, [0.5], u=0.7, rho=0.2, d=0.1).item() == pytest.approx(expected)
    with pytest.raises(ParameterError, match=r"A0 has shape \(1, 2\), needs \(1, 1\)"):
        Persidskii(lambda t: [[1.0]] if t == 0.0 else [[1.0, 2.0]], None, None, "sin").field(1.0, [1.0])


@pytest.mark.parametrize("scale", [1e-12, 1.0, 1e12])
def test_what_cannot_hold_cannot_hold_in_every_unit(scale: float) -> None:
    """Time in other units multiplies A0, B and S0: Pi stays, and so does what contradicts it."""
    plant = Persidskii([[-scale]], None, None, "sin", B=[scale])
    assert steady_state_map(plant, Generator([[0.0]], L0=[2.0])).Pi == pytest.approx(2.0)
    with pytest.raises(InfeasibleError, match=r"B L0 = 0 cannot hold: the least residual is "):
        steady_state_map(plant, Generator([[-scale]], L0=[2.0]))


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
def test_a_wrong_map_is_refused_however_large_an_entry_is_elsewhere(unit: float) -> None:
    """Inputs in units of 1e-9 make B large; the map 5 in place of 1 is wrong in all of them."""
    plant = Persidskii([[-1.0]], None, None, "sin", B=[unit], C0=[1.0])
    generator = Generator([[0.0]], L0=[1.0 / unit])
    with pytest.raises(
        InfeasibleError, match=r"Assumption 3\.2\.1: A0 Pi .* residual is 4, 0\.7 of its terms"
    ):
        DrivenObserver.design(plant, generator=generator, Pi=[[5.0]], decay=0.0)
    design = DrivenObserver.design(plant, generator=generator, Pi=[[1.0]], decay=0.0)
    assert min(design.margins.values()) > 0.0


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_one_row_of_a_map_does_not_hide_another(unit: float) -> None:
    """The second state, in other units, does not follow the map; the first row's terms are larger."""
    plant = Persidskii(np.diag([-1.0, -2.0]), None, None, "sin", B=[1.0, 2.0 * unit], C0=[[1.0, 0.0]])
    generator = Generator([[0.0]], L0=[1.0])
    right = np.array([[1.0], [unit]])
    assert steady_state_map(plant, generator).Pi == pytest.approx(right)
    with pytest.raises(InfeasibleError, match=r"0\.0005 of its terms"):
        DrivenObserver.design(plant, generator=generator, Pi=right * [[1.0], [1.001]], decay=0.0)


def test_tracking_refuses_a_map_in_small_units() -> None:
    """A0 = -1e7 belongs to the other state: it does not excuse the map of the first."""
    plant = Persidskii(np.diag([-1.0, -1e7]), None, None, "sin", np.array([[1e-7], [1e7]]), None, np.eye(2))
    regulator = Generator([[-1.0]], None, None, [[0.0, 0.0]], [1.0])
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.1: A0 Pi"):
        certify_tracking(plant, regulator, [[3e-3], [1.0]])


def test_rounding_in_a_map_of_the_caller_is_no_failure() -> None:
    """1e-17 stands where 0 is meant, in a row and in a matrix of its own."""
    plant = Persidskii(
        [[0.0, 1.0], [-2.0, -3.0]], [0.0, -2.0], [1.0, 0.0], "sin", [0.0, 1.0], None, [1.0, 0.0]
    )
    generator = Generator([[0.0, 1.0], [-2.0, -3.0]], [1e-17, -2.0], None, None, np.array([[1e-17, 0.0]]))
    design = DrivenObserver.design(plant, generator=generator, Pi=np.eye(2) + 1e-17, decay=0.0)
    assert min(design.margins.values()) > 0.0


@pytest.mark.parametrize("unit", [1e-3, 1.0, 1e11])
def test_one_column_of_a_map_does_not_hide_another(unit: float) -> None:
    """The first state follows the second signal wrongly, whose unit may be that of the second state."""
    plant = Persidskii(np.diag([-1.0, -1.0]), None, None, "sin", np.eye(2), None, np.eye(2))
    right = np.array([[1e4, 4e-4 * unit], [0.0, 8e-4 * unit]])
    generator = Generator(np.zeros((2, 2)), L0=right)
    assert min(DrivenObserver.design(plant, generator=generator, Pi=right, decay=0.0).margins.values()) > 0.0
    with pytest.raises(InfeasibleError, match=r"Assumption 3\.2\.1: A0 Pi .* 0\.3 of its terms"):
        DrivenObserver.design(plant, generator=generator, Pi=right * [[1.0, 2.0], [1.0, 1.0]], decay=0.0)
