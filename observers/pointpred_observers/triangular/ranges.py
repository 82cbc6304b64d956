"""Enclosures of the values of an expression over a box, by interval arithmetic on parts of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from math import inf, isfinite
from typing import Any

from pointpred.errors import ParameterError
from pointpred_observers.triangular.polynomials import symbolic

PARTS_MOST = 4096
"""Parts of the box, all axes together: more parts give a tighter enclosure."""


def enclosure(
    expression: Any, box: Mapping[Any, tuple[float, float]], parts: int = PARTS_MOST
) -> tuple[float, float]:
    """Bounds of the expression over the box, rounded outwards and tight up to the size of one of ``parts``.

    Raises ParameterError where the expression has no bounded enclosure or depends on other symbols.

    >>> import sympy as sp
    >>> x = sp.Symbol("x")
    >>> low, high = enclosure(x**2 - x, {x: (0.0, 1.0)})
    >>> -0.26 < low <= -0.25, 0.0 <= high < 0.01
    (True, True)
    """
    from mpmath import iv

    over = sorted(expression.free_symbols, key=str)
    if missing := [str(one) for one in over if one not in box]:
        raise ParameterError(
            f"region needs {', '.join(missing)}, which {expression} depends on", field="region"
        )
    enclose = interval_function(over, expression)
    count = max(1, int(parts ** (1.0 / max(1, len(over)))))
    low, high = inf, -inf
    for part in product(*(_parts(box[one], count) for one in over)):
        try:
            interval = iv.mpf(enclose(*(iv.mpf(list(side)) for side in part)))
        except (ValueError, TypeError, NotImplementedError, ZeroDivisionError):
            interval = iv.mpf(["-inf", "inf"])
        low, high = min(low, float(interval.a)), max(high, float(interval.b))
    if not (isfinite(low) and isfinite(high)):
        raise ParameterError(
            f"{expression} has no bounds over the region: make it smaller", field="region", value=box
        )
    return low, high


def interval_function(over: Sequence[Any], expression: Any) -> Callable[..., Any]:
    """The expression as a function of intervals of mpmath; constants become intervals as well."""
    from mpmath import iv

    functions = {name: getattr(iv, name) for name in ("mpf", "sin", "cos", "tan", "exp", "log", "sqrt")}
    enclose: Callable[..., Any] = symbolic().lambdify(over, expression, modules=[functions, "mpmath"])
    return enclose


def _parts(side: tuple[float, float], count: int) -> Sequence[tuple[float, float]]:
    low, high = side
    if low == high:
        return [side]
    ends = [low + (high - low) * i / count for i in range(count)]
    return list(zip(ends, [*ends[1:], high], strict=True))
