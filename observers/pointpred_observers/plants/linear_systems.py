"""Linear plants of other libraries: state-space systems of python-control and scipy."""

from __future__ import annotations

from math import inf
from typing import Any, Protocol

import numpy as np

from pointpred.errors import ParameterError
from pointpred.parameter import is_number
from pointpred_observers.numerics.matrices import matrix, wrong
from pointpred_observers.plants.persidskii import Persidskii


class LinearSystem(Protocol):
    """x' = A x + B u, y = C x + D u of another library: ``control.StateSpace``, ``scipy.signal.lti``."""

    A: Any
    B: Any
    C: Any
    D: Any


Plant = Persidskii | LinearSystem
"""What every design takes as its plant."""


def as_plant(system: Any) -> Persidskii:
    """The Persidskii system of a linear system x' = A x + B u, y = C x, or a Persidskii system as it is.

    Discrete where the system has a step (``dt`` above 0, or True); rates are then per step. A transfer
    function of scipy or python-control is realised by its own library.

    Raises ParameterError for other objects, for a transfer function that is not proper, for a system without
    states, for D other than 0 and for a ``dt`` that is no number.
    """
    if isinstance(system, Persidskii):
        return system
    if not hasattr(system, "A") and hasattr(system, "to_ss"):
        try:
            system = system.to_ss()
        except (ValueError, TypeError, ArithmeticError, NotImplementedError) as failure:
            words = f"a plant must have a state-space form, received a {type(system).__name__}: {failure}"
            raise ParameterError(words, field="plant") from failure
    if not all(hasattr(system, name) for name in "ABCD"):
        kinds = "a Persidskii system or a linear one with A, B, C and D, such as control.StateSpace"
        raise ParameterError(
            f"a plant must be {kinds}, received {type(system).__name__}", field="plant", value=system
        )
    a = matrix("A", system.A)
    if not a.size:
        raise ParameterError("a plant needs at least one state, A is empty", field="plant")
    d = matrix("D", system.D, len(matrix("C", system.C)), matrix("B", system.B).shape[1])
    if d.any():
        raise ParameterError("a plant needs D = 0: subtract D u from the measured output", field="plant")
    time = "discrete" if _has_step(system) else "continuous"
    return Persidskii(a, None, None, "identity", B=system.B, C0=system.C, time=time)


def constant(system: Any, what: str = "a design") -> Persidskii:
    """The same for what needs constant matrices; raises ParameterError naming those that vary."""
    plant = as_plant(system)
    if plant.varying:
        varying = ", ".join(plant.varying)
        raise ParameterError(f"{what} needs constant matrices; {varying} vary: use plant.at", field="plant")
    return plant


def _has_step(system: Any) -> bool:
    """Whether a system is discrete; python-control has True for a step that is not known."""
    step = getattr(system, "dt", None)
    if step is None or isinstance(step, bool | np.bool_):
        return bool(step)
    if not is_number(step) or not 0.0 <= step < inf:
        raise wrong("dt", "must be a number not below 0, True for a step that is not known, or None", step)
    return bool(step > 0.0)
