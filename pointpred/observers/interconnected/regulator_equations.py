"""The regulator equations: the input under which a plant follows a generator."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import InfeasibleError, ParameterError
from pointpred.observers.eigenvalues import number_text
from pointpred.observers.interconnected.generator import Generator, fitted
from pointpred.observers.linear_systems import Plant, as_plant
from pointpred.observers.matrices import matrix, share
from pointpred.observers.persidskii import Persidskii

TOLERANCE = 1e-9


class RegulatorEquations(msgspec.Struct, frozen=True):
    """Pi, L0 and L1 such that x = Pi w solves the plant under u = L0 w + L1 f(H Pi w), and R Pi = F.

    ``residuals`` by equality; ``nullity``: how many independent directions of (Pi, L0, L1) change no
    equality.
    """

    Pi: FloatArray
    L0: FloatArray
    L1: FloatArray
    residuals: dict[str, float]
    nullity: int


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
    the largest of its terms. Raises InfeasibleError naming the equality that cannot hold and, where
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
    if g.G.any():
        raise ParameterError("the regulator equations need a generator without G, received one with G")
    tolerance = share("tolerance", tolerance)
    n, m, q, k = one.n, one.m, g.q, one.k
    r, f = ([[0.0] * n], [[0.0] * q]) if following is None else _pair(following)
    rows, wanted = matrix("R", r, None, n), matrix("F", f, len(matrix("R", r, None, n)), q)

    def left(numbers: FloatArray) -> dict[str, FloatArray]:
        pi, l0, l1 = _split(numbers, n, m, q, k)
        return {
            "A0 Pi + B L0 - Pi S0": one.A0 @ pi + one.B @ l0 - pi @ g.S0,
            "A1 + B L1 - Pi S1": one.A1 + one.B @ l1 - pi @ g.S1,
            "R Pi - F": rows @ pi - wanted,
        }

    def stacked(numbers: FloatArray) -> FloatArray:
        return np.concatenate([part.ravel() for part in left(numbers).values()])

    count = n * q + m * (q + k)
    start = stacked(np.zeros(count))
    slope = np.array([stacked(unit) - start for unit in np.eye(count)]).T
    size = np.where(slope.any(axis=0), np.abs(slope).max(axis=0, initial=0.0), 1.0)
    numbers = np.linalg.lstsq(slope / size, -start, rcond=None)[0] / size
    residuals = {name: float(np.abs(part).max(initial=0.0)) for name, part in left(numbers).items()}
    pi, l0, l1 = _split(numbers, n, m, q, k)
    terms = {
        "A0 Pi + B L0 - Pi S0": np.abs(one.A0) @ np.abs(pi) + np.abs(one.B) @ np.abs(l0),
        "A1 + B L1 - Pi S1": np.abs(one.A1) + np.abs(one.B) @ np.abs(l1),
        "R Pi - F": np.abs(wanted) + np.abs(rows) @ np.abs(pi),
    }
    shares = {
        name: residual / (float(terms[name].max(initial=0.0)) or 1.0) for name, residual in residuals.items()
    }
    worst = max(shares, key=lambda name: shares[name])
    if shares[worst] > tolerance:
        raise InfeasibleError(
            f"the regulator equations cannot hold: the least residual leaves {residuals[worst]:.6g} in "
            f"{worst}"
            f"{_zeros(one, g.S0, rows if following is not None else None)}"
        )
    rank = int(np.linalg.matrix_rank(slope / size))
    return RegulatorEquations(pi, l0, l1, residuals, count - rank)


def _split(numbers: FloatArray, n: int, m: int, q: int, k: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    pi, l0, l1 = np.split(numbers, [n * q, n * q + m * q])
    return pi.reshape(n, q), l0.reshape(m, q), l1.reshape(m, k)


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
