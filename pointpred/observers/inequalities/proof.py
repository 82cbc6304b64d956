"""What a solver's multipliers prove, recomputed: that nothing satisfies the inequalities, or a least objective.

Weak duality: for Z_i >= 0 and numbers x that satisfy every inequality, sum <Z_i, F_i(x)> <= 0. The sum is affine
in x. Its slopes should vanish, and they do up to rounding; what is left over is bounded for the numbers up to a
``reach``, so that a proof says for which numbers it holds.
"""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.observers.inequalities.affine import Affine

ENTIRE = 1e12
"""A proof up to this condition number of P, in balanced units, counts as one for every choice."""


class Multipliers(msgspec.Struct, frozen=True):
    """One positive semidefinite matrix for each block: ``strict``, ``floors`` (I - P) and ``caps`` (P - kappa I)."""

    strict: list[FloatArray]
    floors: list[FloatArray]
    caps: list[FloatArray]


def multipliers(strict: list[Any], floors: list[Any], caps: list[Any]) -> Multipliers | None:
    """The solver's, made positive semidefinite; ``None`` where it has none."""
    if any(one is None or not np.isfinite(one).all() for one in [*strict, *floors, *caps]):
        return None
    return Multipliers(
        [_positive(one) for one in strict],
        [_positive(one) for one in floors],
        [_positive(one) for one in caps],
    )


def largest_margin(problem: Affine, found: Multipliers | None, kappa: float, *, most: float) -> float:
    """An upper bound of the margin for P below kappa I and other numbers within +-kappa; ``most`` is its cap."""
    if found is None:
        return np.inf
    level, slopes, weight = _sum(problem, found, capped=True)
    if weight <= 0.0:
        return np.inf
    # Weights above 1 are divided out; what is missing to 1 counts with the margin's own cap.
    size = max(1.0, weight)
    return max(0.0, 1.0 - weight) * most + (level + _largest(problem, slopes, kappa)) / size


def reach(problem: Affine, found: Multipliers | None) -> float:
    """Up to which condition number of P, and which size of any other number, nothing satisfies the inequalities.

    0 if nothing is proved. Leaves out the multipliers of kappa, so that the proof does not depend on it.
    """
    if found is None:
        return 0.0
    found = _exact(problem, found, np.zeros(len(problem.x0)))
    level, slopes, weight = _sum(problem, found, capped=False)
    if weight <= 0.0:
        return 0.0
    # The sum is affine in the reach, from its value at 0 numbers beyond the floors.
    first, second = (level + _largest(problem, slopes, size) for size in (1.0, 2.0))
    if first >= 0.0:
        return 0.0
    growth = second - first
    return np.inf if growth <= 0.0 else 1.0 - first / growth


def least_objective(problem: Affine, found: Multipliers | None, kappa: float) -> float:
    """A lower bound of the objective over all P below kappa I and other numbers within +-kappa."""
    if found is None or problem.objective is None:
        return -np.inf
    found = _exact(problem, found, problem.objective)
    level, slopes, _ = _sum(problem, found, capped=False)
    return -(
        level - float(problem.objective @ problem.x0) + _largest(problem, slopes - problem.objective, kappa)
    )


def _exact(problem: Affine, found: Multipliers, wanted: FloatArray) -> Multipliers:
    """The multipliers moved a little, so that the slopes become ``wanted`` up to rounding; those of kappa are left out.

    Z^(1/2) (I + S) Z^(1/2) with the least S: positive semidefinite as long as S is small.
    """
    pairs = [*zip(found.strict, problem.strict, strict=True), *zip(found.floors, problem.floors, strict=True)]
    without = Multipliers(found.strict, found.floors, [])
    _, slopes, _ = _sum(problem, without, capped=False)
    missing = slopes - wanted
    # A number that may grow as it likes towards its own side costs nothing.
    missing[(problem.lows > -np.inf) & (missing < 0.0)] = 0.0
    roots = [_root(z) for z, _ in pairs]
    shares = [root @ block @ root for root, (_, (_, block)) in zip(roots, pairs, strict=True)]
    flat = problem.basis.T @ np.hstack([one.reshape(len(one), -1) for one in shares])
    moved = flat.T @ np.linalg.lstsq(flat @ flat.T, problem.basis.T @ missing, rcond=1e-13)[0]
    exact, start = [], 0
    for root in roots:
        n = len(root)
        s = moved[start : start + n * n].reshape(n, n)
        exact.append(_positive(root @ (np.eye(n) + 0.5 * (s + s.T)) @ root))
        start += n * n
    strict = len(found.strict)
    return Multipliers(exact[:strict], exact[strict:], [])


def _sum(problem: Affine, found: Multipliers, *, capped: bool) -> tuple[float, FloatArray, float]:
    """-sum <Z, F(x)> as its value at x0, its slopes, and the weight of the strict blocks."""
    pairs = [*zip(found.strict, problem.strict, strict=True), *zip(found.floors, problem.floors, strict=True)]
    if capped:
        pairs += zip(found.caps, problem.caps, strict=True)
    level, slopes = 0.0, np.zeros(len(problem.x0))
    for z, (constant, block) in pairs:
        moved = constant + np.tensordot(problem.x0, block, 1)
        level -= float((z * moved).sum())
        slopes = slopes - np.tensordot(block, z, 2)
    return level, slopes, sum(float(np.trace(one)) for one in found.strict)


def _largest(problem: Affine, slopes: FloatArray, kappa: float) -> float:
    """The largest value of slopes (x - x0) over numbers of at most kappa, of P between I and kappa I."""
    highs = np.full(len(slopes), kappa)
    lows = np.maximum(problem.lows, -kappa)
    if not np.array_equal(problem.basis, np.eye(len(slopes))):
        size = np.maximum(np.abs(lows - problem.x0), np.abs(highs - problem.x0))
        return float(np.linalg.norm(problem.basis.T @ slopes) * np.linalg.norm(size))
    each = np.maximum(slopes * lows, slopes * highs)
    total = 0.0
    for start, rows in problem.positive:
        numbers = slice(start, start + rows * (rows + 1) // 2)
        values = np.linalg.eigvalsh(_dual(slopes[numbers], rows))
        total += float(np.maximum(values, 0.0).sum() * kappa + np.minimum(values, 0.0).sum())
        each[numbers] = 0.0
    return total + float(each.sum())


def _dual(slopes: FloatArray, rows: int) -> FloatArray:
    """The R with <R, P> = the slopes times the upper triangle of P."""
    r, (above, right) = np.zeros((rows, rows)), np.triu_indices(rows)
    r[above, right] += 0.5 * slopes
    r[right, above] += 0.5 * slopes
    return r


def _root(matrix: FloatArray) -> FloatArray:
    values, vectors = np.linalg.eigh(matrix)
    root: FloatArray = (vectors * np.sqrt(np.maximum(values, 0.0))) @ vectors.T
    return root


def _positive(matrix: Any) -> FloatArray:
    """The nearest positive semidefinite matrix."""
    square = np.atleast_2d(np.asarray(matrix, np.float64))
    values, vectors = np.linalg.eigh(0.5 * (square + square.T))
    positive: FloatArray = (vectors * np.maximum(values, 0.0)) @ vectors.T
    return positive
