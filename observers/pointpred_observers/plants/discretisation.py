"""Sampled plants: a continuous Persidskii system as a discrete one."""

from __future__ import annotations

from typing import Any, overload

import numpy as np

from pointpred.errors import ParameterError
from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import one_of, positive
from pointpred_observers.plants.generator import Generator
from pointpred_observers.plants.linear_systems import Plant, constant
from pointpred_observers.plants.persidskii import Persidskii

METHODS = ("zoh", "euler")


@overload
def c2d(system: Generator, step_s: float, *, method: str = "zoh") -> Generator: ...
@overload
def c2d(system: Plant, step_s: float, *, method: str = "zoh") -> Persidskii: ...
def c2d(system: Any, step_s: float, *, method: str = "zoh") -> Any:
    """The discrete plant (or generator) whose next state is the state after ``step_s``.

    ``"zoh"`` holds the inputs u, rho (y and rho of a generator), and the value of f, over the step: exact for
    a linear plant under held inputs, else off by terms of step_s^2 each step, as f moves meanwhile.
    ``"euler"`` is x + step_s x', off by terms of step_s^2 as well, and keeps the steady-state map: (3.3)
    holds for the discrete pair with the same Pi. Slopes, domain, C0, C1, H, J, L0 and L1 stay.

    zoh: (Ad Nd; 0 I) = exp(step_s (A0 N; 0 0)) with N = (A1 B Q) or (S1 G E).

    Parameters: ``step_s`` in s, > 0. Raises ParameterError for a plant or a generator that is discrete, and
    for matrices that vary.

    >>> held = c2d(Persidskii([[-1.0]], None, None, "sin", B=[1.0]), 0.1)
    >>> held.A0.round(6).tolist(), held.B.round(6).tolist(), held.time
    ([[0.904837]], [[0.095163]], 'discrete')
    """
    step_s = positive("step_s", step_s)
    one_of("method", method, METHODS)
    if isinstance(system, Generator):
        if system.time == "discrete":
            raise ParameterError("c2d needs a continuous generator, received a discrete one", field="system")
        held = {name: one for name in ("S1", "G", "E") if (one := getattr(system, name)) is not None}
        s0, parts = _sampled(system.S0, list(held.values()), step_s, method)
        driven: dict[str, Any] = dict(zip(held, parts, strict=True))
        kept = {"J": system.J, "L0": system.L0, "L1": system.L1, "f": system.f}
        return Generator(s0, **driven, **kept, time="discrete")
    plant = constant(system, "c2d")
    if plant.time == "discrete":
        raise ParameterError("c2d needs a continuous plant, received a discrete one", field="system")
    a0, (a1, b, q) = _sampled(plant.A0, [plant.A1, plant.B, plant.Q], step_s, method)
    return Persidskii(
        a0, a1, plant.H, plant.f, b, q, plant.C0, plant.C1, time="discrete", domain=plant.domain
    )


def _sampled(
    a: FloatArray, parts: list[FloatArray], step_s: float, method: Any
) -> tuple[FloatArray, list[FloatArray]]:
    from scipy.signal import cont2discrete

    widths = np.cumsum([one.shape[1] for one in parts])[:-1]
    drive, none = np.hstack([np.zeros((len(a), 0)), *parts]), np.zeros((0, len(a)))
    system: Any = a, drive, none, np.zeros((0, drive.shape[1]))
    held: Any = cont2discrete(system, step_s, method)
    return np.asarray(held[0], np.float64), np.split(np.asarray(held[1], np.float64), widths, axis=1)
