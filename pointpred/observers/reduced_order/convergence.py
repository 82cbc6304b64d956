"""The certificate that the state of a reduced-order observer converges, and the bound that it proves."""

from __future__ import annotations

from math import sqrt
from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import CertificateError
from pointpred.observers.bounds import ErrorBound, continuous_bound, discrete_bound
from pointpred.observers.matrices import positive
from pointpred.observers.persidskii import Persidskii
from pointpred.observers.reduced_order.reversed_connection import Connection


class Convergence(msgspec.Struct, frozen=True):
    """A certificate that the invariant solution attracts the observer's state.

    ``values`` of P, Xi and the theorem's other matrices, the ``margins`` of each inequality recomputed from
    them, and the ``bound`` of the error for a disturbance delta of the observer's equation. The certificate
    holds while the arguments of f stay within ``domain``; ``J`` maps the error to them. ``gap``: how far the
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
        reach = positive("reach", reach, zero=True)
        if np.isinf(self.domain) or not self.J.any():
            return np.inf, np.inf
        room = self.domain - reach
        if room <= 0.0:
            raise CertificateError(
                f"the trajectory reaches {reach:g}, the slopes hold within {self.domain:g} only"
            )
        p = np.asarray(self.values["P"])
        spread = float(np.einsum("ij,jk,ik->i", self.J, np.linalg.inv(p), self.J).max())
        level = room**2 / spread
        return level, sqrt(level / float(np.linalg.eigvalsh(p).max()))


def convergence(
    connections: list[Connection],
    plant: Persidskii,
    values: dict[str, Any],
    margins: dict[str, float],
    gap: float,
) -> Convergence:
    """The bound that audited matrices prove."""
    if plant.time == "discrete":
        bound = discrete_bound(values["P"], values["Xi"], values["Gamma"], sharp=True)
    else:
        bound = continuous_bound(values["P"], values["Xi"], values["gamma"])
    theorem = "3.3.2" if plant.time == "discrete" else "3.3.1"
    domain = plant.domain if any(one.S1.any() for one in connections) else np.inf
    return Convergence(theorem, values, margins, bound, connections[0].J, domain, gap)
