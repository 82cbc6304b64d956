"""Gains of an unknown input observer: one small semidefinite problem, the rest in closed form."""

from __future__ import annotations

from functools import partial
from typing import Any, NamedTuple

import numpy as np

from pointpred.errors import InfeasibleError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities, Solution
from pointpred_observers.stationary import decay_start, filter_start
from pointpred_observers.unknown_input.invariant_zeros import kernel


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
    gammas: FloatArray, ts: FloatArray, c: FloatArray, sigma: float, room: Room = ROOMS[0]
) -> tuple[FloatArray, float, float]:
    """P and gamma with F = gamma I from (27c) on the kernel of C, where no gain acts, and the gap.

    The gains drop out (elimination lemma). If C T = 0, the outputs' part of P drops out as well and is set to
    the identity; vertices that differ only in terms that a gain can cancel share one inequality. The
    certificate does not change with the scale of P. The gap is that of gamma + 0.01 trace P: how far the
    least could lie below it, relative to it; infinite with another ``room`` than the first.

    Raises InfeasibleError if no P serves all vertices although the zeros of each allow one, UndecidedError if
    none is found.
    """
    blind, frame, rest = frames(c, ts)
    if not blind.shape[1]:
        p = np.eye(c.shape[1])
        return p, modest(ts, p, sigma), np.inf
    # T' enters through its output columns only, which vanish on the kernel of C.
    cases = np.unique(np.concatenate([gammas @ blind, _root(ts)], axis=2), axis=0)

    def problem(name: str) -> MatrixInequalities:
        inequalities = MatrixInequalities(f"unknown input observer, {name}")
        return inequalities.positive("P", frame.shape[1])

    def corner(case: FloatArray, v: Any) -> FloatArray:
        moved = case[:, : blind.shape[1]] + 0.5 * sigma * blind
        half: FloatArray = blind.T @ (rest + frame @ v.P @ frame.T) @ moved
        return half + half.T

    def whole(case: FloatArray, v: Any) -> FloatArray:
        side = blind.T @ (rest + frame @ v.P @ frame.T) @ case[:, blind.shape[1] :]
        return np.block([[corner(case, v), side], [side.T, -v.gamma * np.eye(side.shape[1])]])

    best, any_p = problem("least gamma").number("gamma"), problem("decay")
    for i, case in enumerate(cases):
        best.below(f"(27c), case {i}", partial(whole, case))
        any_p.below(f"decay, case {i}", partial(corner, case))
    start, gap = mean_start(gammas, c, sigma, decoupled=frame is blind), np.inf
    try:
        near = None if start is None else {"P": start, "gamma": 1.0}
        solution = best.solve(minimise=lambda v: v.gamma + room.weight * np.trace(v.P), near=near)
        values, gap = solution.values, room.gap(solution)
    except (InfeasibleError, UndecidedError):  # the required gamma may be too large for a solver
        near = None if start is None else {"P": start}
        values = solved(any_p, near, sigma).values
    p = rest + frame @ values["P"] @ frame.T
    needed, usual = least_gamma(gammas, ts, c, p, sigma), modest(ts, p, sigma)
    return p, room.factor * needed if needed > NEGLIGIBLE * usual else usual, gap


def solved(
    problem: MatrixInequalities, near: dict[str, Any] | None, sigma: float, minimise: Any = None
) -> Solution:
    """Some P with the decay; raises an error that names sigma."""
    allowed = f"the invariant zeros allow sigma = {sigma:g}, but"
    try:
        return problem.solve(minimise=minimise, near=near)
    except InfeasibleError as none:
        raise InfeasibleError(
            f"{allowed} no P serves every vertex: choose a smaller sigma or a smaller box ({none})"
        ) from none
    except UndecidedError as none:
        raise UndecidedError(
            f"{allowed} too closely: choose a smaller sigma or a smaller box ({none})"
        ) from none


def mean_start(
    gammas: FloatArray, c: FloatArray, sigma: float, *, decoupled: bool, time: str = "continuous"
) -> FloatArray | None:
    """A P for the mean of the vertices."""
    mean = gammas.mean(axis=0)
    if decoupled:
        blind = kernel(c)
        return decay_start(blind.T @ mean @ blind, 0.505 * sigma, time)
    start = filter_start(mean, c, 0.505 * sigma, time)
    return None if start is None else start[0]


def frames(c: FloatArray, ts: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The kernel B of C, and P as R + F X F' with X to be found: all of P, or its part on B if C T = 0."""
    blind = kernel(c)
    if float(np.abs(c @ ts).max()) > DECOUPLED * float(np.abs(c).max() * max(1.0, np.abs(ts).max())):
        return blind, np.eye(c.shape[1]), np.zeros((c.shape[1], c.shape[1]))
    return blind, blind, np.asarray(np.linalg.pinv(c) @ c, np.float64)


def modest(ts: FloatArray, p: FloatArray, sigma: float) -> float:
    """The gamma max T'P T / sigma, for which the term of gamma takes no more from the decay than sigma does.

    Any gamma will do where no error can hide from the outputs; a smaller one has larger gains.
    """
    largest = max(float(np.linalg.eigvalsh(t.T @ p @ t)[-1]) for t in ts)
    return (largest if largest > NEGLIGIBLE else 1.0) / sigma


def _root(ts: FloatArray) -> FloatArray:
    """R with R R' = T T' for each T, as few columns as T has rows that differ from zero."""
    roots = np.array([np.asarray(np.linalg.qr(t.T, mode="r")).T for t in ts])
    used = np.abs(roots).max(axis=(0, 1)) > 0.0
    return roots[:, :, used]


def least_gamma(gammas: FloatArray, ts: FloatArray, c: FloatArray, p: FloatArray, sigma: float) -> float:
    """The least gamma for which P satisfies (27c) on the kernel of C at every vertex."""
    blind, least = kernel(c), 0.0
    for gamma_i, t_i in zip(gammas, ts, strict=True):
        half = blind.T @ p @ (gamma_i + 0.5 * sigma * np.eye(len(p))) @ blind
        side = blind.T @ p @ t_i
        least = max(least, float(np.linalg.eigvalsh(side.T @ np.linalg.solve(-(half + half.T), side))[-1]))
    return least


def gain(
    gamma_i: FloatArray,
    t_i: FloatArray,
    c: FloatArray,
    p: FloatArray,
    gamma: float,
    sigma: float,
    output_rate: float,
) -> FloatArray:
    """W = P K at one vertex: it decouples the outputs from the other states and makes their errors decay.

    In the basis (C^+, ker C) the Schur complement of (27c) becomes diag(-2 rho P_11, the block that P was
    solved for).
    """
    basis = np.hstack([np.linalg.pinv(c), kernel(c)])
    outputs = c.shape[0]
    whole = gamma_i.T @ p + p @ gamma_i + sigma * p + p @ t_i @ t_i.T @ p / gamma
    turned = basis.T @ whole @ basis
    own = (basis.T @ p @ basis)[:outputs, :outputs]
    w1 = 0.5 * turned[:outputs, :outputs] + output_rate * own
    w: FloatArray = np.linalg.solve(basis.T, np.vstack([w1, turned[outputs:, :outputs]]))
    return w
