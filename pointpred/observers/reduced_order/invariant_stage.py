"""The reversed connection of section 3.3 in a loop: samples of y and u in, the plant's state out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pointpred.records import FloatArray
from pointpred_observers.interconnected.missing_inputs import MissingInputs
from pointpred_observers.interconnected.persidskii_observer import PersidskiiObserver
from pointpred_observers.matrices import instance, matrix
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver


def invariant_stage(
    observer: InvariantObserver,
    *,
    start: ArrayLike | None = None,
    **settings: Any,
) -> PersidskiiObserver:
    """Observer (3.17) or (3.19) as a stage: inputs are y, then u; it returns the plant's x.

    Assumes C1 = 0 and that w and y determine x, as for a reduced-order observer. The measured part of the
    output is the measurement with its noise, which also enters the rest through Upsilon. While an output is
    missing it follows the plant's equation, y' = C0 x'; a missing u keeps its last value. Compiled for
    constant matrices and an f that has a name; others run in numpy.

    Parameters: ``start`` a guess of the plant's state, default zeros; ``step_s`` and ``gap_s`` as for
    ``PersidskiiObserver``. Raises ParameterError.

    Reference: Khalin 2022, (3.17), (3.19), (3.29).

    >>> from pointpred_observers import Persidskii, invariant_observer
    >>> plant = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0])  # position, velocity
    >>> stage = invariant_stage(invariant_observer(plant, [[0.0, 1.0]], [[-20.0]]), step_s=0.01)
    >>> for i in range(100):
    ...     state = stage.update(i / 100, [0.3 * i / 100])
    >>> state.round(6).tolist()
    [0.297, 0.3]
    >>> stage.update(1.5, None).round(4).tolist()  # half a second later, without a measurement
    [0.45, 0.3]
    """
    observer = instance("observer", observer, InvariantObserver)
    plant, now = observer.plant, observer.at(0.0)
    m, inputs = plant.p + plant.m + plant.z, plant.m + plant.z
    guess = np.zeros(plant.n) if start is None else matrix("start", start, 1, plant.n)[0]
    stay = np.eye(m)[plant.p :] if plant.time == "discrete" else np.zeros((inputs, m))

    def of(one: Callable[[float], Any]) -> Any:
        return one if observer.varying else one(0.0)

    def below(part: int, rest: FloatArray) -> Any:
        return of(lambda t: np.vstack([observer.output_rate(t)[part], rest]))

    def inner(t: float) -> tuple[FloatArray, FloatArray]:
        """J and R with Hx = Jw + Ry, also where the observer has no f of its own."""
        one = observer.at(t)
        if one.S1.any():
            return one.J, one.R
        onto, straight = observer.recovery(t)
        h = plant.matrices(t)["H"]
        return h @ onto, h @ straight

    missing = MissingInputs(
        (False,) * m,
        below(0, np.zeros((inputs, observer.q))),
        below(1, np.zeros((inputs, plant.k))),
        below(2, stay),
        np.concatenate([plant.C0 @ guess, np.zeros(inputs)]),
    )
    return PersidskiiObserver(
        of(lambda t: observer.at(t).S0),
        of(lambda t: observer.at(t).S1),
        of(lambda t: inner(t)[0]),
        of(lambda t: np.hstack([observer.at(t).B, observer.at(t).O])),
        plant.f,
        R0=of(lambda t: observer.recovery(t)[0]),
        R=of(lambda t: np.hstack([inner(t)[1], np.zeros((plant.r, inputs))])),
        R2=of(lambda t: np.hstack([observer.recovery(t)[1], np.zeros((plant.n, inputs))])),
        start=now.Z @ guess,
        missing=missing,
        time=plant.time,
        **settings,
    )
