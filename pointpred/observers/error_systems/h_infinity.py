"""The H-infinity norm of a linear system, by the imaginary eigenvalues of a Hamiltonian matrix."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray

TOLERANCE = 1e-10
"""Relative error of the norm."""
STEPS_MOST = 60


def h_infinity(a: FloatArray, b: FloatArray, c: FloatArray, time: str = "continuous") -> tuple[float, float]:
    """The H-infinity norm of C (s I - A)^-1 B and the frequency in rad/s (rad/step) where it is reached.

    Assumes that A is stable. A level above the norm leaves no imaginary eigenvalues; below it, the midpoints
    between them are frequencies at which the gain is larger. In discrete time z = (1 + s) / (1 - s) keeps the
    norm.

    Reference: Bruinsma and Steinbuch 1990, A fast algorithm to compute the H-infinity norm.

    >>> norm, frequency = h_infinity(np.array([[-2.0]]), np.eye(1), np.eye(1))
    >>> round(norm, 9), frequency
    (0.5, 0.0)
    """
    d = np.zeros((len(c), b.shape[1]))
    if time == "discrete":
        inverse = np.linalg.inv(np.eye(len(a)) + a)
        a, b, c, d = (
            inverse @ (a - np.eye(len(a))),
            np.sqrt(2.0) * inverse @ b,
            np.sqrt(2.0) * c @ inverse,
            -c @ inverse @ b,
        )
    level, at = _first(a, b, c, d)
    for _ in range(STEPS_MOST):
        crossings = _crossings(a, b, c, d, (1.0 + TOLERANCE) * level)
        if not len(crossings):
            break
        between = [0.5 * crossings[0], *np.sqrt(crossings[:-1] * crossings[1:]), 2.0 * crossings[-1]]
        tried = [(_gain(a, b, c, d, w), float(w)) for w in between]
        best = max(tried)
        if best[0] <= level:
            break
        level, at = best
    return level, 2.0 * float(np.arctan(at)) if time == "discrete" else at


def _first(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray) -> tuple[float, float]:
    """The largest gain at rest, at infinity and near each eigenvalue."""
    values = np.linalg.eigvals(a)
    frequencies = [0.0, *np.abs(values), *np.abs(values.imag)]
    tried = [(_gain(a, b, c, d, w), float(w)) for w in frequencies]
    return max([*tried, (float(np.linalg.norm(d, 2)), np.inf)], key=lambda one: one[0])


def _gain(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray, frequency: float) -> float:
    inside = np.linalg.solve(1j * frequency * np.eye(len(a)) - a, b)
    return float(np.linalg.norm(c @ inside + d, 2))


def _crossings(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray, level: float) -> FloatArray:
    """The frequencies above 0 at which a singular value equals the level, in order."""
    if level == 0.0:
        return np.zeros(0)
    r = level**2 * np.eye(d.shape[1]) - d.T @ d
    if np.linalg.eigvalsh(r)[0] <= 0.0:
        return np.zeros(0)
    s = np.linalg.solve(r, np.hstack([d.T @ c, b.T]))
    n = len(a)
    inner = a + b @ s[:, :n]
    across = b @ s[:, n:]
    down = -c.T @ c - c.T @ d @ s[:, :n]
    values = np.linalg.eigvals(np.block([[inner, across], [down, -inner.T]]))
    size = float(np.abs(values).max(initial=1.0))
    on_axis = np.abs(values.real) <= 1e-8 * np.maximum(np.abs(values), 1e-4 * size)
    return np.asarray(np.sort(values.imag[on_axis & (values.imag > 0.0)]), np.float64)
