"""The mixing step of DREM: determinant and adjugate of a small square matrix, valid for singular ones too.

adj(A) y is never formed from an inverse. Its entry i is the determinant of A with column i replaced by y
(Cramer), which holds, and is smooth, for singular A as well.
"""

from __future__ import annotations

from pointpred.compiled import law, layout
from pointpred.records import FloatArray


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
    """Write adj(A) y at ``out`` and return det A; A is the row-major n x n matrix at ``a``."""
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
