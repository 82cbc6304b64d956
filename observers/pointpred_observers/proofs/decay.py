"""Proofs that an error decays, whatever the slopes: one quadratic function for all corners."""

from __future__ import annotations

from functools import partial
from math import exp
from typing import Any

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates, balanced
from pointpred_observers.numerics.matrices import instance, positive
from pointpred_observers.proofs.bounds import ErrorBound, proved_bound
from pointpred_observers.proofs.error_system import ErrorSystem
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import Posed, at_decay, search


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

    def forces(v: Any) -> FloatArray:
        sizes = [np.full(width, getattr(v, f"bound_{i}")) for i, width in enumerate(widths)]
        return np.diag(np.concatenate(sizes))

    def continuous(a: FloatArray, b: FloatArray, v: Any) -> FloatArray:
        half = v.P @ (a + decay * np.eye(len(a)))
        return np.block([[half + half.T, v.P @ b], [(v.P @ b).T, -forces(v)]])

    def discrete(a: FloatArray, b: FloatArray, v: Any) -> FloatArray:
        onward = v.P @ np.hstack([a, b])
        n, m = b.shape
        before = np.block([[-exp(-2.0 * decay) * v.P, np.zeros((n, m))], [np.zeros((m, n)), -forces(v)]])
        return np.block([[before, onward.T], [onward, -v.P]])

    block = discrete if system.time == "discrete" else continuous
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
