"""Observers and regulators of Persidskii form as compiled stages on irregular samples."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pointpred.errors import DivergenceError, EventError, EventOrderError, ParameterError
from pointpred.parameter import option, parameter
from pointpred.records import BoolArray, FloatArray
from pointpred.stage import CompiledStage
from pointpred_observers.interconnected import persidskii_law as law
from pointpred_observers.interconnected.realisation import LONGEST_S, MissingInputs, PlainLaw, Realisation
from pointpred_observers.numerics.matrices import TIMES, matrix, one_of
from pointpred_observers.plants.generator import Generator, fitted
from pointpred_observers.plants.linear_systems import Plant, as_plant
from pointpred_observers.plants.nonlinearity import nonlinearity

NEVER = 1e300
"""A time that no interval reaches, s."""


class PersidskiiStage(CompiledStage):
    """The stage w' = N w + L f(Jw + R i) + K i with i the inputs of a sample; returns R0 w + R1 f(.) + R2 i.

    Assumes that inputs are linear between two samples; in discrete time each sample is one step, its index
    the last one plus 1, and its inputs act from the next step on: an index that nobody measured at is a
    sample without inputs, ``update(t, None)``. In continuous time it starts again at ``start`` after a gap
    longer than ``gap_s``, by default never. An input that is NaN is missing: while it is so at one end of an
    interval, ``missing`` says what replaces it, by default its last value.

    Continuous time is integrated by the classical Runge-Kutta method in steps of at most ``step_s``, by
    default 0.01 or the inverse of a bound of the stage's fastest rate, whichever is shorter. A ``step_s``
    that is too long for the fastest eigenvalue amplifies. An interval between two samples has at most 10^5
    steps: within 10^5 inverse rates the default step grows with it, if the matrices are constant and f has a
    name and bounded slopes; a longer interval is refused. "s" is the unit of time of the matrices.

    With an f of a name and constant matrices the stage is compiled; with functions it runs in numpy, some
    thirty times slower, by the same law.

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
        named = not callable(f) or getattr(f, "codes", None) is not None
        parts = Realisation(named, missing, self.time, N=N, L=L, J=J, K=K, R0=R0, R1=R1, R=R, R2=R2)
        nonlinear = nonlinearity(f, parts.k)
        self.inputs, self.width = parts.inputs, parts.outputs
        first = np.zeros(parts.q) if start is None else matrix("start", start, 1, parts.q)[0]
        self._plain: PlainLaw | None = None
        own_step, speed = self.step_s, parts.fastest(0.0, nonlinear.slopes)
        self.step_s = own_step or min(LONGEST_S, 1.0 / max(speed, 1e-300))
        if nonlinear.codes is None or parts.varies:
            self._plain = PlainLaw(parts, nonlinear, first, own_step, self.gap_s)
            settings, states = np.zeros(0), self._plain.states
            self._bridged = self._plain.bridged(0.0)
        else:
            limited = np.isfinite(nonlinear.slopes or ()).all() and not own_step
            self._bridged = law.STEPS_MOST * (1.0 / max(speed, 1e-290) if limited else self.step_s)
            gap = NEVER if self.gap_s is None else self.gap_s
            sizes = [parts.q, parts.k, self.inputs, self.width, float(parts.discrete)]
            shape = [*sizes, self.step_s, gap, self._bridged, *nonlinear.codes]
            settings = np.concatenate([np.array(shape), *(one.ravel() for one in parts.flat(first))])
            states = law.floats(parts.q, parts.k, self.inputs)
        if not parts.discrete and self.gap_s is not None and self.gap_s > self._bridged:
            raise ParameterError(
                f"gap_s must be at most {self._bridged:g} s, {law.STEPS_MOST:.0e} steps of the stage, "
                f"received {self.gap_s!r}: give a shorter gap_s",
                field="gap_s",
                value=self.gap_s,
            )
        self._state_at = len(settings)
        self.lay_out(settings, states)

    def declare(self, **values: Any) -> None:
        """Check the values."""
        super().declare(**values)
        one_of("time", self.time, TIMES)

    def _clock(self) -> tuple[bool, float]:
        """Whether there was a sample, and its time."""
        started, t = self._memory[self._state_at : self._state_at + 2].tolist()
        return started == 1.0, t

    def _refused(self, t: float, last: float) -> EventError:
        """The refusal of a sample after an interval that is too long, in discrete time not one step."""
        if self.time == "discrete":
            return EventError(
                f"the sample at index {t:g} comes after index {last:g}, a sample is one step: give a sample "
                f"without measurements, update({last + 1.0:g}, None), for each missing index, or call reset",
                field="t",
                value=t,
            )
        longest = self._bridged if self._plain is None else self._plain.bridged(last)
        return EventError(
            f"the sample at t = {t!r} comes {t - last:g} s after the last one, the stage bridges at most "
            f"{longest:g} s, {law.STEPS_MOST:.0e} steps: sample more often, or give gap_s, after "
            "which it starts again",
            field="t",
            value=t,
        )

    def walk(self, begin: BoolArray, rows: FloatArray) -> FloatArray:
        """Run the law over rows, resetting before each row marked ``begin``; continues from the memory."""
        if self.time == "discrete":
            self._check_steps(begin, rows[:, 0])
        if self._plain is None:
            self._check_intervals(begin, rows[:, 0])
            return super().walk(begin, rows)
        out = np.full((len(rows), self.width), np.nan)
        for i, row in enumerate(np.asarray(rows, np.float64)):
            if begin[i]:
                self._memory[:] = 0.0
            if self._plain.step(self._memory, row, out[i]) == law.TOO_LONG:
                raise self._refused(row[0], self._clock()[1])
        return out

    def _check_intervals(self, begin: BoolArray, times: FloatArray) -> None:
        """Raise EventError for an interval that is too long, before anything changes."""
        if self.time == "discrete" or self.gap_s is not None or not len(times):
            return
        started, last = self._clock()
        before = np.concatenate([[last] if started else times[:1], times[:-1]])
        for i in np.flatnonzero((times - before > self._bridged) & ~begin)[:1]:
            raise self._refused(float(times[i]), float(before[i]))

    def _check_steps(self, begin: BoolArray, times: FloatArray) -> None:
        """The same in discrete time, where an index is the last one, the next one, or runs backwards."""
        started, before = self._clock()
        last = before if started else None
        for first, t in zip(begin.tolist(), times.tolist(), strict=True):
            if first or last is None or t == last + 1.0:
                last = t
            elif not t <= last:
                raise self._refused(t, last)

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
            raise EventOrderError(
                f"t must not run backwards: received {float(row[0])!r} after {last!r}",
                field="t",
                value=t,
            )
        if not np.isfinite(self._memory).all():
            self._memory[:] = before
            raise DivergenceError(f"the state leaves every bound before t = {t!r}: take a smaller step_s")
        return out

    def _row(self, t: float, inputs: ArrayLike | None) -> FloatArray:
        try:
            values = np.full(self.inputs, np.nan) if inputs is None else np.asarray(inputs, np.float64)
            row = np.concatenate([[t], np.ravel(values)]).astype(np.float64)
        except (TypeError, ValueError, OverflowError) as unusable:
            raise EventError(f"a sample must be numbers, received t={t!r}, inputs={inputs!r}") from unusable
        if len(row) != 1 + self.inputs:
            raise EventError(f"a sample needs {self.inputs} inputs, received {inputs!r}")
        if not np.isfinite(row).all() and (row[0] != row[0] or np.isinf(row).any()):
            raise EventError(
                f"a sample must be finite (NaN only for a missing input), received t={t!r}, inputs={inputs!r}"
            )
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
