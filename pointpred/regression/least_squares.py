"""Recursive least squares with forgetting, as compiled laws in a flat array: a triangular root, no inverse.

The information A = sum of d^(k-i) w_i w_i' is kept as its triangular root R (A = R'R) with z (psi = R'z).
Plane rotations merge each sample into the triangle, so the condition number is that of the data, not its
square. Rotations commute with a change of the regressor's units: no scaling is needed.

``advance`` works inside the memory of any stage: give it an offset and ``states(n)`` floats, write the
regressor at ``at + REGRESSOR``, call. All zeros: no samples.
"""

from __future__ import annotations

from math import hypot, sqrt

from pointpred.compiled import law, layout
from pointpred.records import FloatArray

# Relative to `at`: samples so far, the same with forgetting, sum of squared residuals with forgetting, the
# regressor (n), which is overwritten; then z (n) and R (n x n, row-major, upper).
SAMPLES, EFFECTIVE, RESIDUAL, REGRESSOR = 0, 1, 2, 3


@layout
def root(at: int, n: int) -> int:
    """Offset of R; z lies n floats before it."""
    return at + REGRESSOR + 2 * n


@layout
def states(n: int) -> int:
    """Floats that n parameters need."""
    return REGRESSOR + 2 * n + n * n


@law
def advance(memory: FloatArray, at: int, n: int, forgetting: float, output: float) -> None:
    """A = d A + w w', psi = d psi + w y for the regressor w at ``at + REGRESSOR`` and y = ``output``."""
    w, z, r = at + REGRESSOR, at + REGRESSOR + n, root(at, n)
    if forgetting < 1.0:
        keep = sqrt(forgetting)
        for i in range(n + n * n):
            memory[z + i] *= keep
    rest = output
    for i in range(n):
        top, low = memory[r + i * n + i], memory[w + i]
        length = hypot(top, low)
        if low == 0.0 or length == 0.0:
            continue
        cosine, sine = top / length, low / length
        for j in range(i, n):
            upper, lower = memory[r + i * n + j], memory[w + j]
            memory[r + i * n + j] = cosine * upper + sine * lower
            memory[w + j] = cosine * lower - sine * upper
        memory[z + i], rest = cosine * memory[z + i] + sine * rest, cosine * rest - sine * memory[z + i]
    memory[at + SAMPLES] += 1.0
    memory[at + EFFECTIVE] = forgetting * memory[at + EFFECTIVE] + 1.0
    memory[at + RESIDUAL] = forgetting * memory[at + RESIDUAL] + rest * rest


@law
def excitation(memory: FloatArray, at: int, n: int, j: int) -> float:
    """The sine of the angle between column j of the data and those before it: 0 if it depends on them."""
    r = root(at, n)
    square = 0.0
    for i in range(j + 1):
        square += memory[r + i * n + j] * memory[r + i * n + j]
    return abs(memory[r + j * n + j]) / sqrt(square) if square > 0.0 else 0.0


@law
def solve(memory: FloatArray, at: int, n: int, least: float, out: int) -> bool:
    """Write the estimate at ``out``; False, without writing, if an excitation is below ``least``."""
    for j in range(n):
        if excitation(memory, at, n, j) < least:
            return False
    r, z = root(at, n), at + REGRESSOR + n
    for back in range(n):
        i = n - 1 - back
        value = memory[z + i]
        for j in range(i + 1, n):
            value -= memory[r + i * n + j] * memory[out + j]
        memory[out + i] = value / memory[r + i * n + i]
    return True
