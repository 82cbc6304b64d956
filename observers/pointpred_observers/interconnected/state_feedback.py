"""State feedback for Persidskii plants: gains L0 and L1 with a proof of the closed loop's decay."""

from __future__ import annotations

from math import exp
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.eigenvalues import number_text, undetectable, vertices
from pointpred_observers.numerics.equalities import NO_DIGIT, without_rounding
from pointpred_observers.numerics.matrices import matrix, positive
from pointpred_observers.plants.linear_systems import Plant, constant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.bounds import solved
from pointpred_observers.proofs.error_system import (
    DecayCertificate,
    ErrorSystem,
    certify_decay,
    sloped_system,
)
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import Posed, search

ROOM = 1.01
"""The feedback is designed for a decay larger by this factor than the certified one."""


class StateFeedback(msgspec.Struct, frozen=True):
    """u = L0 x + L1 f(Hx), and the certificate of x' = (A0 + B L0) x + (A1 + B L1) f(Hx) + d."""

    L0: FloatArray
    L1: FloatArray
    certificate: DecayCertificate


def design_state_feedback(
    plant: Plant,
    *,
    decay: float = 1.0,
    L1: Any = None,
) -> StateFeedback:
    """The feedback u = L0 x + L1 f(Hx) of small gain with which any two solutions approach each other.

    Assumes that the state is known; see ``design_regulator`` where only the output is. With f = m s + df, m
    the middle of each slope and abs(df_j) <= delta_j abs(s_j), delta half its width, Y = (L0 + L1 m H) X and
    Z = L1 T the condition is linear:

    ((sym(2 (A0 + A1 m H) X + 2 B Y) + 2 decay X, A1 T + B Z, X H' delta), (., -T, 0), (., 0, -T)) < 0

    with X > 0 and a diagonal T > 0; in discrete time the corresponding inequality of the next state.
    Minimises abs(u)^2 over the ellipsoid x'X^-1 x + df'T^-1 df <= 1 in balanced units. One function of
    Lyapunov for all slopes: a refusal does not prove that no feedback exists unless f is absent.

    Parameters: ``decay`` in 1/s (1/step), > 0; ``L1`` (m, k) if it is chosen already: zeros, or one that
    cancels A1, for which slopes are not needed.
    Raises InfeasibleError naming a mode that no input moves before any solver runs; InfeasibleError,
    UndecidedError and CertificateError from the solver; ParameterError for a plant without input, with
    varying matrices, or slopes that are missing or not bounded.

    Reference: Boyd, El Ghaoui, Feron, Balakrishnan 1994, section 7.2; S and S~ of Khalin 2022, Assumption
    3.2.3.

    >>> mass = Persidskii([[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0], [1.0, 0.0], "sin", [0.0, 1.0])
    >>> feedback = design_state_feedback(mass, decay=1.0)
    >>> round(feedback.certificate.bound.decay, 6), min(feedback.certificate.margins.values()) > 0.0
    (1.0, True)
    """
    decay = positive("decay", decay)
    one = constant(plant)
    if not one.B.any():
        raise ParameterError("a feedback needs an input: give the plant a B other than 0", field="B")
    fixed = None if L1 is None else matrix("L1", L1, one.m, one.k)
    l1 = np.zeros((one.m, one.k)) if fixed is None else fixed
    a1 = without_rounding(one.A1 + one.B @ l1, one.A1, one.B @ l1)
    corners = vertices(one.slopes) if a1.any() else {"": np.zeros((one.k, one.r))}
    for name, d in corners.items():
        for mode in undetectable((one.A0 + a1 @ d @ one.H).T, one.B.T, one.time):
            corner = f" at D = diag({name})" if name else ""
            raise InfeasibleError(
                f"no input moves the mode of the eigenvalue {number_text(mode)}{corner}: "
                "(A0, B) is not stabilisable"
            )
    middle, half = _slopes(one) if a1.any() else (np.zeros(one.k), np.zeros(one.k))
    slope = middle[:, None] * one.H if a1.any() else np.zeros((one.k, one.n))
    used = (half > 0.0) & a1.any(axis=0)  # elsewhere f is linear, or has no effect
    drift, driven, inner = one.A0 + a1 @ slope, a1[:, used], half[used, None] * one.H[used]
    free = fixed is None and bool(used.any())

    def posed(units: Coordinates) -> Posed:
        x, f, t = units.states, units.values, units.seconds
        b = inward(one.B, x, np.ones(one.m), t)
        u = 1.0 / np.where(b.any(axis=0), np.abs(b).max(axis=0, initial=0.0), 1.0)
        scaled = (inward(drift, x, x, t), b * u, inward(driven, x, f, t), inward(inner, f, x))
        measured = {
            "X": 1.0 / np.outer(x, x),
            "Y": 1.0 / np.outer(u, x),
            "Z": 1.0 / np.outer(u, f),
            "T": 1.0 / np.outer(f, f),
        }
        problem = _inequalities(*scaled, ROOM * decay * t, one.time, free=free)
        return Posed(problem, measured, lambda v: v.size)

    def audited(values: dict[str, Any], _: float) -> StateFeedback:
        l0, whole = solved(values["X"], values["Y"].T).T, l1.copy()
        sizes = np.sqrt(np.diag(values["X"]))
        terms = np.abs(l0 * sizes).max(axis=1, initial=0.0)[:, None] / sizes
        l0 = without_rounding(l0, terms, share=NO_DIGIT)
        if free:
            whole[:, used] = values["Z"] / np.diag(values["T"])
            l0 = l0 - whole @ slope
        return StateFeedback(l0, whole, certify_decay(closed_system(one, l0, whole), decay=decay))

    units = balanced(
        drift,
        driven=driven,
        inner=inner,
        moved=one.B,
        slopes=((0.0, 1.0),) * len(inner),
        rates=(ROOM * decay,),
        time=one.time,
    )
    return search(units, posed, audited)


def closed_system(plant: Persidskii, L0: FloatArray, L1: FloatArray) -> ErrorSystem:
    """The system of the difference of two solutions under the feedback."""
    whole = without_rounding(plant.A1 + plant.B @ L1, plant.A1, plant.B @ L1)
    return sloped_system(
        plant.A0 + plant.B @ L0,
        whole,
        plant.H,
        {"d": np.eye(plant.n)},
        slopes=plant.slopes,
        time=plant.time,
        domain=plant.domain,
    )


def _slopes(plant: Persidskii) -> tuple[FloatArray, FloatArray]:
    """The middle and half the width of each slope; raises ParameterError where one is not bounded."""
    vertices(plant.slopes)
    low, high = np.array(plant.slopes).reshape(-1, 2).T
    return 0.5 * (low + high), 0.5 * (high - low)


def _inequalities(
    a: FloatArray,
    b: FloatArray,
    a1: FloatArray,
    h: FloatArray,
    decay: float,
    time: str,
    *,
    free: bool,
) -> MatrixInequalities:
    """The condition for abs(df_j) <= abs(h_j x), and the size of the input over the ellipsoid."""
    from scipy.linalg import block_diag

    (n, m), k = b.shape, a1.shape[1]
    problem = MatrixInequalities("state feedback").positive("X", n).free("Y", m, n).number("size")
    problem.diagonal("T", k).above("T > 0", lambda v: v.T)
    if free:
        problem.free("Z", m, k)

    def onward(v: Any) -> FloatArray:
        return np.hstack([a @ v.X + b @ v.Y, a1 @ v.T + (b @ v.Z if free else 0.0)])

    def continuous(v: Any) -> FloatArray:
        moved = onward(v)
        first = moved[:, :n] + moved[:, :n].T + 2.0 * decay * v.X
        across = np.hstack([moved[:, n:], v.X @ h.T])
        return np.block([[first, across], [across.T, -np.kron(np.eye(2), v.T)]])

    def discrete(v: Any) -> FloatArray:
        moved = np.vstack([onward(v), np.hstack([h @ v.X, np.zeros((k, k))])])
        before, after = block_diag(-exp(-2.0 * decay) * v.X, -v.T), block_diag(-v.X, -v.T)
        return np.block([[before, moved.T], [moved, after]])

    def input_size(v: Any) -> FloatArray:
        u = np.hstack([v.Y, v.Z if free else np.zeros((m, k))])
        return np.block([[v.size * np.eye(m), u], [u.T, block_diag(v.X, v.T)]])

    problem.below("the closed loop", discrete if time == "discrete" else continuous)
    return problem.above("the input's size", input_size, strict=False)
