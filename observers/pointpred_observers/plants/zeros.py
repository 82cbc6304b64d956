"""Invariant zeros: the modes that no unknown input observer can change."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import balanced, inward
from pointpred_observers.numerics.equalities import cleared, or_one

RELATIVE = 1e-9
"""Singular values below this share of the largest count as zero."""


def kernel(matrix: FloatArray, size: float | None = None) -> FloatArray:
    """An orthonormal basis of the null space, a vector a column; ``size`` in place of the largest value."""
    _, sizes, rows = np.linalg.svd(np.atleast_2d(matrix))
    rank = int((sizes > RELATIVE * (sizes.max(initial=0.0) if size is None else size)).sum())
    basis: FloatArray = rows[rank:].T
    return basis


def independent(c: FloatArray) -> tuple[FloatArray, FloatArray]:
    """R and C' with C = R C', R'R = I and independent rows in C'; R is the identity if C has such rows."""
    left, sizes, right = np.linalg.svd(c, full_matrices=False)
    rank = int((sizes > RELATIVE * sizes.max(initial=0.0)).sum())
    if rank == len(c):
        return np.eye(rank), c
    return np.asarray(left[:, :rank], np.float64), np.asarray(sizes[:rank, None] * right[:rank], np.float64)


def unobservable(gamma: FloatArray, c: FloatArray) -> FloatArray:
    """An orthonormal basis of the largest subspace inside ker C that Gamma maps into itself."""
    basis, size = kernel(c), float(np.linalg.norm(gamma, 2))
    while basis.shape[1]:
        moved = gamma @ basis
        leaving = moved - basis @ (basis.T @ moved)
        staying = kernel(leaving, size)
        if staying.shape[1] == basis.shape[1]:
            break
        basis = basis @ staying
    return basis


def fixed_modes(gamma: FloatArray, c: FloatArray) -> NDArray[np.complex128]:
    """The eigenvalues of Gamma that Gamma - K C keeps for every K, complex, the slowest first."""
    units = balanced(gamma, seen=c)
    gamma = inward(gamma, units.states, units.states)
    basis = unobservable(gamma, inward(c, units.outputs, units.states))
    if not basis.shape[1]:
        return np.zeros(0, dtype=np.complex128)
    zeros: NDArray[np.complex128] = np.linalg.eigvals(basis.T @ gamma @ basis).astype(np.complex128)
    return zeros[np.argsort(-zeros.real, kind="stable")]


def _rank(entries: FloatArray, sizes: FloatArray) -> int:
    """The rank in any units; ``sizes`` are those of the terms of each entry."""
    rows = or_one(sizes.max(axis=1, initial=0.0))
    columns = or_one((sizes / rows[:, None]).max(axis=0, initial=0.0))
    return int(np.linalg.matrix_rank(entries / rows[:, None] / columns, tol=RELATIVE))


def decoupling(f: FloatArray, c: FloatArray) -> FloatArray:
    """T = I - F (C F)^+ C, with T F = 0; raises ParameterError naming the ranks if there is none."""
    if f.ndim != 2 or c.ndim != 2 or f.shape[0] != c.shape[1]:
        raise ParameterError(f"C F must exist: F has shape {f.shape}, C has shape {c.shape}")
    if not f.shape[1]:
        raise ParameterError("F needs a column for each unknown input, received none")
    cf = c @ f
    rank_cf, rank = _rank(cf, np.abs(c) @ np.abs(f)), _rank(f, np.abs(f))
    if rank < f.shape[1]:
        raise ParameterError(f"F must have full column rank {f.shape[1]}, its rank is {rank}")
    if rank_cf < rank:
        raise ParameterError(
            f"rank(C F) must equal rank(F): rank(C F) = {rank_cf} < rank(F) = {rank}, "
            "so an unknown input does not reach the outputs directly"
        )
    return cleared((np.eye(len(f)),), (-(f @ np.linalg.pinv(cf)), c))
