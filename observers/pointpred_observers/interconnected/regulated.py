"""The inequalities of assumptions 3.2.3 and 3.2.6, in the user's units and in balanced ones."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.balance import Coordinates, balanced, inward
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.interconnected.generator import Fitted
from pointpred_observers.interconnected.growing_mode import (
    ComplexArray,
    GrowingMode,
    disc,
    growing_mode,
    quadrant,
    rounding,
)
from pointpred_observers.interconnected.sector import SectorBounds
from pointpred_observers.persidskii import Persidskii
from pointpred_observers.search import Units


class Regulated(msgspec.Struct, frozen=True):
    """The regulator with the plant on its steady state: w' = ``s`` w + ``tilde`` f(``j`` w) + disturbances.

    s = S0 + G C0 Pi, tilde = S1 + G C1, j = H Pi.
    """

    s: FloatArray
    tilde: FloatArray
    j: FloatArray

    @classmethod
    def of(cls, plant: Persidskii, g: Fitted, pi: FloatArray) -> Regulated:
        """The matrices of Assumption 3.2.3."""
        return cls(g.S0 + g.G @ plant.C0 @ pi, g.S1 + g.G @ plant.C1, plant.H @ pi)

    def inequalities(self) -> MatrixInequalities:
        """Assumption 3.2.3 with the condition of Theorem 3.2.2."""
        s, tilde, j = self.s, self.tilde, self.j
        q, k = tilde.shape
        problem = MatrixInequalities("Assumption 3.2.3").positive("P", q).symmetric("Gamma", q)
        problem.symmetric("Xi", q)
        for name in ("Omega", "Lambda") if k else ():
            problem.diagonal(name, k)

        def block(v: Any) -> FloatArray:
            weight = weights(v, "Lambda", k)
            upper = s.T @ v.P + v.P @ s + v.Xi
            across = v.P @ tilde + s.T @ j.T @ weight + j.T @ weights(v, "Omega", k)
            middle = tilde.T @ j.T @ weight + weight @ j @ tilde
            lift, none = j.T @ weight, np.zeros((q, q))
            return np.block(
                [
                    [upper, across, v.P, v.P],
                    [across.T, middle, lift.T, lift.T],
                    [v.P, lift, -v.Gamma, none],
                    [v.P, lift, none, -v.Gamma],
                ]
            )

        problem.below("Phi", block, strict=False).above("Gamma > 0", lambda v: v.Gamma)
        problem.above("Xi", lambda v: v.Xi, strict=False)
        return problem.above("Xi + J' Omega J", lambda v: v.Xi + j.T @ weights(v, "Omega", k) @ j)

    def growing(self) -> tuple[str, GrowingMode | None]:
        """A motion that excludes every choice, if one is found, and the matrix that has it.

        With v = (x, f, 0, 0) and f = D J x, v*Phi v is the sum of 2 Re x*P x', x*Xi x, and of the components
        of 2 Re f* J x' and 2 Re f* J x with the weights of Lambda and Omega: above 0 where none is below 0.
        """

        def admitted(mode: GrowingMode) -> bool:
            x, f = mode.state, mode.value
            speed = self.s @ x + self.tilde @ f
            error = np.abs(self.j) @ rounding((self.s, x), (self.tilde, f)) + rounding((self.j, speed))
            return _agree(f, self.j @ speed, error) and _agree(f, self.j @ x, rounding((self.j, x)))

        effect = _size(self.tilde) * _size(self.j)
        slopes = [quadrant(_size(self.s) / effect if effect > 0.0 else 1.0)] * len(self.j)
        return "S + S~ D J", growing_mode(self.s, self.tilde, self.j, slopes, admitted)

    def units(self) -> Coordinates:
        """The units in which the regulator is balanced; f and its arguments keep theirs."""
        return balanced(self.s, driven=self.tilde, inner=self.j, plain=True)

    def inward(self, units: Coordinates) -> Regulated:
        """The same matrices in these units."""
        x, f, t = units.states, units.values, units.seconds
        return Regulated(
            inward(self.s, x, x, t), inward(self.tilde, x, f, t), inward(self.j, units.arguments, x)
        )

    def measured(self, units: Coordinates) -> Units:
        """The units of the matrices."""
        form, t = np.outer(units.states, units.states), units.seconds
        return {"P": form, "Gamma": form / t, "Xi": t * form, "Omega": t, "Lambda": 1.0}


class Followed(msgspec.Struct, frozen=True):
    """The tracking error z = x - Pi w: z' = ``a0`` z + ``a1`` (f(Jw + ``h`` z) - f(Jw)) + disturbances.

    a0 = A0 - Pi G C0, a1 = A1 - Pi G C1; ``sector`` holds the constants of Assumption 3.2.4.
    """

    a0: FloatArray
    a1: FloatArray
    h: FloatArray
    sector: SectorBounds

    @classmethod
    def of(cls, plant: Persidskii, g: Fitted, pi: FloatArray, sector: SectorBounds) -> Followed:
        """The matrices of Assumption 3.2.6."""
        return cls(plant.A0 - pi @ g.G @ plant.C0, plant.A1 - pi @ g.G @ plant.C1, plant.H, sector)

    def inequalities(self) -> MatrixInequalities:
        """Assumption 3.2.6 with the conditions of Theorem 3.2.3."""
        a0, a1, h, bound = self.a0, self.a1, self.h, self.sector
        n, k = a1.shape
        problem = MatrixInequalities("Assumption 3.2.6").positive("P", n).symmetric("Gamma", n)
        problem.symmetric("Xi", n)
        if not k:
            return _linear(problem, a0)
        problem.number("gamma1").number("gamma2")
        for name in ("Lambda", "Omega1", "Omega2", "Upsilon"):
            problem.diagonal(name, k)

        def block(v: Any) -> FloatArray:
            first = a0.T @ h.T @ v.Lambda + h.T @ v.Omega1
            second = v.P @ a1 + h.T @ v.Omega2
            third = v.Lambda @ h @ a1 + v.Upsilon
            lift, none = v.Lambda @ h, np.zeros((k, n))
            return np.block(
                [
                    [a0.T @ v.P + v.P @ a0 + v.Xi, first, second, v.P],
                    [first.T, -v.gamma1 * np.eye(k), third, lift],
                    [second.T, third.T, -v.gamma2 * np.eye(k), none],
                    [v.P, lift.T, none.T, -v.Gamma],
                ]
            )

        def r1(v: Any) -> FloatArray:
            block: FloatArray = v.Xi - v.gamma1 * bound.Sigma1 - v.gamma2 * bound.Psi1
            return block

        def r2(v: Any) -> FloatArray:
            block: FloatArray = v.Omega1 - v.gamma1 * bound.Sigma2 - v.gamma2 * bound.Psi2
            return block

        def r3(v: Any) -> FloatArray:
            block: FloatArray = v.Omega2 - v.gamma1 * bound.Sigma3
            return block

        problem.below("Phi", block, strict=False).above("Gamma > 0", lambda v: v.Gamma)
        for name, left in (("Xi", lambda v: v.Xi), ("R1", r1), ("R2", r2), ("R3", r3)):
            problem.above(name, left, strict=False)
        problem.above("R4", lambda v: v.Upsilon - v.gamma1 * bound.Sigma4, strict=False)
        return problem.above("R1 + H'(R2 + R3) H", lambda v: r1(v) + h.T @ (r2(v) + r3(v)) @ h)

    def growing(self) -> tuple[str, GrowingMode | None]:
        """A motion that excludes every choice, if one is found, and the matrix that has it.

        With v = (x, 0, f, 0) and f = D H x, v*Phi v is the sum of 2 Re x*P x', x*R1 x and 2 Re x*H'R3 f, and
        of gamma1 (x*Sigma1 x + 2 Re x*H'Sigma3 f) and gamma2 (x*Psi1 x - f*f).
        """
        bound = self.sector

        def admitted(mode: GrowingMode) -> bool:
            x, f, argument = mode.state, mode.value, self.h @ mode.state
            first = float((x.conj() @ bound.Sigma1 @ x + 2.0 * argument.conj() @ bound.Sigma3 @ f).real)
            second = float((x.conj() @ bound.Psi1 @ x - f.conj() @ f).real)
            return first >= 0.0 and second >= 0.0 and _agree(f, argument, rounding((self.h, x)))

        slopes = [disc(_steepest(bound.Psi1, row)) for row in self.h]
        return "A~0 + A~1 D H", growing_mode(self.a0, self.a1, self.h, slopes, admitted)

    def units(self) -> Coordinates:
        """The units in which the error is balanced; f keeps its own: gamma1 weighs its components alike."""
        return balanced(self.a0, driven=self.a1, inner=self.h, plain=True)

    def inward(self, units: Coordinates) -> Followed:
        """The same matrices in these units."""
        x, f, t = units.states, units.values, units.seconds
        sector = msgspec.structs.replace(
            self.sector,
            Sigma1=self.sector.Sigma1 * x * x[:, None],
            Psi1=self.sector.Psi1 * x * x[:, None],
        )
        return Followed(
            inward(self.a0, x, x, t),
            inward(self.a1, x, f, t),
            inward(self.h, units.arguments, x),
            sector,
        )

    def measured(self, units: Coordinates) -> Units:
        """The units of the matrices."""
        form, t = np.outer(units.states, units.states), units.seconds
        rates = dict.fromkeys(("gamma1", "gamma2", "Omega1", "Omega2", "Upsilon"), t)
        return {"P": form, "Gamma": form / t, "Xi": t * form, "Lambda": 1.0, **rates}


def _agree(f: ComplexArray, other: ComplexArray, error: FloatArray) -> bool:
    """Whether no component of Re f* other lies below 0, for every ``other`` within this error."""
    return bool(((f.conj() * other).real >= np.abs(f) * error).all())


def _steepest(psi: FloatArray, row: FloatArray) -> float:
    """The largest d with d^2 row' row <= psi."""
    onto = np.linalg.pinv(psi) @ row
    within = np.allclose(psi @ onto, row, rtol=0.0, atol=1e-9 * float(np.abs(row).max(initial=0.0)))
    return 1.0 / float(np.sqrt(row @ onto)) if within and row @ onto > 0.0 else 0.0


def _size(matrix: FloatArray) -> float:
    return float(np.linalg.norm(matrix))


def weights(v: Any, name: str, k: int) -> FloatArray:
    """A diagonal unknown, or the empty matrix where there is no f."""
    return np.asarray(getattr(v, name) if k else np.zeros((0, 0)), np.float64)


def _linear(problem: MatrixInequalities, a0: FloatArray) -> MatrixInequalities:
    """Assumption 3.2.6 and the condition of Theorem 3.2.3 where there is no f."""

    def block(v: Any) -> FloatArray:
        return np.block([[a0.T @ v.P + v.P @ a0 + v.Xi, v.P], [v.P, -v.Gamma]])

    problem.below("Phi", block, strict=False).above("Gamma > 0", lambda v: v.Gamma)
    return problem.above("R1 + H'(R2 + R3) H", lambda v: v.Xi)
