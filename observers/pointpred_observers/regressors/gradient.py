"""Gradient estimators (3.46) and (3.58): regressors as observers of constants.

The parameters are the constant state of a plant; its reversed connection (section 3.3) estimates them.
"""

from __future__ import annotations

from math import inf
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError
from pointpred.layout import Layout
from pointpred.parameter import option, parameter
from pointpred.records import FloatArray, FloatTable
from pointpred.regression import gradient
from pointpred.regression.least_squares import moment, starting
from pointpred.stage import CompiledStage, loop_into
from pointpred_observers.matrices import TIMES, one_of

CONTINUOUS, DISCRETE, NORMALISED = 0.0, 1.0, 2.0
"""Kinds of law, as stored in the memory."""
TAKEN, BACKWARDS, TOO_STEEP, UNUSABLE = 0, 1, 2, 3
"""Results of a step."""


class Memory(Layout):
    """Unknowns n, outputs p, kind of law; then ``Parts``, whose sizes follow."""

    count: float
    outputs: float
    kind: float
    rest: Annotated[FloatArray, None]


class Parts(NamedTuple):
    """Start (n) and gain (n, n); whether there was a sample, and t; theta minus its start; two samples.

    A sample is p rows of the regressor, then p outputs; the second one lies in the middle of an interval.
    """

    start: FloatArray
    gain: FloatTable
    clock: FloatArray
    theta: FloatArray
    last: FloatArray
    middle: FloatArray


class Sample(NamedTuple):
    """Outputs and their regressor: y (p) = D (p, n) theta."""

    D: FloatTable
    y: FloatArray


@law
def width(n: int, p: int) -> int:
    """Floats of a sample."""
    return p * n + p


@law
def states(n: int, p: int) -> int:
    """Floats of the state."""
    return 2 + n + 2 * width(n, p)


@law
def parts_of(memory: Memory) -> Parts:
    """The parts in their places."""
    n = int(memory.count)
    gain_at, clock_at = n, n + n * n
    theta_at, last_at = clock_at + 2, clock_at + 2 + n
    middle_at = last_at + width(n, int(memory.outputs))
    return Parts(
        memory.rest[:gain_at],
        memory.rest[gain_at:clock_at].reshape(n, n),
        memory.rest[clock_at:theta_at],
        memory.rest[theta_at:last_at],
        memory.rest[last_at:middle_at],
        memory.rest[middle_at : middle_at + middle_at - last_at],
    )


@law
def sample_of(numbers: FloatArray, n: int) -> Sample:
    """The parts of a sample."""
    p = len(numbers) // (n + 1)
    return Sample(numbers[: p * n].reshape(p, n), numbers[p * n : p * n + p])


@law
def finite(row: FloatArray) -> bool:
    """Whether every number of a row is finite."""
    for i in range(1, len(row)):
        if not abs(row[i]) < inf:
            return False
    return bool(abs(row[0]) < inf)


@law
def steepness(d: FloatTable, gain: FloatTable) -> float:
    """The trace of D G D': the sum of the decay rates of the errors of the outputs, in 1/s or per sample."""
    n = len(gain)
    total = 0.0
    for row in range(len(d)):
        for i in range(n):
            for j in range(n):
                total += d[row, i] * gain[i, j] * d[row, j]
    return total


@law
def flow(s: Parts, sample: Sample, h: float) -> None:
    """Follow (3.46) over ``h`` s: exact for one output, a symmetric splitting of second order for several."""
    p = len(sample.y)
    for i in range(2 * p):
        row = i if i < p else 2 * p - 1 - i
        output = sample.y[row]
        for j in range(len(s.start)):
            output -= sample.D[row, j] * s.start[j]
        gradient.descend_along(s.theta, sample.D[row], s.gain, output, 0.5 * h)


@law
def jump(s: Parts, sample: Sample, share: float) -> None:
    """One step of (3.58) with ``share`` of the gain; the outputs of the sample become their errors."""
    n = len(s.start)
    for row in range(len(sample.y)):
        for j in range(n):
            sample.y[row] -= sample.D[row, j] * (s.start[j] + s.theta[j])
    for row in range(len(sample.y)):
        for i in range(n):
            for j in range(n):
                way = s.gain[i, j] * sample.D[row, j]
                s.theta[i] += share * way * sample.y[row]


@law
def step(memory: Memory, row: FloatArray, out: FloatArray) -> int:
    """Process t and a sample and write the estimate to ``out``; a refused row changes nothing."""
    s = parts_of(memory)
    n, new = len(s.start), row[1:]
    if not finite(row):
        return UNUSABLE
    started, h = s.clock[0] == 1.0, row[0] - s.clock[1]
    if started and h < 0.0:
        return BACKWARDS
    middle = sample_of(s.middle, n)
    if memory.kind == CONTINUOUS:
        for i in range(len(s.last)):
            s.middle[i] = 0.5 * (s.last[i] + new[i])
        if started:
            flow(s, middle, h)
    else:
        now = sample_of(new, n)
        steep = steepness(now.D, s.gain)
        if memory.kind == DISCRETE and not steep < 2.0:
            return TOO_STEEP
        for i in range(len(s.last)):
            s.middle[i] = new[i]
        jump(s, middle, 1.0 / (1.0 + steep) if memory.kind == NORMALISED else 1.0)
    for i in range(len(s.last)):
        s.last[i] = new[i]
    s.clock[0], s.clock[1] = 1.0, row[0]
    for i in range(n):
        out[i] = s.start[i] + s.theta[i]
    return TAKEN


class GradientRegressor(CompiledStage):
    """Gradient estimator of constants x in y = D x, as a differential equation or sample by sample.

    Assumes a regressor D that is persistently exciting: nothing is learned in directions that D does not
    excite, and drifting constants are tracked with a lag. Noise is not averaged. More gain is not always
    faster: a large one keeps the estimate on the plane of the newest sample, along which it moves slowly.

    Continuous (3.46): theta' = G D'(y - D theta), with D and y linear between two samples; of
    second order in the interval, exact in theta for one output, and no gain is too large.
    Discrete (3.58): theta += G D'(y - D theta), refused if the trace of D G D' reaches 2, because the error
    could then grow; ``normalised`` divides G by 1 + trace(D G D'), so that no sample is refused.

    Parameters: ``count`` of unknowns n, 1 to 32; ``outputs`` p, 1 to 32; ``gain`` G, a positive
    number, n of them or a positive definite matrix, in 1/s over the square of the regressor's unit
    (discrete: without 1/s); ``time`` "continuous" or "discrete"; ``start`` the first estimate, default zeros.
    Memory: 5 + 2 n + n^2 + 2 p (n + 1) floats. Returns the estimate from ``update``.
    Raises ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, (3.41)-(3.46) and (3.53)-(3.58), with G positive definite where the print
    has nonsingular.

    >>> stage = GradientRegressor(2, gain=3.0)
    >>> for i in range(800):
    ...     t = i / 50
    ...     estimate = stage.update((1.0, np.sin(3 * t)), 3.0 + 5.0 * np.sin(3 * t), t)
    >>> [round(float(value), 3) for value in estimate]
    [3.0, 5.0]
    """

    count: int = parameter("", 1, 32, "number of unknown constants", whole=True, kw_only=False)
    outputs: int = parameter("", 1, 32, "number of outputs in a sample", default=1, whole=True)
    gain: ArrayLike = option("the gain G: a number, one for each constant, or a matrix", default=1.0)
    time: Literal["continuous", "discrete"] = option("'continuous' or 'discrete'", default="continuous")
    normalised: bool = option("whether each step divides the gain by 1 + trace(D G D')", default=False)
    start: ArrayLike | None = option("the first estimate", default=None)
    loop = staticmethod(loop_into(step))

    def declare(self, **values: Any) -> None:
        """Check the values and their combinations."""
        super().declare(**values)
        one_of("time", self.time, TIMES)
        if self.normalised and self.time == "continuous":
            raise ParameterError(
                "normalised needs time='discrete': no gain of the continuous law is too large",
                field="normalised",
                value=self.normalised,
            )
        self.count, self.outputs = int(self.count), int(self.outputs)
        self.width, self.states = self.count, states(self.count, self.outputs)

    def settings(self) -> FloatArray:
        """The beginning of the memory: sizes, kind of law, start and gain."""
        kind = CONTINUOUS if self.time == "continuous" else NORMALISED if self.normalised else DISCRETE
        shape = np.array([float(self.count), float(self.outputs), kind])
        return np.concatenate(
            [shape, starting(self.count, self.start), positive(self.count, self.gain).ravel()]
        )

    def update(self, regressor: ArrayLike, output: ArrayLike, t: float | None = None) -> FloatArray:
        """Process output = regressor theta at ``t`` s and return the estimate.

        The discrete law needs no time. Raises EventError for values that are not finite, of another shape or
        too large, and EventOrderError when time runs backwards; the stage is then unchanged.
        """
        memory = Memory(self._memory)
        started, last_t = parts_of(memory).clock.tolist()
        sample = joined(self.count, self.outputs, regressor, output)
        if t is None and self.time == "continuous":
            raise EventError("the continuous law needs the time of every sample, received t=None", field="t")
        now = last_t if t is None else moment(t, last_t if started == 1.0 else None)
        out = np.empty(self.count)
        if step(memory, np.concatenate([[now], sample]), out) == TOO_STEEP:
            raise EventError(
                "the trace of D G D' must lie below 2, where a step may enlarge the error, received "
                f"regressor {regressor!r}: choose a smaller gain or normalised=True",
                field="regressor",
                value=regressor,
            )
        return out


def joined(count: int, outputs: int, regressor: ArrayLike, output: ArrayLike) -> FloatArray:
    """A sample as one row; raises EventError for an invalid one."""
    try:
        d, y = np.asarray(regressor, np.float64), np.asarray(output, np.float64)
    except (TypeError, ValueError, OverflowError) as unusable:
        raise EventError(
            f"a sample must be numbers, received regressor {regressor!r}, output {output!r}",
            field="regressor",
        ) from unusable
    if d.shape not in ((outputs, count), (count,) if outputs == 1 else ()) or not np.isfinite(d).all():
        raise EventError(
            f"regressor must be finite and of shape ({outputs}, {count}), received {regressor!r}",
            field="regressor",
            value=regressor,
        )
    if y.size != outputs or not np.isfinite(y).all():
        raise EventError(
            f"output must be {outputs} finite numbers, received {output!r}", field="output", value=output
        )
    return np.concatenate([d.ravel(), y.ravel()])


def positive(count: int, gain: ArrayLike) -> FloatArray:
    """A gain as a matrix; raises ParameterError unless it is symmetric and positive definite."""
    try:
        values = np.asarray(gain, np.float64)
    except (TypeError, ValueError) as unusable:
        raise _wrong_gain("be numbers", gain) from unusable
    if values.shape not in ((), (count,), (count, count)) or not np.isfinite(values).all():
        raise _wrong_gain(f"be a finite number, {count} or {count} x {count}", gain)
    matrix = np.diag(np.broadcast_to(values, count)) if values.ndim < 2 else values
    if np.abs(matrix - matrix.T).max() > 1e-12 * np.abs(matrix).max():
        raise _wrong_gain("be symmetric", gain)
    least = float(np.linalg.eigvalsh(matrix).min())
    if least <= 0.0:
        raise _wrong_gain(f"be positive definite, its least eigenvalue is {least:g}", gain)
    return np.array(matrix, np.float64)


def _wrong_gain(must: str, gain: ArrayLike) -> ParameterError:
    return ParameterError(f"gain must {must}, received {gain!r}", field="gain", value=gain)
