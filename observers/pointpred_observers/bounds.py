"""Bounds of the error that certificates prove, corrected where the print lacks a factor."""

from __future__ import annotations

from math import exp, inf, log, sqrt
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.inequalities.definite import least
from pointpred_observers.matrices import TIMES, matrix, one_of, positive


class ErrorBound(msgspec.Struct, frozen=True):
    """abs(e(t)) <= ``overshoot`` decay(t) abs(e(0)) + sum of ``gains`` times the largest disturbances + rest.

    decay(t) = exp(-``rate`` t); ``rate`` in 1/s, or in 1/step for discrete time. ``disturbances`` names the
    disturbance of each gain. ``rest`` is what remains without any, as of a steady state that is truncated.
    """

    overshoot: float
    rate: float
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
        return inf if initial == inf else self.overshoot * exp(-self.rate * t) * initial + forced + self.rest


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


def interconnection_bound(
    P: Any,
    Theta: Any,
    Gamma: Any,
    Xi: Any,
    *,
    time: str = "continuous",
    sharp: bool = False,
    G: Any = None,
) -> ErrorBound:
    """The bound of Theorem 3.2.1 for v, noise of Y, eps, the distance of the outputs from their model, and w.

    Y disturbs the error twice: through G of the generator as v, and through M as v~ = v + eps. With c = min
    Theta / max P (eigenvalues): V' <= -c V + max Gamma (abs(v)^2 + abs(v~)^2) + max Xi abs(w)^2, so that
    abs(e) <= sqrt(max P / min P) exp(-c t / 2) abs(e0) + sqrt(max Gamma / (c min P)) (sqrt(2) abs(v) +
    abs(eps)) + sqrt(max Xi / (c min P)) abs(w), without sqrt(2) if G = 0.

    Parameters: ``G`` (q, p) of the generator, by default any; ``sharp`` takes the least generalised
    eigenvalue of (Theta, P) for c, which is never smaller. In discrete time the decay of V is 1 - c each
    step.

    >>> interconnection_bound([[1.0]], [[2.0]], [[8.0]], [[2.0]])(1.0, 1.0, eps=0.5)  # exp(-1) + 2 * 0.5
    1.3678794411714423
    >>> interconnection_bound([[1.0]], [[2.0]], [[8.0]], [[2.0]], G=[[0.0]]).gains
    (2.0, 2.0, 1.0)
    """
    one_of("time", time, TIMES)
    p, theta = eigenvalues("P", P), eigenvalues("Theta", Theta)
    gamma, xi = eigenvalues("Gamma", Gamma), eigenvalues("Xi", Xi)
    c = float(theta[0] / p[-1])
    if sharp:
        c = max(c, least_ratio(P, Theta))
    speed = -log(max(1.0 - c, 1e-300)) if time == "discrete" else c
    once, drive = sqrt(gamma[-1] / (c * p[0])), sqrt(xi[-1] / (c * p[0]))
    twice = once if G is not None and not matrix("G", G).any() else sqrt(2.0) * once
    return ErrorBound(sqrt(p[-1] / p[0]), 0.5 * speed, (twice, once, drive), ("v", "eps", "w"))


def convergence_bound(P: Any, Xi: Any, gamma: float) -> ErrorBound:
    """The bound of Theorem 3.3.1 with the factor sqrt(max P / min Xi) that the print lacks, for delta.

    V' <= -e' Xi e + delta' P delta / gamma gives abs(e) <= sqrt(max P / min P) (exp(-min Xi / (2 max P) t)
    abs(e0) + sqrt(max P / min Xi) abs(delta) / sqrt(gamma)).

    >>> convergence_bound([[4.0]], [[1.0]], 1.0)(0.0, 0.0, delta=1.0)
    2.0
    """
    p, xi, gamma = eigenvalues("P", P), eigenvalues("Xi", Xi), positive("gamma", gamma)
    overshoot = sqrt(p[-1] / p[0])
    return ErrorBound(
        overshoot, float(0.5 * xi[0] / p[-1]), (overshoot * sqrt(p[-1] / xi[0] / gamma),), ("delta",)
    )


def continuous_bound(P: Any, Xi: Any, gamma: float) -> ErrorBound:
    """The bound of Theorem 3.3.1 with the least generalised eigenvalue c of (Xi, P): never larger.

    V' <= -c V + delta'P delta / gamma, so that abs(e) <= sqrt(max P / min P) (exp(-c t / 2) abs(e0) +
    abs(delta) / sqrt(c gamma)).

    >>> continuous_bound([[4.0]], [[1.0]], 1.0)(0.0, 0.0, delta=1.0)
    2.0
    """
    p, c = eigenvalues("P", P), least_ratio(P, Xi)
    overshoot = sqrt(p[-1] / p[0])
    return ErrorBound(overshoot, 0.5 * c, (overshoot / sqrt(c * gamma),), ("delta",))


def discrete_bound(P: Any, Xi: Any, Gamma: Any, *, sharp: bool = False) -> ErrorBound:
    """The bound that Theorem 3.3.2 implies and the print leaves out, for delta; the rate is per step.

    V(k+1) <= (1 - c) V(k) + max Gamma abs(delta)^2 with c = min Xi / max P, so that abs(e) <= sqrt(max
    P / min P) (1 - c)^(k/2) abs(e0) + sqrt(max Gamma / (c min P)) abs(delta). ``sharp`` takes the
    least generalised eigenvalue of (Xi, P) for c, which is never smaller.

    >>> discrete_bound([[1.0]], [[0.75]], [[3.0]])(2.0, 1.0, delta=0.5)  # 1/4 + 2 * 0.5
    1.25
    """
    p, xi, gamma = eigenvalues("P", P), eigenvalues("Xi", Xi), eigenvalues("Gamma", Gamma)
    c = least_ratio(P, Xi) if sharp else float(xi[0] / p[-1])
    rate = -0.5 * log(max(1.0 - c, 1e-300))
    return ErrorBound(sqrt(p[-1] / p[0]), rate, (sqrt(gamma[-1] / (c * p[0])),), ("delta",))


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
