"""Steady states x = Pi w of a plant and its generator, and the input that holds the plant there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import combinations, islice
from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.numerics.eigenvalues import number_text
from pointpred_observers.numerics.equalities import (
    TOLERANCE,
    Equalities,
    column_units,
    jacobian,
    largest,
    nearest_solutions,
    or_one,
    row_rounding,
    share_of_terms,
    stacked,
    summed,
)
from pointpred_observers.numerics.matrices import flag, instance, listed, matrix, moments, share, wrong
from pointpred_observers.plants.generator import Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant, constant
from pointpred_observers.plants.persidskii import Persidskii

SHARED = "H Pi - J"
"""The equality of the arguments of f."""

EXACT = 1e-15
"""Relative change at which a solution is refined no further."""
SUBSPACES_MOST = 5000
"""At most so many invariant subspaces are tried, those of the first eigenvalues."""


class SteadyState(msgspec.Struct, frozen=True):
    """A steady-state map: ``Pi`` (n, q), ``J`` = H Pi, the largest ``residuals`` by equality.

    ``basis`` (nullity, n, q) holds the ``nullity`` directions that keep every equality (to first order for a
    Riccati equation). ``others`` are the further isolated solutions of a Riccati equation; with Pi the
    plant's error decays fastest.
    """

    Pi: FloatArray
    J: FloatArray
    residuals: dict[str, float]
    nullity: int
    basis: FloatArray
    others: tuple[FloatArray, ...] = ()


def equalities(plant: Plant, generator: Generator, Pi: Any, *, relaxed: bool = False) -> Equalities:
    """The equalities of (3.3) and J = H Pi for a Pi, or those of Corollary 3.2.1."""
    plant = as_plant(plant)
    g = fitted(generator, plant)
    pi = matrix("Pi", Pi, plant.n, g.q)
    found = {
        "A0 Pi - Pi G C0 Pi - Pi S0 + B L0": summed(
            (plant.A0, pi), (-pi, g.G, plant.C0, pi), (-pi, g.S0), (plant.B, g.L0)
        )
    }
    if flag("relaxed", relaxed):
        found["A1 - Pi G C1"] = summed((plant.A1,), (-pi, g.G, plant.C1))
        found["B L1 - Pi S1"] = summed((plant.B, g.L1), (-pi, g.S1))
    else:
        found["A1 + B L1 - Pi (S1 + G C1)"] = summed(
            (plant.A1,), (plant.B, g.L1), (-pi, g.S1), (-pi, g.G, plant.C1)
        )
        if generator.J is not None:
            found[SHARED] = summed((plant.H, pi), (-matrix("J", generator.J, plant.r, g.q),))
    found["Q - Pi E"] = summed((plant.Q,), (-pi, g.E))
    return {name: one for name, one in found.items() if one[0].size}


def residuals(plant: Plant, generator: Generator, Pi: Any, *, relaxed: bool = False) -> dict[str, FloatArray]:
    """Residual of each equality for a Pi: of (3.3) and J = H Pi, or of Corollary 3.2.1.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0])
    >>> generator = Generator([[0.0]], L0=[2.0])
    >>> {name: one.tolist() for name, one in residuals(plant, generator, [[2.0]]).items()}
    {'A0 Pi - Pi G C0 Pi - Pi S0 + B L0': [[0.0]]}
    """
    return {name: left for name, (left, _) in equalities(plant, generator, Pi, relaxed=relaxed).items()}


def shares_left(found: Equalities) -> dict[str, float]:
    """The largest share that an entry of each of these ``equalities`` has of its own terms, in any units."""
    # Rows of the plant's states go through all equalities but that of J, and show together what is rounding.
    states = [name for name in found if name != SHARED]
    wide = row_rounding(np.hstack([found[name][1] for name in states]))
    ends = np.cumsum([found[name][1].shape[1] for name in states])[:-1]
    rounding = dict(zip(states, np.split(wide, ends, axis=1), strict=True))
    # The columns of J belong to the generator's states, whose units the first equality shows.
    units = {SHARED: column_units(found[states[0]][1])}
    return {
        name: share_of_terms(left, terms, units.get(name), rounding=rounding.get(name))
        for name, (left, terms) in found.items()
    }


def steady_state_map(
    plant: Plant,
    generator: Generator,
    *,
    relaxed: bool = False,
    times: Sequence[float] | None = None,
    tolerance: float = TOLERANCE,
) -> SteadyState:
    """Pi such that x = Pi w is a solution of plant and generator without disturbances.

    Assumes nothing about stability: Pi w need not attract x. With G C0 = 0 the equalities are linear and
    solved by least squares; otherwise the first is a Riccati equation, whose isolated solutions are found as
    graphs of invariant subspaces of ((S0, G C0), (B L0, A0)).

    (A0 - Pi G C0) Pi - Pi S0 + B L0 = 0, A1 + B L1 - Pi (S1 + G C1) = 0, Q = Pi E, J = H Pi;
    ``relaxed``: A1 = Pi G C1 and B L1 = Pi S1 instead of the second, and nothing about J.

    Parameters: ``tolerance`` of a residual, (0, 1), relative to its own terms, for matrices rounded in
    print; ``times`` in s (indices in discrete time) at which a constant Pi has to satisfy the equalities of
    a plant that varies. Raises InfeasibleError naming the violated equality and its residual, ParameterError,
    UndecidedError where a Riccati equation has no isolated solution that satisfies the rest.

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
    if generator.f is not None and not flag("relaxed", relaxed):
        raise ParameterError(
            "a generator with an f of its own needs relaxed=True: J = H Pi says nothing then"
        )
    varying = f"the plant ({', '.join(plant.varying)})" if plant.varying else ""
    plants = [plant.at(t) for t in moments(varying, times, "to hold")]
    g = generator.beside(plants[0])

    def left(numbers: FloatArray) -> Equalities:
        each = [equalities(one, generator, numbers.reshape(shape), relaxed=relaxed) for one in plants]
        parts = {name: zip(*(one[name] for one in each), strict=True) for name in each[0]}
        return {name: (np.vstack(errors), np.vstack(terms)) for name, (errors, terms) in parts.items()}

    def every(numbers: FloatArray) -> FloatArray:
        return stacked(left(numbers))

    shape, count = (plant.n, g.q), plant.n * g.q
    linear = not any((g.G @ one.C0).any() for one in plants)
    if linear:
        candidates = nearest_solutions(every, count)
    else:
        started = _invariant_graphs(plants[0].A0, g.S0, plants[0].B @ g.L0, g.G @ plants[0].C0)
        candidates = [_refined(every, one.ravel()) for one in [*started, np.zeros(shape)]]
    solved = [one for one in candidates if all(part <= tolerance for part in shares_left(left(one)).values())]
    if not solved and linear:
        _name_first(left, count, tolerance)
    if not solved:
        worst = min((largest(left(one)) for one in candidates), key=lambda each: max(each.values()))
        name = max(worst, key=lambda one: worst[one])
        raise UndecidedError(
            f"no solution of the Riccati equation was found that satisfies the other equalities: {name} "
            f"keeps a residual of {worst[name]:.6g}"
        )
    distinct: list[FloatArray] = []
    for one in (numbers.reshape(shape) for numbers in solved):
        if all(np.abs(one - other).max() > 1e-6 * max(1.0, np.abs(one).max()) for other in distinct):
            distinct.append(one)
    size = np.abs if plant.time == "discrete" else np.real
    distinct.sort(key=lambda pi: size(np.linalg.eigvals(plants[0].A0 - pi @ g.G @ plants[0].C0)).max())
    pi, *others = distinct
    _, sizes, rows = np.linalg.svd(jacobian(every, np.zeros(count) if linear else pi.ravel()))
    basis = rows[int((sizes > 1e-9 * sizes.max(initial=0.0)).sum()) :].reshape(-1, *shape)
    return SteadyState(pi, plants[0].H @ pi, largest(left(pi.ravel())), len(basis), basis, tuple(others))


def _invariant_graphs(a0: FloatArray, s0: FloatArray, k: FloatArray, r: FloatArray) -> list[FloatArray]:
    """Every isolated solution if the eigenvalues of ((s0, r), (k, a0)) differ, else some of them.

    A Pi is a solution exactly if the columns of (I; Pi) span an invariant subspace. Each complex eigenvalue
    comes with its conjugate.
    """
    q, graphs = len(s0), []
    values, vectors = np.linalg.eig(np.block([[s0, r], [k, a0]]))
    for chosen in islice(combinations(range(len(values)), q), SUBSPACES_MOST):
        upper = sorted((values[i].real, values[i].imag) for i in chosen if values[i].imag > 0.0)
        lower = sorted((values[i].real, -values[i].imag) for i in chosen if values[i].imag < 0.0)
        basis = vectors[:, list(chosen)]
        if len(upper) != len(lower) or not np.allclose(upper, lower, rtol=1e-9, atol=0.0):
            continue
        if np.linalg.cond(basis[:q]) <= 1e10:
            graphs.append(np.ascontiguousarray((basis[q:] @ np.linalg.inv(basis[:q])).real))
    return graphs


def _refined(residuals: Callable[[FloatArray], FloatArray], start: FloatArray) -> FloatArray:
    """The nearest point where every equality holds, or nearly."""
    from scipy.optimize import least_squares

    close: Any = {"xtol": EXACT, "ftol": EXACT, "gtol": EXACT}
    found = least_squares(residuals, start, partial(jacobian, residuals), x_scale="jac", **close)
    return np.asarray(found.x, np.float64)


def _name_first(left: Callable[[FloatArray], Equalities], count: int, tolerance: float) -> None:
    """Raise InfeasibleError for the first equality that cannot hold together with those before it."""
    names = list(left(np.zeros(count)))
    for last, name in enumerate(names):
        first = names[: last + 1]

        def some(numbers: FloatArray, first: list[str] = first) -> FloatArray:
            found = left(numbers)
            return stacked({one: found[one] for one in first})

        nearest = nearest_solutions(some, count)
        each = [shares_left(left(one)) for one in nearest]
        if name == names[-1] or not any(all(one[held] <= tolerance for held in first) for one in each):
            residual = min(float(np.abs(some(one)).max()) for one in nearest)
            beside = f" beside {', '.join(first[:-1])}" if last else ""
            raise InfeasibleError(f"{name} = 0 cannot hold{beside}: the least residual is {residual:.6g}")


class RegulatorEquations(msgspec.Struct, frozen=True):
    """Pi, L0 and L1 such that x = Pi w solves the plant under u = L0 w + L1 f(H Pi w), and R Pi = F.

    ``R`` and ``F`` are zero where nothing is to be followed. ``residuals`` by equality; ``nullity``: how many
    independent directions of (Pi, L0, L1) change no equality.
    """

    Pi: FloatArray
    L0: FloatArray
    L1: FloatArray
    residuals: dict[str, float]
    nullity: int
    R: FloatArray
    F: FloatArray


def regulator_equations(
    plant: Plant,
    generator: Generator,
    *,
    following: tuple[Any, Any] | None = None,
    tolerance: float = TOLERANCE,
) -> RegulatorEquations:
    """Solve (3.3) for the input: the map Pi and the gains with which the plant can follow a generator.

    A0 Pi + B L0 = Pi S0, A1 + B L1 = Pi S1 and, with ``following`` = (R, F), R Pi = F: the combinations R x
    of the states follow F w. The solution of least norm where there are several.

    Assumes a generator without G (its L0 and L1 are not used) and constant matrices.

    Parameters: ``following`` R (any, n) and F (as many, q); ``tolerance`` of a residual, (0, 1), relative to
    its own terms. Raises InfeasibleError naming the equality that cannot hold and, where it is one, the zero
    of the plant from the input to R x that equals an eigenvalue of S0; ParameterError.

    Reference: Khalin 2022, (3.3) with G = 0; Francis and Wonham 1976.

    >>> plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", [0.0, 2.0], None, [1.0, 0.0])
    >>> circle = Generator([[0.0, 3.0], [-3.0, 0.0]])
    >>> found = regulator_equations(plant, circle, following=([[1.0, 0.0]], [[1.0, 0.0]]))
    >>> (found.Pi.round(9) + 0.0).tolist(), found.L0.round(9).tolist()
    ([[1.0, 0.0], [0.0, 3.0]], [[-4.5, 1.5]])
    """
    one = constant(plant, "the input of a steady state")
    g = fitted(generator, one)
    require_same_nonlinearity(one, generator)
    if g.G.any():
        raise ParameterError("the regulator equations need a generator without G")
    tolerance = share("tolerance", tolerance)
    if following is None:
        following = [[0.0] * one.n], [[0.0] * g.q]
    pair = listed("following", following)
    if len(pair) != 2:
        raise wrong("following", "must be (R, F) with R x to follow F w", following)
    rows = matrix("R", pair[0], None, one.n)
    problem = _Regulation(one, g.S0, g.S1, rows, matrix("F", pair[1], len(rows), g.q))
    nearest = nearest_solutions(lambda numbers: stacked(problem.left(numbers)), problem.count)
    for numbers in nearest:
        if problem.failing(numbers, tolerance) is None:
            return problem.solved(numbers)
    name = problem.failing(nearest[0], tolerance) or ""
    raise InfeasibleError(
        "the regulator equations cannot hold: the least residual leaves "
        f"{largest(problem.left(nearest[0]))[name]:.6g} in {name}"
        f"{_zeros(one, g.S0, rows) if rows.any() else ''}"
    )


def checked_equations(
    plant: Persidskii, S0: FloatArray, Pi: Any, L0: Any, L1: Any, R: Any, F: Any
) -> RegulatorEquations:
    """The equations of given matrices, such as those of a file, for a generator w' = S0 w + E rho.

    Raises CertificateError naming an equality that does not hold to ``TOLERANCE`` of its own terms.
    """
    q = len(S0)
    rows = matrix("R", R, None, plant.n)
    problem = _Regulation(plant, S0, np.zeros((q, plant.k)), rows, matrix("F", F, len(rows), q))
    given = matrix("Pi", Pi, plant.n, q), matrix("L0", L0, plant.m, q), matrix("L1", L1, plant.m, plant.k)
    numbers = np.concatenate([one.ravel() for one in given])
    name = problem.failing(numbers, TOLERANCE)
    if name is not None:
        raise CertificateError(
            f"the regulator equations do not hold: {largest(problem.left(numbers))[name]:.6g} is left in "
            f"{name}; design the regulator again",
            field=name,
        )
    return problem.solved(numbers)


class _Regulation(msgspec.Struct, frozen=True):
    """The equalities for a plant, S0, S1, R and F, of the numbers of Pi, L0 and L1."""

    plant: Persidskii
    s0: FloatArray
    s1: FloatArray
    rows: FloatArray
    wanted: FloatArray

    @property
    def count(self) -> int:
        """How many numbers there are."""
        return int((self.plant.n + self.plant.m) * len(self.s0) + self.plant.m * self.plant.k)

    def split(self, numbers: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Pi, L0 and L1."""
        n, m, q = self.plant.n, self.plant.m, len(self.s0)
        both, l1 = np.split(numbers, [(n + m) * q])
        return both[: n * q].reshape(n, q), both[n * q :].reshape(m, q), l1.reshape(m, self.plant.k)

    def left(self, numbers: FloatArray) -> Equalities:
        """The equalities at these numbers."""
        pi, l0, l1 = self.split(numbers)
        return {
            "A0 Pi + B L0 - Pi S0": summed((self.plant.A0, pi), (self.plant.B, l0), (-pi, self.s0)),
            "A1 + B L1 - Pi S1": summed((self.plant.A1,), (self.plant.B, l1), (-pi, self.s1)),
            "R Pi - F": summed((self.rows, pi), (-self.wanted,)),
        }

    def failing(self, numbers: FloatArray, tolerance: float) -> str | None:
        """The equality that fails most, if one leaves more than this share of its own terms."""
        shares = {name: share_of_terms(*one) for name, one in self.left(numbers).items()}
        failed = [name for name, part in shares.items() if not part <= tolerance]
        return max(failed, key=lambda name: shares[name]) if failed else None

    def solved(self, numbers: FloatArray) -> RegulatorEquations:
        """The matrices of these numbers, with what they leave."""
        slope = jacobian(lambda one: stacked(self.left(one)), np.zeros(self.count))
        rank = int(np.linalg.matrix_rank(slope / or_one(np.abs(slope).max(axis=0, initial=0.0))))
        (pi, l0, l1), left = self.split(numbers), largest(self.left(numbers))
        return RegulatorEquations(pi, l0, l1, left, self.count - rank, self.rows, self.wanted)


def _zeros(plant: Persidskii, s0: FloatArray, rows: FloatArray) -> str:
    """Names an eigenvalue of S0 at which the plant does not let every R x through."""
    for value in np.linalg.eigvals(s0).astype(np.complex128):
        left = np.vstack([plant.A0 - value * np.eye(plant.n), rows])
        pencil = np.hstack([left, np.vstack([plant.B, np.zeros((len(rows), plant.m))])])
        sizes = np.linalg.svd(pencil, compute_uv=False)
        if len(sizes) < len(pencil) or sizes[-1] <= 1e-9 * sizes[0]:
            return (
                "; the plant has a zero from u to R x at the eigenvalue "
                f"{number_text(value)} of S0, or too few inputs"
            )
    return ""
