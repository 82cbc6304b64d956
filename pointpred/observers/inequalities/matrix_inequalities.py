"""Linear matrix inequalities: the only interface to a solver.

A solver's answer is never a certificate. Its matrices are audited (``audit.py``): the numpy functions of the
problem are evaluated at them and the eigenvalues recomputed. A problem is infeasible only if the solver's
multipliers, recomputed as well (``proof.py``), exclude every choice. Otherwise there is none below kappa, or it is
undecided. A least objective comes with the distance from a bound that the multipliers prove.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter
from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.observers.inequalities.affine import Affine, relaxing, released, scaled
from pointpred.observers.inequalities.audit import Inequalities
from pointpred.observers.inequalities.proof import ENTIRE, largest_margin, least_objective, reach
from pointpred.observers.inequalities.rescaling import rescaled
from pointpred.observers.inequalities.solver import CAP, Answer, run
from pointpred.observers.inequalities.unknowns import Block

GAP = 1e-3
"""A relative distance from the proved bound at which the search for a smaller objective ends."""
FINER = (1.0, 1e-2, 1e-4)
"""Shares of the margin at which the objective is minimised, until the gap is small."""
TURNS = 4
"""How often a problem is posed again in coordinates scaled to its last answer."""
SMALL = 1e3
"""A proof up to a smaller condition number of P tells nothing."""
LARGEST = 1e30
"""Up to here a number that only relaxes the inequalities is doubled."""


class Solution(msgspec.Struct, frozen=True):
    """Matrices that satisfy every inequality: ``values`` by name, ``margins`` by inequality.

    A margin is the distance of the nearest eigenvalue from the wrong side, in the unit of the inequality.
    ``objective`` is what was minimised, ``None`` if nothing was. ``gap``: how far, relative to the objective, a
    smaller one could lie below it, by a bound that is recomputed from the multipliers for P below kappa I; infinite
    if nothing is proved, ``None`` if nothing was minimised.
    """

    values: dict[str, Any]
    margins: dict[str, float]
    objective: float | None = None
    gap: float | None = None


class MatrixInequalities(Inequalities):
    """Find matrices that satisfy linear matrix inequalities with a margin.

    Assumes strict inequalities: one that can only hold with equality is infeasible here. Meant for dense
    problems of some hundred numbers; sparsity is not used.

    Each inequality reads block(v) <= -margin s I, where v holds the matrices and s is the largest coefficient
    of the block; a matrix declared ``positive`` lies between I and kappa I, other numbers have no upper bound.

    Parameters: ``margin`` relative to s, (0, 1e-2]; ``kappa`` the largest eigenvalue, [10, 1e8].
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
        problem = self._numbers(minimise)
        best = None if minimise is None else self._least_objective(problem, minimise, solver)
        if best is not None and best.gap is not None and best.gap <= GAP:
            return best
        found, answer = (None, None) if best is not None else self._feasible(problem, solver)
        if found is not None and minimise is not None:
            best = self._least_objective(problem, minimise, solver, found) or self._solution(
                found, minimise, np.inf
            )
        elif found is not None:
            best = self._solution(found, None, None)
        if best is None:
            assert answer is not None
            self._refuse(problem, answer)
            raise AssertionError
        return best

    def _least_objective(
        self, problem: Affine, minimise: Block, solver: str, start: FloatArray | None = None
    ) -> Solution | None:
        """The audited solution of the least objective, if any; from ``start``, whose numbers set the scale."""
        best: Solution | None = None
        bound, numbers = -np.inf, start
        for share in FINER:
            answer = self._run(problem, solver, share * self.margin, numbers)
            bound = max(bound, least_objective(problem, answer.multipliers, self.kappa))
            found = answer.numbers
            if found is not None and self._passes(found):
                solution = self._solution(found, minimise, None)
                if best is None or solution.objective < best.objective:  # type: ignore[operator]
                    best, numbers = solution, found
            if best is None:
                if start is None:
                    return None
                continue
            best = self._with_gap(best, bound)
            if best.gap is not None and best.gap <= GAP:
                break
        return best

    @staticmethod
    def _with_gap(solution: Solution, bound: float) -> Solution:
        objective = solution.objective or 0.0
        gap = max(0.0, objective - bound) / max(abs(objective), 1e-300)
        return msgspec.structs.replace(solution, gap=gap)

    def _feasible(self, problem: Affine, solver: str) -> tuple[FloatArray | None, Answer]:
        """Numbers that satisfy the inequalities, if any; those that only relax them are as large as needed."""
        free = relaxing(problem)
        posed = released(problem, free)
        answers: list[Answer] = []
        for _ in range(TURNS):
            answers.append(self._run(posed, solver, None, answers[-1].numbers if answers else None))
            numbers = answers[-1].numbers
            passing = None if numbers is None else self._relaxed(problem, numbers, free)
            if passing is not None or numbers is None or reach(posed, answers[-1].multipliers) >= ENTIRE:
                return passing, answers[-1]
        return None, max(answers, key=lambda one: reach(posed, one.multipliers))

    @staticmethod
    def _run(problem: Affine, solver: str, margin: float | None, near: FloatArray | None) -> Answer:
        """The solver's answer, in coordinates scaled to the numbers ``near`` if given."""
        if near is None:
            return run(problem, solver=solver, margin=margin)
        other = rescaled(problem, near)
        answer = run(other.problem, solver=solver, margin=margin)
        numbers = None if answer.numbers is None else other.numbers(answer.numbers)
        return msgspec.structs.replace(
            answer, numbers=numbers, multipliers=other.multipliers(answer.multipliers)
        )

    def _relaxed(self, problem: Affine, numbers: FloatArray, free: list[int]) -> FloatArray | None:
        """The numbers with those of ``free`` large enough to pass the audit, if any are."""
        size = 1.0
        while size < (LARGEST if free else 2.0):
            numbers[free] = np.maximum(problem.lows[free], size)
            if self._passes(numbers):
                return numbers
            size *= 2.0
        return None

    def _refuse(self, problem: Affine, answer: Answer) -> None:
        """Raise what the multipliers of a problem without solution prove."""
        posed = released(problem, relaxing(problem))
        extent = reach(posed, answer.multipliers)
        if extent >= ENTIRE:
            raise InfeasibleError(
                f"{self.name}: no choice satisfies the inequalities, proved for every P with a condition number up "
                f"to {extent:.1g}"
            )
        bound = largest_margin(posed, answer.multipliers, self.kappa, most=CAP)
        need = f"{self.name}: a margin of {self.margin:g} (relative) is needed"
        most = self.kappa if bound < self.margin else extent
        if most >= SMALL:
            raise UndecidedError(
                f"{need}, no P with a condition number below {most:.1g} allows one: raise kappa (it is "
                f"{self.kappa:g}), or require less decay"
            )
        if answer.status == "optimal" and answer.claimed >= self.margin:
            raise CertificateError(
                f"{need}, the solver claims {answer.claimed:.3g}, its matrices fail: {self._worst(answer)}"
            )
        raise UndecidedError(
            f"{need}, the solver proves only that none exceeds {bound:.3g} (its status: {answer.status})"
        )

    def _worst(self, answer: Answer) -> str:
        if answer.numbers is None:
            return "there are none"
        margins = self.margins(vars(self.unknowns.matrices(answer.numbers)))
        name = min(margins, key=lambda one: margins[one])
        return f"{name} has {-margins[name]:.3g}"

    def _numbers(self, minimise: Block | None) -> Affine:
        """The problem as numbers."""
        strict, floors, caps, positive = [], [], [], []
        for name, block in self.blocks.items():
            strict.append(scaled(*self.unknowns.coefficients(name, block))[0])
        for name, rows in self._normal.items():
            constant, slopes = self.unknowns.coefficients(name, attrgetter(name))
            floors.append((np.eye(rows) - constant, -slopes))
            caps.append(((constant - self.kappa * np.eye(rows)) / self.kappa, slopes / self.kappa))
            positive.append((self.unknowns.place(name), rows))
        objective = None
        if minimise is not None:
            objective = self.unknowns.coefficients("the objective", minimise)[1].reshape(-1)
        x0, basis = self.unknowns.equalities(self._equalities)
        return Affine(strict, floors, caps, x0, basis, self.unknowns.lows(), objective, positive)

    def _passes(self, numbers: FloatArray) -> bool:
        """Whether numbers pass the audit."""
        values = vars(self.unknowns.matrices(numbers))
        margins = self.margins(values)
        return all(self._holds(name, margin, values) for name, margin in margins.items())

    def _solution(self, numbers: FloatArray, minimise: Block | None, gap: float | None) -> Solution:
        named = self.unknowns.matrices(numbers)
        objective = None if minimise is None else float(minimise(named))
        return Solution(vars(named), self.margins(vars(named)), objective, gap)


def check(
    printed: Mapping[str, Any], theorem: MatrixInequalities, *, rounding: float = 0.0
) -> dict[str, float]:
    """The margins of published matrices, as from ``theorem.check``; raises CertificateError.

    >>> decay = MatrixInequalities("decay").positive("P", 1).below("-2 P", lambda v: -2.0 * v.P)
    >>> check({"P": 3.0}, decay)
    {'P > 0': 3.0, '-2 P': 6.0}
    """
    return theorem.check(printed, rounding=rounding)
