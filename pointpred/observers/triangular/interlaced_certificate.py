"""Theorem 4.4.1: a gain for the observer of an interlaced system, its certificate and the corrected bound."""

from __future__ import annotations

from math import exp, sqrt
from typing import Any

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.balance import balanced, form, inward, outward
from pointpred_observers.bounds import eigenvalues
from pointpred_observers.detectability import require_detectable
from pointpred_observers.inequalities.audit import answer_of_a_search
from pointpred_observers.inequalities.definite import solved
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.matrices import matrix
from pointpred_observers.stationary import filter_start

SMALL = 1e-3
"""Weight of the size of U, which decides among gains with the same traces."""


class InterlacedCertificate(msgspec.Struct, frozen=True):
    """P, Q, Gamma and U of the theorem with recomputed margins, L = P^-1 U, and the proved bound.

    |e(t)| <= overshoot exp(-rate t) |e(0)| + noise_gain sup|y - C w| for e = w - w_hat, with
    rate = lambda_min(P^-1 Q) / 2 in 1/s, overshoot = sqrt(lambda_max(P) / lambda_min(P)) and
    noise_gain = sqrt(lambda_max(Gamma) / (2 rate lambda_min(P))). The error of y consists of noise and the
    plant's distance from its steady state.

    The print has the first root upside down and leaves out lambda_min(Q) under the second; with lambda_min(Q)
    / lambda_max(P), which is no larger, in place of 2 rate, its bound also holds.

    ``gap``: how far the least trace of P and Gamma in balanced units could lie below that of these, relative;
    infinite if nothing is proved, as for matrices that were given.
    """

    P: Any
    Q: Any
    Gamma: Any
    U: Any
    L: Any
    margins: dict[str, float]
    rate: float
    overshoot: float
    noise_gain: float
    gap: float = np.inf

    def bound(self, t: float, start: float, noise: float) -> float:
        """The largest error of w at ``t`` s, from its ``start`` and the largest error of y, ``noise``."""
        return self.overshoot * exp(-self.rate * t) * start + self.noise_gain * noise


def theorem_4_4_1(a: ArrayLike, c: ArrayLike, **bounds: float) -> MatrixInequalities:
    """Theorem 4.4.1 as a problem in P, Q, Gamma and U, with strict inequalities; see ``check``."""
    system = matrix("A", a)
    q = len(system)
    output = matrix("C", c, None, q)
    p = len(output)

    def block(v: Any) -> FloatArray:
        corner = v.P @ system - v.U @ output
        return np.block([[corner + corner.T + v.Q, -v.U], [-v.U.T, -v.Gamma]])

    problem = MatrixInequalities("Theorem 4.4.1", **bounds).positive("P", q)
    problem.symmetric("Q", q).symmetric("Gamma", p).free("U", q, p)
    problem.above("Q", lambda v: v.Q).above("Gamma", lambda v: v.Gamma)
    return problem.below("the matrix of (4.16)", block)


def certify(
    a: ArrayLike, c: ArrayLike, *, rate: float = 0.5, gain: ArrayLike | None = None
) -> InterlacedCertificate:
    """Compute a gain with its certificate, or a certificate for ``gain``.

    Of all gains that decay at ``rate`` it takes one with the least trace of P and Gamma in balanced units,
    for little overshoot and noise, and of several the smallest U. That the plant converges to its steady
    state is assumption 4.4.2 and not checked.

    Parameters: ``a`` of the generator; ``c`` with h(rho, pi) = C w; ``rate`` in 1/s, above 0; ``gain`` L.
    Raises ParameterError, InfeasibleError (before any solver runs for an unobservable eigenvalue),
    UndecidedError and CertificateError. Reference: Khalin 2022, Theorem 4.4.1.

    >>> found = certify([[0.0, 1.0], [-1.0, 0.0]], [[1.0, 0.0]], rate=0.25)
    >>> found.L.round(2).tolist(), round(found.rate, 3), round(found.overshoot, 2)
    ([[1.0], [0.25]], 0.25, 1.28)
    """
    system = matrix("A", a)
    output = matrix("C", c, None, len(system))
    if not is_number(rate) or not 0.0 < rate < np.inf:
        raise ParameterError(
            f"rate must be a positive number of 1/s, received {rate!r}", field="rate", value=rate
        )
    require_detectable(system, output, "continuous", "(A, C)")
    units = balanced(system, seen=output, rates=(rate,))
    x, y, t = units.states, units.outputs, units.seconds
    problem = theorem_4_4_1(inward(system, x, x, t), inward(output, y, x))
    problem.above("Q - 2 rate P", lambda v: v.Q - 2.0 * rate * t * v.P)
    if gain is not None:
        fixed_gain = matrix("gain", gain, len(system), len(output))
        inner_gain = inward(fixed_gain, x, y, t)
        problem.equal("U = P L", lambda v: v.U - v.P @ inner_gain)
    problem.number("size").above(
        "size - U'U",
        lambda v: np.block([[v.size * np.eye(len(output)), v.U.T], [v.U, np.eye(len(system))]]),
        strict=False,
    )
    near = _start(inward(system, x, x, t), inward(output, y, x), rate * t) if gain is None else None
    solution = problem.solve(minimise=lambda v: np.trace(v.P) + np.trace(v.Gamma) + SMALL * v.size, near=near)
    inner = solution.values
    values = {"P": form(inner["P"], x), "Q": form(inner["Q"], x, t), "Gamma": form(inner["Gamma"], y, t)}
    values["U"] = outward(inner["U"], 1.0 / x, y, t)
    gap = np.inf if solution.gap is None else solution.gap
    with answer_of_a_search():
        return certificate(values, theorem_4_4_1(system, output).check(values), gap)


def _start(a: FloatArray, c: FloatArray, rate: float) -> dict[str, Any] | None:
    """The matrices of the stationary filter, and a Gamma that is large enough for them."""
    start = filter_start(a, c, 1.2 * rate, "continuous")
    if start is None:
        return None
    p, u = start
    corner, q = p @ a - u @ c, 2.2 * rate * p
    gamma = 2.0 * u.T @ np.linalg.pinv(-(corner + corner.T + q)) @ u + np.eye(len(c))
    size = 1.1 * float(np.linalg.norm(u, 2)) ** 2
    return {"P": p, "Q": q, "Gamma": 0.5 * (gamma + gamma.T), "U": u, "size": size}


def certificate(
    values: dict[str, Any], margins: dict[str, float], gap: float = np.inf
) -> InterlacedCertificate:
    """The bound that audited matrices prove."""
    p, gamma = eigenvalues("P", values["P"]), eigenvalues("Gamma", values["Gamma"])
    root = np.linalg.inv(np.linalg.cholesky(values["P"]))
    rate = 0.5 * float(np.linalg.eigvalsh(root @ values["Q"] @ root.T)[0])
    return InterlacedCertificate(
        **{name: values[name] for name in ("P", "Q", "Gamma", "U")},
        L=solved(values["P"], values["U"]),
        margins=margins,
        rate=rate,
        overshoot=sqrt(p[-1] / p[0]),
        noise_gain=sqrt(gamma[-1] / (2.0 * rate * p[0])),
        gap=gap,
    )
