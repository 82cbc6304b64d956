"""Tracking control: assumptions 3.2.3 to 3.2.6, theorems 3.2.2 and 3.2.3, for a regulator and its plant."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError, UndecidedError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.regulated import (
    Followed,
    Loop,
    Regulated,
    SectorBounds,
    sector_bounds,
)
from pointpred_observers.interconnected.steady_state import equalities, shares_left
from pointpred_observers.numerics.balance import Coordinates
from pointpred_observers.numerics.equalities import TOLERANCE, largest
from pointpred_observers.numerics.matrices import instance, matrix, share, vector
from pointpred_observers.plants.generator import (
    Fitted,
    Generator,
    fitted,
    require_same_nonlinearity,
)
from pointpred_observers.plants.linear_systems import Plant, as_plant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities, Solution
from pointpred_observers.proofs.search import Posed, search


class TrackingCertificate(msgspec.Struct, frozen=True):
    """Both theorems: the ``regulator`` is ISS (3.2.2) and so is the ``error`` z = x - Pi w (3.2.3).

    Local if the slopes hold on a ``domain`` only: abs(Jw), abs(Hz) and abs(Jw + Hz) must stay below it.
    """

    regulator: Solution
    error: Solution
    margins: dict[str, float]
    domain: float


def theorem_3_2_2(
    plant: Plant,
    regulator: Generator,
    Pi: Any,
) -> MatrixInequalities:
    """Assumption 3.2.3 with the condition of Theorem 3.2.2: the regulator is ISS with respect to z, w and v.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Omega, Lambda >= 0; S = S0 + G C0 Pi, S~ = S1 + G C1. The
    condition Xi + mu J' Omega J > 0 holds for some mu exactly if it holds for mu = 1, as both terms are
    positive semidefinite; so it is solved like the other inequalities.

    Assumes strict inequalities: with J S~ = 0 the block of f(Jw) is zero and none can hold.
    """
    plant, g, pi = _shared(plant, regulator, Pi)
    return Regulated.of(plant, g, pi).inequalities()


def theorem_3_2_3(
    plant: Plant,
    regulator: Generator,
    Pi: Any,
    sector: SectorBounds | None = None,
) -> MatrixInequalities:
    """Assumption 3.2.6 with the conditions of Theorem 3.2.3: z = x - Pi w is ISS with respect to d, w and v.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Lambda, Omega1, Omega2, Upsilon >= 0, gamma1, gamma2 > 0;
    A~0 = A0 - Pi G C0, A~1 = A1 - Pi G C1. As above, mu = 1 is enough.
    """
    plant, g, pi = _shared(plant, regulator, Pi)
    bound = sector_bounds(plant) if sector is None else instance("sector", sector, SectorBounds)
    return Followed.of(plant, g, pi, bound).inequalities()


def assumption_3_2_3(plant: Plant, regulator: Generator, Pi: Any) -> MatrixInequalities:
    """The inequalities of Assumption 3.2.3: ``solve`` finds matrices, ``check`` audits printed ones.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Omega, Lambda >= 0; S = S0 + G C0 Pi, S~ = S1 + G C1.

    Assumes r = k, as the thesis does, and strict inequalities in ``solve``: with J S~ = 0 the block of f(Jw)
    is zero and none can hold.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
    >>> regulator = Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0])
    >>> printed = {"P": 2.0, "Gamma": 99.0, "Xi": 1.0, "Omega": 4.0, "Lambda": 1.0}
    >>> sorted(assumption_3_2_3(plant, regulator, [[1.0]]).check(printed))
    ['Gamma > 0', 'Lambda >= 0', 'Omega >= 0', 'P > 0', 'Phi', 'Xi']
    """
    return _of_assumption(theorem_3_2_2(plant, regulator, Pi), "Xi + J' Omega J")


def assumption_3_2_6(
    plant: Plant, regulator: Generator, Pi: Any, sector: SectorBounds | None = None
) -> MatrixInequalities:
    """The inequalities of Assumption 3.2.6: ``solve`` finds matrices, ``check`` audits printed ones.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Lambda, Omega1, Omega2, Upsilon >= 0, gamma1, gamma2 > 0; A~0 =
    A0 - Pi G C0, A~1 = A1 - Pi G C1.
    """
    conditions = ("R1", "R2", "R3", "R4", "R1 + H'(R2 + R3) H")
    return _of_assumption(theorem_3_2_3(plant, regulator, Pi, sector), *conditions)


def _of_assumption(problem: MatrixInequalities, *conditions: str) -> MatrixInequalities:
    """A theorem's inequalities without the conditions that are its own."""
    for name in conditions:
        problem.blocks.pop(name, None)
    return problem


def certify_tracking(
    plant: Plant,
    regulator: Generator,
    Pi: Any,
    *,
    sector: SectorBounds | None = None,
    tolerance: float = TOLERANCE,
) -> TrackingCertificate:
    """Corollary 3.2.2: the plant follows Pi w under regulator (3.8), locally where slopes hold locally.

    Assumes that x = Pi w is the desired trajectory; checks that it is a solution (Assumption 3.2.1). Nothing
    is minimised: both problems are solved in balanced units, their matrices audited in the plant's.

    Parameters: ``sector`` the constants of Assumption 3.2.4, by default from the slopes; ``tolerance``
    of the equalities, a share of their own terms, for matrices rounded in print.
    Raises InfeasibleError naming an equality with its residual, or the assumption that cannot be satisfied;
    UndecidedError, CertificateError and ParameterError as for ``MatrixInequalities``.

    Reference: Khalin 2022, section 3.2.3.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
    >>> regulator = Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0])
    >>> certificate = certify_tracking(plant, regulator, [[1.0]])
    >>> min(certificate.margins.values()) > 0.0
    True
    """
    plant, tolerance = as_plant(plant), share("tolerance", tolerance)
    require_same_nonlinearity(plant, instance("regulator", regulator, Generator), name="regulator")
    held = equalities(plant, regulator, Pi)
    for name, part in shares_left(held).items():
        if not part <= tolerance:
            reason = f"{name} = 0 fails, its residual is {largest(held)[name]:.6g}"
            raise InfeasibleError(f"Assumption 3.2.1: {reason}")
    # With a larger tolerance J is checked to that share of its terms, above.
    g = fitted(regulator, plant, "regulator")
    pi = matrix("Pi", Pi, plant.n, g.q)
    bound = sector_bounds(plant) if sector is None else instance("sector", sector, SectorBounds)
    both: dict[str, Loop] = {
        "3.2.3": Regulated.of(plant, g, pi),
        "3.2.6": Followed.of(plant, g, pi, bound),
    }
    reasons = []
    for name, one in both.items():
        units = one.units()
        matrix_name, mode = one.inward(units).growing()
        if mode is not None:
            reasons.append(f"Assumption {name}: {mode.text(matrix_name, units.seconds)}, must lie left of 0")
    if reasons:
        raise InfeasibleError("; ".join(reasons))
    solutions: list[Solution] = []
    failed: list[Exception] = []
    for one in both.values():

        def posed(units: Coordinates, one: Loop = one) -> Posed:
            return Posed(one.inward(units).inequalities(), one.measured(units))

        def audited(values: dict[str, Any], _: float, one: Loop = one) -> Solution:
            return Solution(values, one.inequalities().check(values, printed=False))

        try:
            solutions.append(search(one.units(), posed, audited))
        except (InfeasibleError, UndecidedError, CertificateError) as failure:
            failed.append(failure)
    if failed:
        # One assumption that no matrices satisfy is enough for a refusal.
        kind = next((type(one) for one in failed if isinstance(one, InfeasibleError)), type(failed[0]))
        raise kind("; ".join(str(one) for one in failed)) from failed[0]
    margins = {
        f"{number}: {name}": margin
        for number, one in zip(both, solutions, strict=True)
        for name, margin in one.margins.items()
    }
    return TrackingCertificate(solutions[0], solutions[1], margins, plant.domain)


def _shared(plant: Plant, regulator: Any, Pi: Any) -> tuple[Persidskii, Fitted, FloatArray]:
    """The plant, the regulator's matrices and Pi, once they are known to share f and its arguments."""
    plant = as_plant(plant)
    g = fitted(regulator, plant, "regulator")
    pi = matrix("Pi", Pi, plant.n, g.q)
    require_same_nonlinearity(plant, regulator, pi, "regulator")
    return plant, g, pi


def closed_loop(plant: Plant, regulator: Generator, t: float, both: Any, **signals: Any) -> FloatArray:
    """The derivative of (x, w) under the regulator; ``rho``, ``v``, ``d`` and ``w`` are signals at t."""
    plant = as_plant(plant)
    g: Fitted = fitted(regulator, plant, "regulator")
    require_same_nonlinearity(plant, regulator, name="regulator")
    if unknown := set(signals) - {"rho", "v", "d", "w"}:
        raise ParameterError(f"the signals are rho, v, d and w, received {', '.join(sorted(unknown))}")
    sizes = {"rho": plant.z, "v": plant.p, "d": plant.n, "w": g.q}
    signals = {name: vector(name, one, sizes[name]) for name, one in signals.items() if one is not None}
    x, w = np.split(vector("both", both, plant.n + g.q), [plant.n])
    if g.J is None:
        raise ParameterError("a regulator needs J: give it, or take it from the steady-state map, J = H Pi")
    nonlinear = plant.f(g.J @ w)
    rho = signals.get("rho")
    dx = plant.field(t, x, g.L0 @ w + g.L1 @ nonlinear, rho, signals.get("d"))
    dw = g.S0 @ w + g.S1 @ nonlinear + g.G @ plant.output(t, x, signals.get("v"))
    if rho is not None:
        dw = dw + g.E @ np.atleast_1d(rho)
    return np.concatenate([dx, dw if signals.get("w") is None else dw + signals["w"]])
