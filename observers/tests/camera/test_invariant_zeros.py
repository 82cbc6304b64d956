"""Invariant zeros against Rosenbrock's pencil, and the part of the camera that no image reaches."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eig

from pointpred.errors import ParameterError
from pointpred_observers.camera import model
from pointpred_observers.camera.model import camera_system
from pointpred_observers.plants.varying import decoupling, fixed_modes, invariant_zeros, unobservable


def rosenbrock(a: np.ndarray, f: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Finite generalised eigenvalues of [[A, F], [C, 0]] - s [[I, 0], [0, 0]]; outputs as many as inputs."""
    n, m = f.shape
    left = np.block([[a, f], [c, np.zeros((m, m))]])
    right = np.zeros((n + m, n + m))
    right[:n, :n] = np.eye(n)
    above, below = eig(left, right, homogeneous_eigvals=True, right=False)
    finite = np.abs(below) > 1e-8 * np.abs(above)
    return np.sort_complex(above[finite] / below[finite])


@pytest.mark.parametrize("seed", range(8))
def test_zeros_are_those_of_the_pencil(seed: int) -> None:
    random = np.random.default_rng(seed)
    n, m = 5, 2
    a, f, c = random.normal(size=(n, n)), random.normal(size=(n, m)), random.normal(size=(m, n))
    found = invariant_zeros(a, f, c)
    assert len(found) == n - m
    np.testing.assert_allclose(np.poly(found), np.poly(rosenbrock(a, f, c)), rtol=1e-7, atol=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_the_camera_has_the_zeros_a_and_eta(seed: int) -> None:
    values = np.random.default_rng(seed).uniform(-1.0, 1.0, 6)
    point = dict(zip(("x", "y", "w_x", "w_y", "eta", "a_z"), map(float, values), strict=True))
    a, f = model.dynamics(point), model.unknown_input(point)
    expected = sorted([point["y"] * point["w_x"] - point["x"] * point["w_y"] + point["eta"], point["eta"]])
    np.testing.assert_allclose(np.sort(invariant_zeros(a, f, model.C).real), expected, atol=1e-12)
    np.testing.assert_allclose(rosenbrock(a, f, model.C).real, expected, atol=1e-9)


def test_the_unobservable_part_of_the_camera_is_chi_and_eta() -> None:
    system = camera_system()
    point = {"x": 0.1, "y": -0.2, "w_x": 0.05, "w_y": 0.03, "eta": -0.3, "a_z": 0.2}
    basis = unobservable(system.t(point) @ system.a(point), model.C)
    np.testing.assert_allclose(basis @ basis.T, np.diag([0.0, 0.0, 1.0, 1.0]), atol=1e-12)


def test_no_gain_moves_a_zero() -> None:
    system = camera_system()
    point = {"x": 0.1, "y": -0.2, "w_x": 0.05, "w_y": 0.03, "eta": -0.3, "a_z": 0.2}
    a = system.t(point) @ system.a(point)
    zeros = invariant_zeros(system.a(point), system.f(point), model.C)
    for seed in range(5):
        gain = np.random.default_rng(seed).normal(size=(4, 2))
        values = np.linalg.eigvals(a - gain @ model.C)
        assert all(np.abs(values - zero).min() < 1e-9 for zero in zeros)


def test_with_more_outputs_than_inputs_a_zero_can_vanish() -> None:
    a = np.array([[0.0, 1.0, 0.0], [0.0, 0.3, 0.0], [0.0, 1.0, -2.0]])
    f = np.array([[1.0], [0.0], [0.0]])
    assert invariant_zeros(a, f, np.eye(1, 3)).real.tolist() == [0.3, -2.0]
    assert invariant_zeros(a, f, np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])).size == 0


@pytest.mark.parametrize("of_a", [1e-10, 1e-8, 1.0, 1e6, 1e8])
@pytest.mark.parametrize("of_c", [1e-10, 1e-8, 1.0, 1e6, 1e8])
def test_zeros_keep_their_number_in_every_unit(of_a: float, of_c: float) -> None:
    """Time in other units multiplies A, and its zeros with it; outputs in other units change none."""
    a = np.array([[0.0, 1.0, 0.0], [0.0, 0.3, 0.0], [0.0, 1.0, -2.0]])
    f = np.array([[1.0], [0.0], [0.0]])
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turned, pushed = of_a * turn @ a @ turn.T, turn @ f
    found = invariant_zeros(turned, pushed, of_c * np.eye(1, 3) @ turn.T)
    assert (found / of_a).tolist() == pytest.approx([0.3, -2.0], rel=1e-7)
    both = of_c * np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]) @ turn.T
    assert invariant_zeros(turned, pushed, both).size == 0


def test_a_fast_mode_that_shows_hides_no_slow_one() -> None:
    """Seen through the coupling 1, beside a mode of 1e6 1/s."""
    s = 1e6
    gamma, c = np.array([[0.0, 1.0, 1.0], [0.0, -s, 0.0], [0.0, 0.0, -1.0]]), np.eye(1, 3)
    assert unobservable(gamma, c).shape == (3, 0)
    gamma[0, 2] = 0.0
    assert fixed_modes(gamma, c).real.tolist() == [-1.0]


def test_ranks_are_named() -> None:
    with pytest.raises(ParameterError, match=r"rank\(C F\) = 1 < rank\(F\) = 2"):
        decoupling(np.eye(3, 2), np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
    with pytest.raises(ParameterError, match="full column rank 2, its rank is 1"):
        decoupling(np.ones((3, 2)), np.eye(2, 3))


@pytest.mark.parametrize("scale", [1e-12, 1.0, 1e12])
def test_an_input_that_rounding_alone_lets_through_is_not_seen(scale: float) -> None:
    """0.3 - (0.1 + 0.2) is not 0; an output of 1e-6 of the states' is one all the same."""
    f = scale * np.array([[1.0], [1.0], [1.0]])
    with pytest.raises(ParameterError, match=r"rank\(C F\) = 0 < rank\(F\) = 1"):
        decoupling(f, np.array([[0.3, -0.2, -0.1]]))
    small = decoupling(f, np.array([[0.3, -0.2, -0.1 + 1e-6]]))
    np.testing.assert_allclose(small @ f / scale, 0.0, atol=1e-9)
