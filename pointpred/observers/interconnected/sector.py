"""The constants of Assumption 3.2.4, from the slopes of f or from the caller."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.linear_systems import Plant, as_plant
from pointpred_observers.matrices import matrix


class SectorBounds(msgspec.Struct, frozen=True):
    """The constants of Assumption 3.2.4: ``Sigma1``, ``Psi1`` (n, n), the others diagonal (k, k)."""

    Sigma1: FloatArray
    Psi1: FloatArray
    Sigma2: FloatArray
    Sigma3: FloatArray
    Sigma4: FloatArray
    Psi2: FloatArray


def sector_bounds(plant: Plant, **values: Any) -> SectorBounds:
    """The constants that slopes of at most b_j imply, Sigma1 = Psi1 = H' diag(b^2) H, or those passed.

    Raises ParameterError where slopes are missing, unbounded or negative (Assumption 3.2.5 needs an f that
    increases), CertificateError where the passed Sigma1 or Psi1 lie below those that the slopes imply; that
    is sufficient for Assumption 3.2.4 and, with the other constants zero, necessary where the slopes are
    reached.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii(-np.eye(2), [0.0, 1.0], [0.0, 2.0], "tanh")
    >>> sector_bounds(plant).Sigma1.tolist()
    [[0.0, 0.0], [0.0, 4.0]]
    """
    plant = as_plant(plant)
    slopes = np.array(plant.slopes if plant.slopes is not None else [], np.float64).reshape(-1, 2)
    if len(slopes) != plant.k or not np.isfinite(slopes).all():
        raise ParameterError(f"Assumption 3.2.4 needs bounded slopes, received {plant.slopes}")
    if (slopes < 0.0).any():
        raise ParameterError(
            f"Assumption 3.2.5 needs an f that increases, received slopes {plant.slopes}: give those of a "
            "domain on which it does"
        )
    least: FloatArray = plant.H.T @ np.diag(slopes[:, 1] ** 2) @ plant.H
    n, k = plant.n, plant.k
    shapes = {"Sigma1": n, "Psi1": n, "Sigma2": k, "Sigma3": k, "Sigma4": k, "Psi2": k}
    if set(values) - set(shapes):
        raise ParameterError(f"the constants are {', '.join(shapes)}, received {', '.join(values)}")
    default = {"Sigma1": least, "Psi1": least}
    constants = {
        name: matrix(name, values[name], size, size)
        if name in values
        else default.get(name, np.zeros((k, k)))
        for name, size in shapes.items()
    }
    for name in ("Sigma1", "Psi1"):
        below = float(np.linalg.eigvalsh(constants[name] - least).min())
        if below < -1e-9 * max(1.0, float(np.abs(least).max(initial=0.0))):
            reason = f"{name} - H' diag(b^2) H has the eigenvalue {below:.6g}, must be >= 0"
            raise CertificateError(f"Assumption 3.2.4: {reason}")
    return SectorBounds(**constants)
