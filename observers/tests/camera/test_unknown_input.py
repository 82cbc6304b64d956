"""Designs in boxes: feasible where the zeros allow it, certificates that hold, and reasons where none is."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointpred_observers as o
from evidence.observers import printed
from evidence.observers.designs import minimum
from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred_observers.camera import camera_box, camera_system
from pointpred_observers.files import encoded
from pointpred_observers.plants.boxes import Box, at_vertices
from pointpred_observers.plants.varying import CornerSystem, ParameterVaryingSystem
from pointpred_observers.proofs.bounds import least
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.unknown_input.certificate import ROOMS, audit, inequality
from pointpred_observers.unknown_input.observer import UnknownInputObserver

CAMERA = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (-0.06, 0.06), "dw": (-0.1, 0.1)}


@pytest.fixture(scope="module")
def camera() -> UnknownInputObserver:
    return UnknownInputObserver.design(camera_system(), camera_box((-0.4, -0.05), **CAMERA), 0.01)


def parts(observer: UnknownInputObserver) -> tuple:
    """Gamma, T and K at each vertex of a design, C and P."""
    gammas, ts = observer.system.at_vertices(observer.box)
    return gammas, ts, observer.system.c, observer.certificate.P, observer.gains


def test_128_vertices_are_proved_one_by_one(camera: UnknownInputObserver) -> None:
    gammas, ts, c, p, ks = parts(camera)
    assert len(gammas) == 128
    one = camera.certificate
    force = one.gamma * np.eye(4)
    worst = -np.inf
    for g, t, k in zip(gammas, ts, ks, strict=True):
        n = g - k @ c
        whole = np.block([[n.T @ p + p @ n + 2.0 * one.decay * p, p @ t], [t.T @ p, -force]])
        worst = max(worst, float(np.linalg.eigvalsh(whole)[-1]))
    assert worst == pytest.approx(-one.margin, rel=1e-6)
    assert one.margin > 0.0
    assert one.largest_decay == pytest.approx(0.03)


def test_the_bound_holds_for_errors_that_jump_about_in_the_box(camera: UnknownInputObserver) -> None:
    """e' = N(p) e + T(p) delta with p and delta changing at random: no trajectory leaves the bound."""
    random = np.random.default_rng(5)
    lows, highs = np.array(list(camera.box.bounds.values())).T
    error, largest, h = np.array([0.3, -0.2, 0.5, 1.0]), 1e-3, 0.01
    first = float(np.linalg.norm(error))
    for k in range(1500):
        if k % 50 == 0:
            point = camera.box.named(lows + random.uniform(size=7) * (highs - lows))
            n = camera.system.gamma(point) - camera.box.mixed(camera.gains, point) @ camera.system.c
            t = camera.system.t(point)
        push = random.normal(size=4)
        error = error + h * (n @ error + t @ push * largest / np.linalg.norm(push))
        assert np.linalg.norm(error) <= camera.bound((k + 1) * h, first, delta=largest)


@pytest.mark.parametrize("eta", [-0.2, -0.05, -0.021])
def test_designs_are_feasible_exactly_when_the_zeros_allow_it(eta: float) -> None:
    box = camera_box((-0.4, eta), **CAMERA)
    most = -(eta + 0.02)
    observer = UnknownInputObserver.design(camera_system(), box, 0.9 * most)
    assert observer.certificate.largest_decay == pytest.approx(most)
    with pytest.raises(InfeasibleError, match=f"the largest feasible decay is below {most:.6g} 1/s"):
        UnknownInputObserver.design(camera_system(), box, 1.01 * most)


def test_a_camera_that_may_approach_is_refused_before_any_solver(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object, **__: object) -> None:
        raise AssertionError("a solver was called")

    monkeypatch.setattr(MatrixInequalities, "solve", never)
    box = camera_box((-0.4, 0.01), **CAMERA)
    with pytest.raises(InfeasibleError, match="no decay above 0 is feasible in this box"):
        UnknownInputObserver.design(camera_system(), box, 1e-6)


def test_the_certificate_does_not_change_with_its_scale(camera: UnknownInputObserver) -> None:
    (gammas, ts, c, p, ks), one = parts(camera), camera.certificate
    force = one.gamma * np.eye(4)
    for scale in (1e-12, 1e-3, 1e6):
        other = audit(gammas, ts, c, scale * p, ks, scale * force, one.decay, one.zeros)
        assert other.phi1 == pytest.approx(one.phi1, rel=1e-9)
        assert other.phi2 == pytest.approx(one.phi2, rel=1e-9)
        assert other.margin == pytest.approx(scale * one.margin, rel=1e-6)


def test_a_certificate_that_fails_is_an_error_never_a_gain(camera: UnknownInputObserver) -> None:
    (gammas, ts, c, p, ks), one = parts(camera), camera.certificate
    force = one.gamma * np.eye(4)
    with pytest.raises(CertificateError, match=r"\(27c\) has the eigenvalue"):
        audit(gammas, ts, c, p, ks, force, 1.1 * one.largest_decay, one.zeros)
    with pytest.raises(CertificateError, match=r"\(27c\) has the eigenvalue .* at vertex"):
        audit(gammas, ts, c, p, -ks, force, one.decay, one.zeros)
    with pytest.raises(CertificateError, match="P must be symmetric and positive definite"):
        audit(gammas, ts, c, p - 2.0 * np.eye(4), ks, force, one.decay, one.zeros)
    with pytest.raises(CertificateError, match="F must be symmetric and positive definite"):
        audit(gammas, ts, c, p, ks, -force, one.decay, one.zeros)


def test_the_printed_sign_of_27c_with_44_is_unstable(camera: UnknownInputObserver) -> None:
    """W that satisfies the print makes Gamma - K C, the observer of (44), grow."""
    gammas, ts, c, p, ks = parts(camera)
    force = camera.certificate.gamma * np.eye(4)
    for g, t, w in zip(gammas, ts, p @ ks, strict=True):
        found = printed.gain_inequality(g, t, c, p, -w, force, 2.0 * camera.decay)
        assert np.linalg.eigvalsh(found)[-1] < 0.0
        assert np.linalg.eigvals(g - np.linalg.solve(p, -w) @ c).real.max() > 1.0


def test_the_printed_p_breaks_its_own_bound() -> None:
    assert np.linalg.eigvalsh(printed.P)[0] < printed.CHI_1


STILL = camera_box((-0.4, -0.05), turn=(-0.02, 0.02), a_z=(-0.1, 0.1), w=(0.0, 0.0), dw=(0.0, 0.0))


@pytest.mark.slow
def test_closer_to_the_zeros_than_a_proof_can_be_is_undecided_not_infeasible() -> None:
    with pytest.raises(UndecidedError, match=r"the invariant zeros allow a decay of 0\.03"):
        UnknownInputObserver.design(camera_system(), STILL, 0.03 * (1.0 - 1e-10))


def test_more_outputs_than_unknown_inputs() -> None:
    """Another system: a third output repairs an unstable zero, and T moves with the schedule."""
    c = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    system = ParameterVaryingSystem(
        lambda p: np.array([[0.0, 1.0, 0.0], [0.0, 0.3, 0.0], [0.0, 1.0, p["k"]]]),
        lambda p: np.array([[1.0], [p["s"]], [0.0]]),
        c,
        rates={"s": "ds"},
    )
    box = Box({"k": (-2.0, -1.0), "s": (-0.2, 0.2), "ds": (-0.1, 0.1)})
    observer = UnknownInputObserver.design(system, box, 0.25)
    assert observer.certificate.zeros.size == 0
    assert observer.certificate.largest_decay == float("inf")
    assert not observer.reducible
    point = {"k": -1.5, "s": 0.1, "ds": 0.0}
    n = system.gamma(point) - observer.box.mixed(observer.gains, point) @ c
    values = np.linalg.eigvals(n).real
    assert values.max() < -0.25
    assert values.min() > -100.0  # no gain is larger than it must be


def test_the_rate_of_e_is_the_derivative_of_e() -> None:
    random = np.random.default_rng(2)
    parts_of_f = random.normal(size=(3, 5, 2))
    system = ParameterVaryingSystem(
        lambda p: np.zeros((5, 5)),
        lambda p: parts_of_f[0] + p["s"] * parts_of_f[1] + p["r"] * parts_of_f[2],
        random.normal(size=(3, 5)),
        rates={"s": "ds", "r": "dr"},
    )
    h, point = 1e-6, {"s": 0.3, "r": -0.2, "ds": 0.7, "dr": -0.4}
    ahead = {**point, "s": 0.3 + h * 0.7, "r": -0.2 - h * 0.4}
    behind = {**point, "s": 0.3 - h * 0.7, "r": -0.2 + h * 0.4}
    difference = (system.e(ahead) - system.e(behind)) / (2.0 * h)
    np.testing.assert_allclose(system.e_rate(point), difference, rtol=1e-6, atol=1e-7)
    np.testing.assert_allclose(system.t(point), np.eye(5) + system.e(point) @ system.c, atol=1e-12)


def test_what_cancels_off_the_diagonal_proves_nothing() -> None:
    """A pair without damping: the energy's change, 5.6e-17 in exact numbers, is 0 in floating point."""
    n = np.array([[-1e-17, 1.0], [-1.0 / 3.0, -1e-17]])
    p, c, none = np.diag([1.0, 3.0]), np.zeros((1, 2)), np.zeros((1, 1), complex)
    exact = [[Fraction(float(one)) for one in row] for row in n]
    across = exact[0][1] + 3 * exact[1][0]
    assert across**2 > 12 * exact[0][0] ** 2  # not negative definite
    with pytest.raises(CertificateError, match=r"\(27c\) has the eigenvalue 0 at vertex 0"):
        audit(n[None], np.zeros((1, 2, 2)), c, p, np.zeros((1, 2, 1)), np.eye(2), 0.5e-20, none)


def test_the_gain_that_runs_is_the_one_that_is_proved() -> None:
    """In discrete time and with a P that is nearly singular: W = P K no longer tells K."""
    axes = np.linalg.qr(np.random.default_rng(8).normal(size=(3, 3)))[0]
    p = (axes * [1.0, 1.0, 1e-10]) @ axes.T
    p = 0.5 * (p + p.T)
    k, c = axes[:, 2:], axes[:, 2:].T
    one = audit(
        0.3 * np.eye(3)[None], np.zeros((1, 3, 3)), c, p, k[None], np.eye(3), 0.05,
        np.zeros((1, 0), complex), "discrete",
    )  # fmt: skip
    assert not np.allclose(np.linalg.solve(p, p @ k), k, rtol=1e-8, atol=1e-8)
    whole = -inequality(0.3 * np.eye(3) - k @ c, np.zeros((3, 3)), p, np.eye(3), 0.05, "discrete")
    assert one.margin == pytest.approx(least(whole)[0], rel=1e-12)


@pytest.mark.parametrize("size", [1.0, 1e-12])
def test_an_entry_that_is_not_affine_does_not_hide_behind_others_or_in_small_units(size: float) -> None:
    def a(p: dict) -> np.ndarray:  # um beside m: the small entry decides whether it decays
        rows = [[0.0, 0.0, 0.0], [0.0, -1.0, 1e6], [0.0, 1e-4 * (1.0 - p["k"] ** 2), -1.0]]
        return size * np.array(rows)

    system = ParameterVaryingSystem(a, np.eye(3, 1), np.eye(1, 3))
    with pytest.raises(ParameterError, match=r"affine in each variable.* row 3, column 2"):
        UnknownInputObserver.design(system, Box({"k": (-1.0, 1.0)}), 0.5 * size)


@pytest.mark.parametrize("through", ["function", "corners"])
def test_a_ta_that_is_not_t_times_a_is_refused(through: str) -> None:
    box = Box({"k": (1.0, 3.0)})
    system = ParameterVaryingSystem(
        lambda p: np.array([[0.0, 1.0], [0.0, p["k"]]]),
        np.eye(2, 1),
        np.eye(1, 2),
        decoupled=lambda p: np.diag([0.0, -p["k"]]),
    )
    make = {
        "function": lambda: UnknownInputObserver.design(system, box, 0.5),
        "corners": lambda: CornerSystem.of(system, box),
    }
    with pytest.raises(ParameterError, match=r"TA must be T times A.* 6 in row 2, column 2") as failure:
        make[through]()
    assert failure.value.field == "TA"


def test_a_ta_whose_a_needs_more_variables_is_audited_but_not_kept(camera: UnknownInputObserver) -> None:
    assert o.audit(camera) == {"(27c)": camera.certificate.margin}
    with pytest.raises(ParameterError, match="A needs the variable 'x', the box has zero, eta"):
        encoded(camera)


@pytest.mark.parametrize("a_z", [0.1, *(pytest.param(one, marks=pytest.mark.slow) for one in (0.5, 2.0))])
@pytest.mark.parametrize("decay", [0.005, 0.025, 0.045, 0.046, 0.0475])
def test_the_least_gamma_is_the_least(decay: float, a_z: float) -> None:
    box = camera_box((-2.0, -0.07), turn=(-0.02, 0.02), a_z=(-a_z, a_z), w=(-0.06, 0.06), dw=(-0.1, 0.1))
    with mpmath.workdps(40):
        wanted = float(minimum(2.0 * decay, box.bounds))
    gamma = UnknownInputObserver.design(camera_system(), box, decay).certificate.gamma
    assert gamma / ROOMS[0].factor == pytest.approx(wanted, rel=5e-3)


number = st.floats(-100.0, 100.0)
axis = st.tuples(number, st.one_of(st.just(0.0), st.floats(0.01, 50.0)))


@given(st.lists(st.tuples(axis, st.floats(0.0, 1.0)), min_size=1, max_size=5))
def test_weights_are_a_convex_sum_that_gives_the_point(axes: list) -> None:
    box = Box({f"p{i}": (low, low + width) for i, ((low, width), _) in enumerate(axes)})
    point = {f"p{i}": low + share * width for i, ((low, width), share) in enumerate(axes)}
    weights = box.weights(point)
    assert len(weights) == len(box.vertices) == 2 ** sum(width > 0.0 for (_, width), _ in axes)
    assert weights.min() >= 0.0
    assert abs(weights.sum() - 1.0) < 1e-12
    np.testing.assert_allclose(weights @ box.vertices, list(point.values()), rtol=1e-9, atol=1e-9)


def test_a_model_reproduces_a_multilinear_matrix_anywhere_in_the_box() -> None:
    random = np.random.default_rng(3)
    parts = random.normal(size=(8, 2, 3))
    box = Box({"a": (-1.0, 2.0), "b": (0.5, 0.5), "c": (3.0, 4.0)})

    def matrix(p: dict) -> np.ndarray:
        a, b, c = p["a"], p["b"], p["c"]
        return np.tensordot([1.0, a, b, c, a * b, a * c, b * c, a * b * c], parts, 1)

    model = at_vertices(matrix, box, "A")
    for share in random.uniform(size=(20, 2)):
        point = {"a": -1.0 + 3.0 * share[0], "b": 0.5, "c": 3.0 + share[1]}
        np.testing.assert_allclose(box.mixed(model, point), matrix(point), rtol=1e-12, atol=1e-12)
