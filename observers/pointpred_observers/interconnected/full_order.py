"""The full-order observer: a copy of the plant, corrected by its output."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred_observers.interconnected.design import ObserverDesign, design_observer
from pointpred_observers.interconnected.generator import Generator
from pointpred_observers.linear_systems import Plant, as_plant
from pointpred_observers.matrices import positive
from pointpred_observers.persidskii import Persidskii


def design_full_order(plant: Plant, *, decay: float = 1.0, gain: Any = None) -> ObserverDesign:
    """The observer that estimates every state from the outputs and the known inputs, with its certificate.

    Theorem 3.2.1 with the plant itself as its generator and Pi = I: the inputs of B and of Q are both
    measured, so that the plant of the answer has them in its Q, those of B first.

    z' = A0 z + A1 f(Hz) + B u + Q rho + M (y - C0 z - C1 f(Hz))

    Parameters: ``decay`` in 1/s (1/step), > 0, demanded of the error; ``gain`` as for
    ``design_observer``, which also says what is raised. ``observer_stage`` runs it; its inputs are y, then u
    and rho.

    Reference: Khalin 2022, Theorem 3.2.1.

    >>> cart = Persidskii([[0.0, 1.0], [0.0, 0.0]], None, None, "sin", [0.0, 1.0], None, [1.0, 0.0])
    >>> design = design_full_order(cart, decay=2.0)
    >>> design.bound.decay >= 2.0, min(design.margins.values()) > 0.0
    (True, True)
    """
    one, decay = as_plant(plant), positive("decay", decay)
    inputs = np.hstack([one.B, one.Q])
    known = Persidskii(
        one.A0, one.A1, one.H, one.f, None, inputs, one.C0, one.C1, time=one.time, domain=one.domain
    )
    copied = Generator(one.A0, one.A1, one.H, E=inputs)
    return design_observer(known, copied, np.eye(one.n), gain=gain, decay=decay)
