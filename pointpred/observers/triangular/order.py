"""The order in which the equations of a triangular system determine its steady state, and their solution.

Rows of the lower part give the next state or the input by division, exactly (Proposition 4.3.1). Rows of the
upper part and the zero dynamics give their own states by power series (Proposition 4.3.2).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pointpred.errors import ParameterError
from pointpred_observers.matrices import instance, listed
from pointpred_observers.triangular.nonzero import prove_nonzero
from pointpred_observers.triangular.polynomials import exact, symbolic
from pointpred_observers.triangular.power_series import Free, power_series
from pointpred_observers.triangular.regions import Region
from pointpred_observers.triangular.system import (
    HIGHEST_DEGREE,
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    vanishes,
)


class Solving:
    """The maps solved so far, and the rules that solve the next one."""

    def __init__(
        self,
        system: SymbolicSystem,
        generator: SymbolicGenerator,
        maps: Mapping[Any, Any],
        *,
        upper: int,
        zero: Sequence[Any] | None,
        degree: int | None,
        region: Region,
    ) -> None:
        instance("system", system, SymbolicSystem)
        instance("generator", generator, SymbolicGenerator)
        self.system, self.generator, self.region, self.degree = system, generator, region, degree
        if degree is not None and (not isinstance(degree, int) or not 1 <= degree <= HIGHEST_DEGREE):
            raise ParameterError(
                f"degree must be a whole number in [1, {HIGHEST_DEGREE}], received {degree!r}",
                field="degree",
                value=degree,
            )
        self.maps = {symbol: self._of_generator(symbol, e) for symbol, e in maps.items()}
        self.rows = dict(zip(system.states, system.field, strict=True))
        self.up, self.low = list(system.states[:upper])[::-1], list(system.states[upper:])
        self.next = dict(zip(self.low, [*self.low[1:], system.input], strict=False))
        self.symbols = {*system.states, *system.zero, system.input}
        self.free: list[Free] = []
        self.series_used = False
        self.divided: list[Any] = []
        self.imposed: tuple[Any, ...] = ()
        self._check_form(upper)
        if zero is not None:
            if len(listed("zero", zero)) != len(system.zero):
                raise ParameterError(
                    f"zero must hold {len(system.zero)} maps, received {len(zero)}", field="zero"
                )
            self.maps |= {z: self._of_generator(z, e) for z, e in zip(system.zero, zero, strict=True)}
            self.imposed = system.zero

    def solve(self) -> SymbolicSteadyState:
        """Apply the rules until every map is solved; raises ParameterError if no rule applies."""
        while self._divide() or self._expand():
            pass
        if waiting := [x for x in (*self.system.states, *self.system.zero) if x not in self.maps]:
            needs = "; ".join(f"{x}' needs {self._missing(x)}" for x in self.rows if self._missing(x))
            raise ParameterError(f"no order of solving leads to {waiting}: {needs}")
        states, zero = self.system.states, self.system.zero
        fields = (*self.system.field, *self.system.zero_field)
        residuals = []
        for x, field in zip((*states, *zero), fields, strict=True):
            if x in self.divided:
                residuals.append(symbolic().Integer(0))
                continue
            after = field.subs(self.maps, simultaneous=True)
            residuals.append(vanishes(self.generator.along(self.maps[x]) - after)[1])
            if x in self.imposed and not self.series_used and residuals[-1] != 0:
                raise ParameterError(
                    f"{x}' is not satisfied by {x} = {self.maps[x]}: the residual is {residuals[-1]}"
                )
        return SymbolicSteadyState(
            self.system,
            self.generator,
            tuple(self.maps[x] for x in states),
            tuple(self.maps[z] for z in zero),
            self.maps[self.system.input],
            tuple(residuals),
            all(residual == 0 for residual in residuals),
            self.degree if self.series_used else None,
            tuple(self.free),
        )

    def _missing(self, x: Any, besides: frozenset[Any] = frozenset()) -> list[Any]:
        wanted = self.rows[x].free_symbols & self.symbols
        return sorted(wanted - self.maps.keys() - besides - {x}, key=str)

    def _divide(self) -> bool:
        """Proposition 4.3.1: a row of the lower part gives the unknown that it contains first."""
        for x, target in self.next.items():
            if x in self.maps and target not in self.maps and not self._missing(x, frozenset({target})):
                gain = symbolic().diff(self.rows[x], target)
                drift = self.rows[x].subs(target, 0).subs(self.maps, simultaneous=True)
                over = gain.subs(self.maps, simultaneous=True)
                prove_nonzero(f"g of {x}'", over, self.generator.states, self.region)
                self.divided.append(x)
                self.maps[target] = vanishes((self.generator.along(self.maps[x]) - drift) / over)[1]
                return True
        return False

    def _expand(self) -> bool:
        """Proposition 4.3.2: a row of the upper part, or the zero dynamics, as a power series."""
        zero = [z for z in self.system.zero if z not in self.maps]
        for block in ([x for x in self.up if x not in self.maps][:1], zero):
            fields = [self._field(x) for x in block]
            wanted = set().union(*(f.free_symbols for f in fields)) & self.symbols - {*block}
            if not block or wanted - self.maps.keys():
                continue
            if self.degree is None:
                raise ParameterError(f"{block[0]}' needs a power series: give its degree, received None")
            inputs = {symbol: self.maps[symbol] for symbol in wanted}
            w, s = self.generator.states, self.generator.field
            series = power_series(block, fields, inputs, w, s, self.degree)
            self.maps |= series.terms
            self.free += series.free
            self.series_used = True
            return True
        return False

    def _field(self, x: Any) -> Any:
        if x in self.rows:
            return self.rows[x]
        return self.system.zero_field[self.system.zero.index(x)]

    def _of_generator(self, symbol: Any, expression: Any) -> Any:
        function = exact(expression)
        if foreign := function.free_symbols & {*self.system.states, *self.system.zero, self.system.input}:
            raise ParameterError(f"{symbol} must be a function of the generator, received {foreign}")
        return function

    def _check_form(self, upper: int) -> None:
        """Raise ParameterError for a row that the triangular form does not allow."""
        for i, x in enumerate(self.system.states):
            used = self.rows[x].free_symbols & self.symbols
            if i < upper:
                wrong = used & {*self.system.states[:i], *([self.system.input] if self.low else [])}
                allowed = "itself, later states and the zero dynamics"
            else:
                target = self.next[x]
                wrong = used & {*self.system.states[i + 1 :], self.system.input} - {target}
                allowed = f"{target}, earlier states and the zero dynamics"
                slope = symbolic().diff(self.rows[x], target)
                if slope.has(target):
                    raise ParameterError(f"{x}' must be affine in {target}, received {self.rows[x]}")
            if wrong:
                raise ParameterError(f"{x}' may contain {allowed}, received {sorted(map(str, wrong))}")
