"""Linear matrix inequalities: the one door to a solver, and the audit that makes its answer a certificate.

What a solver says is never a certificate. Matrices it returns are put into the same numpy functions that the
problem was made of, and their eigenvalues are recomputed; "infeasible" is said only where the solver's
multipliers, recomputed as well, bound the margin that any choice can reach. Everything else is undecided.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter
from typing import Any, Self

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.observers.inequalities.solver import Affine, Answer, run, scaled
from pointpred.observers.inequalities.unknowns import Block, Unknown, Unknowns


class Solution(msgspec.Struct, frozen=True):
    """Matrices that satisfy every inequality: ``values`` by name, ``margins`` by inequality.

    A margin is the distance of the nearest eigenvalue from the wrong side, in the unit of the inequality.
    ``objective`` is what was minimised, ``None`` where nothing was or the best could not be reached.
    """

    values: dict[str, Any]
    margins: dict[str, float]
    objective: float | None


class MatrixInequalities:
    """Find matrices that satisfy linear matrix inequalities with room to spare.

    Assumes that strictness costs nothing: an inequality that can only hold with equality is infeasible here.
    Made for dense problems of some hundred numbers; nothing here uses sparsity.

    Each inequality reads block(v) <= -margin s I, where v holds the matrices and s is the largest coefficient
    of the block; a matrix declared ``positive`` lies between I and kappa I, any other number within +-kappa.

    Parameters: ``margin`` relative to s, (0, 1e-2]; ``kappa`` the largest eigenvalue and entry, [10, 1e8].
    Returns a ``Solution`` from ``solve``. Raises ParameterError, InfeasibleError, UndecidedError and
    CertificateError; MissingExtraError where the extra is not installed.

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

    def __init__(self, name: str, *, margin: float = 1e-5, kappa: float = 1e4) -> None:
        if not 0.0 < margin <= 1e-2:
            raise ParameterError(f"margin must lie in (0, 0.01], received {margin!r}")
        if not 10.0 <= kappa <= 1e8:
            raise ParameterError(f"kappa must lie in [10, 1e8], received {kappa!r}")
        self.name, self.margin, self.kappa = name, margin, kappa
        self.unknowns = Unknowns()
        self.blocks: dict[str, Block] = {}
        self._normal: dict[str, int] = {}
        self._weak: set[str] = set()
        self._above: set[str] = set()
        self._equalities: dict[str, Block] = {}

    def positive(self, name: str, rows: int) -> Self:
        """A symmetric matrix between I and kappa I: the scale of the problem."""
        self._normal[name] = rows
        return self.symmetric(name, rows)

    def symmetric(self, name: str, rows: int) -> Self:
        """A symmetric matrix of any sign."""
        return self._add(name, "symmetric", rows, rows)

    def free(self, name: str, rows: int, columns: int) -> Self:
        """A matrix without structure."""
        return self._add(name, "free", rows, columns)

    def diagonal(self, name: str, rows: int) -> Self:
        """A diagonal matrix without negative entries."""
        return self._add(name, "diagonal", rows, rows, 0.0)

    def number(self, name: str, low: float = 0.0) -> Self:
        """One number not below ``low``; the functions receive it as a float."""
        return self._add(name, "number", 1, 1, low)

    def below(self, name: str, block: Block, *, strict: bool = True) -> Self:
        """Demand block(v) < 0; where not ``strict``, ``check`` accepts 0, to 1e-12 of the largest term."""
        if name in self.blocks:
            raise ParameterError(f"an inequality needs a new name, received {name!r}")
        self.blocks[name] = block
        if not strict:
            self._weak.add(name)
        return self

    def above(self, name: str, block: Block, *, strict: bool = True) -> Self:
        """Demand block(v) > 0; where it is not ``strict``, ``check`` accepts an eigenvalue of 0."""
        self._above.add(name)
        return self.below(name, lambda v: -np.asarray(block(v)), strict=strict)

    def equal(self, name: str, block: Block) -> Self:
        """Demand block(v) = 0, whatever its shape; solved exactly before any solver runs."""
        self._equalities[name] = block
        return self

    def solve(self, *, minimise: Block | None = None, solver: str = "CLARABEL") -> Solution:
        """Matrices with margins, and with the least ``minimise(v)`` where one is given.

        Raises InfeasibleError, UndecidedError or CertificateError where there is no answer to stand on.
        """
        if not self.blocks:
            raise ParameterError(f"{self.name}: needs at least one inequality, received none")
        problem, scales = self._numbers(minimise)
        if minimise is not None:
            best = run(problem, solver=solver, margin=self.margin)
            solution = self._audited(best, scales, minimise)
            if solution is not None:
                return solution
        answer = run(problem, solver=solver, margin=None)
        solution = self._audited(answer, scales, None)
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

    def margins(self, values: Mapping[str, Any]) -> dict[str, float]:
        """How far each inequality's nearest eigenvalue lies on the right side; negative where it fails."""
        numbers = self.unknowns.numbers(dict(values))
        named = self.unknowns.matrices(numbers)
        found = {
            f"{name} > 0": float(np.linalg.eigvalsh(getattr(named, name)).min()) for name in self._normal
        }
        for one in self.unknowns.listed:
            if one.low > -np.inf:
                entries = one.numbers(getattr(named, one.name)) - one.low
                found[f"{one.name} >= {one.low:g}"] = float(entries.min())
        for name, block in self.blocks.items():
            found[name] = -float(np.linalg.eigvalsh(self.unknowns.value(name, block, numbers)).max())
        for name, block in self._equalities.items():
            error = float(np.abs(np.asarray(block(named))).max())
            size = max(1.0, float(np.abs(numbers).max()))
            found[name] = 1e-8 * size - error
        return found

    def check(self, values: Mapping[str, Any], *, rounding: float = 0.0) -> dict[str, float]:
        """The margins of matrices that somebody prints; raises CertificateError where one fails.

        ``rounding`` is the largest error of a printed entry: the message says whether it could explain it.
        """
        margins = self.margins(values)
        failed = [
            self._failure(name, margin)
            for name, margin in margins.items()
            if not self._holds(name, margin, values)
        ]
        if failed:
            raise CertificateError(f"{self.name}: {'; '.join(failed)}{self._excuse(margins, rounding)}")
        return margins

    def _holds(self, name: str, margin: float, values: Mapping[str, Any]) -> bool:
        if name in self._weak:
            numbers = self.unknowns.numbers(dict(values))
            return margin >= -1e-12 * self.unknowns.size(name, self.blocks[name], numbers)
        return margin > 0.0 if name in self.blocks or name.endswith(" > 0") else margin >= 0.0

    def _failure(self, name: str, margin: float) -> str:
        if name in self._above:
            return f"{name} has the eigenvalue {margin:.6g}, must lie above 0"
        if name in self.blocks:
            return f"{name} has the eigenvalue {-margin:.6g}, must lie below 0"
        if name in self._equalities:
            return f"{name} fails by {-margin:.6g}"
        return f"{name} fails: its least value is {margin:.6g}"

    def _excuse(self, margins: dict[str, float], rounding: float) -> str:
        if rounding <= 0.0:
            return ""
        moved = {
            name: rounding * float(np.abs(np.linalg.eigvalsh(slopes)).max(axis=1).sum())
            for name, (_, slopes) in ((n, self.unknowns.coefficients(n, b)) for n, b in self.blocks.items())
        }
        sure = [name for name, margin in margins.items() if -margin > moved.get(name, rounding)]
        if sure:
            return f"; entries rounded by {rounding:g} cannot explain it"
        return f"; entries rounded by {rounding:g} could explain it"

    def _add(self, name: str, kind: str, rows: int, columns: int, low: float = -np.inf) -> Self:
        self.unknowns.add(Unknown(name, kind, rows, columns, low))
        return self

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

    def _audited(self, answer: Answer, scales: dict[str, float], minimise: Block | None) -> Solution | None:
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
    """The margins of matrices that somebody prints, as ``theorem.check`` gives them, or CertificateError.

    >>> decay = MatrixInequalities("decay").positive("P", 1).below("-2 P", lambda v: -2.0 * v.P)
    >>> check({"P": 3.0}, decay)
    {'P > 0': 3.0, '-2 P': 6.0}
    """
    return theorem.check(printed, rounding=rounding)
