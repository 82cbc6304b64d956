"""The reduced-order observer of an interlaced system (4.16) as a stage on irregular samples.

w' = A w + L (y - C w) is followed exactly, then the maps of the steady state are evaluated.
"""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, isfinite
from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError
from pointpred.layout import Layout
from pointpred.parameter import parameter
from pointpred.records import BoolArray, FloatArray, FloatTable
from pointpred.regression.least_squares import moment
from pointpred.stage import CompiledStage, loop_into
from pointpred_observers.matrices import instance, matrix
from pointpred_observers.triangular.interlaced_certificate import InterlacedCertificate, certify
from pointpred_observers.triangular.polynomials import symbolic
from pointpred_observers.triangular.program import ROW, computable, execute, program
from pointpred_observers.triangular.system import SymbolicSteadyState

TAKEN, BACKWARDS = 0, 1
"""Results of a step."""

ORDER = 14
"""Terms of the exponential series; with a norm of at most 1/2 the remainder is below 1e-16."""
NEGLIGIBLE = 1e-18
"""Fraction of the estimate below which the remainder of the series is negligible."""
STEPS_MOST = 4096
"""Most sub-steps of one interval; after a longer one the estimate restarts."""
NEVER = 1e300
"""A time that no interval reaches, s."""


class Head(Layout):
    """What the memory begins with: sizes, places in the memory, times and rates."""

    states: float
    """Of the generator, q."""
    outputs: float
    rows: float
    """Of the program of the maps; where it begins."""
    program: float
    answers: float
    """Where the values of the maps stand, and how many they are."""
    answered: float
    state: float
    """Where ``State`` begins."""
    gap_s: float
    """The longest interval over which outputs are interpolated."""
    fast: float
    """The largest row sums of A - L C and of A, 1/s."""
    slow: float


class State(Layout):
    """Whether there was a sample, its time, whether it had outputs; y, w and the series' vectors follow."""

    started: float
    t: float
    measured: float


class Parts(NamedTuple):
    """What has sizes that are known at run time: the start of w and the matrices, the last outputs and w.

    ``closed`` is A - L C; ``term`` and ``after`` (q) are for the series; ``answers`` are the maps' values.
    """

    start: FloatArray
    A: FloatTable
    closed: FloatTable
    L: FloatTable
    y: FloatArray
    w: FloatArray
    term: FloatArray
    after: FloatArray
    program: FloatTable
    answers: FloatArray


@law
def settings(q: int, p: int) -> int:
    """Floats before the program."""
    return Head.length + q + 2 * q * q + q * p


@law
def states(q: int, p: int) -> int:
    """Floats of the state, with two scratch vectors, before the program's registers."""
    return State.length + p + 3 * q


@law
def parts_of(memory: FloatArray) -> Parts:
    """The parts in their places."""
    head = Head(memory)
    q, p, rows = int(head.states), int(head.outputs), int(head.rows)
    a_at = Head.length + q
    closed_at = a_at + q * q
    l_at = closed_at + q * q
    y_at = int(head.state) + State.length
    w_at = y_at + p
    program_at, answers_at = int(head.program), int(head.answers)
    return Parts(
        memory[Head.length : a_at],
        memory[a_at:closed_at].reshape(q, q),
        memory[closed_at:l_at].reshape(q, q),
        memory[l_at : l_at + q * p].reshape(q, p),
        memory[y_at:w_at],
        memory[w_at : w_at + q],
        memory[w_at + q : w_at + 2 * q],
        memory[w_at + 2 * q : w_at + 3 * q],
        memory[program_at : program_at + ROW * rows].reshape(rows, ROW),
        memory[answers_at : answers_at + int(head.answered)],
    )


@law
def drive(parts: Parts, i: int, k: int, passed: float, share: float, row: FloatArray) -> float:
    """The part of L y in row i of the first two derivatives, y linear between the two samples."""
    total = 0.0
    for j in range(len(parts.y)):
        rise = row[1 + j] - parts.y[j]
        total += parts.L[i, j] * (parts.y[j] + passed * rise if k == 1 else share * rise)
    return total


@law
def follow(parts: Parts, h: float, steps: int, row: FloatArray, driven: bool) -> None:
    """Follow w' = (A - L C) w + L y over ``h`` s by the exponential series, w' = A w unless ``driven``."""
    q = len(parts.w)
    matrix = parts.closed if driven else parts.A
    for n in range(steps):
        for k in range(1, ORDER + 1):
            source = parts.w if k == 1 else parts.term
            for i in range(q):
                total = drive(parts, i, k, n / steps, 1.0 / steps, row) if driven and k <= 2 else 0.0
                for j in range(q):
                    total += matrix[i, j] * source[j]
                parts.after[i] = total * h / (steps * k)
            moved, most = 0.0, 0.0
            for i in range(q):
                parts.term[i] = parts.after[i]
                parts.w[i] += parts.after[i]
                moved = max(moved, abs(parts.after[i]))
                most = max(most, abs(parts.w[i]))
            if k > 2 and moved <= NEGLIGIBLE * most:
                break


@law
def step(memory: FloatArray, row: FloatArray, out: FloatArray) -> int:
    """Process t and the outputs (NaN: not measured) into ``out``; an earlier t changes nothing.

    Over an interval longer than ``gap_s``, or without a measurement at one end, the generator runs alone.
    """
    head, parts = Head(memory), parts_of(memory)
    s = State(memory, int(head.state))
    h, started = row[0] - s.t, s.started == 1.0
    if started and h < 0.0:
        return BACKWARDS
    measured = True
    for j in range(len(parts.y)):
        if row[1 + j] != row[1 + j]:
            measured = False
    driven = measured and s.measured == 1.0 and h <= head.gap_s
    steps = max(1.0, ceil(2.0 * h * (head.fast if driven else head.slow)))
    if started and steps <= STEPS_MOST:
        follow(parts, h, int(steps), row, driven)
    else:
        for i in range(len(parts.w)):
            parts.w[i] = parts.start[i]
    s.started, s.t, s.measured = 1.0, row[0], 1.0 if measured else 0.0
    for j in range(len(parts.y)):
        parts.y[j] = row[1 + j] if measured else 0.0
    execute(memory, parts.program)
    q = len(parts.w)
    for i in range(q):
        out[i] = parts.w[i]
    for i in range(len(parts.answers)):
        out[q + i] = parts.answers[i]
    return TAKEN


class InterlacedEstimate(msgspec.Struct, frozen=True):
    """The generator's state w, the plant's state x = pi(w), its zero dynamics z = rho(w) and input l(w)."""

    t: float
    w: tuple[float, ...]
    x: tuple[float, ...]
    z: tuple[float, ...]
    input: float


class InterlacedObserver(CompiledStage):
    """Estimate the state of a plant from that of the generator which drives it.

    Assumes that the plant converges to its steady state (assumption 4.4.2): its distance from it is an
    error of y. Between two samples y is linear. An interval longer than ``gap_s``, by default none, or
    without a measurement at one end, is bridged by the generator alone; after more than 2048 time constants
    of the generator w restarts. Without ``gap_s`` an interval of more than 2048 time constants is refused. If
    the steady state is a truncated series, x and z are accurate near the origin only. Values that are not
    finite are NaN. Maps that hold a function which the compiled law does not know are evaluated by sympy's
    numpy functions, some five times slower.

    w' = A w + L (y - C w), x = pi(w), z = rho(w), u = l(w), followed exactly.

    Parameters: ``steady`` whose outputs must be C w; ``certificate`` with L, from ``certify``; ``start`` of
    w, default zeros; ``gap_s`` s, 1e-12 to 1e12. Memory: 13 + 4 q + 2 q^2 + p + p q floats and the program of
    the maps. Returns ``InterlacedEstimate`` from ``update``. Raises ParameterError, and EventError and
    EventOrderError from ``update``. Reference: Khalin 2022, Theorem 4.4.1.

    >>> import sympy as sp
    >>> from pointpred_observers.triangular.forms import interlaced
    >>> from pointpred_observers.triangular.system import SymbolicGenerator, SymbolicSystem
    >>> x1, x2, u, w1, w2 = sp.symbols("x1 x2 u w1 w2")
    >>> plant = SymbolicSystem((x1, x2), (-x1 + x2**2, -x2 + u), u, outputs=(x2,))
    >>> steady = interlaced(plant, SymbolicGenerator((w1, w2), (w2, -w1)), 1, w1, degree=2)
    >>> observer = InterlacedObserver.design(steady)
    >>> for i in range(4000):
    ...     estimate = observer.update(np.cos(0.01 * i), 0.01 * i)
    >>> true = steady.function()((np.cos(39.99), -np.sin(39.99)))
    >>> round(estimate.x[0], 4), round(float(true[0]), 4)
    (0.2887, 0.2887)
    """

    gap_s: float | None = parameter(
        "s", 1e-12, 1e12, "over a longer gap the generator runs alone", default=None, absent=NEVER
    )
    loop = staticmethod(loop_into(step))

    def __init__(
        self,
        steady: SymbolicSteadyState,
        certificate: InterlacedCertificate,
        *,
        start: ArrayLike | None = None,
        **values: float | None,
    ) -> None:
        self.declare(**values)
        a, c = steady.generator.matrix(), output_matrix(steady)
        q, p = len(a), len(c)
        gain = matrix("L", certificate.L, q, p)
        first = np.zeros(q) if start is None else matrix("start", start, q, 1).ravel()
        wanted = (*steady.maps, *steady.zero_maps, steady.input)
        self._function: Callable[[Any], FloatArray] | None = None
        if not computable(wanted):
            self._function, wanted = evaluable(steady), ()
        maps = program(steady.generator.states, wanted)
        state = settings(q, p) + ROW * len(maps.rows) + len(maps.constants)
        computed = state + states(q, p)
        rows = maps.placed(state + State.length + p, state - len(maps.constants), computed)
        closed = a - gain @ c
        speeds = [float(np.abs(one).sum(axis=1).max()) for one in (closed, a)]
        answers = computed + maps.computed - maps.outputs
        gap = NEVER if self.gap_s is None else self.gap_s
        self._bridged = STEPS_MOST / (2.0 * max(*speeds, 1e-290))
        shape = [q, p, len(maps.rows), settings(q, p), answers, maps.outputs, state, gap, *speeds]
        flat = np.concatenate([shape, first, a.ravel(), closed.ravel(), gain.ravel(), rows, maps.constants])
        self.steady, self.certificate, self.start = steady, certificate, first
        self._states, self._outputs = q, p
        self.width = q + len(steady.maps) + len(steady.zero_maps) + 1
        self.lay_out(flat, states(q, p) + maps.computed)

    @classmethod
    def design(
        cls,
        steady: SymbolicSteadyState,
        *,
        rate: float = 0.5,
        gain: ArrayLike | None = None,
        start: ArrayLike | None = None,
        **values: float | None,
    ) -> InterlacedObserver:
        """Compute or certify a gain and build the observer with it; see ``certify``."""
        output = output_matrix(steady)
        certificate = certify(steady.generator.matrix(), output, rate=rate, gain=gain)
        return cls(steady, certificate, start=start, **values)

    def update(self, y: ArrayLike | None, t: float) -> InterlacedEstimate:
        """Process the outputs at ``t`` s, ``None`` without a measurement, and return the estimate.

        Raises EventError for values that are not finite or of another length and for too long an interval,
        EventOrderError when time runs backwards; the stage is then unchanged.
        """
        last = self._last()
        now = moment(t, last)
        if last is not None:
            self._check_interval(now, last)
        out = np.empty(self.width)
        step(self._memory, np.concatenate([[now], self._outputs_of(y)]), out)
        self._map(out)
        values, q, n = out.tolist(), self._states, self._states + len(self.steady.maps)
        return InterlacedEstimate(now, tuple(values[:q]), tuple(values[q:n]), tuple(values[n:-1]), values[-1])

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Run the law over rows, resetting before each row marked ``begin``; continues from the memory."""
        before = self._last()
        for t, first in zip(rows[:, 0].tolist(), begin, strict=True):
            if before is not None and not first:
                self._check_interval(t, before)
            before = t
        out = super().walk(begin, rows)
        for row in out:
            self._map(row)
        return out

    def _last(self) -> float | None:
        """The time of the last sample."""
        state = State(self._memory, int(Head(self._memory).state))
        return float(state.t) if state.started == 1.0 else None

    def _check_interval(self, t: float, last: float) -> None:
        """Raise EventError for an interval that is too long, unless ``gap_s`` is given."""
        if self.gap_s is None and t - last > self._bridged:
            raise EventError(
                f"the sample at t = {t!r} comes {t - last:g} s after the last one, the observer follows at "
                f"most {self._bridged:g} s, {STEPS_MOST // 2} of its time constants: sample more often, "
                "or give gap_s, after which the generator runs alone",
                field="t",
                value=t,
            )

    def _map(self, row: FloatArray) -> None:
        """Evaluate the maps at w, which stands first, where the law does not; NaN without a finite value."""
        if self._function is None:
            return
        with np.errstate(all="ignore"):
            values = self._function(row[: self._states])
        row[self._states :] = np.where(np.isfinite(values), values, np.nan)

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the function, which sympy makes again."""
        return {**self.__dict__, "_function": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        wanted = (*self.steady.maps, *self.steady.zero_maps, self.steady.input)
        self._function = None if computable(wanted) else evaluable(self.steady)

    def _outputs_of(self, y: ArrayLike | None) -> FloatArray:
        if y is None:
            return np.full(self._outputs, np.nan)
        try:
            sample = np.asarray(y, np.float64).reshape(-1)
        except (TypeError, ValueError) as unusable:
            raise EventError(f"outputs must be numbers, received {y!r}") from unusable
        if len(sample) != self._outputs or not all(isfinite(value) for value in sample):
            raise EventError(f"needs {self._outputs} finite outputs, received {y!r}")
        return sample


def evaluable(steady: SymbolicSteadyState) -> Callable[[Any], FloatArray]:
    """The maps as a numpy function; raises ParameterError for a function without a numerical form."""
    try:
        function = steady.function()
        with np.errstate(all="ignore"):
            function(np.zeros(len(steady.generator.states)))
    except (NameError, TypeError, AttributeError, NotImplementedError, SyntaxError) as unusable:
        raise ParameterError(
            f"the maps hold a function that has no numerical form: {unusable}; give it one by sympy's "
            "implemented_function"
        ) from unusable
    return function


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
