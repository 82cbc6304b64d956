"""Matrix inequalities: three answers, and no certificate that its own eigenvalues do not bear out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.linalg import solve_continuous_lyapunov

from pointpred.errors import CertificateError, InfeasibleError, UndecidedError
from pointpred_observers import invariant_observer
from pointpred_observers.camera import camera_box, camera_system
from pointpred_observers.examples import UNMEASURED, academic, chua_circuits, two_masses
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.proofs import matrix_inequalities, solver
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.solver import Affine, Answer, reach, run
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.thesis import certify_convergence
from pointpred_observers.triangular.interlaced_observer import certify as certify_interlaced
from pointpred_observers.unknown_input.observer import UnknownInputObserver


def lyapunov(a: Any) -> MatrixInequalities:
    return (
        MatrixInequalities("Lyapunov").positive("P", len(a)).below("A'P + PA", lambda v: a.T @ v.P + v.P @ a)
    )


def trace(v: Any) -> float:
    return float(np.trace(v.P))


@given(st.integers(1, 5), st.integers(0, 2**32 - 1), st.booleans())
@example(4, 568621, False)  # the solver stalls before its tight tolerances
@settings(max_examples=25)
def test_a_certificate_exists_exactly_where_the_eigenvalues_say_so(n: int, seed: int, stable: bool) -> None:
    a = np.random.default_rng(seed).normal(size=(n, n))
    a -= (np.linalg.eigvals(a).real.max() + (0.3 if stable else -0.3)) * np.eye(n)
    if not stable:
        with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
            lyapunov(a).solve()
        return
    solution = lyapunov(a).solve(minimise=trace)
    p = solution.values["P"]
    assert np.array_equal(p, p.T)
    assert np.linalg.eigvalsh(p).min() == pytest.approx(solution.margins["P > 0"])
    largest = np.linalg.eigvalsh(a.T @ p + p @ a).max()
    assert largest == pytest.approx(-solution.margins["A'P + PA"], abs=1e-9)
    assert largest < 0.0


def test_infeasible_is_not_undecided() -> None:
    with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
        lyapunov(np.diag([-1.0, 0.1])).solve()
    with pytest.raises(UndecidedError, match="no P with a condition number below"):
        lyapunov(np.array([[-1.0, 2e6], [0.0, -1.0]])).solve()


def test_a_solver_that_lies_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    def lie(problem: Affine, *, margin: float | None) -> Answer:
        return Answer("optimal", np.array([1.0, 0.0, 1.0]), 1e-2, None)

    monkeypatch.setattr(solver, "run", lie)
    with pytest.raises(CertificateError, match=r"claims 0\.01, its matrices fail: A'P \+ PA has 0\.162"):
        lyapunov(np.array([[0.0, 1.0], [-2.0, -3.0]])).solve()


def test_multipliers_that_prove_nothing_leave_it_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    def mute(problem: Affine, *, margin: float | None) -> Answer:
        answer = run(problem, margin=margin)
        return Answer(answer.status, None, answer.claimed, None)

    monkeypatch.setattr(solver, "run", mute)
    with pytest.raises(UndecidedError, match=r"the solver proves nothing \(its status"):
        lyapunov(np.eye(2)).solve()


def test_a_solver_that_panics_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    """The errors of a solver that is written in Rust are no exceptions of Python's."""
    panic = type("PanicException", (BaseException,), {})

    def solve(*given: Any, **settings: Any) -> None:
        raise panic("Eigval error")

    monkeypatch.setattr("cvxpy.Problem.solve", solve)
    with pytest.raises(UndecidedError, match="its status: failed: Eigval error"):
        lyapunov(-np.eye(2)).solve()


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=20)
def test_no_choice_within_the_reach_of_a_proof_satisfies_the_inequalities(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a = rng.normal(size=(3, 3))
    problem = lyapunov(a)
    affine = problem._numbers(None, 100.0)
    excluded = reach(affine, run(affine, margin=None).multipliers)
    for _ in range(30):
        factor = rng.normal(size=(3, 3))
        p = np.eye(3) + factor @ factor.T
        reached, largest = problem.margins({"P": p})["A'P + PA"], np.linalg.eigvalsh(p).max()
        assert reached < 0.0 or largest > excluded


@given(st.integers(1, 5), st.integers(0, 2**32 - 1))
@settings(max_examples=15, deadline=None)
def test_a_least_objective_comes_with_a_bound_below_it(n: int, seed: int) -> None:
    """The least trace of P >= I with A'P + PA < 0; no P that is tried lies below objective - gap."""
    rng = np.random.default_rng(seed)
    a = rng.normal(size=(n, n))
    a -= (np.linalg.eigvals(a).real.max() + 0.3) * np.eye(n)
    solution = lyapunov(a).solve(minimise=trace)
    assert solution.objective is not None
    assert solution.gap is not None
    assert 0.0 <= solution.gap < 1e-2
    least = solution.objective * (1.0 - solution.gap)
    for _ in range(20):
        q = rng.normal(size=(n, n))
        p = solve_continuous_lyapunov(a.T, -q @ q.T - 1e-9 * np.eye(n))
        p = p / np.linalg.eigvalsh(p).min()
        assert np.trace(p) >= least * (1.0 - 1e-9)


def test_numbers_that_only_relax_have_no_bound() -> None:
    """The epigraph of a square of 1e5: 1e10 is far above kappa."""
    problem = MatrixInequalities("square").positive("P", 1).number("size").free("K", 1, 1)
    problem.above("size - K^2 / P", lambda v: np.block([[v.size * np.eye(1), v.K.T], [v.K, v.P]]))
    problem.below("K", lambda v: v.K + 1e5 * v.P)
    solution = problem.solve(minimise=lambda v: v.size)
    assert solution.objective == pytest.approx(1e10, rel=1e-3)


def test_equalities_hold_exactly_and_contradictions_are_found() -> None:
    a = np.array([[-1.0, 2.0], [0.0, -3.0]])
    problem = lyapunov(a).equal("trace P = 5", lambda v: np.trace(v.P) - 5.0)
    solution = problem.solve()
    assert np.trace(solution.values["P"]) == pytest.approx(5.0, abs=1e-12)
    with pytest.raises(InfeasibleError, match=r"cannot hold: the least residual is 1"):
        problem.equal("trace P = 7", lambda v: np.trace(v.P) - 7.0).solve()


def test_rounding_is_an_excuse_only_where_it_is_one() -> None:
    a = np.array([[0.0, 1.0], [-1.0, -0.001]])
    with pytest.raises(CertificateError, match=r"entries rounded by 0\.001 could explain it"):
        lyapunov(a).check({"P": np.eye(2)}, rounding=1e-3)
    with pytest.raises(CertificateError, match=r"entries rounded by 0\.001 cannot explain it"):
        lyapunov(a).check({"P": np.diag([1.0, 2.0])}, rounding=1e-3)


def test_diagonals_and_numbers_are_never_negative() -> None:
    problem = MatrixInequalities("bounds").diagonal("D", 2).number("g").free("F", 1, 2)
    problem = problem.below("D", lambda v: v.D - v.g * np.eye(2)).above("g", lambda v: 3.0 - v.g)
    solution = problem.solve(minimise=lambda v: v.g + np.trace(v.D))
    assert (np.diag(solution.values["D"]) >= 0.0).all()
    assert solution.values["F"].shape == (1, 2)
    with pytest.raises(CertificateError, match="D >= 0 fails: its least value is -1"):
        problem.check({"D": np.diag([-1.0, 0.0]), "g": 1.0, "F": [[0.0, 0.0]]})


@pytest.mark.parametrize("scale", [1e-14, 1.0, 1e14])
def test_an_eigenvalue_of_zero_is_told_from_a_small_one_in_every_unit(scale: float) -> None:
    """A block of 1e-14 fails by a tenth of itself, one of 1e14 holds although rounding moves it by 0.02."""
    equal = MatrixInequalities("edge").number("a").number("b")
    equal.below("a - b", lambda v: scale * (v.a - v.b), strict=False)
    equal.above("b - a", lambda v: scale * (v.b - v.a), strict=False)
    assert equal.check({"a": 1.0 + 2.0**-52, "b": 1.0})["a - b"] < 0.0
    with pytest.raises(CertificateError, match="a - b has the eigenvalue"):
        equal.check({"a": 1.1, "b": 1.0})
    with pytest.raises(CertificateError, match="b - a has the eigenvalue"):
        equal.check({"a": 1.0 + 1e-11, "b": 1.0})


def test_an_answer_may_not_violate_what_a_printed_matrix_may(monkeypatch: pytest.MonkeyPatch) -> None:
    """P - Q <= 0 fails by 1e-13 of its terms: rounding of a print, but no design."""
    problem = MatrixInequalities("weak").positive("P", 1).symmetric("Q", 1)
    problem.below("P - Q", lambda v: v.P - v.Q, strict=False)
    assert problem.check({"P": 1.0, "Q": 1.0 - 1e-13})["P - Q"] < 0.0
    answer = Answer("optimal", np.array([1.0, 1.0 - 1e-13]), 0.0, None)
    monkeypatch.setattr(matrix_inequalities, "answered", lambda *given: answer)
    with pytest.raises(UndecidedError):
        problem.solve()


def test_an_answer_too_large_for_a_symmetric_block_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    """a + b - b is a for the numbers with which the block is probed, and 0 for a = 1 and b = 1e20."""
    problem = MatrixInequalities("large").number("a").number("b").positive("P", 1)
    problem.below("block", lambda v: np.array([[-2.0, v.a + v.b - v.b], [v.a, -2.0]]))
    answer = Answer("optimal", np.array([1.0, 1e20, 1.0]), 0.0, None)
    monkeypatch.setattr(matrix_inequalities, "answered", lambda *given: answer)
    with pytest.raises(UndecidedError):
        problem.solve()


@pytest.mark.parametrize("size", [1.0, 1e8])
def test_an_equality_is_judged_by_its_own_terms(size: float) -> None:
    """Gamma = 1e8 is no excuse for a printed F that is off, nor is a first row of 1e8 for the second."""
    scale = np.diag([size, 1.0])

    def off(by: float) -> MatrixInequalities:
        problem = MatrixInequalities("print").symmetric("P", 2).symmetric("Gamma", 1)
        return problem.equal("P S - F", lambda v: scale @ v.P @ [[1.0], [3.0]] - scale @ [[1.0], [3.0 + by]])

    values = {"P": np.eye(2), "Gamma": [[size]]}
    assert off(0.0).check(values)["P S - F"] >= 0.0
    assert off(1e-10).check(values)["P S - F"] >= 0.0
    with pytest.raises(CertificateError, match=r"P S - F fails by 9\.[0-9]+e-07"):
        off(1e-6).check(values)


CALM = {"turn": (-0.02, 0.02), "a_z": (-0.1, 0.1), "w": (0.0, 0.0), "dw": (0.0, 0.0)}


DOORS: dict[str, Any] = {
    "observer": lambda: DrivenObserver.design(academic()[0], generator=academic()[1], decay=0.0).gap,
    "observer with a sector": lambda: (
        DrivenObserver.design(
            chua_circuits(0.3)[0], generator=chua_circuits(0.3)[1], Pi=np.eye(3), decay=0.0
        ).gap
    ),
    "convergence": lambda: (
        certify_convergence(invariant_observer(two_masses(1.0), UNMEASURED, [[-1, 0], [0, 0]]), decay=0.2).gap
    ),
    "reduced order": lambda: ReducedOrderObserver.design(two_masses(), Pi=UNMEASURED, decay=0.5).gap,
    "interlaced": lambda: certify_interlaced([[0.0, 1.0], [-1.0, 0.0]], [[1.0, 1.0]], decay=0.25).gap,
    "unknown input": lambda: (
        UnknownInputObserver.design(camera_system(), camera_box((-0.4, -0.05), **CALM), 0.01).certificate.gap
    ),
}


@pytest.mark.parametrize("door", list(DOORS))
def test_the_answer_tells_its_gap(door: str) -> None:
    assert 0.0 <= DOORS[door]() < 1e-2


def test_where_the_solver_fails_on_the_minimum_bisection_comes_near_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    a = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-6.0, -11.0, -6.0]])

    def least() -> Any:
        problem = MatrixInequalities("Lyapunov").positive("P", 3)
        problem.below("A'P + PA", lambda v: a.T @ v.P + v.P @ a)
        return problem.solve(minimise=lambda v: np.trace(v.P))

    wanted = least()

    def stalled(problem: Affine, *, margin: float | None) -> Answer:
        if margin is not None:
            return Answer("user_limit", None, -np.inf, None)
        return run(problem, margin=margin)

    monkeypatch.setattr(solver, "run", stalled)
    reached = least()
    assert reached.gap == np.inf  # nothing is proved without multipliers
    assert wanted.objective <= reached.objective <= 1.1 * wanted.objective
