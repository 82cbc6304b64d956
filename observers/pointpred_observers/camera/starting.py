"""The initial state of a filter of (p, v): noise-compensated pseudo-linear least squares over the images.

x Z = X and y Z = Y are linear in (p, v) at the first image. The rows contain the noisy x and y, which biases
the solution towards small depths (a factor of three at 8 px and 800 px of focal length): the known
contribution of the noise to the normal matrix is subtracted.
"""

from __future__ import annotations

from math import sqrt
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout, clear
from pointpred.records import FloatArray
from pointpred_observers.camera.kinematics import Matrix


class State(Layout):
    """What the images said of the first state s0, s = Phi s0 + g; then space for a trial of the start."""

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
def begin(s: State) -> None:
    """Forget all images: Phi is the identity."""
    clear(s)
    for i in range(6):
        s.phi.m[i, i] = 1.0


@law
def take(s: State, x: float, y: float, variance: float) -> None:
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
def start(s: State, state: FloatArray, spread: Matrix, variance: float, share: float) -> bool:
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
