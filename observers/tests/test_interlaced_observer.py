"""Theorem 4.4.1 and the observer (4.16): certificate, bound, and the stage on irregular samples with gaps."""

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
from scipy.special import erf

from observers.tests.solvers import solved_by
from pointpred.errors import (
    CertificateError,
    EventError,
    EventOrderError,
    InfeasibleError,
    ParameterError,
    UndecidedError,
)
from pointpred_observers import SymbolicSystem, interlaced
from pointpred_observers.examples import interlaced_states, oscillator
from pointpred_observers.plants.symbolic import SymbolicSteadyState
from pointpred_observers.triangular.interlaced_observer import (
    InterlacedCertificate,
    InterlacedEstimate,
    InterlacedObserver,
    certify,
    theorem_4_4_1,
)

sp = pytest.importorskip("sympy")
pytest.importorskip("cvxpy")
W1, W2, U, X1, X2 = sp.symbols("w1 w2 u x1 x2")
A = np.array([[0.0, 1.0], [-1.0, 0.0]])
C = np.array([[1.0, 0.0]])
GAIN = np.array([[0.6245], [0.125]])


def test_the_margins_are_those_of_the_matrices_returned() -> None:
    found = certify(A, C, decay=0.4)
    corner = found.P @ A - found.U @ C
    block = np.block([[corner + corner.T + found.Q, -found.U], [-found.U.T, -found.Gamma]])
    assert np.linalg.eigvalsh(block).max() < 0.0
    assert min(np.linalg.eigvalsh(m).min() for m in (found.P, found.Q, found.Gamma)) > 0.0
    assert min(found.margins.values()) > 0.0
    assert pytest.approx(found.U, abs=1e-12) == found.P @ found.L
    assert found.bound.decay >= 0.4
    assert np.linalg.eigvals(A - found.L @ C).real.max() <= -0.4


@cache
def certified() -> InterlacedCertificate:
    return certify(A, C, decay=0.25, gain=GAIN)


@given(st.integers(0, 10**6))
@settings(max_examples=15)
def test_the_corrected_bound_holds_on_random_trajectories(seed: int) -> None:
    random = np.random.default_rng(seed)
    bound = certified().bound
    start, h = random.normal(size=2), 0.05
    noise = random.uniform(-1.0, 1.0, 400) * random.uniform(0.0, 2.0)
    e, size = start.copy(), float(np.linalg.norm(start))
    big = np.zeros((3, 3))
    big[:2, :2], big[:2, 2:] = A - GAIN @ C, -GAIN
    turn = expm(big * h)
    for i, v in enumerate(noise):
        e = turn[:2, :2] @ e + turn[:2, 2] * v
        assert np.linalg.norm(e) <= bound((i + 1) * h, size, v=float(np.abs(noise).max())) + 1e-12


def test_the_printed_bound_is_exceeded_and_the_corrected_one_holds() -> None:
    """At t = 0 the printed first root is below 1; scaling the matrices shrinks its second root to nothing."""
    printed = {"P": [[1.03, -0.206], [-0.206, 1.03]], "Q": [[0.412, 0], [0, 0.206]], "Gamma": [[1.03]]}
    p = np.array(printed["P"])
    eigen = np.linalg.eigvalsh(p)
    assert np.sqrt(eigen[0] / eigen[1]) < 0.82
    rest = np.linalg.norm(np.linalg.solve(A - GAIN @ C, GAIN))
    for scale in (1.0, 1e-4):
        values = {name: scale * np.array(m) for name, m in printed.items()} | {"U": scale * p @ GAIN}
        bound = InterlacedCertificate.audited(A, C, values).bound
        printed_gain = np.sqrt(scale * 1.03 * eigen[1] / eigen[0])
        corrected = np.sqrt(1.03 * eigen[1] / (0.206 * eigen[0]))
        assert rest <= bound.gains[0] <= corrected + 1e-12
        assert bound.overshoot == pytest.approx(np.sqrt(eigen[1] / eigen[0]))
        assert bound.decay >= 0.5 * 0.206 / eigen[1] - 1e-12
        assert bound.decay == pytest.approx(0.5 * eigh(printed["Q"], p, eigvals_only=True)[0])
        assert bound.gains[0] == pytest.approx(np.sqrt(1.03 / (2.0 * bound.decay * eigen[0])))
    assert rest > printed_gain


def test_printed_matrices_are_audited() -> None:
    p = np.array([[1.03, -0.206], [-0.206, 1.03]])
    printed = {"P": p, "Q": np.diag([0.412, 0.206]), "Gamma": [[1.03]], "U": p @ GAIN}
    assert theorem_4_4_1(A, C).check(printed)["the matrix of (4.16)"] == pytest.approx(0.02977, abs=1e-5)
    with pytest.raises(
        CertificateError, match=r"the matrix of \(4.16\) has the eigenvalue .* must lie below 0"
    ):
        theorem_4_4_1(A, C).check(printed | {"Gamma": [[0.3]]})


@pytest.mark.parametrize("gain", [None, [[60.0], [9.36e12]]])
def test_no_proof_within_some_condition_number_says_that_no_gain_exists(gain: Any) -> None:
    """The gain makes the eigenvalues -30 +- 6i, only the P of it has a condition number of 1e22."""
    with pytest.raises(UndecidedError, match="decay = 24 is too large for the arithmetic"):
        certify(1e-10 * A, C, decay=24.0, gain=gain)


@pytest.mark.parametrize(("gain", "decay"), [(None, 2.0), ([[4.0], [0.0]], 1.5)])
def test_a_mode_that_never_shows_or_is_left_slow_is_proved_to_be_one(gain: Any, decay: float) -> None:
    with pytest.raises(InfeasibleError, match="no choice satisfies the inequalities"):
        certify([[0.0, 0.0], [0.0, -1.0]], C, decay=decay, gain=gain)


def test_no_gain_is_returned_where_none_is_certified() -> None:
    with pytest.raises(
        InfeasibleError, match=r"\(A, C\) is not detectable: .* eigenvalue -?0[+-]1j never shows"
    ):
        certify(A, [[0.0, 0.0]])
    with pytest.raises(InfeasibleError, match=r"Theorem 4\.4\.1"):
        certify(A, C, gain=[[-0.5], [0.0]])
    for decay in (0.0, -1.0, np.inf, np.nan):
        with pytest.raises(ParameterError, match="decay must be finite and above 0"):
            certify(A, C, decay=decay)


@pytest.mark.parametrize("row", [[1.0, 0.0], [1.0, 1.0]], ids=["example 8", "example 9"])
def test_another_solver_finds_the_same_least_trace(row: list[float]) -> None:
    pytest.importorskip("cvxopt")

    def least(solver: str) -> float:
        problem = theorem_4_4_1(A, [row]).above("Q - 2 decay P", lambda v: v.Q - 0.5 * v.P)
        with solved_by(solver):
            solution = problem.solve(minimise=lambda v: np.trace(v.P) + np.trace(v.Gamma))
        assert solution.objective is not None
        return solution.objective

    assert least("CVXOPT") == pytest.approx(least("CLARABEL"), rel=1e-5)


@cache
def eight(outputs: tuple[Any, ...] | None = None) -> SymbolicSteadyState:
    system, generator = interlaced_states()
    seen = system.outputs if outputs is None else outputs
    system = SymbolicSystem(system.states, system.field, system.input, outputs=seen)
    return interlaced(system, generator, 2, W1, degree=3)


@pytest.fixture(scope="module")
def observer() -> InterlacedObserver:
    return InterlacedObserver.design(eight(), decay=0.25, gap_s=0.5)


def irregular(count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    t = np.cumsum(random.uniform(0.001, 0.3, count))
    return t, np.cos(t) + random.normal(0.0, 0.1, count)


def flat(found: InterlacedEstimate) -> list[float]:
    return [*found.w, *found.x, *found.z, found.input]


def test_it_follows_the_differential_equation_between_irregular_samples(observer: InterlacedObserver) -> None:
    t, y = irregular(60, 1)
    stage = observer.stage()
    rows = np.array([stage.update(value, time).w for value, time in zip(y, t, strict=True)])
    gain = observer.certificate.L[:, 0]

    def motion(now: float, w: np.ndarray) -> np.ndarray:
        return A @ w + gain * (np.interp(now, t, y) - w[0])

    for i in range(1, len(t)):
        span = (t[i - 1], t[i])
        answer = solve_ivp(motion, span, rows[i - 1], method="DOP853", rtol=1e-12, atol=1e-13)
        assert rows[i] == pytest.approx(answer.y[:, -1], abs=1e-10)


def test_the_maps_are_those_of_sympy_and_it_converges(observer: InterlacedObserver) -> None:
    stage = observer.stage()
    for t in np.arange(0.0, 60.0, 0.01):
        found = stage.update(np.cos(t), float(t))
    assert np.array(found.w) == pytest.approx([np.cos(t), -np.sin(t)], abs=5e-5)
    at = dict(zip((W1, W2), found.w, strict=True))
    expected = [float(e.subs(at)) for e in (*observer.steady.maps, observer.steady.input)]
    assert [*found.x, found.input] == pytest.approx(expected, rel=1e-13, abs=1e-14)


def test_tables_samples_chunks_and_pickles_agree(observer: InterlacedObserver) -> None:
    t, y = irregular(60, 3)
    t[40:] += 0.7  # a gap
    t[45:] += 1e4  # one that is too long to be bridged
    y[7], begin = np.nan, np.zeros(60, dtype=bool)
    begin[30] = True
    rows = np.column_stack([t, y])
    whole = observer.stage().walk(begin, rows)
    stage, parts = observer.stage(), observer.stage()
    halves = np.vstack([parts.walk(begin[:13], rows[:13]), parts.walk(begin[13:], rows[13:])])
    assert np.array_equal(whole, halves)
    for i in range(60):
        if begin[i]:
            stage.reset()
        if i == 20:
            stage = pickle.loads(pickle.dumps(copy.copy(stage)))
        assert flat(stage.update(None if np.isnan(y[i]) else y[i], float(t[i]))) == whole[i].tolist()
    assert whole[45, :2].tolist() == [0.0, 0.0]
    backwards = rows.copy()
    backwards[10, 0] = 0.0
    found = observer.stage().walk(begin, backwards)
    assert np.isnan(found).any(axis=1).nonzero()[0].tolist() == [10]
    assert np.array_equal(
        found[11:], observer.stage().walk(np.delete(begin, 10), np.delete(rows, 10, 0))[10:]
    )


def test_over_gaps_and_without_outputs_the_generator_runs_alone(observer: InterlacedObserver) -> None:
    start = [1.0, 0.5]
    stage = observer.stage(start=start)
    assert stage.update(9.0, 10.0).w == (1.0, 0.5)
    assert stage.update(-3.0, 13.0).w == pytest.approx(expm(A * 3.0) @ start, abs=1e-9)
    assert stage.update(None, 13.1).w == pytest.approx(expm(A * 3.1) @ start, abs=1e-9)
    assert stage.update(5.0, 13.2).w == pytest.approx(expm(A * 3.2) @ start, abs=1e-9)
    assert stage.update(5.0, 13.3).w != pytest.approx(expm(A * 3.3) @ start, abs=1e-3)
    assert stage.update(5.0, 1e5).w == (1.0, 0.5)


def test_what_cannot_be_taken_in_changes_nothing(observer: InterlacedObserver) -> None:
    stage = observer.stage()
    stage.update(1.0, 1.0)
    kept = pickle.dumps(stage)
    with pytest.raises(EventOrderError, match="t must not run backwards"):
        stage.update(1.0, 0.5)
    for wrong in ([1.0, 2.0], np.inf, "far"):
        for t in (1.2, 2.0):  # within a gap and after one
            with pytest.raises(EventError) as refused:
                stage.update(wrong, t)
            assert refused.value.field == "inputs"
    assert pickle.dumps(stage) == kept


def of(function: Any) -> SymbolicSteadyState:
    system = SymbolicSystem((X1, X2), (-function(X1) + X2, -X2 + U), U, outputs=(X1,))
    return interlaced(system, oscillator(), 0, W1)


@pytest.mark.parametrize(
    ("symbolic", "f", "slope"),
    [
        (sp.erf, erf, lambda w: 2.0 / np.sqrt(np.pi) * np.exp(-(w**2))),
        (sp.asinh, np.arcsinh, lambda w: 1.0 / np.sqrt(1.0 + w**2)),
    ],
)
def test_maps_of_any_function_run(symbolic: Any, f: Any, slope: Any) -> None:
    """x2 = w2 + f(w1) and u = -w1 + f'(w1) w2 + x2, beside scipy's f."""
    stage = InterlacedObserver.design(of(symbolic), decay=1.0).stage()
    for t in np.arange(0.0, 12.0, 0.05):
        found = stage.update(2.0 * np.cos(t), t)
        w1, w2 = found.w
        assert found.x == pytest.approx((w1, w2 + f(w1)), abs=1e-14)
        assert found.input == pytest.approx(-w1 + slope(w1) * w2 + w2 + f(w1), abs=1e-13)
    assert found.w == pytest.approx((2.0 * np.cos(t), -2.0 * np.sin(t)), abs=1e-2)


def test_what_has_no_finite_value_is_nan_and_a_function_without_numbers_is_named() -> None:
    stage = InterlacedObserver.design(of(lambda x: sp.log(x + 1)), decay=1.0, start=[-2.0, 1.0]).stage()
    found = stage.update(0.0, 0.0)
    assert found.x[0] == -2.0
    assert np.isnan(found.x[1])
    with pytest.raises(ParameterError, match="no numerical form"):
        InterlacedObserver.design(of(sp.Function("friction")), decay=1.0).stage()
