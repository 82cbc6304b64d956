"""Parameter-varying systems with unknown inputs: what decouples an observer from them, invariant zeros."""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.equalities import cleared, or_one
from pointpred_observers.numerics.matrices import TIMES, dimensions, instance, matrix, one_of, wrong
from pointpred_observers.plants.boxes import Box, Point, at_vertices, difference, samples, scheduled

RELATIVE = 1e-9
"""Singular values below this share of the largest count as zero."""


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
        self._a, self._f, self.time = scheduled("A", a), scheduled("F", f), time
        self._decoupled = None if decoupled is None else scheduled("T A", decoupled)
        self.c = _shaped("C", c)
        self.rates = dict(instance("rates", {} if rates is None else rates, dict))
        if self.rates and time == "discrete":
            raise ParameterError("a discrete system needs no rates: T is that of the step", field="rates")
        self._weights = np.ones(len(self.c))
        self.sizes = None if sizes is None else matrix("sizes", sizes, 1, self.c.shape[1])[0]
        if self.sizes is not None and (self.sizes <= 0.0).any():
            raise wrong("sizes", "must lie above 0", sizes)

    @property
    def decoupled(self) -> bool:
        """Whether T A was given."""
        return self._decoupled is not None

    def units(self, gammas: FloatArray, decay: float) -> tuple[Coordinates, float]:
        """The units of a design for ``gammas``, of ``sizes`` or balanced, and the balanced unit of time."""
        units = balanced(gammas, seen=self.c, rates=(2.0 * decay,), time=self.time)
        if self.sizes is None:
            return units, units.seconds
        none, outputs = np.zeros(0), np.abs(self.c * self.sizes).max(axis=1)
        return Coordinates(self.sizes, outputs, none, none, 1.0), units.seconds

    def weighted(self, box: Box) -> Self:
        """The same system, whose (C F)^+ weighs the outputs in balanced units if there is a choice."""
        if self.decoupled or len(self.c) == self.f(box.corners[0]).shape[1]:
            return self
        other = copy(self)
        a, driven = (np.array([of(point) for point in box.corners]) for of in (self.a, self.f))
        other._weights = 1.0 / balanced(a, seen=self.c, driven=driven, time=self.time).outputs
        return other

    def a(self, point: Point) -> FloatArray:
        """A at a point, n x n."""
        return _shaped("A", self._a(point), self.c.shape[1], self.c.shape[1])

    def f(self, point: Point) -> FloatArray:
        """F at a point, n x m."""
        return _shaped("F", self._f(point), self.c.shape[1])

    def e(self, point: Point) -> FloatArray:
        """E = -F (C F)^+, n x p."""
        f = self.f(point)
        return -f @ self._inverse(f)

    def t(self, point: Point, *, check: bool = True) -> FloatArray:
        """T = I + E C; with ``check`` raises ParameterError naming the ranks if T F = 0 is impossible."""
        if check:
            return decoupling(self.f(point), self._weights[:, None] * self.c)
        return cleared((np.eye(self.c.shape[1]),), (self.e(point), self.c))

    def ta(self, point: Point) -> FloatArray:
        """T A at a point."""
        if self._decoupled is not None:
            return _shaped("T A", self._decoupled(point), self.c.shape[1], self.c.shape[1])
        return cleared((self.t(point, check=False), self.a(point)))

    def e_rate(self, point: Point) -> FloatArray:
        """dE/dt from the rates of F's variables; exact for F affine in each, zero in discrete time."""
        f, moving = self.f(point), self._f_rate(point)
        x, w = self._inverse(f), self._weights
        # X' = -X C F' X + ((W C F)' W C F)^-1 (W C F')' W (I - C F X), X = (W C F)^+ W
        rest = (w[:, None] * (self.c @ moving)).T * w @ (np.eye(len(self.c)) - self.c @ f @ x)
        rate: FloatArray = -moving @ x + f @ (x @ self.c @ moving @ x - (x / w) @ (x / w).T @ rest)
        return rate

    def gamma(self, point: Point) -> FloatArray:
        """Gamma = T A + T' (in discrete time T A), the error dynamics without a gain."""
        ta = self.ta(point)
        return cleared((ta,), (self.e_rate(point), self.c)) if self.rates else ta

    def at_vertices(self, box: Box) -> tuple[FloatArray, FloatArray]:
        """Gamma and T at each vertex; raises ParameterError where one is not affine in each variable."""
        gammas = at_vertices(self.gamma, box, "Gamma = T A + T'", self._gamma_terms)
        return gammas, at_vertices(self.t, box, "T", self._t_terms)

    def _inverse(self, f: FloatArray) -> FloatArray:
        """(W C F)^+ W, W the weights of the outputs."""
        return np.asarray(np.linalg.pinv(self._weights[:, None] * (self.c @ f)) * self._weights)

    def _f_rate(self, point: Point, *, sizes: bool = False) -> FloatArray:
        """dF/dt, or the ``sizes`` of its terms."""
        f = self.f(point)
        total = np.zeros_like(f)
        for name, rate in self.rates.items():
            ahead = self.f({**point, name: point[name] + 1.0})
            slope = np.abs(ahead) + np.abs(f) if sizes else ahead - f
            total = total + slope * (abs(point[rate]) if sizes else point[rate])
        return np.asarray(total, np.float64)

    def _inverse_terms(self, point: Point) -> tuple[FloatArray, FloatArray, FloatArray]:
        """abs(F), the sizes of the terms of (C F)^+, and abs(C): entries may be small differences of them."""
        f, c = self.f(point), np.abs(self.c)
        x = np.abs(self._inverse(f))
        return np.abs(f), np.asarray(x @ c @ np.abs(f) @ x, np.float64), c

    def _t_terms(self, point: Point) -> FloatArray:
        """The sizes of the terms of T, of which its entries may be small differences."""
        f, x, c = self._inverse_terms(point)
        return np.asarray(np.eye(self.c.shape[1]) + f @ x @ c, np.float64)

    def _gamma_terms(self, point: Point) -> FloatArray:
        """The same of Gamma."""
        given = self._decoupled is not None
        terms = np.abs(self.ta(point)) if given else self._t_terms(point) @ np.abs(self.a(point))
        if not self.rates:
            return terms
        (f, x, c), w, moving = self._inverse_terms(point), self._weights, self._f_rate(point, sizes=True)
        rest = (w[:, None] * (c @ moving)).T * w @ (np.eye(len(c)) + c @ f @ x)
        moved = moving @ x + f @ (x @ c @ moving @ x + (x / w) @ (x / w).T @ rest)
        return np.asarray(terms + moved @ c, np.float64)

    def checked(self, box: Box) -> None:
        """Raise ParameterError if the system and a box of its variables do not match."""
        axes = ", ".join(instance("box", box, Box).names)
        for one in (*self.rates, *self.rates.values()):
            if one not in box.names:
                raise ParameterError(f"the box needs the axis {one}, received {axes}")
        for point in box.corners:
            try:
                self.t(point)
                self.ta(point)
            except KeyError as missing:
                words = f"the system needs the variable {missing}, the box has {axes}"
                raise ParameterError(words) from missing
            except ParameterError as wrong:
                raise ParameterError(f"{wrong}; at the vertex {point}") from wrong
        self._require_decoupled(box)
        if self.time == "discrete":
            return
        forces = at_vertices(self.f, box, "F")
        for name, (low, high) in box.bounds.items():
            first, last = (box.mixed(forces, {**box.corners[0], name: end}) for end in (low, high))
            if name not in self.rates and not np.array_equal(first, last):
                raise ParameterError(f"F varies with {name}: its rate must be a scheduling variable too")

    def _require_decoupled(self, box: Box) -> None:
        """Raise ParameterError unless the given T A is T times A, where the box has A's variables."""
        if not self.decoupled:
            return
        points = box.corners + samples(box)
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
            where = f"they differ by {error:.3g} in row {row + 1}, column {column + 1}"
            raise ParameterError(f"TA must be T times A, T = I - F (C F)^+ C: {where}", field="TA")


class CornerSystem(ParameterVaryingSystem):
    """x' = A(p) x + b(y, u) + F(p) d, y = C x by the matrices at the corners of a box: it can be saved.

    Affine in each scheduling variable; with one variable the corners are its low and its high end.

    Parameters: ``box``; ``A``, ``F`` and, if it is given, ``TA`` (T A where it needs fewer variables than A):
    a matrix, or one for each vertex of ``box.vertices`` in its order, (vertices, rows, columns); ``C`` p x n;
    ``rates``, ``sizes``, ``time`` as for ``ParameterVaryingSystem``. Raises ParameterError.

    >>> box = Box({"k": (-3.0, -1.0)})
    >>> system = CornerSystem(box, [[[0, 1], [0, -3]], [[0, 1], [0, -1]]], [[1], [0]], [[1, 0]])
    >>> system.a({"k": -2.0}).tolist()
    [[0.0, 1.0], [0.0, -2.0]]
    """

    def __init__(
        self,
        box: Box,
        A: Any,
        F: Any,
        C: Any,
        *,
        TA: Any = None,
        rates: Mapping[str, str] | None = None,
        sizes: Any = None,
        time: str = "continuous",
    ) -> None:
        self.box = instance("box", box, Box)
        given = {"A": A, "F": F} | ({} if TA is None else {"TA": TA})
        self.corners = {name: _held(box, name, one) for name, one in given.items()}
        a, f, *ta = (CornerMatrix(box, one) for one in self.corners.values())
        decoupled, outputs, n = ta[0] if ta else None, C, self.corners["A"].shape[2]
        if self.corners["F"].shape[1] == n:  # else C may be right, and A wrong
            outputs = matrix("C", C, None, n)
        super().__init__(a, f, outputs, rates=rates, decoupled=decoupled, sizes=sizes, time=time)
        self.checked(box)

    @classmethod
    def of(cls, system: ParameterVaryingSystem, box: Box) -> Self:
        """The matrices of a system at the corners.

        Raises ParameterError unless A and F are affine in each variable: nothing else would be known of them
        between the corners; also where A needs a variable that the box lacks.
        """
        instance("system", system, ParameterVaryingSystem)
        try:
            drift = at_vertices(system.a, box, "A")
        except KeyError as missing:
            words = f"A needs the variable {missing}, the box has {', '.join(box.names)}"
            raise ParameterError(f"{words}: take a box that has every variable of A", field="A") from missing
        forces = at_vertices(system.f, box, "F")
        ta = at_vertices(system.ta, box, "T A") if system.decoupled else None
        kept = {name: getattr(system, name) for name in ("rates", "sizes", "time")}
        return cls(box, drift, forces, system.c, TA=ta, **kept)


class CornerMatrix:
    """A matrix that is affine in each variable of a box, also beyond it; exact at the corners."""

    def __init__(self, box: Box, values: FloatArray) -> None:
        wide = [(name, pair) for name, pair in box.bounds.items() if pair[0] < pair[1]]
        self._mixed = values.reshape((2,) * len(wide) + values.shape[1:])
        self._axes: list[tuple[str, float, float]] = []
        for name, (low, high) in wide:
            place = len(self._axes)
            first, last = np.take(self._mixed, 0, place), np.take(self._mixed, 1, place)
            if np.array_equal(first, last):
                self._mixed = first
            else:
                self._axes.append((name, low, high))

    def __call__(self, point: Point) -> FloatArray:
        """The matrix at a point; raises KeyError for a variable that it needs and the point lacks."""
        mixed = self._mixed
        for name, low, high in self._axes:
            share = (point[name] - low) / (high - low)
            at_end = share in (0.0, 1.0)
            mixed = mixed[int(share)] if at_end else (1.0 - share) * mixed[0] + share * mixed[1]
        return mixed


def _held(box: Box, name: str, given: Any) -> FloatArray:
    count = len(box.vertices)
    if dimensions(given) != 3:
        return np.repeat(matrix(name, given)[None], count, axis=0)
    if len(given) != count:
        must = f"needs a matrix, or {count} of them, one for each corner of the box"
        raise wrong(name, must, len(given))
    return np.array([matrix(name, one) for one in given])


def invariant_zeros(a: Any, f: Any, c: Any = None) -> NDArray[np.complex128]:
    """The invariant zeros of x' = A x + F d, y = C x, where d is unknown; needs no solver.

    Assumes rank(C F) = rank(F) = columns of F, so that d can be decoupled; raises ParameterError otherwise.
    Rank decisions are made at 1e-9: zeros of nearly cancelling systems may be found or missed.

    The zeros are the values s where [[A - s I, F], [C, 0]] loses rank: the eigenvalues of T A on its
    unobservable subspace, T = I - F (C F)^+ C. No gain moves them: errors in those modes decay or grow at
    these rates.

    Parameters: the matrices A (n, n), F (n, m), C (p, n); or a ``ParameterVaryingSystem`` and its ``Box``.
    Returns the zeros, complex, the slowest first; of a system one row per vertex of the box.

    Reference: Darouach, Zasadzinski, Xu 1994, theorem 2; the pencil is Rosenbrock's.

    >>> a = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 0.0], [0.0, 1.0, -2.0]])
    >>> f, c = np.array([[1.0], [0.0], [0.0]]), np.array([[1.0, 0.0, 0.0]])
    >>> invariant_zeros(a, f, c).real.tolist()
    [0.0, -2.0]
    """
    if not isinstance(a, ParameterVaryingSystem):
        n = len(matrix("A", a))
        one = ParameterVaryingSystem(matrix("A", a, n, n), matrix("F", f, n), matrix("C", c, None, n))
        return fixed_modes(one.ta({}), one.c)
    rows = [fixed_modes(a.ta(point), a.c) for point in instance("box", f, Box).corners]
    counts = [len(row) for row in rows]
    if min(counts) != max(counts):
        between = f"it lies between {min(counts)} and {max(counts)}"
        raise ParameterError(f"the number of invariant zeros must not change over the box, {between}")
    return np.array(rows).reshape(len(rows), counts[0])


def _shaped(name: str, value: Any, rows: int | None = None, columns: int | None = None) -> FloatArray:
    """A matrix of a caller, as it is where it fits: so it is at every sample."""
    if isinstance(value, np.ndarray) and value.dtype == np.float64 and value.ndim == 2:
        fits = rows in (None, value.shape[0]) and columns in (None, value.shape[1])
        if fits and np.isfinite(value).all():
            return value
    return matrix(name, value, rows, columns)


def kernel(rows: FloatArray, size: float | None = None) -> FloatArray:
    """An orthonormal basis of the null space, a vector a column; ``size`` in place of the largest value."""
    _, sizes, right = np.linalg.svd(np.atleast_2d(rows))
    rank = int((sizes > RELATIVE * (sizes.max(initial=0.0) if size is None else size)).sum())
    return np.asarray(right[rank:].T, np.float64)


def independent(c: FloatArray) -> tuple[FloatArray, FloatArray]:
    """R and C' with C = R C', R'R = I and independent rows in C'; R is the identity if C has such rows."""
    left, sizes, right = np.linalg.svd(c, full_matrices=False)
    rank = int((sizes > RELATIVE * sizes.max(initial=0.0)).sum())
    if rank == len(c):
        return np.eye(rank), c
    return np.asarray(left[:, :rank], np.float64), np.asarray(sizes[:rank, None] * right[:rank], np.float64)


def unobservable(gamma: FloatArray, c: FloatArray) -> FloatArray:
    """An orthonormal basis of the largest subspace inside ker C that Gamma maps into itself."""
    basis, size = kernel(c), float(np.linalg.norm(gamma, 2))
    while basis.shape[1]:
        moved = gamma @ basis
        leaving = moved - basis @ (basis.T @ moved)
        staying = kernel(leaving, size)
        if staying.shape[1] == basis.shape[1]:
            break
        basis = basis @ staying
    return basis


def fixed_modes(gamma: FloatArray, c: FloatArray) -> NDArray[np.complex128]:
    """The eigenvalues of Gamma that Gamma - K C keeps for every K, complex, the slowest first."""
    units = balanced(gamma, seen=c)
    gamma = inward(gamma, units.states, units.states)
    basis = unobservable(gamma, inward(c, units.outputs, units.states))
    if not basis.shape[1]:
        return np.zeros(0, dtype=np.complex128)
    zeros: NDArray[np.complex128] = np.linalg.eigvals(basis.T @ gamma @ basis).astype(np.complex128)
    return zeros[np.argsort(-zeros.real, kind="stable")]


def _rank(entries: FloatArray, sizes: FloatArray) -> int:
    """The rank in any units; ``sizes`` are those of the terms of each entry."""
    rows = or_one(sizes.max(axis=1, initial=0.0))
    columns = or_one((sizes / rows[:, None]).max(axis=0, initial=0.0))
    return int(np.linalg.matrix_rank(entries / rows[:, None] / columns, tol=RELATIVE))


def decoupling(f: FloatArray, c: FloatArray) -> FloatArray:
    """T = I - F (C F)^+ C, with T F = 0; raises ParameterError naming the ranks if there is none."""
    if f.ndim != 2 or c.ndim != 2 or f.shape[0] != c.shape[1]:
        raise ParameterError(f"C F must exist: F has shape {f.shape}, C has shape {c.shape}")
    if not f.shape[1]:
        raise ParameterError("F needs a column for each unknown input, received none")
    cf = c @ f
    rank_cf, rank = _rank(cf, np.abs(c) @ np.abs(f)), _rank(f, np.abs(f))
    if rank < f.shape[1]:
        raise ParameterError(f"F must have full column rank {f.shape[1]}, its rank is {rank}")
    if rank_cf < rank:
        ranks = f"rank(C F) = {rank_cf} < rank(F) = {rank}"
        raise ParameterError(f"rank(C F) must equal rank(F): {ranks}, an unknown input is not seen directly")
    return cleared((np.eye(len(f)),), (-(f @ np.linalg.pinv(cf)), c))
