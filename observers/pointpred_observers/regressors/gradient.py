"""Gradient estimators (3.46), (3.50) and (3.58): observers of constants, which are the state of a plant."""

from __future__ import annotations

from math import ceil, inf
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from pointpred.compiled import law
from pointpred.errors import EventError
from pointpred.layout import Layout
from pointpred.parameter import option, parameter
from pointpred.records import FloatArray, FloatTable
from pointpred.regression import gradient
from pointpred.regression.least_squares import moment, starting
from pointpred.stage import CompiledStage, loop_into
from pointpred_observers.numerics.matrices import TIMES, one_of, wrong
from pointpred_observers.plants import nonlinearity
from pointpred_observers.plants.nonlinearity import KNOWN

CONTINUOUS, DISCRETE, NONLINEAR = 0.0, 1.0, 2.0
"""Kinds of law, as stored in the memory."""
TAKEN, BACKWARDS, TOO_STEEP, UNUSABLE = 0, 1, 2, 3
"""Results of a step."""
STEPS_MOST = 10_000
"""Most integration steps of the nonlinear law for one sample."""
STEP_MOST = 0.5
"""Longest step of the integration, in units of the fastest time constant."""
MONOTONE = tuple(name for name, one in KNOWN.items() if one.low >= 0.0 and np.isfinite(one.high))
"""Nondecreasing nonlinearities with a bounded slope."""


class Memory(Layout):
    """Unknowns n, outputs p, floats of a sample, kind of law, code of f, its slope; then ``Parts``."""

    count: float
    outputs: float
    width: float
    kind: float
    code: float
    steepest: float
    rest: Annotated[FloatArray, None]


class Parts(NamedTuple):
    """Start (n) and gain (n, n); whether there was a sample, and t; theta minus its start; two samples.

    The second sample lies within an interval; then the numbers of a step of the integration (n each).
    """

    start: FloatArray
    gain: FloatTable
    clock: FloatArray
    theta: FloatArray
    last: FloatArray
    between: FloatArray
    stage: FloatArray
    change: FloatArray
    total: FloatArray


class Sample(NamedTuple):
    """The regressor (p, n), then the outputs y (p); in the nonlinear law D1 follows them."""

    D: FloatTable
    y: FloatArray


@law
def parts_of(memory: Memory) -> Parts:
    """The parts in their places."""
    n, width = int(memory.count), int(memory.width)
    clock_at = n + n * n
    theta_at = clock_at + 2
    last_at = theta_at + n
    between_at = last_at + width
    stage_at = between_at + width
    return Parts(
        memory.rest[:n],
        memory.rest[n:clock_at].reshape(n, n),
        memory.rest[clock_at:theta_at],
        memory.rest[theta_at:last_at],
        memory.rest[last_at:between_at],
        memory.rest[between_at:stage_at],
        memory.rest[stage_at : stage_at + n],
        memory.rest[stage_at + n : stage_at + 2 * n],
        memory.rest[stage_at + 2 * n : stage_at + 3 * n],
    )


@law
def sample_of(numbers: FloatArray, n: int) -> Sample:
    """The parts of a sample."""
    p = len(numbers) // (n + 1)
    return Sample(numbers[: p * n].reshape(p, n), numbers[p * n : p * n + p])


@law
def steepness(d: FloatTable, gain: FloatTable) -> float:
    """The trace of D G D': the sum of the decay rates of the errors of the outputs, in 1/s or per sample."""
    total = 0.0
    for row in range(len(d)):
        for i in range(len(gain)):
            for j in range(len(gain)):
                total += d[row, i] * gain[i, j] * d[row, j]
    return total


@law
def flow(s: Parts, h: float) -> None:
    """Follow (3.46) over ``h`` s: exact for one output, a symmetric splitting of second order for several."""
    sample = sample_of(s.between, len(s.start))
    p = len(sample.y)
    for i in range(2 * p):
        row = i if i < p else 2 * p - 1 - i
        output = sample.y[row]
        for j in range(len(s.start)):
            output -= sample.D[row, j] * s.start[j]
        gradient.descend_along(s.theta, sample.D[row], s.gain, output, 0.5 * h)


@law
def jump(s: Parts) -> None:
    """One step of (3.58); the outputs of the sample become their errors."""
    n = len(s.start)
    sample = sample_of(s.between, n)
    for row in range(len(sample.y)):
        for j in range(n):
            sample.y[row] -= sample.D[row, j] * (s.start[j] + s.theta[j])
    for row in range(len(sample.y)):
        for i in range(n):
            for j in range(n):
                way = s.gain[i, j] * sample.D[row, j]
                s.theta[i] += way * sample.y[row]


@law
def slope(code: float, s: Parts) -> None:
    """Write G J'(y - (1 - D1) J theta - D1 f(J theta)) of the stage at the interpolated sample."""
    n, weight = len(s.start), s.between[len(s.between) - 1]
    sample = sample_of(s.between, n)
    for i in range(n):
        s.change[i] = 0.0
    for row in range(len(sample.y)):
        argument = 0.0
        for i in range(n):
            argument += sample.D[row, i] * (s.stage[i] + s.start[i])
        error = sample.y[row] - (1.0 - weight) * argument - weight * nonlinearity.value(code, argument)
        for i in range(n):
            for j in range(n):
                s.change[i] += s.gain[i, j] * sample.D[row, j] * error


@law
def bend(code: float, s: Parts, new: FloatArray, begin: float, h: float, dt: float) -> None:
    """A step of the classical Runge-Kutta method over the share ``h`` of the interval ``dt``."""
    n = len(s.start)
    for i in range(n):
        s.stage[i] = s.theta[i]
        s.total[i] = 0.0
    for part in range(4):
        at = begin + (0.0 if part == 0 else h if part == 3 else 0.5 * h)
        for i in range(len(s.last)):
            s.between[i] = s.last[i] + at * (new[i] - s.last[i])
        slope(code, s)
        weight = 1.0 if part == 0 or part == 3 else 2.0
        ahead = h * dt if part == 2 else 0.5 * h * dt
        for i in range(n):
            s.total[i] += weight * s.change[i]
            s.stage[i] = s.theta[i] + ahead * s.change[i]
    for i in range(n):
        s.theta[i] += h * dt / 6.0 * s.total[i]


@law
def step(memory: Memory, row: FloatArray, out: FloatArray) -> int:
    """Process t and a sample and write the estimate to ``out``; a refused row changes nothing."""
    s = parts_of(memory)
    n, new = len(s.start), row[1:]
    for i in range(len(row)):
        if not abs(row[i]) < inf:
            return UNUSABLE
    weight = row[len(row) - 1]
    if memory.kind == NONLINEAR and not (weight >= 0.0 and weight <= 1.0):
        return UNUSABLE
    started, h = s.clock[0] == 1.0, row[0] - s.clock[1]
    if started and h < 0.0:
        return BACKWARDS
    steep = steepness(sample_of(new, n).D, s.gain)
    if memory.kind == CONTINUOUS:
        for i in range(len(s.last)):
            s.between[i] = 0.5 * (s.last[i] + new[i])
        if started:
            flow(s, h)
    elif memory.kind == NONLINEAR:
        fastest = max(steepness(sample_of(s.last, n).D, s.gain), steep) * memory.steepest
        needed = fastest * h / STEP_MOST if started else 0.0
        if not needed <= STEPS_MOST:
            return TOO_STEEP
        steps = max(1, ceil(needed)) if started and h > 0.0 else 0
        for i in range(steps):
            bend(memory.code, s, new, i / steps, 1.0 / steps, h)
    else:
        if not steep < 2.0:
            return TOO_STEEP
        for i in range(len(s.last)):
            s.between[i] = new[i]
        jump(s)
    for i in range(len(s.last)):
        s.last[i] = new[i]
    s.clock[0], s.clock[1] = 1.0, row[0]
    for i in range(n):
        out[i] = s.start[i] + s.theta[i]
    return TAKEN


class _Estimator(CompiledStage):
    """What both regressors share: their sizes, their start, and how a sample becomes a row of the law."""

    count: int = parameter("", 1, 32, "number of unknown constants", whole=True, kw_only=False)
    outputs: int = parameter("", 1, 32, "number of outputs in a sample", default=1, whole=True)
    start: ArrayLike | None = option("the first estimate", default=None)
    loop = staticmethod(loop_into(step))

    def _settings(self, weights: int, kind: float, gain: FloatArray, f: str = "identity") -> FloatArray:
        """The beginning of the memory: sizes, kind of law, nonlinearity, start and gain."""
        self.count, self.outputs = int(self.count), int(self.outputs)
        self.width, wide = self.count, self.outputs * (self.count + 1) + weights
        self.states = 2 + 4 * self.count + 2 * wide
        shape = [self.count, self.outputs, wide, kind, KNOWN[f].code, max(1.0, KNOWN[f].high)]
        return np.concatenate([shape, starting(self.count, self.start), gain.ravel()])

    def _taken(self, t: Any, **sample: Any) -> FloatArray | None:
        """The estimate after a sample, ``None`` where it is too steep; raises EventError."""
        memory, n, p = Memory(self._memory), self.count, self.outputs
        started, last = parts_of(memory).clock.tolist()

        def wrong(name: str, must: str) -> EventError:
            return EventError(
                f"{name} must {must}, received {sample[name]!r}", field=name, value=sample[name]
            )

        row = []
        for name, given in sample.items():
            try:
                row.append(np.asarray(given, np.float64))
            except (TypeError, ValueError, OverflowError) as unusable:
                raise wrong(name, "be numbers") from unusable
        d, y, *weight = row
        if not (d.shape == (p, n) or (p == 1 and d.shape == (n,))) or not np.isfinite(d).all():
            raise wrong("regressor", f"be finite and of shape ({p}, {n})")
        if y.size != p or not np.isfinite(y).all():
            raise wrong("output", f"be {p} finite numbers")
        if weight and (weight[0].size != 1 or not 0.0 <= weight[0].item() <= 1.0):
            raise wrong("weight", "lie in [0, 1]")
        timeless = t is None and not weight
        now = last if timeless else moment(t, last if started == 1.0 else None)
        out = np.empty(n)
        verdict = step(memory, np.concatenate([[now], *map(np.ravel, row)]), out)
        return None if verdict == TOO_STEEP else out


class GradientRegressor(_Estimator):
    """Gradient estimator of constants x in y = D x, as a differential equation or sample by sample.

    Assumes a regressor D that is persistently exciting: nothing is learned in directions that D does not
    excite, and drifting constants are tracked with a lag. Noise is not averaged. More gain is not always
    faster: a large one keeps the estimate on the plane of the newest sample, along which it moves slowly.

    Continuous (3.46): theta' = G D'(y - D theta), with D and y linear between two samples; of
    second order in the interval, exact in theta for one output, and no gain is too large.
    Discrete (3.58): theta += G D'(y - D theta), refused if the trace of D G D' reaches 2, because the error
    could then grow.

    Parameters: ``count`` of unknowns n, 1 to 32; ``outputs`` p, 1 to 32; ``gain`` G, a positive
    number, n of them or a positive definite matrix, in 1/s over the square of the regressor's unit
    (discrete: without 1/s); ``time`` "continuous" or "discrete"; ``start`` the first estimate, default zeros.
    Memory: 8 + 5 n + n^2 + 2 p (n + 1) floats. Raises ParameterError, and EventError and EventOrderError from
    ``update``.

    Reference: Khalin 2022, (3.41)-(3.46) and (3.53)-(3.58), with G positive definite where the print
    has nonsingular.

    >>> stage = GradientRegressor(2, gain=3.0)
    >>> for i in range(800):
    ...     t = i / 50
    ...     estimate = stage.update((1.0, np.sin(3 * t)), 3.0 + 5.0 * np.sin(3 * t), t)
    >>> [round(float(value), 3) for value in estimate]
    [3.0, 5.0]
    """

    gain: ArrayLike = option("the gain G: a number, one for each constant, or a matrix", default=1.0)
    time: Literal["continuous", "discrete"] = option("'continuous' or 'discrete'", default="continuous")

    def declare(self, **values: Any) -> None:
        """Check the values."""
        super().declare(**values)
        one_of("time", self.time, TIMES)

    def settings(self) -> FloatArray:
        """The beginning of the memory."""
        kind = CONTINUOUS if self.time == "continuous" else DISCRETE
        return self._settings(0, kind, _positive(int(self.count), self.gain))

    def update(self, regressor: ArrayLike, output: ArrayLike, t: float | None = None) -> FloatArray:
        """Process output = regressor theta at ``t`` s and return the estimate.

        The discrete law needs no time. Raises EventError for values that are not finite, of another shape or
        too large, and EventOrderError when time runs backwards; the stage is then unchanged.
        """
        if t is None and self.time == "continuous":
            raise EventError("the continuous law needs the time of every sample, received t=None", field="t")
        if (estimate := self._taken(t, regressor=regressor, output=output)) is None:
            told = f"must lie below 2, received regressor {regressor!r}: choose a smaller gain"
            raise EventError(f"the trace of D G D' {told}", field="regressor", value=regressor)
        return estimate


class NonlinearRegressor(_Estimator):
    """Estimator of constants x in y = (1 - D1) J x + D1 f(J x), a mean of a linear and a saturating sensor.

    Assumes that J is persistently exciting and f nondecreasing; where f is flat and D1 near 1 nothing is
    learned.

    theta' = g J'(y - (1 - D1) J theta - D1 f(J theta)), with J, D1 and y linear between two samples,
    by the classical Runge-Kutta method in steps of half the fastest time constant.

    Parameters: ``count`` of unknowns n, 1 to 32; ``outputs`` r, 1 to 32; ``gain`` g in 1/s over the
    square of J's unit, > 0; ``f`` one of identity, tanh, atan, saturation; ``start`` the first estimate,
    default zeros. Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, (3.47)-(3.51); before (3.51) the print lacks a J in J'J z.

    >>> stage = NonlinearRegressor(2, f="atan", gain=2.0)
    >>> for i in range(4000):
    ...     t, s = i / 100, 3.0 + 5.0 * np.sin(i / 100)
    ...     weight = np.sin(5 * t) ** 2
    ...     estimate = stage.update((1.0, np.sin(t)), weight, (1 - weight) * s + weight * np.arctan(s), t)
    >>> [round(float(value), 2) for value in estimate]
    [3.0, 5.0]
    """

    gain: float = parameter("1/s", 1e-9, 1e9, "speed of the estimate where J has length 1", default=1.0)
    f: str = option("the nonlinearity of the saturating sensor", default="atan")

    def declare(self, **values: Any) -> None:
        """Check the values."""
        super().declare(**values)
        one_of("f", self.f, MONOTONE)

    def settings(self) -> FloatArray:
        """The beginning of the memory."""
        return self._settings(1, NONLINEAR, self.gain * np.eye(int(self.count)), self.f)

    def update(self, regressor: ArrayLike, weight: float, output: ArrayLike, t: float) -> FloatArray:
        """Process a sample at ``t`` s with ``weight`` D1 and return the estimate.

        Raises EventError as ``GradientRegressor`` does, for a weight outside [0, 1], and for a gap over which
        the gain is too large; EventOrderError when time runs backwards; the stage is then unchanged.
        """
        if (estimate := self._taken(t, regressor=regressor, output=output, weight=weight)) is None:
            told = f"received t={t!r}, regressor {regressor!r}"
            raise EventError(
                f"gain J'J over the gap would need more than {STEPS_MOST} steps, {told}", field="t", value=t
            )
        return estimate


def _positive(count: int, gain: ArrayLike) -> FloatArray:
    """A gain as a matrix; raises ParameterError unless it is symmetric and positive definite."""
    try:
        values = np.array(gain, np.float64)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise wrong("gain", "must be numbers", gain) from unusable
    if values.shape not in ((), (count,), (count, count)) or not np.isfinite(values).all():
        raise wrong("gain", f"must be a finite number, {count} or {count} x {count}", gain)
    square = values if values.ndim == 2 else np.diag(np.broadcast_to(values, count))
    if np.abs(square - square.T).max() > 1e-12 * np.abs(square).max():
        raise wrong("gain", "must be symmetric", gain)
    if (least := float(np.linalg.eigvalsh(square).min())) <= 0.0:
        raise wrong("gain", f"must be positive definite, its least eigenvalue is {least:g}", gain)
    return square
