"""Checks of matrices from a caller: shape, real and finite entries."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import Any, TypeVar

import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray

Kind = TypeVar("Kind")
TIMES = ("continuous", "discrete")


def matrix(name: str, value: Any, rows: int | None = None, columns: int | None = None) -> FloatArray:
    """A copy of a matrix of the required shape; ``None`` leaves a side free.

    A flat list is a column if the matrix has one column, else a row if it has one row.
    Raises ParameterError for another shape, and for NaN, inf and complex entries.

    >>> matrix("C0", [1.0, 0.0], 1, 2).shape
    (1, 2)
    >>> matrix("A0", [[1.0, 2.0]], 2, 2)
    Traceback (most recent call last):
    pointpred.errors.ParameterError: A0 has shape (1, 2), needs (2, 2)
    """
    try:
        received = np.asarray(value)
        if np.iscomplexobj(received):
            raise wrong(name, "must be real", value)
        entries = np.array(received, np.float64)
    except (TypeError, ValueError, OverflowError) as unusable:
        if isinstance(unusable, ParameterError):
            raise
        raise wrong(name, "must be a matrix of numbers", value) from unusable
    if not np.isfinite(entries).all():
        raise wrong(name, "must be finite", value)
    if entries.ndim == 0:
        entries = entries.reshape(1, 1)
    elif entries.ndim == 1:
        entries = entries.reshape(-1, 1) if columns == 1 else entries.reshape(1, -1)
    shape = entries.shape
    if (
        len(shape) != 2
        or (rows is not None and shape[0] != rows)
        or (columns is not None and shape[1] != columns)
    ):
        needed = f"({'any' if rows is None else rows}, {'any' if columns is None else columns})"
        raise ParameterError(f"{name} has shape {shape}, needs {needed}", field=name, value=value)
    return entries


def dimensions(value: Any) -> int:
    """How many dimensions an array has; 0 for rows of different lengths, which are none."""
    try:
        return int(np.ndim(value))
    except ValueError:
        return 0


def moments(varying: str, times: Sequence[float] | None, purpose: str) -> list[float]:
    """The times at which a statement is to hold: those passed, or only 0 if nothing varies.

    Raises ParameterError if something varies and no time is passed, or one is not finite.
    """
    if not varying:
        return [0.0]
    if times is None or len(times) == 0:
        raise ParameterError(f"{varying} varies: give the times at which it is {purpose}", field="times")
    return [float(one) for one in matrix("times", times, 1)[0]]


def positive(name: str, value: Any, *, zero: bool = False) -> float:
    """A finite number above 0 (or not below it); raises ParameterError, also for text and complex numbers."""
    with suppress(OverflowError):
        if is_number(value) and 0.0 <= value < np.inf and (zero or value > 0.0):
            return float(value)
    raise wrong(name, f"must be finite and {'not below' if zero else 'above'} 0", value)


def share(name: str, value: Any) -> float:
    """A number within (0, 1); raises ParameterError."""
    if not is_number(value) or not 0.0 < value < 1.0:
        raise wrong(name, "must lie in (0, 1)", value)
    return float(value)


def vector(name: str, value: Any, size: int) -> FloatArray:
    """An array of ``size`` numbers, not copied; raises ParameterError."""
    try:
        numbers = np.atleast_1d(np.asarray(value, np.float64))
    except (TypeError, ValueError, OverflowError) as unusable:
        raise wrong(name, f"must be {size} numbers", value) from unusable
    if numbers.shape != (size,):
        raise wrong(name, f"must be {size} numbers", value)
    return numbers


def flag(name: str, value: Any) -> bool:
    """A truth value; raises ParameterError for anything else."""
    if not isinstance(value, bool | np.bool_):
        raise wrong(name, "must be True or False", value)
    return bool(value)


def instance(name: str, value: Any, kind: type[Kind]) -> Kind:
    """The value, which must be of this kind; raises ParameterError."""
    if not isinstance(value, kind):
        article = "an" if kind.__name__[0] in "AEIOU" else "a"
        raise ParameterError(
            f"{name} must be {article} {kind.__name__}, received {value!r:.80}", field=name, value=value
        )
    return value


def one_of(name: str, value: Any, options: Sequence[str]) -> str:
    """The value, which must be one of these words; raises ParameterError."""
    if not isinstance(value, str) or value not in options:
        words = " or ".join(map(repr, options)) if len(options) == 2 else f"one of {', '.join(options)}"
        raise wrong(name, f"must be {words}", value)
    return value


def listed(name: str, value: Any) -> Sequence[Any]:
    """The values of a list, or of anything else that holds several in order; raises ParameterError."""
    if isinstance(value, str | dict) or not isinstance(value, Iterable):
        raise wrong(name, "must be a list", value)
    return list(value)


def wrong(name: str, must: str, value: Any) -> ParameterError:
    """The error for a value that is not what its name must be."""
    return ParameterError(f"{name} {must}, received {value!r}", field=name, value=value)
