"""Eigenvalues: which decay, which never show in an output, at every corner of the slopes; and as text."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product
from math import log
from typing import Any

import numpy as np

from pointpred.errors import InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import balanced, inward
from pointpred_observers.numerics.matrices import TIMES, matrix, one_of

SINGULAR = 1e-9
"""A singular value below this, relative to the matrices, counts as zero."""
LOST = 3e-7
"""The same of a mode that outputs do not show: repeated eigenvalues have half their digits only."""
COMPONENTS_MOST = 8

EPS, ROUNDINGS = float(np.finfo(np.float64).eps), 1e3
"""An eigenvalue counts as on the axis within so many roundings of the matrix, times its condition."""


def require_decay(corners: Iterable[tuple[str, FloatArray]], time: str, what: str) -> float:
    """The largest real part of an eigenvalue at any corner, in discrete time the logarithm of its modulus.

    Parameters: ``corners`` name and matrix of each, "" for the only one of a linear system.
    Raises InfeasibleError naming an eigenvalue that does not decay, and its corner.
    """
    slowest, discrete = -np.inf, time == "discrete"
    for name, a in corners:
        for value in np.linalg.eigvals(a).astype(np.complex128):
            rate = log(max(abs(value), 1e-300)) if discrete else float(value.real)
            if rate >= 0.0:
                where = "inside the unit circle" if discrete else "left of 0"
                corner = f" at {name}" if name else ""
                raise InfeasibleError(
                    f"{what} has the eigenvalue {number_text(value)}{corner}, must lie {where}"
                )
            slowest = max(slowest, rate)
    return slowest


def unsettled(a: FloatArray, time: str = "continuous") -> list[tuple[complex, str]]:
    """The eigenvalues with which w' = a w is not neutrally stable, each with what its motion does."""
    from scipy.linalg import eig, matrix_balance

    even = np.asarray(matrix_balance(a, permute=False)[0], np.float64)
    size = float(np.linalg.norm(even, 2)) or 1.0
    found: Any = eig(even, left=True, right=True)
    values, left, right = found
    # Rounding moves an eigenvalue by its condition number: a defective one by a root of its digits.
    condition = 1.0 / np.maximum(np.abs((left.conj() * right).sum(axis=0)), np.sqrt(EPS))
    blur = ROUNDINGS * EPS * size * condition
    listed = []
    for one, near in zip(values.astype(np.complex128), blur, strict=True):
        growth = abs(one) - 1.0 if time == "discrete" else one.real
        alike = int((np.abs(values - one) <= near + blur).sum())
        pencil = one * np.eye(len(even)) - even
        if abs(growth) > near:
            motion = f"a motion of the eigenvalue {{}} {'grows' if growth > 0.0 else 'decays'}"
        elif len(even) - np.linalg.matrix_rank(pencil, tol=10.0 * near) < alike:
            motion = "the eigenvalue {} is multiple, and a motion of it grows with t"
        else:
            continue
        listed.append((complex(one), motion))
    return listed


def perron_root(entries: FloatArray) -> float:
    """The largest eigenvalue of the absolute entries, a bound of every eigenvalue.

    It does not change with the units of the states; that of no states is 0.
    """
    return float(np.abs(np.linalg.eigvals(np.abs(entries))).max(initial=0.0))


def number_text(value: complex) -> str:
    """A number with six digits, without an imaginary part of zero."""
    return f"{value.real:.6g}" if value.imag == 0.0 else f"{value:.6g}"


def undetectable(A: Any, C: Any, time: str = "continuous") -> list[complex]:
    """The eigenvalues of modes that neither decay nor appear in the output; empty for a detectable pair.

    An eigenvalue s with real part >= 0 (modulus >= 1 in discrete time) is one of them if (sI - A; C) loses
    rank in balanced units, which do not depend on those of states and outputs.

    >>> undetectable([[1.0, 0.0], [0.0, -2.0]], [[0.0, 1.0]])
    [(1+0j)]
    """
    return hidden(A, C, time, staying=True)


def hidden(A: Any, C: Any, time: str, *, staying: bool = False, least: float = LOST) -> list[complex]:
    """The eigenvalues of modes that outputs show by at most ``least``, or only of those ``staying``."""
    one_of("time", time, TIMES)
    a = matrix("A", A, len(matrix("A", A)), len(matrix("A", A)))
    c = matrix("C", C, None, len(a))
    units = balanced(a, seen=c, time=time)
    # Balanced units may show a weakly coupled part faintly, and those of the user another.
    pairs = [(a, c), (inward(a, units.states, units.states), inward(c, units.outputs, units.states))]
    modes = []
    size = float(np.linalg.norm(pairs[1][0], 2)) or 1.0
    for one in np.linalg.eigvals(pairs[1][0]).astype(np.complex128):
        stays = abs(one) >= 1.0 - SINGULAR if time == "discrete" else one.real >= -SINGULAR * size
        if (stays or not staying) and all(_shown(one, *pair) <= least for pair in pairs):
            modes.append(complex(one))
    return modes


def _shown(value: complex, a: FloatArray, c: FloatArray) -> float:
    """The least singular value of (s I - A; C) at an eigenvalue, with A and C scaled to 1."""
    size = float(np.linalg.norm(a, 2)) or 1.0
    seen = (float(np.linalg.norm(c, 2)) if c.size else 0.0) or 1.0
    pencil = np.vstack([(value * np.eye(len(a)) - a) / size, c / seen])
    return float(np.linalg.svd(pencil, compute_uv=False)[-1])


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
