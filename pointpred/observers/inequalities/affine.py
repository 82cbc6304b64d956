"""A problem of matrix inequalities as numbers: blocks that are affine in one vector."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.records import FloatArray

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
