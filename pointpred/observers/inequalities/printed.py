"""The audit of matrices that somebody prints."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pointpred.observers.inequalities.matrix_inequalities import MatrixInequalities


def check(
    printed: Mapping[str, Any], theorem: MatrixInequalities, *, rounding: float = 0.0
) -> dict[str, float]:
    """The margins of matrices that somebody prints, as ``theorem.check`` gives them, or CertificateError.

    >>> decay = MatrixInequalities("decay").positive("P", 1).below("-2 P", lambda v: -2.0 * v.P)
    >>> check({"P": 3.0}, decay)
    {'P > 0': 3.0, '-2 P': 6.0}
    """
    return theorem.check(printed, rounding=rounding)
