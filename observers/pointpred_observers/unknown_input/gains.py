"""Gains of an unknown input observer: one small semidefinite problem, the rest in closed form."""

from __future__ import annotations

from functools import partial
from math import exp
from typing import Any, NamedTuple

import numpy as np

from pointpred.errors import InfeasibleError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.plants.varying import kernel
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities, Solution
from pointpred_observers.proofs.stationary import decay_start, filter_start


class Room(NamedTuple):
    """How far the matrices stay from the edge of what is feasible, where gains grow without bound."""

    weight: float
    """Of the trace of P beside gamma in the objective; without it P and the gains grow needlessly."""
    factor: float
    """On the least gamma, with which the inequality would hold with equality."""

    def gap(self, solution: Solution) -> float:
        """The gap of gamma + 0.01 trace P, which another room than the first does not minimise."""
        return np.inf if solution.gap is None or self != ROOMS[0] else solution.gap


ROOMS = (Room(0.01, 1.001), Room(1.0, 10.0))
"""Those that are tried in turn: the second has smaller gains, whose rounding takes less of the proof."""
NEGLIGIBLE = 1e-9
"""A gamma below this share of a modest one counts as zero."""
DECOUPLED = 1e-13
"""C T below this, relative to C, is rounding."""


def lyapunov(
    gammas: FloatArray,
    ts: FloatArray,
    c: FloatArray,
    decay: float,
    room: Room = ROOMS[0],
    time: str = "continuous",
) -> tuple[FloatArray, float, float]:
    """P and gamma with F = gamma I from (27c) on the kernel of C, where no gain acts, and the gap.

    The gains drop out (elimination lemma; in discrete time ``discrete_gain`` needs no more). If C T = 0, the
    outputs' part of P drops out as well and is set to the identity; vertices that differ only in terms that a
    gain can cancel share one inequality. The certificate does not change with the scale of P. The gap is that
    of gamma + 0.01 trace P: how far the least could lie below it, relative to it; infinite with another
    ``room`` than the first.

    Raises InfeasibleError if no P serves all vertices although the zeros of each allow one, UndecidedError if
    none is found.
    """
    discrete, blind, rest = time == "discrete", kernel(c), np.zeros((c.shape[1], c.shape[1]))
    size, frame, gap = blind.shape[1], np.eye(c.shape[1]), np.inf
    # P as rest + F X F' with X to be found: all of P, or its part on the kernel of C if C T = 0.
    decoupled = float(np.abs(c @ ts).max()) <= DECOUPLED * float(np.abs(c).max() * max(1.0, np.abs(ts).max()))
    if decoupled:
        frame, rest = blind, np.asarray(np.linalg.pinv(c) @ c, np.float64)

    def block(case: FloatArray, whole: bool, v: Any) -> Any:
        """The inequality of a case, or its corner, the decay alone."""
        p = rest + frame @ v.P @ frame.T
        moved, pushed = case[:, :size], case[:, size:]
        if discrete:
            corner = moved.T @ p @ moved - exp(-2.0 * decay) * (blind.T @ p @ blind)
            side, own = moved.T @ p @ pushed, pushed.T @ p @ pushed
        else:
            half = blind.T @ p @ (moved + decay * blind)
            corner, side, own = half + half.T, blind.T @ p @ pushed, np.zeros((pushed.shape[1],) * 2)
        if not whole:
            return corner
        return np.block([[corner, side], [side.T, own - v.gamma * np.eye(pushed.shape[1])]])

    if not size:
        p = np.eye(c.shape[1])
    else:
        # T' enters through its output columns only, which vanish on the kernel of C.
        pushes = ts if discrete else _root(ts)
        cases = np.unique(np.concatenate([gammas @ blind, pushes], axis=2), axis=0)
        best = MatrixInequalities("unknown input observer, least gamma").positive("P", frame.shape[1])
        any_p = MatrixInequalities("unknown input observer, decay").positive("P", frame.shape[1])
        best.number("gamma")
        for i, case in enumerate(cases):
            best.below(f"(27c), case {i}", partial(block, case, True))
            any_p.below(f"decay, case {i}", partial(block, case, False))
        start = _start(gammas.mean(axis=0), c, decay, decoupled, time)
        near = None if start is None else {"P": start}
        try:
            both = None if near is None else {**near, "gamma": 1.0}
            solution = best.solve(minimise=lambda v: v.gamma + room.weight * np.trace(v.P), near=both)
            gap = room.gap(solution)
        except (InfeasibleError, UndecidedError):  # the required gamma may be too large for a solver
            solution = _solved(any_p, near, decay)
        p = rest + frame @ solution.values["P"] @ frame.T
    needed = least_gamma(gammas, ts, c, p, decay, time)
    usual = 1.0 if discrete else modest(ts, p, decay)
    return p, room.factor * needed if needed > NEGLIGIBLE * usual else usual, gap


def _solved(problem: MatrixInequalities, near: dict[str, Any] | None, decay: float) -> Solution:
    """Some P with the decay; raises an error that names the decay."""
    allowed = f"the invariant zeros allow a decay of {decay:g}, but"
    try:
        return problem.solve(near=near)
    except InfeasibleError as none:
        raise InfeasibleError(
            f"{allowed} no P serves every vertex: choose a smaller decay or a smaller box ({none})"
        ) from none
    except UndecidedError as none:
        raise UndecidedError(
            f"{allowed} too closely: choose a smaller decay or a smaller box ({none})"
        ) from none


def _start(mean: FloatArray, c: FloatArray, decay: float, decoupled: bool, time: str) -> FloatArray | None:
    """A P for the mean of the vertices, from which a solver starts."""
    if decoupled:
        blind = kernel(c)
        return decay_start(blind.T @ mean @ blind, 1.01 * decay, time)
    start = filter_start(mean, c, 1.01 * decay, time)
    return None if start is None else start[0]


def modest(ts: FloatArray, p: FloatArray, decay: float) -> float:
    """The gamma max T'P T / (2 decay), whose term takes no more from the decay than the decay does.

    Any gamma will do where no error can hide from the outputs; a smaller one has larger gains.
    """
    largest = max(float(np.linalg.eigvalsh(t.T @ p @ t)[-1]) for t in ts)
    return (largest if largest > NEGLIGIBLE else 1.0) / (2.0 * decay)


def _root(ts: FloatArray) -> FloatArray:
    """R with R R' = T T' for each T, as few columns as T has rows that differ from zero."""
    roots = np.array([np.asarray(np.linalg.qr(t.T, mode="r")).T for t in ts])
    used = np.abs(roots).max(axis=(0, 1)) > 0.0
    return roots[:, :, used]


def least_gamma(
    gammas: FloatArray, ts: FloatArray, c: FloatArray, p: FloatArray, decay: float, time: str = "continuous"
) -> float:
    """The least gamma for which P satisfies (27c) on the kernel of C at every vertex."""
    blind, least = kernel(c), 0.0
    for gamma_i, t_i in zip(gammas, ts, strict=True):
        moved = gamma_i @ blind
        if time == "discrete":
            room = exp(-2.0 * decay) * blind.T @ p @ blind - moved.T @ p @ moved
            side, own = moved.T @ p @ t_i, t_i.T @ p @ t_i
        else:
            half = blind.T @ p @ (moved + decay * blind)
            room, side, own = -(half + half.T), blind.T @ p @ t_i, np.zeros((len(p), len(p)))
        needed = own + side.T @ np.linalg.solve(room, side)
        least = max(least, float(np.linalg.eigvalsh(needed)[-1]))
    return least


def gain(
    gamma_i: FloatArray,
    t_i: FloatArray,
    c: FloatArray,
    p: FloatArray,
    gamma: float,
    decay: float,
    output_decay: float,
) -> FloatArray:
    """K at one vertex: it decouples the outputs from the other states and makes their errors decay.

    In the basis (C^+, ker C) the Schur complement of (27c) becomes diag(-2 rho P_11, the block that P was
    solved for).
    """
    basis = np.hstack([np.linalg.pinv(c), kernel(c)])
    outputs = c.shape[0]
    whole = gamma_i.T @ p + p @ gamma_i + 2.0 * decay * p + p @ t_i @ t_i.T @ p / gamma
    turned = basis.T @ whole @ basis
    own = (basis.T @ p @ basis)[:outputs, :outputs]
    w1 = 0.5 * turned[:outputs, :outputs] + output_decay * own
    w = np.linalg.solve(basis.T, np.vstack([w1, turned[outputs:, :outputs]]))
    return np.asarray(np.linalg.solve(p, w), np.float64)


def discrete_gain(gamma_i: FloatArray, c: FloatArray, p: FloatArray) -> FloatArray:
    """K at one vertex: the errors that the outputs show are replaced by the P-orthogonal ones that they hide.

    T A - K C = T A B (B'P B)^-1 B'P with B a basis of the kernel of C, the choice with the largest margin (in
    the basis (C^+, B) it completes the square), which depends neither on gamma nor on the decay.
    """
    blind = kernel(c)
    hidden = blind @ np.linalg.solve(blind.T @ p @ blind, blind.T @ p)
    k: FloatArray = gamma_i @ (np.eye(len(p)) - hidden) @ np.linalg.pinv(c)
    return k
