"""Gains of a discrete unknown input observer: one small semidefinite problem, the rest in closed form."""

from __future__ import annotations

from functools import partial
from math import exp
from typing import Any

import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.unknown_input.gains import (
    NEGLIGIBLE,
    ROOMS,
    Room,
    frames,
    mean_start,
    solved,
)
from pointpred_observers.unknown_input.invariant_zeros import kernel


def lyapunov(
    gammas: FloatArray, ts: FloatArray, c: FloatArray, sigma: float, room: Room = ROOMS[0]
) -> tuple[FloatArray, float, float]:
    """P, gamma and the gap with V(e+) <= exp(-sigma) V(e) + gamma delta'delta for e in the kernel of C.

    e+ = T A e + T delta there. For every such P there is a gain that needs no more: ``gain``.

    The gap is that of gamma + 0.01 trace P. Raises InfeasibleError if no P serves all vertices,
    UndecidedError if none is found.
    """
    blind, frame, rest = frames(c, ts)
    if not blind.shape[1]:
        p = np.eye(c.shape[1])
        return p, least_gamma(gammas, ts, c, p, sigma, room.factor), np.inf
    cases = np.unique(np.concatenate([gammas @ blind, ts], axis=2), axis=0)
    lost = exp(-sigma)

    def whole(case: FloatArray, v: Any) -> FloatArray:
        p = rest + frame @ v.P @ frame.T
        block: FloatArray = case.T @ p @ case
        size = blind.shape[1]
        rest_of = len(block) - size
        across = np.zeros((size, rest_of))
        allowed = np.block([[lost * (blind.T @ p @ blind), across], [across.T, v.gamma * np.eye(rest_of)]])
        return np.asarray(block - allowed, np.float64)

    problem = MatrixInequalities("discrete unknown input observer")
    problem.positive("P", frame.shape[1]).number("gamma")
    for i, case in enumerate(cases):
        problem.below(f"decay, case {i}", partial(whole, case))
    start = mean_start(gammas, c, sigma, decoupled=frame is blind, time="discrete")
    near = None if start is None else {"P": start, "gamma": 1.0}
    solution = solved(problem, near, sigma, minimise=lambda v: v.gamma + room.weight * np.trace(v.P))
    p = rest + frame @ solution.values["P"] @ frame.T
    return p, least_gamma(gammas, ts, c, p, sigma, room.factor), room.gap(solution)


def least_gamma(
    gammas: FloatArray, ts: FloatArray, c: FloatArray, p: FloatArray, sigma: float, factor: float
) -> float:
    """A gamma ``factor`` times the least one that P allows at every vertex; 1 where any will do."""
    blind, least = kernel(c), 0.0
    for gamma_i, t_i in zip(gammas, ts, strict=True):
        moved = gamma_i @ blind
        room = exp(-sigma) * blind.T @ p @ blind - moved.T @ p @ moved
        side = moved.T @ p @ t_i
        needed = t_i.T @ p @ t_i + side.T @ np.linalg.solve(room, side)
        least = max(least, float(np.linalg.eigvalsh(needed)[-1]))
    return factor * least if least > NEGLIGIBLE else 1.0


def gain(gamma_i: FloatArray, c: FloatArray, p: FloatArray) -> FloatArray:
    """K at one vertex: the errors that the outputs show are replaced by the P-orthogonal ones that they hide.

    T A - K C = T A B (B'P B)^-1 B'P with B a basis of the kernel of C, the choice with the largest margin (in
    the basis (C^+, B) it completes the square), which depends neither on gamma nor on sigma.
    """
    blind = kernel(c)
    hidden = blind @ np.linalg.solve(blind.T @ p @ blind, blind.T @ p)
    k: FloatArray = gamma_i @ (np.eye(len(p)) - hidden) @ np.linalg.pinv(c)
    return k
