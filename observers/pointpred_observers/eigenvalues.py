"""Eigenvalues of an error: whether every one decays, how fast the fastest can be, and as text."""

from __future__ import annotations

from collections.abc import Iterable
from math import log

import numpy as np

from pointpred.errors import InfeasibleError
from pointpred.records import FloatArray

BESIDE = 1e-5
"""An eigenvalue within this of another, or of the imaginary axis, relative to the matrix, counts as there."""


def require_decay(corners: Iterable[tuple[str, FloatArray]], time: str, what: str) -> float:
    """The largest real part of an eigenvalue at any corner, in discrete time the logarithm of its modulus.

    Parameters: ``corners`` name and matrix of each, "" for the only one of a linear system.
    Raises InfeasibleError naming an eigenvalue that does not decay, and its corner.

    >>> require_decay([("", np.diag([-1.0, -2.0]))], "continuous", "the error system")
    -1.0
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
    """The eigenvalues with which w' = a w is not neutrally stable, each with what its motion does.

    >>> unsettled(np.array([[0.0, 1.0], [-1.0, 0.0]])), unsettled(np.array([[-1.0]]))
    ([], [((-1+0j), 'a motion of the eigenvalue {} decays')])
    """
    size = float(np.linalg.norm(a, 2)) or 1.0
    values = np.linalg.eigvals(a).astype(np.complex128)
    listed = []
    for one in values:
        growth = abs(one) - 1.0 if time == "discrete" else one.real
        pencil = (one * np.eye(len(a)) - a) / size
        alike = int((np.abs(values - one) <= BESIDE * size).sum())
        # A defective eigenvalue is computed to a root of its digits only.
        if abs(growth) > BESIDE * size:
            motion = f"a motion of the eigenvalue {{}} {'grows' if growth > 0.0 else 'decays'}"
        elif len(a) - np.linalg.matrix_rank(pencil, tol=BESIDE) < alike:
            motion = "the eigenvalue {} is multiple, and a motion of it grows with t"
        else:
            continue
        listed.append((complex(one), motion))
    return listed


def perron_root(entries: FloatArray) -> float:
    """The largest eigenvalue of the absolute entries, a bound of every eigenvalue.

    It does not change with the units of the states; that of no states is 0.

    >>> round(perron_root(np.array([[0.0, -4.0], [1.0, 0.0]])), 9)
    2.0
    """
    return float(np.abs(np.linalg.eigvals(np.abs(entries))).max(initial=0.0))


def number_text(value: complex) -> str:
    """A number with six digits, without an imaginary part of zero.

    >>> number_text(-2.0 + 0.0j), number_text(0.5 - 1.0j)
    ('-2', '0.5-1j')
    """
    return f"{value.real:.6g}" if value.imag == 0.0 else f"{value:.6g}"
