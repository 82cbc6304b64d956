"""Linear matrix inequalities: the only interface to a solver, and the audit of matrices from any source.

A solver's answer is never a certificate. Its matrices are audited: the numpy functions of the problem are
evaluated at them and the eigenvalues recomputed. A problem is infeasible only if the solver's multipliers,
recomputed as well, exclude every choice. Else there is none below kappa, or it is undecided. A least
objective comes with the distance from a bound that the multipliers prove.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter, itemgetter
from typing import Any, Self

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
from pointpred_observers.numerics.equalities import allowed, or_one
from pointpred_observers.proofs.bounds import LEAST_POSITIVE, least
from pointpred_observers.proofs.solver import (
    ENTIRE,
    PATIENT,
    Affine,
    Answer,
    answered,
    capped,
    least_objective,
    reach,
    relaxing,
    released,
    scaled,
)
from pointpred_observers.proofs.unknowns import Block, Unknown, Unknowns, symmetric

KAPPA = 1e12
"""Largest condition number of a matrix that is declared positive."""
MARGIN = 1e-5
"""By which a solver is to satisfy an inequality, relative to its largest coefficient."""
WEAK = 1e-12
"""An inequality that need not be strict may fail by this share of its terms."""
EASY = 1e8
"""Up to this kappa a solution is sought first, and this is how far the bound of an objective is proved."""
LOOSER = 10.0
"""Where nothing is decided, a proof is sought with so many times kappa: its multipliers may reach further."""
BEST = 5
"""Where no proof reaches far enough, so many of those that reach farthest are corrected in more steps."""
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


class MatrixInequalities:
    """Linear matrix inequalities and equalities, the search for matrices that satisfy them, and their audit.

    Assumes strict inequalities: one that can only hold with equality is infeasible here. Meant for dense
    problems of some hundred numbers; sparsity is not used.

    Each inequality reads block(v) < 0, where v holds the matrices; a search asks for a margin, -1e-5 s I with
    s the largest coefficient of the block. A matrix declared ``positive`` lies between I and kappa I, kappa =
    1e12, other numbers have no such bound. ``Solution`` says what ``margins`` and ``gap`` are. A refusal is
    proved for P up to the condition number that its message names, in the units of the matrices that were
    passed, which the designs of this package balance first.

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

    def __init__(self, name: str) -> None:
        self.name = name
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
        """Require block(v) < 0; if not ``strict``, ``check`` accepts 0, to 1e-12 of the largest term."""
        if name in self.blocks:
            raise ParameterError(f"an inequality needs a new name, received {name!r}")
        self.blocks[name] = block
        if not strict:
            self._weak.add(name)
        return self

    def above(self, name: str, block: Block, *, strict: bool = True) -> Self:
        """Require block(v) > 0; if not ``strict``, ``check`` accepts an eigenvalue of 0."""
        self._above.add(name)
        return self.below(name, lambda v: -np.asarray(block(v)), strict=strict)

    def equal(self, name: str, block: Block) -> Self:
        """Require block(v) = 0 for a block of any shape; solved exactly before any solver runs.

        ``check`` accepts a residual of 1e-9 of its own terms.
        """
        self._equalities[name] = block
        return self

    def margins(self, values: Mapping[str, Any]) -> dict[str, float]:
        """How far each inequality's nearest eigenvalue lies on the right side; negative if it fails."""
        return {name: margin for name, (margin, _) in self._audited(values).items()}

    def check(
        self, values: Mapping[str, Any], *, rounding: float = 0.0, printed: bool = True
    ) -> dict[str, float]:
        """The margins of matrices from any source, such as a publication; raises CertificateError.

        ``rounding`` is the largest error of a printed entry: the message says whether it could explain it.
        Where they are ``printed``, an inequality that need not be strict may fail by 1e-12 of its terms;
        else every inequality must hold by more than rounding, so that every margin is above 0.
        """
        audited = self._audited(values)
        edge = WEAK if printed else None
        failed = [name for name, one in audited.items() if not self._holds(name, *one, edge)]
        margins = {name: margin for name, (margin, _) in audited.items()}
        if failed:
            reasons = "; ".join(self._failure(name, *audited[name]) for name in failed)
            raise CertificateError(
                f"{self.name}: {reasons}{self._excuse(margins, rounding)}",
                field=failed[0],
                value=margins[failed[0]],
            )
        return margins

    def _audited(self, values: Mapping[str, Any]) -> dict[str, tuple[float, float | None]]:
        """Of each inequality its margin and, of one of matrices, the least eigenvalue in units of its terms.

        Entries off the diagonal may be small differences of larger terms, whose rounding counts as well.
        """
        numbers = self.unknowns.numbers(dict(values))
        named = self.unknowns.matrices(numbers)
        audited: dict[str, tuple[float, float | None]] = {}
        for name in self._normal:
            audited[f"{name} > 0"] = least(getattr(named, name))
        for one in self.unknowns.listed:
            if one.low > -np.inf:
                entries = one.numbers(getattr(named, one.name)) - one.low
                audited[f"{one.name} >= {one.low:g}"] = float(entries.min(initial=np.inf)), None
        for name, block in self.blocks.items():
            terms = self.unknowns.sizes(name, block, numbers)
            sizes = np.diag(terms)
            value, relative = least(-symmetric(name, block(named)), sizes)
            d = 1.0 / np.sqrt(or_one(sizes))
            audited[name] = value, relative / max(1.0, float(np.linalg.norm(terms * d * d[:, None], 2)))
        for name, block in self._equalities.items():
            left, terms = self.unknowns.equality(name, block, numbers)
            audited[name] = float((allowed(terms) - np.abs(left)).min(initial=np.inf)), None
        return audited

    def _holds(self, name: str, margin: float, share: float | None, edge: float | None) -> bool:
        """Whether an inequality holds by more than rounding.

        One that need not be strict may also lie within ``edge`` of equality, a share of its terms: 0 for a
        search, which may begin there, WEAK for a print. An answer of a solver has no such room: gains of 1e12
        would turn it into a violation.
        """
        if share is None:
            return margin >= 0.0
        return share > LEAST_POSITIVE or (edge is not None and name in self._weak and abs(share) <= edge)

    def _failure(self, name: str, margin: float, share: float | None) -> str:
        above = name in self._above
        if share is not None and margin > 0.0:
            value = margin if above or name not in self.blocks else -margin
            return (
                f"{name} has the eigenvalue {value:.6g}, which is {share:.1g} of its terms: that may be "
                f"rounding, more than {LEAST_POSITIVE:g} is needed"
            )
        if name in self.blocks:
            value, side = (margin, "above") if above else (-margin, "below")
            return f"{name} has the eigenvalue {value:.6g}, must lie {side} 0"
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
        certain = any(-margin > moved.get(name, rounding) for name, margin in margins.items())
        return f"; entries rounded by {rounding:g} {'cannot' if certain else 'could'} explain it"

    def _add(self, name: str, kind: str, rows: int, columns: int, low: float = -np.inf) -> Self:
        self.unknowns.add(Unknown(name, kind, rows, columns, low))
        return self

    def solve(self, *, minimise: Block | None = None, near: Mapping[str, Any] | None = None) -> Solution:
        """Matrices with margins, and with the least ``minimise(v)`` if passed.

        ``near``: matrices by name where the search goes on if its first attempt fails; any will do.
        Raises InfeasibleError, UndecidedError or CertificateError if no solution passes the audit.
        """
        if not self.blocks:
            raise ParameterError(f"{self.name}: needs at least one inequality, received none")
        if minimise is None:
            return self._solution(self._search(None, near)[0])
        best = self._minimum(self._numbers(minimise, EASY), minimise, None)
        if best is None:
            numbers, problem = self._search(minimise, near)
            best = self._minimum(problem, minimise, numbers)
        assert best is not None
        return best

    def _minimum(self, problem: Affine, minimise: Block, start: FloatArray | None) -> Solution | None:
        """The solution of the least objective, if any; ``start`` satisfies the inequalities."""

        def value(numbers: FloatArray | None) -> float:
            return np.inf if numbers is None else float(minimise(self.unknowns.matrices(numbers)))

        def smaller(answer: Answer) -> FloatArray | None:
            found = answer.numbers
            passes = found is not None and self._passes(found) and value(found) < value(best)
            return found if passes else best

        bound, best, near = -np.inf, start, start
        for share in FINER:
            answer = answered(problem, share * MARGIN, near)
            best = smaller(answer)
            if best is not None:
                least = value(best)
                enough = least - GAP * abs(least)
                bound = max(bound, least_objective(problem, answer.multipliers, EASY, enough))
                if _gap(least, bound) <= GAP:
                    break
            elif answer.numbers is None:
                return None
            near = answer.numbers if best is None else best  # wrong, but of the right size
        if best is None:
            return None
        if _gap(value(best), bound) > WIDE:
            # A smaller objective by bisection, for a minimum at which the solver stalls.
            low = bound
            for _ in range(HALVINGS):
                high = value(best)
                if high <= 0.0 or _gap(high, low) <= GAP:
                    break
                cap = np.sqrt(low * high) if low > 1e-6 * high else 1e-3 * high
                for near in (best, None):
                    best = smaller(answered(capped(problem, cap), None, near))
                    if value(best) < high:
                        break
                else:
                    low = cap
            answer = answered(problem, FINER[1] * MARGIN, best)
            best = smaller(answer)
            bound = max(bound, least_objective(problem, answer.multipliers, EASY))
        assert best is not None
        return self._solution(best, value(best), _gap(value(best), bound))

    def _search(self, minimise: Block | None, near: Mapping[str, Any] | None) -> tuple[FloatArray, Affine]:
        """Numbers that satisfy the inequalities, and the problem whose kappa they keep; raises if none do.

        Numbers that only relax the inequalities are as large as needed. The first attempt is in the units of
        the problem, the next in those scaled to ``near``, each further one in those of the last answer.
        """
        start = None if near is None else self.unknowns.numbers(dict(near))
        proofs: list[tuple[float, Affine, Answer]] = []
        for kappa in (EASY, KAPPA, LOOSER * KAPPA):
            problem = self._numbers(minimise, kappa)
            free = relaxing(problem)
            posed = released(problem, free)
            scale: FloatArray | None = None
            last: FloatArray | None = None
            for turn in range(TURNS):
                answer = answered(posed, None, scale)
                for one in (answer.numbers, start if turn == 0 else None):
                    passing = None if one is None else self._relaxed(problem, one, free)
                    if passing is not None and kappa <= KAPPA:
                        return passing, problem
                proofs.append((reach(posed, answer.multipliers), posed, answer))
                # Where the start of the caller leads nowhere, the first answer may.
                last = answer.numbers if answer.numbers is not None or turn > 1 else last
                scale = start if turn == 0 and start is not None else last
                if proofs[-1][0] >= ENTIRE or scale is None:
                    break
            if proofs[-1][0] >= ENTIRE:
                break
        best = sorted(proofs, key=itemgetter(0))[-BEST:]
        extent = best[-1][0]
        for _, posed, answer in reversed(best):
            if extent < ENTIRE:
                extent = max(extent, reach(posed, answer.multipliers, PATIENT))
        raise self._refusal(extent, best[-1][2])

    def _relaxed(self, problem: Affine, numbers: FloatArray, free: list[int]) -> FloatArray | None:
        """The numbers with those of ``free`` large enough to pass the audit, if any are."""
        numbers, size = numbers.copy(), 1.0
        while size < (LARGEST if free else 2.0):
            numbers[free] = np.maximum(problem.lows[free], size)
            if self._passes(numbers):
                return numbers
            size *= 2.0
        return None

    def _refusal(self, extent: float, answer: Answer) -> PointpredError:
        """What the multipliers of a problem without solution prove."""
        if extent >= ENTIRE:
            return InfeasibleError(
                f"{self.name}: no choice satisfies the inequalities in the units of the search, proved for P "
                f"with a condition number up to {extent:.1g}"
            )
        need = f"{self.name}: a margin of {MARGIN:g} (relative) is needed"
        if extent >= SMALL:
            return UndecidedError(
                f"{need}, no P with a condition number below {extent:.1g} allows one: require less decay"
            )
        if answer.status == "optimal" and answer.claimed >= MARGIN and answer.numbers is not None:
            margins = self.margins(vars(self.unknowns.matrices(answer.numbers)))
            name = min(margins, key=lambda one: margins[one])
            return CertificateError(
                f"{need}, the solver claims {answer.claimed:.3g}, its matrices fail: {name} has "
                f"{-margins[name]:.3g}"
            )
        return UndecidedError(f"{need}, the solver proves nothing (its status: {answer.status})")

    def _numbers(self, minimise: Block | None, kappa: float) -> Affine:
        """The problem as numbers, with P below ``kappa`` I."""
        strict, floors, caps, positive, listed = [], [], [], [], self.unknowns.listed
        for name, block in self.blocks.items():
            constant, slopes = self.unknowns.coefficients(name, block)
            if constant.size:
                strict.append(scaled(constant, slopes))
        for name, rows in self._normal.items():
            constant, slopes = self.unknowns.coefficients(name, attrgetter(name))
            floors.append((np.eye(rows) - constant, -slopes))
            caps.append(((constant - kappa * np.eye(rows)) / kappa, slopes / kappa))
            at = next(at for one, at in listed.items() if one.name == name)
            positive.append((at.start, rows))
        objective = None
        if minimise is not None:
            objective = self.unknowns.coefficients("the objective", minimise)[1].reshape(-1)
        x0, basis = self.unknowns.equalities(self._equalities)
        blocks = [*strict, *floors, *caps]
        lows = np.concatenate([np.full(at.stop - at.start, one.low) for one, at in listed.items()])
        return Affine(blocks, len(strict), x0, basis, lows, objective, positive)

    def _passes(self, numbers: FloatArray) -> bool:
        """Whether numbers pass the audit; those whose rounding makes a block unsymmetric do not."""
        try:
            audited = self._audited(vars(self.unknowns.matrices(numbers)))
        except ParameterError:
            return False
        return all(self._holds(name, *one, edge=0.0) for name, one in audited.items())

    def _solution(
        self, numbers: FloatArray, objective: float | None = None, gap: float | None = None
    ) -> Solution:
        values = vars(self.unknowns.matrices(numbers))
        return Solution(values, self.margins(values), objective, gap)


def _gap(objective: float, bound: float) -> float:
    return float(max(0.0, objective - bound) / max(abs(objective), 1e-300))


def check(
    printed: Mapping[str, Any], theorem: MatrixInequalities, *, rounding: float = 0.0
) -> dict[str, float]:
    """The margins of published matrices, as from ``theorem.check``; raises CertificateError."""
    return theorem.check(printed, rounding=rounding)
