"""The choice of Upsilon by the theorem's inequality."""

from __future__ import annotations

from math import exp
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.design import symmetric
from pointpred_observers.numerics.balance import Coordinates, inward
from pointpred_observers.numerics.equalities import NO_DIGIT, cleared, without_rounding
from pointpred_observers.numerics.matrices import matrix
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.stationary import cover, filter_start, middle
from pointpred_observers.reduced_order.reversed_certificate import lipschitz


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

    def inward(self, units: Coordinates) -> Split:
        """The same in these units; ``outer`` stays."""
        x, y, f, t = units.states, units.outputs, units.values, units.seconds
        return Split(
            inward(self.drift, x, x, t),
            inward(self.seen, y, x),
            inward(self.driven, x, f, t),
            inward(self.shown, y, f),
            inward(self.inner, units.arguments, x),
            self.outer,
        )


def split(plant: Persidskii, Pi: Any) -> Split:
    """The plant with its outputs as coordinates; raises ParameterError where that is impossible."""
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
        *(
            cleared(factors, share=NO_DIGIT)
            for factors in (
                (pi, plant.A0, hidden),
                (plant.C0, plant.A0, hidden),
                (pi, plant.A1),
                (plant.C0, plant.A1),
                (plant.H, hidden),
                (plant.H, measured),
            )
        )
    )


class InjectionSearch(msgspec.Struct, frozen=True):
    """The search for an Upsilon such that one P proves the decay: linear in P and U = P Upsilon.

    V' <= -``rate`` V (V+ <= exp(-``rate``) V in discrete time).
    """

    parts: Split
    corners: dict[str, FloatArray]
    """Of the slopes; none if f does not matter."""
    slopes: tuple[tuple[float, float], ...] | None
    time: str
    rate: float

    def made(self) -> tuple[FloatArray, float, dict[str, Any]]:
        """An Upsilon with a small output injection, the gap of its size, and its P with W or alpha."""
        q, p = len(self.parts.drift), len(self.parts.seen)
        unneeded = self._without_injection()
        if unneeded is not None:
            return np.zeros((q, p)), 0.0, unneeded
        problem = self._problem(injected=True).number("size")
        problem.above(
            "size - U' P^-1 U", lambda v: np.block([[v.size * np.eye(p), v.U.T], [v.U, v.P]]), strict=False
        )
        solution = problem.solve(minimise=lambda v: v.size, near=self._start())
        values = solution.values
        proof: dict[str, Any] = {name: one for name, one in values.items() if name in ("P", "W", "alpha")}
        upsilon = np.asarray(np.linalg.solve(values["P"], values["U"]))
        return upsilon, np.inf if solution.gap is None else solution.gap, proof

    def _without_injection(self) -> dict[str, Any] | None:
        """P with W or alpha for Upsilon = 0; ``None`` if it does not decay fast enough."""
        parts, most = self.parts, -0.5 * self.rate
        for corner in self.corners.values() or [np.zeros((parts.driven.shape[1], len(parts.inner)))]:
            modes = np.linalg.eigvals(parts.drift + parts.driven @ corner @ parts.inner)
            discrete = self.time == "discrete"
            slowest = np.abs(modes).max() if discrete else modes.real.max()
            if slowest >= (exp(most) if discrete else most):
                return None
        try:
            return self._problem(injected=False).solve().values
        except (InfeasibleError, UndecidedError, CertificateError):
            return None

    def _start(self) -> dict[str, Any] | None:
        """The matrices of the stationary filter at the middle of the slopes."""
        parts = self.parts
        slope = np.zeros((parts.driven.shape[1], len(parts.drift)))
        if self.corners:
            slope = np.asarray(middle(self.slopes) @ parts.inner)
        a, c = parts.drift + parts.driven @ slope, parts.seen + parts.shown @ slope
        start = filter_start(a, c, 0.5 * self.rate, self.time)
        if start is None:
            return None
        p, u = start
        values: dict[str, Any] = {
            "P": p,
            "U": -u,
            "size": 1.1 * np.linalg.norm(u.T @ np.linalg.solve(p, u), 2),
        }
        if self.time == "discrete":
            values["alpha"] = 1.0
        elif self.corners:
            values["W"] = cover(p @ parts.driven - u @ parts.shown, parts.inner, self.slopes)
        return values

    def _problem(self, *, injected: bool) -> MatrixInequalities:
        """Theorem 3.3.1 without delta, 2 sym(P S0) + 2 W + rate P < 0, or the LMI of Theorem 3.3.2."""
        parts, (q, k) = self.parts, self.parts.driven.shape
        problem = MatrixInequalities("choice of Upsilon" if injected else "analysis").positive("P", q)
        if injected:
            problem.free("U", q, len(parts.seen))

        def closed(v: Any, first: FloatArray, second: FloatArray) -> FloatArray:
            return np.asarray(v.P @ first + v.U @ second if injected else v.P @ first)

        if self.time == "continuous":
            if self.corners:
                problem.symmetric("W", q)
            for name, corner in self.corners.items():
                within = corner @ parts.inner

                def sector(v: Any, d: FloatArray = within) -> FloatArray:
                    return np.asarray(v.W - symmetric(closed(v, parts.driven, parts.shown) @ d))

                problem.above(f"W - sym(F D J), D = diag({name})", sector, strict=False)

            def dissipation(v: Any) -> FloatArray:
                onward = 2.0 * symmetric(closed(v, parts.drift, parts.seen)) + self.rate * v.P
                return np.asarray(onward + 2.0 * v.W if self.corners else onward)

            return problem.below("the inequality", dissipation)
        steepest, keep = lipschitz(self.slopes, parts.inner), exp(-self.rate)
        problem.number("alpha")

        def block(v: Any) -> FloatArray:
            diagonal = np.zeros((q + k, q + k))
            diagonal[:q, :q] = v.alpha * steepest.T @ steepest - keep * v.P
            diagonal[q:, q:] = -v.alpha * np.eye(k)
            onward = np.hstack([closed(v, parts.drift, parts.seen), closed(v, parts.driven, parts.shown)])
            return np.block([[diagonal, onward.T], [onward, -v.P]])

        return problem.below("the LMI", block)
