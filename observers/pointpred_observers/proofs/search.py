"""The search for the matrices of a design or a proof: posed, solved, brought to the user's units, audited.

A problem says its systems once, for ``balanced`` to choose units. It is posed in those units, and where that
is better or fails in the user's own; its answer counts only if it passes an audit in the user's units. A
search may begin at the P, gain and W of one equation of Riccati or Lyapunov, of which nothing is proved.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from contextlib import suppress
from types import SimpleNamespace
from typing import Any, TypeVar

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.numerics.balance import Coordinates
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.unknowns import Block

T = TypeVar("T")
Units = Mapping[str, Any]
"""What each matrix of the posed problem is divided by to be in the user's units."""
WORSE = float(np.log(10.0))
"""A design of balanced units is given up where one of the user's is smaller by this much."""
LITTLE = 0.1
"""The logarithm by which a size must be smaller in the user's units than in balanced ones to be taken."""
SHARES = (0.6, 0.4, 0.2, 0.05, 1e-2, 1e-3, 1e-4)
"""Fractions of the slowest corner's decay that are tried where none is required."""


class Posed(msgspec.Struct, frozen=True):
    """A problem in chosen units: what it minimises, where it may begin, and the ``units`` of its matrices.

    ``functions`` of the unknowns are matrices as well. Those without units are not part of the answer.
    """

    problem: MatrixInequalities
    units: Units
    minimise: Block | None = None
    near: Mapping[str, Any] | None = None
    functions: Mapping[str, Block] = {}


def search(
    units: Coordinates,
    posed: Callable[[Coordinates], Posed],
    audited: Callable[[dict[str, Any], float], T],
    size: Callable[[T], Any] | None = None,
    little: float = LITTLE,
) -> T:
    """What ``audited`` makes of the matrices that are found, in the user's units, and of their gap.

    Parameters: ``units`` from ``balanced``; ``audited`` raises CertificateError for matrices that prove
    nothing; ``size`` as for ``least_in_both``. Matrices of a minimum that fail the audit are sought once more
    with the largest margins. Raises InfeasibleError, UndecidedError, CertificateError.
    """
    failed: list[Coordinates] = []

    def attempt(one: Coordinates, *, least: bool = True) -> T:
        now = posed(one)
        found = now.problem.solve(minimise=now.minimise if least else None, near=now.near)
        v = SimpleNamespace(**found.values)
        matrices = {**found.values, **{name: function(v) for name, function in now.functions.items()}}
        try:
            outward = {name: matrices[name] / unit for name, unit in now.units.items() if name in matrices}
            return audited(outward, np.inf if found.gap is None else found.gap)
        except (CertificateError, InfeasibleError, np.linalg.LinAlgError) as failure:
            # An InfeasibleError is of an audit that searched a proof of these matrices: others may have one.
            if least and now.minimise is not None and not isinstance(failure, InfeasibleError):
                failed.append(one)
            # They passed in the units of the search: a CertificateError is for matrices of others.
            raise UndecidedError(
                f"{failure}; that is too close to the edge for the arithmetic, which proves nothing: require "
                "less decay, or measure more states"
            ) from failure

    try:
        return least_in_both(units, attempt, size, little)
    except (CertificateError, UndecidedError):
        # At a minimum little is left of the margins; the largest ones may outlast the rounding.
        for one in failed:
            with suppress(InfeasibleError, UndecidedError, CertificateError):
                return attempt(one, least=False)
        raise


def least_in_both(
    units: Coordinates,
    attempt: Callable[[Coordinates], T],
    size: Callable[[T], Any] | None = None,
    little: float = LITTLE,
) -> T:
    """What ``attempt`` finds in balanced units, or in the user's where that is smaller by ``little``.

    ``size`` is a logarithm, or several, all of which must be smaller; without it the user's units are tried
    only where the balanced ones fail. Where both fail it raises what ``attempt`` raised in balanced units,
    InfeasibleError only where both did, or where the user's units do not allow the problem to be posed.
    """
    found, failures = [], []
    for one in (units, units.plain):
        try:
            found.append(attempt(one))
        except (InfeasibleError, UndecidedError, CertificateError) as failure:
            failures.append(failure)
        except ParameterError:
            if one is units:
                raise
            # In the user's units the arithmetic may not even tell independent rows.
        if size is None and found:
            break
    if not found:
        if isinstance(failures[0], InfeasibleError) and not isinstance(failures[-1], InfeasibleError):
            raise failures[-1]  # what was proved in balanced units says little about the user's
        raise failures[0]
    if size is None or np.any(np.asarray(size(found[0])) <= np.asarray(size(found[-1])) + little):
        return found[0]
    return found[-1]


def at_decay(decay: float | None, slowest: float, time: str, attempt: Callable[[float], T]) -> T:
    """What ``attempt`` finds at ``decay``, or at the largest share of the slowest corner's that has any."""
    tried = [-share * slowest for share in SHARES] if decay is None else [decay]
    for one in tried:
        try:
            return attempt(one)
        except (InfeasibleError, UndecidedError) as failure:
            if one == tried[-1]:
                unit = "1/step" if time == "discrete" else "1/s"
                raise type(failure)(f"{failure}; with decay = {one:g} {unit}") from failure
    raise AssertionError


def filter_start(
    a: FloatArray, c: FloatArray, decay: float, time: str
) -> tuple[FloatArray, FloatArray] | None:
    """P >= I and U = P L of the stationary Kalman filter of e' = a e, y = c e, made to decay at ``decay``.

    The covariance of its noises is the unit matrix; the filter is that of a + ``decay`` I, or of
    exp(``decay``) a in discrete time. ``None`` where the equation has no solution or its solver fails.

    Reference: Anderson, Moore 1971, section 4.1, for the rate.
    """
    from scipy.linalg import solve_continuous_are, solve_discrete_are

    one, noise = np.eye(len(a)), np.eye(len(c))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what is ill-conditioned is audited later
        try:
            if time == "discrete":
                faster = np.exp(decay) * a
                x = solve_discrete_are(faster.T, c.T, one, noise)
                gain = np.exp(-decay) * faster @ x @ c.T @ np.linalg.inv(c @ x @ c.T + noise)
            else:
                x = solve_continuous_are((a + decay * one).T, c.T, one, noise)
                gain = x @ c.T
            p = normal(np.linalg.inv(x))
        except (np.linalg.LinAlgError, ValueError):
            return None
    return None if p is None else (p, p @ gain)


def decay_start(a: FloatArray, decay: float, time: str) -> FloatArray | None:
    """P >= I with which e' = a e decays at ``decay``; ``None`` where there is none."""
    from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

    one = np.eye(len(a))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what is ill-conditioned is audited later
        try:
            if time == "discrete":
                return normal(solve_discrete_lyapunov(np.exp(decay) * a.T, one))
            p = solve_continuous_lyapunov((a + decay * one).T, -one)
            return normal(np.asarray(p, np.float64))
        except (np.linalg.LinAlgError, ValueError):
            return None


def normal(p: FloatArray) -> FloatArray | None:
    """A matrix divided by its least eigenvalue; ``None`` unless that is positive."""
    symmetric: FloatArray = 0.5 * (p + p.T)
    least = float(np.linalg.eigvalsh(symmetric)[0]) if np.isfinite(symmetric).all() else -1.0
    return symmetric / least if least > 0.0 else None


def middle(slopes: tuple[tuple[float, float], ...] | None) -> FloatArray:
    """The middle of the slopes as a diagonal matrix."""
    return np.diag([0.5 * (low + high) for low, high in slopes or ()])


def cover(
    weight: FloatArray, inner: FloatArray, slopes: tuple[tuple[float, float], ...] | None
) -> FloatArray:
    """A W >= sym(F D J) for every D within the slopes, F the ``weight`` and J the ``inner`` matrix.

    The sum over the components of middle slope times M plus half the spread times abs(M), M = sym(F_i J_i).
    """
    whole: FloatArray = np.zeros((len(weight), len(weight)))
    for i, (low, high) in enumerate(slopes or ()):
        one = np.outer(weight[:, i], inner[i])
        values, vectors = np.linalg.eigh(0.5 * (one + one.T))
        sizes = 0.5 * (low + high) * values + 0.5 * (high - low) * np.abs(values)
        whole = whole + (vectors * sizes) @ vectors.T
    return 0.5 * (whole + whole.T)
