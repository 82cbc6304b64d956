"""Nonlinearities of Persidskii systems: by name, which compiled stages can evaluate, or any function."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import atan, inf, sin, tanh
from typing import Any

import msgspec
import numpy as np

from pointpred.compiled import law
from pointpred.errors import ParameterError
from pointpred.records import FloatArray

IDENTITY, SIN, TANH, ATAN, SATURATION, CUBE = 0, 1, 2, 3, 4, 5


class Known(msgspec.Struct, frozen=True):
    """A named nonlinearity: its code in compiled laws, and the bounds of its slope."""

    code: int
    low: float
    high: float


KNOWN = {
    "identity": Known(IDENTITY, 1.0, 1.0),
    "sin": Known(SIN, -1.0, 1.0),
    "tanh": Known(TANH, 0.0, 1.0),
    "atan": Known(ATAN, 0.0, 1.0),
    "saturation": Known(SATURATION, 0.0, 1.0),
    "cube": Known(CUBE, 0.0, inf),
}
"""What compiled stages can evaluate; ``cube`` has a bounded slope only where its argument is bounded."""
NAMED = {one.code: name for name, one in KNOWN.items()}


@law
def value(code: float, s: float) -> float:
    """The nonlinearity with the given code at s."""
    if code == SIN:
        return sin(s)
    if code == TANH:
        return tanh(s)
    if code == ATAN:
        return atan(s)
    if code == SATURATION:
        return min(max(s, -1.0), 1.0)
    if code == CUBE:
        return s * s * s
    return s


class Nonlinearity(msgspec.Struct, frozen=True):
    """The f of a Persidskii system, R^r to R^k; ``codes`` is ``None`` unless every component has a name."""

    function: Callable[[FloatArray], FloatArray]
    codes: tuple[int, ...] | None
    slopes: tuple[tuple[float, float], ...] | None
    """Bounds of each component's slope, ``None`` where f is not elementwise or they were not passed."""
    checked: float = 0.0
    """The largest domain within which the slopes were compared with f."""

    def __call__(self, s: Any) -> FloatArray:
        """The value at s."""
        return np.asarray(self.function(np.asarray(s, np.float64)), np.float64)


def nonlinearity(f: Any, count: int, slopes: Any = None) -> Nonlinearity:
    """The f of a name, of one name for each of ``count`` components, or of a function of the vector.

    Raises ParameterError for an unknown name and for slopes that are not intervals.

    >>> nonlinearity("sin", 2)([0.0, 0.5]).round(3).tolist()
    [0.0, 0.479]
    >>> nonlinearity("sine", 1)
    Traceback (most recent call last):
    pointpred.errors.ParameterError: f must be a function or one of identity, sin, tanh, atan, saturation, \
cube, received 'sine'
    """
    if isinstance(f, Nonlinearity):
        return (
            f if slopes is None else msgspec.structs.replace(f, slopes=intervals(slopes, count), checked=0.0)
        )
    bounds = None if slopes is None else intervals(slopes, count)
    if callable(f):
        return Nonlinearity(f, None, bounds)
    names = [f] * count if isinstance(f, str) else f
    if not isinstance(names, Sequence) or any(
        not isinstance(name, str) or name not in KNOWN for name in names
    ):
        raise ParameterError(
            f"f must be a function or one of {', '.join(KNOWN)}, received {f!r}", field="f", value=f
        )
    if len(names) != count:
        raise ParameterError(f"f needs {count} components, received {f!r}", field="f", value=f)
    parts = [KNOWN[name] for name in names]
    codes = tuple(part.code for part in parts)

    def function(s: FloatArray) -> FloatArray:
        return np.array([value(code, one) for code, one in zip(codes, s, strict=True)])

    return Nonlinearity(function, codes, bounds or tuple((part.low, part.high) for part in parts))


def same(one: Nonlinearity, other: Nonlinearity) -> bool:
    """Whether two are the same by their names, or the same Python function."""
    if one.codes is None or other.codes is None:
        return one.codes == other.codes and one.function is other.function
    return one.codes == other.codes


def intervals(slopes: Any, count: int) -> tuple[tuple[float, float], ...]:
    """One (low, high) for each component; a single pair applies to all."""
    try:
        pairs = np.broadcast_to(np.array(slopes, np.float64), (count, 2))
    except (TypeError, ValueError) as unusable:
        raise ParameterError(
            f"slopes must be (low, high) or {count} such pairs, received {slopes!r}",
            field="slopes",
            value=slopes,
        ) from unusable
    if np.isnan(pairs).any() or (pairs[:, 0] > pairs[:, 1]).any():
        raise ParameterError(f"slopes need low <= high in each pair, received {slopes!r}")
    return tuple((float(low), float(high)) for low, high in pairs)
