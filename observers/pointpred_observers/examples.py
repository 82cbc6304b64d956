"""The systems of examples 1 to 9 of the thesis, corrected where the print is wrong."""

from __future__ import annotations

from typing import Any

import numpy as np

from pointpred.records import FloatArray
from pointpred_observers.plants.generator import Generator
from pointpred_observers.plants.persidskii import Persidskii
from pointpred_observers.plants.symbolic import SymbolicGenerator, SymbolicSystem, symbolic

ROBOT_INPUT = (0.0, 21.6, 0.0, 0.0)
"""B of the robotic arm: the input drives the motor only."""
ROBOT_INPUT_MODIFIED = (0.0, 21.6, 21.6, 0.0)
"""B~ of the thesis, which also drives the link's angle, although no motor acts there."""


def academic() -> tuple[Persidskii, Generator]:
    """Example 1: three states under a two-state oscillator."""
    a0 = [[0.0, 1.0, 0.0], [0.0, 0.0, 0.0], [-1.0, -2.0, -1.0]]
    b = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
    plant = Persidskii(a0, [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], "sin", b, None, [1.0, 0.0, 0.0])
    return plant, Generator([[0.0, 1.0], [-2.0, 0.0]], [0.0, 0.0], L0=np.eye(2), L1=[[-1.0], [0.0]])


def robotic_arm(b: tuple[float, ...] = ROBOT_INPUT, *, reach: float = 1.0) -> tuple[Persidskii, Generator]:
    """Example 3: a flexible arm and its regulator with Pi = I; sin has its slopes within ``reach`` rad."""
    a0 = np.array(
        [[0.0, 1.0, 0.0, 0.0], [-48.6, -1.25, 48.6, 0.0], [0.0, 0.0, 0.0, 1.0], [19.5, 0.0, -19.5, 0.0]]
    )
    a1, drive = np.array([[0.0], [0.0], [0.0], [-3.33]]), np.array(b).reshape(4, 1)
    c0, h = np.array([[1.0, 0.0, 0.0, 0.0]]), np.array([[0.0, 0.0, 1.0, 0.0]])
    l0, l1 = np.array([[1.0, 0.0, -24.3 / 21.6, 0.0]]), np.array([[-1.0]])
    g = np.array([[21.6], [21.6], [0.0], [0.0]])
    slopes = (float(np.cos(reach)), 1.0)
    plant = Persidskii(a0, a1, h, "sin", drive, drive, c0, slopes=slopes, domain=reach)
    return plant, Generator(a0 + drive @ l0 - g @ c0, a1 + drive @ l1, h, g, l0, l1, drive)


def chua_circuits(reach: float = 1.0) -> tuple[Persidskii, Generator]:
    """Example 4: two synchronised circuits; the slopes of the cube hold within ``reach``."""
    b: FloatArray = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    a0 = [[-200.0 / 7.0, 10.0, 0.0], [1.0, -1.0, 1.0], [0.0, -16.0, 0.0]]
    s0 = [[10.0 / 7.0, 10.0, 0.0], [1.0, -1.0, 1.0], [0.0, -100.0 / 7.0, 0.0]]
    l0 = [[220.0 / 7.0, 0.0, 0.0], [-10.0 / 7.0, 0.0, 0.0], [0.0, 12.0 / 7.0, 0.0]]
    l1 = [[-20.0 / 7.0], [10.0], [0.0]]
    plant = Persidskii(
        a0, [-10.0, 0.0, 0.0], [1.0, 0.0, 0.0], "cube", b, None, [0.0, 0.0, 1.0], [[1.0]],
        (0.0, 3.0 * reach**2), domain=reach,
    )  # fmt: skip
    return plant, Generator(s0, [-20.0 / 7.0, 0.0, 0.0], [1.0, 0.0, 0.0], None, l0, l1)


class Bioreactor:
    """Example 2: a two-stage digestion, whose nonlinearities have two arguments each.

    ``plant`` and ``generator`` are in the form of Corollary 3.2.1 with the inflow as third state; ``field``
    is the digestion with an observer of the second stage, states (x1, x2, w1, w2, z1, z2).
    """

    D, KS1, KS2, KI2, MU1, MU2 = 0.35, 7.1, 9.28, 256.0, 1.2, 0.74
    K1, K2, K3 = 42.14, 116.5, 268.0
    PRINTED_GAIN = (1.914e-3, 9.572e-5)

    def __init__(self) -> None:
        a0 = [[-self.D, 0.0, 0.0], [0.0, -self.D, self.D], [0.0, 0.0, 0.0]]
        self.plant = Persidskii(
            a0, [1.0, -self.K1, 0.0], np.eye(3), self.first, None, None, None, [[self.K3]]
        )  # fmt: skip
        self.generator = Generator(a0, [1.0, -self.K2, 0.0], None, [0.0, 1.0, 0.0], f=self.second)

    def first(self, x: FloatArray) -> FloatArray:
        """Growth of the first population, f1."""
        return np.array([self.MU1 * x[0] * x[1] / (self.KS1 + x[1])])

    def second(self, w: FloatArray) -> FloatArray:
        """Growth of the second population, f2."""
        return np.array([self.MU2 * w[0] * w[1] / (self.KS2 + w[1] + w[1] ** 2 / self.KI2)])

    @property
    def printed_map(self) -> FloatArray:
        """Pi of the thesis."""
        k1, k2, k3 = self.K1, self.K2, self.K3
        return np.array([[k2, 1.0, -1.0], [-k1 * k2, -k1, k3 + k1], [0.0, 0.0, k3]]) / k3

    def field(
        self, inflow: float, states: FloatArray, gain: tuple[float, float], *, projected: bool
    ) -> FloatArray:
        """The derivative with the observer's gain; ``projected`` clips the arguments of f at zero."""
        x, w, z = states[:2], states[2:4], states[4:]
        z = np.maximum(z, 0.0) if projected else z
        guess = self.printed_map[:2] @ np.append(z, inflow)
        guess = np.maximum(guess, 0.0) if projected else guess
        f1, f2, g2 = self.first(x)[0], self.second(w)[0], self.second(z)[0]
        wrong = self.K3 * (f1 - self.first(guess)[0])
        d = self.D
        return np.array(
            [
                -d * x[0] + f1,
                d * (inflow - x[1]) - self.K1 * f1,
                -d * w[0] + f2,
                d * (inflow - w[1]) + self.K3 * f1 - self.K2 * f2,
                -d * z[0] + g2 + gain[0] * wrong,
                d * (inflow - z[1]) + self.K3 * f1 - self.K2 * g2 + gain[1] * wrong,
            ]
        )


UNMEASURED = np.eye(4)[2:]
"""Pi of example 5: position and velocity of the second mass."""
TRUTH = (3.0, 5.0)
"""The constants that example 6 estimates, at t = 0."""
VAPOURS = np.array([-0.08, 0.19, -4.0, 9.8])
"""The least-squares estimate on the data of example 7, rounded."""


def two_masses(domain: float = 2.0) -> Persidskii:
    """Example 5, (3.59): two masses and a hardening spring; ``domain`` bounds abs(x1 - x3), in its unit.

    A0[4, 4] is -a1 - a2 where the print has a1 - a2, and Q has a second column for u1, which the print drops.

    >>> two_masses().A0[3].round(9).tolist()
    [3.0, 0.6, -3.6, -2.6]
    """
    k1, k2, k3, a1, a2 = 3.0, 3.0, 0.6, 0.6, 2.0
    return Persidskii(
        [[0.0, 1.0, 0.0, 0.0], [-k1, -a1, k1, a1], [0.0, 0.0, 0.0, 1.0], [k1, a1, -k1 - k3, -a1 - a2]],
        [0.0, -k2, 0.0, k2],
        [1.0, 0.0, -1.0, 0.0],
        "cube",
        Q=[[0.0, 0.0], [0.0, 0.2], [0.0, 0.0], [1.0, 0.0]],
        C0=np.eye(2, 4),
        slopes=(0.0, 3.0 * domain**2),
        domain=domain,
    )


def pushes(t: float) -> FloatArray:
    """The inputs of example 5: u = sin t on the second mass, u1 = sin 10 t on the first."""
    return np.array([np.sin(t), np.sin(10.0 * t)])


def two_sensors(t: Any) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Example 6 at times t: J, D1, and the constants that d = 0.1 (sin t, sin 2t) moves.

    >>> j, weight, x = two_sensors(0.0)
    >>> j.tolist(), float(weight), x.tolist()
    ([1.0, 0.0], 0.0, [3.0, 5.0])
    """
    t = np.asarray(t, np.float64)
    x = np.stack([TRUTH[0] + 0.1 * (1.0 - np.cos(t)), TRUTH[1] + 0.05 * (1.0 - np.cos(2.0 * t))], axis=-1)
    return np.stack([np.ones_like(t), np.sin(t)], axis=-1), np.sin(5.0 * t) ** 2, x


def fused(t: Any) -> FloatArray:
    """The output of example 6, (3.50): (1 - D1) J x + D1 arctan(J x)."""
    j, weight, x = two_sensors(t)
    s = (j * x).sum(axis=-1)
    return np.asarray((1.0 - weight) * s + weight * np.arctan(s))


def vapours(seed: int = 7, count: int = 125) -> tuple[FloatArray, FloatArray]:
    """A stand-in for the data of example 7: four nearly collinear predictors and the output.

    The true parameters are those of least squares on the real data, rounded; the noise has the size found
    there.

    >>> rows, outputs = vapours()
    >>> rows.shape, round(float(np.linalg.cond(rows)), -2)
    ((125, 4), 500.0)
    """
    random = np.random.default_rng(seed)
    warm = random.uniform(30.0, 90.0, count)
    gas = warm + random.normal(0.0, 8.0, count) - 5.0
    tank = 2.2 + 0.045 * warm + random.normal(0.0, 0.35, count)
    pressure = tank + random.normal(0.0, 0.25, count)
    rows = np.column_stack([warm, gas, tank, pressure])
    return rows, rows @ VAPOURS + random.normal(0.0, 2.8, count)


SPRINGS = {"k1": 3, "k2": 3, "k3": 0.6, "a1": 0.6, "a2": 2}
"""The parameters of example 9: springs and dampers."""


def interlaced_states() -> tuple[SymbolicSystem, SymbolicGenerator]:
    """Example 8, (4.17): (x1, x2) feeds forward what (x3, x4) feeds back, under an oscillator."""
    x1, x2, x3, x4, u = symbolic().symbols("x1:5 u")
    field = (-x1 + x2**2 * x3, -x2 + x3, -(x3**3) + x4, -x4 + (1 + x3**2) * u)
    return SymbolicSystem((x1, x2, x3, x4), field, u, outputs=(x3,)), oscillator()


def interlaced_masses() -> tuple[SymbolicSystem, SymbolicGenerator]:
    """Example 9: two masses on springs, in y1 = x1, y2 = x2, y3 = x1 - x3, y4 = x2 - x4."""
    y1, y2, y3, y4, u, k1, k2, k3, a1, a2 = symbolic().symbols("y1:5 u k1:4 a1:3")
    force = k1 * y3 + k2 * y3**3 + a1 * y4
    field = (y2, -force, y4, -2 * force + k3 * (y1 - y3) + a2 * (y2 - y4) - u)
    return SymbolicSystem((y1, y2, y3, y4), field, u, outputs=(y3,)), oscillator()


def oscillator() -> SymbolicGenerator:
    """w1' = w2, w2' = -w1, which drives examples 8 and 9."""
    w1, w2 = symbolic().symbols("w1 w2")
    return SymbolicGenerator((w1, w2), (w2, -w1))
