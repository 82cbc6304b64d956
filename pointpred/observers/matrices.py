"""Matrices that somebody hands over: of the right shape, real and finite, or an error that says why not."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.differentiators.sampling import is_number
from pointpred.errors import ParameterError


def matrix(name: str, given: Any, rows: int | None = None, columns: int | None = None) -> FloatArray:
    """A matrix of the given shape, copied; ``None`` leaves a side free.

    A flat list is a column where the matrix has one column, else a row where it has one row.
    Raises ParameterError with the name, the shape received and the shape needed, or for NaN, inf and complex.

    >>> matrix("C0", [1.0, 0.0], 1, 2).shape
    (1, 2)
    >>> matrix("A0", [[1.0, 2.0]], 2, 2)
    Traceback (most recent call last):
    pointpred.errors.ParameterError: A0 has shape (1, 2), needs (2, 2)
    """
    try:
        received = np.asarray(given)
        if np.iscomplexobj(received):
            raise ParameterError(f"{name} must be real, received {given!r}")
        value = np.array(received, np.float64)
    except (TypeError, ValueError) as unusable:
        if isinstance(unusable, ParameterError):
            raise
        raise ParameterError(f"{name} must be a matrix of numbers, received {given!r}") from unusable
    if not np.isfinite(value).all():
        raise ParameterError(f"{name} must be finite, received {given!r}")
    if value.ndim == 0:
        value = value.reshape(1, 1)
    elif value.ndim == 1:
        value = value.reshape(-1, 1) if columns == 1 else value.reshape(1, -1)
    shape = value.shape
    if (
        len(shape) != 2
        or (rows is not None and shape[0] != rows)
        or (columns is not None and shape[1] != columns)
    ):
        needed = f"({'any' if rows is None else rows}, {'any' if columns is None else columns})"
        raise ParameterError(f"{name} has shape {shape}, needs {needed}")
    return value


def moments(varying: str, times: Sequence[float] | None, purpose: str) -> list[float]:
    """The times at which a statement is made: those given, or 0 alone where nothing varies.

    Raises ParameterError where something varies and no time is given, or one is not finite.

    >>> moments("A0", None, "to hold")
    Traceback (most recent call last):
    pointpred.errors.ParameterError: A0 varies: give the times at which it is to hold
    """
    if not varying:
        return [0.0]
    if times is None or len(times) == 0:
        raise ParameterError(f"{varying} varies: give the times at which it is {purpose}")
    return [float(one) for one in matrix("times", times, 1)[0]]


def positive(name: str, given: Any, *, zero: bool = False) -> float:
    """A finite number above 0 (or not below it); raises ParameterError, also for words and complex ones.

    >>> positive("decay", "fast")
    Traceback (most recent call last):
    pointpred.errors.ParameterError: decay must be finite and above 0, received 'fast'
    """
    if not is_number(given) or not 0.0 <= given < np.inf or (given == 0.0 and not zero):
        bound = "not below" if zero else "above"
        raise ParameterError(f"{name} must be finite and {bound} 0, received {given!r}")
    return float(given)


def share(name: str, given: Any) -> float:
    """A number within (0, 1); raises ParameterError."""
    if not is_number(given) or not 0.0 < given < 1.0:
        raise ParameterError(f"{name} must lie in (0, 1), received {given!r}")
    return float(given)
