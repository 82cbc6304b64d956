"""The reduced-order observer of the interconnection: Theorem 3.2.1 with the sector as a decision variable."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.errors import CertificateError, InfeasibleError
from pointpred.observers.balance import form, inward, outward
from pointpred.observers.bounds import ErrorBound, interconnection_bound
from pointpred.observers.detectability import require_detectable
from pointpred.observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred.observers.interconnected.generator import Fitted, Generator
from pointpred.observers.interconnected.interconnection import Interconnection, theorem_3_2_1
from pointpred.observers.interconnected.steady_state import residuals
from pointpred.observers.matrices import matrix, positive
from pointpred.observers.persidskii import Persidskii


class ObserverDesign(msgspec.Struct, frozen=True):
    """A gain with its certificate: matrices by name, ``margins`` by inequality, ``bound`` of the error."""

    gain: FloatArray
    values: dict[str, Any]
    margins: dict[str, float]
    bound: ErrorBound
    plant: Persidskii
    generator: Fitted
    Pi: FloatArray

    def region(self, reach: Any) -> tuple[float, float]:
        """The region of validity, if abs(Jw) stays within ``reach`` on the true trajectory.

        Returns the level c of the ellipsoid e'Pe <= c that keeps every argument within the plant's domain,
        and the radius of the largest ball of initial errors in it; both infinite if the domain is.
        Raises CertificateError if the trajectory itself leaves the domain.
        """
        if np.isinf(self.plant.domain):
            return np.inf, np.inf
        j = self.plant.H @ self.Pi
        room = self.plant.domain - np.broadcast_to(np.asarray(reach, np.float64), (len(j),))
        if (room <= 0.0).any():
            raise CertificateError(
                f"the trajectory reaches {np.max(reach):g}, the slopes hold within {self.plant.domain:g} only"
            )
        spread = np.einsum("ij,jk,ik->i", j, np.linalg.inv(self.values["P"]), j)
        level = float((room**2 / spread).min())
        return level, float(np.sqrt(level / np.linalg.eigvalsh(self.values["P"]).max()))


def design_observer(
    plant: Persidskii,
    generator: Generator,
    Pi: Any,
    *,
    gain: Any = None,
    decay: float = 0.0,
    solver: str = "CLARABEL",
    **bounds: float,
) -> ObserverDesign:
    """The gain M of observer (3.5) for the generator's state, with its certificate.

    Assumes that x = Pi w attracts the plant (Assumption 3.2.2), which needs a certificate of its own.
    Minimises a common bound of Gamma and Xi with Theta = I + c P, c = 2 ``decay``, in balanced units; the size
    of the gain is not minimised.

    z' = S0 z + S1 f(Jz) + G Y + E rho + M (Y - C0 Pi z - C1 f(Jz)) with z the estimate of w, M = P^-1 U.

    Parameters: ``gain`` M (q, p) to certify instead of computing one; ``decay`` in 1/s (1/step), demanded of
    the error; ``margin`` and ``kappa`` as for ``MatrixInequalities``.
    Raises InfeasibleError naming the undetectable eigenvalue before any solver runs; InfeasibleError,
    UndecidedError or CertificateError from the solver; ParameterError where slopes are not bounded.

    Reference: Khalin 2022, Theorem 3.2.1, (3.5)-(3.7).

    >>> plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0])
    >>> generator = Generator([[0.0]], L0=[1.0])
    >>> design = design_observer(plant, generator, [[1.0]], decay=2.0)
    >>> bool(design.gain[0, 0] > 2.0), min(design.margins.values()) > 0.0
    (True, True)
    >>> design_observer(plant, generator, [[0.0]])
    Traceback (most recent call last):
    pointpred.errors.InfeasibleError: (S0, C0 Pi) is not detectable: the mode of the eigenvalue 0 never shows
    """
    decay = positive("decay", decay, zero=True)
    connection = Interconnection(plant, generator, Pi)
    for name, d in connection.corners.items():
        pair = f"(S0 + S1 D J, C0 Pi + C1 D J), D = diag({name}),"
        sloped = (
            connection.g.S0 + connection.g.S1 @ d @ connection.j,
            connection.output + plant.C1 @ d @ connection.j,
        )
        require_detectable(*sloped, plant.time, pair)
    if not connection.corners:
        require_detectable(connection.g.S0, connection.output, plant.time, "(S0, C0 Pi)")
    require_map(plant, generator, connection.pi)
    q, p = connection.g.q, plant.p
    units = connection.units(decay)
    x, y, t = units.states, units.outputs, units.seconds
    c = 2.0 * decay * t if plant.time == "continuous" else 1.0 - float(np.exp(-2.0 * decay))
    fixed: dict[str, Any] = {
        "Theta": lambda v: np.eye(q) + c * v.P,
        "Gamma": lambda v: v.bound * np.eye(p),
        "Xi": lambda v: v.bound * np.eye(q),
    }
    problem = MatrixInequalities("Theorem 3.2.1", **bounds).positive("P", q).number("bound")
    if gain is None:
        problem.free("U", q, p)
    else:
        fixed_gain = matrix("gain", gain, q, p)
        inner_gain = inward(fixed_gain, x, y, t)
        fixed["U"] = lambda v: v.P @ inner_gain
    if connection.sloped and plant.time == "continuous":
        problem.symmetric("W", q)
    state = connection.inward(units).state(problem, **fixed)
    answer = state.solve(minimise=lambda v: v.bound, solver=solver).values
    inner = {**answer, **{name: function(_Attributes(answer)) for name, function in fixed.items()}}
    m = outward(np.linalg.solve(answer["P"], answer["U"]), x, y, t) if gain is None else fixed_gain
    values = {
        "P": form(inner["P"], x),
        "Theta": form(inner["Theta"], x, t),
        "Gamma": form(inner["Gamma"], y, t),
        "Xi": form(inner["Xi"], x, 1.0 / t),
    }
    if "W" in inner:
        values["W"] = form(inner["W"], x, t)
    values["U"] = values["P"] @ m
    # Audits the returned gain in the theorem as stated, not the solver's answer.
    margins = theorem_3_2_1(plant, generator, Pi, **bounds).check(values)
    bound = interconnection_bound(
        values["P"], values["Theta"], values["Gamma"], values["Xi"], time=plant.time, sharp=True
    )
    return ObserverDesign(m, values, margins, bound, plant, connection.g, connection.pi)


def require_map(plant: Persidskii, generator: Generator, Pi: FloatArray) -> None:
    """Raise InfeasibleError naming an equality of (3.3), or of Corollary 3.2.1, and its residual."""
    parts = (plant.A0, plant.A1, plant.B, plant.Q, generator.S0, Pi)
    size = max(np.abs(one).max(initial=0.0) for one in parts)
    for relaxed in (True, False):
        left = residuals(plant, generator, Pi, relaxed=relaxed)
        name = max(left, key=lambda one: float(np.abs(left[one]).max()))
        worst = float(np.abs(left[name]).max())
        if worst <= 1e-6 * max(1.0, float(size)):
            return
    raise InfeasibleError(f"Assumption 3.2.1: {name} = 0 fails, its residual is {worst:.6g}")


class _Attributes:
    def __init__(self, values: dict[str, Any]) -> None:
        self.__dict__.update(values)
