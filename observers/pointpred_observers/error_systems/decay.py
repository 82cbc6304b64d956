"""Proofs that an error decays, whatever the slopes: one quadratic function for all corners."""

from __future__ import annotations

from functools import partial
from math import exp, expm1, sqrt
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.balance import Coordinates, balanced, form, inward, least_in_both
from pointpred_observers.bounds import ErrorBound, eigenvalues
from pointpred_observers.error_systems.system import ErrorSystem
from pointpred_observers.inequalities.audit import answer_of_a_search
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.matrices import instance, positive

SHARES = (0.6, 0.4, 0.2, 0.05, 1e-2, 1e-3)
"""Fractions of the slowest corner's decay that are tried where none is required."""


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


def certify_decay(
    system: ErrorSystem,
    *,
    decay: float | None = None,
    domain: float = np.inf,
) -> DecayCertificate:
    """A certificate that the error decays, with small overshoot and gains.

    Assumes one P for all corners, which is conservative where there are several: a refusal does not say that
    some f keeps the error from decaying.

    Parameters: ``decay`` in 1/s (1/step), > 0, by default a fraction of the slowest corner's; ``domain`` > 0
    if the corners hold within a smaller one than the system's.
    Raises InfeasibleError naming an eigenvalue that does not decay before any solver runs;
    InfeasibleError, UndecidedError, CertificateError from the solver.

    >>> import numpy as np
    >>> from pointpred_observers.error_systems.system import sloped_system
    >>> system = sloped_system(
    ...     -2 * np.eye(1), np.eye(1), np.eye(1), {"d": np.eye(1)}, slopes=((0.0, 1.0),), time="continuous"
    ... )
    >>> found = certify_decay(system, decay=0.5)
    >>> round(found.bound.rate, 6), found.bound(0.0, 0.0, d=1.0) < 1.5, min(found.margins.values()) > 0.0
    (0.5, True, True)
    """
    if decay is not None:
        positive("decay", decay)
    if not is_number(domain) or not domain > 0.0:
        raise ParameterError(f"domain must lie above 0, received {domain!r}", field="domain", value=domain)
    slowest = instance("system", system, ErrorSystem).slowest()
    system = msgspec.structs.replace(system, domain=min(float(domain), system.domain))
    rates = [-share * slowest for share in SHARES] if decay is None else [decay]
    for rate in rates:
        try:
            return _certified(system, rate)
        except (InfeasibleError, UndecidedError) as failure:
            if rate == rates[-1]:
                unit = "1/step" if system.time == "discrete" else "1/s"
                raise type(failure)(f"{failure}; with decay = {rate:g} {unit}") from failure
    raise AssertionError


def _certified(system: ErrorSystem, decay: float) -> DecayCertificate:
    """The certificate of the smaller bound, from a problem in balanced units and from one in the user's."""
    units = balanced(system.A, driven=system.B, rates=(decay,), time=system.time)

    def size(one: DecayCertificate) -> float:
        return float(sum(np.log([one.bound.overshoot, *filter(None, one.bound.gains)])))

    return least_in_both(units, partial(_posed, system, decay), size)


def _posed(system: ErrorSystem, decay: float, units: Coordinates) -> DecayCertificate:
    """The certificate in the user's units, from a problem in these."""
    x, t = units.states, units.seconds
    one = np.ones(system.B.shape[2])
    a = np.array([inward(each, x, x, t) for each in system.A])
    b = np.array([inward(each, x, one, t) for each in system.B])
    sizes = [float(np.abs(b[:, :, one]).max(initial=0.0)) or 1.0 for one in system.places().values()]
    b = b / np.repeat(sizes, list(system.disturbances.values()))
    inner = msgspec.structs.replace(system, A=a, B=b)
    problem = decay_inequalities(inner, decay * t).number("size")
    problem.above("size - P", lambda v: v.size * np.eye(system.n) - v.P, strict=False)
    count = len(sizes)
    found = problem.solve(
        minimise=lambda v: v.size + sum(getattr(v, f"bound_{i}") for i in range(count))
    ).values
    values = {"P": form(found["P"], x)}
    for i, size in enumerate(sizes):
        values[f"bound_{i}"] = found[f"bound_{i}"] * size**2 / t
    with answer_of_a_search():
        return certified_decay(system, values, decay)


def certified_decay(system: ErrorSystem, values: dict[str, Any], decay: float) -> DecayCertificate:
    """The certificate that matrices from any source are: P and bound_i of each disturbance, audited.

    Raises CertificateError naming the corner at which the inequality fails, ParameterError for a decay that
    is not above 0.
    """
    decay = positive("decay", decay)
    margins = decay_inequalities(system, decay).check(values)
    p = eigenvalues("P", values["P"])
    loss = -expm1(-2.0 * decay) if system.time == "discrete" else 2.0 * decay
    gains = tuple(sqrt(values[f"bound_{i}"] / (loss * p[0])) for i in range(len(system.disturbances)))
    bound = ErrorBound(sqrt(p[-1] / p[0]), decay, gains, tuple(system.disturbances))
    return DecayCertificate(values["P"], values, margins, bound, system, system.domain)
