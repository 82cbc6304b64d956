"""Assumption 3.2.2: solutions of a plant approach each other, whatever its inputs."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred_observers.error_systems.decay import DecayCertificate, certify_decay
from pointpred_observers.error_systems.system import ErrorSystem, sloped_system
from pointpred_observers.interconnected.generator import Generator, fitted
from pointpred_observers.linear_systems import Plant, as_plant
from pointpred_observers.matrices import matrix
from pointpred_observers.rounding import without_rounding


def incremental_system(plant: Plant, generator: Generator | None = None, Pi: Any = None) -> ErrorSystem:
    """The system of x - Pi w, or of the difference of two solutions where no output is fed back.

    z' = (A0 - Pi G C0) z + (A1 - Pi G C1) (f(Jw + Hz) - f(Jw)) + d - Pi w + Pi G v, (3.14) for Pi = I;
    without G it does not depend on the generator.

    Raises ParameterError where matrices vary, and where a generator with a G comes without Pi.
    """
    one = as_plant(plant)
    if one.varying:
        raise ParameterError(
            f"Assumption 3.2.2 is checked for constant matrices; {', '.join(one.varying)} vary"
        )
    disturbances = {"d": np.eye(one.n)}
    a0, a1 = one.A0, one.A1
    if generator is not None:
        g = fitted(generator, one)
        if Pi is None and g.G.any():
            raise ParameterError("a generator with a G needs Pi: take it from steady_state_map", field="Pi")
        if Pi is not None:
            pi = matrix("Pi", Pi, one.n, g.q)
            a0 = a0 - pi @ g.G @ one.C0
            a1 = without_rounding(a1 - pi @ g.G @ one.C1, a1, pi @ g.G @ one.C1)
            disturbances |= {"w": -pi, "v": pi @ g.G}
    return sloped_system(a0, a1, one.H, disturbances, slopes=one.slopes, time=one.time, domain=one.domain)


def assumption_3_2_2(
    plant: Plant,
    generator: Generator | None = None,
    Pi: Any = None,
    *,
    decay: float | None = None,
) -> DecayCertificate:
    """A certificate of incremental input-to-state stability, by a quadratic function of the difference.

    Sufficient for Assumption 3.2.2, as far as its consequence, Proposition 3.2.2, uses it: x approaches Pi w
    up to the disturbances d of the plant, w of the generator and v of the output. Global if the slopes of f
    hold globally. The states of two generators need not approach each other, those of an oscillator never do.
    A refusal is not a proof of the contrary.

    Parameters: ``generator`` and ``Pi`` for a plant whose output is fed back (G != 0); ``decay`` in 1/s
    (1/step), > 0, by default a fraction of the slowest corner's.
    Raises InfeasibleError naming an eigenvalue of the plant linearised at a corner of the slopes that does
    not decay; InfeasibleError, UndecidedError, CertificateError from the solver; ParameterError for slopes
    that are missing or not bounded.

    Reference: Khalin 2022, Assumption 3.2.2, Proposition 3.2.2; Angeli 2002.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0, 0.5], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.0], "tanh", [0.0, 1.0])
    >>> found = assumption_3_2_2(plant, decay=0.8)
    >>> round(found.bound.decay, 6), min(found.margins.values()) > 0.0
    (0.8, True)
    >>> assumption_3_2_2(Persidskii([[0.0, 1.0], [-1.0, 0.0]], None, None, "sin"))
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: Assumption 3.2.2: the error system has the eigenvalue 0+1j, must lie \
left of 0
    """
    system = incremental_system(plant, generator, Pi)
    try:
        return certify_decay(system, decay=decay)
    except ArithmeticError as failure:
        raise type(failure)(f"Assumption 3.2.2: {failure}") from failure
