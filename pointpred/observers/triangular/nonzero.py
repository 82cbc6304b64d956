"""A proof that an expression has no zero in a region, or the place of a zero.

Interval arithmetic encloses every value over a box. A box whose enclosure contains zero is halved; if that
does not end, the answer is undecided.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers.triangular.polynomials import symbolic
from pointpred_observers.triangular.ranges import interval_function
from pointpred_observers.triangular.regions import Region, intervals_of
from pointpred_observers.triangular.system import vanishes

BOXES_MOST = 4000
"""Most boxes examined before the answer is undecided."""
SEARCHED = 10.0
"""Half the side of the box about the origin that is searched for a zero in the whole space."""
HALVINGS = 200
SMALL = 1e-9


def prove_nonzero(name: str, expression: Any, over: Sequence[Any], region: Region) -> None:
    """Return if the expression has no zero in the region.

    Raises InfeasibleError naming a place where it vanishes or has no value, UndecidedError if neither could
    be shown, ParameterError for parameters without value. A constant of parameters is taken as generic.

    >>> import sympy as sp
    >>> w = sp.Symbol("w")
    >>> prove_nonzero("g", 1 + w**2, [w], None)
    >>> prove_nonzero("g", 2 - w**2, [w], [(0.0, 2.0)])
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: g vanishes at w = 1.41421
    """
    if vanishes(expression)[0]:
        raise InfeasibleError(f"{name} vanishes everywhere")
    real = {w: symbolic().Symbol(w.name, real=True) for w in over}
    if expression.subs(real).is_nonzero or not expression.free_symbols & {*over}:
        return
    if foreign := expression.free_symbols - {*over}:
        raise ParameterError(f"{name} = {expression} needs values for {sorted(map(str, foreign))}")
    from mpmath import iv

    enclose = interval_function(over, expression)
    value = symbolic().lambdify(over, expression, modules="math")
    if region is None and _excludes_zero(enclose, [iv.mpf(["-inf", "inf"]) for _ in over]):
        return
    whole = _box(over, [(-SEARCHED, SEARCHED)] * len(over) if region is None else region)
    centre = _middle(whole)
    sign, boxes = _at(value, centre) or 0.0, [whole]
    for _ in range(BOXES_MOST):
        if not boxes:
            break
        box = boxes.pop(0)
        if _excludes_zero(enclose, [iv.mpf(list(side)) for side in box]):
            continue
        middle = _middle(box)
        here = _at(value, middle)
        if here is None or here == 0.0:
            what = "has no value" if here is None else "vanishes"
            raise InfeasibleError(f"{name} {what} at {_shown(over, middle)}")
        if here * sign < 0.0:
            raise InfeasibleError(_crossing(name, value, over, centre, middle))
        boxes += _halves(box)
    if boxes or region is None:
        wanted = "region" if region is None else "smaller region"
        raise UndecidedError(
            f"{name} = {expression} was neither shown to vanish nowhere nor found to vanish in {BOXES_MOST} "
            f"boxes; give a {wanted} of the generator"
        )


def _excludes_zero(enclose: Callable[..., Any], box: Sequence[Any]) -> bool:
    """Whether an enclosure excludes zero by more than the rounding of the constants."""
    try:
        interval = enclose(*box)
    except (ValueError, TypeError, NotImplementedError, ZeroDivisionError):
        return False  # no enclosure: the box is halved
    low, high = float(interval.a), float(interval.b)
    return low > SMALL or high < -SMALL


def _box(over: Sequence[Any], region: Region) -> list[tuple[float, float]]:
    """The interval of each state in order; raises ParameterError where one is missing."""
    intervals = intervals_of(region, over)
    if missing := [str(w) for w in over if w not in intervals]:
        raise ParameterError(
            f"region needs {', '.join(missing)}, received {region!r}", field="region", value=region
        )
    return [intervals[w] for w in over]


def _middle(box: Sequence[tuple[float, float]]) -> list[float]:
    return [0.5 * (low + high) for low, high in box]


def _halves(box: list[tuple[float, float]]) -> list[list[tuple[float, float]]]:
    """The two halves across the longest side."""
    longest = max(range(len(box)), key=lambda i: box[i][1] - box[i][0])
    low, high = box[longest]
    middle = 0.5 * (low + high)
    return [[*box[:longest], side, *box[longest + 1 :]] for side in ((low, middle), (middle, high))]


def _at(value: Callable[..., Any], place: Sequence[float]) -> float | None:
    try:
        return float(value(*place))
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


def _crossing(
    name: str, value: Callable[..., Any], over: Sequence[Any], start: list[float], end: list[float]
) -> str:
    """Raise for the zero, or the place without a value, between two places of opposite sign."""
    sign = _at(value, start) or 0.0
    for _ in range(HALVINGS):
        middle = [0.5 * (a + b) for a, b in zip(start, end, strict=True)]
        here = _at(value, middle)
        if here is None:
            return f"{name} has no value at {_shown(over, middle)}"
        if here * sign > 0.0:
            start = middle
        else:
            end = middle
    small = abs(_at(value, end) or 0.0) < SMALL
    return f"{name} {'vanishes' if small else 'has no value'} at {_shown(over, end)}"


def _shown(over: Sequence[Any], place: Sequence[float]) -> str:
    return ", ".join(f"{w} = {x:.6g}" for w, x in zip(over, place, strict=True))
