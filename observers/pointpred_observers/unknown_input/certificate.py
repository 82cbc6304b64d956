"""Theorem 1 of the camera paper as a certificate, also in discrete time, every eigenvalue recomputed."""

from __future__ import annotations

from math import exp, expm1, inf, log, sqrt

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import CertificateError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import positive
from pointpred_observers.proofs.bounds import ErrorBound
from pointpred_observers.proofs.definite import LEAST_POSITIVE, least


class UnknownInputCertificate(msgspec.Struct, frozen=True, eq=False):
    """The matrices that prove the decay of an observer's error.

    |e(t)| <= phi1 |e(0)| exp(-decay t) + phi2 sup |delta|, delta = (A(p) - A(p_hat)) x, as long as the
    scheduling variables stay in the box; decay is sigma / 2 of the theorem. ``margin``: how far the largest
    eigenvalue of (27c) lies below 0. In discrete time t counts steps.
    """

    decay: float
    """The proved rate, 1/s (1/step)."""
    p: FloatArray
    force: FloatArray
    """F of the theorem, n x n; gamma is its largest eigenvalue."""
    margin: float
    zeros: NDArray[np.complex128]
    """Invariant zeros, 1/s (factors in discrete time), one row per vertex."""
    gap: float = np.inf
    """How far the least gamma + 0.01 trace P in balanced units could lie below that of the design, relative;
    infinite if nothing is proved."""
    time: str = "continuous"

    @property
    def gamma(self) -> float:
        """The bound of F, F <= gamma I."""
        return float(np.linalg.eigvalsh(self.force)[-1])

    @property
    def phi1(self) -> float:
        """sqrt(chi2 / chi1), chi the extreme eigenvalues of P."""
        return sqrt(float(np.linalg.eigvalsh(self.p)[-1]) / least(self.p)[0])

    @property
    def phi2(self) -> float:
        """sqrt(gamma / (2 decay chi1)), s; in discrete time with 1 - exp(-2 decay) for 2 decay."""
        lost = -expm1(-2.0 * self.decay) if self.time == "discrete" else 2.0 * self.decay
        return sqrt(self.gamma / (lost * least(self.p)[0]))

    @property
    def largest_decay(self) -> float:
        """The bound on the decay of any design in this box, 1/s (1/step); infinite without zeros."""
        return largest_decay(self.zeros, self.time)

    @property
    def bound(self) -> ErrorBound:
        """The proved bound of |e|, disturbed by ``delta``."""
        return ErrorBound(self.phi1, self.decay, (self.phi2,), ("delta",))


def largest_decay(zeros: NDArray[np.complex128], time: str = "continuous") -> float:
    """-max Re s over all zeros, in discrete time -log max abs(s): every feasible decay lies below it.

    >>> largest_decay(np.array([[-0.5 + 1j, -0.25], [-2.0, -1.0]]))
    0.25
    >>> round(largest_decay(np.array([[0.5, -0.1]]), "discrete"), 6)  # log 2
    0.693147
    """
    if not zeros.size:
        return inf
    if time == "continuous":
        return float(-zeros.real.max())
    largest = float(np.abs(zeros).max())
    return -log(largest) if largest > 0.0 else inf


def inequality(
    n_i: FloatArray,
    t_i: FloatArray,
    p: FloatArray,
    force: FloatArray,
    decay: float,
    time: str = "continuous",
    sign: float = -1.0,
) -> FloatArray:
    """The matrix of (27c) at one vertex with W = P K and N = Gamma - K C: below 0 it is a proof.

    That is with - W C: the print has + W C, which contradicts N = Gamma - K C of (44). In discrete time,
    which the paper does not have, it is V(e+) - exp(-2 decay) V(e) - delta'F delta with e+ = N e + T delta,
    N = T A - K C. With ``sign`` 1 and absolute values it is the size of each entry's terms.
    """
    n = len(p)
    if time == "discrete":
        onward = np.hstack([n_i, t_i])
        whole: FloatArray = onward.T @ p @ onward
        whole[:n, :n] += sign * exp(-2.0 * decay) * p
    else:
        half, side = p @ n_i, p @ t_i
        whole = np.block([[half + half.T + 2.0 * decay * p, side], [side.T, np.zeros_like(force)]])
    whole[n:, n:] += sign * force
    return whole


def audit(
    gammas: FloatArray,
    ts: FloatArray,
    c: FloatArray,
    p: FloatArray,
    ks: FloatArray,
    force: FloatArray,
    decay: float,
    zeros: NDArray[np.complex128],
    time: str = "continuous",
) -> UnknownInputCertificate:
    """Recompute every eigenvalue of Theorem 1, or of its discrete counterpart.

    Raises CertificateError naming the one that fails.

    ``gammas``, ``ts`` and the gains ``ks`` hold one matrix per vertex, ``force`` is F of the theorem. The
    gains that run are the ones that are proved. Multiplying P and F by one positive number does not change
    the result.
    """
    positive("decay", decay)
    for name, matrix in (("P", p), ("F", force)):
        # To the last bit, in any unit: eigenvalues are computed from the lower triangle alone.
        if not np.array_equal(matrix, matrix.T):
            raise CertificateError(
                f"{name} must be symmetric and positive definite, it differs from its transpose by "
                f"{np.abs(matrix - matrix.T).max():.3g}",
                field=name,
            )
        lowest = least(matrix)[0]
        if not lowest > 0.0:
            raise CertificateError(
                f"{name} must be symmetric and positive definite, its least eigenvalue is {lowest:.6g}",
                field=name,
            )
    largest, at = -np.inf, 0
    for vertex, (gamma_i, t_i, k_i) in enumerate(zip(gammas, ts, ks, strict=True)):
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            whole = -inequality(gamma_i - k_i @ c, t_i, p, force, decay, time)
            moved = np.abs(gamma_i) + np.abs(k_i) @ np.abs(c)
            terms = inequality(moved, np.abs(t_i), np.abs(p), np.abs(force), decay, time, 1.0)
        if not (np.isfinite(whole).all() and np.isfinite(terms).all()):
            raise CertificateError(
                f"(27c) holds numbers that are too large to compute with at vertex {vertex}: check the "
                "largest entries of the gains, of P and of F"
            )
        sizes = np.diag(terms)
        value, relative = least(whole, sizes)
        # What rounding of the terms could make of it does not count as negative. Entries off the diagonal
        # may be small differences of larger terms: those of a lightly damped pair are.
        d = 1.0 / np.sqrt(sizes)
        spread = float(np.linalg.norm(terms * d * d[:, None], 2))
        eigenvalue = -value if relative > LEAST_POSITIVE * spread else max(-value, 0.0)
        if not eigenvalue <= largest:
            largest, at = eigenvalue, vertex
    if not largest < 0.0:
        raise CertificateError(f"(27c) has the eigenvalue {largest:.6g} at vertex {at}, must lie below 0")
    return UnknownInputCertificate(decay, p, force, -largest, zeros, time=time)
