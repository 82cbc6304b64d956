"""The choice of Upsilon: those that the equalities allow, and one that satisfies the theorem's inequality."""

from __future__ import annotations

from math import exp
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.equalities import NO_DIGIT, without_rounding
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.inequalities.unknowns import Block
from pointpred_observers.matrices import matrix
from pointpred_observers.persidskii import Persidskii
from pointpred_observers.reduced_order.reversed_certificate import lipschitz, symmetric
from pointpred_observers.stationary import cover, filter_start, middle

SLACK = 1e3
"""Offset of the slack, since unknown numbers must not be negative."""
TURNS_MOST = 30
"""Most alternations between P and Upsilon before the search stops."""


class Split(msgspec.Struct, frozen=True):
    """The plant in the coordinates (Pi x, y): the observer's matrices are affine in Upsilon.

    S0 = ``drift`` + Upsilon ``seen``, S1 = ``driven`` + Upsilon ``shown``, J = ``inner``, and R =
    ``outer`` - J Upsilon.
    """

    drift: FloatArray
    seen: FloatArray
    driven: FloatArray
    shown: FloatArray
    inner: FloatArray
    outer: FloatArray


def split(plant: Persidskii, Pi: Any) -> Split:
    """The plant with its measured combinations as coordinates; raises ParameterError if that is impossible.

    >>> plant = Persidskii([[0.0, 1.0], [-3.0, -1.0]], None, None, "sin", C0=[1.0, 0.0])
    >>> one = split(plant, [[0.0, 1.0]])
    >>> one.drift.tolist(), one.seen.tolist()
    ([[-1.0]], [[1.0]])
    """
    if plant.varying:
        raise ParameterError(f"a design needs constant matrices; {', '.join(plant.varying)} vary")
    if plant.C1.any():
        raise ParameterError("a reduced-order design needs y = C0 x, received C1 other than 0")
    q = plant.n - plant.p
    if q < 1:
        raise ParameterError(f"all {plant.n} states are measured by {plant.p} outputs: nothing to observe")
    pi = matrix("Pi", Pi, q, plant.n)
    both = np.vstack([pi, plant.C0])
    least = float(np.linalg.svd(both, compute_uv=False)[-1])
    if least <= 1e-9 * float(np.linalg.norm(both, 2)):
        raise ParameterError(
            f"the rows of Pi and C0 must be independent, their least singular value is {least:.3g}"
        )
    inverse = np.linalg.inv(both)
    inverse = without_rounding(inverse, np.abs(inverse) @ np.abs(both) @ np.abs(inverse), share=NO_DIGIT)
    hidden, measured = inverse[:, :q], inverse[:, q:]
    return Split(
        _product(pi, plant.A0, hidden),
        _product(plant.C0, plant.A0, hidden),
        _product(pi, plant.A1),
        _product(plant.C0, plant.A1),
        _product(plant.H, hidden),
        _product(plant.H, measured),
    )


def _product(*factors: FloatArray) -> FloatArray:
    """The product of matrices without the entries that are only its rounding."""
    whole, sizes = factors[0], np.abs(factors[0])
    for one in factors[1:]:
        whole, sizes = whole @ one, sizes @ np.abs(one)
    return without_rounding(whole, sizes, share=NO_DIGIT)


def allowed(parts: Split, tied: bool) -> tuple[FloatArray, FloatArray]:
    """U0 and N of all Upsilon = U0 + N K with J Z = H; every Upsilon if there is no constraint."""
    q, p = len(parts.drift), len(parts.seen)
    if not tied:
        return np.zeros((q, p)), np.eye(q)
    base = np.asarray(np.linalg.lstsq(parts.inner, parts.outer, rcond=None)[0])
    residual = float(np.abs(parts.inner @ base - parts.outer).max(initial=0.0))
    if residual > 1e-9 * max(1.0, float(np.abs(parts.outer).max(initial=0.0))):
        raise InfeasibleError(
            f"J (Pi + Upsilon C0) - H = 0 cannot hold for any Upsilon: its residual is {residual:.3g}; "
            "injection=True lets the output into f"
        )
    _, singular, rows = np.linalg.svd(parts.inner)
    rank = int((singular > 1e-9 * max(1.0, float(singular.max(initial=0.0)))).sum())
    return base, np.asarray(rows[rank:].T, np.float64)


class InjectionSearch(msgspec.Struct, frozen=True):
    """The search for Upsilon = ``base`` + ``free`` K such that one P proves the decay within the slopes.

    V' <= -``rate`` V (V+ <= exp(-``rate``) V in discrete time). With V an orthonormal complement of N =
    ``free``, every P > 0 is V P1 V' + T P2 T' with T = N + V X', and P Upsilon = P U0 + T (P2 K): linear in
    P1, P2 and P2 K for a fixed X. If N is square there is no X and no conservatism; else X and K are improved
    alternately, each time by the solver.
    """

    parts: Split
    corners: dict[str, FloatArray]
    """Of the slopes; none if f does not matter."""
    slopes: tuple[tuple[float, float], ...] | None
    time: str
    base: FloatArray
    free: FloatArray
    rate: float

    def made(self) -> tuple[FloatArray, float, dict[str, Any]]:
        """An Upsilon with a small output injection, the gap of its size, and its P with W or alpha."""
        unneeded = self._without_injection()
        if unneeded is not None:
            return self.base, 0.0, unneeded
        tilt = self.free
        rest = np.linalg.svd(self.free.T)[2][self.free.shape[1] :].T
        if rest.shape[1]:
            self._require_free_choice()
            tilt = self._tilted(rest)
        problem = self._problem(tilt, rest, slack=False).number("size")
        problem.above(
            "size - K2' P2^-1 K2",
            lambda v: np.block([[v.size * np.eye(len(self.parts.seen)), v.K2.T], [v.K2, v.P2]]),
            strict=False,
        )
        near = None if rest.shape[1] else self._start()
        solution = problem.solve(minimise=lambda v: v.size, near=near)
        values = solution.values
        p = tilt @ values["P2"] @ tilt.T
        if rest.shape[1]:
            p = p + rest @ values["P1"] @ rest.T
        proof: dict[str, Any] = {"P": p, **{name: values[name] for name in ("W", "alpha") if name in values}}
        return self._upsilon(values), np.inf if solution.gap is None else solution.gap, proof

    def _without_injection(self) -> dict[str, Any] | None:
        """P with W or alpha for Upsilon = U0, the least one; ``None`` if it does not decay fast enough."""
        parts, most = self.parts, -0.5 * self.rate
        for corner in self.corners.values() or [np.zeros((parts.driven.shape[1], len(parts.inner)))]:
            onward = parts.drift + self.base @ parts.seen
            onward = onward + (parts.driven + self.base @ parts.shown) @ corner @ parts.inner
            modes = np.linalg.eigvals(onward)
            discrete = self.time == "discrete"
            slowest = np.abs(modes).max() if discrete else modes.real.max()
            if slowest >= (exp(most) if discrete else most):
                return None
        try:
            return self._analysis(self.base, slack=False).solve().values
        except (InfeasibleError, UndecidedError, CertificateError):
            return None

    def _start(self) -> dict[str, Any] | None:
        """The matrices of the stationary filter at the middle of the slopes."""
        parts, slope = self.parts, self._slope()
        a, c = parts.drift + parts.driven @ slope, parts.seen + parts.shown @ slope
        start = filter_start(a, c, 0.5 * self.rate, self.time)
        if start is None:
            return None
        p, u = start
        turn = self.free
        upsilon = -np.linalg.solve(p, u)
        p2, k2 = symmetric(turn.T @ p @ turn), turn.T @ p @ (upsilon - self.base)
        size = 1.1 * np.linalg.norm(k2.T @ np.linalg.solve(p2, k2), 2)
        values: dict[str, Any] = {"P2": p2, "K2": k2, "size": size}
        weight = p @ (parts.driven + upsilon @ parts.shown)
        if self.time == "discrete":
            values["alpha"] = 1.0
        elif self.corners:
            values["W"] = cover(weight, parts.inner, self.slopes)
        return values

    def _slope(self) -> FloatArray:
        if self.corners:
            return np.asarray(middle(self.slopes) @ self.parts.inner)
        return np.zeros((self.parts.driven.shape[1], len(self.parts.drift)))

    def _require_free_choice(self) -> None:
        """Raise InfeasibleError if not even an Upsilon without J Z = H satisfies the inequality."""
        whole = np.eye(len(self.parts.drift))
        other = msgspec.structs.replace(self, base=np.zeros_like(self.base), free=whole)
        try:
            other._problem(whole, whole[:, :0], slack=False).solve(near=None)
        except UndecidedError:
            return

    def _tilted(self, rest: FloatArray) -> FloatArray:
        """A T for which the inequality can be satisfied, by alternation."""
        tilt, slack = self.free, np.inf
        for _ in range(TURNS_MOST):
            problem = self._problem(tilt, rest, slack=True)
            values = problem.solve(minimise=lambda v: v.slack).values
            slack = values["slack"] - SLACK
            if slack < -2.0 * problem.margin:
                return tilt
            upsilon = self._upsilon(values)
            values = self._analysis(upsilon).solve(minimise=lambda v: v.slack).values
            inner = self.free.T @ values["P"] @ self.free
            tilt = self.free + rest @ np.linalg.solve(inner, self.free.T @ values["P"] @ rest).T
        raise UndecidedError(
            f"no Upsilon with this decay was found in {TURNS_MOST} turns, the inequality "
            f"still lacks {slack:.3g}; that proves nothing: try a smaller decay or injection=True"
        )

    def _upsilon(self, values: dict[str, Any]) -> FloatArray:
        return np.asarray(self.base + self.free @ np.linalg.solve(values["P2"], values["K2"]))

    def _problem(self, tilt: FloatArray, rest: FloatArray, *, slack: bool) -> MatrixInequalities:
        """The problem for a fixed T: unknowns P1, P2 and K2 = P2 K."""
        width, other = tilt.shape[1], rest.shape[1]
        problem = MatrixInequalities("choice of Upsilon").positive("P2", width)
        if other:
            problem.positive("P1", other)
        problem.free("K2", width, len(self.parts.seen))

        def p(v: Any) -> FloatArray:
            whole = tilt @ v.P2 @ tilt.T
            return np.asarray(whole + rest @ v.P1 @ rest.T if other else whole)

        def closed(v: Any, first: FloatArray, second: FloatArray) -> FloatArray:
            return np.asarray(p(v) @ (first + self.base @ second) + tilt @ v.K2 @ second)

        return self._inequalities(problem, p, closed, slack)

    def _analysis(self, upsilon: FloatArray, *, slack: bool = True) -> MatrixInequalities:
        """The problem for a fixed Upsilon: the unknown is P."""
        problem = MatrixInequalities("analysis").positive("P", len(upsilon))

        def closed(v: Any, first: FloatArray, second: FloatArray) -> FloatArray:
            return np.asarray(v.P @ (first + upsilon @ second))

        return self._inequalities(problem, lambda v: v.P, closed, slack)

    def _inequalities(
        self, problem: MatrixInequalities, p: Any, closed: Any, slack: bool
    ) -> MatrixInequalities:
        """Theorem 3.3.1 without delta, 2 sym(P S0) + 2 W + rate P < slack I, or the LMI of Theorem 3.3.2."""
        parts = self.parts
        if slack:
            problem.number("slack")

        def spare(v: Any) -> float:
            return float(v.slack) - SLACK if slack else 0.0

        if self.time == "continuous":
            if self.corners:
                problem.symmetric("W", len(parts.drift))
            for name, corner in self.corners.items():
                problem.above(f"W - sym(F D J), D = diag({name})", self._sector(closed, corner), strict=False)

            def dissipation(v: Any) -> FloatArray:
                onward = 2.0 * symmetric(closed(v, parts.drift, parts.seen)) + self.rate * p(v)
                onward = onward + 2.0 * v.W if self.corners else onward
                return np.asarray(onward - spare(v) * np.eye(len(onward)))

            return problem.below("the inequality", dissipation)
        q, k = parts.driven.shape
        steepest, keep = lipschitz(self.slopes, parts.inner), exp(-self.rate)
        problem.number("alpha")

        def block(v: Any) -> FloatArray:
            diagonal = np.zeros((q + k, q + k))
            diagonal[:q, :q] = v.alpha * steepest.T @ steepest - keep * p(v)
            diagonal[q:, q:] = -v.alpha * np.eye(k)
            onward = np.hstack([closed(v, parts.drift, parts.seen), closed(v, parts.driven, parts.shown)])
            whole = np.block([[diagonal, onward.T], [onward, -p(v)]])
            return np.asarray(whole - spare(v) * np.eye(len(whole)))

        return problem.below("the LMI", block)

    def _sector(self, closed: Any, corner: FloatArray) -> Block:
        parts = self.parts
        return lambda v: v.W - symmetric(closed(v, parts.driven, parts.shown) @ corner @ parts.inner)
