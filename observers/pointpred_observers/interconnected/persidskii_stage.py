"""Observers and regulators of Persidskii form as stages on irregular samples, compiled or in numpy."""

from __future__ import annotations

from math import ceil
from typing import Any

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.errors import DivergenceError, EventError, EventOrderError, ParameterError
from pointpred.parameter import option, parameter
from pointpred.records import BoolArray, FloatArray
from pointpred.regression.least_squares import moment
from pointpred.stage import CompiledStage
from pointpred_observers.interconnected import persidskii_law as law
from pointpred_observers.numerics.eigenvalues import perron_root
from pointpred_observers.numerics.matrices import TIMES, instance, matrix, one_of
from pointpred_observers.plants import nonlinearity
from pointpred_observers.plants.generator import Generator, fitted, require_same_nonlinearity
from pointpred_observers.plants.linear_systems import Plant, as_plant
from pointpred_observers.plants.persidskii import Persidskii, column
from pointpred_observers.simulations.result import Simulation
from pointpred_observers.simulations.signals import Setting, run, sampled

GROUPS = {"r": ("J", "R"), "q": ("N", "L", "K"), "p": ("R0", "R1", "R2"), "m": ("V0", "V1", "V2")}
"""The matrices that stand side by side, by their rows: arguments of f, w, outputs, and missing inputs."""
SHAPES = {
    name: (rows, columns)
    for rows, names in GROUPS.items()
    for name, columns in zip(names, "qm" if rows == "r" else "qkm", strict=True)
}
"""Of states q, components k and arguments r of f, inputs m and outputs p."""
LONGEST_S = 1e-2
"""The longest step by default, s."""
NEVER = 1e300
"""A time that no interval reaches, s."""


class MissingInputs(msgspec.Struct, frozen=True):
    """What replaces the inputs i of w' = N w + L f(Jw + R i) + K i while they are not measured.

    Of a *value* the input is V0 w + V1 f(.). Any other follows i' = V0 w + V1 f(.) + V2 i from its last
    measurement on; in discrete time this is the next i. ``first``: the inputs before their first measurement.
    V0 (inputs, q), V1 (inputs, k), V2 (inputs, inputs): arrays, or functions of t (of the index).
    """

    value: tuple[bool, ...]
    V0: Any
    V1: Any
    V2: Any
    first: FloatArray

    @classmethod
    def expected(cls, V0: Any, V1: Any, inputs: int, time: str = "continuous") -> MissingInputs:
        """The first inputs are outputs, expected to be V0 w + V1 f(.); the others keep their last value."""
        v0 = matrix("V0", V0)
        v1 = matrix("V1", V1, len(v0))
        rest = inputs - len(v0)
        return cls(
            (True,) * len(v0) + (False,) * rest,
            np.pad(v0, ((0, rest), (0, 0))),
            np.pad(v1, ((0, rest), (0, 0))),
            np.eye(inputs) if time == "discrete" else np.zeros((inputs, inputs)),
            np.zeros(inputs),
        )


class Realisation:
    """w' = N w + L f(Jw + R i) + K i with the output R0 w + R1 f(.) + R2 i, and its law in numpy.

    Arguments as for ``PersidskiiStage``. The law is that of ``persidskii_law``, where f or matrices are
    functions; slow, 0.15 ms and more. Its memory: whether there was a sample, t; w minus its start (q); the
    last inputs; which were missing.
    """

    def __init__(
        self, f: Any, start: Any, missing: Any, time: str, step_s: float | None, gap_s: float, **given: Any
    ) -> None:
        self._given = given
        self._constant: dict[str, FloatArray] = {}
        self.discrete, self.step_s, self.gap_s = time == "discrete", step_s, gap_s
        q = self.q = len(matrix("N", self._now("N", 0.0)))
        self.k, m = (column(name, self._now(name, 0.0), q).shape[1] for name in ("L", "K"))
        inner, shown = self._now("J", 0.0), self._now("R0", 0.0)
        elementwise = not callable(f) or getattr(f, "codes", None) is not None
        self.r = self.k if elementwise or inner is None else len(matrix("J", inner, None, q))
        self.m, self.p = m, q if shown is None else len(matrix("R0", shown, None, q))
        self.f = nonlinearity.nonlinearity(f, self.k)
        self.start = np.zeros(q) if start is None else matrix("start", start, 1, q)[0]
        if missing is None:
            missing = MissingInputs.expected(np.zeros((0, q)), np.zeros((0, self.k)), m, time)
        if len(instance("missing", missing, MissingInputs).value) != m:
            raise ParameterError(f"missing needs {m} inputs, received {len(missing.value)}", field="missing")
        self._given |= {name: getattr(missing, name) for name in GROUPS["m"]}
        self.valued, self.first = np.array(missing.value, bool), matrix("first", missing.first, 1, m)[0]
        first = {name: self.at(name, 0.0) for name in SHAPES}
        self._constant |= {name: one for name, one in first.items() if not callable(self._given[name])}
        self.compiled = self.f.codes is not None and len(self._constant) == len(SHAPES)
        if (np.abs(first["R"][:, self.valued]) @ np.abs(first["V1"][self.valued])).any():
            raise ParameterError(
                "an input that enters f cannot be replaced by a value of f: set its rows of V1 to zero",
                field="missing",
            )

    def _now(self, name: str, t: float) -> Any:
        one = self._given[name]
        return one(t) if callable(one) else one

    def at(self, name: str, t: float) -> FloatArray:
        """A matrix at a time; raises ParameterError for a shape."""
        if name in self._constant:
            return self._constant[name]
        rows, columns = (getattr(self, size) for size in SHAPES[name])
        now = self._now(name, t)
        if now is None or (self.k == 0 and name in ("J", "R")):
            return np.eye(rows, columns) if name == "R0" else np.zeros((rows, columns))
        return matrix(name, now, rows, columns)

    def fastest(self, t: float) -> float:
        """A bound of the rates of the stage at a time in 1/s, with its inputs measured or missing.

        The Perron root of abs(N) + abs(L) S abs(J) bounds each eigenvalue of N + L D J with abs(D) <= S, in
        any units. Missing inputs that are values are functions of w, the others are states.
        """
        n, ell, j, k, r, v0, v1, v2 = (self.at(x, t) for x in ("N", "L", "J", "K", "R", "V0", "V1", "V2"))
        valued, rest = self.valued, ~self.valued
        spread = np.zeros((self.k, self.r))
        if self.f.slopes is not None and self.k == self.r:
            steepest = np.abs(np.array(self.f.slopes, np.float64).reshape(-1, 2)).max(axis=1)
            spread = np.diag(np.where(np.isfinite(steepest), steepest, 0.0))

        def rate(n: FloatArray, ell: FloatArray, j: FloatArray) -> float:
            return perron_root(np.abs(n) + np.abs(ell) @ spread @ np.abs(j))

        within, across = n + k[:, valued] @ v0[valued], k[:, rest]
        bridged = np.block([[within, across], [v0[rest], v2[np.ix_(rest, rest)]]])
        moved = np.vstack([ell + k[:, valued] @ v1[valued], v1[rest]])
        inner = np.hstack([j + r[:, valued] @ v0[valued], r[:, rest]])
        return max(rate(n, ell, j), rate(bridged, moved, inner))

    def longest(self, t: float) -> float:
        """The longest step from t on, in s: it follows the fastest eigenvalue of the matrices."""
        return self.step_s or min(LONGEST_S, 1.0 / max(self.fastest(t), 1e-300))

    def bridged(self, t: float) -> float:
        """The longest interval from t on that is bridged, in s."""
        if not self.compiled or self.step_s or not np.isfinite(self.f.slopes or ()).all():
            return law.STEPS_MOST * self.longest(t)
        return law.STEPS_MOST * (1.0 / max(self.fastest(t), 1e-290))

    def step(self, memory: FloatArray, row: FloatArray, out: FloatArray) -> int:
        """Process the sample (t, inputs), NaN for a missing one, into ``out``; see the compiled law."""
        q = 2 + self.q
        sample, w, last, absent = np.split(memory, (2, q, q + self.m))
        started, t, now = sample[0] == 1.0, float(sample[1]), float(row[0])
        if started and now < t:
            return law.BACKWARDS
        if started and self.discrete and now not in (t, t + 1.0):
            return law.SKIPPED
        measured = ~np.isnan(row[1:])
        x, inputs = w + self.start, last.copy()
        verdict = law.REPEATED if started and now == t else law.ACCEPTED
        if verdict == law.ACCEPTED:
            missing = (absent == 1.0) | ~measured
            if not started or (not self.discrete and now - t > self.gap_s):
                x, inputs = self.start.copy(), self.first.copy()
            elif self.discrete:
                onward, x = self._sum("m", t, x, inputs), self._sum("q", t, x, inputs)
                inputs = np.where(missing, onward, inputs)
            elif now - t > self.bridged(t):
                return law.TOO_LONG
            else:
                x, inputs = self._flown(t, x, inputs, row, missing)
            absent[~measured] = 1.0
        inputs[measured] = row[1:][measured]
        absent[measured] = 0.0
        if verdict == law.ACCEPTED:
            inputs = self._replaced(now, x, inputs, absent == 1.0)
        sample[:] = 1.0, now
        w[:], last[:] = x - self.start, inputs
        out[:] = self._sum("p", now, x, inputs)
        return verdict

    def _f(self, t: float, x: FloatArray, inputs: FloatArray) -> FloatArray:
        return self.f(self.at("J", t) @ x + self.at("R", t) @ inputs) if self.k else np.zeros(0)

    def _sum(self, what: str, t: float, x: FloatArray, inputs: FloatArray) -> FloatArray:
        """The change of w, what missing inputs follow, or the outputs; see ``GROUPS``."""
        first, second, third = (self.at(name, t) for name in GROUPS[what])
        total: FloatArray = first @ x + second @ self._f(t, x, inputs) + third @ inputs
        return total

    def _replaced(self, t: float, x: FloatArray, inputs: FloatArray, missing: BoolArray) -> FloatArray:
        """The inputs with those that are missing and a value at their value."""
        chosen = missing & self.valued
        if not chosen.any():
            return inputs
        inputs = np.where(chosen, self.at("V0", t) @ x, inputs)
        return np.where(chosen, inputs + self.at("V1", t) @ self._f(t, x, inputs), inputs)

    def _flown(
        self, t: float, x: FloatArray, inputs: FloatArray, row: FloatArray, missing: BoolArray
    ) -> tuple[FloatArray, FloatArray]:
        """The state and the inputs carried to the next sample by the classical Runge-Kutta method."""
        q, now = len(x), float(row[0])
        count = max(1, ceil(min((now - t) / self.longest(t), law.STEPS_MOST)))
        h, both = (now - t) / count, np.concatenate([x, inputs])
        for n in range(count):
            begin = t + n * h
            rise = (row[1:] - both[q:]) / (now - t - n * h)

            def rate(s: float, v: FloatArray, rise: FloatArray = rise) -> FloatArray:
                x, inputs = v[:q], self._replaced(s, v[:q], v[q:], missing)
                if missing.any():
                    onward = np.where(self.valued, 0.0, self._sum("m", s, x, inputs))
                    rise = np.where(missing, onward, rise)
                return np.concatenate([self._sum("q", s, x, inputs), rise])

            k1 = rate(begin, both)
            k2 = rate(begin + 0.5 * h, both + 0.5 * h * k1)
            k3 = rate(begin + 0.5 * h, both + 0.5 * h * k2)
            k4 = rate(begin + h, both + h * k3)
            both = both + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        return both[:q], both[q:]


class PersidskiiStage(CompiledStage):
    """The stage w' = N w + L f(Jw + R i) + K i with i the inputs of a sample; returns R0 w + R1 f(.) + R2 i.

    Assumes that inputs are linear between two samples; in discrete time each sample is one step, its index
    the last one plus 1, and its inputs act from the next step on: an index that nobody measured at is a
    sample without inputs, ``update(t, None)``. In continuous time it starts again at ``start`` after a gap
    longer than ``gap_s``, by default never. An input that is NaN is missing: while it is so at one end of an
    interval, ``missing`` says what replaces it, by default its last value.

    Continuous time is integrated by the classical Runge-Kutta method in steps of at most ``step_s``, by
    default 0.01 or the inverse of a bound of the stage's fastest rate, whichever is shorter; a ``step_s``
    that is too long for the fastest eigenvalue amplifies. An interval has at most 10^5 steps: within 10^5
    inverse rates the default step grows with it, if the matrices are constant and f has a name and bounded
    slopes; a longer interval is refused. "s" is the unit of time of the matrices. With an f of a name and
    constant matrices the stage is compiled; with functions it runs in numpy, some thirty times slower, by the
    same law.

    Parameters: ``N`` (q, q), ``L`` (q, k), ``J`` (k, q), ``K`` (q, inputs), each an array or a function of
    t (of the index in discrete time); ``f`` a name or one for each component, or a function from R^r to R^k
    (then J is (r, q)); ``R0`` (outputs, q), default the identity; ``R1`` (outputs, k); ``R`` (r, inputs)
    and ``R2`` (outputs, inputs), default zeros; ``start`` (q), default zeros; ``step_s`` in s, [1e-12, 1e12];
    ``gap_s`` in s, [1e-12, 1e12], at most what is bridged; ``time`` "continuous" or "discrete"; ``missing`` a
    ``MissingInputs``. Memory: the matrices and 2 + 5 q + k + 6 inputs floats.
    Raises ParameterError; EventError, EventOrderError and DivergenceError from ``update``.

    Reference: Khalin 2022, (3.5), (3.8), (3.17), (3.19).

    >>> lag = PersidskiiStage([[-1.0]], None, None, [[1.0]], "sin", start=[0.0])
    >>> [round(float(lag.update(t, 1.0)[0]), 6) for t in (0.0, 0.25, 1.0)]  # 1 - exp(-t)
    [0.0, 0.221199, 0.632121]
    >>> turning = PersidskiiStage(lambda t: [[-2.0 * t]], None, None, None, "sin", start=[1.0])
    >>> [round(float(turning.update(t)[0]), 6) for t in (0.0, 0.5, 1.0)]  # exp(-t^2)
    [1.0, 0.778801, 0.367879]
    """

    step_s: float | None = parameter(
        "s", 1e-12, 1e12, "longest step of the integration", default=None, absent=0.0
    )
    gap_s: float | None = parameter(
        "s", 1e-12, 1e12, "after a longer gap it starts again", default=None, absent=NEVER
    )
    time: str = option("'continuous' or 'discrete'", default="continuous")
    step = staticmethod(law.step)
    loop = staticmethod(law.loop)

    def __init__(
        self,
        N: Any,
        L: Any,
        J: Any,
        K: Any,
        f: Any,
        *,
        R0: Any = None,
        R1: Any = None,
        R: Any = None,
        R2: Any = None,
        start: ArrayLike | None = None,
        missing: MissingInputs | None = None,
        **values: Any,
    ) -> None:
        self.declare(**values)
        gap = NEVER if self.gap_s is None else self.gap_s
        parts = Realisation(
            f, start, missing, self.time, self.step_s, gap, N=N, L=L, J=J, K=K, R0=R0, R1=R1, R=R, R2=R2
        )
        self.inputs, self.width = parts.m, parts.p
        self._plain = None if parts.compiled else parts
        bridged = self._bridged = parts.bridged(0.0)
        self.step_s = parts.longest(0.0)
        if not parts.discrete and self.gap_s is not None and self.gap_s > bridged:
            most = f"at most {bridged:g} s, {law.STEPS_MOST:.0e} steps, received {self.gap_s!r}"
            raise ParameterError(
                f"gap_s must be {most}: give a shorter gap_s", field="gap_s", value=self.gap_s
            )
        settings, states = np.zeros(0), 2 + parts.q + 2 * parts.m
        if parts.compiled:
            sizes = [parts.q, parts.k, parts.m, parts.p, parts.discrete, self.step_s, gap, bridged]
            tables = [np.hstack([parts.at(name, 0.0) for name in one]).ravel() for one in GROUPS.values()]
            own = parts.start, parts.valued, parts.first
            settings = np.concatenate([sizes, parts.f.codes or (), *tables, *own])
            states = 2 + 5 * (parts.q + parts.m) + parts.k + parts.m
        self.lay_out(settings, states)

    def declare(self, **values: Any) -> None:
        """Check the values."""
        super().declare(**values)
        one_of("time", self.time, TIMES)

    def _clock(self) -> tuple[bool, float]:
        """Whether there was a sample, and its time."""
        started, t = self._memory[self._first : self._first + 2].tolist()
        return started == 1.0, t

    def _refused(self, t: float, last: float) -> EventError:
        """The refusal of a sample after an interval that is too long, in discrete time not one step."""
        if self.time == "discrete":
            reason = (
                f"the sample at index {t:g} comes after index {last:g}, a sample is one step: give a sample "
                f"without measurements, update({last + 1.0:g}, None), for each missing index, or call reset"
            )
        else:
            longest = self._bridged if self._plain is None else self._plain.bridged(last)
            reason = (
                f"the sample at t = {t!r} comes {t - last:g} s after the last one, the stage bridges at most "
                f"{longest:g} s, {law.STEPS_MOST:.0e} steps: sample more often, or give gap_s, after "
                "which it starts again"
            )
        return EventError(reason, field="t", value=t)

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Run the law over rows, resetting before each row marked ``begin``; continues from the memory.

        Raises EventError for an interval that is too long, or a skipped index, before anything changes.
        """
        plain, (started, last) = self._plain, self._clock()
        for first, t in zip(begin.tolist(), rows[:, 0].tolist(), strict=False):
            if started and not first and t > last:
                if self.time == "discrete":
                    far = t != last + 1.0
                else:
                    far = plain is None and self.gap_s is None and t - last > self._bridged
                if far:
                    raise self._refused(t, last)
            if first or not started or t > last:
                started, last = True, t
        if plain is None:
            return super().walk(begin, rows)
        out = np.full((len(rows), self.width), np.nan)
        for i, row in enumerate(np.asarray(rows, np.float64)):
            if begin[i]:
                self._memory[:] = 0.0
            if plain.step(self._memory, row, out[i]) == law.TOO_LONG:
                raise self._refused(row[0], self._clock()[1])
        return out

    def update(self, t: float, inputs: ArrayLike | None = ()) -> FloatArray:
        """Process the inputs measured at ``t`` (s, or the index) and return the outputs at t.

        An input that is NaN is missing, ``None`` for all of them. Raises EventError for values that are not
        finite, a wrong number of them, too long an interval or a skipped index, EventOrderError when time
        runs backwards and DivergenceError if the state diverges; the stage is then unchanged.
        """
        row = self._row(t, inputs)
        before, (_, last) = self._memory.copy(), self._clock()
        out = np.empty(self.width)
        step: Any = law.step if self._plain is None else self._plain.step
        verdict = step(self._memory, row, out)
        if verdict in (law.TOO_LONG, law.SKIPPED):
            raise self._refused(float(row[0]), last)
        if verdict == law.BACKWARDS:
            told = f"received {float(row[0])!r} after {last!r}"
            raise EventOrderError(f"t must not run backwards: {told}", field="t", value=t)
        if not np.isfinite(self._memory).all():
            self._memory[:] = before
            raise DivergenceError(f"the state leaves every bound before t = {t!r}: take a smaller step_s")
        return out

    def _row(self, t: float, inputs: ArrayLike | None) -> FloatArray:
        def wrong(must: str) -> EventError:
            return EventError(f"inputs must be {must}, received {inputs!r}", field="inputs", value=inputs)

        row = np.empty(1 + self.inputs)
        row[0] = moment(t, None)
        try:
            values = np.asarray(np.full(self.inputs, np.nan) if inputs is None else inputs)
            if values.dtype.kind not in "biufO":
                raise TypeError  # text, dates, complex numbers
            row[1:] = values.reshape(self.inputs)
        except (TypeError, ValueError, OverflowError) as unusable:
            raise wrong(f"real numbers, {self.inputs} of them") from unusable
        if np.isinf(row).any():
            raise wrong("finite, or NaN for those that are missing")
        return row


def regulator_stage(plant: Plant, regulator: Generator, Pi: Any = None, **settings: Any) -> PersidskiiStage:
    """Regulator (3.8): inputs are Y, then rho; it returns u = L0 w + L1 f(Jw), and behind it Pi w if given.

    A missing input keeps its last value. Raises ParameterError if the regulator has no J.
    """
    plant = as_plant(plant)
    g = fitted(regulator, plant, "regulator")
    pi = np.zeros((0, g.q)) if Pi is None else matrix("Pi", Pi, plant.n, g.q)
    if g.J is None:
        raise ParameterError("a regulator needs J: give it, or take it from the steady-state map, J = H Pi")
    return PersidskiiStage(
        g.S0,
        g.S1,
        g.J,
        np.hstack([g.G, g.E]),
        plant.f if regulator.f is None else regulator.f,
        R0=np.vstack([g.L0, pi]),
        R1=np.vstack([g.L1, np.zeros((len(pi), g.L1.shape[1]))]),
        time=plant.time,
        **settings,
    )


UNUSED = ("unknown_input", "schedule")


def alone(
    plant: Persidskii, observer: Any, setting: Setting, title: str, bound: FloatArray | None = None
) -> Simulation:
    """A plant that nothing feeds back, beside its observer."""
    setting.refuse("a Persidskii plant", *UNUSED)
    times = setting.samples(plant.time == "discrete")
    stage = observer.stage(start=setting.begin(plant.n, "estimate", 0.0))
    both, d = setting.signal("input", plant.m + plant.z), setting.signal("disturbance", plant.n)

    def field(t: float, x: FloatArray) -> FloatArray:
        now = both(t)
        return plant.field(t, x, now[: plant.m], now[plant.m :], d(t))

    state = run(field, setting.begin(plant.n), times, plant.time == "discrete")
    inputs = sampled(both, times)
    outputs, answers = observed(stage, plant, times, state, inputs, setting)
    return Simulation.of(plant, times, state, answers, outputs, inputs, title, bound=bound)


def observed(
    stage: PersidskiiStage, plant: Persidskii, times: FloatArray, state: Any, inputs: Any, setting: Setting
) -> tuple[FloatArray, FloatArray]:
    """The outputs with their noise, (N, p), and the answers of a stage that receives them and the inputs."""
    exact = np.array([plant.output(float(t), x) for t, x in zip(times, state, strict=True)])
    outputs = setting.measured(exact)
    try:
        return outputs, stage.walk(np.zeros(len(times), bool), np.column_stack([times, outputs, inputs]))
    except EventError as far:
        raise _too_far(times) from far


def _too_far(times: FloatArray) -> ParameterError:
    return ParameterError(
        f"times: samples lie {np.diff(times).max():g} s apart, more than 1e5 steps of the observer, "
        "which is that fast: they must lie closer together, or the design needs less decay",
        field="times",
    )


def closed(plant: Persidskii, regulator: Generator, pi: FloatArray, setting: Setting) -> Simulation:
    """The stage of the regulator gives u at each sample, and the plant moves on with it until the next."""
    setting.refuse("a plant under a regulator", *UNUSED)
    discrete, g = plant.time == "discrete", fitted(regulator, plant, "regulator")
    require_same_nonlinearity(plant, regulator, name="regulator")
    times = setting.samples(discrete)
    j = plant.H @ pi if g.J is None else g.J
    used = Generator(g.S0, g.S1, j, g.G, g.L0, g.L1, g.E, regulator.f)
    stage = regulator_stage(plant, used, pi, start=setting.begin(g.q, "estimate", 0.0))
    rho, d = setting.signal("input", plant.z), setting.signal("disturbance", plant.n)
    outputs, known = setting.measured(np.zeros((len(times), plant.p))), sampled(rho, times)
    state, answers = [setting.begin(plant.n)], np.empty((len(times), plant.m + plant.n))
    for i, t in enumerate(times.tolist()):
        outputs[i] += plant.output(t, state[i])
        try:
            answers[i] = stage.update(t, np.concatenate([outputs[i], known[i]]))
        except EventError as far:
            raise _too_far(times) from far

        def field(t: float, x: FloatArray, u: FloatArray = answers[i, : plant.m]) -> FloatArray:
            return plant.field(t, x, u, rho(t), d(t))

        if i + 1 < len(times):
            state.append(run(field, state[i], times[i : i + 2], discrete)[-1])
    u, estimate = np.split(answers, [plant.m], axis=1)
    inputs = np.hstack([u, known])
    return Simulation.of(
        plant, times, np.array(state), estimate, outputs, inputs, "plant under its regulator"
    )


def like(plant: Any, known: Persidskii, *, apart: bool = True) -> Persidskii:
    """The plant to simulate; raises ParameterError unless its sizes are those of the design's.

    Its inputs may stand in B or in Q unless they are told ``apart``.
    """

    def sizes(one: Persidskii) -> tuple[Any, ...]:
        return one.n, (one.m, one.z) if apart else one.m + one.z, one.p, one.time

    def shown(one: Persidskii) -> str:
        return f"{one.n} states, {one.m + one.z} inputs and {one.p} outputs in {one.time} time"

    one = as_plant(plant)
    if sizes(one) != sizes(known):
        raise ParameterError(
            f"the observer was designed for a plant of {shown(known)}, received one of {shown(one)}",
            field="plant",
        )
    return one


def same(plant: Persidskii, known: Persidskii) -> bool:
    """Whether a plant is the one that a certificate speaks of, whose inputs may stand in B or in Q.

    Certificates are of constant matrices: one that varies is another plant, also where both agree at 0.
    """
    if plant.varying or known.varying:
        return False
    left, right = plant.matrices(0.0), known.matrices(0.0)
    for one in (left, right):
        one["inputs"] = np.hstack([one.pop("B"), one.pop("Q")])
    return nonlinearity.same(plant.f, known.f) and all(
        np.array_equal(left[name], right[name]) for name in left
    )
