"""The certificate that the state of a reduced-order observer converges, and the bound that it proves."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.numerics.matrices import positive
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.bounds import ErrorBound, decay_of, eigenvalues, proved_bound, region
from pointpred_observers.reduced_order.reversed_connection import Connection


class Convergence(msgspec.Struct, frozen=True):
    """A certificate that the invariant solution attracts the observer's state.

    ``values`` of P, Xi and the theorem's other matrices, the ``margins`` of each inequality recomputed from
    them, and the ``bound`` of the error for a disturbance delta of the observer's equation. The certificate
    holds while the arguments of f stay within ``domain``; ``J`` maps the error to them, the rows of one
    certified time below those of another. ``gap``: how far the
    least condition number of P in balanced units (in discrete time plus the size of Gamma) could lie below
    that of this one, relative to it; infinite if nothing is proved.
    """

    theorem: str
    values: dict[str, Any]
    margins: dict[str, float]
    bound: ErrorBound
    J: FloatArray
    domain: float
    gap: float = np.inf

    def region(self, reach: float) -> tuple[float, float]:
        """The region of validity, if abs(H x) stays within ``reach``, not below 0, on the true trajectory.

        Returns the level c of the ellipsoid e'Pe <= c that keeps the observer's arguments within the
        domain, and the radius of the largest ball of initial errors in it; infinite if the domain is. Raises
        CertificateError if the trajectory itself leaves the domain, ParameterError for a ``reach`` that is
        no bound.
        """
        return region(
            self.values["P"], self.J, self.domain, np.full(len(self.J), positive("reach", reach, zero=True))
        )


def convergence(
    connections: list[Connection],
    plant: Persidskii,
    values: dict[str, Any],
    margins: dict[str, float],
    gap: float,
) -> Convergence:
    """The bound that audited matrices prove."""
    if plant.time == "discrete":
        drive = eigenvalues("Gamma", values["Gamma"])[-1]
    else:  # delta'P delta / gamma, with the factor that the print lacks
        drive = eigenvalues("P", values["P"])[-1] / values["gamma"]
    decay = decay_of(values["P"], values["Xi"], plant.time)
    bound = proved_bound(values["P"], decay, {"delta": drive}, plant.time)
    theorem = "3.3.2" if plant.time == "discrete" else "3.3.1"
    sloped = [one.J for one in connections if one.S1.any()]
    domain = plant.domain if sloped else np.inf
    j = np.vstack(sloped) if sloped else np.zeros((0, len(connections[0].S0)))
    return Convergence(theorem, values, margins, bound, j, domain, gap)
