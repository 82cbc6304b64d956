"""Dynamic regressor extension and mixing (DREM) with delay operators, thesis section 2.5.3.

``advance`` works inside the memory of any stage: give it an offset and ``states(n)`` floats, write the
regressor at ``at + REGRESSOR`` and call. Estimates stay at ``estimates(at, n)``, where a caller may also set
or restore them. All zeros: no samples.
"""

from __future__ import annotations

from math import sqrt

from pointpred.compiled import law, layout
from pointpred.records import FloatArray
from pointpred.regression import delay, gradient, mixing

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
    return at + REGRESSOR + 5 * n + n * n + mixing.work(n)


@layout
def states(n: int) -> int:
    """Floats that n parameters need."""
    return ring(0, n) + delay.states(n + 1, delay.capacity(n - 1))


@law
def restart(memory: FloatArray, at: int, n: int) -> None:
    """Forget everything, estimates included."""
    memory[at : at + states(n)] = 0.0


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
    phi = mixing.mix(memory, rows, extended, n, mixed, rows + n * n)
    memory[at + PHI] = phi
    memory[at + EXCITATION] += gamma * phi * phi * h
    for i in range(n):
        if memory[scale + i] > 0.0:
            target = memory[mixed + i] / memory[scale + i]
            memory[theta + i] = gradient.descend(memory[theta + i], target, phi, gamma, h)
    return True
