"""Least-squares polynomial of speed over distance, updated by Givens rotations, as a law.

The triangular factor of all rows so far takes the place of the rows: a new row is rotated into it, which
is as exact as factorising the whole table anew and never squares its condition. Distances are divided by
a power of two that grows with them; growing rescales the factor's columns without any rounding.
"""

from __future__ import annotations

from math import sqrt

from pointpred.columns import FloatArray
from pointpred.compiled import law

DEGREE_MOST = 4
TERMS = DEGREE_MOST + 1
WIDTH = TERMS + 1

# State, relative to `at`: the unit of distance, the triangular factor with its right side row by row,
# the row on its way into it, the coefficients from the constant up.
UNIT, FACTOR, ROW, COEFFICIENTS = 0, 1, 1 + TERMS * WIDTH, 1 + TERMS * WIDTH + WIDTH
STATES = COEFFICIENTS + TERMS

DEPENDENT = 1e-5
"""A column of the factor whose own part is smaller than this share of it depends on those before it."""


@law
def clear(memory: FloatArray, at: int) -> None:
    """Forget every row."""
    memory[at : at + STATES] = 0.0
    memory[at + UNIT] = 1.0


@law
def grow(memory: FloatArray, at: int, degree: int, distance: float) -> None:
    """Double the unit until the distance is at most one."""
    while distance > memory[at + UNIT]:
        memory[at + UNIT] *= 2.0
        for i in range(degree + 1):
            for j in range(max(i, 1), degree + 1):
                memory[at + FACTOR + i * WIDTH + j] *= 0.5**j


@law
def add(memory: FloatArray, at: int, degree: int, distance: float, speed: float) -> None:
    """Rotate the row (1, d, d^2, ... | speed) into the factor."""
    grow(memory, at, degree, distance)
    row = at + ROW
    power = 1.0
    for j in range(degree + 1):
        memory[row + j] = power
        power *= distance / memory[at + UNIT]
    memory[row + TERMS] = speed
    for i in range(degree + 1):
        below = memory[row + i]
        line = at + FACTOR + i * WIDTH
        own = memory[line + i]
        length = sqrt(own * own + below * below)
        if length > 0.0:
            c, s = own / length, below / length
            memory[line + i] = length
            for j in range(i + 1, degree + 1):
                old = memory[line + j]
                memory[line + j] = c * old + s * memory[row + j]
                memory[row + j] = c * memory[row + j] - s * old
            old = memory[line + TERMS]
            memory[line + TERMS] = c * old + s * memory[row + TERMS]
            memory[row + TERMS] = c * memory[row + TERMS] - s * old


@law
def solve(memory: FloatArray, at: int, degree: int) -> bool:
    """Whether the rows determine the polynomial; its coefficients are then those of d / unit."""
    for j in range(degree + 1):
        whole = 0.0
        for i in range(j + 1):
            whole += memory[at + FACTOR + i * WIDTH + j] ** 2
        own = memory[at + FACTOR + j * WIDTH + j]
        if not own * own > DEPENDENT * DEPENDENT * whole:
            return False
    for i in range(degree, -1, -1):
        line = at + FACTOR + i * WIDTH
        rest = memory[line + TERMS]
        for j in range(i + 1, degree + 1):
            rest -= memory[line + j] * memory[at + COEFFICIENTS + j]
        memory[at + COEFFICIENTS + i] = rest / memory[line + i]
    return True
