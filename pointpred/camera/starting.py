"""Where a filter of (p, v) starts: pseudo-linear least squares over the images so far, noise compensated.

x Z = X and y Z = Y are linear in (p, v) at the first image. The rows contain the noisy x and y, which draws
the solution towards small depths (a factor of three at 8 px and 800 px of focal length): the noise's part of
the normal matrix is known and is taken out again.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from pointpred.columns import FloatArray
from pointpred.compiled import law

CARRY, FORCE, NORMAL, RIGHT, SHAKEN = 0, 36, 42, 78, 84
"""Places relative to ``at``: Phi and g of s = Phi s0 + g, normal matrix, right side, sensor noise."""
STATES = 120


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
def factor(matrix: FloatArray) -> bool:
    """Cholesky's lower factor in place; false where the matrix is not safely positive definite."""
    for i in range(6):
        own = matrix[i, i]
        for j in range(i + 1):
            total = matrix[i, j]
            for k in range(j):
                total -= matrix[i, k] * matrix[j, k]
            if i == j:
                if not total > 1e-12 * own:
                    return False
                matrix[i, i] = sqrt(total)
            else:
                matrix[i, j] = total / matrix[j, j]
    return True


@law
def solved(matrix: FloatArray, vector: FloatArray) -> None:
    """Solve with Cholesky's factor, in place."""
    for i in range(6):
        total = vector[i]
        for k in range(i):
            total -= matrix[i, k] * vector[k]
        vector[i] = total / matrix[i, i]
    for i in range(5, -1, -1):
        total = vector[i]
        for k in range(i + 1, 6):
            total -= matrix[k, i] * vector[k]
        vector[i] = total / matrix[i, i]


@law
def six(memory: FloatArray, at: int) -> FloatArray:
    """A copy of six numbers of the memory."""
    numbers = np.empty(6)
    for i in range(6):
        numbers[i] = memory[at + i]
    return numbers


@law
def start(memory: FloatArray, at: int, state: int, p: int, variance: float, share: float) -> bool:
    """Write (p, v) and its covariance now, if the depth is known to ``share`` of itself; else change nothing.

    P = Phi N^-1 Phi' r Z^2, Z^2 the mean square of a depth that ran evenly since, and the sensors' noise.
    """
    matrix = np.empty((6, 6))
    for i in range(6):
        for j in range(6):
            matrix[i, j] = memory[at + NORMAL + 6 * i + j]
    if not factor(matrix):
        return False
    first = six(memory, at + RIGHT)
    solved(matrix, first)
    now = six(memory, at + FORCE)
    for i in range(6):
        for j in range(6):
            now[i] += memory[at + CARRY + 6 * i + j] * first[j]
    square = (first[2] * first[2] + first[2] * now[2] + now[2] * now[2]) / 3.0
    if not (first[2] > 0.0 and now[2] > 0.0):
        return False
    spread = np.empty((6, 6))  # rows: Phi N^-1, then times Phi'
    for i in range(6):
        row = six(memory, at + CARRY + 6 * i)
        solved(matrix, row)
        for j in range(6):
            total = 0.0
            for k in range(6):
                total += row[k] * memory[at + CARRY + 6 * j + k]
            spread[i, j] = total * variance * square + memory[at + SHAKEN + 6 * i + j]
    if not spread[2, 2] < (share * now[2]) ** 2:
        return False
    for i in range(6):
        memory[state + i] = now[i]
        for j in range(6):
            memory[p + 6 * i + j] = 0.5 * (spread[i, j] + spread[j, i])
    return True
