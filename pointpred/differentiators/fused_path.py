"""An extended Kalman filter of a path whose acceleration is measured by a turned, biased sensor.

The state is, for each axis, position m, velocity m/s, offset m/s^2 and three weights of the specific force;
then the delay of the positions in s. With the force f, as it differs from a reference, an axis follows

    u' = v,   v' = c + n1 f1 + n2 f2 + n3 f3 + white noise of density q,   c' = white noise of density q_c,

which is linear in the state, and a position measured at time t is u(t - d): the delay d alone makes it bend.
With I and J the first and second integral of f, and d not negative,

    u(t - d) = u - d v + d^2 c / 2 + n (d I(t) - J(t) + J(t - d)),
    du(t - d)/dd = -(v - d c - n (I(t) - I(t - d))).
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from pointpred.compiled import law
from pointpred.records import FloatArray
from pointpred.regression import delay
from pointpred.stage import offsets

# Of the state: an axis; both axes, the delay.
POSITION, VELOCITY, OFFSET, WEIGHT, AXIS = offsets(1, 1, 1, 3)
SECOND = AXIS
DELAY = 2 * AXIS
SIZE = DELAY + 1

DELAY_MOST_S = 0.02
"""Bound on the magnitude of the delay."""
SPACING_S = DELAY_MOST_S / delay.PER_DELAY
RING = delay.capacity(1)
INTEGRALS = 6

# Relative to `at`: the state, its covariance, the force that acts now, its first and second integral, and a
# ring of both integrals.
STATE, COVARIANCE, FORCE, FIRST, TWICE, PAST, LENGTH = offsets(
    SIZE, SIZE * SIZE, 3, 3, 3, delay.states(INTEGRALS, RING)
)


@law
def remember(memory: FloatArray, at: int, t: float) -> None:
    """Store the integrals of the force at ``t`` s."""
    place = delay.push(memory, at + PAST, INTEGRALS, RING, SPACING_S, t)
    for i in range(INTEGRALS):
        memory[place + i] = memory[at + FIRST + i]


@law
def acceleration(memory: FloatArray, at: int, axis: int, force: int) -> float:
    """Of the axis that begins at ``axis`` of the state, m/s^2, for the force at ``force`` of the memory."""
    x = at + STATE + axis
    total = memory[x + OFFSET]
    for i in range(3):
        total += memory[x + WEIGHT + i] * memory[force + i]
    return float(total)


@law
def carry(memory: FloatArray, row: int, stride: int, at: int, dt: float) -> None:
    """Multiply by F: an axis' six numbers at ``row``, ``stride`` apart, after ``dt`` s of the same force."""
    push = memory[row + OFFSET * stride]
    for i in range(3):
        push += memory[row + (WEIGHT + i) * stride] * memory[at + FORCE + i]
    memory[row] += dt * (memory[row + stride] + 0.5 * dt * push)
    memory[row + stride] += dt * push


@law
def predict(memory: FloatArray, at: int, density: float, drift: float, dt: float) -> None:
    """State, covariance and integrals after ``dt`` s; densities of noise in m^2/s^3 and m^2/s^5."""
    p = at + COVARIANCE
    for number in range(2):
        axis = number * AXIS
        carry(memory, at + STATE + axis, 1, at, dt)
        for j in range(SIZE):
            carry(memory, p + axis * SIZE + j, SIZE, at, dt)
    for number in range(2):
        axis = number * AXIS
        for i in range(SIZE):
            carry(memory, p + i * SIZE + axis, 1, at, dt)
    for number in range(2):
        axis = number * AXIS
        row, q, s = p + axis * (SIZE + 1), drift * dt, density * dt
        both = q * dt**3 / 8.0 + 0.5 * s * dt
        memory[row] += q * dt**4 / 20.0 + s * dt * dt / 3.0
        memory[row + VELOCITY] += both
        memory[row + VELOCITY * SIZE] += both
        memory[row + OFFSET] += q * dt * dt / 6.0
        memory[row + OFFSET * SIZE] += q * dt * dt / 6.0
        memory[row + VELOCITY * (SIZE + 1)] += q * dt * dt / 3.0 + s
        memory[row + VELOCITY * SIZE + OFFSET] += 0.5 * q * dt
        memory[row + OFFSET * SIZE + VELOCITY] += 0.5 * q * dt
        memory[row + OFFSET * (SIZE + 1)] += q
    for i in range(3):
        force, first = memory[at + FORCE + i], memory[at + FIRST + i]
        memory[at + TWICE + i] += dt * (first + 0.5 * dt * force)
        memory[at + FIRST + i] = first + dt * force


@law
def correct(memory: FloatArray, at: int, h: FloatArray, error: float, noise: float) -> float:
    """State and covariance after a measurement with row ``h``, its ``error`` and the variance ``noise``.

    Returns how many standard deviations the error is.
    """
    p = at + COVARIANCE
    spread = np.zeros(SIZE)
    total = noise
    for i in range(SIZE):
        for j in range(SIZE):
            spread[i] += memory[p + i * SIZE + j] * h[j]
        total += h[i] * spread[i]
    for i in range(SIZE):
        share = spread[i] / total
        memory[at + STATE + i] += share * error
        for j in range(SIZE):
            memory[p + i * SIZE + j] -= share * spread[j]
        # Rounding must not make a variance negative, whatever the parameters.
        memory[p + i * (SIZE + 1)] = max(memory[p + i * (SIZE + 1)], 0.0)
    late = memory[at + STATE + DELAY]
    memory[at + STATE + DELAY] = min(max(late, -DELAY_MOST_S), DELAY_MOST_S)
    return float(abs(error) / sqrt(total))


@law
def measure(
    memory: FloatArray, at: int, axis: int, now: float, ahead: float, place: float, noise: float
) -> float:
    """The position of an axis was measured as ``place`` m, with ``noise`` m^2.

    ``now`` s is the time of the state, which is ``ahead`` s of the stamp of the position. Returns how many
    standard deviations the position is off.
    """
    x, d = at + STATE + axis, memory[at + STATE + DELAY] + ahead
    h = np.zeros(SIZE)
    known, before, after, share = delay.find(memory, at + PAST, INTEGRALS, RING, now - max(d, 0.0))
    h[axis + POSITION], h[axis + VELOCITY], h[axis + OFFSET] = 1.0, -d, 0.5 * d * d
    slope = memory[x + VELOCITY] - d * memory[x + OFFSET]
    for i in range(3):
        way, first = 0.5 * d * d * memory[at + FORCE + i], d * memory[at + FORCE + i]
        if d > 0.0 and known:
            then = memory[before + i] + share * (memory[after + i] - memory[before + i])
            twice = memory[before + 3 + i] + share * (memory[after + 3 + i] - memory[before + 3 + i])
            way = d * memory[at + FIRST + i] - memory[at + TWICE + i] + twice
            first = memory[at + FIRST + i] - then
        h[axis + WEIGHT + i] = way
        slope -= memory[x + WEIGHT + i] * first
    error = place
    for i in range(AXIS):
        error -= h[axis + i] * memory[x + i]
    h[DELAY] = -slope
    return correct(memory, at, h, error, noise)


@law
def row_of_acceleration(memory: FloatArray, at: int, axis: int) -> FloatArray:
    """The acceleration of an axis under the force that acts now, as a row on the state."""
    h = np.zeros(SIZE)
    h[axis + OFFSET] = 1.0
    for i in range(3):
        h[axis + WEIGHT + i] = memory[at + FORCE + i]
    return h


@law
def sigmas_from_rest(memory: FloatArray, at: int, axis: int, noise: float) -> float:
    """How many standard deviations the acceleration of an axis is from 0, with ``noise`` (m/s^2)^2."""
    h = row_of_acceleration(memory, at, axis)
    total = noise
    for i in range(axis + OFFSET, axis + AXIS):
        for j in range(axis + OFFSET, axis + AXIS):
            total += h[i] * memory[at + COVARIANCE + i * SIZE + j] * h[j]
    return float(abs(acceleration(memory, at, axis, at + FORCE)) / sqrt(total))


@law
def rest(memory: FloatArray, at: int, axis: int, noise: float) -> None:
    """The device rests: the acceleration of the axis is 0, with ``noise`` (m/s^2)^2."""
    h = row_of_acceleration(memory, at, axis)
    correct(memory, at, h, -acceleration(memory, at, axis, at + FORCE), noise)


@law
def acceleration_variance(memory: FloatArray, at: int, axis: int, force: float) -> float:
    """What is not known of offset and weights: the larger variance of an axis' acceleration, (m/s^2)^2.

    Under a ``force`` m/s^2 along one of the first two axes of the sensor, either way; the third is upright.
    """
    row = at + COVARIANCE + (axis + OFFSET) * SIZE + axis
    most = 0.0
    for i in range(2):
        own = memory[at + COVARIANCE + (axis + WEIGHT + i) * (SIZE + 1)]
        both = 2.0 * force * abs(memory[row + WEIGHT + i])
        most = max(most, memory[row + OFFSET] + both + force * force * own)
    return float(most)


@law
def forget(memory: FloatArray, at: int, i: int, variance: float) -> None:
    """Make one number of the state uncertain by ``variance`` and independent of the others."""
    p = at + COVARIANCE
    for j in range(SIZE):
        memory[p + i * SIZE + j] = memory[p + j * SIZE + i] = 0.0
    memory[p + i * (SIZE + 1)] = variance
