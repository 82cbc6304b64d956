"""One call that simulates a plant of any kind beside its observer."""

from __future__ import annotations

from collections.abc import Callable
from functools import singledispatch
from typing import Any

import numpy as np

from pointpred.errors import ParameterError
from pointpred.regression import RecursiveLeastSquares
from pointpred_observers.interconnected.design import ObserverDesign
from pointpred_observers.interconnected.generator import Generator
from pointpred_observers.interconnected.regulator import RegulatorDesign
from pointpred_observers.reduced_order.design import ReducedOrderDesign
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver
from pointpred_observers.regressors.gradient import GradientRegressor, NonlinearRegressor
from pointpred_observers.simulations import parameter_varying, persidskii, regressions, symbolic
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.unknown_input.observer import UnknownInputObserver


def simulate(
    plant: Any,
    observer: Any,
    *,
    times: Any = None,
    start: Any = None,
    estimate: Any = None,
    input: Any = None,
    disturbance: Any = None,
    unknown_input: Any = None,
    schedule: Any = None,
    noise: Any = 0.0,
    seed: int = 0,
) -> Simulation:
    """A plant and its observer from their starts on, with arrays of every signal and ``plot``.

    The plant is integrated by an adaptive method, the observer is the stage that a program runs, sample by
    sample; a regulator is ``regulator_stage``, whose u at a sample acts until the next. The plant need not be
    the one of the design: give another to see what a wrong model does.

    ========================================= ============================ ==========================
    observer                                  plant                        ``start`` of the plant
    ========================================= ============================ ==========================
    ReducedOrderDesign, InvariantObserver,    Persidskii or linear         x
    ObserverDesign of design_full_order
    other ObserverDesign                      Persidskii or linear         x, or x and the generator's w
    RegulatorDesign, Generator as regulator   Persidskii or linear         x
    UnknownInputObserver                      ParameterVaryingSystem       x
    InterlacedObserver                        SymbolicSystem               w of the generator, x, z
    GradientRegressor, NonlinearRegressor,    Regression                   none: the parameters are its
    RecursiveLeastSquares
    ========================================= ============================ ==========================

    Parameters: ``times`` of the samples in s, by default 10 s in steps of 10 ms; of a discrete plant its
    indices, by default 0 to 1000. ``start`` by default ones. ``estimate``: what the observer starts with, by
    default zeros: x; w for a generator, a regulator and an interlaced observer. Signals are constants,
    functions of t, or left out for zero: ``input`` the known inputs, those of B, then of Q (of Q alone where
    a generator or a regulator gives u; b of a parameter-varying plant); ``disturbance`` added to x' (the next
    x); ``unknown_input`` d and ``schedule`` the scheduling variables of a parameter-varying plant, a dict, or
    a function of t and x. ``noise`` standard deviation of the outputs, one or p; ``seed`` of the noise.

    Raises ParameterError naming the argument, also where plant and observer do not fit; DivergenceError with
    the time at which the plant leaves every bound; CertificateError for a reduced-order design whose
    observer does not keep the equalities of its certificate.

    >>> import numpy as np
    >>> from pointpred_observers import Persidskii, design_reduced_order
    >>> cart = Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", [0.0, 1.0], None, [1.0, 0.0])
    >>> design = design_reduced_order(cart, decay=3.0)
    >>> result = simulate(cart, design, times=np.arange(0.0, 4.0, 0.01), input=np.sin)
    >>> result.state.shape, bool(abs(result.error[-1]).max() < 1e-4)
    ((400, 2), True)
    """
    if not isinstance(seed, int) or isinstance(seed, bool) or seed < 0:
        raise ParameterError(
            f"seed must be a whole number not below 0, received {seed!r}", field="seed", value=seed
        )
    setting = Setting(times, start, estimate, input, disturbance, unknown_input, schedule, noise, seed)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows leaves every bound, and is refused
        return _simulated(observer, plant, setting)


@singledispatch
def _simulated(observer: Any, plant: Any, setting: Setting) -> Simulation:
    advice = ": the state of a field over time is trajectory(field, start, times)" if callable(plant) else ""
    raise ParameterError(
        f"can simulate {', '.join(kind.__name__ for kind in RUNS)} with their plants, received "
        f"{type(observer).__name__}{advice}",
        field="observer",
        value=observer,
    )


RUNS: dict[type, Callable[[Any, Any, Setting], Simulation]] = {
    ReducedOrderDesign: persidskii.reduced_order,
    InvariantObserver: persidskii.invariant,
    ObserverDesign: persidskii.observed,
    RegulatorDesign: persidskii.regulated,
    Generator: persidskii.driven_by,
    UnknownInputObserver: parameter_varying.unknown_inputs,
    InterlacedObserver: symbolic.interlaced,
    GradientRegressor: regressions.gradient,
    NonlinearRegressor: regressions.nonlinear,
    RecursiveLeastSquares: regressions.least_squares,
}
"""How each kind of observer is simulated."""
for _kind, _run in RUNS.items():
    _simulated.register(_kind, _run)
