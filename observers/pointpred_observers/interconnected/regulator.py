"""Dynamic regulators (3.8): an observer of the plant, a feedback of its state, and a reference."""

from __future__ import annotations

from math import exp
from typing import Any, ClassVar

import msgspec
import numpy as np

from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred.records import FloatArray
from pointpred_observers.interconnected.design import DrivenDocument, DrivenObserver, driven, require_map
from pointpred_observers.interconnected.persidskii_stage import PersidskiiStage, closed, like, regulator_stage
from pointpred_observers.interconnected.steady_state import (
    RegulatorEquations,
    checked_equations,
    regulator_equations,
)
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.eigenvalues import number_text, undetectable, vertices
from pointpred_observers.numerics.equalities import (
    NO_DIGIT,
    TOLERANCE,
    or_one,
    share_of_terms,
    summed,
    without_rounding,
)
from pointpred_observers.numerics.matrices import flag, instance, matrix, positive
from pointpred_observers.observer import Observer
from pointpred_observers.plants.documents import GeneratorDocument, PlantDocument
from pointpred_observers.plants.entries import (
    Document,
    Functions,
    Rows,
    Values,
    entries,
    fields_of,
    matrices_of,
    plain,
)
from pointpred_observers.plants.generator import Fitted, Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant, constant
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.proofs.bounds import ErrorBound, solved
from pointpred_observers.proofs.error_system import (
    DecayCertificate,
    ErrorSystem,
    certified_decay,
    certify_decay,
    sloped_system,
)
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import Posed, search
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting

ROOM = 1.01
"""The feedback is designed for a decay larger by this factor than the certified one."""


class StateFeedback(msgspec.Struct, frozen=True):
    """u = L0 x + L1 f(Hx), and the certificate of x' = (A0 + B L0) x + (A1 + B L1) f(Hx) + d."""

    L0: FloatArray
    L1: FloatArray
    certificate: DecayCertificate


def design_state_feedback(plant: Plant, *, decay: float = 1.0, L1: Any = None) -> StateFeedback:
    """The feedback u = L0 x + L1 f(Hx) of small gain with which any two solutions approach each other.

    Assumes that the state is known; ``design(plant, "regulator")`` needs the output only. With f = m s + df,
    m the middle of each slope and abs(df_j) <= delta_j abs(s_j), delta half its width, Y = (L0 + L1 m H) X
    and Z = L1 T the condition is linear:

    ((sym(2 (A0 + A1 m H) X + 2 B Y) + 2 decay X, A1 T + B Z, X H' delta), (., -T, 0), (., 0, -T)) < 0

    with X > 0 and a diagonal T > 0; in discrete time the corresponding inequality of the next state.
    Minimises abs(u)^2 over the ellipsoid x'X^-1 x + df'T^-1 df <= 1 in balanced units. One function of
    Lyapunov for all slopes: a refusal does not prove that no feedback exists unless f is absent.

    Parameters: ``decay`` in 1/s (1/step), > 0; ``L1`` (m, k) if it is chosen already: zeros, or one that
    cancels A1, for which slopes are not needed.
    Raises InfeasibleError naming a mode that no input moves before any solver runs; what the solver raises;
    ParameterError for a plant without input, with varying matrices, or slopes that are not bounded.

    Reference: Boyd, El Ghaoui, Feron, Balakrishnan 1994, section 7.2.

    >>> mass = Persidskii([[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0], [1.0, 0.0], "sin", [0.0, 1.0])
    >>> feedback = design_state_feedback(mass, decay=1.0)
    >>> round(feedback.certificate.bound.decay, 6), min(feedback.certificate.margins.values()) > 0.0
    (1.0, True)
    """
    decay = positive("decay", decay)
    one = constant(plant)
    if not one.B.any():
        raise ParameterError("a feedback needs an input: give the plant a B other than 0", field="B")
    l1 = np.zeros((one.m, one.k)) if L1 is None else matrix("L1", L1, one.m, one.k)
    a1 = without_rounding(one.A1 + one.B @ l1, one.A1, one.B @ l1)
    corners = vertices(one.slopes) if a1.any() else {"": np.zeros((one.k, one.r))}
    for name, d in corners.items():
        for mode in undetectable((one.A0 + a1 @ d @ one.H).T, one.B.T, one.time):
            corner = f" at D = diag({name})" if name else ""
            raise InfeasibleError(f"no input moves the mode of the eigenvalue {number_text(mode)}{corner}")
    middle, half, slope = np.zeros(one.k), np.zeros(one.k), np.zeros((one.k, one.n))
    if a1.any():
        low, high = np.array(one.slopes).reshape(-1, 2).T
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        slope = middle[:, None] * one.H
    used = (half > 0.0) & a1.any(axis=0)  # elsewhere f is linear, or has no effect
    drift, acting, inner = one.A0 + a1 @ slope, a1[:, used], half[used, None] * one.H[used]
    free = L1 is None and bool(used.any())

    def posed(units: Coordinates) -> Posed:
        x, f, t = units.states, units.values, units.seconds
        b = inward(one.B, x, np.ones(one.m), t)
        u = 1.0 / or_one(np.abs(b).max(axis=0, initial=0.0))
        scaled = (inward(drift, x, x, t), b * u, inward(acting, x, f, t), inward(inner, f, x))
        measured = {
            "X": 1.0 / np.outer(x, x),
            "Y": 1.0 / np.outer(u, x),
            "Z": 1.0 / np.outer(u, f),
            "T": 1.0 / np.outer(f, f),
        }
        problem = _inequalities(*scaled, ROOM * decay * t, one.time, free)
        return Posed(problem, measured, lambda v: v.size)

    def audited(values: dict[str, Any], _: float) -> StateFeedback:
        l0, whole = solved(values["X"], values["Y"].T).T, l1.copy()
        sizes = np.sqrt(np.diag(values["X"]))
        terms = np.abs(l0 * sizes).max(axis=1, initial=0.0)[:, None] / sizes
        l0 = without_rounding(l0, terms, share=NO_DIGIT)
        if free:
            whole[:, used] = values["Z"] / np.diag(values["T"])
            l0 = l0 - whole @ slope
        return StateFeedback(l0, whole, certify_decay(closed_system(one, l0, whole), decay=decay))

    slopes, rates = ((0.0, 1.0),) * len(inner), (ROOM * decay,)
    units = balanced(
        drift, driven=acting, inner=inner, moved=one.B, slopes=slopes, rates=rates, time=one.time
    )
    return search(units, posed, audited)


def closed_system(plant: Persidskii, L0: FloatArray, L1: FloatArray) -> ErrorSystem:
    """The system of the difference of two solutions under the feedback."""
    whole = without_rounding(plant.A1 + plant.B @ L1, plant.A1, plant.B @ L1)
    return sloped_system(
        plant.A0 + plant.B @ L0,
        whole,
        plant.H,
        {"d": np.eye(plant.n)},
        slopes=plant.slopes,
        time=plant.time,
        domain=plant.domain,
    )


def _inequalities(
    a: FloatArray, b: FloatArray, a1: FloatArray, h: FloatArray, decay: float, time: str, free: bool
) -> MatrixInequalities:
    """The condition for abs(df_j) <= abs(h_j x), and the size of the input over the ellipsoid."""
    from scipy.linalg import block_diag

    (n, m), k = b.shape, a1.shape[1]
    problem = MatrixInequalities("state feedback").positive("X", n).free("Y", m, n).number("size")
    problem.diagonal("T", k).above("T > 0", lambda v: v.T)
    if free:
        problem.free("Z", m, k)

    def onward(v: Any) -> FloatArray:
        return np.hstack([a @ v.X + b @ v.Y, a1 @ v.T + (b @ v.Z if free else 0.0)])

    def continuous(v: Any) -> FloatArray:
        moved = onward(v)
        first = moved[:, :n] + moved[:, :n].T + 2.0 * decay * v.X
        across = np.hstack([moved[:, n:], v.X @ h.T])
        return np.block([[first, across], [across.T, -np.kron(np.eye(2), v.T)]])

    def discrete(v: Any) -> FloatArray:
        moved = np.vstack([onward(v), np.hstack([h @ v.X, np.zeros((k, k))])])
        before, after = block_diag(-exp(-2.0 * decay) * v.X, -v.T), block_diag(-v.X, -v.T)
        return np.block([[before, moved.T], [moved, after]])

    def input_size(v: Any) -> FloatArray:
        u = np.hstack([v.Y, v.Z if free else np.zeros((m, k))])
        return np.block([[v.size * np.eye(m), u], [u.T, block_diag(v.X, v.T)]])

    problem.below("the closed loop", discrete if time == "discrete" else continuous)
    return problem.above("the input's size", input_size, strict=False)


class Regulator(Observer, msgspec.Struct, frozen=True):
    """A regulator, and what proves that x follows Pi w.

    ``observer`` certifies z = x - Pi w: z' = (A0 - Pi G C0) z + (A1 - Pi G C1) df + d - Pi G v, its bound's
    ``w`` being d and its ``v`` the noise v. ``feedback`` certifies Pi w, driven by Pi G (C0 z + C1 df + v): a
    cascade, so that both approach their steady state. With a reference, the last states of w are the
    reference's, and ``equations`` are those that they satisfy.
    """

    kind: ClassVar[str] = "regulator"

    plant: Persidskii
    regulator: Generator
    Pi: FloatArray
    observer: DrivenObserver
    feedback: StateFeedback
    equations: RegulatorEquations | None = None

    @property
    def margins(self) -> dict[str, float]:
        """Those of the observer and of the feedback."""
        parts = {"observer": self.observer.margins, "feedback": self.feedback.certificate.margins}
        return {f"{part}: {name}": one for part, each in parts.items() for name, one in each.items()}

    @property
    def gap(self) -> float:
        """That of the observer."""
        return self.observer.gap

    @property
    def bounds(self) -> dict[str, ErrorBound]:
        """Of x - Pi w, and of Pi w, which x - Pi w and v drive as d; x is their sum."""
        one = self.observer.bound  # its generator is the plant itself, so that its w is the plant's d
        names = tuple("d" if name == "w" else name for name in one.disturbances)
        error = msgspec.structs.replace(one, disturbances=names)
        return {"x - Pi w": error, "Pi w": self.feedback.certificate.bound}

    @property
    def lyapunov(self) -> dict[str, FloatArray]:
        """One of the observer, and one of the feedback."""
        return {"observer: ": self.observer.values["P"], "feedback: ": self.feedback.certificate.P}

    @property
    def chosen(self) -> dict[str, FloatArray]:
        """Of the observer, and of the feedback."""
        return {"G": self.observer.gain, "L0": self.feedback.L0}

    @classmethod
    def design(
        cls,
        plant: Plant,
        *,
        decay: float = 1.0,
        observer_decay: float | None = None,
        L1: Any = None,
        reference: Generator | None = None,
        following: tuple[Any, Any] | None = None,
    ) -> Regulator:
        """The regulator w' = S0 w + S1 f(Jw) + G Y + E rho, u = L0 w + L1 f(Jw), with proofs.

        Without ``reference`` Pi = I: w is an observer of the plant, and u feeds it back: S0 = A0 + B L0 - G
        C0, S1 = A1 + B L1 - G C1, J = H, E = Q. G comes from ``driven``, L0 and L1 from
        ``design_state_feedback``; x - w does not depend on the feedback.

        With a ``reference`` r' = Sr r + Er rho and ``following`` = (R, F), R x approaches F r: w = (w1, r),
        Pi = (I 0), u = K w1 + (Lr - K Pir) r + L1 f(H w1), Pir and Lr from ``regulator_equations``. This
        needs a nonlinearity that the input can cancel, A1 + B L1 = 0, or none; else R x would have a steady
        state that is not linear in r.

        Proves more than Corollary 3.2.2 by other conditions: slopes may change sign. ``certify_tracking`` may
        refuse what is proved here, as its Assumption 3.2.3 needs J S~ < 0.

        Parameters: ``decay`` in 1/s (1/step) of the closed loop and, unless ``observer_decay`` is given, of x
        - w; ``L1`` as for ``design_state_feedback``. Raises what that, ``driven`` and ``regulator_equations``
        raise, InfeasibleError where f is not cancelled.

        Reference: Khalin 2022, section 3.2.3, (3.8), (3.12)-(3.15).
        """
        one, decay = as_plant(plant), positive("decay", decay)
        faster = decay if observer_decay is None else positive("observer_decay", observer_decay)
        if (reference is None) != (following is None):
            raise ParameterError("give reference and following = (R, F) together: R x is to follow F r")
        if reference is not None:
            instance("reference", reference, Generator)
        copied = Generator(one.A0, one.A1, one.H, E=one.Q)
        observer = driven(one, copied, np.eye(one.n), decay=faster)
        if reference is None:
            feedback = design_state_feedback(one, decay=decay, L1=L1)
            none = np.zeros((0, 0)), np.zeros((0, one.z)), np.zeros((one.m, 0))
            return cls(one, *_regulator(one, observer.gain, feedback, *none), observer, feedback)
        if reference.S1 is not None and reference.S1.any():
            raise ParameterError("a reference is linear, r' = Sr r + Er rho: leave out S1", field="S1")
        equations = regulator_equations(one, reference, following=following)
        cancelling = equations.L1 if L1 is None else L1
        feedback = design_state_feedback(one, decay=decay, L1=cancelling)
        left, terms = summed((one.A1,), (one.B, feedback.L1))
        if not share_of_terms(left, terms) <= TOLERANCE:
            raise InfeasibleError(
                f"a reference needs A1 + B L1 = 0 to cancel f, its residual is {np.abs(left).max():.6g}"
            )
        straight, r = equations.L0 - feedback.L0 @ equations.Pi, fitted(reference, one, "reference")
        regulator, pi = _regulator(one, observer.gain, feedback, r.S0, r.E, straight)
        return cls(one, regulator, pi, observer, feedback, equations)

    def error_system(self) -> ErrorSystem:
        """That of x - Pi w."""
        return self.observer.error_system()

    def stage(
        self,
        *,
        estimate: bool = False,
        start: Any = None,
        step_s: float | None = None,
        gap_s: float | None = None,
    ) -> PersidskiiStage:
        """Regulator (3.8): inputs are Y, then rho; it returns u, and behind it Pi w if ``estimate``."""
        shown = self.Pi if flag("estimate", estimate) else None
        return regulator_stage(self.plant, self.regulator, shown, start=start, step_s=step_s, gap_s=gap_s)

    def simulated(self, plant: Any, setting: Setting) -> Simulation:
        """The plant under its regulator."""
        return closed(like(plant, self.plant), self.regulator, self.Pi, setting)

    def document(self) -> RegulatorDocument:
        """Its observer, plant and feedback, and the regulator with its map."""
        feedback, solved = self.feedback, self.equations
        return RegulatorDocument(
            observer=self.observer.document(),
            regulator=GeneratorDocument.of(self.regulator),
            Pi=entries(self.Pi),
            plant=PlantDocument.of(self.plant),
            feedback=Feedback(
                L0=entries(feedback.L0),
                L1=entries(feedback.L1),
                decay=feedback.certificate.bound.decay,
                certificate=plain(feedback.certificate.values),
            ),
            equations=None if solved is None else Equations(**fields_of(Equations, solved)),
        )


def _regulator(
    plant: Persidskii, gain: FloatArray, feedback: StateFeedback, s_r: Any, e_r: Any, straight: Any
) -> tuple[Generator, FloatArray]:
    """The regulator from (3.3) with Pi = (I 0): the reference's states, fed ``straight``, behind its own."""
    n, q = plant.n, len(s_r)
    pi, g = np.eye(n, n + q), np.vstack([gain, np.zeros((q, plant.p))])
    whole = np.block([[plant.A0 + plant.B @ feedback.L0, plant.B @ straight], [np.zeros((q, n)), s_r]])
    s1 = plant.A1 + plant.B @ feedback.L1 - gain @ plant.C1
    return Generator(
        whole - g @ plant.C0 @ pi,
        np.vstack([s1, np.zeros((q, plant.k))]),
        plant.H @ pi,
        g,
        np.hstack([feedback.L0, straight]),
        feedback.L1,
        np.vstack([plant.Q, e_r]),
    ), pi


class Feedback(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A ``StateFeedback``: u = L0 x + L1 f(Hx), and what proves its decay."""

    L0: Rows
    L1: Rows | None
    decay: float
    certificate: Values


class Equations(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """``RegulatorEquations``: the matrices, of which everything else is computed again."""

    Pi: Rows
    L0: Rows
    L1: Rows | None
    R: Rows
    F: Rows


class RegulatorDocument(Document, tag="regulator", frozen=True):
    """A ``Regulator``: its observer with the plant, its feedback, and the regulator with its map."""

    observer: DrivenDocument
    regulator: GeneratorDocument
    Pi: Rows
    plant: PlantDocument
    feedback: Feedback
    equations: Equations | None = None

    def made(self, functions: Functions) -> Regulator:
        """The design: both proofs audited, and whether the regulator is the one that they speak of."""
        plant, regulator = self.plant.made(functions), self.regulator.made(functions)
        observer, pi = self.observer.made(functions), matrix("Pi", self.Pi, plant.n, regulator.q)
        _require_plant(observer, plant)
        require_same_nonlinearity(plant, regulator, pi, "regulator")
        require_map(plant, regulator, pi)
        l0 = matrix("L0", self.feedback.L0, plant.m, plant.n)
        l1 = _shaped(self.feedback.L1, plant)
        g = regulator.beside(plant)
        if regulator.J is None:  # that of the plant
            own_f, time = regulator.f, regulator.time
            regulator = Generator(g.S0, g.S1, plant.H @ pi, g.G, g.L0, g.L1, g.E, own_f, time=time)
        own = {"G": (g.G[: plant.n], observer.gain), "L0": (g.L0[:, : plant.n], l0), "L1": (g.L1, l1)}
        for name, (left, right) in own.items():
            if not np.array_equal(left, right):
                raise CertificateError(
                    f"{name} of the regulator is not the {name} that was certified", field=name
                )
        system = closed_system(plant, l0, l1)
        numbers = tuple(f"bound_{i}" for i in range(len(system.disturbances)))
        values = matrices_of(self.feedback.certificate, {"P": (plant.n, plant.n)}, numbers)
        proof = certified_decay(system, values, self.feedback.decay)
        feedback = StateFeedback(l0, l1, proof)
        return Regulator(plant, regulator, pi, observer, feedback, self._equations(plant, g, l0))

    def _equations(self, plant: Persidskii, g: Fitted, l0: FloatArray) -> RegulatorEquations | None:
        """The equations, checked: the reference's states are the last ones of the regulator."""
        solved = self.equations
        if solved is None:
            return None
        s0 = g.S0[plant.n :, plant.n :]
        l1 = _shaped(solved.L1, plant)
        checked = checked_equations(plant, s0, solved.Pi, solved.L0, l1, solved.R, solved.F)
        straight = g.L0[:, plant.n :]
        if not share_of_terms(*summed((straight,), (-checked.L0,), (l0, checked.Pi))) <= TOLERANCE:
            raise CertificateError(
                "L0 of the regulator does not apply the L0 and Pi of its equations: design it again",
                field="equations.L0",
            )
        return checked


def _shaped(l1: Rows | None, plant: Persidskii) -> FloatArray:
    return np.zeros((plant.m, plant.k)) if l1 is None else matrix("L1", l1, plant.m)


def _require_plant(observer: DrivenObserver, plant: Persidskii) -> None:
    """Raise CertificateError unless the observer estimates the states of this very plant."""
    if not np.array_equal(observer.Pi, np.eye(plant.n)):
        raise CertificateError(
            "the observer's Pi is not the identity: a regulator's observer estimates the plant's own states",
            field="observer.Pi",
        )
    own, ours = observer.plant.matrices(0.0), plant.matrices(0.0)
    different = [name for name in own if not np.array_equal(own[name], ours[name])]
    settings = ("time", "domain", "slopes")
    different += [name for name in settings if getattr(observer.plant, name) != getattr(plant, name)]
    different += ["f"] if observer.plant.f.codes != plant.f.codes else []
    if different:
        raise CertificateError(
            f"{different[0]} of observer.plant is not the {different[0]} of plant: design it again",
            field=f"observer.plant.{different[0]}",
        )
