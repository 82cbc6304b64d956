"""The reduced-order observer of the interconnection: Theorem 3.2.1 with the sector as a decision variable."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.balance import Coordinates, inward
from pointpred_observers.bounds import ErrorBound, decay_of, eigenvalues, proved_bound, region
from pointpred_observers.detectability import require_detectable
from pointpred_observers.equalities import TOLERANCE
from pointpred_observers.inequalities.definite import solved
from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.interconnected.generator import Fitted, Generator
from pointpred_observers.interconnected.interconnection import Interconnection, theorem_3_2_1
from pointpred_observers.interconnected.steady_state import relative_residuals
from pointpred_observers.linear_systems import Plant
from pointpred_observers.matrices import matrix, positive, vector
from pointpred_observers.persidskii import Persidskii
from pointpred_observers.search import Posed, search
from pointpred_observers.stationary import cover, filter_start, middle


class ObserverDesign(msgspec.Struct, frozen=True):
    """A gain with its certificate: matrices by name, ``margins`` by inequality, ``bound`` of the error.

    The disturbances of ``bound`` are v, the noise of Y, eps, by which the outputs differ from those of x = Pi
    w, and w of the generator's equation, as in ``error_system``.
    ``gap``: how far the least bound of Gamma and Xi in balanced units could lie below that of this design,
    relative to it; infinite if nothing is proved.
    """

    gain: FloatArray
    values: dict[str, Any]
    margins: dict[str, float]
    bound: ErrorBound
    plant: Persidskii
    generator: Fitted
    Pi: FloatArray
    gap: float = np.inf

    @property
    def full_order(self) -> bool:
        """Whether the generator is the plant itself, as ``design_full_order`` has it, so that w is x."""
        plant, g = self.plant, self.generator
        same = self.Pi.shape == (plant.n, plant.n) and np.array_equal(self.Pi, np.eye(plant.n))
        return bool(same and not plant.m and np.array_equal(g.S0, plant.A0) and np.array_equal(g.E, plant.Q))

    def region(self, reach: Any) -> tuple[float, float]:
        """The region of validity, if abs(Jw) stays within ``reach`` >= 0 (one, or r) on the true trajectory.

        Returns the level c of the ellipsoid e'Pe <= c that keeps every argument within the plant's domain,
        and the radius of the largest ball of initial errors in it; both infinite if the domain is.
        Raises CertificateError if the trajectory itself leaves the domain, ParameterError for a ``reach``
        that is no bound.
        """
        j = self.plant.H @ self.Pi
        reaches = vector("reach", np.full(len(j), reach) if is_number(reach) else reach, len(j))
        return region(self.values["P"], j, self.plant.domain, reaches)


def design_observer(
    plant: Plant,
    generator: Generator,
    Pi: Any,
    *,
    gain: Any = None,
    decay: float = 0.0,
) -> ObserverDesign:
    """The gain M of observer (3.5) for the generator's state, with its certificate.

    Assumes that x = Pi w attracts the plant (Assumption 3.2.2), which needs a certificate of its own.
    Minimises a common bound of Gamma and Xi with Theta = I + c P, c = 2 ``decay``, in balanced units; the
    size of the gain is not minimised.

    z' = S0 z + S1 f(Jz) + G Y + E rho + M (Y - C0 Pi z - C1 f(Jz)) with z the estimate of w, M = P^-1 U.

    Parameters: ``gain`` M (q, p) to certify instead of computing one; ``decay`` in 1/s (1/step), demanded of
    the error.
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
    plant = connection.plant
    copy = np.array_equal(connection.pi, np.eye(plant.n)) and np.array_equal(connection.g.S0, plant.A0)
    for name, d in connection.corners.items():
        pair = "(A0 + A1 D H, C0 + C1 D H)" if copy else "(S0 + S1 D J, C0 Pi + C1 D J)"
        sloped = (
            connection.g.S0 + connection.g.S1 @ d @ connection.j,
            connection.output + plant.C1 @ d @ connection.j,
        )
        require_detectable(*sloped, plant.time, f"{pair}, D = diag({name}),")
    if not connection.corners:
        require_detectable(
            connection.g.S0, connection.output, plant.time, "(A0, C0)" if copy else "(S0, C0 Pi)"
        )
    require_map(plant, generator, connection.pi)
    q, p = connection.g.q, plant.p
    fixed_gain = None if gain is None else matrix("gain", gain, q, p)

    def posed(units: Coordinates) -> Posed:
        x, y, t = units.states, units.outputs, units.seconds
        c = 2.0 * decay * t if plant.time == "continuous" else 1.0 - float(np.exp(-2.0 * decay))
        fixed: dict[str, Any] = {
            "Theta": lambda v: np.eye(q) + c * v.P,
            "Gamma": lambda v: v.bound * np.eye(p),
            "Xi": lambda v: v.bound * np.eye(q),
        }
        problem = MatrixInequalities("Theorem 3.2.1").positive("P", q).number("bound")
        if fixed_gain is None:
            problem.free("U", q, p)
        else:
            inner_gain = inward(fixed_gain, x, y, t)
            fixed["U"] = lambda v: v.P @ inner_gain
        if connection.sloped and plant.time == "continuous":
            problem.symmetric("W", q)
        inner, form = connection.inward(units), np.outer(x, x)
        measured = {
            "P": form,
            "Theta": t * form,
            "Gamma": t * np.outer(y, y),
            "Xi": form / t,
            "U": t * np.outer(x, y),
            "W": t * form,
        }
        near = _start(inner, c) if fixed_gain is None else None
        return Posed(inner.state(problem, **fixed), measured, lambda v: v.bound, near, fixed)

    def audited(values: dict[str, Any], gap: float) -> ObserverDesign:
        u = values.pop("U")
        if fixed_gain is not None:
            return certified_design(plant, generator, Pi, fixed_gain, values, gap)
        m = solved(values["P"], u)
        try:
            return certified_design(plant, generator, Pi, m, values, gap)
        except CertificateError:
            # The rounding of a large M = P^-1 U can exceed the margins of U: that M needs a P of its own.
            again = design_observer(plant, generator, Pi, gain=m, decay=decay)
            return msgspec.structs.replace(again, gap=np.inf)

    return search(connection.units(decay), posed, audited)


def certified_design(
    plant: Plant,
    generator: Generator,
    Pi: Any,
    gain: Any,
    values: dict[str, Any],
    gap: float = np.inf,
) -> ObserverDesign:
    """The design of a gain M and of matrices from any source, audited in the theorem as stated.

    Parameters: ``values`` P, Theta, Gamma, Xi, and W where f matters; U = P M is computed. Raises
    InfeasibleError for an equality of the map that does not hold, CertificateError naming the inequality that
    fails.
    """
    connection = Interconnection(plant, generator, Pi)
    plant, g = connection.plant, connection.g
    require_map(plant, generator, connection.pi)
    m = matrix("gain", gain, g.q, plant.p)
    values = {**values, "U": values["P"] @ m}
    theorem = theorem_3_2_1(plant, generator, Pi)
    margins = theorem.check(values, printed=False)
    # M runs, not P^-1 U: the rounding of P M counts as well, large beside U where P is nearly singular.
    theorem.unknowns.computed("U", np.abs(values["P"]) @ np.abs(m))
    theorem.check(values, printed=False)
    # V' <= -e'Theta e + max Gamma (abs(v)^2 + abs(v + eps)^2) + max Xi abs(w)^2, the first v only through G.
    noise, drive = eigenvalues("Gamma", values["Gamma"])[-1], eigenvalues("Xi", values["Xi"])[-1]
    decay = decay_of(values["P"], values["Theta"], plant.time)
    drives = {"v": 2.0 * noise if g.G.any() else noise, "eps": noise, "w": drive}
    bound = proved_bound(values["P"], decay, drives, plant.time)
    return ObserverDesign(m, values, margins, bound, plant, g, connection.pi, gap)


def require_map(plant: Persidskii, generator: Generator, Pi: FloatArray) -> None:
    """Raise InfeasibleError naming an equality of (3.3), or of Corollary 3.2.1, and its residual.

    Each entry must hold to ``TOLERANCE`` of its own terms: a large entry elsewhere, such as a B for inputs in
    small units, says nothing about it.
    """
    for relaxed in (True, False):
        left = relative_residuals(plant, generator, Pi, relaxed=relaxed)
        failed = {name: (worst, part) for name, (worst, part) in left.items() if not part <= TOLERANCE}
        if not failed:
            return
    name = max(failed, key=lambda one: failed[one][1])
    worst, part = failed[name]
    raise InfeasibleError(
        f"Assumption 3.2.1: {name} = 0 fails, its residual is {worst:.6g}, {part:.1g} of its terms: "
        "take Pi from steady_state_map, with all digits"
    )


def _start(connection: Interconnection, c: float) -> dict[str, Any] | None:
    """The matrices of the stationary filter at the middle of the slopes, with room for Theta = I + c P."""
    g, discrete = connection.g, connection.plant.time == "discrete"
    slope = middle(connection.slopes) @ connection.j if connection.sloped else None
    a = g.S0 if slope is None else g.S0 + g.S1 @ slope
    output = connection.output if slope is None else connection.output + connection.shown @ slope
    rate = -0.5 * float(np.log1p(-c)) if discrete else 0.5 * c
    start = filter_start(a, output, 1.01 * rate + 0.01, connection.plant.time)
    if start is None:
        return None
    p, u = start
    if discrete:
        onward = p @ a - u @ output
        rest = (1.0 - c) * p - onward.T @ np.linalg.solve(p, onward)
        w = None
    else:
        w = cover(p @ g.S1 - u @ connection.shown, connection.j, connection.slopes)
        upper = p @ g.S0 - u @ connection.output + w
        rest = -(upper + upper.T + c * p)
    room = float(np.linalg.eigvalsh(0.5 * (rest + rest.T))[0])
    scale = max(1.0, 2.0 / room) if room > 0.0 else 1.0
    values: dict[str, Any] = {"P": scale * p, "U": scale * u, "bound": 1.0}
    if connection.sloped and w is not None:
        values["W"] = scale * w
    return values
