"""Definiteness of symmetric matrices whose rows have different units, and the bounds that they prove."""

from __future__ import annotations

from collections.abc import Mapping
from math import exp, expm1, inf, log, sqrt
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import matrix, positive

LEAST_POSITIVE = 1e-13
"""Rounding of an entry, relative to its terms: a least eigenvalue must exceed it to count as positive."""


def least(matrix: FloatArray, sizes: FloatArray | None = None) -> tuple[float, float]:
    """The least eigenvalue of a symmetric matrix, and that of the matrix with rows and columns scaled.

    ``sizes`` are those of the diagonal's terms before they cancel, by default of the diagonal. Scaled, d M d
    with d = sizes^(-1/2), the matrix does not depend on the units of its rows, and by Sylvester's law it has
    as many positive eigenvalues as M. A solver of eigenvalues errs by a share of the largest one, so that
    the least eigenvalue of a positive M comes from the inverse of the scaled matrix, which is accurate.
    Infinite for a matrix without entries. Raises CertificateError for what overflowed: it proves nothing.

    >>> graded = np.array([[1e24, 5e11], [5e11, 1.0]])
    >>> [round(one, 6) for one in least(graded)]
    [0.75, 0.5]
    """
    if not matrix.size:
        return np.inf, np.inf
    diagonal = np.abs(np.diag(matrix)) if sizes is None else sizes
    if not (np.isfinite(matrix).all() and np.isfinite(diagonal).all()):
        raise CertificateError("an inequality holds numbers that are too large to compute with")
    used = diagonal > 0.0
    if not used.all():
        if np.abs(matrix[~used]).max() > 0.0:
            plain = float(np.linalg.eigvalsh(matrix)[0])
            return plain, min(-1.0, plain)
        inner = least(matrix[np.ix_(used, used)], diagonal[used]) if used.any() else (0.0, 0.0)
        return min(0.0, inner[0]), min(0.0, inner[1])
    d = 1.0 / np.sqrt(diagonal)
    if len(d) == 1:
        return float(matrix[0, 0]), float(matrix[0, 0] * d[0] ** 2)
    values, vectors = np.linalg.eigh(matrix * d * d[:, None])
    relative = float(values[0])
    if relative > LEAST_POSITIVE:
        inverse = (vectors / values) @ vectors.T * d * d[:, None]
        return 1.0 / float(np.linalg.eigvalsh(inverse)[-1]), relative
    along = d * vectors[:, 0]
    return min(float(np.linalg.eigvalsh(matrix)[0]), relative / float(along @ along)), relative


def solved(matrix: FloatArray, right: FloatArray) -> FloatArray:
    """The solution X of P X = ``right`` for a positive P whose rows have different units, by scaling them."""
    d = 1.0 / np.sqrt(np.diag(matrix))
    answer: FloatArray = d[:, None] * np.linalg.solve(matrix * d * d[:, None], right * d[:, None])
    return answer


class ErrorBound(msgspec.Struct, frozen=True):
    """abs(e(t)) <= ``overshoot`` decay(t) abs(e(0)) + sum of ``gains`` times the largest disturbances + rest.

    decay(t) = exp(-``decay`` t), ``decay`` in 1/s, or in 1/step for discrete time. ``disturbances`` names the
    disturbance of each gain. ``rest`` is what remains without any, as of a steady state that is truncated.
    """

    overshoot: float
    decay: float
    gains: tuple[float, ...]
    disturbances: tuple[str, ...]
    rest: float = 0.0

    def __call__(self, t: float, initial: float, **largest: float) -> float:
        """The bound at t for an initial error and the largest norm of each disturbance that is present.

        Raises ParameterError for a time that is not finite, for numbers below 0 and for another disturbance.
        """
        foreign = set(largest) - set(self.disturbances)
        if foreign:
            raise ParameterError(
                f"the disturbances are {', '.join(self.disturbances)}, received {', '.join(sorted(foreign))}"
            )
        t = positive("t", t, zero=True)
        for name, size in (("initial", initial), *largest.items()):
            if size != inf:
                positive(name, size, zero=True)
        forced = sum(
            gain * largest[name]
            for name, gain in zip(self.disturbances, self.gains, strict=True)
            if name in largest
        )
        return inf if initial == inf else self.overshoot * exp(-self.decay * t) * initial + forced + self.rest


def region(P: Any, J: FloatArray, domain: float, reach: FloatArray) -> tuple[float, float]:
    """The region of validity where abs(J w) stays within ``reach`` (rows of J) on the true trajectory.

    Returns the level c of the ellipsoid e'Pe <= c that keeps abs(J (w + e)) within ``domain``, and the
    radius of the largest ball in it; both infinite if the domain is. Raises CertificateError if the
    trajectory itself leaves the domain, ParameterError for a ``reach`` that is no bound.

    >>> region(np.diag([4.0, 1.0]), np.array([[1.0, 0.0]]), 2.0, np.array([0.5]))  # abs(e[0]) <= 1.5
    (9.0, 1.5)
    """
    for one in reach.tolist():
        positive("reach", one, zero=True)
    p, moved = np.asarray(P, np.float64), J.any(axis=1)
    if np.isinf(domain) or not moved.any():
        return np.inf, np.inf
    j, room = J[moved], domain - reach[moved]
    if (room <= 0.0).any():
        raise CertificateError(
            f"the trajectory reaches {reach[moved].max():g}, the slopes hold within {domain:g} only"
        )
    level = float((room**2 / np.einsum("ij,jk,ik->i", j, np.linalg.inv(p), j)).min())
    return level, sqrt(level / float(np.linalg.eigvalsh(p).max()))


def eigenvalues(name: str, value: Any) -> FloatArray:
    """The eigenvalues of a matrix that must be positive; raises CertificateError naming the least."""
    square = matrix(name, value)
    if not square.size or square.shape[0] != square.shape[1]:
        raise ParameterError(f"{name} must be a square matrix, received {value!r}", field=name, value=value)
    half: FloatArray = 0.5 * (square + square.T)
    values: FloatArray = np.asarray(np.linalg.eigvalsh(half), np.float64)
    # Accurate beside a largest one of any size, as in units of different sizes.
    values[0] = least(half)[0]
    if values[0] <= 0.0:
        raise CertificateError(f"{name} has the eigenvalue {values[0]:.6g}, must lie above 0")
    return values


def proved_bound(P: Any, decay: float, drives: Mapping[str, float], time: str = "continuous") -> ErrorBound:
    """The bound of an error whose V = e'Pe obeys V' <= -2 decay V + sum of drives abs(disturbance)^2.

    In discrete time V+ <= exp(-2 decay) V plus the same sum. Raises CertificateError without a decay.

    >>> proved_bound([[1.0]], 1.0, {"eps": 8.0})(1.0, 1.0, eps=0.5)  # exp(-1) + 2 * 0.5
    1.3678794411714423
    >>> proved_bound([[1.0]], log(2.0), {"delta": 3.0}, "discrete")(2.0, 1.0, delta=0.5)  # 1/4 + 2 * 0.5
    1.25
    """
    p = eigenvalues("P", P)
    share = decay_share(decay, time) * p[0]
    if share <= 0.0:
        raise CertificateError(
            f"the matrices prove no decay beyond rounding: it is {decay:.3g}", field="decay"
        )
    gains = tuple(sqrt(one / share) for one in drives.values())
    return ErrorBound(sqrt(p[-1] / p[0]), decay, gains, tuple(drives))


def decay_share(decay: float, time: str) -> float:
    """The share of V that is lost in a unit of time at this decay of the error."""
    return -expm1(-2.0 * decay) if time == "discrete" else 2.0 * decay


def decay_of(P: Any, Xi: Any, time: str) -> float:
    """The decay of V' <= -e'Xi e, in discrete time V+ <= V - e'Xi e: of the largest c with Xi >= c P."""
    c = least_ratio(P, Xi)
    return -0.5 * log(max(1.0 - c, 1e-300)) if time == "discrete" else 0.5 * c


def least_ratio(P: Any, Xi: Any) -> float:
    """The largest c with Xi >= c P: the least generalised eigenvalue of (Xi, P).

    >>> least_ratio([[1.0, 0.0], [0.0, 4.0]], [[3.0, 0.0], [0.0, 8.0]])
    2.0
    """
    p, xi = (np.atleast_2d(np.asarray(one, np.float64)) for one in (P, Xi))
    with np.errstate(all="ignore"):  # what overflows is not finite, and refused
        # Only the symmetric part is a form, and eigenvalues are computed from the lower triangle alone.
        root = np.linalg.inv(np.linalg.cholesky(0.5 * (p + p.T)))
        inner = root @ (0.5 * (xi + xi.T)) @ root.T
    if not np.isfinite(inner).all():
        raise CertificateError("Xi beside P holds numbers that are too large to compute with")
    return float(np.linalg.eigvalsh(inner)[0])
