"""The call of the solver for ``matrix_inequalities``, and the bound that its multipliers prove."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.extras import missing_extra

CAP = 1e-2
"""Largest margin that is sought."""
TIGHT: dict[str, dict[str, float]] = {
    "CLARABEL": {"tol_feas": 1e-11, "tol_gap_abs": 1e-11, "tol_gap_rel": 1e-11}
}
"""Tight tolerances: kappa magnifies the rounding of the multipliers in the bound they prove."""
LOOSER = 1e-9
"""Second tolerances, still tighter than a solver's own."""
Block = tuple[FloatArray, FloatArray]


class Affine(msgspec.Struct, frozen=True):
    """A problem as numbers: constant and coefficients of each block, each scaled to a largest entry of 1.

    ``strict`` blocks must lie below -margin I, ``bounds`` below 0; ``x0 + basis y`` are the numbers that
    satisfy every equality; ``lows`` and ``highs`` bound the numbers, ``objective`` is linear in them.
    """

    strict: list[Block]
    bounds: list[Block]
    x0: FloatArray
    basis: FloatArray
    lows: FloatArray
    highs: FloatArray
    objective: FloatArray | None


class Answer(msgspec.Struct, frozen=True):
    """The numbers that the solver returned, if any, and a bound on the margin that its multipliers prove."""

    status: str
    numbers: FloatArray | None
    claimed: float
    """The margin that the solver reports for its numbers."""
    bound: float


def scaled(constant: FloatArray, slopes: FloatArray) -> tuple[Block, float]:
    """A block divided by its largest entry, and that entry."""
    size = float(max(np.abs(constant).max(), np.abs(slopes).max(initial=0.0)))
    return (constant / (size or 1.0), slopes / (size or 1.0)), size or 1.0


def run(problem: Affine, *, solver: str, margin: float | None) -> Answer:
    """Minimise the objective at the given margin, or find the largest margin if it is ``None``."""
    cvxpy = _library(solver)
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
    bounds = [block(pair, 0.0) for pair in problem.bounds]
    boxes = [x >= problem.lows, x <= problem.highs, t <= CAP]
    if margin is None or problem.objective is None:
        goal = cvxpy.Maximize(t)
    else:
        goal = cvxpy.Minimize(problem.objective @ x)
    whole = cvxpy.Problem(goal, [*strict, *bounds, *boxes])
    status = _solved(cvxpy, whole, solver)
    numbers = None if y.value is None else problem.x0 + problem.basis @ y.value
    if numbers is not None:
        numbers = np.clip(numbers, problem.lows, problem.highs)
    proof = np.inf
    if margin is None:
        proof = bound(problem, [one.dual_value for one in strict], [one.dual_value for one in bounds])
    claimed = -np.inf if t.value is None else float(t.value)
    return Answer(status, numbers, claimed if margin is None else margin, proof)


def bound(problem: Affine, strict: list[Any], bounds: list[Any]) -> float:
    """An upper bound of the margin for any multipliers: weak duality, with the multipliers made admissible.

    For Z_i >= 0 with sum tr Z_i = 1 over the strict blocks, the margin is at most the largest value of
    -sum <Z_i, F_i(x)> over the box, which is a sum over the entries of x.
    """
    if any(one is None or not np.isfinite(one).all() for one in [*strict, *bounds]):
        return np.inf
    multipliers = [_positive(one) for one in [*strict, *bounds]]
    weight = sum(float(np.trace(one)) for one in multipliers[: len(strict)])
    if weight <= 0.0:
        return np.inf
    slack = max(0.0, 1.0 - weight) * CAP
    size = max(1.0, weight)
    level, slope = 0.0, np.zeros(len(problem.x0))
    for z, (constant, slopes) in zip(multipliers, [*problem.strict, *problem.bounds], strict=True):
        moved = constant + np.tensordot(problem.x0, slopes, 1)
        level -= float((z * moved).sum()) / size
        slope -= np.tensordot(slopes, z, 2) / size
    if np.array_equal(problem.basis, np.eye(len(slope))):
        return slack + level + float(np.maximum(slope * problem.lows, slope * problem.highs).sum())
    reach = np.maximum(np.abs(problem.lows - problem.x0), np.abs(problem.highs - problem.x0))
    return slack + level + float(np.linalg.norm(problem.basis.T @ slope) * np.linalg.norm(reach))


def _positive(matrix: Any) -> FloatArray:
    """The nearest positive semidefinite matrix."""
    square = np.atleast_2d(np.asarray(matrix, np.float64))
    values, vectors = np.linalg.eigh(0.5 * (square + square.T))
    positive: FloatArray = (vectors * np.maximum(values, 0.0)) @ vectors.T
    return positive


def _solved(cvxpy: Any, whole: Any, solver: str) -> str:
    """Run the solver; its errors become its status, since its answer is audited anyway.

    If it stalls before the tight tolerances without an answer, it runs again with looser ones.
    """
    import warnings

    failed, tight = "", TIGHT.get(solver, {})
    for digits in (tight, dict.fromkeys(tight, LOOSER))[: 2 if tight else 1]:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                whole.solve(solver=solver, **digits)
        except (cvxpy.error.SolverError, ArithmeticError, ValueError) as failure:
            failed = f"failed: {failure}"
        else:
            return str(whole.status)
    return failed


def _library(solver: str) -> Any:
    try:
        import cvxpy
    except ImportError as missing:
        raise missing_extra("observers", "designing an observer needs a solver") from missing
    library: Any = cvxpy
    if solver not in (there := library.installed_solvers()):
        raise ParameterError(f"solver {solver!r} is not installed; there are {', '.join(there)}")
    return library
