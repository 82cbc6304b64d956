"""Riccati equations A0 Pi - Pi R Pi - Pi S0 + K = 0, which have several solutions or none."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations, islice

import numpy as np

from pointpred.records import FloatArray

SUBSPACES_MOST = 5000
"""At most so many invariant subspaces are tried, those of the first eigenvalues."""


def invariant_graphs(a0: FloatArray, s0: FloatArray, k: FloatArray, r: FloatArray) -> list[FloatArray]:
    """Every isolated solution if the eigenvalues of ((s0, r), (k, a0)) differ, else some of them.

    A Pi is a solution exactly if the columns of (I; Pi) span an invariant subspace.

    >>> import numpy as np
    >>> one = np.ones((1, 1))
    >>> sorted(pi.item() for pi in invariant_graphs(0 * one, 0 * one, one, one))  # Pi^2 = 1
    [-1.0, 1.0]
    """
    q = len(s0)
    whole = np.block([[s0, r], [k, a0]])
    values, vectors = np.linalg.eig(whole)
    graphs = []
    for chosen in _real_choices(values, q):
        basis = vectors[:, list(chosen)]
        if np.linalg.cond(basis[:q]) > 1e10:
            continue
        pi = basis[q:] @ np.linalg.inv(basis[:q])
        graphs.append(np.ascontiguousarray(pi.real))
    return graphs


def _real_choices(values: FloatArray, q: int) -> Iterator[tuple[int, ...]]:
    """Choices of q eigenvalues in which each complex one comes with its conjugate."""
    for chosen in islice(combinations(range(len(values)), q), SUBSPACES_MOST):
        upper = sorted((values[i].real, values[i].imag) for i in chosen if values[i].imag > 0.0)
        lower = sorted((values[i].real, -values[i].imag) for i in chosen if values[i].imag < 0.0)
        if len(upper) == len(lower) and np.allclose(upper, lower, rtol=1e-9, atol=0.0):
            yield chosen


def refined(stacked: Callable[[FloatArray], FloatArray], start: FloatArray, *, steps: int = 60) -> FloatArray:
    """The nearest point where every equality holds, by damped Gauss-Newton steps of least norm."""
    numbers, size = start, float(np.linalg.norm(stacked(start)))
    damping = 1e-3 * max(1.0, size)
    for _ in range(steps):
        unit = np.eye(len(numbers))
        jacobian = np.array([0.5 * (stacked(numbers + one) - stacked(numbers - one)) for one in unit]).T
        matrix = np.vstack([jacobian, np.sqrt(damping) * unit])
        target = np.concatenate([-stacked(numbers), np.zeros(len(numbers))])
        moved = numbers + np.linalg.lstsq(matrix, target, rcond=None)[0]
        next_size = float(np.linalg.norm(stacked(moved)))
        if next_size < size:
            numbers, size, damping = moved, next_size, damping * 0.1
        else:
            damping *= 10.0
        if size < 1e-14 or damping > 1e12:
            break
    return numbers
