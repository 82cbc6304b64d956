"""Exact motion of a fixed point seen by a moving camera, as laws.

In (p, v), both in the camera's frame, p' = -v - w x p and v' = a - w x v: linear, so nothing is linearised
when a step is predicted. In a fixed frame p' = -v and v' = a; only the frame rotates.
"""

from __future__ import annotations

from math import cos, sin, sqrt
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import FloatArray, FloatTable

Vector = tuple[float, float, float]
SMALL = 1e-4
"""Below this angle (rad) the series of sin and cos are exact to rounding."""


class Matrix(Layout):
    """6 x 6 numbers, such as the covariance of (p, v)."""

    m: Annotated[FloatTable, 6, 6]


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
def carried(p: Vector, v: Vector, h: float, turn: Vector) -> tuple[Vector, Vector]:
    """(p, v) after ``h`` s without acceleration: p - h v and v, in the rotated frame."""
    px, py, pz = p
    vx, vy, vz = v
    return back(turn, (px - h * vx, py - h * vy, pz - h * vz)), back(turn, v)


@law
def carry(s: FloatArray, h: float, turn: Vector) -> None:
    """``carried`` of s = (p, v)."""
    p, v = carried((s[0], s[1], s[2]), (s[3], s[4], s[5]), h, turn)
    s[0], s[1], s[2] = p
    s[3], s[4], s[5] = v


@law
def carry_column(phi: Matrix, i: int, h: float, turn: Vector) -> None:
    """``carried`` of a column of a matrix."""
    p, v = (phi.m[0, i], phi.m[1, i], phi.m[2, i]), (phi.m[3, i], phi.m[4, i], phi.m[5, i])
    p, v = carried(p, v, h, turn)
    phi.m[0, i], phi.m[1, i], phi.m[2, i] = p
    phi.m[3, i], phi.m[4, i], phi.m[5, i] = v


@law
def push(s: FloatArray, h: float, turn: Vector, before: Vector, after: Vector) -> None:
    """The effect on (p, v) in ``h`` s of an acceleration, linear from ``before`` to ``after`` the rotation.

    Each is given in the frame of its own time.
    """
    bx, by, bz = back(turn, before)
    ax, ay, az = after
    square = h * h
    s[0] -= square * (bx / 3.0 + ax / 6.0)
    s[1] -= square * (by / 3.0 + ay / 6.0)
    s[2] -= square * (bz / 3.0 + az / 6.0)
    s[3] += 0.5 * h * (bx + ax)
    s[4] += 0.5 * h * (by + ay)
    s[5] += 0.5 * h * (bz + az)


@law
def turn_covariance(p: Matrix, h: float, turn: Vector) -> None:
    """A covariance after ``h`` s: Phi P Phi'."""
    for i in range(6):
        carry_column(p, i, h, turn)
    for i in range(6):
        carry(p.m[i], h, turn)


@law
def add_noise(p: Matrix, s: FloatArray, gyro: float, accel: float) -> None:
    """Add the effect of sensor noise with variances (rad^2, m^2/s^2) on s = (p, v) to a covariance.

    A rotation error e moves p by p x e and v by v x e with the same e.
    """
    for block in range(2):
        for other in range(2):
            i, j = 3 * block, 3 * other
            dot = s[i] * s[j] + s[i + 1] * s[j + 1] + s[i + 2] * s[j + 2]
            for row in range(3):
                for column in range(3):
                    value = (dot if row == column else 0.0) - s[j + row] * s[i + column]
                    p.m[i + row, j + column] += gyro * value
    for row in range(3, 6):
        p.m[row, row] += accel


@law
def propagate(
    s: FloatArray,
    p: Matrix,
    h: float,
    turn: Vector,
    acceleration: tuple[Vector, Vector],
    gyro: float,
    accel: float,
) -> None:
    """A state (p, v) and its covariance after ``h`` s, with the ``acceleration`` before and after."""
    before, after = acceleration
    carry(s, h, turn)
    push(s, h, turn, before, after)
    turn_covariance(p, h, turn)
    add_noise(p, s, gyro, accel)
