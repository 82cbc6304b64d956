"""The steady-state map x = Pi w of a plant and its generator: Proposition 3.2.1 and Corollary 3.2.1."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import combinations, islice
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.numerics.equalities import (
    TOLERANCE,
    column_units,
    nearest_solutions,
    row_rounding,
    share_of_terms,
)
from pointpred_observers.numerics.matrices import instance, matrix, moments, share
from pointpred_observers.plants.generator import Generator, fitted
from pointpred_observers.plants.linear_systems import Plant, as_plant

SHARED = "H Pi - J"
"""The equality of the arguments of f."""

EXACT = 1e-15
"""Relative change at which a solution is refined no further."""
SUBSPACES_MOST = 5000
"""At most so many invariant subspaces are tried, those of the first eigenvalues."""


def invariant_graphs(a0: FloatArray, s0: FloatArray, k: FloatArray, r: FloatArray) -> list[FloatArray]:
    """Every isolated solution if the eigenvalues of ((s0, r), (k, a0)) differ, else some of them.

    A Pi is a solution exactly if the columns of (I; Pi) span an invariant subspace.
    """
    q = len(s0)
    whole = np.block([[s0, r], [k, a0]])
    values, vectors = np.linalg.eig(whole)
    graphs = []
    for chosen in _real_choices(values, q):
        basis = vectors[:, list(chosen)]
        if np.linalg.cond(basis[:q]) > 1e10:
            continue
        pi = basis[q:] @ np.linalg.inv(basis[:q])
        graphs.append(np.ascontiguousarray(pi.real))
    return graphs


def _real_choices(values: FloatArray, q: int) -> Iterator[tuple[int, ...]]:
    """Choices of q eigenvalues in which each complex one comes with its conjugate."""
    for chosen in islice(combinations(range(len(values)), q), SUBSPACES_MOST):
        upper = sorted((values[i].real, values[i].imag) for i in chosen if values[i].imag > 0.0)
        lower = sorted((values[i].real, -values[i].imag) for i in chosen if values[i].imag < 0.0)
        if len(upper) == len(lower) and np.allclose(upper, lower, rtol=1e-9, atol=0.0):
            yield chosen


class SteadyState(msgspec.Struct, frozen=True):
    """A steady-state map: ``Pi`` (n, q), ``J`` = H Pi, the largest ``residuals`` by equality.

    If Pi is not unique, ``basis`` holds the ``nullity`` directions that keep every equality (to first order
    for a Riccati equation), shape (nullity, n, q). ``others`` are the further isolated solutions of a Riccati
    equation; Pi is the one from which the plant's error decays fastest.
    """

    Pi: FloatArray
    J: FloatArray
    residuals: dict[str, float]
    nullity: int
    basis: FloatArray
    others: tuple[FloatArray, ...] = ()


def residuals(
    plant: Plant,
    generator: Generator,
    Pi: Any,
    *,
    relaxed: bool = False,
) -> dict[str, FloatArray]:
    """Residual of each equality for a Pi: of (3.3) and J = H Pi, or of Corollary 3.2.1.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0])
    >>> generator = Generator([[0.0]], L0=[2.0])
    >>> {name: one.tolist() for name, one in residuals(plant, generator, [[2.0]]).items()}
    {'A0 Pi - Pi G C0 Pi - Pi S0 + B L0': [[0.0]]}
    """
    return _equalities(plant, generator, Pi, relaxed, lambda one: one, -1.0)


def relative_residuals(
    plant: Plant, generator: Generator, Pi: Any, *, relaxed: bool = False
) -> dict[str, tuple[float, float]]:
    """The largest residual of each equality, and the largest share that an entry has of its own terms.

    The share does not depend on the units of states, inputs, outputs and time: 1 where an entry fails
    completely, however large those of other rows, columns and equalities are.
    """
    left = residuals(plant, generator, Pi, relaxed=relaxed)
    terms = equality_terms(plant, generator, Pi, relaxed=relaxed)
    # Rows of the plant's states go through all equalities but that of J: they show together what is rounding.
    states = [name for name in terms if name != SHARED]
    wide = row_rounding(np.hstack([terms[name] for name in states]))
    ends = np.cumsum([terms[name].shape[1] for name in states])[:-1]
    rounding = dict(zip(states, np.split(wide, ends, axis=1), strict=True))
    # The columns of J belong to the generator's states, whose units the first equality shows.
    units = {SHARED: column_units(terms[states[0]])}
    return {
        name: (
            float(np.abs(one).max()),
            share_of_terms(one, terms[name], units.get(name), rounding=rounding.get(name)),
        )
        for name, one in left.items()
    }


def equality_terms(
    plant: Plant, generator: Generator, Pi: Any, *, relaxed: bool = False
) -> dict[str, FloatArray]:
    """The sizes of each equality's terms before they cancel, in the shapes of ``residuals``."""
    return _equalities(plant, generator, Pi, relaxed, np.abs, 1.0)


def _equalities(
    plant: Plant, generator: Generator, Pi: Any, relaxed: bool, part: Any, minus: float
) -> dict[str, FloatArray]:
    """The left side of each equality, of the ``part`` of each matrix; ``minus`` is the sign within it."""
    plant = as_plant(plant)
    g = fitted(generator, plant)
    pi = part(matrix("Pi", Pi, plant.n, g.q))
    a0, a1, b, q, c0, c1, h = (
        part(one) for one in (plant.A0, plant.A1, plant.B, plant.Q, plant.C0, plant.C1, plant.H)
    )
    s0, s1, gain, l0, l1, e = (part(one) for one in (g.S0, g.S1, g.G, g.L0, g.L1, g.E))
    linear = a0 @ pi + minus * (pi @ gain @ c0 @ pi) + minus * (pi @ s0) + b @ l0
    if relaxed:
        nonlinear = {
            "A1 - Pi G C1": a1 + minus * (pi @ gain @ c1),
            "B L1 - Pi S1": b @ l1 + minus * (pi @ s1),
        }
    else:
        nonlinear = {"A1 + B L1 - Pi (S1 + G C1)": a1 + b @ l1 + minus * (pi @ (s1 + gain @ c1))}
        if generator.J is not None:
            j = part(matrix("J", generator.J, plant.r, g.q))
            nonlinear[SHARED] = h @ pi + minus * j
    left = {"A0 Pi - Pi G C0 Pi - Pi S0 + B L0": linear, **nonlinear, "Q - Pi E": q + minus * (pi @ e)}
    return {name: one for name, one in left.items() if one.size}


def steady_state_map(
    plant: Plant,
    generator: Generator,
    *,
    relaxed: bool = False,
    times: Sequence[float] | None = None,
    tolerance: float = TOLERANCE,
) -> SteadyState:
    """Pi such that x = Pi w is a solution of plant and generator without disturbances.

    Assumes nothing about stability: Pi w need not attract x. For a plant whose matrices vary, Pi is constant
    and satisfies the equalities at each of ``times``, which are then required. With G C0 = 0 the equalities
    are linear and solved by least squares; otherwise the first equality is a Riccati equation, whose isolated
    solutions are found as graphs of invariant subspaces of ((S0, G C0), (B L0, A0)).

    (A0 - Pi G C0) Pi - Pi S0 + B L0 = 0, A1 + B L1 - Pi (S1 + G C1) = 0, Q = Pi E, J = H Pi;
    ``relaxed``: A1 = Pi G C1 and B L1 = Pi S1 instead of the second, and nothing about J.

    Parameters: ``tolerance`` of a residual, (0, 1), relative to its own terms, for matrices rounded in
    print; ``times`` in s (indices in discrete time). Raises InfeasibleError naming the
    violated equality and its residual, ParameterError, UndecidedError where a Riccati equation has no
    isolated solution that satisfies the rest.

    Reference: Khalin 2022, Proposition 3.2.1, Corollary 3.2.1; Lancaster and Rodman 1995, chapter 7.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0])
    >>> steady_state_map(plant, Generator([[0.0]], L0=[2.0])).Pi.tolist()
    [[2.0]]
    >>> steady_state_map(plant, Generator([[-1.0]], L0=[2.0]))  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: A0 Pi - Pi G C0 Pi - Pi S0 + B L0 = 0 cannot hold: ... residual is 2
    """
    plant, tolerance = as_plant(plant), share("tolerance", tolerance)
    instance("generator", generator, Generator)
    if generator.f is not None and not relaxed:
        raise ParameterError(
            "a generator with an f of its own needs relaxed=True, as J = H Pi says nothing then"
        )
    varying = f"the plant ({', '.join(plant.varying)})" if plant.varying else ""
    plants = [plant.at(t) for t in moments(varying, times, "to hold")]
    g = generator.beside(plants[0])

    def left(pi: FloatArray) -> dict[str, list[FloatArray]]:
        each = [residuals(one, generator, pi, relaxed=relaxed) for one in plants]
        return {name: [one[name] for one in each] for name in each[0]}

    def stacked(numbers: FloatArray) -> FloatArray:
        parts = left(numbers.reshape(plant.n, g.q)).values()
        return np.concatenate([one.ravel() for part in parts for one in part])

    linear = not any((g.G @ one.C0).any() for one in plants)
    if linear:
        slope = _jacobian(stacked, np.zeros(plant.n * g.q))
        candidates = list(nearest_solutions(stacked, slope))
    else:
        started = invariant_graphs(plants[0].A0, g.S0, plants[0].B @ g.L0, g.G @ plants[0].C0)
        candidates = [_refined(stacked, one.ravel()) for one in [*started, np.zeros((plant.n, g.q))]]

    def shares_left(pi: FloatArray) -> dict[str, float]:
        each = [relative_residuals(one, generator, pi, relaxed=relaxed) for one in plants]
        return {name: float(np.max([one[name][1] for one in each])) for name in each[0]}

    shape = plant.n, g.q
    solved = [
        one
        for one in candidates
        if all(part <= tolerance for part in shares_left(one.reshape(shape)).values())
    ]
    if not solved:
        if linear:
            _name_first(left, shares_left, shape, tolerance)
        _refuse(left, [one.reshape(shape) for one in candidates])
    distinct = _distinct([one.reshape(plant.n, g.q) for one in solved])
    distinct.sort(key=lambda pi: _abscissa(plants[0].A0 - pi @ g.G @ plants[0].C0, plant.time))
    pi = distinct[0]
    basis = _null(slope if linear else _jacobian(stacked, pi.ravel())).reshape(-1, plant.n, g.q)
    worst = {name: _largest(parts) for name, parts in left(pi).items()}
    return SteadyState(pi, plants[0].H @ pi, worst, len(basis), basis, tuple(distinct[1:]))


def _refined(stacked: Any, start: FloatArray) -> FloatArray:
    """The nearest point where every equality holds, or nearly."""
    from scipy.optimize import least_squares

    close: Any = {"xtol": EXACT, "ftol": EXACT, "gtol": EXACT}
    found = least_squares(stacked, start, partial(_jacobian, stacked), x_scale="jac", **close)
    return np.asarray(found.x, np.float64)


def _jacobian(stacked: Any, numbers: FloatArray) -> FloatArray:
    """The derivative by central differences, which are exact for quadratic equalities."""
    steps = np.eye(len(numbers))
    columns = [0.5 * (stacked(numbers + step) - stacked(numbers - step)) for step in steps]
    return np.array(columns).T


def _null(jacobian: FloatArray) -> FloatArray:
    _, sizes, rows = np.linalg.svd(jacobian, full_matrices=len(jacobian) < jacobian.shape[1])
    rank = int((sizes > 1e-9 * sizes.max(initial=0.0)).sum())
    basis: FloatArray = np.asarray(rows[rank:], np.float64)
    return basis


def _abscissa(a: FloatArray, time: str) -> float:
    eigenvalues = np.linalg.eigvals(a)
    return float(np.abs(eigenvalues).max() if time == "discrete" else eigenvalues.real.max())


def _distinct(maps: list[FloatArray]) -> list[FloatArray]:
    distinct: list[FloatArray] = []
    for one in maps:
        if all(np.abs(one - other).max() > 1e-6 * max(1.0, np.abs(one).max()) for other in distinct):
            distinct.append(one)
    return distinct


def _refuse(left: Any, candidates: list[FloatArray]) -> None:
    worst = min(
        ({name: _largest(parts) for name, parts in left(one).items()} for one in candidates),
        key=lambda norms: max(norms.values()),
    )
    name = max(worst, key=lambda one: worst[one])
    raise UndecidedError(
        f"no solution of the Riccati equation was found that satisfies the other equalities: {name} keeps a "
        f"residual of {worst[name]:.6g}"
    )


def _name_first(left: Any, shares_left: Any, shape: tuple[int, int], tolerance: float) -> None:
    """Raise InfeasibleError for the first equality that cannot hold together with those before it."""
    names, zero = list(left(np.zeros(shape))), np.zeros(shape[0] * shape[1])
    for count in range(1, len(names) + 1):

        def some(numbers: FloatArray, first: list[str] = names[:count]) -> FloatArray:
            errors = left(numbers.reshape(shape))
            return np.concatenate([one.ravel() for name in first for one in errors[name]])

        nearest = nearest_solutions(some, _jacobian(some, zero))
        each = [shares_left(one.reshape(shape)) for one in nearest]
        held = any(all(one[name] <= tolerance for name in names[:count]) for one in each)
        if not held or count == len(names):
            residual = min(float(np.abs(some(one)).max()) for one in nearest)
            beside = f" beside {', '.join(names[: count - 1])}" if count > 1 else ""
            reason = f"{names[count - 1]} = 0 cannot hold{beside}"
            raise InfeasibleError(f"{reason}: the least residual is {residual:.6g}")


def _largest(parts: list[FloatArray]) -> float:
    return max(float(np.abs(one).max()) for one in parts)
