"""Parameter-varying systems with unknown inputs, and the matrices that decouple an observer from them."""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from typing import Any, Self

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.balance import Coordinates, balanced
from pointpred_observers.equalities import without_rounding
from pointpred_observers.matrices import TIMES, dimensions, instance, matrix, one_of
from pointpred_observers.unknown_input.boxes import Box
from pointpred_observers.unknown_input.invariant_zeros import decoupling
from pointpred_observers.unknown_input.takagi_sugeno import (
    TakagiSugeno,
    corners,
    difference,
    samples,
    scheduled,
)

Point = Mapping[str, float]


class ParameterVaryingSystem:
    """x' = A(p) x + b(y, u) + F(p) d, y = C x, with d unknown and p scheduled.

    In discrete time x' is the next x. Assumes that F depends on measured variables only, and in continuous
    time that the rate of each variable it depends on is a scheduling variable as well: T changes with F,
    and the observer needs its rate. Where a box has the variables of A, ``decoupled`` is compared with T A;
    where it lacks one, ``decoupled`` is assumed to be right.

    E = -F (C F)^+, T = I + E C, so that T F = 0; Gamma = T A + T'. With rank(C F) = rank(F) the unknown
    input does not enter e = T x - z at all.

    Parameters: ``a``, ``f`` n x n and n x m, each a matrix or a function of a point; ``c`` p x n;
    ``rates`` names for a variable the one that is its rate; ``decoupled`` T A as a function of a point, if
    it needs fewer variables than A; ``sizes`` of the states (n) that count alike in a certificate, by
    default chosen so that the matrices are balanced (with ``sizes`` the design depends on the unit of time:
    gamma, a time, is weighed against P, which has no unit); ``time`` "continuous" or "discrete".
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
        a: Any,
        f: Any,
        c: Any,
        *,
        rates: Mapping[str, str] | None = None,
        decoupled: Any = None,
        sizes: Any = None,
        time: str = "continuous",
    ) -> None:
        one_of("time", time, TIMES)
        a, f = scheduled("A", a), scheduled("F", f)
        decoupled = None if decoupled is None else scheduled("T A", decoupled)
        self._a, self._f, self._decoupled, self.time = a, f, decoupled, time
        self.c = _shaped("C", c, (None, None))
        self.rates = dict(instance("rates", {} if rates is None else rates, dict))
        if self.rates and time == "discrete":
            raise ParameterError("a discrete system needs no rates: T is that of the step", field="rates")
        self._weights = np.ones(len(self.c))
        self._latest_e = b"", np.zeros(self.c.T.shape)
        self.sizes = None if sizes is None else matrix("sizes", sizes, 1, self.c.shape[1])[0]
        if self.sizes is not None and (self.sizes <= 0.0).any():
            raise ParameterError(f"sizes must lie above 0, received {sizes!r}", field="sizes", value=sizes)

    @property
    def decoupled(self) -> bool:
        """Whether T A was given."""
        return self._decoupled is not None

    def units(self, gammas: FloatArray, sigma: float) -> Coordinates:
        """The units in which a design for ``gammas`` is posed: those of ``sizes``, or balanced ones."""
        if self.sizes is None:
            return balanced(gammas, seen=self.c, rates=(sigma,), time=self.time)
        none = np.zeros(0)
        return Coordinates(self.sizes, np.abs(self.c * self.sizes).max(axis=1), none, none, 1.0)

    def natural_seconds(self, gammas: FloatArray, sigma: float) -> float:
        """The unit of time in which a design for ``gammas`` is balanced, whatever ``sizes`` are."""
        return balanced(gammas, seen=self.c, rates=(sigma,), time=self.time).seconds

    def weighted(self, box: Box) -> Self:
        """The same system, whose (C F)^+ weighs the outputs in balanced units if there is a choice.

        With more outputs than unknown inputs there are many inverses of C F; the one of plain least squares
        would depend on the units of the outputs.
        """
        points = [box.named(vertex) for vertex in box.vertices]
        if self.decoupled or len(self.c) == self.f(points[0]).shape[1]:
            return self
        other = copy(self)
        a = np.array([self.a(point) for point in points])
        driven = np.array([self.f(point) for point in points])
        units = balanced(a, seen=self.c, driven=driven, time=self.time)
        other._weights, other._latest_e = 1.0 / units.outputs, (b"", self._latest_e[1])
        return other

    def a(self, point: Point) -> FloatArray:
        """A at a point, n x n."""
        return _shaped("A", self._a(point), (self.c.shape[1], self.c.shape[1]))

    def f(self, point: Point) -> FloatArray:
        """F at a point, n x m."""
        return _shaped("F", self._f(point), (self.c.shape[1], None))

    def e(self, point: Point) -> FloatArray:
        """E = -F (C F)^+, n x p."""
        f, w = self.f(point), self._weights
        # F is often constant, and the inverse is most of the cost of a step.
        same = f.tobytes()
        if same != self._latest_e[0]:
            self._latest_e = same, -f @ np.linalg.pinv(w[:, None] * (self.c @ f)) * w
        return self._latest_e[1]

    def t(self, point: Point, *, check: bool = True) -> FloatArray:
        """T = I + E C; raises ParameterError naming the ranks if T F = 0 is impossible.

        Without ``check`` it is computed in any case, and faster.
        """
        if check:
            return decoupling(self.f(point), self._weights[:, None] * self.c)
        e, one = self.e(point), np.eye(self.c.shape[1])
        return without_rounding(one + e @ self.c, one, np.abs(e) @ np.abs(self.c))

    def e_rate(self, point: Point) -> FloatArray:
        """dE/dt from the rates of F's variables; exact for F affine in each, zero in discrete time."""
        f = self.f(point)
        if not self.rates:
            return np.zeros(self.c.T.shape)
        moving: FloatArray = np.zeros_like(f)
        for name, rate in self.rates.items():
            slope = self.f({**point, name: point[name] + 1.0}) - f
            moving = np.asarray(moving + slope * point[rate], np.float64)
        cf, cf_rate = (self._weights[:, None] * (self.c @ one) for one in (f, moving))
        inverse = np.asarray(np.linalg.pinv(cf), np.float64)
        square = np.linalg.inv(cf.T @ cf)
        inverse_rate = -inverse @ cf_rate @ inverse
        inverse_rate += square @ cf_rate.T @ (np.eye(len(cf)) - cf @ inverse)
        rate_of_e: FloatArray = -(moving @ inverse + f @ inverse_rate) * self._weights
        return rate_of_e

    def ta(self, point: Point) -> FloatArray:
        """T A at a point."""
        if self._decoupled is not None:
            return _shaped("T A", self._decoupled(point), (self.c.shape[1], self.c.shape[1]))
        t, a = self.t(point, check=False), self.a(point)
        return without_rounding(t @ a, np.abs(t) @ np.abs(a))

    def gamma(self, point: Point) -> FloatArray:
        """Gamma = T A + T' (in discrete time T A), the error dynamics without a gain."""
        ta, moving = self.ta(point), self.e_rate(point)
        return without_rounding(ta + moving @ self.c, ta, np.abs(moving) @ np.abs(self.c))

    def at_vertices(self, box: Box) -> tuple[FloatArray, FloatArray]:
        """Gamma and T at each vertex; raises ParameterError where one is not affine in each variable."""
        gammas = TakagiSugeno.of(self.gamma, box, "Gamma = T A + T'", terms=self._gamma_terms)
        return gammas.matrices, TakagiSugeno.of(self.t, box, "T", terms=self._t_terms).matrices

    def _inverse_terms(self, point: Point) -> FloatArray:
        """The sizes of the terms of X = (W C F)^+, W the weights: X = X (W C F) X."""
        f, c = self.f(point), self._weights[:, None] * self.c
        inverse = np.abs(np.linalg.pinv(c @ f))
        return np.asarray(inverse @ np.abs(c) @ np.abs(f) @ inverse, np.float64)

    def _t_terms(self, point: Point) -> FloatArray:
        """The sizes of the terms of T, of which its entries may be small differences."""
        onto = np.abs(self.f(point)) @ self._inverse_terms(point) * self._weights
        return np.asarray(np.eye(self.c.shape[1]) + onto @ np.abs(self.c), np.float64)

    def _gamma_terms(self, point: Point) -> FloatArray:
        """The same of Gamma."""
        if self._decoupled is not None:
            terms = np.abs(self.ta(point))
        else:
            terms = self._t_terms(point) @ np.abs(self.a(point))
        return np.asarray(terms + self._e_rate_terms(point) @ np.abs(self.c), np.float64)

    def _e_rate_terms(self, point: Point) -> FloatArray:
        """The same of dE/dt."""
        if not self.rates:
            return np.zeros(self.c.T.shape)
        f = np.abs(self.f(point))
        moving: FloatArray = np.zeros_like(f)
        for name, rate in self.rates.items():
            ahead = np.abs(self.f({**point, name: point[name] + 1.0}))
            moving = np.asarray(moving + (ahead + f) * abs(point[rate]), np.float64)
        c, inverse = np.abs(self._weights[:, None] * self.c), self._inverse_terms(point)
        turned = inverse @ c @ moving @ inverse
        turned += inverse @ inverse.T @ (c @ moving).T @ (np.eye(len(c)) + c @ f @ inverse)
        return np.asarray((moving @ inverse + f @ turned) * self._weights, np.float64)

    def checked(self, box: Box) -> None:
        """Raise ParameterError if the system and a box of its variables do not match."""
        instance("box", box, Box)
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
        self._require_decoupled(box)
        if self.time == "discrete":
            return
        forces = TakagiSugeno.of(self.f, box, "F")
        for name, (low, high) in box.bounds.items():
            point = box.named(box.vertices[0])
            moved = forces.at({**point, name: high}) - forces.at({**point, name: low})
            if name not in self.rates and np.abs(moved).max() > 0.0:
                raise ParameterError(f"F varies with {name}: its rate must be a scheduling variable too")

    def _require_decoupled(self, box: Box) -> None:
        """Raise ParameterError unless the given T A is T times A, where the box has A's variables."""
        if not self.decoupled:
            return
        points = corners(box) + samples(box)
        try:
            drift = [self.a(point) for point in points]
        except KeyError:
            return
        given = np.array([self.ta(point) for point in points])
        product = np.array([self.t(point) @ a for point, a in zip(points, drift, strict=True)])
        terms = [self._t_terms(point) @ np.abs(a) for point, a in zip(points, drift, strict=True)]
        place = difference(given, product, given, np.array(terms))
        if place is not None:
            row, column, error = place
            raise ParameterError(
                f"TA must be T times A, T = I - F (C F)^+ C: they differ by {error:.3g} in row {row + 1}, "
                f"column {column + 1}; correct it, or leave TA out, then it is computed",
                field="TA",
            )


def _shaped(name: str, value: Any, shape: tuple[int | None, int | None]) -> FloatArray:
    uneven = dimensions(value) == 0 and isinstance(value, list | tuple)  # rows of different lengths
    entries = matrix(name, value) if uneven or dimensions(value) == 2 else np.zeros(np.shape(value))
    if entries.ndim != 2 or any(
        one not in (None, has) for one, has in zip(shape, entries.shape, strict=True)
    ):
        rows, columns = shape
        wanted = f"({rows or 'outputs'}, {columns or ('inputs' if rows else 'states')})"
        raise ParameterError(f"{name} has shape {entries.shape}, needs {wanted}", field=name, value=value)
    return entries
