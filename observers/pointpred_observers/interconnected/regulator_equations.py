"""The regulator equations: the input under which a plant follows a generator."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.eigenvalues import number_text
from pointpred_observers.numerics.equalities import TOLERANCE, nearest_solutions, share_of_terms
from pointpred_observers.numerics.matrices import matrix, share
from pointpred_observers.plants.generator import Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant
from pointpred_observers.plants.persidskii import Persidskii


class RegulatorEquations(msgspec.Struct, frozen=True):
    """Pi, L0 and L1 such that x = Pi w solves the plant under u = L0 w + L1 f(H Pi w), and R Pi = F.

    ``R`` (any, n) and ``F`` (as many, q) are zero where nothing is to be followed. ``residuals`` by equality;
    ``nullity``: how many independent directions of (Pi, L0, L1) change no equality.
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
    of the states follow F w. The solution of least norm where there are several. What makes x approach Pi w
    is another question: see ``design_regulator``.

    Assumes a generator without G (its L0 and L1 are not used) and constant matrices.

    Parameters: ``following`` R (any, n) and F (as many, q); ``tolerance`` of a residual, (0, 1), relative to
    its own terms. Raises InfeasibleError naming the equality that cannot hold and, where
    it is one, the zero of the plant from the input to R x that equals an eigenvalue of S0; ParameterError.

    Reference: Khalin 2022, (3.3) with G = 0; Francis and Wonham 1976.

    >>> plant = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", [0.0, 2.0], None, [1.0, 0.0])
    >>> circle = Generator([[0.0, 3.0], [-3.0, 0.0]])
    >>> found = regulator_equations(plant, circle, following=([[1.0, 0.0]], [[1.0, 0.0]]))
    >>> (found.Pi.round(9) + 0.0).tolist(), found.L0.round(9).tolist()
    ([[1.0, 0.0], [0.0, 3.0]], [[-4.5, 1.5]])
    """
    one = as_plant(plant)
    if one.varying:
        raise ParameterError(f"the regulator equations need constant matrices; {', '.join(one.varying)} vary")
    g = fitted(generator, one)
    require_same_nonlinearity(one, generator)
    if g.G.any():
        raise ParameterError("the regulator equations need a generator without G, received one with G")
    tolerance = share("tolerance", tolerance)
    r, f = ([[0.0] * one.n], [[0.0] * g.q]) if following is None else _pair(following)
    rows, wanted = matrix("R", r, None, one.n), matrix("F", f, len(matrix("R", r, None, one.n)), g.q)
    problem = _Problem(one, g.S0, g.S1, rows, wanted)
    cleaned, raw = nearest_solutions(problem.stacked, problem.slope())
    name = problem.failing(cleaned, tolerance)
    if name is None:
        return problem.solved(cleaned)
    if problem.failing(raw, tolerance) is None:
        return problem.solved(raw)
    residual = problem.residuals(cleaned)[name]
    raise InfeasibleError(
        f"the regulator equations cannot hold: the least residual leaves {residual:.6g} in {name}"
        f"{_zeros(one, g.S0, None if following is None else rows)}"
    )


def checked_equations(
    plant: Persidskii, S0: FloatArray, Pi: Any, L0: Any, L1: Any, R: Any, F: Any
) -> RegulatorEquations:
    """The equations of given matrices, such as those of a file, for a generator w' = S0 w + E rho.

    Residuals and nullity are computed. Raises CertificateError naming an equality that does not hold to
    ``TOLERANCE`` of its own terms; ParameterError for a shape.
    """
    q = len(S0)
    rows = matrix("R", R, None, plant.n)
    problem = _Problem(plant, S0, np.zeros((q, plant.k)), rows, matrix("F", F, len(rows), q))
    given = (
        matrix("Pi", Pi, plant.n, q),
        matrix("L0", L0, plant.m, q),
        matrix("L1", L1, plant.m, plant.k),
    )
    numbers = np.concatenate([one.ravel() for one in given])
    name = problem.failing(numbers, TOLERANCE)
    if name is not None:
        raise CertificateError(
            f"the regulator equations do not hold: {problem.residuals(numbers)[name]:.6g} is left in {name}; "
            "design the regulator again",
            field=name,
        )
    return problem.solved(numbers)


class _Problem(msgspec.Struct, frozen=True):
    """The equalities for a plant, S0, S1, R and F, as functions of the numbers of Pi, L0 and L1."""

    plant: Persidskii
    s0: FloatArray
    s1: FloatArray
    rows: FloatArray
    wanted: FloatArray

    def split(self, numbers: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Pi, L0 and L1."""
        n, m, q, k = self.plant.n, self.plant.m, len(self.s0), self.plant.k
        pi, l0, l1 = np.split(numbers, [n * q, n * q + m * q])
        return pi.reshape(n, q), l0.reshape(m, q), l1.reshape(m, k)

    def left(self, numbers: FloatArray, part: Any = np.asarray, minus: float = -1.0) -> dict[str, FloatArray]:
        """The left side of each equality, of the ``part`` of each matrix; ``minus`` is the sign within it."""
        pi, l0, l1 = self.split(part(numbers))
        a0, a1, b = (part(one) for one in (self.plant.A0, self.plant.A1, self.plant.B))
        return {
            "A0 Pi + B L0 - Pi S0": a0 @ pi + b @ l0 + minus * (pi @ part(self.s0)),
            "A1 + B L1 - Pi S1": a1 + b @ l1 + minus * (pi @ part(self.s1)),
            "R Pi - F": part(self.rows) @ pi + minus * part(self.wanted),
        }

    def stacked(self, numbers: FloatArray) -> FloatArray:
        """Every residual."""
        return np.concatenate([one.ravel() for one in self.left(numbers).values()])

    def slope(self) -> FloatArray:
        """The derivative of the residuals."""
        count = (self.plant.n + self.plant.m) * len(self.s0) + self.plant.m * self.plant.k
        start = self.stacked(np.zeros(count))
        return np.array([self.stacked(unit) - start for unit in np.eye(count)]).T

    def residuals(self, numbers: FloatArray) -> dict[str, float]:
        """The largest residual of each equality."""
        return {name: float(np.abs(one).max(initial=0.0)) for name, one in self.left(numbers).items()}

    def failing(self, numbers: FloatArray, tolerance: float) -> str | None:
        """The equality that fails most, if one leaves more than this share of its own terms."""
        terms = self.left(numbers, np.abs, 1.0)
        shares = {name: share_of_terms(one, terms[name]) for name, one in self.left(numbers).items()}
        failed = [name for name, part in shares.items() if not part <= tolerance]
        return max(failed, key=lambda name: shares[name]) if failed else None

    def solved(self, numbers: FloatArray) -> RegulatorEquations:
        """The matrices of these numbers, with what they leave."""
        slope = self.slope()
        size = np.where(slope.any(axis=0), np.abs(slope).max(axis=0, initial=0.0), 1.0)
        rank = int(np.linalg.matrix_rank(slope / size))
        pi, l0, l1 = self.split(numbers)
        return RegulatorEquations(
            pi, l0, l1, self.residuals(numbers), len(numbers) - rank, self.rows, self.wanted
        )


def _pair(following: Any) -> tuple[Any, Any]:
    try:
        rows, wanted = following
    except (TypeError, ValueError) as unusable:
        raise ParameterError(
            f"following must be (R, F) with R x to follow F w, received {following!r}",
            field="following",
            value=following,
        ) from unusable
    return rows, wanted


def _zeros(plant: Persidskii, s0: FloatArray, rows: FloatArray | None) -> str:
    """Names an eigenvalue of S0 at which the plant does not let every R x through."""
    if rows is None:
        return ""
    for value in np.linalg.eigvals(s0).astype(np.complex128):
        pencil = np.block(
            [[plant.A0 - value * np.eye(plant.n), plant.B], [rows, np.zeros((len(rows), plant.m))]]
        )
        sizes = np.linalg.svd(pencil, compute_uv=False)
        if len(sizes) < len(pencil) or sizes[-1] <= 1e-9 * sizes[0]:
            eigenvalue = number_text(value)
            return (
                f"; the plant has a zero from u to R x at the eigenvalue {eigenvalue} of S0, "
                "or too few inputs"
            )
    return ""
