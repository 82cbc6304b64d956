"""Theorem 4.4.1: the certificate, its corrected bound, and what is printed."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import eigh, expm

from observers.tests.solvers import solved_by
from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred_observers.triangular.interlaced_observer import (
    InterlacedCertificate,
    certificate,
    certify,
    theorem_4_4_1,
)

pytest.importorskip("cvxpy")
A = np.array([[0.0, 1.0], [-1.0, 0.0]])
C = np.array([[1.0, 0.0]])


def test_the_margins_are_those_of_the_matrices_returned() -> None:
    found = certify(A, C, decay=0.4)
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
    return certify(A, C, decay=0.25, gain=[[0.6245], [0.125]])


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
        found = certificate(values, theorem_4_4_1(A, C).check(values))
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
    assert theorem_4_4_1(A, C).check(printed)["the matrix of (4.16)"] == pytest.approx(0.02977, abs=1e-5)
    with pytest.raises(
        CertificateError, match=r"the matrix of \(4.16\) has the eigenvalue .* must lie below 0"
    ):
        theorem_4_4_1(A, C).check(printed | {"Gamma": [[0.3]]})


def test_no_gain_is_returned_where_none_is_certified() -> None:
    with pytest.raises(
        InfeasibleError, match=r"\(A, C\) is not detectable: .* eigenvalue -?0[+-]1j never shows"
    ):
        certify(A, [[0.0, 0.0]])
    with pytest.raises(InfeasibleError, match=r"Theorem 4\.4\.1"):
        certify(A, C, gain=[[-0.5], [0.0]])
    for rate in (0.0, -1.0, np.inf, np.nan):
        with pytest.raises(ParameterError, match="rate must be a positive number"):
            certify(A, C, decay=rate)


@pytest.mark.parametrize("row", [[1.0, 0.0], [1.0, 1.0]], ids=["example 8", "example 9"])
def test_another_solver_finds_the_same_least_trace(row: list[float]) -> None:
    pytest.importorskip("cvxopt")

    def least(solver: str) -> float:
        problem = theorem_4_4_1(A, [row]).above("Q - rate P", lambda v: v.Q - 0.5 * v.P)
        with solved_by(solver):
            solution = problem.solve(minimise=lambda v: np.trace(v.P) + np.trace(v.Gamma))
        assert solution.objective is not None
        return solution.objective

    assert least("CVXOPT") == pytest.approx(least("CLARABEL"), rel=1e-5)
