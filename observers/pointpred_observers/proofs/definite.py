"""Definiteness of symmetric matrices whose rows have different units."""

from __future__ import annotations

import numpy as np

from pointpred.errors import CertificateError
from pointpred.records import FloatArray

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
