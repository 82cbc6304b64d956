"""The L2 gain of an error system: the largest energy of the error for a disturbance of energy 1."""

from __future__ import annotations

from functools import partial
from math import sqrt
from typing import Any

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.balance import Coordinates, balanced
from pointpred_observers.error_systems.h_infinity import h_infinity
from pointpred_observers.error_systems.system import ErrorSystem
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.matrices import instance
from pointpred_observers.search import Posed, search

ROOM = 1e-6
"""Relative room that is added to the least gain, with which the inequality would hold with equality."""


class L2Gain(msgspec.Struct, frozen=True):
    """The gain from delta to z lies between ``lower`` and ``upper``.

    ``lower`` is the largest H-infinity norm of a corner, for a linear system the gain itself; it is reached
    at ``frequency`` in rad/s (rad/step) at ``corner``. ``upper`` is proved for every f with these slopes,
    also for slopes that change, by ``P`` with the recomputed ``margins``, while the arguments of f stay
    within ``domain``.
    """

    lower: float
    upper: float
    frequency: float
    corner: str
    P: FloatArray
    margins: dict[str, float]
    domain: float = np.inf


def gain_inequalities(system: ErrorSystem, gain: Any = None) -> MatrixInequalities:
    """The bounded real lemma at every corner: V' <= gain^2 abs(delta)^2 - abs(z)^2.

    In discrete time V(e+) - V(e) stands for V'. Unknowns: P, and ``square`` for gain^2 where no ``gain`` is
    passed.
    """
    problem = MatrixInequalities("L2 gain").symmetric("P", system.n).above("P > 0", lambda v: v.P)
    if gain is None:
        problem.number("square")
    energy = system.C.T @ system.C

    def square(v: Any) -> float:
        return float(v.square if gain is None else gain**2)

    def continuous(a: FloatArray, b: FloatArray, v: Any) -> FloatArray:
        half = v.P @ a
        return np.block([[half + half.T + energy, v.P @ b], [(v.P @ b).T, -square(v) * np.eye(b.shape[1])]])

    def discrete(a: FloatArray, b: FloatArray, v: Any) -> FloatArray:
        onward, (n, m) = np.hstack([a, b]), b.shape
        before = np.zeros((n + m, n + m))
        before[:n, :n], before[n:, n:] = energy - v.P, -square(v) * np.eye(m)
        return np.asarray(before + onward.T @ v.P @ onward)

    block = discrete if system.time == "discrete" else continuous
    for name, a, b in zip(system.names, system.A, system.B, strict=True):
        problem.below(f"the gain{f' at {name}' if name else ''}", partial(block, a, b))
    return problem


def l2_gain(system: ErrorSystem) -> L2Gain:
    """The L2 gain from the disturbances to z, from below and from above.

    Assumes one P for all corners: with several, ``upper`` may lie above the true gain. Units matter: the
    gain is that of the Euclidean norms of delta and z in the units of the matrices; ``disturbed_by`` and
    ``seen_as`` choose others.

    Raises InfeasibleError naming an eigenvalue that does not decay; UndecidedError and CertificateError from
    the solver.

    Reference: Boyd, El Ghaoui, Feron, Balakrishnan 1994, section 6.3.2.

    >>> from pointpred_observers.error_systems.system import sloped_system
    >>> system = sloped_system(
    ...     -2 * np.eye(1), np.eye(1), np.eye(1), {"d": np.eye(1)}, slopes=((0.0, 1.0),), time="continuous"
    ... )
    >>> found = l2_gain(system)
    >>> round(found.lower, 4), round(found.upper, 3), found.corner
    (1.0, 1.0, 'D = diag(1)')
    """
    instance("system", system, ErrorSystem).slowest()
    norms = [h_infinity(a, b, system.C, system.time) for a, b in zip(system.A, system.B, strict=True)]
    worst = max(range(len(norms)), key=lambda i: norms[i][0])
    lower, frequency = norms[worst]
    if lower == 0.0:
        none = np.zeros((system.n, system.n))
        return L2Gain(0.0, 0.0, 0.0, system.names[worst], none, {}, system.domain)

    def posed(units: Coordinates) -> Posed:
        inner, x, t = system.inward(units), units.states, units.seconds
        size = float(np.abs(inner.B).max())
        # V' is V's change in 1/s, delta is divided by ``size`` and z by size / lower.
        inner = msgspec.structs.replace(inner, B=inner.B / size, C=inner.C * size / lower)
        measured = {"P": np.outer(x, x) * (size / lower) ** 2 / t, "square": 1.0}
        return Posed(gain_inequalities(inner), measured, lambda v: v.square)

    def audited(values: dict[str, Any], _: float) -> L2Gain:
        upper = (1.0 + ROOM) * lower * sqrt(values["square"])
        margins = gain_inequalities(system, upper).check({"P": values["P"]})
        corner = system.names[worst]
        return L2Gain(lower, upper, frequency, corner, values["P"], margins, system.domain)

    units = balanced(system.A, seen=system.C, driven=system.B, time=system.time)
    return search(units, posed, audited, lambda found: float(np.log(found.upper)))
