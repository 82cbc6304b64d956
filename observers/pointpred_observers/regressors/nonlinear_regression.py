"""Nonlinear regression (3.49)-(3.51): an estimator and its condition of convergence, Theorem 3.3.3."""

from __future__ import annotations

from math import ceil
from typing import Annotated, Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError, UndecidedError
from pointpred.layout import Layout
from pointpred.parameter import option, parameter
from pointpred.records import FloatArray, FloatTable
from pointpred.regression.least_squares import moment, starting
from pointpred.stage import CompiledStage, loop_into
from pointpred_observers import nonlinearity
from pointpred_observers.matrices import positive, vector
from pointpred_observers.nonlinearity import KNOWN
from pointpred_observers.regressors.excitation import increasing, samples
from pointpred_observers.regressors.gradient import finite, joined

MONOTONE = tuple(name for name, one in KNOWN.items() if one.low >= 0.0 and np.isfinite(one.high))
"""Nondecreasing nonlinearities with a bounded slope."""
PASSES_MOST = 200
TAKEN, BACKWARDS, TOO_FAST, UNUSABLE = 0, 1, 2, 3
"""Results of a step."""
STEPS_MOST = 10_000
"""Most integration steps for one sample."""
STEP_MOST = 0.5
"""Longest step of the integration, in units of the fastest time constant."""


class Memory(Layout):
    """Unknowns n, outputs r, gain, code of f, its steepest slope; then ``Parts``, whose sizes follow."""

    count: float
    outputs: float
    gain: float
    code: float
    steepest: float
    rest: Annotated[FloatArray, None]


class Parts(NamedTuple):
    """Start (n); whether there was a sample, and t; theta minus its start; the last sample.

    Then space for an interpolated sample and for a step of the integration (n each).
    """

    start: FloatArray
    clock: FloatArray
    theta: FloatArray
    last: FloatArray
    between: FloatArray
    stage: FloatArray
    change: FloatArray
    total: FloatArray


class Sample(NamedTuple):
    """The regressor J (r, n), the outputs y (r) and the weight D1, one behind the other."""

    J: FloatTable
    y: FloatArray
    weight: float


@law
def width(n: int, r: int) -> int:
    """Floats of a sample."""
    return r * n + r + 1


@law
def states(n: int, r: int) -> int:
    """Floats of the state."""
    return 2 + n + 2 * width(n, r) + 3 * n


@law
def parts_of(memory: Memory) -> Parts:
    """The parts in their places."""
    n = int(memory.count)
    wide = width(n, int(memory.outputs))
    theta_at, last_at = n + 2, n + 2 + n
    between_at, stage_at = last_at + wide, last_at + 2 * wide
    return Parts(
        memory.rest[:n],
        memory.rest[n:theta_at],
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
    r = (len(numbers) - 1) // (n + 1)
    return Sample(numbers[: r * n].reshape(r, n), numbers[r * n : r * n + r], numbers[r * n + r])


@law
def pace(regressor: FloatTable) -> float:
    """The sum of the squares of J, which bounds the eigenvalues of J'J."""
    total = 0.0
    for row in range(len(regressor)):
        for i in range(regressor.shape[1]):
            total += regressor[row, i] * regressor[row, i]
    return total


@law
def slope(memory: Memory, s: Parts) -> None:
    """Write g J'(y - (1 - D1) J theta - D1 f(J theta)) of the stage at the interpolated sample."""
    n = len(s.start)
    sample = sample_of(s.between, n)
    for i in range(n):
        s.change[i] = 0.0
    for row in range(len(sample.y)):
        argument = 0.0
        for i in range(n):
            argument += sample.J[row, i] * (s.stage[i] + s.start[i])
        error = sample.y[row] - (1.0 - sample.weight) * argument
        error -= sample.weight * nonlinearity.value(memory.code, argument)
        for i in range(n):
            s.change[i] += memory.gain * sample.J[row, i] * error


@law
def flow(memory: Memory, s: Parts, new: FloatArray, begin: float, h: float, dt: float) -> None:
    """A step of the classical Runge-Kutta method over the share ``h`` of the interval ``dt``."""
    n = len(s.start)
    for i in range(n):
        s.stage[i] = s.theta[i]
        s.total[i] = 0.0
    for part in range(4):
        at = begin + (0.0 if part == 0 else h if part == 3 else 0.5 * h)
        for i in range(len(s.last)):
            s.between[i] = s.last[i] + at * (new[i] - s.last[i])
        slope(memory, s)
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
    sample = sample_of(new, n)
    if not finite(row) or not 0.0 <= sample.weight <= 1.0:
        return UNUSABLE
    if s.clock[0] == 1.0:
        dt = row[0] - s.clock[1]
        if dt < 0.0:
            return BACKWARDS
        last = sample_of(s.last, n)
        steep = max(pace(last.J), pace(sample.J))
        needed = memory.gain * steep * memory.steepest * dt / STEP_MOST
        if not needed <= STEPS_MOST:
            return TOO_FAST
        steps = max(1, ceil(needed))
        if dt > 0.0:
            for i in range(steps):
                flow(memory, s, new, i / steps, 1.0 / steps, dt)
    s.clock[0], s.clock[1] = 1.0, row[0]
    for i in range(len(new)):
        s.last[i] = new[i]
    for i in range(n):
        out[i] = s.theta[i] + s.start[i]
    return TAKEN


class NonlinearRegressor(CompiledStage):
    """Estimator of constants x in y = (1 - D1) J x + D1 f(J x), a mean of a linear and a saturating sensor.

    Assumes that J is persistently exciting and f nondecreasing; where f is flat and D1 near 1 nothing is
    learned. Drifting constants are tracked with a lag.

    theta' = g J'(y - (1 - D1) J theta - D1 f(J theta)), with J, D1 and y linear between two samples,
    by the classical Runge-Kutta method in steps of half the fastest time constant.

    Parameters: ``count`` of unknowns n, 1 to 32; ``outputs`` r, 1 to 32; ``gain`` g in 1/s over the
    square of J's unit, > 0; ``f`` one of identity, tanh, atan, saturation; ``start`` the first estimate,
    default zeros. Memory: 7 + 5 n + 2 (r n + r + 1) floats. Returns the estimate from ``update``. Raises
    ParameterError, and EventError and EventOrderError from ``update``.

    Reference: Khalin 2022, (3.47)-(3.51); before (3.51) the print lacks a J in J'J z.

    >>> stage = NonlinearRegressor(2, f="atan", gain=2.0)
    >>> for i in range(4000):
    ...     t, s = i / 100, 3.0 + 5.0 * np.sin(i / 100)
    ...     weight = np.sin(5 * t) ** 2
    ...     estimate = stage.update((1.0, np.sin(t)), weight, (1 - weight) * s + weight * np.arctan(s), t)
    >>> [round(float(value), 2) for value in estimate]
    [3.0, 5.0]
    """

    count: int = parameter("", 1, 32, "number of unknown constants", whole=True, kw_only=False)
    outputs: int = parameter("", 1, 32, "number of outputs in a sample", default=1, whole=True)
    gain: float = parameter("1/s", 1e-9, 1e9, "speed of the estimate where J has length 1", default=1.0)
    f: str = option("the nonlinearity of the saturating sensor", default="atan")
    start: ArrayLike | None = option("the first estimate", default=None)
    loop = staticmethod(loop_into(step))

    def declare(self, **values: Any) -> None:
        """Check the values."""
        super().declare(**values)
        if self.f not in MONOTONE:
            raise ParameterError(
                f"f must be one of {', '.join(MONOTONE)}, which do not fall, received {self.f!r}",
                field="f",
                value=self.f,
            )
        self.count, self.outputs = int(self.count), int(self.outputs)
        self.width, self.states = self.count, states(self.count, self.outputs)

    def settings(self) -> FloatArray:
        """The beginning of the memory: sizes, gain, nonlinearity and start."""
        f = KNOWN[self.f]
        shape = np.array([self.count, self.outputs, self.gain, f.code, max(1.0, f.high)])
        return np.concatenate([shape, starting(self.count, self.start)])

    def update(self, regressor: ArrayLike, weight: float, output: ArrayLike, t: float) -> FloatArray:
        """Process a sample at ``t`` s with ``weight`` D1 and return the estimate.

        Raises EventError for values that are not finite or of another shape, a weight outside [0, 1], or a
        gap over which the gain is too large; EventOrderError when time runs backwards; the stage is then
        unchanged.
        """
        sample = joined(self.count, self.outputs, regressor, output)
        try:
            share = float(weight)
        except (TypeError, ValueError) as unusable:
            raise EventError(
                f"weight must be a number, received {weight!r}", field="weight", value=weight
            ) from unusable
        if not 0.0 <= share <= 1.0:
            raise EventError(f"weight must lie in [0, 1], received {weight!r}", field="weight", value=weight)
        memory = Memory(self._memory)
        started, last_t = parts_of(memory).clock.tolist()
        now = moment(t, last_t if started == 1.0 else None)
        out = np.empty(self.count)
        if step(memory, np.concatenate([[now], sample, [share]]), out) == TOO_FAST:
            raise EventError(
                f"gain J'J over the gap would need more than {STEPS_MOST} steps, received t={t!r}, "
                f"regressor {regressor!r}",
                field="t",
                value=t,
            )
        return out


class RegressionMargin(msgspec.Struct, frozen=True):
    """The least ``margin`` of Theorem 3.3.3 over the record, the time ``at`` which it occurs, and P there.

    With a positive margin V = e'Pe decreases by at least 2 margin abs(e)^2; otherwise the theorem does not
    apply.
    """

    margin: float
    at: float
    P: FloatArray


def regression_margin(
    t: ArrayLike, regressor: ArrayLike, weight: ArrayLike, gain: float, *, flattest: float = 0.0
) -> RegressionMargin:
    """The margin of Theorem 3.3.3 on a record of J and D1 that repeats periodically.

    Assumes f with slopes between ``flattest`` and 1, and J, D1 constant within a sample's interval.
    The theorem shows asymptotic stability, not the input-to-state stability that it claims.

    P' = g (P J'J + J'J P) - I, solved backwards; with f(Jw) - f(Jz) = s J e the condition
    -g D1 e'P J'(f(Jw) - f(Jz) - J e) < e'e / 2 is g D1 (1 - s) max eig sym(P J'J) < 1/2 at the flattest s.

    Parameters: ``t`` s, increasing; ``regressor`` (samples, n) or (samples, r, n); ``weight`` D1 in [0, 1];
    ``gain`` g > 0; ``flattest`` in [0, 1]. Raises ParameterError; UndecidedError if P does not converge, as
    without excitation.

    Reference: Khalin 2022, (3.52), Theorem 3.3.3.

    >>> t = np.linspace(0.0, 2 * np.pi, 200)
    >>> j = np.stack([np.cos(t), np.sin(t)], axis=1)
    >>> round(regression_margin(t, j, np.full(200, 0.2), 1.0).margin, 3)
    0.288
    """
    times = increasing(t)
    j = samples(regressor, len(times))
    d1 = vector("weight", weight, len(times))
    if not ((d1 >= 0.0) & (d1 <= 1.0)).all():
        raise ParameterError(
            f"weight must lie in [0, 1] in every sample, received {weight!r}", field="weight"
        )
    gain, flattest = positive("gain", gain), positive("flattest", flattest, zero=True)
    if flattest > 1.0:
        raise ParameterError(f"flattest must lie in [0, 1], received {flattest!r}", field="flattest")
    squares = np.einsum("kri,krj->kij", j, j)
    middle, h = 0.5 * (squares[:-1] + squares[1:]), np.diff(times)
    values, vectors = np.linalg.eigh(middle)
    rate = gain * np.maximum(values, 0.0) * h[:, None]
    fade = np.einsum("kia,ka,kja->kij", vectors, np.exp(-rate), vectors)
    gained = np.einsum("kia,ka,kja->kij", vectors, _share(2.0 * rate) * h[:, None], vectors)
    p, last = np.zeros(squares.shape[1:]), np.inf
    for _ in range(PASSES_MOST):
        first, backwards = p, []
        for forget, new in zip(fade[::-1], gained[::-1], strict=True):
            p = new + forget @ p @ forget
            backwards.append(p)
        last = float(np.abs(p - first).max()) / float(np.abs(p).max())
        if last < 1e-9:
            break
    else:
        raise UndecidedError(
            f"P still changes by {last:.2g} of itself after {PASSES_MOST} passes: no excitation?"
        )
    return _least(times, np.array(backwards[::-1]), squares[:-1], d1[:-1], gain * (1.0 - flattest))


def _share(x: FloatArray) -> FloatArray:
    """(1 - exp(-x)) / x, 1 at 0."""
    small = np.where(x > 1e-12, x, 1.0)
    return np.where(x > 1e-12, -np.expm1(-small) / small, 1.0)


def _least(
    times: FloatArray, p: FloatArray, squares: FloatArray, d1: FloatArray, gain: float
) -> RegressionMargin:
    product = p @ squares
    worst = np.linalg.eigvalsh(0.5 * (product + np.swapaxes(product, 1, 2)))[:, -1]
    margins = 0.5 - gain * d1 * worst
    k = int(margins.argmin())
    return RegressionMargin(float(margins[k]), float(times[k]), p[k])
