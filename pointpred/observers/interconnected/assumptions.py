"""Assumptions 3.2.3 and 3.2.6 on their own, without the conditions of theorems 3.2.2 and 3.2.3."""

from __future__ import annotations

from typing import Any

from pointpred_observers.inequalities.matrix_inequalities import MatrixInequalities
from pointpred_observers.interconnected.generator import Generator
from pointpred_observers.interconnected.sector import SectorBounds
from pointpred_observers.interconnected.tracking import theorem_3_2_2, theorem_3_2_3
from pointpred_observers.linear_systems import Plant

CONDITIONS_3_2_3 = ("R1", "R2", "R3", "R4", "R1 + H'(R2 + R3) H")
"""The conditions of Theorem 3.2.3 beside its assumption."""


def assumption_3_2_3(plant: Plant, regulator: Generator, Pi: Any, **bounds: float) -> MatrixInequalities:
    """The inequalities of Assumption 3.2.3: ``solve`` finds matrices, ``check`` audits printed ones.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Omega, Lambda >= 0; S = S0 + G C0 Pi, S~ = S1 + G C1.

    Assumes r = k, as the thesis does, and strict inequalities in ``solve``: with J S~ = 0 the block of f(Jw)
    is zero and none can hold.

    >>> from pointpred_observers import Persidskii
    >>> plant = Persidskii([[-1.0]], [-1.0], [1.0], "tanh", [1.0], None, [1.0])
    >>> regulator = Generator([[-3.0]], [-2.0], None, [2.0], [0.0], [-1.0])
    >>> printed = {"P": 2.0, "Gamma": 99.0, "Xi": 1.0, "Omega": 4.0, "Lambda": 1.0}
    >>> sorted(assumption_3_2_3(plant, regulator, [[1.0]]).check(printed))
    ['Gamma > 0', 'Lambda >= 0', 'Omega >= 0', 'P > 0', 'Phi', 'Xi']
    """
    return _without(theorem_3_2_2(plant, regulator, Pi, **bounds), "Xi + J' Omega J")


def assumption_3_2_6(
    plant: Plant, regulator: Generator, Pi: Any, sector: SectorBounds | None = None, **bounds: float
) -> MatrixInequalities:
    """The inequalities of Assumption 3.2.6: ``solve`` finds matrices, ``check`` audits printed ones.

    Unknowns: P, Gamma > 0, Xi >= 0, diagonal Lambda, Omega1, Omega2, Upsilon >= 0, gamma1, gamma2 > 0; A~0 =
    A0 - Pi G C0, A~1 = A1 - Pi G C1.
    """
    return _without(theorem_3_2_3(plant, regulator, Pi, sector, **bounds), *CONDITIONS_3_2_3)


def _without(problem: MatrixInequalities, *names: str) -> MatrixInequalities:
    for name in names:
        problem.blocks.pop(name, None)
    return problem
