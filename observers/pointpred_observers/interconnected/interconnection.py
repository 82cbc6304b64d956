"""The inequalities of Theorem 3.2.1, to be solved or to check published matrices."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from operator import attrgetter
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.eigenvalues import vertices
from pointpred_observers.numerics.matrices import matrix
from pointpred_observers.plants.generator import Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, constant
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities


class Interconnection:
    """The blocks of Theorem 3.2.1 as functions of P, U, Theta, ...

    ``j`` is J = H Pi, ``output`` C0 Pi; ``corners`` of the slopes, none if the blocks do not depend on f.
    """

    def __init__(self, plant: Plant, generator: Generator, Pi: Any) -> None:
        plant = constant(plant)
        if not plant.p:
            raise ParameterError("an observer needs an output: give the plant C0 or C1", field="C0")
        self.plant, self.g = plant, fitted(generator, plant)
        self.pi = matrix("Pi", Pi, plant.n, self.g.q)
        self.j: FloatArray = plant.H @ self.pi
        self.output: FloatArray = plant.C0 @ self.pi
        require_same_nonlinearity(plant, generator, self.pi)
        g = self.g
        self.shown: FloatArray = plant.C1
        self.sloped = bool(g.S1.any() or plant.C1.any())
        self.slopes = plant.slopes if self.sloped else None
        self.corners = vertices(plant.slopes) if self.sloped else {}

    def units(self, *rates: float) -> Coordinates:
        """The units in which the error equation is balanced; ``rates`` in 1/s are required of it."""
        return balanced(
            self.g.S0,
            seen=self.output,
            driven=self.g.S1,
            shown=self.shown,
            inner=self.j,
            slopes=self.plant.slopes if self.sloped else None,
            rates=rates,
            time=self.plant.time,
        )

    def inward(self, units: Coordinates) -> Interconnection:
        """The same blocks in these units."""
        x, y, f, t = units.states, units.outputs, units.values, units.seconds
        other = copy(self)
        other.g = msgspec.structs.replace(
            self.g,
            S0=inward(self.g.S0, x, x, t),
            S1=inward(self.g.S1, x, f, t),
            G=inward(self.g.G, x, y, t),
        )
        other.j, other.output = inward(self.j, units.arguments, x), inward(self.output, y, x)
        other.shown = inward(self.shown, y, f)
        other.slopes = units.slopes(self.slopes)
        other.corners = vertices(other.slopes) if self.sloped else {}
        return other

    def linear(self, v: Any) -> FloatArray:
        """P S0 - U C0 Pi."""
        block: FloatArray = v.P @ self.g.S0 - v.U @ self.output
        return block

    def weight(self, v: Any) -> FloatArray:
        """F = P S1 - U C1, the weight of f."""
        block: FloatArray = v.P @ self.g.S1 - v.U @ self.shown
        return block

    def sector(self, v: Any, corner: FloatArray) -> FloatArray:
        """W - sym(F D J) at a corner D."""
        block: FloatArray = v.W - symmetric(self.weight(v) @ corner @ self.j)
        return block

    def continuous(self, v: Any) -> FloatArray:
        """The block of the theorem: V' against Theta, Gamma, Gamma and Xi."""
        upper = symmetric(2.0 * self.linear(v)) + v.Theta + (2.0 * v.W if self.sloped else 0.0)
        across = np.hstack([-v.P @ self.g.G, -v.U, v.P])
        return np.block([[upper, across], [across.T, -self._disturbances(v)]])

    def discrete(self, v: Any, corner: FloatArray | None) -> FloatArray:
        """V(e+) - V(e) against the same, at a corner, by a Schur complement."""
        inner = self.linear(v) if corner is None else self.linear(v) + self.weight(v) @ corner @ self.j
        onward = np.hstack([inner, -v.P @ self.g.G, -v.U, v.P])
        whole, q = np.zeros((onward.shape[1], onward.shape[1])), self.g.q
        whole[:q, :q], whole[q:, q:] = v.Theta - v.P, -self._disturbances(v)
        return np.block([[whole, onward.T], [onward, -v.P]])

    def _disturbances(self, v: Any) -> FloatArray:
        p, q = self.plant.p, self.g.q
        block = np.zeros((2 * p + q, 2 * p + q))
        block[:p, :p] = block[p : 2 * p, p : 2 * p] = v.Gamma
        block[2 * p :, 2 * p :] = v.Xi
        return block

    def state(self, problem: MatrixInequalities, **fixed: Any) -> MatrixInequalities:
        """Add the theorem's inequalities to a problem; ``fixed`` holds matrices that are not unknowns."""

        def completed(block: Callable[..., FloatArray], *corner: Any) -> Callable[[Any], FloatArray]:
            return lambda v: block(Completed(v, fixed), *corner)

        for name, corner in self.corners.items() if self.plant.time == "continuous" else ():
            problem.above(
                f"W - sym(F D J), D = diag({name})",
                completed(self.sector, corner),
                strict=False,
            )
        if self.plant.time == "continuous":
            return problem.below("the LMI", completed(self.continuous), strict=False)
        if not self.corners:
            return problem.below("the LMI", completed(self.discrete, None))
        for name, one in self.corners.items():
            problem.below(f"the LMI, D = diag({name})", completed(self.discrete, one))
        return problem


class Completed:
    """The matrices of a problem and the functions of them."""

    def __init__(self, v: Any, fixed: dict[str, Any]) -> None:
        self._v, self._fixed = v, fixed

    def __getattr__(self, name: str) -> Any:
        return self._fixed[name](self._v) if name in self._fixed else getattr(self._v, name)


def theorem_3_2_1(
    plant: Plant,
    generator: Generator,
    Pi: Any,
    *,
    F: Any = None,
) -> MatrixInequalities:
    """The inequalities of Theorem 3.2.1 for a plant, its generator and their steady-state map.

    Unknowns: P, Theta, Gamma, Xi, U, and W where f matters. F = P S1 - U C1 is not an unknown; if it is
    passed, the equality is required. e'F(f(Jw) - f(Jz)) <= e'We holds exactly if W >= sym(F D J) for each
    corner D of the slopes. In discrete time, for which the thesis has no such theorem, V(e+) - V(e) replaces
    V' at each corner.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0])
    >>> theorem = theorem_3_2_1(plant, Generator([[0.0]], L0=[1.0]), [[1.0]])
    >>> theorem.check({"P": 1.0, "Theta": 1.0, "Gamma": 9.0, "Xi": 4.0, "U": 2.0})["the LMI"] > 0.0
    True
    """
    connection = Interconnection(plant, generator, Pi)
    plant = connection.plant
    q, p = connection.g.q, plant.p
    problem = MatrixInequalities("Theorem 3.2.1").positive("P", q).symmetric("Theta", q)
    problem.symmetric("Gamma", p).symmetric("Xi", q).free("U", q, p)
    for name in ("Theta", "Gamma", "Xi"):
        problem.above(f"{name} > 0", attrgetter(name))
    if F is not None:
        f = matrix("F", F, q, plant.k)
        problem.equal("P S1 - U C1 - F", lambda v: connection.weight(v) - f)
    if connection.sloped and plant.time == "continuous":
        problem.symmetric("W", q)
    return connection.state(problem)


def symmetric(square: FloatArray) -> FloatArray:
    """The symmetric part."""
    half: FloatArray = 0.5 * (square + square.T)
    return half
