"""Observers of the reversed connection as compiled stages on irregular samples."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pointpred.errors import ParameterError
from pointpred.observers.interconnected.persidskii_observer import PersidskiiObserver
from pointpred.observers.matrices import matrix
from pointpred.observers.reduced_order.reversed_connection import InvariantObserver


def invariant_stage(
    observer: InvariantObserver,
    *,
    start: ArrayLike | None = None,
    **settings: Any,
) -> PersidskiiObserver:
    """Observer (3.17) or (3.19) as a stage: inputs are y, then u; it returns the plant's x.

    Assumes constant matrices, C1 = 0 and w, y that determine x, as a reduced-order observer has them.
    The measured part of the answer is the measurement: its noise goes through, also into the rest by
    Upsilon.

    Parameters: ``start`` a guess of the plant's state, zeros unless given; ``step_s`` and ``gap_s`` as for
    ``PersidskiiObserver``. Raises ParameterError.

    Reference: Khalin 2022, (3.17), (3.19), (3.29).

    >>> from pointpred.observers import Persidskii, invariant_observer
    >>> plant = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", C0=[1.0, 0.0])  # position, velocity
    >>> stage = invariant_stage(invariant_observer(plant, [[0.0, 1.0]], [[-20.0]]), step_s=0.01)
    >>> for i in range(100):
    ...     state = stage.update(i / 100, [0.3 * i / 100])
    >>> state.round(6).tolist()
    [0.297, 0.3]
    """
    if observer.varying:
        raise ParameterError("a compiled stage needs constant matrices, received some that vary")
    now, plant = observer.at(0.0), observer.plant
    onto, straight = observer.recovery(0.0)
    known = plant.m + plant.z
    guess = np.zeros(plant.n) if start is None else matrix("start", start, 1, plant.n)[0]
    return PersidskiiObserver(
        now.S0,
        now.S1,
        now.J,
        np.hstack([now.B, now.O]),
        plant.f,
        R0=onto,
        R=np.hstack([now.R, np.zeros((plant.k, known))]),
        R2=np.hstack([straight, np.zeros((plant.n, known))]),
        start=now.Z @ guess,
        time=plant.time,
        **settings,
    )
