"""Certificates of the reversed connection of an observer: Theorems 3.3.1 and 3.3.2."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.design import symmetric
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.eigenvalues import require_decay, vertices
from pointpred_observers.numerics.matrices import instance, matrix, moments, positive
from pointpred_observers.plants.nonlinearity import NARROWER, intervals, nonlinearity, require_slopes
from pointpred_observers.plants.persidskii import Persidskii, column, row
from pointpred_observers.proofs.bounds import (
    ErrorBound,
    decay_of,
    decay_share,
    eigenvalues,
    least_ratio,
    proved_bound,
    region,
)
from pointpred_observers.proofs.error_system import dissipation
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import Posed, at_decay, cover, decay_start, middle, search
from pointpred_observers.reduced_order.reversed_connection import Connection, InvariantObserver

Slopes = tuple[tuple[float, float], ...] | None


class Convergence(msgspec.Struct, frozen=True):
    """A certificate that the invariant solution attracts the observer's state.

    ``values`` of P, Xi and the theorem's other matrices, the ``margins`` recomputed from them, the ``bound``
    of the error for a disturbance delta of the observer's equation, while the arguments of f, ``J`` times the
    error beside the true ones, stay within ``domain``. ``gap``: how far the least condition number of P in
    balanced units (in discrete time plus the size of Gamma) could lie below this one, relative to it.
    """

    values: dict[str, Any]
    margins: dict[str, float]
    bound: ErrorBound
    J: FloatArray
    domain: float
    gap: float = np.inf

    def region(self, reach: float) -> tuple[float, float]:
        """The level c of e'Pe <= c and the radius of the largest ball of initial errors in the domain.

        ``reach`` bounds abs(H x) on the true trajectory. Raises CertificateError if that leaves the domain.
        """
        return region(
            self.values["P"], self.J, self.domain, np.full(len(self.J), positive("reach", reach, zero=True))
        )

    @classmethod
    def audited(
        cls, connections: list[Connection], plant: Persidskii, values: dict[str, Any], gap: float
    ) -> Convergence:
        """What matrices prove; raises CertificateError naming the inequality that fails."""
        theorem = _theorem(connections, plant.time, plant.slopes, values.get("gamma", 1.0))
        matrices = {name: one for name, one in values.items() if name != "gamma"}
        margins = theorem.check(matrices, printed=False)
        if plant.time == "discrete":
            drive = eigenvalues("Gamma", values["Gamma"])[-1]
        else:  # delta'P delta / gamma, with the factor that the print lacks
            drive = eigenvalues("P", values["P"])[-1] / values["gamma"]
        decay = decay_of(values["P"], values["Xi"], plant.time)
        bound = proved_bound(values["P"], decay, {"delta": drive}, plant.time)
        sloped = [one.J for one in connections if one.S1.any()]
        j = np.vstack(sloped) if sloped else np.zeros((0, len(connections[0].S0)))
        return cls(values, margins, bound, j, plant.domain if sloped else np.inf, gap)


def theorem_3_3_1(
    observer: Any,
    slopes: Any = None,
    gamma: float = 1.0,
    *,
    F: Any = None,
    times: Sequence[float] | None = None,
) -> MatrixInequalities:
    """The inequalities of Theorem 3.3.1 with a constant P, at each of the observer's matrices.

    Unknowns: P, Xi, and W if S1 is not zero. F = P S1; if it is passed, the equality is required.
    e'F(f(Jw) - f(Jz)) <= e'We holds exactly if W >= sym(F D J) at each corner D of the slopes.

    Parameters: ``observer`` an ``InvariantObserver``, or printed matrices {"S0": ..., "S1": ..., "J": ...};
    ``slopes`` of each component of f, by default those of the observer's plant; ``gamma`` in 1/s, > 0;
    ``times`` at which the matrices of an observer that varies are taken.

    >>> theorem = theorem_3_3_1({"S0": [[-2.0]], "S1": [1.0], "J": [1.0]}, [(0.0, 0.5)], gamma=1.0)
    >>> theorem.check({"P": 1.0, "Xi": 1.0, "W": 0.5})["the inequality"]
    1.0
    """
    connections, slopes = connections_of(observer, slopes, times)
    gamma = positive("gamma", gamma)
    q = len(connections[0].S0)
    problem = MatrixInequalities("Theorem 3.3.1").positive("P", q).symmetric("Xi", q)
    problem.above("Xi > 0", lambda v: v.Xi)
    sloped = any(one.S1.any() for one in connections)
    if sloped:
        problem.symmetric("W", q)
    corners = vertices(slopes) if sloped else {}

    def sector(one: Connection, corner: FloatArray, v: Any) -> FloatArray:
        return np.asarray(v.W - symmetric(v.P @ one.S1 @ corner @ one.J))

    def given(s1: FloatArray, f: FloatArray, v: Any) -> FloatArray:
        return np.asarray(v.P @ s1 - f)

    def decaying(one: Connection, v: Any) -> FloatArray:
        within = 2.0 * v.W if sloped else 0.0
        return np.asarray(symmetric(2.0 * v.P @ one.S0) + v.Xi + gamma * v.P + within)

    for i, one in enumerate(connections):
        mark = f" at {i}" if len(connections) > 1 else ""
        if F is not None:
            problem.equal(f"P S1 - F{mark}", partial(given, one.S1, matrix("F", F, q, one.S1.shape[1])))
        for name, corner in corners.items():
            bound = partial(sector, one, corner)
            problem.above(f"W - sym(F D J), D = diag({name}){mark}", bound, strict=False)
        problem.below(f"the inequality{mark}", partial(decaying, one))
    return problem


def theorem_3_3_2(
    observer: Any, slopes: Any = None, gamma: float | None = None, *, times: Sequence[float] | None = None
) -> MatrixInequalities:
    """The inequalities of Theorem 3.3.2 with a constant P.

    Unknowns: P, Xi, Gamma, alpha; the last row and column are q wide, as Gamma is q x q.

    Parameters: ``observer``, ``slopes`` and ``times`` as for ``theorem_3_3_1``; ``gamma`` of the theorem,
    with abs(f(Jw) - f(Jz)) <= gamma abs(w - z), by default the L with abs(L (w - z)) that the slopes imply.
    Raises ParameterError for a gamma below the norm of that L, where an observer has slopes.
    """
    connections, slopes = connections_of(observer, slopes, times)
    if gamma is not None:
        positive("gamma", gamma)
    q = len(connections[0].S0)
    problem = MatrixInequalities("Theorem 3.3.2").positive("P", q).symmetric("Xi", q)
    problem.symmetric("Gamma", q).number("alpha").above("Xi > 0", lambda v: v.Xi)

    for i, one in enumerate(connections):
        if gamma is None:
            steepest = lipschitz(slopes, one.J)
        else:
            steepest = gamma * np.eye(q)
            implied = isinstance(observer, InvariantObserver) and slopes is not None and one.S1.any()
            least = float(np.linalg.norm(lipschitz(slopes, one.J), 2)) if implied else 0.0
            if gamma < least * (1.0 - NARROWER):
                raise ParameterError(
                    f"gamma must be at least {least:.6g}, which the slopes of f and J imply, received "
                    f"{gamma:g}; leave it out, or pass the slopes of f where they are narrower",
                    field="gamma",
                    value=gamma,
                )
        mark = f" at {i}" if len(connections) > 1 else ""
        problem.below(f"the LMI{mark}", partial(_next, one, steepest), strict=False)
    return problem


def certify_convergence(
    observer: InvariantObserver,
    *,
    decay: float | None = None,
    gamma: float | None = None,
    times: Sequence[float] | None = None,
) -> Convergence:
    """A certificate that w = Pi x + Upsilon y attracts the observer's state, recomputed from its matrices.

    Assumes one P for all times; if matrices vary, ``times`` are required and only these are certified, not
    the times between them. Theorem 3.3.2 uses only the Lipschitz constant of f: a steep f is refused although
    it may help. Takes the P of least condition number (in discrete time, with a small Gamma).

    Parameters: ``decay`` of the error in 1/s (per step in discrete time), > 0, by Xi >= 2 decay P; by default
    a fraction of the slowest corner's; ``gamma`` of Theorem 3.3.1 in 1/s, > 0, by default ``decay``.
    Raises CertificateError for an equality that fails by more than the default tolerance, whatever the
    observer's; InfeasibleError naming the eigenvalue where S0 + S1 D J is unstable at a corner D of the
    slopes, before any solver runs; InfeasibleError, UndecidedError, CertificateError from the solver.

    Reference: Khalin 2022, Theorems 3.3.1 and 3.3.2, the bounds corrected.

    >>> from pointpred_observers import Persidskii, invariant_observer
    >>> plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", C0=[1.0, 0.0])
    >>> certificate = certify_convergence(invariant_observer(plant, [[0.0, 1.0]], [[-3.0]]), decay=2.0)
    >>> min(certificate.margins.values()) > 0.0, certificate.bound(1.0, 1.0) < 0.14
    (True, True)
    >>> certify_convergence(invariant_observer(plant, [[0.0, 1.0]], [[2.0]]))
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: Theorem 3.3.1: S0 + S1 D J has the eigenvalue 1, must lie left of 0
    """
    for name, given in (("decay", decay), ("gamma", gamma)):
        if given is not None:
            positive(name, given)
    connections = _held(instance("observer", observer, InvariantObserver), times)
    plant = observer.plant
    theorem = "3.3.2" if plant.time == "discrete" else "3.3.1"
    corners = [("", one.S0) for one in connections if not one.S1.any()]
    for one in (one for one in connections if one.S1.any()):
        slopes = vertices(plant.slopes).items()
        corners += [(f"D = diag({name})", one.S0 + one.S1 @ d @ one.J) for name, d in slopes]
    slowest = require_decay(corners, plant.time, f"Theorem {theorem}: S0 + S1 D J")

    def certified(rate: float) -> Convergence:
        scale, share = gamma or rate, decay_share(rate, plant.time)

        def posed(units: Coordinates) -> Posed:
            x, t = units.states, units.seconds
            inner = [
                msgspec.structs.replace(
                    one,
                    S0=inward(one.S0, x, x, t),
                    S1=inward(one.S1, x, units.values, t),
                    J=inward(one.J, units.arguments, x),
                )
                for one in connections
            ]
            slopes = units.slopes(plant.slopes)
            problem, identity = _theorem(inner, plant.time, slopes, scale * t), np.eye(len(x))
            needed = decay_share(rate * t, plant.time)
            problem.above("Xi for the decay", lambda v: v.Xi - needed * v.P, strict=False)
            problem.number("bound").above("bound - P", lambda v: v.bound * identity - v.P, strict=False)
            if plant.time == "discrete":
                problem.number("noise").above(
                    "noise - Gamma", lambda v: v.noise * identity - v.Gamma, strict=False
                )
            form = np.outer(x, x)
            measured = {"P": form, "Xi": t * form, "W": t * form, "Gamma": form, "alpha": 1.0}
            start = _start(inner, plant.time, slopes, (rate * t, scale * t))
            return Posed(problem, measured, lambda v: v.bound + getattr(v, "noise", 0.0), start)

        def audited(values: dict[str, Any], gap: float) -> Convergence:
            # Xi >= 2 decay P may fail by rounding; the theorem's own inequality has room for that.
            missing = share - least_ratio(values["P"], values["Xi"])
            if missing > 0.0:
                values["Xi"] = values["Xi"] + 2.0 * missing * values["P"]
            if plant.time == "continuous":
                values["gamma"] = scale
            return Convergence.audited(connections, plant, values, gap)

        units = balanced(
            [one.S0 for one in connections],
            driven=[one.S1 for one in connections],
            inner=[one.J for one in connections],
            slopes=plant.slopes,
            rates=(rate, scale),
            time=plant.time,
        )
        return search(units, posed, audited, lambda one: 0.5 * float(np.log(np.linalg.cond(one.values["P"]))))

    return at_decay(decay, slowest, plant.time, certified)


def certified_convergence(
    observer: InvariantObserver, values: dict[str, Any], gap: float = np.inf
) -> Convergence:
    """The certificate that matrices from any source are, audited; constant matrices of the observer only.

    Raises CertificateError naming the equality or the inequality that fails.
    """
    return Convergence.audited(_held(observer, None), observer.plant, dict(values), gap)


def _theorem(connections: list[Connection], time: str, slopes: Slopes, gamma: float) -> MatrixInequalities:
    if time == "discrete":
        return theorem_3_3_2(connections, slopes)
    return theorem_3_3_1(connections, slopes, gamma)


def _held(observer: InvariantObserver, times: Sequence[float] | None) -> list[Connection]:
    """The matrices that are certified; raises CertificateError for an equality that does not hold."""
    varying = "the observer" if observer.varying else ""
    connections = [observer.at(t) for t in moments(varying, times, "certified")]
    for one in connections:
        one.require_equalities()
    return connections


def connections_of(
    observer: Any, slopes: Any = None, times: Sequence[float] | None = None
) -> tuple[list[Connection], Slopes]:
    """The matrices at each time, of an observer or as printed, with the slopes of f; checked."""
    if isinstance(observer, InvariantObserver):
        varying = "the observer" if observer.varying else ""
        connections = [observer.at(t) for t in moments(varying, times, "checked")]
        plant = observer.plant
        if slopes is None:
            slopes = plant.slopes
        elif any(one.S1.any() for one in connections):
            f = nonlinearity(plant.f, plant.k, intervals(slopes, plant.k))
            require_slopes(f, plant.k, plant.r, plant.domain)
    elif isinstance(observer, Mapping):
        connections = [_printed(observer)]
    elif isinstance(observer, list) and observer and all(isinstance(one, Connection) for one in observer):
        connections = observer
    else:
        raise ParameterError(
            "a theorem of section 3.3 needs an InvariantObserver, or printed matrices S0, S1 and J, "
            f"received {observer!r:.80}",
            field="observer",
        )
    k = connections[0].S1.shape[1]
    return connections, intervals(slopes, k) if k and slopes is not None else slopes


def _printed(given: Mapping[str, Any]) -> Connection:
    if "S0" not in given or set(given) - {"S0", "S1", "J"}:
        raise ParameterError(
            f"printed matrices are S0 and, where f matters, S1 and J, received {', '.join(map(str, given))}",
            field="observer",
        )
    q = len(matrix("S0", given["S0"]))
    s0, s1 = matrix("S0", given["S0"], q, q), column("S1", given.get("S1"), q)
    j = row("J", given.get("J"), q)
    if len(j) != s1.shape[1]:
        raise ParameterError(
            f"J has {len(j)} rows, needs {s1.shape[1]}, one for each column of S1", field="J"
        )
    none = np.zeros((q, 0))
    return Connection(none, s0, s1, j, none, none, np.zeros((len(j), 0)), {})


def lipschitz(slopes: Slopes, j: FloatArray) -> FloatArray:
    """The L with abs(f(Jw) - f(Jz)) <= abs(L (w - z)); the gamma I of Theorem 3.3.2 is its norm, larger."""
    if slopes is None or not np.isfinite(np.array(slopes)).all():
        raise ParameterError(f"a certificate needs bounded slopes, received {slopes}")
    steepest = np.abs(np.array(slopes).reshape(-1, 2)).max(axis=1, initial=0.0)
    return np.asarray(steepest[:, None] * j, np.float64)


def _next(one: Connection, steepest: FloatArray, v: Any) -> FloatArray:
    """V(k+1) - V(k) + e'Xi e - delta'Gamma delta, with the terms of the Lipschitz constant."""
    q, k = one.S1.shape
    forces = np.zeros((k + q, k + q))
    forces[:k, :k], forces[k:, k:] = -v.alpha * np.eye(k), -v.Gamma
    own = v.Xi - v.P + v.alpha * (steepest.T @ steepest)
    return dissipation(one.S0, np.hstack([one.S1, -np.eye(q)]), v.P, own, forces, "discrete")


def _start(
    connections: list[Connection], time: str, slopes: Slopes, rates: tuple[float, float]
) -> dict[str, Any] | None:
    """Matrices of the theorem for the P of Lyapunov's equation at the middle slopes."""
    one, sloped = connections[0], any(other.S1.any() for other in connections)
    (decay, gamma), discrete = rates, time == "discrete"
    a = one.S0 + one.S1 @ middle(slopes) @ one.J if sloped else one.S0
    p = decay_start(a, 1.01 * (decay if discrete else decay + 0.5 * gamma), time)
    if p is None:
        return None
    # Xi - share P is 0 to the last digit, which its audit accepts whatever the condition number of P.
    share = decay_share(decay, time)
    values: dict[str, Any] = {"P": p, "Xi": share * p, "bound": 2.0 * np.linalg.norm(p, 2)}
    if discrete:
        steepest = lipschitz(slopes, one.J)
        onward = np.hstack([one.S0, one.S1])
        rest = -onward.T @ p @ onward
        q = len(p)
        rest[:q, :q] += p - values["Xi"] - steepest.T @ steepest
        rest[q:, q:] += np.eye(len(rest) - q)
        across = p @ onward
        room = p + 2.0 * across @ np.linalg.pinv(rest) @ across.T
        values["alpha"], values["Gamma"] = 1.0, symmetric(room) + p
        values["noise"] = 2.0 * float(np.linalg.norm(values["Gamma"], 2))
    elif sloped:
        values["W"] = cover(p @ one.S1, one.J, slopes)
    return values
