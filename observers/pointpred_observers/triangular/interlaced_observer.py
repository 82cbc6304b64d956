"""Section 4.4: Assumption 4.4.2, and the reduced-order observer (4.16) of an interlaced system.

w' = A w + L (y - C w) is followed from the outputs, then the maps of the steady state are evaluated.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from itertools import product
from typing import Any, ClassVar, Self

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.errors import (
    DivergenceError,
    EventError,
    EventOrderError,
    InfeasibleError,
    ParameterError,
    UndecidedError,
)
from pointpred.records import BoolArray, FloatArray
from pointpred.regression.least_squares import moment
from pointpred_observers.interconnected.persidskii_law import STEPS_MOST
from pointpred_observers.interconnected.persidskii_stage import MissingInputs, PersidskiiStage
from pointpred_observers.numerics.balance import Coordinates, balanced, inward
from pointpred_observers.numerics.eigenvalues import hidden, perron_root, require_detectable
from pointpred_observers.numerics.equalities import NO_DIGIT
from pointpred_observers.numerics.matrices import instance, matrix, positive
from pointpred_observers.observer import Observer
from pointpred_observers.plants.documents import SteadyStateDocument
from pointpred_observers.plants.entries import (
    Document,
    Functions,
    Values,
    finite,
    gap_of,
    matrices_of,
    parsed,
    plain,
)
from pointpred_observers.plants.symbolic import (
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    symbolic,
)
from pointpred_observers.proofs.bounds import ErrorBound, decay_of, eigenvalues, proved_bound, solved
from pointpred_observers.proofs.error_system import DecayCertificate, ErrorSystem, certify_decay
from pointpred_observers.proofs.matrix_inequalities import MatrixInequalities
from pointpred_observers.proofs.search import Posed, filter_start, search
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting, Signal, run
from pointpred_observers.triangular.forms import StateRegion, enclosure, interlaced, intervals_of

SMALL = 1e-3
"""Weight of the size of U, which decides among gains with the same traces."""
DEGREE = 3
"""Of the power series of the steady state."""
STEP = 0.01
"""A step of the integration, of the fastest time constant: it errs by 1e-12 of w."""
TERMS_MOST = 8
"""Most different terms of the Jacobian of Assumption 4.4.2: each doubles the number of corners."""
RESIDUAL_PARTS = 256
"""Parts of the box over which a residual is enclosed: a long expression, of which the size will do."""


class InterlacedCertificate(msgspec.Struct, frozen=True):
    """P, Q, Gamma and U of the theorem with recomputed margins, L = P^-1 U, and the proved bound.

    ``bound`` of e = w - w_hat for ``v``, the error of y: noise, and the plant's distance from its steady
    state. Its decay is lambda_min(P^-1 Q) / 2 in 1/s, its overshoot sqrt(lambda_max(P) / lambda_min(P)) and
    its gain sqrt(lambda_max(Gamma) / (2 decay lambda_min(P))). The print has the first root upside down and
    leaves out lambda_min(Q) under the second. ``gap``: how far the least trace of P and Gamma in balanced
    units could lie below that of these, relative; infinite if nothing is proved.
    """

    P: Any
    Q: Any
    Gamma: Any
    U: Any
    L: Any
    margins: dict[str, float]
    bound: ErrorBound
    gap: float = np.inf

    @classmethod
    def audited(cls, a: ArrayLike, c: ArrayLike, values: dict[str, Any], gap: float = np.inf) -> Self:
        """The certificate of matrices; raises CertificateError where an inequality fails."""
        margins = theorem_4_4_1(a, c).check(values)
        decay = decay_of(values["P"], values["Q"], "continuous")
        bound = proved_bound(values["P"], decay, {"v": eigenvalues("Gamma", values["Gamma"])[-1]})
        return cls(**values, L=solved(values["P"], values["U"]), margins=margins, bound=bound, gap=gap)


def theorem_4_4_1(a: ArrayLike, c: ArrayLike) -> MatrixInequalities:
    """Theorem 4.4.1 as a problem in P, Q, Gamma and U, with strict inequalities."""
    system = matrix("A", a)
    output = matrix("C", c, None, len(system))
    p, q = output.shape

    def block(v: Any) -> FloatArray:
        corner = v.P @ system - v.U @ output
        return np.block([[corner + corner.T + v.Q, -v.U], [-v.U.T, -v.Gamma]])

    problem = MatrixInequalities("Theorem 4.4.1").positive("P", q)
    problem.symmetric("Q", q).symmetric("Gamma", p).free("U", q, p)
    problem.above("Q", lambda v: v.Q).above("Gamma", lambda v: v.Gamma)
    return problem.below("the matrix of (4.16)", block)


def certify(
    a: ArrayLike, c: ArrayLike, *, decay: float = 0.5, gain: ArrayLike | None = None
) -> InterlacedCertificate:
    """Compute a gain with its certificate, or a certificate for ``gain``.

    Minimises the trace of P and Gamma in balanced units, for little overshoot and noise, and beside it the
    size of U. That the plant converges to its steady state is assumption 4.4.2 and not checked.

    Parameters: ``a`` (q, q) of the generator; ``c`` (p, q) with h(rho, pi) = C w; ``decay`` in 1/s, above 0,
    of the error; ``gain`` L (q, p). Raises InfeasibleError naming an undetectable eigenvalue before any
    solver runs; what the solver raises; ParameterError. Reference: Khalin 2022, Theorem 4.4.1.

    >>> found = certify([[0.0, 1.0], [-1.0, 0.0]], [[1.0, 0.0]], decay=0.25)
    >>> found.L.round(2).tolist(), round(found.bound.overshoot, 2)
    ([[1.0], [0.25]], 1.28)
    """
    system = matrix("A", a)
    output = matrix("C", c, None, len(system))
    decay = positive("decay", decay)
    require_detectable(system, output, "continuous", "(A, C)")
    fixed = None if gain is None else matrix("gain", gain, len(system), len(output))

    def posed(units: Coordinates) -> Posed:
        x, y, t = units.states, units.outputs, units.seconds
        a, c = inward(system, x, x, t), inward(output, y, x)
        problem = theorem_4_4_1(a, c)
        problem.above("Q - 2 decay P", lambda v: v.Q - 2.0 * decay * t * v.P)
        if fixed is not None:
            inner = inward(fixed, x, y, t)
            problem.equal("U = P L", lambda v: v.U - v.P @ inner)

        def room(v: Any) -> FloatArray:
            return np.block([[v.size * np.eye(len(c)), v.U.T], [v.U, np.eye(len(a))]])

        problem.number("size").above("size - U'U", room, strict=False)
        form = np.outer(x, x)
        measured = {"P": form, "Q": t * form, "Gamma": t * np.outer(y, y), "U": t * np.outer(x, y)}
        near = _start(a, c, decay * t) if fixed is None else None
        return Posed(problem, measured, lambda v: np.trace(v.P) + np.trace(v.Gamma) + SMALL * v.size, near)

    units = balanced(system, seen=output, rates=(decay,))
    try:
        return search(units, posed, partial(InterlacedCertificate.audited, system, output))
    except InfeasibleError as failure:
        still = hidden(system, output, "continuous", least=NO_DIGIT)
        modes = still if fixed is None else np.linalg.eigvals(system - fixed @ output).tolist()
        if any(one.real >= -decay for one in modes):
            raise
        # Every faster error has a P (Lyapunov): the proof holds for condition numbers of the search only.
        raise UndecidedError(f"decay = {decay:g} is too large for the arithmetic: {failure}") from failure


def _start(a: FloatArray, c: FloatArray, decay: float) -> dict[str, Any] | None:
    """The matrices of the stationary filter, and a Gamma that is large enough for them."""
    if (start := filter_start(a, c, 1.2 * decay, "continuous")) is None:
        return None
    p, u = start
    corner, q = p @ a - u @ c, 2.2 * decay * p
    gamma = 2.0 * u.T @ np.linalg.pinv(-(corner + corner.T + q)) @ u + np.eye(len(c))
    size = 1.1 * float(np.linalg.norm(u, 2)) ** 2
    return {"P": p, "Q": q, "Gamma": 0.5 * (gamma + gamma.T), "U": u, "size": size}


def output_matrix(steady: SymbolicSteadyState) -> FloatArray:
    """C with h(rho, pi) = C w; raises ParameterError for an output that is not linear in w."""
    states = instance("steady", steady, SymbolicSteadyState).generator.states
    if not steady.system.outputs:
        raise ParameterError("an observer needs outputs of the system, received none")
    rows = []
    for number, output in enumerate(steady.outputs(), 1):
        row = [symbolic().diff(output, w) for w in states]
        linear = sum((c * w for c, w in zip(row, states, strict=True)), symbolic().Integer(0))
        if any(c.free_symbols for c in row) or symbolic().expand(output - linear) != 0:
            raise ParameterError(f"output {number} must be C w with numbers C, received {output}")
        rows.append([float(c) for c in row])
    return np.array(rows)


class InterlacedEstimate(msgspec.Struct, frozen=True):
    """The generator's state w, the plant's state x = pi(w), its zero dynamics z = rho(w) and input l(w)."""

    t: float
    w: tuple[float, ...]
    x: tuple[float, ...]
    z: tuple[float, ...]
    input: float


class InterlacedObserver(Observer, msgspec.Struct, frozen=True):
    """The observer w' = A w + L (y - C w), x = pi(w), z = rho(w), u = l(w) of a driven plant.

    Assumes that the plant converges to its steady state (assumption 4.4.2): its distance from it is an
    error of y. If the steady state is a truncated series, x and z are accurate near the origin only.

    Parameters: ``steady`` whose outputs must be C w; ``certificate`` with L, from ``certify``; ``start`` of
    w; ``gap_s`` s, by default none: over a longer interval between two samples the generator runs alone.
    Reference: Khalin 2022, Theorem 4.4.1.

    >>> import sympy as sp
    >>> from pointpred_observers import SymbolicGenerator
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2**2, -x2 + u), u, outputs=(x2,))
    >>> steady = interlaced(plant, SymbolicGenerator((w1, w2), (w2, -w1)), 1, w1, degree=2)
    >>> stage = InterlacedObserver.design(steady, decay=0.5).stage()
    >>> for i in range(4000):
    ...     estimate = stage.update(np.cos(0.01 * i), 0.01 * i)
    >>> true = steady.function()((np.cos(39.99), -np.sin(39.99)))
    >>> round(estimate.x[0], 4), round(float(true[0]), 4)
    (0.2887, 0.2887)
    """

    kind: ClassVar[str] = "interlaced"
    steady: SymbolicSteadyState
    certificate: InterlacedCertificate
    start: FloatArray
    gap_s: float | None = None

    @classmethod
    def design(
        cls,
        plant: SymbolicSystem | SymbolicSteadyState,
        *,
        generator: SymbolicGenerator | None = None,
        first: Any = None,
        upper: int = 0,
        degree: int | None = DEGREE,
        decay: float = 1.0,
        gain: ArrayLike | None = None,
        start: ArrayLike | None = None,
        gap_s: float | None = None,
    ) -> Self:
        """The observer of a plant that comes to a steady state under a generator, with its certificate.

        Parameters: ``plant``, or its steady state from ``interlaced``, which needs none of the next four;
        ``generator`` that drives it; ``first`` the steady state of the first lower row, an expression or its
        text, such as "w1"; ``upper`` rows of the upper part; ``degree`` of their power series; ``gain`` (q,
        p) to certify; ``start`` of w, default zeros; ``gap_s``: over a longer interval between two samples
        the generator runs alone. Raises what ``certify`` and ``interlaced`` raise.
        """
        if isinstance(plant, SymbolicSystem):
            moved = instance("generator", generator, SymbolicGenerator)
            steady = interlaced(plant, moved, upper, _first(first, moved), degree=degree)
        else:
            steady = instance("plant", plant, SymbolicSteadyState)
        output = output_matrix(steady)
        certificate = certify(steady.generator.matrix(), output, decay=decay, gain=gain)
        q = len(certificate.L)
        begin = np.zeros(q) if start is None else matrix("start", start, q, 1).ravel()
        return cls(steady, certificate, begin, gap_s)

    @property
    def plant(self) -> SymbolicSystem:
        """The plant whose states are estimated."""
        return self.steady.system

    @property
    def chosen(self) -> dict[str, FloatArray]:
        """The gain."""
        return {"L": np.asarray(self.certificate.L)}

    def error_system(self) -> ErrorSystem:
        """The system of w - w_hat, disturbed by ``v``, the error of y."""
        gain = self.certificate.L
        a = self.steady.generator.matrix() - gain @ output_matrix(self.steady)
        return ErrorSystem(a[None], -gain[None], np.eye(len(a)), ("",), {"v": gain.shape[1]}, "continuous")

    def stage(self, *, start: Any = None, gap_s: float | None = None) -> InterlacedStage:
        """The observer as a stage on samples, with another ``start`` or ``gap_s``."""
        return InterlacedStage(
            self, self.start if start is None else start, self.gap_s if gap_s is None else gap_s
        )

    def simulated(self, plant: Any, setting: Setting) -> Simulation:
        """The plant from a start of its own, under the input l(w) of the steady state."""
        setting.refuse("a symbolic plant", "unknown_input", "schedule", "input")
        system, steady = instance("plant", plant, SymbolicSystem), self.steady
        if system.parameters():
            raise ParameterError(
                f"parameters without value: {sorted(map(str, system.parameters()))}", field="plant"
            )
        sizes = [(len(one.states), len(one.zero), len(one.outputs)) for one in (system, steady.system)]
        if sizes[0] != sizes[1]:
            raise ParameterError(
                "the observer was designed for {} states, {} of zero dynamics and {} outputs, received a "
                "plant of {}, {} and {}".format(*sizes[1], *sizes[0]),
                field="plant",
            )
        times, q, n = setting.samples(discrete=False), len(steady.generator.states), sum(sizes[0][:2])
        field = driven_field(steady, system, setting.signal("disturbance", n))
        both = run(field, setting.begin(q + n), times, discrete=False)
        driving, state = both[:, :q], both[:, q:]
        outputs = setting.measured(outputs_of(system, state))
        stage = self.stage(start=setting.begin(q, "estimate", 0.0))
        answers = stage.walk(np.zeros(len(times), np.bool_), np.column_stack([times, outputs]))
        names = tuple(str(one) for one in (*system.states, *system.zero))
        pushed = steady.function()(driving.T)[-1][:, None]
        return Simulation(
            times, state, answers[:, q:-1], outputs, pushed, names, "interlaced observer", False,
            driving=driving, driving_estimate=answers[:, :q],
        )  # fmt: skip

    def document(self) -> InterlacedDocument:
        """The steady state, and the matrices of the theorem; a stage's memory of samples is not kept."""
        proof = self.certificate
        return InterlacedDocument(
            steady=SteadyStateDocument.of(self.steady),
            certificate=plain({name: getattr(proof, name) for name in ("P", "Q", "Gamma", "U")}),
            gap=finite(proof.gap),
            start=self.start.tolist(),
            gap_s=self.gap_s,
        )


class InterlacedDocument(Document, tag="interlaced observer", frozen=True):
    """An ``InterlacedObserver``."""

    steady: SteadyStateDocument
    certificate: Values
    start: list[float]
    gap_s: float | None = None
    gap: float | None = None

    def made(self, functions: Functions) -> InterlacedObserver:
        """The observer: the equations of its maps and its inequalities audited."""
        steady = self.steady.made(functions)
        a, c = steady.generator.matrix(), output_matrix(steady)
        q, p = len(a), len(c)
        values = matrices_of(self.certificate, {"P": (q, q), "Q": (q, q), "Gamma": (p, p), "U": (q, p)})
        proof = InterlacedCertificate.audited(a, c, values, gap_of(self.gap))
        return InterlacedObserver(steady, proof, matrix("start", self.start, q, 1).ravel(), self.gap_s)


def _first(given: Any, generator: SymbolicGenerator) -> Any:
    """The steady state of the first lower row; raises ParameterError for another symbol than those of w."""
    if given is None:
        raise ParameterError("give first, the steady state of the first lower row, such as w1", field="first")
    first = parsed(given, "first") if isinstance(given, str) else given
    foreign: set[Any] = getattr(first, "free_symbols", set()) - set(generator.states)
    if foreign:
        raise ParameterError(
            f"first may hold the generator's states {', '.join(map(str, generator.states))}, received "
            f"{given!r} with {', '.join(sorted(map(str, foreign)))}",
            field="first",
        )
    return first


class InterlacedStage:
    """An interlaced observer as a stage on irregular samples.

    Between two samples y is linear. Over an interval longer than ``gap_s``, or without a measurement at one
    end, the generator runs alone; it bridges 1000 of its fastest time constants. After a longer interval w
    restarts, which without ``gap_s`` is refused. The equation of w is integrated in compiled code; values of
    the maps that are not finite are NaN.

    Parameters: ``observer`` the design; ``start`` of w; ``gap_s`` s. Raises ParameterError, and EventError
    and EventOrderError from ``update``.
    """

    def __init__(self, observer: InterlacedObserver, start: ArrayLike, gap_s: float | None = None) -> None:
        steady, gain = observer.steady, observer.certificate.L
        a, c = steady.generator.matrix(), output_matrix(steady)
        q, p = gain.shape
        closed = a - gain @ c
        step_s = min(STEP / max(perron_root(closed), perron_root(a), 1e-290), 1e12)
        self._bridged = STEPS_MOST * step_s
        self._gap = np.inf if gap_s is None else min(positive("gap_s", gap_s), self._bridged)
        self.observer = observer
        begin, missing = matrix("start", start, q, 1).ravel(), MissingInputs.expected(c, np.zeros((p, 0)), p)
        self._generator = PersidskiiStage(
            closed, None, None, gain, "sin", start=begin, missing=missing, step_s=step_s
        )
        self._last: float | None = None
        self._maps = _numerical(steady)
        self.width = q + len(steady.maps) + len(steady.zero_maps) + 1

    def update(self, y: ArrayLike | None, t: float) -> InterlacedEstimate:
        """The estimate after the outputs at ``t`` s, NaN where one is missing, ``None`` for all.

        Raises EventError for values that are not finite or of another length and for too long an interval,
        EventOrderError when time runs backwards; the stage is then unchanged.
        """
        now = moment(t, self._last)
        before, passed = self._generator.remembered(), 0.0 if self._last is None else now - self._last
        try:
            if self._gap < passed <= self._bridged:
                self._generator.update(now, None)
            elif passed > self._gap:
                self._generator.reset()
            w = self._generator.update(now, y)
        except (DivergenceError, EventError):
            self._generator.recall(before)
            raise
        self._last, n = now, len(self.observer.steady.maps)
        with np.errstate(all="ignore"):
            maps = self._maps(w)
        *values, push = np.where(np.isfinite(maps), maps, np.nan).tolist()
        return InterlacedEstimate(now, tuple(w.tolist()), tuple(values[:n]), tuple(values[n:]), push)

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Rows (w, x, z, u) for rows (t, outputs), starting again before each that is marked ``begin``.

        NaN where time runs backwards; the rows after it are taken. Raises EventError as ``update`` does.
        """
        out = np.full((len(rows), self.width), np.nan)
        for i, (t, *y) in enumerate(rows.tolist()):
            if begin[i]:
                self.reset()
            with suppress(EventOrderError):
                found = self.update(y, t)
                out[i] = [*found.w, *found.x, *found.z, found.input]
        return out

    def reset(self) -> None:
        """Forget every sample."""
        self._generator.reset()
        self._last = None

    def fresh(self) -> Self:
        """A stage of the same design that remembers no sample."""
        twin = copy.copy(self)
        twin.reset()
        return twin

    def __getstate__(self) -> dict[str, Any]:
        """A memory of its own, and everything but the function, which sympy makes again."""
        return {**self.__dict__, "_generator": copy.copy(self._generator), "_maps": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._maps = _numerical(self.observer.steady)


def _numerical(steady: SymbolicSteadyState) -> Callable[[Any], FloatArray]:
    """The maps as a function of w; raises ParameterError where one has no values."""
    try:
        maps = steady.function()
        with np.errstate(all="ignore"):
            maps(np.zeros(len(steady.generator.states)))
    except (NameError, TypeError, AttributeError, NotImplementedError, SyntaxError) as unusable:
        raise ParameterError(
            f"the maps hold a function that has no numerical form: {unusable}; give it one by sympy's "
            "implemented_function"
        ) from unusable
    return maps


def driven_field(
    steady: SymbolicSteadyState, system: SymbolicSystem, disturbance: Signal
) -> Callable[[float, Any], FloatArray]:
    """Generator and plant together, states (w, x, z), under the input of the steady state."""
    sp, w = symbolic(), steady.generator.states
    drive = sp.lambdify(w, steady.generator.field, modules="math")
    push = sp.lambdify(w, steady.input, modules="math")
    states = (*system.states, *system.zero)
    plant = sp.lambdify((*states, system.input), (*system.field, *system.zero_field), modules="math")

    def field(t: float, both: Any) -> FloatArray:
        numbers = np.asarray(both).tolist()
        driving, x = numbers[: len(w)], numbers[len(w) :]
        moved = np.array(plant(*x, push(*driving))) + disturbance(t)
        return np.concatenate([drive(*driving), moved])

    return field


def outputs_of(system: SymbolicSystem, states: FloatArray) -> FloatArray:
    """The outputs without noise, (N, p), of states (N, n), x before z."""
    names = (*system.states, *system.zero)
    columns = symbolic().lambdify(names, system.outputs, modules="numpy")(*states.T)
    return np.stack([np.broadcast_to(one, len(states)) for one in columns], axis=-1)


class AttractionCertificate(msgspec.Struct, frozen=True):
    """Both parts of Assumption 4.4.2: ``C`` of h(rho, pi) = C w, and that x - pi(w), z - rho(w) decay.

    ``terms``: the terms of the Jacobian that vary, with their bounds over the ``region``; the ``certificate``
    holds while the plant's state, its steady state and w stay in it. ``residual``: the largest norm there of
    what a truncated steady state leaves of its equations; its effect is in ``bound``.
    """

    C: FloatArray
    certificate: DecayCertificate
    terms: dict[str, tuple[float, float]]
    region: dict[str, tuple[float, float]]
    residual: float = 0.0

    @property
    def bound(self) -> ErrorBound:
        """The bound of x - pi(w), z - rho(w), for ``d`` in their equations."""
        return self.certificate.bound


def assumption_4_4_2(
    steady: SymbolicSteadyState, region: StateRegion = None, *, decay: float | None = None
) -> AttractionCertificate:
    """A certificate of Assumption 4.4.2 in a region: detectable output, incrementally stable plant.

    1. h(rho(w), pi(w)) must be C w with (A, C) detectable. 2. Under u = l(w) two solutions of the plant
    approach each other, up to a disturbance d of its equations: their difference obeys the Jacobian somewhere
    in the box, each term of which lies between its bounds there; one quadratic function for all corners of
    these bounds is a proof. The residuals of a steady state that is not exact are a disturbance d that never
    ends: the bound holds the largest over the region. A refusal proves nothing unless it names an eigenvalue
    at a point of the region.

    Parameters: ``region`` of the states x and z and of the generator's w that the Jacobian or the residuals
    contain, each (low, high), by symbol or by name; not needed for a linear plant; ``decay`` in 1/s, > 0, by
    default a fraction of the slowest corner's. Raises InfeasibleError naming the undetectable mode;
    ParameterError for an output that is not C w, a missing bound or more than 8 terms; what
    ``certify_decay`` raises.

    Reference: Khalin 2022, Assumption 4.4.2; Lohmiller and Slotine 1998.

    >>> import sympy as sp
    >>> from pointpred_observers import SymbolicGenerator, SymbolicSystem, interlaced
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2**2, -x2 + u), u, outputs=(x2,))
    >>> steady = interlaced(plant, SymbolicGenerator((w1, w2), (w2, -w1)), upper=1, first=w1, degree=2)
    >>> found = assumption_4_4_2(steady, {x2: (-1.0, 1.0)}, decay=0.5)
    >>> found.C.tolist(), {name: [round(one, 6) for one in pair] for name, pair in found.terms.items()}
    ([[1.0, 0.0]], {'x2': [-1.0, 1.0]})
    """
    c = output_matrix(steady)
    require_detectable(steady.generator.matrix(), c, "continuous", "(A, C)")
    system, states = steady.system, (*steady.system.states, *steady.system.zero)
    if parameters := system.parameters() - {*steady.generator.states}:
        raise ParameterError(f"parameters without value: {sorted(map(str, parameters))}")
    box = {} if region is None else intervals_of(region, (*states, *steady.generator.states))
    n = len(states)
    # The Jacobian under u = l(w): a constant part, and the coefficients of each term that varies.
    constant, terms = np.zeros((n, n)), dict[Any, FloatArray]()
    for (i, row), (j, state) in product(enumerate((*system.field, *system.zero_field)), enumerate(states)):
        entry = symbolic().expand(symbolic().diff(row, state).subs(system.input, steady.input))
        for summand in symbolic().Add.make_args(entry):
            factor, term = summand.as_independent(*summand.free_symbols, as_Add=False)
            if summand.free_symbols:
                terms.setdefault(term, np.zeros((n, n)))[i, j] += float(factor)
            else:
                constant[i, j] += float(summand)
    if len(terms) > TERMS_MOST:
        raise ParameterError(
            f"the Jacobian has {len(terms)} different terms, at most {TERMS_MOST} are allowed: "
            f"{', '.join(map(str, terms))}"
        )
    ranges = {term: enclosure(term, box) for term in terms}
    names, corners = [], []
    for chosen in product(*ranges.values()):
        corners.append(sum((v * slope for v, slope in zip(chosen, terms.values(), strict=True)), constant))
        names.append(", ".join(f"{term} = {v:.6g}" for term, v in zip(terms, chosen, strict=True)))
    drive = np.broadcast_to(np.eye(n), (len(corners), n, n)).copy()
    errors = ErrorSystem(np.array(corners), drive, np.eye(n), tuple(names), {"d": n}, "continuous")
    try:
        found = certify_decay(errors, decay=decay)
    except ArithmeticError as failure:
        raise type(failure)(f"Assumption 4.4.2: {failure}") from failure
    ends = [enclosure(one, box, RESIDUAL_PARTS) for one in steady.residuals if one != 0]
    residual = float(np.linalg.norm([max(-low, high) for low, high in ends]))
    rest = found.bound.gains[0] * residual
    found = msgspec.structs.replace(found, bound=msgspec.structs.replace(found.bound, rest=rest))
    named, within = ({str(one): pair for one, pair in part.items()} for part in (ranges, box))
    return AttractionCertificate(c, found, named, within, residual)
