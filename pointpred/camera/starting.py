"""The initial state of a filter of (p, v): noise-compensated pseudo-linear least squares over the images.

x Z = X and y Z = Y are linear in (p, v) at the first image. The rows contain the noisy x and y, which biases
the solution towards small depths (a factor of three at 8 px and 800 px of focal length): the known
contribution of the noise to the normal matrix is subtracted.
"""

from __future__ import annotations

from math import sqrt

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.stage import offsets

# Relative to `at`: Phi and g of s = Phi s0 + g, normal matrix, right side, sensor noise; then scratch space
# for the factor of the normal matrix, the first state, the current state, a row and the covariance.
CARRY, FORCE, NORMAL, RIGHT, NOISE, FACTOR, FIRST, NOW, ROW, SPREAD, STATES = offsets(
    36, 6, 36, 6, 36, 36, 6, 6, 6, 36
)


@law
def begin(memory: FloatArray, at: int) -> None:
    """Forget all images: Phi is the identity."""
    memory[at : at + STATES] = 0.0
    for i in range(6):
        memory[at + CARRY + 7 * i] = 1.0


@law
def take(memory: FloatArray, at: int, x: float, y: float, variance: float) -> None:
    """Add an image: N += Phi' Q Phi, b -= Phi' Q g, Q = H'H - 2 r e3 e3', H = (1 0 -x; 0 1 -y)."""
    corner = x * x + y * y - 2.0 * variance
    carry, force = at + CARRY, at + FORCE
    g0, g1, g2 = memory[force], memory[force + 1], memory[force + 2]
    for i in range(6):
        a0, a1, a2 = memory[carry + i], memory[carry + 6 + i], memory[carry + 12 + i]
        q0, q1, q2 = a0 - x * a2, a1 - y * a2, -x * a0 - y * a1 + corner * a2
        memory[at + RIGHT + i] -= q0 * g0 + q1 * g1 + q2 * g2
        for j in range(6):
            memory[at + NORMAL + 6 * i + j] += (
                q0 * memory[carry + j] + q1 * memory[carry + 6 + j] + q2 * memory[carry + 12 + j]
            )


@law
def factor(memory: FloatArray, m: int) -> bool:
    """Cholesky's lower factor in place; false if the matrix is not safely positive definite."""
    for i in range(6):
        own = memory[m + 7 * i]
        for j in range(i + 1):
            total = memory[m + 6 * i + j]
            for k in range(j):
                total -= memory[m + 6 * i + k] * memory[m + 6 * j + k]
            if i == j:
                if not total > 1e-12 * own:
                    return False
                memory[m + 7 * i] = sqrt(total)
            else:
                memory[m + 6 * i + j] = total / memory[m + 7 * j]
    return True


@law
def solve(memory: FloatArray, m: int, v: int) -> None:
    """Solve with Cholesky's factor at ``m``, the vector at ``v`` in place."""
    for i in range(6):
        total = memory[v + i]
        for k in range(i):
            total -= memory[m + 6 * i + k] * memory[v + k]
        memory[v + i] = total / memory[m + 7 * i]
    for i in range(5, -1, -1):
        total = memory[v + i]
        for k in range(i + 1, 6):
            total -= memory[m + 6 * k + i] * memory[v + k]
        memory[v + i] = total / memory[m + 7 * i]


@law
def start(memory: FloatArray, at: int, state: int, p: int, variance: float, share: float) -> bool:
    """Write the current (p, v) and covariance if the relative error of the depth is at most ``share``.

    P = Phi N^-1 Phi' r Z^2, Z^2 the mean square of a depth that changed linearly, plus the sensors' noise.
    """
    lower, first, now, row, spread = at + FACTOR, at + FIRST, at + NOW, at + ROW, at + SPREAD
    for i in range(36):
        memory[lower + i] = memory[at + NORMAL + i]
    if not factor(memory, lower):
        return False
    for i in range(6):
        memory[first + i], memory[now + i] = memory[at + RIGHT + i], memory[at + FORCE + i]
    solve(memory, lower, first)
    for i in range(6):
        for j in range(6):
            memory[now + i] += memory[at + CARRY + 6 * i + j] * memory[first + j]
    z0, z = memory[first + 2], memory[now + 2]
    square = (z0 * z0 + z0 * z + z * z) / 3.0
    if not (z0 > 0.0 and z > 0.0):
        return False
    for i in range(6):  # a row of Phi N^-1, then times Phi'
        for j in range(6):
            memory[row + j] = memory[at + CARRY + 6 * i + j]
        solve(memory, lower, row)
        for j in range(6):
            total = 0.0
            for k in range(6):
                total += memory[row + k] * memory[at + CARRY + 6 * j + k]
            memory[spread + 6 * i + j] = total * variance * square + memory[at + NOISE + 6 * i + j]
    if not memory[spread + 14] < (share * z) ** 2:
        return False
    for i in range(6):
        memory[state + i] = memory[now + i]
        for j in range(6):
            memory[p + 6 * i + j] = 0.5 * (memory[spread + 6 * i + j] + memory[spread + 6 * j + i])
    return True
