"""Exact motion of a fixed point seen by a moving camera, and the least squares that start a filter, as laws.

In (p, v), both in the camera's frame, p' = -v - w x p and v' = a - w x v: linear, so nothing is linearised
when a step is predicted. In a fixed frame p' = -v and v' = a; only the frame rotates.
"""

from __future__ import annotations

from math import cos, sin, sqrt
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout, clear
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
    s: FloatArray, p: Matrix, h: float, turn: Vector, a: tuple[Vector, Vector], gyro: float, accel: float
) -> None:
    """A state (p, v) and its covariance after ``h`` s, with the acceleration ``a`` before and after."""
    carry(s, h, turn)
    push(s, h, turn, a[0], a[1])
    turn_covariance(p, h, turn)
    add_noise(p, s, gyro, accel)


class Start(Layout):
    """What the images said of the first state s0, s = Phi s0 + g; then space for a trial of the start.

    x Z = X and y Z = Y are linear in (p, v) at the first image. The rows contain the noisy x and y, which
    biases the solution towards small depths (a factor of three at 8 px and 800 px of focal length): the known
    contribution of the noise to the normal matrix is subtracted.
    """

    phi: Matrix
    g: Annotated[FloatArray, 6]
    normal: Matrix
    right: Annotated[FloatArray, 6]
    noise: Matrix
    """Covariance that the sensors' noise adds."""
    lower: Matrix
    """The factor of the normal matrix."""
    first: Annotated[FloatArray, 6]
    now: Annotated[FloatArray, 6]
    row: Annotated[FloatArray, 6]
    spread: Matrix


@law
def begin_start(s: Start) -> None:
    """Forget all images: Phi is the identity."""
    clear(s)
    for i in range(6):
        s.phi.m[i, i] = 1.0


@law
def take_image(s: Start, x: float, y: float, variance: float) -> None:
    """Add an image: N += Phi' Q Phi, b -= Phi' Q g, Q = H'H - 2 r e3 e3', H = (1 0 -x; 0 1 -y)."""
    corner = x * x + y * y - 2.0 * variance
    g0, g1, g2 = s.g[0], s.g[1], s.g[2]
    for i in range(6):
        a0, a1, a2 = s.phi.m[0, i], s.phi.m[1, i], s.phi.m[2, i]
        q0, q1, q2 = a0 - x * a2, a1 - y * a2, -x * a0 - y * a1 + corner * a2
        s.right[i] -= q0 * g0 + q1 * g1 + q2 * g2
        for j in range(6):
            s.normal.m[i, j] += q0 * s.phi.m[0, j] + q1 * s.phi.m[1, j] + q2 * s.phi.m[2, j]


@law
def factor(lower: Matrix) -> bool:
    """Cholesky's lower factor in place; false if the matrix is not safely positive definite."""
    for i in range(6):
        own = lower.m[i, i]
        for j in range(i + 1):
            total = lower.m[i, j]
            for k in range(j):
                total -= lower.m[i, k] * lower.m[j, k]
            if i == j:
                if not total > 1e-12 * own:
                    return False
                lower.m[i, i] = sqrt(total)
            else:
                lower.m[i, j] = total / lower.m[j, j]
    return True


@law
def solve(lower: Matrix, v: FloatArray) -> None:
    """Solve with Cholesky's factor, the vector in place."""
    for i in range(6):
        total = v[i]
        for k in range(i):
            total -= lower.m[i, k] * v[k]
        v[i] = total / lower.m[i, i]
    for i in range(5, -1, -1):
        total = v[i]
        for k in range(i + 1, 6):
            total -= lower.m[k, i] * v[k]
        v[i] = total / lower.m[i, i]


@law
def started(s: Start, state: FloatArray, spread: Matrix, variance: float, share: float) -> bool:
    """Write the current (p, v) and covariance if the relative error of the depth is at most ``share``.

    P = Phi N^-1 Phi' r Z^2, Z^2 the mean square of a depth that changed linearly, plus the sensors' noise.
    """
    for i in range(6):
        for j in range(6):
            s.lower.m[i, j] = s.normal.m[i, j]
    if not factor(s.lower):
        return False
    for i in range(6):
        s.first[i], s.now[i] = s.right[i], s.g[i]
    solve(s.lower, s.first)
    for i in range(6):
        for j in range(6):
            s.now[i] += s.phi.m[i, j] * s.first[j]
    z0, z = s.first[2], s.now[2]
    square = (z0 * z0 + z0 * z + z * z) / 3.0
    if not (z0 > 0.0 and z > 0.0):
        return False
    for i in range(6):  # a row of Phi N^-1, then times Phi'
        for j in range(6):
            s.row[j] = s.phi.m[i, j]
        solve(s.lower, s.row)
        for j in range(6):
            total = 0.0
            for k in range(6):
                total += s.row[k] * s.phi.m[j, k]
            s.spread.m[i, j] = total * variance * square + s.noise.m[i, j]
    if not s.spread.m[2, 2] < (share * z) ** 2:
        return False
    for i in range(6):
        state[i] = s.now[i]
        for j in range(6):
            spread.m[i, j] = 0.5 * (s.spread.m[i, j] + s.spread.m[j, i])
    return True
