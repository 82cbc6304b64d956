"""Theorem 1 of the camera paper as a certificate, also in discrete time, every eigenvalue recomputed."""

from __future__ import annotations

from math import exp, expm1, inf, log, sqrt

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.inequalities.definite import ROUNDING, least


class UnknownInputCertificate(msgspec.Struct, frozen=True):
    """The matrices that prove the decay of an observer's error.

    |e(t)| <= phi1 |e(0)| exp(-sigma t / 2) + phi2 sup |delta|, delta = (A(p) - A(p_hat)) x, as long as the
    scheduling variables stay in the box. ``margin``: how far the largest eigenvalue of (27c) lies below 0. In
    discrete time t counts steps.
    """

    sigma: float
    """Twice the proved rate, 1/s (1/step)."""
    p: FloatArray
    gamma: float
    margin: float
    zeros: NDArray[np.complex128]
    """Invariant zeros, 1/s (factors in discrete time), one row per vertex."""
    gap: float = np.inf
    """How far the least gamma + 0.01 trace P in balanced units could lie below that of the design, relative;
    infinite if nothing is proved."""
    time: str = "continuous"
    force: FloatArray | None = None
    """F of the theorem, n x n."""

    @property
    def phi1(self) -> float:
        """sqrt(chi2 / chi1), chi the extreme eigenvalues of P."""
        return sqrt(float(np.linalg.eigvalsh(self.p)[-1]) / least(self.p)[0])

    @property
    def phi2(self) -> float:
        """sqrt(gamma / (sigma chi1)), s; in discrete time with 1 - exp(-sigma) for sigma."""
        lost = -expm1(-self.sigma) if self.time == "discrete" else self.sigma
        return sqrt(self.gamma / (lost * least(self.p)[0]))

    @property
    def largest_sigma(self) -> float:
        """The bound on sigma for any design in this box, 1/s (1/step); infinite without zeros."""
        return largest_sigma(self.zeros, self.time)

    def bound(self, t: float, error: float, disturbance: float = 0.0) -> float:
        """The proved bound of |e| at ``t`` s after an error of size ``error``."""
        return self.phi1 * error * exp(-0.5 * self.sigma * t) + self.phi2 * disturbance


def largest_sigma(zeros: NDArray[np.complex128], time: str = "continuous") -> float:
    """-2 max Re s over all zeros, in discrete time -2 log max abs(s): every feasible sigma lies below it.

    >>> largest_sigma(np.array([[-0.5 + 1j, -0.25], [-2.0, -1.0]]))
    0.5
    >>> round(largest_sigma(np.array([[0.5, -0.1]]), "discrete"), 6)  # 2 log 2
    1.386294
    """
    if not zeros.size:
        return inf
    if time == "continuous":
        return float(-2.0 * zeros.real.max())
    largest = float(np.abs(zeros).max())
    return -2.0 * log(largest) if largest > 0.0 else inf


def inequality(
    gamma_i: FloatArray,
    t_i: FloatArray,
    c: FloatArray,
    p: FloatArray,
    w_i: FloatArray,
    force: FloatArray,
    sigma: float,
) -> FloatArray:
    """The matrix of (27c) at one vertex, with - W C: with K = P^-1 W and N = Gamma - K C it is the rate of V.

    The print has + W C, which contradicts N = Gamma - K C of (44).
    """
    corner = gamma_i.T @ p + p @ gamma_i - w_i @ c - c.T @ w_i.T + sigma * p
    return np.block([[corner, p @ t_i], [t_i.T @ p, -force]])


def _terms(
    gamma_i: FloatArray,
    t_i: FloatArray,
    c: FloatArray,
    p: FloatArray,
    k_i: FloatArray,
    force: FloatArray,
    sigma: float,
) -> FloatArray:
    """The size of each entry of (27c) with W = P K, summed over its terms before they cancel."""
    half = np.abs(p) @ (np.abs(gamma_i) + np.abs(k_i) @ np.abs(c))
    side = np.abs(p) @ np.abs(t_i)
    return np.block([[half + half.T + sigma * np.abs(p), side], [side.T, np.abs(force)]])


def discrete_inequality(
    n_i: FloatArray, t_i: FloatArray, p: FloatArray, force: FloatArray, sigma: float
) -> FloatArray:
    """V(e+) - exp(-sigma) V(e) - delta'F delta at one vertex, e+ = N e + T delta: below 0 it is a proof.

    The discrete counterpart of (27c), which the paper does not have; N = T A - K C.
    """
    onward = np.hstack([n_i, t_i])
    whole: FloatArray = onward.T @ p @ onward
    n = len(p)
    whole[:n, :n] -= exp(-sigma) * p
    whole[n:, n:] -= force
    return whole


def _discrete_terms(
    gamma_i: FloatArray,
    t_i: FloatArray,
    c: FloatArray,
    p: FloatArray,
    k_i: FloatArray,
    force: FloatArray,
    sigma: float,
) -> FloatArray:
    """The same for the discrete inequality."""
    onward = np.hstack([np.abs(gamma_i) + np.abs(k_i) @ np.abs(c), np.abs(t_i)])
    whole: FloatArray = onward.T @ np.abs(p) @ onward
    n = len(p)
    whole[:n, :n] += exp(-sigma) * np.abs(p)
    whole[n:, n:] += np.abs(force)
    return whole


def audit(
    gammas: FloatArray,
    ts: FloatArray,
    c: FloatArray,
    p: FloatArray,
    ks: FloatArray,
    force: FloatArray,
    sigma: float,
    zeros: NDArray[np.complex128],
    time: str = "continuous",
) -> UnknownInputCertificate:
    """Recompute every eigenvalue of Theorem 1, or of its discrete counterpart.

    Raises CertificateError naming the one that fails.

    ``gammas``, ``ts`` and the gains ``ks`` hold one matrix per vertex, ``force`` is F of the theorem; gamma
    is its largest eigenvalue. W = P K is computed: the gains that run are the ones that are proved.
    Multiplying P and F by one positive number does not change the result.
    """
    if not (sigma > 0.0 and np.isfinite(sigma)):
        raise ParameterError(
            f"sigma must be positive and finite, received {sigma!r}", field="sigma", value=sigma
        )
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
    with np.errstate(all="ignore"):  # what overflows is not finite, and refused
        largest, vertex = _largest(gammas, ts, c, p, ks, force, sigma, time)
    if not largest < 0.0:
        raise CertificateError(f"(27c) has the eigenvalue {largest:.6g} at vertex {vertex}, must lie below 0")
    gamma = float(np.linalg.eigvalsh(force)[-1])
    return UnknownInputCertificate(sigma, p, gamma, -largest, zeros, time=time, force=force)


def _largest(
    gammas: FloatArray,
    ts: FloatArray,
    c: FloatArray,
    p: FloatArray,
    ks: FloatArray,
    force: FloatArray,
    sigma: float,
    time: str,
) -> tuple[float, int]:
    """The largest eigenvalue of the inequality over the vertices, and its vertex."""
    largest, vertex = -np.inf, 0
    for i, (gamma_i, t_i, k_i) in enumerate(zip(gammas, ts, ks, strict=True)):
        if time == "discrete":
            whole = -discrete_inequality(gamma_i - k_i @ c, t_i, p, force, sigma)
            terms = _discrete_terms(gamma_i, t_i, c, p, k_i, force, sigma)
        else:
            whole = -inequality(gamma_i, t_i, c, p, p @ k_i, force, sigma)
            terms = _terms(gamma_i, t_i, c, p, k_i, force, sigma)
        if not (np.isfinite(whole).all() and np.isfinite(terms).all()):
            raise CertificateError(
                f"(27c) holds numbers that are too large to compute with at vertex {i}: check the largest "
                "entries of the gains, of P and of F"
            )
        sizes = np.diag(terms)
        value, relative = least(whole, sizes)
        # What rounding of the terms could make of it does not count as negative. Entries off the diagonal
        # may be small differences of larger terms: those of a lightly damped pair are.
        d = 1.0 / np.sqrt(sizes)
        spread = float(np.linalg.norm(terms * d * d[:, None], 2))
        eigenvalue = -value if relative > ROUNDING * spread else max(-value, 0.0)
        if not eigenvalue <= largest:
            largest, vertex = eigenvalue, i
    return largest, vertex
