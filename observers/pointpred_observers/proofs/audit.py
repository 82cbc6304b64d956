"""The audit that turns matrices from any source into a certificate: every eigenvalue is recomputed.

The functions of a problem are evaluated at the matrices. Needs no solver.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Self

import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.equalities import allowed
from pointpred_observers.proofs.definite import LEAST_POSITIVE, least
from pointpred_observers.proofs.unknowns import Block, Unknown, Unknowns

KAPPA = 1e12
"""Largest condition number of a matrix that is declared positive."""
WEAK = 1e-12
"""An inequality that need not be strict may fail by this share of its terms."""


class Inequalities:
    """Linear matrix inequalities and equalities, and the audit of matrices against them.

    Each inequality reads block(v) < 0, where v holds the matrices.
    """

    def __init__(self, name: str, *, margin: float = 1e-5, kappa: float = KAPPA) -> None:
        for option, value in (("margin", margin), ("kappa", kappa)):
            if not is_number(value):
                raise ParameterError(
                    f"{option} must be a number, received {value!r}", field=option, value=value
                )
        if not 0.0 < margin <= 1e-2:
            raise ParameterError(
                f"margin must lie in (0, 0.01], received {margin!r}", field="margin", value=margin
            )
        if not 10.0 <= kappa <= 1e14:
            raise ParameterError(
                f"kappa must lie in [10, 1e14], received {kappa!r}", field="kappa", value=kappa
            )
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
        numbers = self.unknowns.numbers(dict(values))
        named = self.unknowns.matrices(numbers)
        margins = {f"{name} > 0": least(getattr(named, name))[0] for name in self._normal}
        for one in self.unknowns.listed:
            if one.low > -np.inf:
                entries = one.numbers(getattr(named, one.name)) - one.low
                margins[f"{one.name} >= {one.low:g}"] = float(entries.min(initial=np.inf))
        for name, block in self.blocks.items():
            margins[name] = self._least(name, block, numbers)[0]
        for name, block in self._equalities.items():
            left, terms = self.unknowns.equality(name, block, numbers)
            margins[name] = float((allowed(terms) - np.abs(left)).min(initial=np.inf))
        return margins

    def check(
        self, values: Mapping[str, Any], *, rounding: float = 0.0, printed: bool = True
    ) -> dict[str, float]:
        """The margins of matrices from any source, such as a publication; raises CertificateError.

        ``rounding`` is the largest error of a printed entry: the message says whether it could explain it.
        Where they are ``printed``, an inequality that need not be strict may fail by 1e-12 of its terms;
        else every inequality must hold by more than rounding, so that every margin is above 0.
        """
        margins = self.margins(values)
        edge = WEAK if printed else None
        failed = [
            name for name, margin in margins.items() if not self._holds(name, margin, values, edge=edge)
        ]
        if failed:
            reasons = "; ".join(self._failure(name, margins[name], values) for name in failed)
            raise CertificateError(
                f"{self.name}: {reasons}{self._excuse(margins, rounding)}",
                field=failed[0],
                value=margins[failed[0]],
            )
        return margins

    def _least(self, name: str, block: Block, numbers: FloatArray) -> tuple[float, float]:
        """The least eigenvalue of minus a block, and that in the units of its terms.

        Entries off the diagonal may be small differences of larger terms, whose rounding counts as well.
        """
        terms = self.unknowns.sizes(name, block, numbers)
        sizes = np.diag(terms)
        value, relative = least(-self.unknowns.value(name, block, numbers), sizes)
        d = 1.0 / np.sqrt(np.where(sizes > 0.0, sizes, 1.0))
        return value, relative / max(1.0, float(np.linalg.norm(terms * d * d[:, None], 2)))

    def _holds(
        self, name: str, margin: float, values: Mapping[str, Any], *, edge: float | None = None
    ) -> bool:
        """Whether an inequality holds by more than rounding.

        One that need not be strict may also lie within ``edge`` of equality, a share of its terms: 0 for a
        search, which may begin there, WEAK for a print. An answer of a solver has no such room: gains of 1e12
        would turn it into a violation.
        """
        relative = self._share(name, values)
        if relative is None:
            return margin >= 0.0
        if edge is not None and name in self._weak and abs(relative) <= edge:
            return True
        return relative > LEAST_POSITIVE

    def _share(self, name: str, values: Mapping[str, Any]) -> float | None:
        """The least eigenvalue of an inequality of matrices in the units of its terms; ``None`` of others."""
        numbers = self.unknowns.numbers(dict(values))
        if name in self.blocks:
            return self._least(name, self.blocks[name], numbers)[1]
        declared = name.removesuffix(" > 0")
        if name == declared or declared not in self._normal:
            return None
        return least(getattr(self.unknowns.matrices(numbers), declared))[1]

    def _failure(self, name: str, margin: float, values: Mapping[str, Any]) -> str:
        share = self._share(name, values)
        if share is not None and margin > 0.0:
            value = margin if name in self._above or name not in self.blocks else -margin
            return (
                f"{name} has the eigenvalue {value:.6g}, which is {share:.1g} of its terms: that may be "
                f"rounding, more than {LEAST_POSITIVE:g} is needed"
            )
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
        certain = [name for name, margin in margins.items() if -margin > moved.get(name, rounding)]
        if certain:
            return f"; entries rounded by {rounding:g} cannot explain it"
        return f"; entries rounded by {rounding:g} could explain it"

    def _add(self, name: str, kind: str, rows: int, columns: int, low: float = -np.inf) -> Self:
        self.unknowns.add(Unknown(name, kind, rows, columns, low))
        return self
