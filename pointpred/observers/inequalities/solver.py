"""The call of the solver for ``matrix_inequalities``."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.extras import missing_extra
from pointpred.records import FloatArray
from pointpred_observers.inequalities.affine import Affine, Block
from pointpred_observers.inequalities.proof import Multipliers, multipliers

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


class Answer(msgspec.Struct, frozen=True):
    """The numbers and the multipliers that the solver returned, if any."""

    status: str
    numbers: FloatArray | None
    claimed: float
    """The margin that the solver reports for its numbers."""
    multipliers: Multipliers | None


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
    status = _solved(cvxpy, whole, solver)
    numbers = None
    if y.value is not None and np.isfinite(y.value).all():
        numbers = np.maximum(problem.x0 + problem.basis @ y.value, problem.lows)
    duals = [[_times(one.dual_value, unit) for one in group] for group in (strict, floors, caps)]
    proof = multipliers(*duals)
    claimed = -np.inf if t.value is None else float(t.value)
    return Answer(status, numbers, claimed if margin is None else margin, proof)


def _times(dual: Any, unit: float) -> Any:
    return None if dual is None else unit * np.asarray(dual)


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
                whole.solve(solver=solver, **digits, **ACCEPTED.get(solver, {}))
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
    there = library.installed_solvers()
    if not isinstance(solver, str) or solver not in there:
        raise ParameterError(f"solver {solver!r} is not installed; there are {', '.join(there)}")
    return library
