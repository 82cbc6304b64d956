"""Steady states of systems in triangular form: feedback, feedforward, and one driven by the other.

Propositions 4.3.1 and 4.3.2, the second corrected, and the interlaced form (4.12), (4.13).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise, product
from math import inf, isfinite
from typing import Any

import numpy as np

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers.numerics.matrices import instance, listed, wrong
from pointpred_observers.plants.symbolic import (
    Free,
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    known_degree,
    power_series,
    shortened,
    symbolic,
)

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
    known = {str(one): one for one in over}
    if isinstance(region, Mapping):
        named = {str(name): pair for name, pair in region.items()}
        if unknown := named.keys() - known.keys():
            raise wrong("region", f"may hold {', '.join(known)}", min(unknown))
        if whole and (missing := known.keys() - named.keys()):
            raise wrong("region", f"needs {', '.join(sorted(missing))}", region)
    elif isinstance(region, list | tuple) and len(region) == len(over):
        named = dict(zip(known, region, strict=True))
    else:
        raise wrong("region", f"needs {len(over)} pairs (low, high)", region)
    found = {}
    for name, pair in named.items():
        try:
            low, high = (float(one) for one in pair)
        except (TypeError, ValueError, OverflowError) as unusable:
            raise wrong("region", f"needs (low, high) for {name}", pair) from unusable
        if not -inf < low <= high < inf:
            raise wrong("region", f"needs finite low <= high for {name}", pair)
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

    Raises ParameterError where it has no bounded enclosure or depends on other symbols.

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
    ends = [
        np.linspace(low, high, count + 1 if low < high else 2) for low, high in (box[one] for one in over)
    ]
    found = [enclosed(part) for part in product(*(pairwise(one.tolist()) for one in ends))]
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

    def found(place: Sequence[float], what: str) -> InfeasibleError:
        at = ", ".join(f"{w} = {x:.6g}" for w, x in zip(over, place, strict=True))
        return InfeasibleError(f"{name} {what} at {at}")

    if region is None and excluded([(-inf, inf)] * len(over)):
        return
    searched = [(-SEARCHED, SEARCHED)] * len(over) if region is None else region
    intervals = intervals_of(searched, over, whole=True)
    boxes: list[Box] = [[intervals[w] for w in over]]
    centre = [0.5 * (low + high) for low, high in boxes[0]]
    sign = value(centre) or 0.0
    for _ in range(BOXES_MOST):
        if not boxes:
            break
        box = boxes.pop(0)
        if excluded(box):
            continue
        start, end = centre, [0.5 * (low + high) for low, high in box]
        here = value(end)
        if here is not None and here * sign < 0.0:
            # Between places of opposite sign it is small at a zero, large or without value at a pole.
            for _ in range(HALVINGS):
                middle = [0.5 * (a + b) for a, b in zip(start, end, strict=True)]
                at = value(middle)
                start, end = (middle, end) if at is not None and at * sign > 0.0 else (start, middle)
            here = value(end)
            here = 0.0 if here is not None and abs(here) < SMALL else None
        if here is None or here == 0.0:
            raise found(end, "has no value" if here is None else "vanishes")
        longest = max(range(len(box)), key=[high - low for low, high in box].__getitem__)
        low, high = box[longest]
        sides = ((low, end[longest]), (end[longest], high))
        boxes += [[*box[:longest], side, *box[longest + 1 :]] for side in sides]
    if boxes or region is None:
        wanted = "region" if region is None else "smaller region"
        raise UndecidedError(
            f"{name} = {expression} was neither shown to vanish nowhere nor found to vanish in {BOXES_MOST} "
            f"boxes; give a {wanted} of the generator"
        )


def interlaced(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    upper: int,
    first: Any,
    degree: int | None = None,
    *,
    zero: Sequence[Any] | None = None,
    region: StateRegion = None,
) -> SymbolicSteadyState:
    """The steady state for which the first state of the lower part is a chosen function, and the input.

    Assumes the form (4.12), (4.13): the first ``upper`` states feed forward, the others feed back.

    - Lower part (Proposition 4.3.1), exact: xi_i' = f_i + g_i xi_(i+1) with f_i, g_i of xi_1 ... xi_i, the
      upper part and z, the last row with the input in place of the next state, so that
      pi_(i+1) = (Dpi_i s - f_i) / g_i and l = (Dpi_n s - f_n) / g_n.
    - Upper part (Proposition 4.3.2): zeta_i' = f_i of zeta_i, later states and z, analytic and zero at the
      origin, as power series up to ``degree``, accurate near the origin only, unless they end. The series is
      the centre manifold; the Cauchy problem of the print has a solution that is not a steady state.

    Rows of the upper part may also contain later states of the lower part if these can be solved without it
    (Example 9). Attraction is not proved.

    Parameters: ``upper`` mu, 0 for a feedback system, the number of states for a feedforward one; ``first``
    pi_(mu+1), of a feedforward system the input l(w); ``degree`` of series, 1 to 15; ``zero`` rho if known,
    else a series; ``region`` in which g_i must vanish nowhere, (low, high) of each state of the generator by
    symbol or in order, ``None`` the whole space. Raises ParameterError for a row of another form,
    InfeasibleError with the place where a g_i vanishes and at a resonance without solution, naming degree and
    equation, UndecidedError if a g_i is neither shown to vanish nor not to.
    Reference: Khalin 2022, sections 4.3 and 4.4; Carr 1981, section 1.4.

    >>> import sympy as sp
    >>> x1, x2, x3, x4, u, w1, w2 = sp.symbols("x1:5 u w1 w2")
    >>> circle = SymbolicGenerator((w1, w2), (w2, -w1))
    >>> steady = interlaced(SymbolicSystem((x1, x2), (-x1 + x2, x1 + u), u), circle, 1, w1, 1)
    >>> steady.maps, steady.input
    ((w1/2 - w2/2, w1), -w1/2 + 3*w2/2)
    >>> feedback = SymbolicSystem((x3, x4), (-x3**3 + x4, -x4 + (1 + x3**2) * u), u)
    >>> interlaced(feedback, circle, 0, w1).maps
    (w1, w1**3 + w2)
    >>> steady = interlaced(SymbolicSystem((x1, x2), (-x1 + x2**2 * u, -x2 + u), u), circle, 2, w1, degree=3)
    >>> steady.maps[1], steady.maps[0].coeff(w1, 3), steady.exact
    (w1/2 - w2/2, 1/40, True)
    """
    instance("system", system, SymbolicSystem)
    instance("generator", generator, SymbolicGenerator)
    if not isinstance(upper, int) or not 0 <= upper <= len(system.states):
        raise wrong("upper", f"must be a whole number in [0, {len(system.states)}]", upper)
    chain = (*system.states[upper:], system.input)
    _require_form(system, upper, chain)
    given = {chain[0]: first}
    if zero is not None:
        if len(zero := listed("zero", zero)) != len(system.zero):
            raise ParameterError(
                f"zero must hold {len(system.zero)} maps, received {len(zero)}", field="zero"
            )
        given |= zip(system.zero, zero, strict=True)
    maps = system.functions(given)
    return _solved(system, generator, known_degree(degree), region, maps, dict(pairwise(chain)), upper)


def _require_form(system: SymbolicSystem, upper: int, chain: Sequence[Any]) -> None:
    """Raise ParameterError for a row that the triangular form does not allow."""
    states = system.states
    for i, (x, row) in enumerate(zip(states, system.field, strict=True)):
        if i < upper:
            foreign = {*states[:i], *([system.input] if len(chain) > 1 else [])}
            allowed = "itself, later states and the zero dynamics"
        else:
            target = chain[i - upper + 1]
            foreign = {*states[i + 1 :], system.input} - {target}
            allowed = f"{target}, earlier states and the zero dynamics"
            if symbolic().diff(row, target).has(target):
                raise ParameterError(f"{x}' must be affine in {target}, received {row}")
        if wrong := row.free_symbols & foreign:
            raise ParameterError(f"{x}' may contain {allowed}, received {sorted(map(str, wrong))}")


def _solved(
    system: SymbolicSystem,
    generator: SymbolicGenerator,
    degree: int | None,
    region: StateRegion,
    maps: dict[Any, Any],
    following: dict[Any, Any],
    upper: int,
) -> SymbolicSteadyState:
    """Apply the rules of both propositions until every map is solved; raises ParameterError if none applies.

    ``maps``: those that are given; ``following``: what the row of each lower state gives.
    """
    names = (*system.states, *system.zero)
    rows = dict(zip(names, (*system.field, *system.zero_field), strict=True))
    w, free, divided = generator.states, list[Free](), list[Any]()
    expanded = False
    imposed = [z for z in system.zero if z in maps]

    def missing(x: Any, *besides: Any) -> set[Any]:
        wanted: set[Any] = rows[x].free_symbols & {*rows, system.input}
        return wanted - maps.keys() - {*besides}

    def divide() -> bool:
        """Proposition 4.3.1: a row of the lower part gives the unknown that it contains first."""
        for x, target in following.items():
            if x in maps and target not in maps and not missing(x, x, target):
                gain = symbolic().diff(rows[x], target).subs(maps, simultaneous=True)
                drift = rows[x].subs(target, 0).subs(maps, simultaneous=True)
                prove_nonzero(f"g of {x}'", gain, w, region)
                divided.append(x)
                maps[target] = shortened((generator.along(maps[x]) - drift) / gain)
                return True
        return False

    def expand() -> bool:
        """Proposition 4.3.2: the next row of the upper part, or the zero dynamics, as a power series."""
        nonlocal expanded
        blocks = [(x,) for x in system.states[:upper][::-1] if x not in maps][:1]
        blocks += [system.zero] if any(z not in maps for z in system.zero) else []
        for block in blocks:
            if any(missing(x, *block) for x in block):
                continue
            if degree is None:
                raise ParameterError(f"{block[0]}' needs a power series: give its degree, received None")
            fields = [rows[x] for x in block]
            inputs = {x: maps[x] for x in set().union(*(f.free_symbols for f in fields)) & maps.keys()}
            found, terms = power_series(block, fields, inputs, w, generator.field, degree)
            maps.update(found)
            free.extend(terms)
            expanded = True
            return True
        return False

    while divide() or expand():
        pass
    if waiting := [x for x in rows if x not in maps]:
        needs = [f"{x}' needs {sorted(missing(x, x), key=str)}" for x in system.states if missing(x, x)]
        raise ParameterError(f"no order of solving leads to {waiting}: {'; '.join(needs)}")
    residuals = system.residuals(generator, maps, divided)
    for z in imposed:
        if not expanded and residuals[z] != 0:
            raise ParameterError(f"{z}' is not satisfied by {z} = {maps[z]}: the residual is {residuals[z]}")
    pi, rho = (tuple(maps[x] for x in part) for part in (system.states, system.zero))
    left, cut_at = tuple(residuals.values()), degree if expanded else None
    return SymbolicSteadyState(system, generator, pi, rho, maps[system.input], left, cut_at, tuple(free))
