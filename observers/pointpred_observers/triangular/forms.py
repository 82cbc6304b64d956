"""Steady states of systems in triangular form: feedback, feedforward, and one driven by the other.

Propositions 4.3.1 and 4.3.2, the second corrected, and the interlaced form (4.12), (4.13).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise, product
from math import inf, isfinite
from typing import Any

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred_observers.numerics.matrices import instance, listed
from pointpred_observers.plants.polynomials import Free, power_series, shortened, symbolic
from pointpred_observers.plants.symbolic import (
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    known_degree,
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
      the centre manifold. The print solves a Cauchy problem with pi = 0 where w_q = 0 instead; its solution
      changes with each revolution of the generator and is not a steady state.

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
        raise ParameterError(
            f"upper must be a whole number in [0, {len(system.states)}], received {upper!r}",
            field="upper",
            value=upper,
        )
    chain = (*system.states[upper:], system.input)
    _require_form(system, upper, chain)
    given = {chain[0]: first}
    if zero is not None:
        if len(zero := listed("zero", zero)) != len(system.zero):
            raise ParameterError(
                f"zero must hold {len(system.zero)} maps, received {len(zero)}", field="zero"
            )
        given |= zip(system.zero, zero, strict=True)
    return _Solving(system, generator, known_degree(degree), region, system.functions(given)).solve(
        dict(pairwise(chain)), [(x,) for x in system.states[:upper][::-1]]
    )


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


class _Solving:
    """The maps solved so far, and the rules that solve the next one."""

    def __init__(
        self,
        system: SymbolicSystem,
        generator: SymbolicGenerator,
        degree: int | None,
        region: StateRegion,
        maps: dict[Any, Any],
    ) -> None:
        self.system, self.generator, self.degree, self.region = system, generator, degree, region
        self.maps, self.imposed = maps, [z for z in system.zero if z in maps]
        self.rows = dict(
            zip((*system.states, *system.zero), (*system.field, *system.zero_field), strict=True)
        )
        self.symbols = {*self.rows, system.input}
        self.free: list[Free] = []
        self.series_used = False
        self.divided: list[Any] = []

    def solve(self, following: dict[Any, Any], series: list[tuple[Any, ...]]) -> SymbolicSteadyState:
        """Apply the rules until every map is solved; raises ParameterError if no rule applies.

        ``following``: what the row of each lower state gives; ``series``: the upper states in their order.
        """
        blocks = [*series, self.system.zero]
        while self._divide(following) or self._expand(blocks):
            pass
        if waiting := [x for x in self.rows if x not in self.maps]:
            states = [x for x in self.system.states if self._missing(x, {x})]
            needs = "; ".join(f"{x}' needs {sorted(self._missing(x, {x}), key=str)}" for x in states)
            raise ParameterError(f"no order of solving leads to {waiting}: {needs}")
        residuals = self.system.residuals(self.generator, self.maps, self.divided)
        for z in self.imposed:
            if not self.series_used and residuals[z] != 0:
                raise ParameterError(
                    f"{z}' is not satisfied by {z} = {self.maps[z]}: the residual is {residuals[z]}"
                )
        system, degree = self.system, self.degree if self.series_used else None
        maps, zero = (tuple(self.maps[x] for x in part) for part in (system.states, system.zero))
        left, ell = tuple(residuals.values()), self.maps[system.input]
        return SymbolicSteadyState(system, self.generator, maps, zero, ell, left, degree, tuple(self.free))

    def _missing(self, x: Any, besides: set[Any]) -> set[Any]:
        """The symbols of a row that are not solved yet."""
        wanted: set[Any] = self.rows[x].free_symbols & self.symbols
        return wanted - self.maps.keys() - besides

    def _divide(self, following: dict[Any, Any]) -> bool:
        """Proposition 4.3.1: a row of the lower part gives the unknown that it contains first."""
        for x, target in following.items():
            if x in self.maps and target not in self.maps and not self._missing(x, {x, target}):
                gain = symbolic().diff(self.rows[x], target).subs(self.maps, simultaneous=True)
                drift = self.rows[x].subs(target, 0).subs(self.maps, simultaneous=True)
                prove_nonzero(f"g of {x}'", gain, self.generator.states, self.region)
                self.divided.append(x)
                self.maps[target] = shortened((self.generator.along(self.maps[x]) - drift) / gain)
                return True
        return False

    def _expand(self, blocks: list[tuple[Any, ...]]) -> bool:
        """Proposition 4.3.2: a row of the upper part, or the zero dynamics, as a power series."""
        waiting = [one for one in blocks if any(x not in self.maps for x in one)]
        upper = [one for one in waiting if one is not self.system.zero]
        for block in (*upper[:1], *(one for one in waiting if one is self.system.zero)):
            if any(self._missing(x, set(block)) for x in block):
                continue
            if self.degree is None:
                raise ParameterError(f"{block[0]}' needs a power series: give its degree, received None")
            fields = [self.rows[x] for x in block]
            wanted = set().union(*(f.free_symbols for f in fields)) & self.maps.keys()
            w, s = self.generator.states, self.generator.field
            inputs = {symbol: self.maps[symbol] for symbol in wanted}
            maps, free = power_series(block, fields, inputs, w, s, self.degree)
            self.maps |= maps
            self.free += free
            self.series_used = True
            return True
        return False
