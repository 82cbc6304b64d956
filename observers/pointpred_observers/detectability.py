"""Detectability by the Popov-Belevitch-Hautus test, which needs no solver."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.balance import balanced, inward
from pointpred_observers.eigenvalues import number_text
from pointpred_observers.matrices import TIMES, matrix, one_of

SINGULAR = 1e-9
"""A singular value below this, relative to the matrices, counts as zero."""
COMPONENTS_MOST = 8


def undetectable(A: Any, C: Any, time: str = "continuous") -> list[complex]:
    """The eigenvalues of modes that neither decay nor appear in the output; empty for a detectable pair.

    An eigenvalue s with real part >= 0 (modulus >= 1 in discrete time) is one of them if (sI - A; C) loses
    rank in balanced units, which do not depend on those of states and outputs.

    >>> undetectable([[1.0, 0.0], [0.0, -2.0]], [[0.0, 1.0]])
    [(1+0j)]
    """
    return hidden(A, C, time, staying=True)


def hidden(A: Any, C: Any, time: str, *, staying: bool = False) -> list[complex]:
    """The eigenvalues of modes that do not appear in the output, or only of those ``staying``."""
    one_of("time", time, TIMES)
    a = matrix("A", A, len(matrix("A", A)), len(matrix("A", A)))
    c = matrix("C", C, None, len(a))
    units = balanced(a, seen=c, time=time)
    a, c = inward(a, units.states, units.states), inward(c, units.outputs, units.states)
    size = float(np.linalg.norm(a, 2)) or 1.0
    c = c / ((float(np.linalg.norm(c, 2)) if c.size else 0.0) or 1.0)
    modes = []
    for one in np.linalg.eigvals(a).astype(np.complex128):
        stays = abs(one) >= 1.0 - SINGULAR if time == "discrete" else one.real >= -SINGULAR * size
        pencil = np.vstack([(one * np.eye(len(a)) - a) / size, c])
        # Repeated eigenvalues are computed to half their digits only.
        if (stays or not staying) and np.linalg.svd(pencil, compute_uv=False)[-1] <= np.sqrt(SINGULAR) * 1e-2:
            modes.append(complex(one))
    return modes


def require_detectable(a: FloatArray, c: FloatArray, time: str, pair: str) -> None:
    """Raise InfeasibleError naming the pair and its first undetectable eigenvalue."""
    for one in undetectable(a, c, time):
        raise InfeasibleError(
            f"{pair} is not detectable: the mode of the eigenvalue {number_text(one)} never shows"
        )


def vertices(slopes: tuple[tuple[float, float], ...] | None) -> dict[str, FloatArray]:
    """The corners of the box of slopes as diagonal matrices, named by their slopes.

    Raises ParameterError where slopes are missing, infinite, or have more than 2^8 corners.
    """
    if slopes is None:
        raise ParameterError(
            "a design needs slopes: the interval of the slope of each component of f", field="slopes"
        )
    if not np.isfinite(np.array(slopes)).all():
        raise ParameterError(
            f"a design needs bounded slopes (give slopes and their domain), received {slopes}",
            field="slopes",
            value=slopes,
        )
    corners = [sorted(set(one)) for one in slopes]
    if sum(len(one) > 1 for one in corners) > COMPONENTS_MOST:
        raise ParameterError(f"at most {COMPONENTS_MOST} components with two slopes, received {len(slopes)}")
    return {", ".join(f"{one:.6g}" for one in corner): np.diag(corner) for corner in product(*corners)}
