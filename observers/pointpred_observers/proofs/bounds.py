"""Bounds of the error that certificates prove."""

from __future__ import annotations

from collections.abc import Mapping
from math import exp, expm1, inf, log, sqrt
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import matrix, positive
from pointpred_observers.proofs.definite import least


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

    In discrete time V+ <= exp(-2 decay) V plus the same sum.

    >>> proved_bound([[1.0]], 1.0, {"eps": 8.0})(1.0, 1.0, eps=0.5)  # exp(-1) + 2 * 0.5
    1.3678794411714423
    >>> proved_bound([[1.0]], log(2.0), {"delta": 3.0}, "discrete")(2.0, 1.0, delta=0.5)  # 1/4 + 2 * 0.5
    1.25
    """
    p = eigenvalues("P", P)
    gains = tuple(sqrt(one / (decay_share(decay, time) * p[0])) for one in drives.values())
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
