"""A first P, gain and W from one equation of Riccati or Lyapunov: where the search for a design may begin.

Nothing is proved here; what a search makes of it is audited like any other matrices.
"""

from __future__ import annotations

import warnings

import numpy as np

from pointpred.records import FloatArray


def filter_start(
    a: FloatArray, c: FloatArray, decay: float, time: str
) -> tuple[FloatArray, FloatArray] | None:
    """P >= I and U = P L of the stationary Kalman filter of e' = a e, y = c e, made to decay at ``decay``.

    The covariance of its noises is the unit matrix; the filter is that of a + ``decay`` I, or of
    exp(``decay``) a in discrete time. ``None`` where the equation has no solution or its solver fails.

    Reference: Anderson, Moore 1971, section 4.1, for the rate.
    """
    from scipy.linalg import solve_continuous_are, solve_discrete_are

    one, noise = np.eye(len(a)), np.eye(len(c))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what is ill-conditioned is audited later
        try:
            if time == "discrete":
                faster = np.exp(decay) * a
                x = solve_discrete_are(faster.T, c.T, one, noise)
                gain = np.exp(-decay) * faster @ x @ c.T @ np.linalg.inv(c @ x @ c.T + noise)
            else:
                x = solve_continuous_are((a + decay * one).T, c.T, one, noise)
                gain = x @ c.T
            p = normal(np.linalg.inv(x))
        except (np.linalg.LinAlgError, ValueError):
            return None
    return None if p is None else (p, p @ gain)


def decay_start(a: FloatArray, decay: float, time: str) -> FloatArray | None:
    """P >= I with which e' = a e decays at ``decay``; ``None`` where there is none."""
    from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

    one = np.eye(len(a))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what is ill-conditioned is audited later
        try:
            if time == "discrete":
                return normal(solve_discrete_lyapunov(np.exp(decay) * a.T, one))
            p = solve_continuous_lyapunov((a + decay * one).T, -one)
            return normal(np.asarray(p, np.float64))
        except (np.linalg.LinAlgError, ValueError):
            return None


def normal(p: FloatArray) -> FloatArray | None:
    """A matrix divided by its least eigenvalue; ``None`` unless that is positive."""
    symmetric: FloatArray = 0.5 * (p + p.T)
    least = float(np.linalg.eigvalsh(symmetric)[0]) if np.isfinite(symmetric).all() else -1.0
    return symmetric / least if least > 0.0 else None


def middle(slopes: tuple[tuple[float, float], ...] | None) -> FloatArray:
    """The middle of the slopes as a diagonal matrix."""
    return np.diag([0.5 * (low + high) for low, high in slopes or ()])


def cover(
    weight: FloatArray, inner: FloatArray, slopes: tuple[tuple[float, float], ...] | None
) -> FloatArray:
    """A W >= sym(F D J) for every D within the slopes, F the ``weight`` and J the ``inner`` matrix.

    The sum over the components of middle slope times M plus half the spread times abs(M), M = sym(F_i J_i).
    """
    whole: FloatArray = np.zeros((len(weight), len(weight)))
    for i, (low, high) in enumerate(slopes or ()):
        one = np.outer(weight[:, i], inner[i])
        values, vectors = np.linalg.eigh(0.5 * (one + one.T))
        sizes = 0.5 * (low + high) * values + 0.5 * (high - low) * np.abs(values)
        whole = whole + (vectors * sizes) @ vectors.T
    return 0.5 * (whole + whole.T)
