"""A problem of matrix inequalities as numbers, and what the multipliers of a solver prove of it.

Blocks are affine in one vector. Weak duality, recomputed: for Z_i >= 0 and numbers x that satisfy every
inequality, sum <Z_i, F_i(x)> <= 0. The sum is affine in x. Its slopes should vanish, and they do up to
rounding; what is left is bounded for numbers up to a ``reach``, so that a proof says for which it holds.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import msgspec
import numpy as np

from pointpred.records import FloatArray

ENTIRE = 1e12
"""A proof up to this condition number of P, in balanced units, counts as one for every choice."""
CORRECTIONS = 7
"""Steps with which the multipliers are moved towards the slopes that they should have."""
EPS = float(np.finfo(np.float64).eps)
"""Rounding of a coefficient, relative to itself: no multiplier can show what is smaller."""
RANKS = (1e-6, 0.0, 1e-3)
"""Eigenvalues of a multiplier below this share of its largest count as rounding, in turn."""

Block = tuple[FloatArray, FloatArray]
"""The constant part, shape (n, n), and the slopes, shape (numbers, n, n)."""


class Affine(msgspec.Struct, frozen=True):
    """Constant and slopes of each block, each divided by its largest entry.

    ``strict`` blocks must lie below -margin I; ``floors``, I - P for each matrix declared positive, and
    ``caps``, P - kappa I, below 0. ``x0 + basis y`` are the numbers that satisfy every equality; ``lows`` are
    their least values; ``objective`` is linear in them. ``positive`` are the place and the rows of each P
    among the numbers, by its upper triangle.
    """

    strict: list[Block]
    floors: list[Block]
    caps: list[Block]
    x0: FloatArray
    basis: FloatArray
    lows: FloatArray
    objective: FloatArray | None
    positive: list[tuple[int, int]]


def scaled(constant: FloatArray, slopes: FloatArray) -> tuple[Block, float]:
    """A block divided by its largest entry, and that entry."""
    size = float(max(np.abs(constant).max(), np.abs(slopes).max(initial=0.0)))
    return (constant / (size or 1.0), slopes / (size or 1.0)), size or 1.0


def relaxing(problem: Affine) -> list[int]:
    """The numbers of which a larger value makes every block smaller, such as a bound that is minimised.

    Whether the inequalities can be satisfied does not depend on them: see ``released``.
    """
    if not np.array_equal(problem.basis, np.eye(len(problem.x0))):
        return []
    blocks = [*problem.strict, *problem.floors, *problem.caps]
    listed = []
    for i, low in enumerate(problem.lows):
        slopes = [block[i] for _, block in blocks if block[i].any()]
        # Diagonals only: others are not entered by a bound, and a sign is then plain to see.
        if low > -np.inf and slopes and all(_falls(one) for one in slopes):
            listed.append(i)
    return listed


def released(problem: Affine, free: list[int]) -> Affine:
    """The problem with these numbers as large as needed: each block on the kernel of their slopes.

    What remains is necessary, and sufficient as well where it holds strictly (Schur).
    """
    strict = [_kept(one, free) for one in problem.strict]
    return Affine(
        [one for one in strict if len(one[0])],
        problem.floors,
        problem.caps,
        problem.x0,
        problem.basis,
        problem.lows,
        None,
        problem.positive,
    )


def capped(problem: Affine, most: float) -> Affine:
    """The problem with the objective below ``most``, which must be above 0."""
    if problem.objective is None:
        return problem
    block = (np.array([[-1.0]]), (problem.objective / most).reshape(-1, 1, 1))
    return msgspec.structs.replace(problem, strict=[*problem.strict, block], objective=None)


def _falls(slope: FloatArray) -> bool:
    return bool(np.array_equal(slope, np.diag(np.diag(slope))) and (np.diag(slope) <= 0.0).all())


def _kept(block: Block, free: list[int]) -> Block:
    constant, slopes = block
    rows = (
        ~np.any([np.diag(slopes[i]) != 0.0 for i in free], axis=0) if free else np.ones(len(constant), bool)
    )
    return constant[np.ix_(rows, rows)], slopes[:, rows][:, :, rows]


class Multipliers(msgspec.Struct, frozen=True):
    """A matrix Z >= 0 for each block of ``strict``, ``floors`` (I - P) and ``caps`` (P - kappa I)."""

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


def largest_margin(problem: Affine, given: Multipliers | None, kappa: float, *, most: float) -> float:
    """An upper bound of the margin for P below kappa I and numbers within +-kappa; ``most`` is its cap."""
    if given is None:
        return np.inf
    level, slopes, weight = _sum(problem, given, capped=True)
    if weight <= 0.0:
        return np.inf
    # Weights above 1 are divided out; what is missing to 1 counts with the margin's own cap.
    size = max(1.0, weight)
    return max(0.0, 1.0 - weight) * most + (level + _largest(problem, slopes, kappa)) / size


def reach(problem: Affine, given: Multipliers | None) -> float:
    """Up to which condition number of P, and size of any other number, nothing satisfies the inequalities.

    0 if nothing is proved. Infinite only where no number has a coefficient: those are known up to rounding.
    Leaves out the multipliers of kappa, so that the proof does not depend on it.
    """
    if given is None or _sum(problem, given, capped=False)[0] >= 0.0:
        return 0.0
    best = 0.0
    for one in _corrected(problem, given, np.zeros(len(problem.x0))):
        level, slopes, weight = _sum(problem, one, capped=False)
        fixed, growing = _rounding(problem, one)
        # The sum is affine in the reach, from its value at 0 numbers beyond the floors.
        at_one, at_two = (_largest(problem, slopes, size) for size in (1.0, 2.0))
        first, growth = level + fixed + at_one + growing, max(0.0, at_two - at_one) + growing
        if weight > 0.0 and first < 0.0:
            best = max(best, np.inf if growth <= 0.0 else 1.0 - first / growth)
        if best >= ENTIRE:
            break
    return best


def least_objective(
    problem: Affine, given: Multipliers | None, kappa: float, enough: float = np.inf
) -> float:
    """A lower bound of the objective over all P below kappa I and other numbers within +-kappa.

    The search for a better one ends at ``enough``.
    """
    best = -np.inf
    if problem.objective is None:
        return best
    for one in _corrected(problem, given, problem.objective):
        level, slopes, _ = _sum(problem, one, capped=False)
        start = level - float(problem.objective @ problem.x0)
        best = max(best, -(start + _largest(problem, slopes - problem.objective, kappa)))
        if best >= enough:
            break
    return best


def _corrected(problem: Affine, given: Multipliers | None, wanted: FloatArray) -> Iterator[Multipliers]:
    """The multipliers, without those of kappa, moved until their slopes are ``wanted`` up to rounding.

    Z = R R' with R of low rank, so that Z is positive semidefinite whatever R is, and Newton's steps of least
    size for R. Where a multiplier must vanish along a direction the root is double: there every second step
    is twice as long. In extended precision, where the machine has it, since the reach is limited by rounding.
    """
    if given is None:
        return
    strict = len(given.strict)
    for share in RANKS:
        roots = [_root(z, share).astype(np.longdouble) for z in (*given.strict, *given.floors)]
        for i in range(CORRECTIONS):
            roots = _moved(problem, roots, wanted, 1.0 + i % 2)
            exact: list[Any] = [r @ r.T for r in roots]
            yield Multipliers(exact[:strict], exact[strict:], [])


def _moved(problem: Affine, roots: list[Any], wanted: FloatArray, length: float) -> list[Any]:
    """The roots after a step of Newton's, ``length`` times as long."""
    blocks = [*problem.strict, *problem.floors]
    exact: list[Any] = [r @ r.T for r in roots]
    strict = len(problem.strict)
    _, slopes, _ = _sum(problem, Multipliers(exact[:strict], exact[strict:], []), capped=False)
    missing = np.asarray(slopes - wanted, np.float64)
    # A number that may grow as it likes towards its own side costs nothing.
    missing[(problem.lows > -np.inf) & (missing < 0.0)] = 0.0
    rounded = [np.asarray(r, np.float64) for r in roots]
    sides = [(block @ r).reshape(len(block), -1) for r, (_, block) in zip(rounded, blocks, strict=True)]
    flat = problem.basis.T @ np.hstack(sides)
    steps = 0.5 * length * np.linalg.lstsq(flat, problem.basis.T @ missing, rcond=1e-12)[0]
    moved, start = [], 0
    for r in roots:
        moved.append(r + steps[start : start + r.size].reshape(r.shape))
        start += r.size
    return moved


def _sum(problem: Affine, given: Multipliers, *, capped: bool) -> tuple[float, FloatArray, float]:
    """-sum <Z, F(x)> as its value at x0, its slopes, and the weight of the strict blocks."""
    pairs = [*zip(given.strict, problem.strict, strict=True), *zip(given.floors, problem.floors, strict=True)]
    if capped:
        pairs += zip(given.caps, problem.caps, strict=True)
    level, slopes = 0.0, np.zeros(len(problem.x0))
    for z, (constant, block) in pairs:
        moved = constant + np.tensordot(problem.x0, block, 1)
        level -= float((z * moved).sum())
        slopes = slopes - np.tensordot(block, z, 2)
    return level, slopes, sum(float(np.trace(one)) for one in given.strict)


def _rounding(problem: Affine, given: Multipliers) -> tuple[float, float]:
    """How far the rounding of the coefficients may move the sum, and by how much more per size of numbers."""
    fixed = growing = 0.0
    pairs = [*zip(given.strict, problem.strict, strict=True), *zip(given.floors, problem.floors, strict=True)]
    for z, (constant, block) in pairs:
        sizes = np.tensordot(np.abs(block), np.abs(z), 2)
        fixed += float((np.abs(z) * np.abs(constant)).sum() + np.abs(problem.x0) @ sizes)
        growing += float(sizes.sum())
    return EPS * fixed, EPS * growing


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


def _root(matrix: FloatArray, share: float) -> FloatArray:
    """R with R R' the matrix, without eigenvalues below this share of the largest."""
    values, vectors = np.linalg.eigh(matrix)
    kept = values > share * max(float(values[-1]), 0.0)
    root: FloatArray = vectors[:, kept] * np.sqrt(np.maximum(values[kept], 0.0))
    return root


def _positive(matrix: Any) -> FloatArray:
    """The nearest positive semidefinite matrix."""
    square = np.atleast_2d(np.asarray(matrix, np.float64))
    values, vectors = np.linalg.eigh(0.5 * (square + square.T))
    positive: FloatArray = (vectors * np.maximum(values, 0.0)) @ vectors.T
    return positive
