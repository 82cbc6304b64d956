"""Steady states of systems in triangular form: feedback, feedforward, and one driven by the other.

Propositions 4.3.1 and 4.3.2, the second corrected, and the interlaced form (4.12), (4.13).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from pointpred.errors import ParameterError
from pointpred_observers.numerics.matrices import instance, listed
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
from pointpred_observers.triangular.ranges import StateRegion, prove_nonzero


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
