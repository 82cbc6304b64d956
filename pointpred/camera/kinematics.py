"""Exact motion of a fixed point seen by a moving camera, as laws on flat arrays.

In (p, v), both in the camera's frame, p' = -v - w x p and v' = a - w x v: linear, so nothing is linearised
when a step is predicted. In a fixed frame p' = -v and v' = a; only the frame rotates.
"""

from __future__ import annotations

from math import cos, sin, sqrt

from pointpred.compiled import law
from pointpred.records import FloatArray

Vector = tuple[float, float, float]
SMALL = 1e-4
"""Below this angle (rad) the series of sin and cos are exact to rounding."""


@law
def back(turn: Vector, vector: Vector) -> Vector:
    """A vector in the frame after a rotation in rad: exp(-[turn]) applied to it (Rodrigues)."""
    rx, ry, rz = turn
    x, y, z = vector
    square = rx * rx + ry * ry + rz * rz
    angle = sqrt(square)
    if angle < SMALL:
        s, c = 1.0 - square / 6.0, 0.5 - square / 24.0
    else:
        s, c = sin(angle) / angle, (1.0 - cos(angle)) / square
    ux, uy, uz = ry * z - rz * y, rz * x - rx * z, rx * y - ry * x
    wx, wy, wz = ry * uz - rz * uy, rz * ux - rx * uz, rx * uy - ry * ux
    return x - s * ux + c * wx, y - s * uy + c * wy, z - s * uz + c * wz


@law
def carry(memory: FloatArray, at: int, stride: int, h: float, turn: Vector) -> None:
    """(p, v) after ``h`` s without acceleration: p - h v and v, in the rotated frame."""
    px = memory[at] - h * memory[at + 3 * stride]
    py = memory[at + stride] - h * memory[at + 4 * stride]
    pz = memory[at + 2 * stride] - h * memory[at + 5 * stride]
    px, py, pz = back(turn, (px, py, pz))
    vx, vy, vz = memory[at + 3 * stride], memory[at + 4 * stride], memory[at + 5 * stride]
    vx, vy, vz = back(turn, (vx, vy, vz))
    memory[at], memory[at + stride], memory[at + 2 * stride] = px, py, pz
    memory[at + 3 * stride], memory[at + 4 * stride], memory[at + 5 * stride] = vx, vy, vz


@law
def push(memory: FloatArray, at: int, h: float, turn: Vector, before: Vector, after: Vector) -> None:
    """The effect on (p, v) in ``h`` s of an acceleration, linear from ``before`` to ``after`` the rotation.

    Each is given in the frame of its own time.
    """
    bx, by, bz = back(turn, before)
    ax, ay, az = after
    square = h * h
    memory[at] -= square * (bx / 3.0 + ax / 6.0)
    memory[at + 1] -= square * (by / 3.0 + ay / 6.0)
    memory[at + 2] -= square * (bz / 3.0 + az / 6.0)
    memory[at + 3] += 0.5 * h * (bx + ax)
    memory[at + 4] += 0.5 * h * (by + ay)
    memory[at + 5] += 0.5 * h * (bz + az)


@law
def turn_covariance(memory: FloatArray, at: int, h: float, turn: Vector) -> None:
    """A 6 x 6 covariance, row by row at ``at``, after ``h`` s: Phi P Phi'."""
    for i in range(6):
        carry(memory, at + i, 6, h, turn)
    for i in range(6):
        carry(memory, at + 6 * i, 1, h, turn)


@law
def add_noise(memory: FloatArray, at: int, state: int, gyro: float, accel: float) -> None:
    """Add the effect of sensor noise with variances (rad^2, m^2/s^2) on (p, v) at ``state`` to a covariance.

    A rotation error e moves p by p x e and v by v x e with the same e.
    """
    for block in range(2):
        for other in range(2):
            i, j = state + 3 * block, state + 3 * other
            dot = memory[i] * memory[j] + memory[i + 1] * memory[j + 1] + memory[i + 2] * memory[j + 2]
            for row in range(3):
                for column in range(3):
                    value = (dot if row == column else 0.0) - memory[j + row] * memory[i + column]
                    memory[at + 6 * (3 * block + row) + 3 * other + column] += gyro * value
    for row in range(3, 6):
        memory[at + 7 * row] += accel
