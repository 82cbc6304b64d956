"""Theorem 4.4.1: the certificate, its corrected bound, and the observer on irregular samples."""

from __future__ import annotations

import copy
import pickle
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import eigh, expm

from pointpred.errors import (
    CertificateError,
    EventError,
    EventOrderError,
    InfeasibleError,
    ParameterError,
)
from pointpred.observers import interlaced_law
from pointpred.observers.interlaced_certificate import (
    InterlacedCertificate,
    certificate,
    certify,
    inequalities,
)
from pointpred.observers.interlaced_form import interlaced
from pointpred.observers.interlaced_observer import InterlacedObserver, output_matrix
from pointpred.observers.triangular import SymbolicGenerator, SymbolicSteadyState, SymbolicSystem

sp = pytest.importorskip("sympy")
pytest.importorskip("cvxpy")
W1, W2, U = sp.symbols("w1 w2 u")
X = X1, X2, X3, X4 = sp.symbols("x1:5")
A = np.array([[0.0, 1.0], [-1.0, 0.0]])
C = np.array([[1.0, 0.0]])
EIGHT = (-X1 + X2**2 * X3, -X2 + X3, -(X3**3) + X4, -X4 + (1 + X3**2) * U)


def eight(outputs: tuple[Any, ...] = (X3,)) -> SymbolicSteadyState:
    system = SymbolicSystem(X, EIGHT, U, outputs=outputs)
    return interlaced(system, SymbolicGenerator((W1, W2), (W2, -W1)), 2, W1, degree=3)


@pytest.fixture(scope="module")
def observer() -> InterlacedObserver:
    return InterlacedObserver.design(eight(), rate=0.25, gap_s=0.5)


def irregular(count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.001, 0.3, count))
    return t, np.cos(t) + random.normal(0.0, 0.1, count)


def test_the_margins_are_those_of_the_matrices_returned() -> None:
    found = certify(A, C, rate=0.4)
    corner = found.P @ A - found.U @ C
    block = np.block([[corner + corner.T + found.Q, -found.U], [-found.U.T, -found.Gamma]])
    assert np.linalg.eigvalsh(block).max() < 0.0
    assert min(np.linalg.eigvalsh(m).min() for m in (found.P, found.Q, found.Gamma)) > 0.0
    assert min(found.margins.values()) > 0.0
    assert pytest.approx(found.U, abs=1e-12) == found.P @ found.L
    assert found.rate >= 0.4
    assert np.linalg.eigvals(A - found.L @ C).real.max() <= -0.4


@cache
def certified() -> InterlacedCertificate:
    return certify(A, C, rate=0.25, gain=[[0.6245], [0.125]])


@given(st.integers(0, 10**6))
@settings(max_examples=15)
def test_the_corrected_bound_holds_on_random_trajectories(seed: int) -> None:
    random = np.random.default_rng(seed)
    gain = np.array([[0.6245], [0.125]])
    found = certified()
    start, h = random.normal(size=2), 0.05
    noise = random.uniform(-1.0, 1.0, 400) * random.uniform(0.0, 2.0)
    e, size = start.copy(), float(np.linalg.norm(start))
    big = np.zeros((3, 3))
    big[:2, :2], big[:2, 2:] = A - gain @ C, -gain
    turn = expm(big * h)
    for i, v in enumerate(noise):
        e = turn[:2, :2] @ e + turn[:2, 2] * v
        assert np.linalg.norm(e) <= found.bound((i + 1) * h, size, float(np.abs(noise).max())) + 1e-12


def test_the_printed_bound_is_exceeded_and_the_corrected_one_holds() -> None:
    """At t = 0 the printed first root is below 1; scaling the matrices shrinks its second root to nothing."""
    printed = {"P": [[1.03, -0.206], [-0.206, 1.03]], "Q": [[0.412, 0], [0, 0.206]], "Gamma": [[1.03]]}
    p = np.array(printed["P"])
    eigen = np.linalg.eigvalsh(p)
    assert np.sqrt(eigen[0] / eigen[1]) < 0.82
    gain = np.array([[0.6245], [0.125]])
    rest = np.linalg.norm(np.linalg.solve(A - gain @ C, gain))
    for scale in (1.0, 1e-4):
        values = {name: scale * np.array(m) for name, m in printed.items()} | {"U": scale * p @ gain}
        found = certificate(values, inequalities(A, C).check(values))
        printed_gain = np.sqrt(scale * 1.03 * eigen[1] / eigen[0])
        corrected = np.sqrt(1.03 * eigen[1] / (0.206 * eigen[0]))
        assert rest <= found.noise_gain <= corrected + 1e-12
        assert found.overshoot == pytest.approx(np.sqrt(eigen[1] / eigen[0]))
        assert found.rate >= 0.5 * 0.206 / eigen[1] - 1e-12
        assert found.rate == pytest.approx(0.5 * eigh(printed["Q"], p, eigvals_only=True)[0])
        assert found.noise_gain == pytest.approx(np.sqrt(1.03 / (2.0 * found.rate * eigen[0])))
    assert rest > printed_gain


def test_printed_matrices_are_audited() -> None:
    p, gain = np.array([[1.03, -0.206], [-0.206, 1.03]]), np.array([[0.6245], [0.125]])
    printed = {"P": p, "Q": np.diag([0.412, 0.206]), "Gamma": [[1.03]], "U": p @ gain}
    assert inequalities(A, C).check(printed)["the matrix of (4.16)"] == pytest.approx(0.02977, abs=1e-5)
    with pytest.raises(
        CertificateError, match=r"the matrix of \(4.16\) has the eigenvalue .* must lie below 0"
    ):
        inequalities(A, C).check(printed | {"Gamma": [[0.3]]})


def test_no_gain_is_returned_where_none_is_certified() -> None:
    with pytest.raises(
        InfeasibleError, match=r"\(A, C\) is not detectable: .* eigenvalue -?0[+-]1j never shows"
    ):
        certify(A, [[0.0, 0.0]])
    with pytest.raises(InfeasibleError, match=r"Theorem 4\.4\.1"):
        certify(A, C, gain=[[-0.5], [0.0]])
    for rate in (0.0, -1.0, np.inf, np.nan):
        with pytest.raises(ParameterError, match="rate must be a positive number"):
            certify(A, C, rate=rate)


def test_it_follows_the_differential_equation_between_irregular_samples(observer: InterlacedObserver) -> None:
    t, y = irregular(60, 1)
    stage = observer.fresh()
    rows = np.array([stage.update(value, time).w for value, time in zip(y, t, strict=True)])
    gain = observer.certificate.L[:, 0]

    def motion(now: float, w: np.ndarray) -> np.ndarray:
        return A @ w + gain * (np.interp(now, t, y) - w[0])

    for i in range(1, len(t)):
        span = (t[i - 1], t[i])
        answer = solve_ivp(motion, span, rows[i - 1], method="DOP853", rtol=1e-12, atol=1e-13)
        assert rows[i] == pytest.approx(answer.y[:, -1], abs=1e-10)


def test_a_rise_from_nothing_is_seen_at_once(observer: InterlacedObserver) -> None:
    """At rest with y = 0 the first derivative is zero, the second is not."""
    stage, h = observer.fresh(), 0.01
    stage.update(0.0, 0.0)
    expected = observer.certificate.L[:, 0] * h / 2
    assert np.array(stage.update(1.0, h).w) == pytest.approx(expected, rel=2 * h)


def test_the_maps_are_those_of_sympy(observer: InterlacedObserver) -> None:
    stage = observer.fresh()
    for value, time in zip(*irregular(20, 2)[::-1], strict=True):
        found = stage.update(value, time)
        expected = observer.steady.function()(np.array(found.w))
        assert np.array([*found.x, *found.z, found.input]) == pytest.approx(expected, rel=1e-13, abs=1e-14)


def test_it_converges_where_the_plant_is_on_its_steady_state(observer: InterlacedObserver) -> None:
    stage = observer.fresh()
    for t in np.arange(0.0, 60.0, 0.01):
        found = stage.update(np.cos(t), float(t))
    assert np.array(found.w) == pytest.approx([np.cos(t), -np.sin(t)], abs=5e-5)


def test_columns_samples_and_chunks_agree(observer: InterlacedObserver) -> None:
    t, y = irregular(50, 3)
    y[7], begin = np.nan, np.zeros(50, dtype=bool)
    begin[30] = True
    rows = np.column_stack([t, y])
    whole = observer.fresh().walk(begin, rows)
    stage, parts = observer.fresh(), observer.fresh()
    halves = np.vstack([parts.walk(begin[:13], rows[:13]), parts.walk(begin[13:], rows[13:])])
    assert np.array_equal(whole, halves)
    for i in range(50):
        if begin[i]:
            stage.reset()
        if i == 20:
            stage = pickle.loads(pickle.dumps(copy.copy(stage)))
        found = stage.update(None if np.isnan(y[i]) else y[i], float(t[i]))
        assert [*found.w, *found.x, *found.z, found.input] == whole[i].tolist()


def test_plain_python_agrees(observer: InterlacedObserver) -> None:
    step = getattr(interlaced_law.step, "py_func", interlaced_law.step)
    memory, compiled = observer.fresh()._memory, observer.fresh()._memory
    out, other = np.empty(7), np.empty(7)
    for time, value in zip(*irregular(10, 4), strict=True):
        step(memory, time, np.array([value]), out)
        interlaced_law.step(compiled, time, np.array([value]), other)
        assert out == pytest.approx(other, rel=1e-13, abs=1e-15)


def test_over_gaps_and_without_outputs_the_generator_runs_alone(observer: InterlacedObserver) -> None:
    start = [1.0, 0.5]
    stage = InterlacedObserver(eight(), observer.certificate, start=start, gap_s=0.5)
    assert stage.update(9.0, 10.0).w == (1.0, 0.5)
    assert stage.update(-3.0, 13.0).w == pytest.approx(expm(A * 3.0) @ start, abs=1e-13)
    before = stage.update(None, 13.1).w
    assert before == pytest.approx(expm(A * 3.1) @ start, abs=1e-13)
    assert stage.update(5.0, 13.2).w == pytest.approx(expm(A * 3.2) @ start, abs=1e-13)
    assert stage.update(5.0, 13.3).w != pytest.approx(expm(A * 3.3) @ start, abs=1e-3)
    assert stage.update(5.0, 1e5).w == (1.0, 0.5)


def test_what_cannot_be_taken_in_changes_nothing(observer: InterlacedObserver) -> None:
    stage = observer.fresh()
    stage.update(1.0, 1.0)
    before = stage.remembered()
    with pytest.raises(EventOrderError, match="t must not run backwards"):
        stage.update(1.0, 0.5)
    for wrong in (np.nan, [1.0, 2.0], np.inf):
        with pytest.raises(EventError, match="needs 1 finite outputs, received"):
            stage.update(wrong, 2.0)
    with pytest.raises(EventError, match="outputs must be numbers, received 'far'"):
        stage.update("far", 2.0)
    assert stage.remembered() == before


def test_an_observer_needs_linear_outputs_and_numbers(observer: InterlacedObserver) -> None:
    assert output_matrix(eight()).tolist() == [[1.0, 0.0]]
    with pytest.raises(ParameterError, match="needs outputs of the system, received none"):
        output_matrix(eight(()))
    with pytest.raises(ParameterError, match=r"output 1 must be C w with numbers C, received w1\*\*3 \+ w2"):
        output_matrix(eight((X4,)))
    with pytest.raises(ParameterError, match=r"gap_s must lie in \[1e-06, 1e\+06\] s, received 0"):
        InterlacedObserver(eight(), observer.certificate, gap_s=0.0)
    with pytest.raises(ParameterError, match="start has shape"):
        InterlacedObserver(eight(), observer.certificate, start=[1.0])


@pytest.mark.parametrize("row", [[1.0, 0.0], [1.0, 1.0]], ids=["example 8", "example 9"])
def test_another_solver_finds_the_same_least_trace(row: list[float]) -> None:
    pytest.importorskip("cvxopt")

    def least(solver: str) -> float:
        problem = inequalities(A, [row]).above("Q - rate P", lambda v: v.Q - 0.5 * v.P)
        solution = problem.solve(minimise=lambda v: np.trace(v.P) + np.trace(v.Gamma), solver=solver)
        assert solution.objective is not None
        return solution.objective

    assert least("CVXOPT") == pytest.approx(least("CLARABEL"), rel=1e-5)
