"""Parameter-varying systems with unknown inputs, and the matrices that decouple an observer from them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import ParameterError
from pointpred.observers.balance import Coordinates, balanced
from pointpred.observers.matrices import matrix
from pointpred.observers.unknown_input.boxes import Box
from pointpred.observers.unknown_input.invariant_zeros import decoupling
from pointpred.observers.unknown_input.takagi_sugeno import Scheduled, TakagiSugeno

Point = Mapping[str, float]


class ParameterVaryingSystem:
    """x' = A(p) x + b(y, u) + F(p) d, y = C x, with d unknown and p scheduled.

    Assumes that F depends on measured variables only, and that the rate of each variable it depends on is a
    scheduling variable as well: T changes with F, and the observer needs its rate.

    E = -F (C F)^+, T = I + E C, so that T F = 0; Gamma = T A + T'. With rank(C F) = rank(F) the unknown
    input does not enter e = T x - z at all.

    Parameters: ``a``, ``f`` functions of a point, n x n and n x m; ``c`` p x n; ``rates`` names for a
    variable the one that is its rate; ``decoupled`` T A as a function of a point, if it needs fewer variables
    than A; ``sizes`` of the states (n) that count alike in a certificate, by default chosen so that the
    matrices are balanced.
    Raises ParameterError for mismatched shapes.

    Reference: Benyoucef et al. 2021, equations (15), (16), (22), with the signs of (17), (18).

    >>> system = ParameterVaryingSystem(
    ...     lambda p: np.array([[-1.0, 1.0], [0.0, p["k"]]]),
    ...     lambda p: np.array([[1.0], [2.0]]),
    ...     np.array([[1.0, 0.0]]),
    ... )
    >>> system.t({"k": -3.0}).tolist()
    [[0.0, 0.0], [-2.0, 1.0]]
    """

    def __init__(
        self,
        a: Scheduled,
        f: Scheduled,
        c: FloatArray,
        *,
        rates: Mapping[str, str] | None = None,
        decoupled: Scheduled | None = None,
        sizes: Any = None,
    ) -> None:
        self._a, self._f, self._decoupled = a, f, decoupled
        self.c = _shaped("C", c, (None, None))
        self.rates = dict(rates or {})
        self.sizes = None if sizes is None else matrix("sizes", sizes, 1, self.c.shape[1])[0]
        if self.sizes is not None and (self.sizes <= 0.0).any():
            raise ParameterError(f"sizes must lie above 0, received {sizes!r}", field="sizes", value=sizes)

    def units(self, gammas: FloatArray, sigma: float) -> Coordinates:
        """The units in which a design for ``gammas`` is posed: those of ``sizes``, or balanced ones."""
        if self.sizes is None:
            return balanced(gammas, seen=self.c, rates=(sigma,))
        none = np.zeros(0)
        return Coordinates(self.sizes, np.abs(self.c * self.sizes).max(axis=1), none, none, 1.0)

    def a(self, point: Point) -> FloatArray:
        """A at a point, n x n."""
        return _shaped("A", self._a(point), (self.c.shape[1], self.c.shape[1]))

    def f(self, point: Point) -> FloatArray:
        """F at a point, n x m."""
        return _shaped("F", self._f(point), (self.c.shape[1], None))

    def e(self, point: Point) -> FloatArray:
        """E = -F (C F)^+, n x p."""
        f = self.f(point)
        value: FloatArray = -f @ np.linalg.pinv(self.c @ f)
        return value

    def t(self, point: Point) -> FloatArray:
        """T = I + E C; raises ParameterError naming the ranks if T F = 0 is impossible."""
        return decoupling(self.f(point), self.c)

    def e_rate(self, point: Point) -> FloatArray:
        """dE/dt from the rates of F's variables; exact for F affine in each of them."""
        f = self.f(point)
        moving: FloatArray = np.zeros_like(f)
        for name, rate in self.rates.items():
            slope = self.f({**point, name: point[name] + 1.0}) - f
            moving = np.asarray(moving + slope * point[rate], np.float64)
        cf, cf_rate = self.c @ f, self.c @ moving
        inverse = np.asarray(np.linalg.pinv(cf), np.float64)
        square = np.linalg.inv(cf.T @ cf)
        inverse_rate = -inverse @ cf_rate @ inverse
        inverse_rate += square @ cf_rate.T @ (np.eye(len(cf)) - cf @ inverse)
        rate_of_e: FloatArray = -(moving @ inverse + f @ inverse_rate)
        return rate_of_e

    def ta(self, point: Point) -> FloatArray:
        """T A at a point."""
        if self._decoupled is not None:
            return _shaped("T A", self._decoupled(point), (self.c.shape[1], self.c.shape[1]))
        value: FloatArray = self.t(point) @ self.a(point)
        return value

    def gamma(self, point: Point) -> FloatArray:
        """Gamma = T A + T', the error dynamics without a gain."""
        value: FloatArray = self.ta(point) + self.e_rate(point) @ self.c
        return value

    def checked(self, box: Box) -> None:
        """Raise ParameterError if the system and a box of its variables do not match."""
        for name, rate in self.rates.items():
            for one in (name, rate):
                if one not in box.names:
                    raise ParameterError(f"the box needs the axis {one}, received {', '.join(box.names)}")
        for vertex in box.vertices:
            point = box.named(vertex)
            try:
                self.t(point)
                self.ta(point)
            except KeyError as missing:
                raise ParameterError(
                    f"the system needs the variable {missing}, the box has {', '.join(box.names)}"
                ) from missing
            except ParameterError as wrong:
                raise ParameterError(f"{wrong}; at the vertex {point}") from wrong
        forces = TakagiSugeno.of(self.f, box, "F")
        for name, (low, high) in box.bounds.items():
            point = box.named(box.vertices[0])
            moved = forces.at({**point, name: high}) - forces.at({**point, name: low})
            if name not in self.rates and np.abs(moved).max() > 0.0:
                raise ParameterError(f"F varies with {name}: its rate must be a scheduling variable too")


def _shaped(name: str, value: Any, shape: tuple[int | None, int | None]) -> FloatArray:
    entries = matrix(name, value) if np.ndim(value) == 2 else np.zeros(np.shape(value))
    if entries.ndim != 2 or any(
        one not in (None, has) for one, has in zip(shape, entries.shape, strict=True)
    ):
        rows, columns = shape
        wanted = f"({rows or 'outputs'}, {columns or ('inputs' if rows else 'states')})"
        raise ParameterError(f"{name} has shape {entries.shape}, needs {wanted}", field=name, value=value)
    return entries
