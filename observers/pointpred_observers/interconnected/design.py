"""The reduced-order observer of the interconnection: Theorem 3.2.1 with the sector as a decision variable."""

from __future__ import annotations

from copy import copy
from functools import partial
from operator import attrgetter
from typing import Any, ClassVar

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred.parameter import is_number
from pointpred.records import FloatArray
from pointpred_observers.interconnected.persidskii_stage import (
    UNUSED,
    MissingInputs,
    PersidskiiStage,
    alone,
    like,
    observed,
    same,
)
from pointpred_observers.interconnected.steady_state import equalities, shares_left, steady_state_map
from pointpred_observers.interconnected.tracking import closed_loop
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.eigenvalues import require_detectable, vertices
from pointpred_observers.numerics.equalities import TOLERANCE, largest, without_rounding
from pointpred_observers.numerics.matrices import dimensions, instance, matrix, positive, vector
from pointpred_observers.observer import Observer
from pointpred_observers.plants.documents import GeneratorDocument, PlantDocument
from pointpred_observers.plants.entries import (
    Document,
    Functions,
    Rows,
    Values,
    entries,
    finite,
    gap_of,
    matrices_of,
    plain,
)
from pointpred_observers.plants.generator import Fitted, Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant, constant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.bounds import ErrorBound, decay_of, eigenvalues, proved_bound, region, solved
from pointpred_observers.proofs.error_system import ErrorSystem, sloped_system
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import WORSE, Posed, cover, filter_start, middle, search
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting, run, sampled

DECAY_MOST = 12.0
"""Of a discrete observer, 1/step."""


class Interconnection:
    """The blocks of Theorem 3.2.1 as functions of P, U, Theta, ...

    ``j`` is J = H Pi, ``output`` C0 Pi; ``corners`` of the slopes, none if the blocks do not depend on f.
    """

    def __init__(self, plant: Plant, generator: Generator, Pi: Any) -> None:
        plant = constant(plant)
        if not plant.p:
            raise ParameterError("an observer needs an output: give the plant C0 or C1", field="C0")
        self.plant, self.g = plant, fitted(generator, plant)
        self.pi = matrix("Pi", Pi, plant.n, self.g.q)
        self.j: FloatArray = plant.H @ self.pi
        self.output: FloatArray = plant.C0 @ self.pi
        self.shown: FloatArray = plant.C1
        require_same_nonlinearity(plant, generator, self.pi)
        self.sloped = bool(self.g.S1.any() or plant.C1.any())
        self.slopes = plant.slopes if self.sloped else None
        self.corners = vertices(plant.slopes) if self.sloped else {}

    @property
    def copies(self) -> bool:
        """Whether the generator is a copy of the plant, so that w is x."""
        return np.array_equal(self.pi, np.eye(self.plant.n)) and np.array_equal(self.g.S0, self.plant.A0)

    def inward(self, units: Coordinates) -> Interconnection:
        """The same blocks in these units."""
        x, y, f, t = units.states, units.outputs, units.values, units.seconds
        other = copy(self)
        other.g = msgspec.structs.replace(
            self.g,
            S0=inward(self.g.S0, x, x, t),
            S1=inward(self.g.S1, x, f, t),
            G=inward(self.g.G, x, y, t),
        )
        other.j, other.output = inward(self.j, units.arguments, x), inward(self.output, y, x)
        other.shown = inward(self.shown, y, f)
        other.slopes = units.slopes(self.slopes)
        other.corners = vertices(other.slopes) if self.sloped else {}
        return other

    def weight(self, p: FloatArray, u: FloatArray) -> FloatArray:
        """F = P S1 - U C1, the weight of f."""
        block: FloatArray = p @ self.g.S1 - u @ self.shown
        return block

    def state(self, problem: MatrixInequalities, **fixed: Any) -> MatrixInequalities:
        """Add the theorem's inequalities to a problem; ``fixed`` holds functions of the unknowns.

        V' against Theta, Gamma, Gamma and Xi, with W - sym(F D J) at each corner D of the slopes; in discrete
        time V(e+) - V(e) against the same at each corner, by a Schur complement.
        """
        from scipy.linalg import block_diag

        g, discrete = self.g, self.plant.time == "discrete"

        def read(v: Any, *names: str) -> list[Any]:
            return [fixed[name](v) if name in fixed else getattr(v, name) for name in names]

        def lmi(v: Any, d: FloatArray | None = None) -> FloatArray:
            u, theta, gamma, xi = read(v, "U", "Theta", "Gamma", "Xi")
            inner = v.P @ g.S0 - u @ self.output
            across, disturbed = np.hstack([-v.P @ g.G, -u, v.P]), -block_diag(gamma, gamma, xi)
            if not discrete:
                upper = symmetric(2.0 * inner) + theta + (2.0 * v.W if self.sloped else 0.0)
                return np.block([[upper, across], [across.T, disturbed]])
            onward = np.hstack([inner if d is None else inner + self.weight(v.P, u) @ d @ self.j, across])
            return np.block([[block_diag(theta - v.P, disturbed), onward.T], [onward, -v.P]])

        def sector(v: Any, d: FloatArray) -> FloatArray:
            block: FloatArray = v.W - symmetric(self.weight(v.P, *read(v, "U")) @ d @ self.j)
            return block

        for name, d in self.corners.items():
            if discrete:
                problem.below(f"the LMI, D = diag({name})", partial(lmi, d=d))
            else:
                problem.above(f"W - sym(F D J), D = diag({name})", partial(sector, d=d), strict=False)
        if discrete and self.corners:
            return problem
        return problem.below("the LMI", lmi, strict=discrete)


def theorem_3_2_1(plant: Plant, generator: Generator, Pi: Any, *, F: Any = None) -> MatrixInequalities:
    """The inequalities of Theorem 3.2.1 for a plant, its generator and their steady-state map.

    Unknowns: P, Theta, Gamma, Xi, U, and W where f matters. F = P S1 - U C1 is not an unknown; if it is
    passed, the equality is required. e'F(f(Jw) - f(Jz)) <= e'We holds exactly if W >= sym(F D J) for each
    corner D of the slopes. In discrete time, for which the thesis has no such theorem, V(e+) - V(e) replaces
    V' at each corner.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], None, None, "sin", B=[1.0], C0=[1.0])
    >>> theorem = theorem_3_2_1(plant, Generator([[0.0]], L0=[1.0]), [[1.0]])
    >>> theorem.check({"P": 1.0, "Theta": 1.0, "Gamma": 9.0, "Xi": 4.0, "U": 2.0})["the LMI"] > 0.0
    True
    """
    connection = Interconnection(plant, generator, Pi)
    plant = connection.plant
    q, p = connection.g.q, plant.p
    problem = MatrixInequalities("Theorem 3.2.1").positive("P", q).symmetric("Theta", q)
    problem.symmetric("Gamma", p).symmetric("Xi", q).free("U", q, p)
    for name in ("Theta", "Gamma", "Xi"):
        problem.above(f"{name} > 0", attrgetter(name))
    if F is not None:
        f = matrix("F", F, q, plant.k)
        problem.equal("P S1 - U C1 - F", lambda v: connection.weight(v.P, v.U) - f)
    if connection.sloped and plant.time == "continuous":
        problem.symmetric("W", q)
    return connection.state(problem)


def symmetric(square: FloatArray) -> FloatArray:
    """The symmetric part."""
    half: FloatArray = 0.5 * (square + square.T)
    return half


class DrivenObserver(Observer, msgspec.Struct, frozen=True):
    """The observer of a generator's state w that drives the plant, x = Pi w, with its certificate.

    ``values``: its matrices by name. The disturbances of ``bound`` are v, the noise of Y, eps, by which the
    outputs differ from those of x = Pi w, and w of the generator's equation, as in ``error_system``. What is
    minimised, in balanced units, is a common bound of Gamma and Xi; ``gap``: how far the least one could lie
    below that of this design, relative to it; infinite if nothing is proved.

    Reference: Khalin 2022, Theorem 3.2.1, (3.5)-(3.7).
    """

    kind: ClassVar[str] = "driven"

    gain: FloatArray
    values: dict[str, Any]
    margins: dict[str, float]
    bound: ErrorBound
    plant: Persidskii
    generator: Fitted
    Pi: FloatArray
    gap: float = np.inf

    @property
    def bounds(self) -> dict[str, ErrorBound]:
        """The bound of w - w^."""
        return {"error": self.bound}

    @property
    def lyapunov(self) -> dict[str, FloatArray]:
        """The P of Theorem 3.2.1."""
        return {"": self.values["P"]}

    @property
    def chosen(self) -> dict[str, FloatArray]:
        """The gain."""
        return {"M": self.gain}

    def region(self, reach: Any) -> tuple[float, float]:
        """The region of validity, if abs(Jw) stays within ``reach`` >= 0 (one, or r) on the true trajectory.

        Returns the level c of the ellipsoid e'Pe <= c that keeps every argument within the plant's domain,
        and the radius of the largest ball of initial errors in it; both infinite if the domain is.
        Raises CertificateError if the trajectory leaves the domain, ParameterError for a ``reach`` that is
        no bound.
        """
        j = self.plant.H @ self.Pi
        reaches = vector("reach", np.full(len(j), reach) if is_number(reach) else reach, len(j))
        return region(self.values["P"], j, self.plant.domain, reaches)

    @classmethod
    def design(
        cls, plant: Plant, *, generator: Generator, Pi: Any = None, gain: Any = None, decay: float = 1.0
    ) -> DrivenObserver:
        """The observer z' = S0 z + S1 f(Jz) + G Y + E rho + M (Y - C0 Pi z - C1 f(Jz)), with its certificate.

        Assumes that x = Pi w attracts the plant (Assumption 3.2.2), which needs a certificate of its own.

        Parameters: ``Pi`` (n, q) with x = Pi w, by default that of ``steady_state_map``; ``gain`` M (q, p)
        to certify instead of computing one; ``decay`` in 1/s (1/step), demanded of the error. Raises
        InfeasibleError naming the undetectable eigenvalue or the equality of the map that fails, before any
        solver runs; what the solver raises; ParameterError where slopes are not bounded.
        """
        generator = instance("generator", generator, Generator)
        pi = steady_state_map(plant, generator).Pi if Pi is None else Pi
        return driven(plant, generator, pi, gain=gain, decay=decay)

    def error_system(self) -> ErrorSystem:
        """(3.6): w - w^, disturbed by ``v`` of Y, ``eps`` (v~ is v + eps) and ``w`` of the generator."""
        g, plant, m = self.generator, self.plant, self.gain
        return sloped_system(
            g.S0 - m @ plant.C0 @ self.Pi,
            without_rounding(g.S1 - m @ plant.C1, g.S1, m @ plant.C1),
            plant.H @ self.Pi,
            {"v": -(g.G + m), "eps": -m, "w": np.eye(g.q)},
            slopes=plant.slopes,
            time=plant.time,
            domain=plant.domain,
        )

    def stage(
        self, *, start: Any = None, step_s: float | None = None, gap_s: float | None = None
    ) -> PersidskiiStage:
        """Observer (3.5): inputs are Y, then rho; it returns w^, then x^ = Pi w^ of (3.7).

        A missing output is replaced by the one of the estimate, C0 Pi w + C1 f(Jw): no correction.
        """
        g, plant, m = self.generator, self.plant, self.gain
        return PersidskiiStage(
            g.S0 - m @ plant.C0 @ self.Pi,
            g.S1 - m @ plant.C1,
            plant.H @ self.Pi,
            np.hstack([g.G + m, g.E]),
            plant.f,
            R0=self._shown(),
            missing=MissingInputs.expected(plant.C0 @ self.Pi, plant.C1, plant.p + g.E.shape[1], plant.time),
            time=plant.time,
            start=start,
            step_s=step_s,
            gap_s=gap_s,
        )

    def _shown(self) -> FloatArray:
        return np.vstack([np.eye(self.generator.q), self.Pi])

    def simulated(self, plant: Any, setting: Setting) -> Simulation:
        """The plant with its generator, and the observer of both."""
        setting.refuse("a plant with a generator", *UNUSED)
        one, g = like(plant, self.plant), self.generator
        times = setting.samples(one.time == "discrete")
        moved = Generator(g.S0, g.S1, one.H @ self.Pi, g.G, g.L0, g.L1, g.E)
        alone = dimensions(setting.start) == 1 and len(setting.start) == one.n
        start = setting.begin(one.n if alone else one.n + g.q)
        if alone:  # the generator that fits the plant's state best
            start = np.concatenate([start, np.linalg.lstsq(self.Pi, start, rcond=None)[0]])
        rho, d = setting.signal("input", one.z), setting.signal("disturbance", one.n)

        def field(t: float, both: FloatArray) -> FloatArray:
            return closed_loop(one, moved, t, both, rho=rho(t), d=d(t))

        state, driving = np.split(run(field, start, times, one.time == "discrete"), [one.n], axis=1)
        inputs, stage = sampled(rho, times), self.stage(start=setting.begin(g.q, "estimate", 0.0))
        outputs, answers = observed(stage, one, times, state, inputs, setting)
        return Simulation.of(
            one, times, state, answers[:, g.q :], outputs, inputs, "observer of a driven plant",
            driving=driving, driving_estimate=answers[:, : g.q],
        )  # fmt: skip

    def document(self) -> DrivenDocument:
        """Plant, generator, map, gain, and the matrices of Theorem 3.2.1."""
        return DrivenDocument(
            plant=PlantDocument.of(self.plant),
            generator=GeneratorDocument.of(self.generator),
            Pi=entries(self.Pi),
            gain=entries(self.gain),
            certificate=plain({name: one for name, one in self.values.items() if name != "U"}),
            gap=finite(self.gap),
        )


class FullOrderObserver(DrivenObserver, frozen=True):
    """The observer of every state: a copy of the plant, corrected by its output.

    Theorem 3.2.1 with the plant itself as its generator and Pi = I, so that w is x: the inputs of B and of Q
    are both measured, and ``plant`` has them in its Q, those of B first.

    z' = A0 z + A1 f(Hz) + B u + Q rho + M (y - C0 z - C1 f(Hz))
    """

    kind: ClassVar[str] = "full"

    @classmethod
    def design(cls, plant: Plant, *, gain: Any = None, decay: float = 1.0) -> DrivenObserver:  # type: ignore[override]
        """The observer that estimates every state from the outputs and the known inputs.

        Parameters: ``gain`` (n, p) to certify instead of computing one.
        """
        one, decay = as_plant(plant), positive("decay", decay)
        inputs = np.hstack([one.B, one.Q])
        known = Persidskii(
            one.A0, one.A1, one.H, one.f, None, inputs, one.C0, one.C1, time=one.time, domain=one.domain
        )
        copied = Generator(one.A0, one.A1, one.H, E=inputs)
        return driven(known, copied, np.eye(one.n), gain=gain, decay=decay)

    def _shown(self) -> FloatArray:
        return np.eye(self.plant.n)

    def simulated(self, plant: Any, setting: Setting) -> Simulation:
        """The plant that nothing feeds back, with the bound where one is proved."""
        known = self.plant
        one = like(plant, known, apart=False)
        bound = None
        if setting.silent and np.isinf(known.domain) and same(one, known):
            times = setting.samples(one.time == "discrete")
            error = setting.begin(one.n, "estimate", 0.0) - setting.begin(one.n)
            bound = np.array([self.bound(float(t - times[0]), float(np.linalg.norm(error))) for t in times])
        return alone(one, self, setting, "full-order observer", bound)


class DrivenDocument(Document, tag="observer", frozen=True):
    """A ``DrivenObserver``, also one of full order."""

    plant: PlantDocument
    generator: GeneratorDocument
    Pi: Rows
    gain: Rows
    certificate: Values
    gap: float | None = None

    def made(self, functions: Functions) -> DrivenObserver:
        """The observer, audited."""
        plant, generator = self.plant.made(functions), self.generator.made(functions)
        q, p = generator.q, plant.p
        shapes = {"P": (q, q), "Theta": (q, q), "Gamma": (p, p), "Xi": (q, q), "W": (q, q)}
        values = matrices_of(self.certificate, shapes, optional=("W",))
        return certified_design(plant, generator, self.Pi, self.gain, values, gap_of(self.gap))


def driven(
    plant: Plant, generator: Generator, Pi: Any, *, gain: Any = None, decay: float = 0.0
) -> DrivenObserver:
    """The gain M of observer (3.5) for the generator's state, with its certificate; see ``DrivenObserver``.

    Minimises a common bound of Gamma and Xi with Theta = I + c P, c = 2 ``decay``, in balanced units (in
    discrete time Theta = s I + (1 - s) P, s = exp(-2 ``decay``)); the size of the gain is not minimised.
    ``gain`` M (q, p) to certify instead of computing one.
    """
    decay = positive("decay", decay, zero=True)
    connection = Interconnection(plant, generator, Pi)
    plant = connection.plant
    if plant.time == "discrete" and decay > DECAY_MOST:
        told = f"at most {DECAY_MOST:g} in discrete time, received {decay:g}: more is below rounding"
        raise ParameterError(f"decay must be {told}", field="decay", value=decay)
    g, j = connection.g, connection.j
    a, c, inner = ("A0", "C0", "H") if connection.copies else ("S0", "C0 Pi", "J")
    for name, d in (connection.corners or {"": np.zeros((plant.k, plant.r))}).items():
        sloped = f"({a} + {a[0]}1 D {inner}, {c} + C1 D {inner}), D = diag({name}),"
        pair = sloped if connection.corners else f"({a}, {c})"
        require_detectable(g.S0 + g.S1 @ d @ j, connection.output + plant.C1 @ d @ j, plant.time, pair)
    require_map(plant, generator, connection.pi)
    q, p = g.q, plant.p
    fixed_gain = None if gain is None else matrix("gain", gain, q, p)

    def posed(units: Coordinates) -> Posed:
        x, y, t = units.states, units.outputs, units.seconds
        # In discrete time the next V is at most (1 - c) V: what is spare beside it is measured in its size.
        discrete = plant.time == "discrete"
        spare = float(np.exp(-2.0 * decay)) if discrete else 1.0
        c = 1.0 - spare if discrete else 2.0 * decay * t
        fixed: dict[str, Any] = {
            "Theta": lambda v: spare * np.eye(q) + c * v.P,
            "Gamma": lambda v: v.bound * np.eye(p),
            "Xi": lambda v: v.bound * np.eye(q),
        }
        problem = MatrixInequalities("Theorem 3.2.1").positive("P", q).number("bound")
        inner, form, near = connection.inward(units), np.outer(x, x), None
        if fixed_gain is None:
            problem.free("U", q, p)
            near = _start(inner, decay if discrete else 0.5 * c, spare)
        else:
            inner_gain = inward(fixed_gain, x, y, t)
            fixed["U"] = lambda v: v.P @ inner_gain
        if connection.sloped and not discrete:
            problem.symmetric("W", q)
        measured = {
            "P": form,
            "Theta": t * form,
            "Gamma": t * np.outer(y, y),
            "Xi": form / t,
            "U": t * np.outer(x, y),
            "W": t * form,
        }
        return Posed(inner.state(problem, **fixed), measured, lambda v: v.bound, near, fixed)

    def audited(values: dict[str, Any], gap: float) -> DrivenObserver:
        u = values.pop("U")
        m = solved(values["P"], u) if fixed_gain is None else fixed_gain
        try:
            return certified_design(plant, generator, Pi, m, values, gap)
        except CertificateError:
            if fixed_gain is not None:
                raise
            # The rounding of a large M = P^-1 U can exceed the margins of U: that M needs a P of its own.
            again = driven(plant, generator, Pi, gain=m, decay=decay)
            return msgspec.structs.replace(again, gap=np.inf)

    seen, shown, slopes = connection.output, connection.shown, connection.slopes
    units = balanced(
        g.S0, seen=seen, driven=g.S1, shown=shown, inner=j, slopes=slopes, rates=(decay,), time=plant.time
    )
    return search(units, posed, audited, lambda found: np.log(max(found.bound.gains)), WORSE)


def certified_design(
    plant: Plant, generator: Generator, Pi: Any, gain: Any, values: dict[str, Any], gap: float = np.inf
) -> DrivenObserver:
    """The design of a gain M and of P, Theta, Gamma, Xi, and W where f matters, audited as stated; U = P M.

    Raises InfeasibleError for an equality of the map, CertificateError for an inequality that fails.
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
    full = connection.copies and not plant.m and np.array_equal(g.E, plant.Q)
    kind = FullOrderObserver if full else DrivenObserver
    return kind(m, values, margins, bound, plant, g, connection.pi, gap)


def require_map(plant: Persidskii, generator: Generator, Pi: FloatArray) -> None:
    """Raise InfeasibleError naming an equality of (3.3), or of Corollary 3.2.1, and its residual."""
    for relaxed in (True, False):
        found = equalities(plant, generator, Pi, relaxed=relaxed)
        failed = {name: part for name, part in shares_left(found).items() if not part <= TOLERANCE}
        if not failed:
            return
    name = max(failed, key=lambda one: failed[one])
    raise InfeasibleError(
        f"Assumption 3.2.1: {name} = 0 fails, its residual is {largest(found)[name]:.6g}, "
        f"{failed[name]:.1g} of its terms: take Pi from steady_state_map, with all digits"
    )


def _start(connection: Interconnection, decay: float, spare: float) -> dict[str, Any] | None:
    """The matrices of the stationary filter at the middle of the slopes, with room for Theta."""
    g, discrete = connection.g, connection.plant.time == "discrete"
    a, output = g.S0, connection.output
    if connection.sloped:
        slope = middle(connection.slopes) @ connection.j
        a, output = a + g.S1 @ slope, output + connection.shown @ slope
    if (start := filter_start(a, output, 1.01 * decay + 0.01, connection.plant.time)) is None:
        return None
    p, u = start
    if discrete:
        onward = p @ a - u @ output
        rest = spare * p - onward.T @ np.linalg.solve(p, onward)
    else:
        w = cover(p @ g.S1 - u @ connection.shown, connection.j, connection.slopes)
        upper = p @ g.S0 - u @ connection.output + w
        rest = -(upper + upper.T + 2.0 * decay * p)
    room = float(np.linalg.eigvalsh(0.5 * (rest + rest.T))[0])
    scale = max(1.0, 2.0 * spare / room) if room > 0.0 else 1.0
    values: dict[str, Any] = {"P": scale * p, "U": scale * u, "bound": 1.0}
    if connection.sloped and not discrete:
        values["W"] = scale * w
    return values
