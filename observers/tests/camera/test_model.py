"""The camera's model against the chain rule and against sympy; the printed equations against both."""

from __future__ import annotations

import numpy as np
import pytest

from evidence.observers import printed
from pointpred_observers.camera import SCENARIOS, model
from pointpred_observers.camera.scenario import Trajectory, trajectory


@pytest.fixture(scope="module", params=["paper", "approaching"])
def truth(request: pytest.FixtureRequest) -> Trajectory:
    return trajectory(SCENARIOS[request.param], np.arange(331) / 33.0)


def test_printed_equations_have_large_residuals(truth: Trajectory) -> None:
    expected = printed.derivatives(truth)
    eta_error = np.abs(printed.eta_rate_12(truth) - expected[:, 3]).max()
    chi_error = np.abs(printed.chi_rate_14(truth) - expected[:, 2]).max()
    assert eta_error > 0.05 * np.abs(expected[:, 3]).max()
    assert chi_error > np.abs(expected[:, 2]).max()


def test_system_15_reproduces_the_derivatives(truth: Trajectory) -> None:
    expected = printed.derivatives(truth)
    for k in range(0, len(truth.t), 10):
        x, y = truth.image[k]
        point = {"x": x, "y": y, "w_x": truth.w[k, 0], "w_y": truth.w[k, 1]}
        point |= {"eta": truth.eta[k], "a_z": truth.a[k, 2]}
        state = np.array([x, y, truth.chi[k], truth.eta[k]])
        b = np.concatenate([model.interaction(x, y) @ truth.w[k], np.zeros(2)])
        d = truth.chi[k] * truth.v[k, :2]
        rate = model.dynamics(point) @ state + b + model.unknown_input(point) @ d
        assert np.abs(rate - expected[k]).max() < 1e-14


def test_sympy_finds_the_corrected_signs_and_no_others() -> None:
    sympy = pytest.importorskip("sympy")
    names = "X Y Z vx vy vz wx wy wz ax ay az"
    x3, y3, z3, vx, vy, vz, wx, wy, wz, ax, ay, az = sympy.symbols(names)
    p, v = sympy.Matrix([x3, y3, z3]), sympy.Matrix([vx, vy, vz])
    w, a = sympy.Matrix([wx, wy, wz]), sympy.Matrix([ax, ay, az])
    p_rate, v_rate = -v - w.cross(p), a - w.cross(v)
    chi, eta = 1 / z3, vz / z3
    variables, rates = [*p, *v], [*p_rate, *v_rate]

    def along(expression: object) -> object:
        return sum(sympy.diff(expression, s) * r for s, r in zip(variables, rates, strict=True))

    x, y = x3 / z3, y3 / z3
    corrected = az * chi + wy * vx * chi - wx * vy * chi + eta**2 + y * wx * eta - x * wy * eta
    as_printed = az * chi - wy * vx * chi + wx * vy * chi + eta**2 - y * wx * eta + x * wy * eta
    assert sympy.simplify(along(eta) - corrected) == 0
    assert sympy.simplify(along(eta) - as_printed) != 0
    assert sympy.simplify(along(chi) - chi * (eta + y * wx - x * wy)) == 0
    assert sympy.simplify(along(chi) + chi * (eta + y * wx - x * wy)) != 0


def test_the_printed_t_lets_the_unknown_input_through() -> None:
    point = {"w_x": 0.05, "w_y": -0.06}
    system = model.camera_system()
    assert np.array_equal(system.t(point) @ system.f(point), np.zeros((4, 2)))
    assert np.array_equal(system.t(point)[3], [-0.06, -0.05, 0.0, 1.0])
    _, t = printed.decoupling_matrices(0.05, -0.06)
    assert np.array_equal((t @ system.f(point))[3], [2 * -0.06, -2 * 0.05])


def test_t_a_needs_seven_variables_only() -> None:
    random = np.random.default_rng(1)
    system = model.camera_system()
    for x, y, w_x, w_y, eta, a_z in random.uniform(-1.0, 1.0, (20, 6)):
        point = {"x": x, "y": y, "w_x": w_x, "w_y": w_y, "eta": eta, "a_z": a_z}
        point["zero"] = y * w_x - x * w_y + eta
        assert np.abs(system.t(point) @ system.a(point) - system.ta(point)).max() < 1e-15
