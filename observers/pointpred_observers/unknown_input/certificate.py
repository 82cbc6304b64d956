"""Theorem 1 of the camera paper, also in discrete time: its certificate, and the matrices that satisfy it.

The matrices are those of one small semidefinite problem, the gains follow in closed form; every eigenvalue of
a certificate is recomputed.
"""

from __future__ import annotations

from functools import partial
from math import exp, inf, log
from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from pointpred.errors import CertificateError, InfeasibleError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import positive
from pointpred_observers.plants.varying import kernel
from pointpred_observers.proofs.bounds import LEAST_POSITIVE, ErrorBound, least, proved_bound
from pointpred_observers.proofs.error_system import dissipation
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import decay_start, filter_start


class Room(NamedTuple):
    """How far the matrices stay from the edge of what is feasible, where gains grow without bound."""

    weight: float
    """Of the trace of P beside gamma in the objective; without it P and the gains grow needlessly."""
    factor: float
    """On the least gamma, with which the inequality would hold with equality."""


ROOMS = (Room(0.01, 1.001), Room(1.0, 10.0))
"""Those that are tried in turn: the second has smaller gains, whose rounding takes less of the proof."""
NEGLIGIBLE = 1e-9
"""A gamma below this share of a modest one counts as zero."""
DECOUPLED = 1e-13
"""C T below this, relative to C, is rounding."""


class UnknownInputCertificate(msgspec.Struct, frozen=True, eq=False):
    """The matrices that prove the decay of an observer's error.

    |e(t)| <= phi1 |e(0)| exp(-decay t) + phi2 sup |delta|, delta = (A(p) - A(p_hat)) x, as long as the
    scheduling variables stay in the box; decay is sigma / 2 of the theorem. ``margin``: how far the largest
    eigenvalue of (27c) lies below 0. In discrete time t counts steps.
    """

    decay: float
    """The proved rate, 1/s (1/step)."""
    P: FloatArray
    force: FloatArray
    """F of the theorem, n x n; gamma is its largest eigenvalue."""
    margin: float
    zeros: NDArray[np.complex128]
    """Invariant zeros, 1/s (factors in discrete time), one row per vertex."""
    gap: float = np.inf
    """How far the least gamma + 0.01 trace P in balanced units could lie below that of the design, relative;
    infinite if nothing is proved."""
    time: str = "continuous"

    @property
    def margins(self) -> dict[str, float]:
        """The margin by the name of its inequality."""
        return {"(27c)": self.margin}

    @property
    def gamma(self) -> float:
        """The bound of F, F <= gamma I."""
        return float(np.linalg.eigvalsh(self.force)[-1])

    @property
    def phi1(self) -> float:
        """sqrt(chi2 / chi1), chi the extreme eigenvalues of P."""
        return self.bound.overshoot

    @property
    def phi2(self) -> float:
        """sqrt(gamma / (2 decay chi1)), s; in discrete time with 1 - exp(-2 decay) for 2 decay."""
        return self.bound.gains[0]

    @property
    def largest_decay(self) -> float:
        """The bound on the decay of any design in this box, 1/s (1/step); infinite without zeros."""
        return largest_decay(self.zeros, self.time)

    @property
    def bound(self) -> ErrorBound:
        """The proved bound of |e|, disturbed by ``delta``."""
        return proved_bound(self.P, self.decay, {"delta": self.gamma}, self.time)


def largest_decay(zeros: NDArray[np.complex128], time: str = "continuous") -> float:
    """-max Re s over all zeros, in discrete time -log max abs(s): every feasible decay lies below it.

    >>> largest_decay(np.array([[-0.5 + 1j, -0.25], [-2.0, -1.0]]))
    0.25
    >>> round(largest_decay(np.array([[0.5, -0.1]]), "discrete"), 6)  # log 2
    0.693147
    """
    if not zeros.size:
        return inf
    if time == "continuous":
        return float(-zeros.real.max())
    largest = float(np.abs(zeros).max())
    return -log(largest) if largest > 0.0 else inf


def inequality(
    n_i: FloatArray,
    t_i: FloatArray,
    p: FloatArray,
    force: FloatArray,
    decay: float,
    time: str = "continuous",
    sign: float = -1.0,
) -> FloatArray:
    """The matrix of (27c) at one vertex with W = P K and N = Gamma - K C: below 0 it is a proof.

    That is with - W C: the print has + W C, which contradicts N = Gamma - K C of (44). In discrete time,
    which the paper does not have, it is V(e+) - exp(-2 decay) V(e) - delta'F delta with e+ = N e + T delta,
    N = T A - K C. With ``sign`` 1 and absolute values it is the size of each entry's terms.
    """
    share = sign * exp(-2.0 * decay) if time == "discrete" else 2.0 * decay
    return dissipation(n_i, t_i, p, share * p, sign * force, time)


def audit(
    gammas: FloatArray,
    ts: FloatArray,
    c: FloatArray,
    p: FloatArray,
    ks: FloatArray,
    force: FloatArray,
    decay: float,
    zeros: NDArray[np.complex128],
    time: str = "continuous",
) -> UnknownInputCertificate:
    """Recompute every eigenvalue of Theorem 1; raises CertificateError naming the one that fails.

    ``gammas``, ``ts`` and the gains ``ks`` hold one matrix per vertex, ``force`` is F of the theorem. The
    gains that run are the ones that are proved. Multiplying P and F by one positive number does not change
    the result.
    """
    positive("decay", decay)
    for name, matrix in (("P", p), ("F", force)):
        # To the last bit, in any unit: eigenvalues are computed from the lower triangle alone.
        fault = f"it differs from its transpose by {np.abs(matrix - matrix.T).max():.3g}"
        if np.array_equal(matrix, matrix.T):
            lowest = least(matrix)[0]
            fault = "" if lowest > 0.0 else f"its least eigenvalue is {lowest:.6g}"
        if fault:
            raise CertificateError(f"{name} must be symmetric and positive definite, {fault}", field=name)
    largest, at = -np.inf, 0
    for vertex, (gamma_i, t_i, k_i) in enumerate(zip(gammas, ts, ks, strict=True)):
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            whole = -inequality(gamma_i - k_i @ c, t_i, p, force, decay, time)
            moved = np.abs(gamma_i) + np.abs(k_i) @ np.abs(c)
            terms = inequality(moved, np.abs(t_i), np.abs(p), np.abs(force), decay, time, 1.0)
        if not (np.isfinite(whole).all() and np.isfinite(terms).all()):
            raise CertificateError(
                f"(27c) holds numbers that are too large to compute with at vertex {vertex}: check the "
                "largest entries of the gains, of P and of F"
            )
        sizes = np.diag(terms)
        value, relative = least(whole, sizes)
        # What rounding of the terms could make of it does not count as negative. Entries off the diagonal
        # may be small differences of larger terms: those of a lightly damped pair are.
        d = 1.0 / np.sqrt(sizes)
        spread = float(np.linalg.norm(terms * d * d[:, None], 2))
        eigenvalue = -value if relative > LEAST_POSITIVE * spread else max(-value, 0.0)
        if not eigenvalue <= largest:
            largest, at = eigenvalue, vertex
    if not largest < 0.0:
        raise CertificateError(f"(27c) has the eigenvalue {largest:.6g} at vertex {at}, must lie below 0")
    return UnknownInputCertificate(decay, p, force, -largest, zeros, time=time)


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
    gain can cancel share one inequality. The gap is that of gamma + 0.01 trace P; infinite with another
    ``room`` than the first.

    Raises InfeasibleError if no P serves all vertices although the zeros of each allow one, UndecidedError if
    none is found.
    """
    discrete, blind, rest = time == "discrete", kernel(c), np.zeros((c.shape[1], c.shape[1]))
    size, frame, gap, p = blind.shape[1], np.eye(c.shape[1]), np.inf, np.eye(c.shape[1])
    # P as rest + F X F' with X to be found: all of P, or its part on the kernel of C if C T = 0.
    decoupled = float(np.abs(c @ ts).max()) <= DECOUPLED * float(np.abs(c).max() * max(1.0, np.abs(ts).max()))
    if decoupled:
        frame, rest = blind, np.asarray(np.linalg.pinv(c) @ c, np.float64)

    def block(case: FloatArray, whole: bool, v: Any) -> Any:
        """The inequality of a case, or its corner, the decay alone."""
        p = rest + frame @ v.P @ frame.T
        corner, side, own = _unseen(p, blind, case[:, :size], case[:, size:], decay, time)
        if not whole:
            return corner
        return np.block([[corner, side], [side.T, own - v.gamma * np.eye(len(own))]])

    if size:
        pushes = ts
        if not discrete:
            # T' enters through R with R R' = T T', as few columns as T has rows that differ from zero.
            roots = np.array([np.asarray(np.linalg.qr(t.T, mode="r")).T for t in ts])
            pushes = roots[:, :, np.abs(roots).max(axis=(0, 1)) > 0.0]
        best = MatrixInequalities("unknown input observer, least gamma").positive("P", frame.shape[1])
        any_p = MatrixInequalities("unknown input observer, decay").positive("P", frame.shape[1])
        best.number("gamma")
        for i, case in enumerate(np.unique(np.concatenate([gammas @ blind, pushes], axis=2), axis=0)):
            best.below(f"(27c), case {i}", partial(block, case, True))
            any_p.below(f"decay, case {i}", partial(block, case, False))
        start = _start(gammas.mean(axis=0), c, decay, decoupled, time)
        near = None if start is None else {"P": start}
        try:
            both = None if near is None else {**near, "gamma": 1.0}
            solution = best.solve(minimise=lambda v: v.gamma + room.weight * np.trace(v.P), near=both)
            gap = np.inf if solution.gap is None or room != ROOMS[0] else solution.gap
        except (InfeasibleError, UndecidedError):  # the required gamma may be too large for a solver
            try:
                solution = any_p.solve(near=near)
            except (InfeasibleError, UndecidedError) as none:
                why = "no P serves every vertex" if isinstance(none, InfeasibleError) else "too closely"
                raise type(none)(
                    f"the invariant zeros allow a decay of {decay:g}, but {why}: choose a smaller decay or a "
                    f"smaller box ({none})"
                ) from none
        p = rest + frame @ solution.values["P"] @ frame.T
    needed = 0.0
    for gamma_i, t_i in zip(gammas, ts, strict=True):
        corner, side, own = _unseen(p, blind, gamma_i @ blind, t_i, decay, time)
        needed = max(needed, float(np.linalg.eigvalsh(own - side.T @ np.linalg.solve(corner, side))[-1]))
    # Any gamma will do where no error can hide from the outputs: max T'P T / (2 decay), whose term takes no
    # more from the decay than the decay does. A smaller one has larger gains.
    push = max(float(np.linalg.eigvalsh(t.T @ p @ t)[-1]) for t in ts)
    usual = 1.0 if discrete else (push if push > NEGLIGIBLE else 1.0) / (2.0 * decay)
    return p, room.factor * needed if needed > NEGLIGIBLE * usual else usual, gap


def _unseen(
    p: FloatArray, blind: FloatArray, moved: FloatArray, pushed: FloatArray, decay: float, time: str
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The blocks of (27c) without F for errors ``blind`` x, which move by ``moved`` x + ``pushed`` delta."""
    if time == "discrete":
        corner = moved.T @ p @ moved - exp(-2.0 * decay) * (blind.T @ p @ blind)
        return corner, moved.T @ p @ pushed, pushed.T @ p @ pushed
    half = blind.T @ p @ (moved + decay * blind)
    return half + half.T, blind.T @ p @ pushed, np.zeros((pushed.shape[1],) * 2)


def _start(mean: FloatArray, c: FloatArray, decay: float, decoupled: bool, time: str) -> FloatArray | None:
    """A P for the mean of the vertices, from which a solver starts."""
    if decoupled:
        blind = kernel(c)
        return decay_start(blind.T @ mean @ blind, 1.01 * decay, time)
    start = filter_start(mean, c, 1.01 * decay, time)
    return None if start is None else start[0]


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
