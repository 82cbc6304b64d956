"""Nonlinear regression (3.49)-(3.51): an estimator and its condition of convergence, Theorem 3.3.3."""

from __future__ import annotations

from math import ceil
from typing import Any

import msgspec
import numpy as np
from numpy.typing import ArrayLike

from pointpred.compiled import law
from pointpred.errors import EventError, ParameterError, UndecidedError
from pointpred.parameter import option, parameter
from pointpred.records import FloatArray
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

# Parameters: unknowns n, outputs r, gain, code of f, its steepest slope, then the start (n). The state:
# whether there was a sample, its time, the estimate minus its start (n), the last sample, then scratch space
# for an interpolated one (a sample is r rows of J, r outputs, the weight D1) and for the integration (3 n).
COUNT, OUTPUTS, GAIN, CODE, STEEPEST, START = range(6)
# A row holds the time, then a sample.
SAMPLE = 1


@law
def width(n: int, r: int) -> int:
    """Floats of a sample."""
    return r * n + r + 1


@law
def states(n: int, r: int) -> int:
    """Floats of the state."""
    return 2 + n + 2 * width(n, r) + 3 * n


@law
def pace(sample: FloatArray, at: int, n: int, r: int) -> float:
    """The sum of the squares of J, which bounds the eigenvalues of J'J."""
    total = 0.0
    for i in range(r * n):
        total += sample[at + i] * sample[at + i]
    return total


@law
def slope(memory: FloatArray, theta: int, sample: int, to: int) -> None:
    """Write g J'(y - (1 - D1) J theta - D1 f(J theta)) at ``to``; theta minus its start."""
    n, r = int(memory[COUNT]), int(memory[OUTPUTS])
    weight = memory[sample + r * n + r]
    for i in range(n):
        memory[to + i] = 0.0
    for row in range(r):
        s = 0.0
        for i in range(n):
            s += memory[sample + row * n + i] * (memory[theta + i] + memory[START + i])
        error = memory[sample + r * n + row] - (1.0 - weight) * s
        error -= weight * nonlinearity.value(memory[CODE], s)
        for i in range(n):
            memory[to + i] += memory[GAIN] * memory[sample + row * n + i] * error


@law
def flow(memory: FloatArray, row: FloatArray, begin: float, h: float, dt: float) -> None:
    """A step of the classical Runge-Kutta method over the share ``h`` of the interval ``dt``."""
    n, r = int(memory[COUNT]), int(memory[OUTPUTS])
    theta, last = START + n + 2, START + n + 2 + n
    wide = width(n, r)
    between, room = last + wide, last + 2 * wide
    for i in range(n):
        memory[room + i] = memory[theta + i]
        memory[room + 2 * n + i] = 0.0
    for part in range(4):
        at = begin + (0.0 if part == 0 else h if part == 3 else 0.5 * h)
        for i in range(wide):
            memory[between + i] = memory[last + i] + at * (row[SAMPLE + i] - memory[last + i])
        slope(memory, room, between, room + n)
        weight = 1.0 if part == 0 or part == 3 else 2.0
        ahead = h * dt if part == 2 else 0.5 * h * dt
        for i in range(n):
            memory[room + 2 * n + i] += weight * memory[room + n + i]
            memory[room + i] = memory[theta + i] + ahead * memory[room + n + i]
    for i in range(n):
        memory[theta + i] += h * dt / 6.0 * memory[room + 2 * n + i]


@law
def step(memory: FloatArray, row: FloatArray, out: FloatArray) -> int:
    """Process a row and write the estimate to ``out``; a refused row changes nothing."""
    n, r = int(memory[COUNT]), int(memory[OUTPUTS])
    state = START + n
    theta, last = state + 2, state + 2 + n
    if not finite(row) or not 0.0 <= row[SAMPLE + r * n + r] <= 1.0:
        return UNUSABLE
    if memory[state] == 1.0:
        dt = row[0] - memory[state + 1]
        if dt < 0.0:
            return BACKWARDS
        steep = max(pace(memory, last, n, r), pace(row, SAMPLE, n, r))
        needed = memory[GAIN] * steep * memory[STEEPEST] * dt / STEP_MOST
        if not needed <= STEPS_MOST:
            return TOO_FAST
        steps = max(1, ceil(needed))
        if dt > 0.0:
            for i in range(steps):
                flow(memory, row, i / steps, 1.0 / steps, dt)
    memory[state], memory[state + 1] = 1.0, row[0]
    for i in range(width(n, r)):
        memory[last + i] = row[SAMPLE + i]
    for i in range(n):
        out[i] = memory[theta + i] + memory[START + i]
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
        state = START + self.count
        now = moment(t, float(self._memory[state + 1]) if self._memory[state] == 1.0 else None)
        out = np.empty(self.count)
        if step(self._memory, np.concatenate([[now], sample, [share]]), out) == TOO_FAST:
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
