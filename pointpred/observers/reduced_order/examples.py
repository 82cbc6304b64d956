"""The systems of examples 5 to 7 of the thesis, corrected where the print is wrong."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.columns import FloatArray
from pointpred.observers.persidskii import Persidskii

UNMEASURED = np.eye(4)[2:]
"""Pi of example 5: position and velocity of the second mass."""
TRUTH = (3.0, 5.0)
"""What example 6 estimates, at t = 0."""
VAPOURS = np.array([-0.08, 0.19, -4.0, 9.8])
"""What least squares finds in the data of example 7, rounded."""


def two_masses(domain: float = 2.0) -> Persidskii:
    """Example 5, (3.59): two masses and a hardening spring; ``domain`` bounds abs(x1 - x3), in its unit.

    A0[4, 4] is -a1 - a2 where the print has a1 - a2, and Q has a second column for u1, which the print drops.

    >>> two_masses().A0[3].round(9).tolist()
    [3.0, 0.6, -3.6, -2.6]
    """
    k1, k2, k3, a1, a2 = 3.0, 3.0, 0.6, 0.6, 2.0
    return Persidskii(
        [[0.0, 1.0, 0.0, 0.0], [-k1, -a1, k1, a1], [0.0, 0.0, 0.0, 1.0], [k1, a1, -k1 - k3, -a1 - a2]],
        [0.0, -k2, 0.0, k2],
        [1.0, 0.0, -1.0, 0.0],
        "cube",
        Q=[[0.0, 0.0], [0.0, 0.2], [0.0, 0.0], [1.0, 0.0]],
        C0=np.eye(2, 4),
        slopes=(0.0, 3.0 * domain**2),
        domain=domain,
    )


def pushes(t: float) -> FloatArray:
    """The inputs of example 5: u = sin t on the second mass, u1 = sin 10 t on the first."""
    return np.array([np.sin(t), np.sin(10.0 * t)])


def two_sensors(t: Any) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Example 6 at times t: J, D1, and the constants that d = 0.1 (sin t, sin 2t) moves.

    >>> j, weight, x = two_sensors(0.0)
    >>> j.tolist(), float(weight), x.tolist()
    ([1.0, 0.0], 0.0, [3.0, 5.0])
    """
    t = np.asarray(t, np.float64)
    x = np.stack([TRUTH[0] + 0.1 * (1.0 - np.cos(t)), TRUTH[1] + 0.05 * (1.0 - np.cos(2.0 * t))], axis=-1)
    return np.stack([np.ones_like(t), np.sin(t)], axis=-1), np.sin(5.0 * t) ** 2, x


def fused(t: Any) -> FloatArray:
    """The output of example 6, (3.50): (1 - D1) J x + D1 arctan(J x)."""
    j, weight, x = two_sensors(t)
    s = (j * x).sum(axis=-1)
    return np.asarray((1.0 - weight) * s + weight * np.arctan(s))


def vapours(seed: int = 7, count: int = 125) -> tuple[FloatArray, FloatArray]:
    """A stand-in for the data of example 7: four predictors that nearly tell the same, and what they make.

    The true parameters are those of least squares on the real data, rounded; the noise has its size.

    >>> rows, outputs = vapours()
    >>> rows.shape, round(float(np.linalg.cond(rows)), -2)
    ((125, 4), 500.0)
    """
    random = np.random.default_rng(seed)
    warm = random.uniform(30.0, 90.0, count)
    gas = warm + random.normal(0.0, 8.0, count) - 5.0
    tank = 2.2 + 0.045 * warm + random.normal(0.0, 0.35, count)
    pressure = tank + random.normal(0.0, 0.25, count)
    rows = np.column_stack([warm, gas, tank, pressure])
    return rows, rows @ VAPOURS + random.normal(0.0, 2.8, count)
