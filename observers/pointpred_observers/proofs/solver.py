"""The call of the solver, for a problem as posed or in coordinates in which given numbers are near 1."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.proofs.affine import Affine, Block, Multipliers, multipliers

SOLVER = "CLARABEL"
CAP = 1e-2
"""Largest margin that is sought."""
ACCEPTED: dict[str, dict[str, bool]] = {"CLARABEL": {"accept_unknown": True}}
"""Numbers of a solver that gave up are audited like any others, and are where the next attempt begins."""
TIGHT: dict[str, dict[str, float]] = {
    "CLARABEL": {"tol_feas": 1e-11, "tol_gap_abs": 1e-11, "tol_gap_rel": 1e-11}
}
"""Tight tolerances: kappa magnifies the rounding of the multipliers in the bound they prove."""
LOOSER = 1e-9
"""Second tolerances, still tighter than a solver's own."""

SMALLEST = 1e-8
"""Eigenvalues of P and of a slack below this share of the largest do not scale further."""


class Rescaled(msgspec.Struct, frozen=True):
    """The problem in new coordinates, and the way back.

    numbers = ``onto`` times the new ones; each new block is C F C' with its C of ``strict``, ``floors``,
    ``caps``.
    """

    problem: Affine
    onto: FloatArray
    strict: list[FloatArray]
    floors: list[FloatArray]
    caps: list[FloatArray]

    def numbers(self, new: FloatArray) -> FloatArray:
        """The numbers in the coordinates of the problem as posed."""
        return np.asarray(self.onto @ new, np.float64)

    def multipliers(self, new: Multipliers | None) -> Multipliers | None:
        """The multipliers of the problem as posed: <Z, C F C'> = <C'Z C, F>."""
        if new is None:
            return None
        return Multipliers(
            _back(new.strict, self.strict), _back(new.floors, self.floors), _back(new.caps, self.caps)
        )


def rescaled(problem: Affine, numbers: FloatArray) -> Rescaled:
    """The problem in coordinates where each positive matrix at ``numbers`` is I, and each slack near I.

    A matrix P of a large condition number stalls a solver of interior points; here it is I. ``numbers``
    need not satisfy the inequalities. The margin of a strict block is meant in the new coordinates.
    """
    onto = np.diag(np.exp2(np.round(np.log2(np.maximum(np.abs(numbers), 1e-6)))))
    for start, rows in problem.positive:
        place = slice(start, start + rows * (rows + 1) // 2)
        onto[place, place] = _turned(numbers[place], rows)
    strict, floors, caps = (
        [_congruence(one, numbers) for one in group]
        for group in (problem.strict, problem.floors, problem.caps)
    )
    plain = np.array_equal(problem.basis, np.eye(len(numbers)))
    inverse = np.linalg.inv(onto)
    new = Affine(
        [_moved(one, c, onto) for one, c in zip(problem.strict, strict, strict=True)],
        [_moved(one, c, onto) for one, c in zip(problem.floors, floors, strict=True)],
        [_moved(one, c, onto) for one, c in zip(problem.caps, caps, strict=True)],
        inverse @ problem.x0,
        problem.basis if plain else inverse @ problem.basis,
        problem.lows / np.diag(onto),
        None if problem.objective is None else onto.T @ problem.objective,
        problem.positive,
    )
    return Rescaled(new, onto, strict, floors, caps)


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


def _congruence(block: Block, numbers: FloatArray) -> FloatArray:
    """C such that C F C' is near I in size at these numbers."""
    constant, slopes = block
    return np.asarray(np.linalg.inv(_root(constant + np.tensordot(numbers, slopes, 1))), np.float64)


def _root(matrix: FloatArray) -> FloatArray:
    """The root of a symmetric matrix with its eigenvalues made positive; that of a zero matrix is I."""
    values, vectors = np.linalg.eigh(matrix)
    sizes = np.maximum(np.abs(values), SMALLEST * float(np.abs(values).max()) or 1.0)
    root: FloatArray = (vectors * np.sqrt(sizes)) @ vectors.T
    return root


def _moved(block: Block, c: FloatArray, onto: FloatArray) -> Block:
    constant, slopes = block
    turned = c @ np.tensordot(onto.T, slopes, 1) @ c.T
    return c @ constant @ c.T, 0.5 * (turned + turned.transpose(0, 2, 1))


def _back(new: list[FloatArray], congruences: list[FloatArray]) -> list[FloatArray]:
    return [c.T @ z @ c for z, c in zip(new, congruences, strict=True)]


class Answer(msgspec.Struct, frozen=True):
    """The numbers and the multipliers that the solver returned, if any."""

    status: str
    numbers: FloatArray | None
    claimed: float
    """The margin that the solver reports for its numbers."""
    multipliers: Multipliers | None


def run(problem: Affine, *, margin: float | None) -> Answer:
    """Minimise the objective at the given margin, or find the largest margin if it is ``None``."""
    cvxpy: Any = import_module("cvxpy")  # where it is first needed: it takes a second
    y, t = cvxpy.Variable(problem.basis.shape[1]), cvxpy.Variable()
    x = problem.x0 + problem.basis @ y
    needed = t if margin is None else margin

    def block(pair: Block, above: Any) -> Any:
        constant, slopes = pair
        rows = len(constant)
        flat = (problem.basis.T @ slopes.reshape(len(slopes), -1)).T @ y
        moved = constant + np.tensordot(problem.x0, slopes, 1)
        return moved + cvxpy.reshape(flat, (rows, rows), order="C") + above * np.eye(rows) << 0

    strict = [block(pair, needed) for pair in problem.strict]
    floors = [block(pair, 0.0) for pair in problem.floors]
    caps = [block(pair, 0.0) for pair in problem.caps]
    signed = np.flatnonzero(problem.lows > -np.inf)
    unit = 1.0
    signs = [x[signed] >= problem.lows[signed]] if len(signed) else []
    if margin is None or problem.objective is None:
        goal, signs = cvxpy.Maximize(t), [*signs, t <= CAP]
    else:
        unit = float(np.abs(problem.objective).max()) or 1.0
        goal = cvxpy.Minimize((problem.objective / unit) @ x)
    whole = cvxpy.Problem(goal, [*strict, *floors, *caps, *signs])
    status = _solved(cvxpy, whole)
    numbers = None
    if y.value is not None and np.isfinite(y.value).all():
        numbers = np.maximum(problem.x0 + problem.basis @ y.value, problem.lows)
    duals = [[_times(one.dual_value, unit) for one in group] for group in (strict, floors, caps)]
    proof = multipliers(*duals)
    claimed = -np.inf if t.value is None else float(t.value)
    return Answer(status, numbers, claimed if margin is None else margin, proof)


def _times(dual: Any, unit: float) -> Any:
    return None if dual is None else unit * np.asarray(dual)


def _solved(cvxpy: Any, whole: Any) -> str:
    """Run the solver; its errors become its status, since its answer is audited anyway.

    If it stalls before the tight tolerances without an answer, it runs again with looser ones.
    """
    import warnings

    failed, tight = "", TIGHT.get(SOLVER, {})
    for digits in (tight, dict.fromkeys(tight, LOOSER))[: 2 if tight else 1]:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                whole.solve(solver=SOLVER, **digits, **ACCEPTED.get(SOLVER, {}))
        except (cvxpy.error.SolverError, ArithmeticError, ValueError) as failure:
            failed = f"failed: {failure}"
        else:
            return str(whole.status)
    return failed
