"""The system that an error obeys, at the corners of what is uncertain; its decay and its L2 gain, proved."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from itertools import pairwise
from math import exp, inf, sqrt
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates, balanced
from pointpred_observers.numerics.eigenvalues import require_decay, vertices
from pointpred_observers.numerics.matrices import (
    TIMES,
    dimensions,
    instance,
    listed,
    matrix,
    one_of,
    positive,
)
from pointpred_observers.proofs.bounds import ErrorBound, proved_bound
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import Posed, at_decay, search

ROOM = 1e-6
"""Relative room that is added to the least gain, with which the inequality would hold with equality."""

TOLERANCE = 1e-10
"""Relative error of the norm."""
STEPS_MOST = 60


class ErrorSystem(msgspec.Struct, frozen=True):
    """e' = A e + B delta, z = C e, with (A, B) anywhere between the corners.

    In discrete time e' is the next e. ``A`` (corners, n, n), ``B`` (corners, n, m), ``C`` (outputs, n);
    ``names`` of the corners, "" for a linear system's only one; ``disturbances`` names the parts of delta and
    their widths, in the order of B's columns. The corners hold while the arguments of f stay within
    ``domain``, and so does every proof that is made of them.

    Raises ParameterError for shapes that do not fit each other, entries that are not finite, and a ``time``
    other than "continuous" and "discrete".
    """

    A: FloatArray
    B: FloatArray
    C: FloatArray
    names: tuple[str, ...]
    disturbances: dict[str, int]
    time: str
    domain: float = inf

    def __post_init__(self) -> None:
        a, b = stack("A", self.A), stack("B", self.B)
        if a.shape[1] != a.shape[2] or b.shape[:2] != a.shape[:2]:
            raise ParameterError(
                "A and B need the shapes (corners, n, n) and (corners, n, m), "
                f"received {a.shape} and {b.shape}",
                field="A",
            )
        c, names = matrix("C", self.C, None, a.shape[1]), tuple(listed("names", self.names))
        for name, value in (("A", a), ("B", b), ("C", c), ("names", names)):
            msgspec.structs.force_setattr(self, name, value)
        if len(names) != len(a):
            raise ParameterError(
                f"names must be {len(a)}, one for each corner, received {names!r}", field="names"
            )
        widths = list(instance("disturbances", self.disturbances, dict).values())
        if not all(is_number(one) and one == int(one) >= 0 for one in widths) or sum(widths) != b.shape[2]:
            raise ParameterError(
                f"the widths of disturbances must add up to the {b.shape[2]} columns of B, received "
                f"{self.disturbances!r}",
                field="disturbances",
            )
        one_of("time", self.time, TIMES)
        if not (is_number(self.domain) and self.domain == inf):
            positive("domain", self.domain)

    @property
    def n(self) -> int:
        """The number of states."""
        return int(self.A.shape[1])

    def places(self) -> dict[str, slice]:
        """The columns of B by disturbance."""
        ends = [int(one) for one in np.cumsum([0, *self.disturbances.values()])]
        return {name: slice(*pair) for name, pair in zip(self.disturbances, pairwise(ends), strict=True)}

    def seen_as(self, C: Any) -> ErrorSystem:
        """The same system with the output z = C e; raises ParameterError for another width."""
        return msgspec.structs.replace(self, C=matrix("C", C, None, self.n))

    def disturbed_by(self, *names: str) -> ErrorSystem:
        """The same system with only these disturbances; raises ParameterError for an unknown one."""
        places = self.places()
        if not names or set(names) - set(places):
            raise ParameterError(
                f"the disturbances are {', '.join(places)}, received {', '.join(names) or 'none'}"
            )
        b = np.concatenate([self.B[:, :, places[name]] for name in names], axis=2)
        widths = {name: self.disturbances[name] for name in names}
        return msgspec.structs.replace(self, B=b, disturbances=widths)

    def inward(self, units: Coordinates) -> ErrorSystem:
        """The same system with its states and time in these units."""
        x, t = units.states, units.seconds
        a, b = t * self.A * x / x[:, None], t * self.B / x[:, None]
        return msgspec.structs.replace(self, A=a, B=b, C=self.C * x)

    def slowest(self) -> float:
        """The largest real part of an eigenvalue, 1/s (logarithm of its modulus, 1/step), at any corner.

        Raises InfeasibleError naming an eigenvalue that does not decay, and its corner.
        """
        return require_decay(zip(self.names, self.A, strict=True), self.time, "the error system")


def stack(name: str, value: Any) -> FloatArray:
    """Matrices of one shape, one for each corner; raises ParameterError for anything else."""
    corners = [matrix(name, one) for one in listed(name, value)]
    if not corners or dimensions(value) != 3:
        raise ParameterError(
            f"{name} must be a list of matrices of one shape, one for each corner, received {value!r:.80}",
            field=name,
            value=value,
        )
    return np.array(corners)


def sloped_system(
    A: FloatArray,
    F: FloatArray,
    H: FloatArray,
    B: Mapping[str, FloatArray],
    *,
    slopes: tuple[tuple[float, float], ...] | None,
    time: str,
    through: Mapping[str, FloatArray] | None = None,
    domain: float = inf,
) -> ErrorSystem:
    """The error system e' = A e + F (f(s + H e + R delta) - f(s)) + B delta for every f with these slopes.

    By the mean value theorem the difference is D (H e + R delta) with D diagonal between the slopes.
    ``through`` are the R of some of the disturbances. The slopes hold within ``domain``: the system has it
    wherever f matters. Raises ParameterError where f matters and its slopes are missing or not bounded.

    >>> system = sloped_system(
    ...     -np.eye(1), np.ones((1, 1)), np.eye(1), {"d": np.eye(1)}, slopes=((0.0, 0.5),), time="continuous"
    ... )
    >>> dict(zip(system.names, system.A.ravel().tolist(), strict=True))
    {'D = diag(0)': -1.0, 'D = diag(0.5)': -0.5}
    """
    drive = np.hstack([*B.values()])
    inner = np.hstack([(through or {}).get(name, np.zeros((len(H), b.shape[1]))) for name, b in B.items()])
    widths = {name: int(b.shape[1]) for name, b in B.items()}
    if not F.any():
        return ErrorSystem(A[None], drive[None], np.eye(len(A)), ("",), widths, time)
    corners = vertices(slopes)
    return ErrorSystem(
        np.array([A + F @ d @ H for d in corners.values()]),
        np.array([drive + F @ d @ inner for d in corners.values()]),
        np.eye(len(A)),
        tuple(f"D = diag({name})" for name in corners),
        widths,
        time,
        domain,
    )


def dissipation(
    a: FloatArray, b: FloatArray, p: FloatArray, own: FloatArray, forces: FloatArray, time: str
) -> FloatArray:
    """V' (in discrete time V of the next e) as a form in (e, delta), with e' = a e + b delta, and more.

    ``own`` (n, n) is added for e, and ``forces`` (m, m) for delta.
    """
    if time == "discrete":
        onward = np.hstack([a, b])
        whole: FloatArray = onward.T @ p @ onward
    else:
        half, side = p @ a, p @ b
        whole = np.block([[half + half.T, side], [side.T, np.zeros_like(forces)]])
    n = len(a)
    whole[:n, :n] += own
    whole[n:, n:] += forces
    return whole


class DecayCertificate(msgspec.Struct, frozen=True):
    """V = e'Pe decays at every corner: P, the ``margins`` recomputed from it, and the ``bound`` of abs(e).

    Holds while the arguments of f stay within ``domain``, that of the ``system``.
    """

    P: FloatArray
    values: dict[str, Any]
    margins: dict[str, float]
    bound: ErrorBound
    system: ErrorSystem
    domain: float = np.inf


def decay_inequalities(system: ErrorSystem, decay: float) -> MatrixInequalities:
    """V' <= -2 decay V + sum of bound_i abs(delta_i)^2 at every corner.

    In discrete time V(e') <= exp(-2 decay) V with the same sum.

    Unknowns: P and bound_i for each disturbance i, in the order of ``system.disturbances``.
    """
    problem = MatrixInequalities("decay").positive("P", system.n)
    for i in range(len(system.disturbances)):
        problem.number(f"bound_{i}")
    widths = list(system.disturbances.values())

    def block(a: FloatArray, b: FloatArray, v: Any) -> FloatArray:
        sizes = [np.full(width, getattr(v, f"bound_{i}")) for i, width in enumerate(widths)]
        forces = -np.diag(np.concatenate(sizes))
        if system.time == "continuous":
            return dissipation(a + decay * np.eye(len(a)), b, v.P, 0.0 * v.P, forces, system.time)
        # Schur's complement of a'Pa: the solver keeps a margin where with the product it ends at the edge.
        onward = v.P @ np.hstack([a, b])
        before = np.block([[-exp(-2.0 * decay) * v.P, 0.0 * b], [0.0 * b.T, forces]])
        return np.block([[before, onward.T], [onward, -v.P]])

    for name, a, b in zip(system.names, system.A, system.B, strict=True):
        problem.below(f"V'{f' at {name}' if name else ''}", partial(block, a, b))
    return problem


def certify_decay(system: ErrorSystem, *, decay: float | None = None) -> DecayCertificate:
    """A certificate that the error decays, with small overshoot and gains.

    Assumes one P for all corners, which is conservative where there are several: a refusal does not say that
    some f keeps the error from decaying.

    Parameters: ``decay`` in 1/s (1/step), > 0, by default a fraction of the slowest corner's.
    Raises InfeasibleError naming an eigenvalue that does not decay before any solver runs;
    InfeasibleError, UndecidedError, CertificateError from the solver.

    >>> import numpy as np
    >>> from pointpred_observers.proofs.error_system import sloped_system
    >>> system = sloped_system(
    ...     -2 * np.eye(1), np.eye(1), np.eye(1), {"d": np.eye(1)}, slopes=((0.0, 1.0),), time="continuous"
    ... )
    >>> found = certify_decay(system, decay=0.5)
    >>> round(found.bound.decay, 6), found.bound(0.0, 0.0, d=1.0) < 1.5, min(found.margins.values()) > 0.0
    (0.5, True, True)
    """
    if decay is not None:
        positive("decay", decay)
    slowest = instance("system", system, ErrorSystem).slowest()
    units = partial(balanced, system.A, driven=system.B, time=system.time)

    def certified(rate: float) -> DecayCertificate:
        return search(
            units(rates=(rate,)),
            partial(_posed, system, rate),
            lambda values, _: certified_decay(system, values, rate),
            lambda one: float(sum(np.log([one.bound.overshoot, *filter(None, one.bound.gains)]))),
        )

    return at_decay(decay, slowest, system.time, certified)


def _posed(system: ErrorSystem, decay: float, units: Coordinates) -> Posed:
    """The least P and the least gains in these units, each disturbance in one of its own."""
    inner, x, t = system.inward(units), units.states, units.seconds
    sizes = [float(np.abs(inner.B[:, :, one]).max(initial=0.0)) or 1.0 for one in system.places().values()]
    inner = msgspec.structs.replace(inner, B=inner.B / np.repeat(sizes, list(system.disturbances.values())))
    problem = decay_inequalities(inner, decay * t).number("size")
    problem.above("size - P", lambda v: v.size * np.eye(system.n) - v.P, strict=False)
    gains = {f"bound_{i}": t / size**2 for i, size in enumerate(sizes)}
    return Posed(
        problem,
        {"P": np.outer(x, x), **gains},
        lambda v: v.size + sum(getattr(v, name) for name in gains),
    )


def certified_decay(system: ErrorSystem, values: dict[str, Any], decay: float) -> DecayCertificate:
    """The certificate that matrices from any source are: P and bound_i of each disturbance, audited.

    Raises CertificateError naming the corner at which the inequality fails, ParameterError for a decay that
    is not above 0.
    """
    decay = positive("decay", decay)
    margins = decay_inequalities(system, decay).check(values)
    drives = {name: values[f"bound_{i}"] for i, name in enumerate(system.disturbances)}
    bound = proved_bound(values["P"], decay, drives, system.time)
    return DecayCertificate(values["P"], values, margins, bound, system, system.domain)


def h_infinity(a: FloatArray, b: FloatArray, c: FloatArray, time: str = "continuous") -> tuple[float, float]:
    """The H-infinity norm of C (s I - A)^-1 B and the frequency in rad/s (rad/step) where it is reached.

    Assumes that A is stable. A level above the norm leaves no imaginary eigenvalues; below it, the midpoints
    between them are frequencies at which the gain is larger. In discrete time z = (1 + s) / (1 - s) keeps the
    norm.

    Reference: Bruinsma and Steinbuch 1990, A fast algorithm to compute the H-infinity norm.

    >>> norm, frequency = h_infinity(np.array([[-2.0]]), np.eye(1), np.eye(1))
    >>> round(norm, 9), frequency
    (0.5, 0.0)
    """
    d = np.zeros((len(c), b.shape[1]))
    if time == "discrete":
        inverse = np.linalg.inv(np.eye(len(a)) + a)
        a, b, c, d = (
            inverse @ (a - np.eye(len(a))),
            np.sqrt(2.0) * inverse @ b,
            np.sqrt(2.0) * c @ inverse,
            -c @ inverse @ b,
        )
    values = np.linalg.eigvals(a)
    # The largest gain at rest, at infinity and near each eigenvalue.
    tried = [(_gain(a, b, c, d, w), float(w)) for w in (0.0, *np.abs(values), *np.abs(values.imag))]
    level, at = max([*tried, (float(np.linalg.norm(d, 2)), np.inf)], key=lambda one: one[0])
    for _ in range(STEPS_MOST):
        crossings = _crossings(a, b, c, d, (1.0 + TOLERANCE) * level)
        if not len(crossings):
            break
        between = [0.5 * crossings[0], *np.sqrt(crossings[:-1] * crossings[1:]), 2.0 * crossings[-1]]
        tried = [(_gain(a, b, c, d, w), float(w)) for w in between]
        best = max(tried)
        if best[0] <= level:
            break
        level, at = best
    return level, 2.0 * float(np.arctan(at)) if time == "discrete" else at


def _gain(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray, frequency: float) -> float:
    inside = np.linalg.solve(1j * frequency * np.eye(len(a)) - a, b)
    return float(np.linalg.norm(c @ inside + d, 2))


def _crossings(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray, level: float) -> FloatArray:
    """The frequencies above 0 at which a singular value equals the level, in order."""
    r = level**2 * np.eye(d.shape[1]) - d.T @ d
    if np.linalg.eigvalsh(r)[0] <= 0.0:
        return np.zeros(0)
    s = np.linalg.solve(r, np.hstack([d.T @ c, b.T]))
    n = len(a)
    inner = a + b @ s[:, :n]
    across = b @ s[:, n:]
    down = -c.T @ c - c.T @ d @ s[:, :n]
    values = np.linalg.eigvals(np.block([[inner, across], [down, -inner.T]]))
    size = float(np.abs(values).max(initial=1.0))
    on_axis = np.abs(values.real) <= 1e-8 * np.maximum(np.abs(values), 1e-4 * size)
    return np.asarray(np.sort(values.imag[on_axis & (values.imag > 0.0)]), np.float64)


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

    def block(a: FloatArray, b: FloatArray, v: Any) -> FloatArray:
        square = v.square if gain is None else gain**2
        own = energy - v.P if system.time == "discrete" else energy
        return dissipation(a, b, v.P, own, -square * np.eye(b.shape[1]), system.time)

    for name, a, b in zip(system.names, system.A, system.B, strict=True):
        problem.below(f"the gain{f' at {name}' if name else ''}", partial(block, a, b))
    return problem


def l2_gain(system: ErrorSystem) -> L2Gain:
    """The L2 gain from the disturbances to z, from below and from above.

    Assumes one P for all corners: with several, ``upper`` may lie above the true gain. The gain is that of
    the Euclidean norms of delta and z in the units of the matrices; ``disturbed_by`` and ``seen_as`` choose
    others.

    Raises InfeasibleError naming an eigenvalue that does not decay; UndecidedError and CertificateError from
    the solver.

    Reference: Boyd, El Ghaoui, Feron, Balakrishnan 1994, section 6.3.2.

    >>> from pointpred_observers.proofs.error_system import sloped_system
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
