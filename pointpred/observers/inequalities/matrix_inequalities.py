"""Linear matrix inequalities: the only interface to a solver.

A solver's answer is never a certificate. Its matrices are audited (``audit.py``): the numpy functions of the
problem are evaluated at them and the eigenvalues recomputed. A problem is infeasible only if the solver's
multipliers, recomputed as well, bound the margin of any choice. Otherwise it is undecided.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.observers.inequalities.audit import Inequalities
from pointpred.observers.inequalities.solver import Affine, Answer, run, scaled
from pointpred.observers.inequalities.unknowns import Block


class Solution(msgspec.Struct, frozen=True):
    """Matrices that satisfy every inequality: ``values`` by name, ``margins`` by inequality.

    A margin is the distance of the nearest eigenvalue from the wrong side, in the unit of the inequality.
    ``objective`` is what was minimised, ``None`` if nothing was or the minimum was not reached.
    """

    values: dict[str, Any]
    margins: dict[str, float]
    objective: float | None


class MatrixInequalities(Inequalities):
    """Find matrices that satisfy linear matrix inequalities with a margin.

    Assumes strict inequalities: one that can only hold with equality is infeasible here. Meant for dense
    problems of some hundred numbers; sparsity is not used.

    Each inequality reads block(v) <= -margin s I, where v holds the matrices and s is the largest coefficient
    of the block; a matrix declared ``positive`` lies between I and kappa I, any other number within +-kappa.

    Parameters: ``margin`` relative to s, (0, 1e-2]; ``kappa`` the largest eigenvalue and entry, [10, 1e8].
    Returns a ``Solution`` from ``solve``. Raises ParameterError, InfeasibleError, UndecidedError and
    CertificateError; MissingExtraError if the extra is not installed.

    Reference: Boyd, El Ghaoui, Feron, Balakrishnan 1994, chapter 2; Boyd, Vandenberghe 2004, section 5.9.

    >>> import numpy as np
    >>> a = np.array([[0.0, 1.0], [-2.0, -3.0]])
    >>> stable = MatrixInequalities("Lyapunov").positive("P", 2)
    >>> stable = stable.below("A'P + PA", lambda v: a.T @ v.P + v.P @ a)
    >>> solution = stable.solve(minimise=lambda v: np.trace(v.P))
    >>> bool(np.linalg.eigvalsh(a.T @ solution.values["P"] + solution.values["P"] @ a).max() < 0)
    True
    >>> stable.check({"P": np.eye(2)})
    Traceback (most recent call last):
    pointpred.errors.CertificateError: Lyapunov: A'P + PA has the eigenvalue 0.162278, must lie below 0
    """

    def solve(self, *, minimise: Block | None = None, solver: str = "CLARABEL") -> Solution:
        """Matrices with margins, and with the least ``minimise(v)`` if passed.

        Raises InfeasibleError, UndecidedError or CertificateError if no solution passes the audit.
        """
        if not self.blocks:
            raise ParameterError(f"{self.name}: needs at least one inequality, received none")
        problem, scales = self._numbers(minimise)
        if minimise is not None:
            best = run(problem, solver=solver, margin=self.margin)
            solution = self._audit(best, scales, minimise)
            if solution is not None:
                return solution
        answer = run(problem, solver=solver, margin=None)
        solution = self._audit(answer, scales, None)
        if solution is not None:
            return solution
        reached, worst = self._reached(answer, scales)
        need = f"{self.name}: a margin of {self.margin:g} (relative, kappa {self.kappa:g}) is needed"
        if answer.bound < self.margin:
            raise InfeasibleError(f"{need}, no choice reaches more than {answer.bound:.3g}")
        if answer.status == "optimal" and answer.claimed >= self.margin:
            raise CertificateError(
                f"{need}, the solver claims {answer.claimed:.3g}, its matrices have {reached:.3g} at {worst}"
            )
        raise UndecidedError(
            f"{need}, the solver reached {reached:.3g} and proves only that none exceeds {answer.bound:.3g} "
            f"(its status: {answer.status})"
        )

    def _numbers(self, minimise: Block | None) -> tuple[Affine, dict[str, float]]:
        """The problem as numbers, and the scale of each inequality."""
        strict, bounds, scales = [], [], {}
        for name, block in self.blocks.items():
            pair, scales[name] = scaled(*self.unknowns.coefficients(name, block))
            strict.append(pair)
        for name, rows in self._normal.items():
            constant, slopes = self.unknowns.coefficients(name, attrgetter(name))
            bounds += [
                (np.eye(rows) - constant, -slopes),
                ((constant - self.kappa * np.eye(rows)) / self.kappa, slopes / self.kappa),
            ]
        objective = None
        if minimise is not None:
            objective = self.unknowns.coefficients("the objective", minimise)[1].reshape(-1)
        x0, basis = self.unknowns.equalities(self._equalities)
        lows = np.maximum(self.unknowns.lows(), -self.kappa)
        return Affine(strict, bounds, x0, basis, lows, np.full(len(lows), self.kappa), objective), scales

    def _audit(self, answer: Answer, scales: dict[str, float], minimise: Block | None) -> Solution | None:
        """The answer as a solution, if its recomputed eigenvalues keep half the margin."""
        if answer.numbers is None or self._reached(answer, scales)[0] < 0.5 * self.margin:
            return None
        values = vars(self.unknowns.matrices(answer.numbers))
        margins = self.margins(values)
        if min(margins.values()) < 0.0:
            return None
        least = None if minimise is None else float(minimise(self.unknowns.matrices(answer.numbers)))
        return Solution(values, margins, least)

    def _reached(self, answer: Answer, scales: dict[str, float]) -> tuple[float, str]:
        """The least recomputed margin, relative to the scale of its inequality, and the name of that one."""
        if answer.numbers is None:
            return -np.inf, "no matrices"
        margins = self.margins(vars(self.unknowns.matrices(answer.numbers)))
        return min((margins[name] / scale, name) for name, scale in scales.items())


def check(
    printed: Mapping[str, Any], theorem: MatrixInequalities, *, rounding: float = 0.0
) -> dict[str, float]:
    """The margins of published matrices, as from ``theorem.check``; raises CertificateError.

    >>> decay = MatrixInequalities("decay").positive("P", 1).below("-2 P", lambda v: -2.0 * v.P)
    >>> check({"P": 3.0}, decay)
    {'P > 0': 3.0, '-2 P': 6.0}
    """
    return theorem.check(printed, rounding=rounding)
