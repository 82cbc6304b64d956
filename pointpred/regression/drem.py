"""Dynamic regressor extension and mixing (DREM) with delay operators, thesis section 2.5.3.

``advance`` works inside the memory of any stage: give it an offset and ``states(n)`` floats, write the
regressor at ``at + REGRESSOR`` and call. Estimates stay at ``estimates(at, n)``, where a caller may also set
or restore them. All zeros: no samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import expm1, sqrt
from typing import Any

import msgspec

from pointpred.compiled import law, layout
from pointpred.parameter import parameter
from pointpred.records import FloatArray
from pointpred.regression import delay, gradient
from pointpred.regression.least_squares import moment, sample
from pointpred.stage import CompiledStage


@layout
def work(n: int) -> int:
    """Floats of scratch space that ``mix`` needs."""
    return n * n


@law
def determinant(memory: FloatArray, at: int, n: int) -> float:
    """The determinant of the row-major n x n matrix at ``at``, which is destroyed.

    Elimination with row pivoting.
    """
    result = 1.0
    for k in range(n):
        pivot = k
        for i in range(k + 1, n):
            if abs(memory[at + i * n + k]) > abs(memory[at + pivot * n + k]):
                pivot = i
        value = memory[at + pivot * n + k]
        if value == 0.0:
            return 0.0
        if pivot != k:
            result = -result
            for j in range(k, n):
                top, low = at + k * n + j, at + pivot * n + j
                memory[top], memory[low] = memory[low], memory[top]
        result *= value
        for i in range(k + 1, n):
            factor = memory[at + i * n + k] / value
            for j in range(k + 1, n):
                memory[at + i * n + j] -= factor * memory[at + k * n + j]
    return result


@law
def mix3(memory: FloatArray, a: int, y: int, out: int) -> float:
    """``mix`` for n = 3 in closed form."""
    a11, a12, a13 = memory[a], memory[a + 1], memory[a + 2]
    a21, a22, a23 = memory[a + 3], memory[a + 4], memory[a + 5]
    a31, a32, a33 = memory[a + 6], memory[a + 7], memory[a + 8]
    y1, y2, y3 = memory[y], memory[y + 1], memory[y + 2]
    c11, c12, c13 = a22 * a33 - a23 * a32, a23 * a31 - a21 * a33, a21 * a32 - a22 * a31
    c21, c22, c23 = a13 * a32 - a12 * a33, a11 * a33 - a13 * a31, a12 * a31 - a11 * a32
    c31, c32, c33 = a12 * a23 - a13 * a22, a13 * a21 - a11 * a23, a11 * a22 - a12 * a21
    memory[out] = c11 * y1 + c21 * y2 + c31 * y3
    memory[out + 1] = c12 * y1 + c22 * y2 + c32 * y3
    memory[out + 2] = c13 * y1 + c23 * y2 + c33 * y3
    return float(a11 * c11 + a12 * c12 + a13 * c13)


@law
def mix(memory: FloatArray, a: int, y: int, n: int, out: int, scratch: int) -> float:
    """Write adj(A) y at ``out`` and return det A; A is the row-major n x n matrix at ``a``.

    Entry i of adj(A) y is the determinant of A with column i replaced by y (Cramer), which holds, and is
    smooth, for singular A as well: it is never formed from an inverse.
    """
    if n == 3:
        return mix3(memory, a, y, out)
    for column in range(-1, n):
        for i in range(n):
            for j in range(n):
                memory[scratch + i * n + j] = memory[y + i] if j == column else memory[a + i * n + j]
        value = determinant(memory, scratch, n)
        if column < 0:
            phi = value
        else:
            memory[out + column] = value
    return phi


# Relative to `at`: whether there was a sample, its time, the determinant phi of the last step, the integral
# of gamma phi^2 so far, the regressor w (n).
STARTED, T, PHI, EXCITATION, REGRESSOR = range(5)
# Then: the largest |w_i| so far (n), the estimates (n), the extended output (n), the mixed output (n),
# the extended regressor (n^2), scratch (n^2), the ring of (t, w, y).


@layout
def estimates(at: int, n: int) -> int:
    """Offset of the n estimates."""
    return at + REGRESSOR + 2 * n


@layout
def ring(at: int, n: int) -> int:
    """Offset of the ring of past samples."""
    return at + REGRESSOR + 5 * n + n * n + work(n)


@layout
def states(n: int) -> int:
    """Floats that n parameters need."""
    return ring(0, n) + delay.states(n + 1, delay.capacity(n - 1))


@law
def extend(memory: FloatArray, at: int, n: int, delay_s: float, t: float) -> bool:
    """Fill the rows w(t - i delay), y(t - i delay); False if the history is too short or a row is zero.

    Columns are divided by the largest values so far, the same for all rows, and rows by their norms, so that
    the determinant lies in [-1, 1] in any units.
    """
    scale, output = at + REGRESSOR + n, at + REGRESSOR + 3 * n
    rows, past, samples = output + 2 * n, ring(at, n), delay.capacity(n - 1)
    for i in range(n):
        long_enough, before, after, share = delay.find(memory, past, n + 1, samples, t - i * delay_s)
        if not long_enough:
            return False
        square = 0.0
        for j in range(n):
            value = memory[before + j] + share * (memory[after + j] - memory[before + j])
            value = value / memory[scale + j] if memory[scale + j] > 0.0 else 0.0
            memory[rows + i * n + j] = value
            square += value * value
        if square == 0.0:
            return False
        norm = sqrt(square)
        for j in range(n):
            memory[rows + i * n + j] /= norm
        y = memory[before + n] + share * (memory[after + n] - memory[before + n])
        memory[output + i] = y / norm
    return True


@law
def remember(memory: FloatArray, at: int, n: int, delay_s: float, t: float, output: float) -> float:
    """Store output = regressor . theta at ``t`` without learning; returns the step in s."""
    scale = at + REGRESSOR + n
    h = t - memory[at + T] if memory[at + STARTED] == 1.0 else 0.0
    memory[at + STARTED] = 1.0
    memory[at + T] = t
    slot = delay.push(memory, ring(at, n), n + 1, delay.capacity(n - 1), delay_s / delay.PER_DELAY, t)
    for j in range(n):
        value = memory[at + REGRESSOR + j]
        memory[slot + j] = value
        memory[scale + j] = max(memory[scale + j], abs(value))
    memory[slot + n] = output
    return float(h)


@law
def advance(
    memory: FloatArray, at: int, n: int, delay_s: float, gamma: float, sample: tuple[float, float]
) -> bool:
    """Process a sample (t, regressor . theta); False while the history is shorter than (n - 1) delays.

    With Phi the extended regressor: phi = det Phi, Y~ = adj(Phi) Y = phi theta, and each theta_i follows
    theta_i' = gamma phi (Y~_i - phi theta_i) exactly over the step. ``gamma`` is in 1/s.
    """
    scale, theta, extended = at + REGRESSOR + n, estimates(at, n), at + REGRESSOR + 3 * n
    mixed, rows = extended + n, extended + 2 * n
    t, output = sample
    h = remember(memory, at, n, delay_s, t, output)
    memory[at + PHI] = 0.0
    if not extend(memory, at, n, delay_s, t):
        return False
    phi = mix(memory, rows, extended, n, mixed, rows + n * n)
    memory[at + PHI] = phi
    memory[at + EXCITATION] += gamma * phi * phi * h
    for i in range(n):
        if memory[scale + i] > 0.0:
            target = memory[mixed + i] / memory[scale + i]
            memory[theta + i] = gradient.descend(memory[theta + i], target, phi, gamma, h)
    return True


DELAY_S, GAMMA, AT = range(3)


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
    Memory: 2 + states(count) floats, 701 for three. Raises ParameterError, and EventError and
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
        self.states = states(self.count)

    def settings(self) -> list[float]:
        """The beginning of the memory."""
        return [float(self.delay_s), float(self.gamma)]

    def update(self, regressor: Sequence[float] | FloatArray, output: float, t: float) -> Estimate | None:
        """Process output = regressor . theta at ``t`` s; ``None`` while the history is too short.

        That is before n - 1 delays have passed. Raises EventError for a value that is not finite or a
        regressor of another length, EventOrderError when time runs backwards; the stage is then unchanged.
        """
        memory, n = self._memory, self.count
        last_t = float(memory[AT + T]) if memory[AT + STARTED] == 1.0 else None
        w, y = sample(n, regressor, output)
        now = moment(t, last_t)
        memory[AT + REGRESSOR : AT + REGRESSOR + n] = w
        if not advance(memory, AT, n, memory[DELAY_S], memory[GAMMA], (now, y)):
            return None
        first = estimates(AT, n)
        learnt = -expm1(-float(memory[AT + EXCITATION]))
        return Estimate(now, tuple(memory[first : first + n].tolist()), float(memory[AT + PHI]), learnt)
