"""A problem of matrix inequalities as numbers: the call of the solver, and what its multipliers prove.

Blocks are affine in one vector. Weak duality, recomputed: for Z_i >= 0 and numbers x that satisfy every
inequality, sum <Z_i, F_i(x)> <= 0. The sum is affine in x. Its slopes should vanish, and they do up to
rounding; what is left is bounded for numbers up to a ``reach``, so that a proof says for which it holds.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from importlib import import_module
from typing import Any

import msgspec
import numpy as np

from pointpred.records import FloatArray

ENTIRE = 1e12
"""A proof up to this condition number of P, in balanced units, counts as one for every choice."""
CORRECTIONS = 7
"""Steps with which the multipliers are moved towards the slopes that they should have."""
PATIENT = 60
"""Steps for the best multipliers of a search that decided nothing, which converge slowly at a double root."""
EPS = float(np.finfo(np.float64).eps)
"""Rounding of a coefficient, relative to itself: no multiplier can show what is smaller."""
RANKS = (1e-6, 0.0, 1e-3)
"""Eigenvalues of a multiplier below this share of its largest count as rounding, in turn."""
SMALLEST = 1e-8
"""Eigenvalues of P and of a slack below this share of the largest do not scale further."""
SOLVER = "CLARABEL"
CAP = 1e-2
"""Largest margin that is sought."""
SETTINGS: dict[str, list[dict[str, Any]]] = {
    "CLARABEL": [
        {"tol_feas": one, "tol_gap_abs": one, "tol_gap_rel": one, "accept_unknown": True}
        for one in (1e-11, 1e-9)
    ]
}
"""Of each attempt. Tight, as a proof's reach is limited by rounding; numbers of a solver that gave up are
audited like any others, and are where the next attempt begins."""

Block = tuple[FloatArray, FloatArray]
"""The constant part, shape (n, n), and the slopes, shape (numbers, n, n)."""


class Affine(msgspec.Struct, frozen=True):
    """The constant and the slopes of each block, each divided by its largest entry.

    The first ``strict`` blocks must lie below -margin I; then comes I - P for each matrix declared positive,
    then P - kappa I for each, which must lie below 0. ``x0 + basis y`` are the numbers that satisfy every
    equality; ``lows`` are their least values; ``objective`` is linear in them. ``positive`` are the place and
    the rows of each P among the numbers, by its upper triangle.
    """

    blocks: list[Block]
    strict: int
    x0: FloatArray
    basis: FloatArray
    lows: FloatArray
    objective: FloatArray | None
    positive: list[tuple[int, int]]

    @property
    def free(self) -> bool:
        """Whether there are no equalities."""
        return np.array_equal(self.basis, np.eye(len(self.x0)))

    @property
    def lower(self) -> list[Block]:
        """The blocks without those of kappa: a proof by them does not depend on it."""
        return self.blocks[: self.strict + len(self.positive)]


def scaled(constant: FloatArray, slopes: FloatArray) -> Block:
    """A block divided by its largest entry."""
    size = float(max(np.abs(constant).max(), np.abs(slopes).max(initial=0.0))) or 1.0
    return constant / size, slopes / size


def relaxing(problem: Affine) -> list[int]:
    """The numbers of which a larger value makes every block smaller, such as a bound that is minimised.

    Whether the inequalities can be satisfied does not depend on them: see ``released``.
    """
    if not problem.free:
        return []
    listed = []
    for i, low in enumerate(problem.lows):
        slopes = [block[i] for _, block in problem.blocks if block[i].any()]
        # Diagonals only: others are not entered by a bound, and a sign is then plain to see.
        falling = all(
            np.array_equal(one, np.diag(np.diag(one))) and np.diag(one).max() <= 0 for one in slopes
        )
        if low > -np.inf and slopes and falling:
            listed.append(i)
    return listed


def released(problem: Affine, free: list[int]) -> Affine:
    """The problem with these numbers as large as needed: each block on the kernel of their slopes.

    What remains is necessary, and sufficient as well where it holds strictly (Schur).
    """
    kept: list[Block] = []
    for constant, slopes in problem.blocks[: problem.strict]:
        rows = ~(np.diagonal(slopes[free], axis1=1, axis2=2) != 0.0).any(axis=0)
        if rows.any():
            kept.append((constant[np.ix_(rows, rows)], slopes[:, rows][:, :, rows]))
    blocks = [*kept, *problem.blocks[problem.strict :]]
    return msgspec.structs.replace(problem, blocks=blocks, strict=len(kept), objective=None)


def capped(problem: Affine, most: float) -> Affine:
    """The problem with its objective below ``most``, which must be above 0."""
    assert problem.objective is not None
    block = (np.array([[-1.0]]), (problem.objective / most).reshape(-1, 1, 1))
    blocks, end = list(problem.blocks), problem.strict
    blocks.insert(end, block)
    return msgspec.structs.replace(problem, blocks=blocks, strict=end + 1, objective=None)


Multipliers = list[FloatArray] | None
"""A matrix Z >= 0 for each of the ``lower`` blocks; ``None`` where the solver has none."""


def reach(problem: Affine, given: Multipliers, corrections: int = CORRECTIONS) -> float:
    """Up to which condition number of P, and size of any other number, nothing satisfies the inequalities.

    0 if nothing is proved. Infinite only where no number has a coefficient: those are known up to rounding.
    """
    if given is None or _sum(problem, given)[0] >= 0.0:
        return 0.0
    best = 0.0
    for one in _corrected(problem, given, np.zeros(len(problem.x0)), corrections):
        level, slopes = _sum(problem, one)
        # How far the rounding of the coefficients may move the sum, and by how much more per size of numbers.
        fixed = growing = 0.0
        for z, (constant, block) in zip(one, problem.lower, strict=True):
            sizes = np.tensordot(np.abs(block), np.abs(z), 2)
            fixed += EPS * float((np.abs(z) * np.abs(constant)).sum() + np.abs(problem.x0) @ sizes)
            growing += EPS * float(sizes.sum())
        # The sum is affine in the reach, from its value at 0 numbers beyond the floors.
        at_one, at_two = (_largest(problem, slopes, size) for size in (1.0, 2.0))
        first, growth = level + fixed + at_one + growing, max(0.0, at_two - at_one) + growing
        if any(np.trace(z) > 0.0 for z in one[: problem.strict]) and first < 0.0:
            best = max(best, np.inf if growth <= 0.0 else 1.0 - first / growth)
        if best >= ENTIRE:
            break
    return best


def least_objective(problem: Affine, given: Multipliers, kappa: float, enough: float = np.inf) -> float:
    """A lower bound of the objective over all P below kappa I and other numbers within +-kappa.

    The search for a better one ends at ``enough``.
    """
    best = -np.inf
    if problem.objective is None or given is None:
        return best
    for one in _corrected(problem, given, problem.objective, CORRECTIONS):
        level, slopes = _sum(problem, one)
        start = level - float(problem.objective @ problem.x0)
        best = max(best, -(start + _largest(problem, slopes - problem.objective, kappa)))
        if best >= enough:
            break
    return best


def _corrected(
    problem: Affine, given: list[FloatArray], wanted: FloatArray, corrections: int
) -> Iterator[list[FloatArray]]:
    """The multipliers moved until their slopes are ``wanted`` up to rounding.

    Z = R R' with R of low rank, so that Z is positive semidefinite whatever R is, and Newton's steps of least
    size for R. Where a multiplier must vanish along a direction the root is double: there every second step
    is twice as long. In extended precision, where the machine has it, since the reach is limited by rounding.
    """
    for share in RANKS:
        roots = []
        for z in given:
            values, vectors = np.linalg.eigh(z)
            kept = values > share * max(float(values[-1]), 0.0)
            roots.append((vectors[:, kept] * np.sqrt(np.maximum(values[kept], 0.0))).astype(np.longdouble))
        exact: list[Any] = [r @ r.T for r in roots]
        for i in range(corrections):
            missing = np.asarray(_sum(problem, exact)[1] - wanted, np.float64)
            # A number that may grow as it likes towards its own side costs nothing.
            missing[(problem.lows > -np.inf) & (missing < 0.0)] = 0.0
            sides = [
                (block @ np.asarray(r, np.float64)).reshape(len(block), -1)
                for r, (_, block) in zip(roots, problem.lower, strict=True)
            ]
            flat, length = problem.basis.T @ np.hstack(sides), 1.0 + i % 2
            steps = 0.5 * length * np.linalg.lstsq(flat, problem.basis.T @ missing, rcond=1e-12)[0]
            parts = np.split(steps, np.cumsum([r.size for r in roots])[:-1])
            roots = [r + one.reshape(r.shape) for r, one in zip(roots, parts, strict=True)]
            exact = [r @ r.T for r in roots]
            yield exact


def _sum(problem: Affine, given: list[FloatArray]) -> tuple[float, FloatArray]:
    """-sum <Z, F(x)> as its value at x0, and its slopes."""
    level, slopes = 0.0, np.zeros(len(problem.x0))
    for z, (constant, block) in zip(given, problem.lower, strict=True):
        moved = constant + np.tensordot(problem.x0, block, 1)
        level -= float((z * moved).sum())
        slopes = slopes - np.tensordot(block, z, 2)
    return level, slopes


def _largest(problem: Affine, slopes: FloatArray, kappa: float) -> float:
    """The largest value of slopes (x - x0) over numbers of at most kappa, of P between I and kappa I."""
    highs = np.full(len(slopes), kappa)
    lows = np.maximum(problem.lows, -kappa)
    if not problem.free:
        size = np.maximum(np.abs(lows - problem.x0), np.abs(highs - problem.x0))
        return float(np.linalg.norm(problem.basis.T @ slopes) * np.linalg.norm(size))
    each = np.maximum(slopes * lows, slopes * highs)
    total = 0.0
    for start, rows in problem.positive:
        numbers = slice(start, start + rows * (rows + 1) // 2)
        # The R with <R, P> = these slopes times the upper triangle of P.
        r, (above, right) = np.zeros((rows, rows)), np.triu_indices(rows)
        r[above, right] += 0.5 * slopes[numbers]
        r[right, above] += 0.5 * slopes[numbers]
        values = np.linalg.eigvalsh(r)
        total += float(np.maximum(values, 0.0).sum() * kappa + np.minimum(values, 0.0).sum())
        each[numbers] = 0.0
    return total + float(each.sum())


class Answer(msgspec.Struct, frozen=True):
    """The numbers and the multipliers that the solver returned, if any."""

    status: str
    numbers: FloatArray | None
    claimed: float
    """The margin that the solver reports for its numbers."""
    multipliers: Multipliers


def answered(problem: Affine, margin: float | None, near: FloatArray | None) -> Answer:
    """The solver's answer, in coordinates where each positive matrix is I at the numbers ``near``, if given.

    There each slack is near I. A matrix P of a large condition number stalls a solver of interior points;
    here it is I. ``near`` need not satisfy the inequalities. The margin of a strict block is meant in the new
    coordinates: the numbers are ``onto`` times the new ones, each new block is C F C', and <Z, C F C'> is
    <C'Z C, F>.
    """
    if near is None:
        return run(problem, margin=margin)
    onto = np.diag(np.exp2(np.round(np.log2(np.maximum(np.abs(near), 1e-6)))))
    for start, rows in problem.positive:
        place = slice(start, start + rows * (rows + 1) // 2)
        onto[place, place] = _turned(near[place], rows)
    inverse, turns, blocks = np.linalg.inv(onto), [], []
    for constant, slopes in problem.blocks:
        c = np.linalg.inv(_root(constant + np.tensordot(near, slopes, 1)))
        turned = c @ np.tensordot(onto.T, slopes, 1) @ c.T
        turns.append(c)
        blocks.append((c @ constant @ c.T, 0.5 * (turned + turned.transpose(0, 2, 1))))
    new = Affine(
        blocks,
        problem.strict,
        inverse @ problem.x0,
        problem.basis if problem.free else inverse @ problem.basis,
        problem.lows / np.diag(onto),
        None if problem.objective is None else onto.T @ problem.objective,
        problem.positive,
    )
    answer = run(new, margin=margin)
    numbers = None if answer.numbers is None else onto @ answer.numbers
    proof = answer.multipliers
    if proof is not None:
        proof = [c.T @ z @ c for z, c in zip(proof, turns[: len(proof)], strict=True)]
    return msgspec.structs.replace(answer, numbers=numbers, multipliers=proof)


def _turned(numbers: FloatArray, rows: int) -> FloatArray:
    """The map of the upper triangle of P~ to that of P = R P~ R, R the root of the P of these numbers."""
    p, (above, right) = np.zeros((rows, rows)), np.triu_indices(rows)
    p[above, right] = p[right, above] = numbers
    r, columns = _root(p), []
    for i, j in zip(above, right, strict=True):
        unit = np.zeros((rows, rows))
        unit[i, j] = unit[j, i] = 1.0
        columns.append((r @ unit @ r)[above, right])
    return np.array(columns).T


def _root(matrix: FloatArray) -> FloatArray:
    """The root of a symmetric matrix with its eigenvalues made positive; that of a zero matrix is I."""
    values, vectors = np.linalg.eigh(matrix)
    sizes = np.maximum(np.abs(values), SMALLEST * float(np.abs(values).max()) or 1.0)
    root: FloatArray = (vectors * np.sqrt(sizes)) @ vectors.T
    return root


def run(problem: Affine, *, margin: float | None) -> Answer:
    """Minimise the objective at the given margin, or find the largest margin if it is ``None``."""
    cvxpy: Any = import_module("cvxpy")  # where it is first needed: it takes a second
    y, t = cvxpy.Variable(problem.basis.shape[1]), cvxpy.Variable()
    x = problem.x0 + problem.basis @ y
    blocks = []
    for i, (constant, slopes) in enumerate(problem.blocks):
        rows, needed = len(constant), t if margin is None else margin
        flat = (problem.basis.T @ slopes.reshape(len(slopes), -1)).T @ y
        moved = constant + np.tensordot(problem.x0, slopes, 1)
        room = (needed if i < problem.strict else 0.0) * np.eye(rows)
        blocks.append(moved + cvxpy.reshape(flat, (rows, rows), order="C") + room << 0)
    signed = np.flatnonzero(problem.lows > -np.inf)
    unit = 1.0
    signs = [x[signed] >= problem.lows[signed]] if len(signed) else []
    if margin is None or problem.objective is None:
        goal, signs = cvxpy.Maximize(t), [*signs, t <= CAP]
    else:
        unit = float(np.abs(problem.objective).max()) or 1.0
        goal = cvxpy.Minimize((problem.objective / unit) @ x)
    status = _solved(cvxpy.Problem(goal, [*blocks, *signs]), cvxpy.error.SolverError)
    numbers, proof = None, None
    if y.value is not None and np.isfinite(y.value).all():
        numbers = np.maximum(problem.x0 + problem.basis @ y.value, problem.lows)
    duals = [one.dual_value for one in blocks[: len(problem.lower)]]
    if all(one is not None and np.isfinite(one).all() for one in duals):
        proof = [_positive(unit * np.asarray(one)) for one in duals]
    claimed = -np.inf if t.value is None else float(t.value)
    return Answer(status, numbers, claimed if margin is None else margin, proof)


def _positive(matrix: Any) -> FloatArray:
    """The nearest positive semidefinite matrix."""
    square = np.atleast_2d(np.asarray(matrix, np.float64))
    values, vectors = np.linalg.eigh(0.5 * (square + square.T))
    positive: FloatArray = (vectors * np.maximum(values, 0.0)) @ vectors.T
    return positive


def _solved(whole: Any, failing: type[Exception]) -> str:
    """Run the solver; its errors become its status, since its answer is audited anyway."""
    failed = ""
    for settings in SETTINGS.get(SOLVER, [{}]):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                whole.solve(solver=SOLVER, **settings)
            return str(whole.status)
        except BaseException as failure:
            # A panic of a solver that is written in Rust is no Exception.
            panic = type(failure).__name__ == "PanicException"
            if not panic and not isinstance(failure, (failing, ArithmeticError, ValueError)):
                raise
            failed = f"failed: {failure}"
    return failed
