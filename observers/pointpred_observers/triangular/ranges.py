"""Regions of states, and what expressions do over them: bounds, and proofs that they vanish nowhere.

Interval arithmetic encloses every value of an expression over a box.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from math import inf, isfinite
from typing import Any

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers.plants.symbolic import shortened, symbolic

StateRegion = Mapping[Any, tuple[float, float]] | Sequence[tuple[float, float]] | None
"""(low, high) of each state: a dictionary by symbol or name, or pairs in order; ``None``: no bounds."""
Box = Sequence[tuple[float, float]]
PARTS_MOST = 4096
"""Parts of the box, all axes together: more parts give a tighter enclosure."""
BOXES_MOST = 4000
"""Most boxes examined before the answer is undecided."""
SEARCHED = 10.0
"""Half the side of the box about the origin that is searched for a zero in the whole space."""
HALVINGS = 200
SMALL = 1e-9


def intervals_of(region: StateRegion, over: Sequence[Any], *, whole: bool = False) -> dict[Any, Any]:
    """The intervals by symbol, of all symbols if ``whole``; pairs in order may not leave any out.

    Raises ParameterError for an unknown state, a missing one and what is no finite interval.

    >>> import sympy as sp
    >>> w = sp.symbols("w1 w2")
    >>> intervals_of({"w2": (-1, 1)}, w)
    {w2: (-1.0, 1.0)}
    >>> intervals_of([(0.0, 1.0)], w)
    Traceback (most recent call last):
    pointpred.errors.ParameterError: region needs 2 pairs (low, high), received [(0.0, 1.0)]
    """

    def wrong(needs: str, value: Any) -> ParameterError:
        return ParameterError(f"{needs}, received {value!r}", field="region", value=value)

    known = {str(one): one for one in over}
    if isinstance(region, Mapping):
        named = {str(name): pair for name, pair in region.items()}
        if unknown := named.keys() - known.keys():
            raise wrong(f"region may hold {', '.join(known)}", min(unknown))
        if whole and (missing := known.keys() - named.keys()):
            raise wrong(f"region needs {', '.join(sorted(missing))}", region)
    elif isinstance(region, list | tuple) and len(region) == len(over):
        named = dict(zip(known, region, strict=True))
    else:
        raise wrong(f"region needs {len(over)} pairs (low, high)", region)
    found = {}
    for name, pair in named.items():
        try:
            low, high = (float(one) for one in pair)
        except (TypeError, ValueError) as unusable:
            raise wrong(f"{name} needs (low, high)", pair) from unusable
        if not -inf < low <= high < inf:
            raise wrong(f"{name} needs finite low <= high", pair)
        found[known[name]] = low, high
    return found


def _enclosing(over: Sequence[Any], expression: Any) -> Callable[[Box], tuple[float, float]]:
    """The expression as a function of a box, rounded outwards; infinite where there is no enclosure."""
    from mpmath import iv

    functions = {name: getattr(iv, name) for name in ("mpf", "sin", "cos", "tan", "exp", "log", "sqrt")}
    enclose = symbolic().lambdify(over, expression, modules=[functions, "mpmath"])

    def enclosed(box: Box) -> tuple[float, float]:
        try:
            interval = iv.mpf(enclose(*(iv.mpf(list(side)) for side in box)))
        except (ValueError, TypeError, NotImplementedError, ZeroDivisionError):
            return -inf, inf
        return float(interval.a), float(interval.b)

    return enclosed


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
    over = sorted(expression.free_symbols, key=str)
    if missing := [str(one) for one in over if one not in box]:
        raise ParameterError(
            f"region needs {', '.join(missing)}, which {expression} depends on", field="region"
        )
    enclosed, count = _enclosing(over, expression), max(1, int(parts ** (1.0 / max(1, len(over)))))
    sides = []
    for low, high in (box[one] for one in over):
        ends = [low + (high - low) * i / count for i in range(count if low < high else 1)]
        sides.append(list(zip(ends, [*ends[1:], high], strict=True)))
    found = [enclosed(part) for part in product(*sides)]
    least, most = min(low for low, _ in found), max(high for _, high in found)
    if not (isfinite(least) and isfinite(most)):
        raise ParameterError(
            f"{expression} has no bounds over the region: make it smaller", field="region", value=box
        )
    return least, most


def prove_nonzero(name: str, expression: Any, over: Sequence[Any], region: StateRegion) -> None:
    """Return if the expression has no zero in the region.

    A box whose enclosure contains zero is halved; if that does not end, the answer is undecided. Raises
    InfeasibleError naming a place where it vanishes or has no value, UndecidedError if neither could be
    shown, ParameterError for parameters without value. A constant of parameters is taken as generic.

    >>> import sympy as sp
    >>> w = sp.Symbol("w")
    >>> prove_nonzero("g", 1 + w**2, [w], None)
    >>> prove_nonzero("g", 2 - w**2, [w], [(0.0, 2.0)])
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: g vanishes at w = 1.41421
    """
    if shortened(expression) == 0:
        raise InfeasibleError(f"{name} vanishes everywhere")
    real = {w: symbolic().Symbol(w.name, real=True) for w in over}
    if expression.subs(real).is_nonzero or not expression.free_symbols & {*over}:
        return
    if foreign := expression.free_symbols - {*over}:
        raise ParameterError(f"{name} = {expression} needs values for {sorted(map(str, foreign))}")
    enclosed = _enclosing(over, expression)
    plain = symbolic().lambdify(over, expression, modules="math")

    def value(place: Sequence[float]) -> float | None:
        try:
            return float(plain(*place))
        except (ValueError, ZeroDivisionError, OverflowError):
            return None

    def excluded(box: Box) -> bool:
        """Whether zero lies outside by more than the rounding of the constants."""
        low, high = enclosed(box)
        return low > SMALL or high < -SMALL

    def found(place: Sequence[float], what: str = "vanishes") -> InfeasibleError:
        at = ", ".join(f"{w} = {x:.6g}" for w, x in zip(over, place, strict=True))
        return InfeasibleError(f"{name} {what} at {at}")

    if region is None and excluded([(-inf, inf)] * len(over)):
        return
    searched = [(-SEARCHED, SEARCHED)] * len(over) if region is None else region
    intervals = intervals_of(searched, over, whole=True)
    boxes: list[Box] = [[intervals[w] for w in over]]
    centre = _middle(boxes[0])
    sign = value(centre) or 0.0
    for _ in range(BOXES_MOST):
        if not boxes:
            break
        box = boxes.pop(0)
        if excluded(box):
            continue
        middle = _middle(box)
        here = value(middle)
        if here == 0.0:
            raise found(middle)
        if here is not None and here * sign < 0.0:
            middle, here = _crossing(value, centre, middle)
            if here is not None and abs(here) < SMALL:
                raise found(middle)
            here = None
        if here is None:
            raise found(middle, "has no value")
        longest = max(range(len(box)), key=[high - low for low, high in box].__getitem__)
        low, high = box[longest]
        sides = ((low, middle[longest]), (middle[longest], high))
        boxes += [[*box[:longest], side, *box[longest + 1 :]] for side in sides]
    if boxes or region is None:
        wanted = "region" if region is None else "smaller region"
        raise UndecidedError(
            f"{name} = {expression} was neither shown to vanish nowhere nor found to vanish in {BOXES_MOST} "
            f"boxes; give a {wanted} of the generator"
        )


def _middle(box: Box) -> list[float]:
    return [0.5 * (low + high) for low, high in box]


def _crossing(
    value: Callable[[Sequence[float]], float | None], start: list[float], end: list[float]
) -> tuple[list[float], float | None]:
    """A place between two of opposite sign, and the value there: small at a zero, large or none at a pole."""
    sign = value(start) or 0.0
    for _ in range(HALVINGS):
        middle = [0.5 * (a + b) for a, b in zip(start, end, strict=True)]
        if (here := value(middle)) is None:
            return middle, None
        start, end = (middle, end) if here * sign > 0.0 else (start, middle)
    return end, value(end)
