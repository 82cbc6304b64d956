"""Dynamic regressor extension and mixing (DREM) with delay operators, thesis section 2.5.3.

A stage that has a regression keeps a ``State`` and ``numbers(n)`` floats, writes the regressor w of ``parts``
and calls ``advance``. Estimates stay at theta, where it may also set or restore them. All zeros: no samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import expm1, sqrt
from typing import Annotated, Any, NamedTuple

import msgspec

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.parameter import parameter
from pointpred.records import FloatArray, FloatTable
from pointpred.regression import delay, gradient
from pointpred.regression.least_squares import moment, sample
from pointpred.stage import CompiledStage


class State(Layout):
    """What a regression remembers besides the numbers of ``parts``."""

    started: float
    t: float
    phi: float
    """The determinant phi of the last step."""
    excitation: float
    """The integral of gamma phi^2 so far."""


class Regression(NamedTuple):
    """The numbers of a regression of n unknowns."""

    w: FloatArray
    """The regressor."""
    largest: FloatArray
    """The largest |w_i| so far: the units in which the rest is computed."""
    theta: FloatArray
    """The estimates."""
    Y: FloatArray
    """The extended output."""
    mixed: FloatArray
    """The mixed output Y~."""
    Phi: FloatTable
    """The extended regressor."""
    scratch: FloatArray
    past: FloatArray
    """The ring of past w and y."""


@law
def numbers(n: int) -> int:
    """Floats that n unknowns need besides the state."""
    return 5 * n + 2 * n * n + delay.states(n, delay.capacity(n - 1))


@law
def parts(memory: FloatArray, n: int) -> Regression:
    """The parts of ``numbers(n)`` floats."""
    tables = 5 * n
    ring = tables + 2 * n * n
    return Regression(
        memory[:n],
        memory[n : 2 * n],
        memory[2 * n : 3 * n],
        memory[3 * n : 4 * n],
        memory[4 * n : 5 * n],
        memory[tables : tables + n * n].reshape(n, n),
        memory[tables + n * n : ring],
        memory[ring:],
    )


@law
def determinant(a: FloatTable) -> float:
    """The determinant of a square matrix, which is destroyed, by elimination with row pivoting."""
    n = len(a)
    result = 1.0
    for k in range(n):
        pivot = k
        for i in range(k + 1, n):
            if abs(a[i, k]) > abs(a[pivot, k]):
                pivot = i
        value = a[pivot, k]
        if value == 0.0:
            return 0.0
        if pivot != k:
            result = -result
            for j in range(k, n):
                a[k, j], a[pivot, j] = a[pivot, j], a[k, j]
        result *= value
        for i in range(k + 1, n):
            factor = a[i, k] / value
            for j in range(k + 1, n):
                a[i, j] -= factor * a[k, j]
    return result


@law
def mix3(a: FloatTable, y: FloatArray, out: FloatArray) -> float:
    """``mix`` for n = 3 in closed form."""
    a11, a12, a13 = a[0, 0], a[0, 1], a[0, 2]
    a21, a22, a23 = a[1, 0], a[1, 1], a[1, 2]
    a31, a32, a33 = a[2, 0], a[2, 1], a[2, 2]
    c11, c12, c13 = a22 * a33 - a23 * a32, a23 * a31 - a21 * a33, a21 * a32 - a22 * a31
    c21, c22, c23 = a13 * a32 - a12 * a33, a11 * a33 - a13 * a31, a12 * a31 - a11 * a32
    c31, c32, c33 = a12 * a23 - a13 * a22, a13 * a21 - a11 * a23, a11 * a22 - a12 * a21
    out[0] = c11 * y[0] + c21 * y[1] + c31 * y[2]
    out[1] = c12 * y[0] + c22 * y[1] + c32 * y[2]
    out[2] = c13 * y[0] + c23 * y[1] + c33 * y[2]
    return float(a11 * c11 + a12 * c12 + a13 * c13)


@law
def mix(a: FloatTable, y: FloatArray, out: FloatArray, scratch: FloatArray) -> float:
    """Write adj(A) y to ``out`` and return det A; ``scratch`` has room for A.

    Entry i of adj(A) y is the determinant of A with column i replaced by y (Cramer), which holds, and is
    smooth, for singular A as well: it is never formed from an inverse.
    """
    n = len(y)
    if n == 3:
        return mix3(a, y, out)
    replaced = scratch.reshape(n, n)
    for column in range(-1, n):
        for i in range(n):
            for j in range(n):
                replaced[i, j] = y[i] if j == column else a[i, j]
        value = determinant(replaced)
        if column < 0:
            phi = value
        else:
            out[column] = value
    return phi


@law
def extend(r: Regression, delay_s: float, t: float) -> bool:
    """Phi and Y: row i is w and y at t - i delay_s; False if the history is too short or a row is zero.

    Columns are divided by the largest values so far, the same for all rows, and rows by their norms, so that
    the determinant lies in [-1, 1] in any units.
    """
    n = len(r.w)
    past, samples = delay.Ring(r.past), delay.capacity(n - 1)
    for i in range(n):
        row = r.Phi[i]
        known, y = delay.delayed(past, samples, t - i * delay_s, row)
        if not known:
            return False
        square = 0.0
        for j in range(n):
            row[j] = row[j] / r.largest[j] if r.largest[j] > 0.0 else 0.0
            square += row[j] * row[j]
        if square == 0.0:
            return False
        norm = sqrt(square)
        for j in range(n):
            row[j] /= norm
        r.Y[i] = y / norm
    return True


@law
def remember(s: State, r: Regression, delay_s: float, t: float, y: float) -> float:
    """Store y = w'theta at ``t`` without learning; returns the step in s."""
    h = t - s.t if s.started == 1.0 else 0.0
    s.started, s.t = 1.0, t
    n = len(r.w)
    delay.push(delay.Ring(r.past), delay.capacity(n - 1), delay_s / delay.PER_DELAY, t, r.w, y)
    for j in range(n):
        r.largest[j] = max(r.largest[j], abs(r.w[j]))
    return h


@law
def advance(s: State, r: Regression, delay_s: float, gamma: float, t: float, y: float) -> bool:
    """Learn from y = w'theta at ``t``; False while the history is shorter than (n - 1) delays.

    phi = det Phi, Y~ = adj(Phi) Y = phi theta, and each theta_i follows theta_i' = gamma phi (Y~_i - phi
    theta_i) exactly over the step. ``gamma`` is in 1/s.
    """
    h = remember(s, r, delay_s, t, y)
    s.phi = 0.0
    if not extend(r, delay_s, t):
        return False
    phi = mix(r.Phi, r.Y, r.mixed, r.scratch)
    s.phi = phi
    s.excitation += gamma * phi * phi * h
    for i in range(len(r.theta)):
        if r.largest[i] > 0.0:
            r.theta[i] = gradient.descend(r.theta[i], r.mixed[i] / r.largest[i], phi, gamma, h)
    return True


class Memory(Layout):
    """Of the stage: its parameters, the regression."""

    delay_s: float
    gamma: float
    state: State
    numbers: Annotated[FloatArray, None]


class Estimate(msgspec.Struct, frozen=True):
    """The constants at ``t`` s.

    ``phi`` in [-1, 1] is the present excitation, and ``learnt`` in [0, 1] the fraction covered of the
    distance from the initial values (zeros) to the constants: below 1 the values are biased towards zero.
    """

    t: float
    values: tuple[float, ...]
    phi: float
    learnt: float


class DynamicRegressorExtension(CompiledStage):
    """Dynamic regressor extension and mixing (DREM) with the delays 0, tau, 2 tau, ...

    Assumes y = w'theta with constant theta. Needs some excitation, though not persistent: over short delays
    the rows are nearly equal, phi falls with the power n (n - 1) / 2 of the delay, and noise dominates.

    Row i of Phi and Y is w and y delayed by i tau; phi = det Phi, Y~ = adj(Phi) Y = phi theta, so that each
    theta_i' = gamma phi (Y~_i - phi theta_i) is independent; integrated exactly over each step. Columns are
    scaled by their largest values so far and rows by their norms: |phi| <= 1 in any units.

    Parameters: ``count`` of unknowns, 2 to 6; ``delay_s`` tau in s; ``gamma`` in 1/s, the rate at full
    excitation (real phi are small: 1e6 is not unusual).
    Memory: 6 + numbers(count) floats, 701 for three. Raises ParameterError, and EventError and
    EventOrderError from ``update``.

    Reference: Khalin 2022, section 2.5.3, with the delay e^(-i tau s) where e^(i tau s) is printed;
    Aranovskiy, Bobtsov, Ortega, Pyrkin 2016.

    >>> from math import sin
    >>> stage = DynamicRegressorExtension(2, delay_s=0.5, gamma=100.0)
    >>> for i in range(300):
    ...     estimate = stage.update((sin(i / 50), 1.0), 3.0 * sin(i / 50) + 2.0, i / 100)
    >>> [round(value, 6) for value in estimate.values]
    [3.0, 2.0]
    """

    count: int = parameter("", 2, 6, "number of unknown constants", default=3, whole=True, kw_only=False)
    delay_s: float = parameter("s", 1e-4, 1e2, "basic delay tau", default=0.1)
    gamma: float = parameter("1/s", 0.0, 1e18, "rate of the estimates at full excitation", default=1e6)

    def declare(self, **values: Any) -> None:
        """Check the values."""
        super().declare(**values)
        self.count = int(self.count)
        self.states = State.length + numbers(self.count)

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        return [float(self.delay_s), float(self.gamma)]

    def update(self, regressor: Sequence[float] | FloatArray, output: float, t: float) -> Estimate | None:
        """Process output = regressor . theta at ``t`` s; ``None`` while the history is too short.

        That is before n - 1 delays have passed. Raises EventError for a value that is not finite or a
        regressor of another length, EventOrderError when time runs backwards; the stage is then unchanged.
        """
        memory = Memory(self._memory)
        s, r = memory.state, parts(memory.numbers, self.count)
        last_t = float(s.t) if s.started == 1.0 else None
        w, y = sample(self.count, regressor, output)
        now = moment(t, last_t)
        r.w[:] = w
        if not advance(s, r, memory.delay_s, memory.gamma, now, y):
            return None
        return Estimate(now, tuple(r.theta.tolist()), float(s.phi), -expm1(-float(s.excitation)))
