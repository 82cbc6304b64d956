"""The Kalman filter of a nearly constant acceleration, as compiled laws in a flat array.

Both axes share a covariance, because both are measured at the same times with the same noise. The
covariance lies at ``p`` as p00 p01 p02 p11 p12 p22, a state at ``x`` as position, velocity, acceleration.
"""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.records import FloatArray

START_SPEED_M_S = 0.3
START_ACCELERATION_M_S2 = 5.0
"""Standard deviations of what the hand may be doing at a restart."""
AXIS, PLANE = 3, 12
"""Floats of an axis; of two axes with their covariance behind them."""


@law
def predict(memory: FloatArray, x: int, dt: float) -> None:
    """One axis after ``dt`` s of constant acceleration."""
    memory[x] += dt * (memory[x + 1] + 0.5 * dt * memory[x + 2])
    memory[x + 1] += dt * memory[x + 2]


@law
def spread(memory: FloatArray, p: int, jerk_density: float, dt: float) -> None:
    """Covariance after ``dt`` s: P <- F P F' + Q, Q that of white jerk integrated exactly."""
    p00, p01, p02 = memory[p], memory[p + 1], memory[p + 2]
    p11, p12, p22 = memory[p + 3], memory[p + 4], memory[p + 5]
    half = 0.5 * dt * dt
    q = jerk_density * dt
    # F P, row by row, then times F'.
    f00, f01, f02 = p00 + dt * p01 + half * p02, p01 + dt * p11 + half * p12, p02 + dt * p12 + half * p22
    g11, g12 = p11 + dt * p12, p12 + dt * p22
    memory[p] = f00 + dt * f01 + half * f02 + q * dt**4 / 20.0
    memory[p + 1] = f01 + dt * f02 + q * dt**3 / 8.0
    memory[p + 2] = f02 + q * dt * dt / 6.0
    memory[p + 3] = g11 + dt * g12 + q * dt * dt / 3.0
    memory[p + 4] = g12 + q * dt / 2.0
    memory[p + 5] = p22 + q


@law
def correct(memory: FloatArray, x: int, p: int, noise: float, measured: float) -> None:
    """One axis after its position was measured with variance ``noise``; the covariance stays."""
    share = (measured - memory[x]) / (memory[p] + noise)
    memory[x] += memory[p] * share
    memory[x + 1] += memory[p + 1] * share
    memory[x + 2] += memory[p + 2] * share


@law
def narrow(memory: FloatArray, p: int, noise: float) -> None:
    """Covariance after a position was measured with variance ``noise``."""
    p00, p01, p02 = memory[p], memory[p + 1], memory[p + 2]
    total = p00 + noise
    # Rounding must not make a variance negative, whatever the parameters.
    memory[p + 3] = max(memory[p + 3] - p01 * p01 / total, 0.0)
    memory[p + 4] -= p01 * p02 / total
    memory[p + 5] = max(memory[p + 5] - p02 * p02 / total, 0.0)
    memory[p], memory[p + 1], memory[p + 2] = p00 * noise / total, p01 * noise / total, p02 * noise / total


@law
def restart(memory: FloatArray, x: int, noise: float) -> None:
    """Both axes at the origin of the path, at a speed that nobody knows."""
    memory[x : x + PLANE] = 0.0
    p = x + 2 * AXIS
    memory[p] = noise
    memory[p + 3] = START_SPEED_M_S**2
    memory[p + 5] = START_ACCELERATION_M_S2**2


@law
def follow(
    memory: FloatArray, x: int, jerk_density: float, noise: float, dt: float, place: tuple[float, float]
) -> None:
    """Both axes and their covariance after ``dt`` s, and after their positions were measured."""
    u, v = place
    p = x + 2 * AXIS
    predict(memory, x, dt)
    predict(memory, x + AXIS, dt)
    spread(memory, p, jerk_density, dt)
    correct(memory, x, p, noise, u)
    correct(memory, x + AXIS, p, noise, v)
    narrow(memory, p, noise)
