"""Linear matrix inequalities: the only interface to a solver.

A solver's answer is never a certificate. Its matrices are audited (``audit.py``): the numpy functions of the
problem are evaluated at them and the eigenvalues recomputed. A problem is infeasible only if the solver's
multipliers, recomputed as well (``proof.py``), exclude every choice. Else there is none below kappa, or it
is undecided. A least objective comes with the distance from a bound that the multipliers prove.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import (
    CertificateError,
    InfeasibleError,
    ParameterError,
    PointpredError,
    UndecidedError,
)
from pointpred.records import FloatArray
from pointpred_observers.proofs.affine import (
    ENTIRE,
    Affine,
    capped,
    largest_margin,
    least_objective,
    reach,
    relaxing,
    released,
    scaled,
)
from pointpred_observers.proofs.audit import Inequalities
from pointpred_observers.proofs.solver import CAP, Answer, rescaled, run
from pointpred_observers.proofs.unknowns import Block

EASY = 1e8
"""Up to this kappa a solution is sought first, and this is how far the bound of an objective is proved."""
LOOSER = 10.0
"""Where nothing is decided, a proof is sought with so many times kappa: its multipliers may reach further."""
GAP = 1e-3
"""A relative distance from the proved bound at which the search for a smaller objective ends."""
FINER = (1.0, 1e-2, 1e-4)
"""Shares of the margin at which the objective is minimised, until the gap is small."""
WIDE = 0.1
"""From this gap on a smaller objective is sought by bisection."""
HALVINGS = 8
"""Most steps of it."""
TURNS = 10
"""How often a problem is posed again in coordinates scaled to its last answer."""
SMALL = 1e3
"""A proof up to a smaller condition number of P tells nothing."""
LARGEST = 1e30
"""Up to here a number that only relaxes the inequalities is doubled."""


class Solution(msgspec.Struct, frozen=True):
    """Matrices that satisfy every inequality: ``values`` by name, ``margins`` by inequality.

    A margin is the distance of the nearest eigenvalue from the wrong side, in the unit of the inequality.
    ``objective`` is what was minimised, ``None`` if nothing was. ``gap``: how far, relative to the objective,
    the least one could lie below it, by a bound that is recomputed from the multipliers for P below 1e8 I;
    infinite if nothing is proved, ``None`` if nothing was minimised.
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
    of the block; a matrix declared ``positive`` lies between I and kappa I, other numbers have no such bound.
    A refusal is proved for P up to the condition number that its message names, in the units of the matrices
    that were passed, which the designs and certificates of this package balance first.

    Parameters: ``margin`` relative to s, (0, 1e-2]; ``kappa`` the largest eigenvalue of such a matrix,
    [10, 1e14].
    Returns a ``Solution`` from ``solve``. Raises ParameterError, InfeasibleError, UndecidedError and
    CertificateError.

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

    def solve(
        self,
        *,
        minimise: Block | None = None,
        near: Mapping[str, Any] | None = None,
    ) -> Solution:
        """Matrices with margins, and with the least ``minimise(v)`` if passed.

        ``near``: matrices by name where the search goes on if its first attempt fails; any will do.
        Raises InfeasibleError, UndecidedError or CertificateError if no solution passes the audit.
        """
        if not self.blocks:
            raise ParameterError(f"{self.name}: needs at least one inequality, received none")
        if minimise is None:
            return self._solution(self._search(None, near)[0], None, None)
        best = self._minimum(self._numbers(minimise, min(self.kappa, EASY)), minimise)
        if best is not None:
            return best
        numbers, problem = self._search(minimise, near)
        start = self._solution(numbers, minimise, np.inf)
        return self._minimum(problem, minimise, (start, numbers)) or start

    def _minimum(
        self,
        problem: Affine,
        minimise: Block,
        start: tuple[Solution, FloatArray] | None = None,
    ) -> Solution | None:
        """The solution of the least objective, if any; the numbers of ``start`` set the scale."""
        best, numbers = (None, None) if start is None else start
        bound, limit = -np.inf, min(self.kappa, EASY)
        for share in FINER:
            answer = self._run(problem, share * self.margin, numbers)
            best, numbers = self._smaller(answer, minimise, best, numbers)
            if best is None:
                if answer.numbers is None:
                    return None
                numbers = answer.numbers  # wrong, but of the right size
                continue
            least = _value(best)
            bound = max(bound, least_objective(problem, answer.multipliers, limit, least - GAP * abs(least)))
            best = msgspec.structs.replace(best, gap=_gap(least, bound))
            if _gap(least, bound) <= GAP:
                break
        if best is None or numbers is None or _gap(_value(best), bound) <= WIDE:
            return best
        # A smaller objective by bisection, for a minimum at which the solver stalls.
        low = bound
        for _ in range(HALVINGS):
            high = _value(best)
            if high <= 0.0 or _gap(high, low) <= GAP:
                break
            cap = np.sqrt(low * high) if low > 1e-6 * high else 1e-3 * high
            for near in (numbers, None):
                answer = self._run(capped(problem, cap), None, near)
                best, numbers = self._smaller(answer, minimise, best, numbers)
                if _value(best) < high:
                    break
            else:
                low = cap
        answer = self._run(problem, FINER[1] * self.margin, numbers)
        best, _ = self._smaller(answer, minimise, best, numbers)
        bound = max(bound, least_objective(problem, answer.multipliers, limit))
        least_found: Solution = msgspec.structs.replace(best, gap=_gap(_value(best), bound))
        return least_found

    def _smaller(
        self, answer: Answer, minimise: Block, best: Any, numbers: FloatArray | None
    ) -> tuple[Any, FloatArray | None]:
        """The solution and the numbers of an answer if it passes and is smaller than ``best``, else those."""
        if answer.numbers is not None and self._passes(answer.numbers):
            solution = self._solution(answer.numbers, minimise, np.inf)
            if best is None or _value(solution) < _value(best):
                return solution, answer.numbers
        return best, numbers

    def _search(self, minimise: Block | None, near: Mapping[str, Any] | None) -> tuple[FloatArray, Affine]:
        """Numbers that satisfy the inequalities, and the problem whose kappa they keep; raises if none do."""
        start = None if near is None else self.unknowns.numbers(dict(near))
        most: tuple[float, Affine, Answer, float] | None = None
        for kappa in sorted({min(self.kappa, EASY), self.kappa, LOOSER * self.kappa}):
            problem = self._numbers(minimise, kappa)
            numbers, answer, extent = self._feasible(problem, start)
            if numbers is not None and kappa <= self.kappa:
                return numbers, problem
            if most is None or extent > most[0]:
                most = extent, problem, answer, kappa
            if extent >= ENTIRE:
                break
        assert most is not None
        raise self._refusal(*most)

    def _feasible(self, problem: Affine, start: FloatArray | None) -> tuple[FloatArray | None, Answer, float]:
        """Numbers that satisfy the inequalities, if any, the answer that proves most, and how far it does.

        Numbers that only relax the inequalities are as large as needed. The first attempt is in the units
        of the problem, the next in those scaled to ``start``, each further one in those scaled to the last
        answer.
        """
        free = relaxing(problem)
        posed = released(problem, free)
        most: tuple[float, Answer] | None = None
        near: FloatArray | None = None
        last: FloatArray | None = None
        for turn in range(TURNS):
            answer = self._run(posed, None, near)
            numbers = answer.numbers
            for one in (numbers, start if turn == 0 else None):
                passing = None if one is None else self._relaxed(problem, one, free)
                if passing is not None:
                    return passing, answer, 0.0
            # Where the start of the caller leads nowhere, the first answer may.
            last = numbers if numbers is not None or turn > 1 else last
            near = start if turn == 0 and start is not None else last
            proved = reach(posed, answer.multipliers)
            if most is None or proved > most[0]:
                most = proved, answer
            if proved >= ENTIRE or near is None:
                break
        assert most is not None
        return None, most[1], most[0]

    @staticmethod
    def _run(problem: Affine, margin: float | None, near: FloatArray | None) -> Answer:
        """The solver's answer, in coordinates scaled to the numbers ``near`` if given."""
        if near is None:
            return run(problem, margin=margin)
        other = rescaled(problem, near)
        answer = run(other.problem, margin=margin)
        numbers = None if answer.numbers is None else other.numbers(answer.numbers)
        return msgspec.structs.replace(
            answer, numbers=numbers, multipliers=other.multipliers(answer.multipliers)
        )

    def _relaxed(self, problem: Affine, numbers: FloatArray, free: list[int]) -> FloatArray | None:
        """The numbers with those of ``free`` large enough to pass the audit, if any are."""
        numbers, size = numbers.copy(), 1.0
        while size < (LARGEST if free else 2.0):
            numbers[free] = np.maximum(problem.lows[free], size)
            if self._passes(numbers):
                return numbers
            size *= 2.0
        return None

    def _refusal(self, extent: float, problem: Affine, answer: Answer, kappa: float) -> PointpredError:
        """What the multipliers of a problem without solution prove."""
        posed = released(problem, relaxing(problem))
        if extent >= ENTIRE:
            return InfeasibleError(
                f"{self.name}: no choice satisfies the inequalities in the units of the search, proved for P "
                f"with a condition number up to {extent:.1g}"
            )
        bound = largest_margin(posed, answer.multipliers, kappa, most=CAP)
        need = f"{self.name}: a margin of {self.margin:g} (relative) is needed"
        most = kappa if bound < self.margin else extent
        if most >= SMALL:
            return UndecidedError(
                f"{need}, no P with a condition number below {most:.1g} allows one: require less decay"
            )
        if answer.status == "optimal" and answer.claimed >= self.margin:
            return CertificateError(
                f"{need}, the solver claims {answer.claimed:.3g}, its matrices fail: {self._worst(answer)}"
            )
        proved = f"only that none exceeds {bound:.3g}" if np.isfinite(bound) else "nothing"
        return UndecidedError(f"{need}, the solver proves {proved} (its status: {answer.status})")

    def _worst(self, answer: Answer) -> str:
        if answer.numbers is None:
            return "there are none"
        margins = self.margins(vars(self.unknowns.matrices(answer.numbers)))
        name = min(margins, key=lambda one: margins[one])
        return f"{name} has {-margins[name]:.3g}"

    def _numbers(self, minimise: Block | None, kappa: float) -> Affine:
        """The problem as numbers, with P below ``kappa`` I."""
        strict, floors, caps, positive = [], [], [], []
        for name, block in self.blocks.items():
            constant, slopes = self.unknowns.coefficients(name, block)
            if constant.size:
                strict.append(scaled(constant, slopes)[0])
        for name, rows in self._normal.items():
            constant, slopes = self.unknowns.coefficients(name, attrgetter(name))
            floors.append((np.eye(rows) - constant, -slopes))
            caps.append(((constant - kappa * np.eye(rows)) / kappa, slopes / kappa))
            positive.append((self.unknowns.place(name), rows))
        objective = None
        if minimise is not None:
            objective = self.unknowns.coefficients("the objective", minimise)[1].reshape(-1)
        x0, basis = self.unknowns.equalities(self._equalities)
        return Affine(strict, floors, caps, x0, basis, self.unknowns.lows(), objective, positive)

    def _passes(self, numbers: FloatArray) -> bool:
        """Whether numbers pass the audit; those whose rounding makes a block unsymmetric do not."""
        values = vars(self.unknowns.matrices(numbers))
        try:
            margins = self.margins(values)
        except ParameterError:
            return False
        return all(self._holds(name, margin, values, edge=0.0) for name, margin in margins.items())

    def _solution(self, numbers: FloatArray, minimise: Block | None, gap: float | None) -> Solution:
        named = self.unknowns.matrices(numbers)
        objective = None if minimise is None else float(minimise(named))
        return Solution(vars(named), self.margins(vars(named)), objective, gap)


def _gap(objective: float, bound: float) -> float:
    return float(max(0.0, objective - bound) / max(abs(objective), 1e-300))


def _value(solution: Solution) -> float:
    return np.inf if solution.objective is None else solution.objective


def check(
    printed: Mapping[str, Any], theorem: MatrixInequalities, *, rounding: float = 0.0
) -> dict[str, float]:
    """The margins of published matrices, as from ``theorem.check``; raises CertificateError."""
    return theorem.check(printed, rounding=rounding)
