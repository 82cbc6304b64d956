"""A plant and a design of every kind, for tests of files, audits and simulations."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

import pointpred_observers as o
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver
from pointpred_observers.unknown_input.observer import UnknownInputObserver

sp = pytest.importorskip("sympy")
X1, X2, U, W1, W2 = sp.symbols("x1 x2 u w1 w2")
CART = o.Persidskii([[0.0, 1.0], [0.0, -1.0]], None, None, "sin", [0.0, 1.0], None, [1.0, 0.0])
PENDULUM = o.Persidskii(
    [[0.0, 1.0], [0.0, -0.3]], [0.0, -9.81], [1.0, 0.0], "sin", [0.0, 1.0], [0.0, 0.5], [1.0, 0.0]
)
DRIVEN = o.Persidskii(
    [[-1.0, 0.5], [0.0, -2.0]], [0.0, -1.0], [1.0, 0.0], "tanh", [0.0, 1.0], None, [1.0, 0.0]
)
CONSTANT = o.Generator([[0.0]], [[0.0]], L0=[[4.0]], L1=[[1.0]])
TANKS = o.Persidskii(
    [[0.95, 0.0], [0.05, 0.93]], None, None, "sin", [0.1, 0.0], None, [0.0, 1.0], time="discrete"
)
SYMBOLIC = o.SymbolicSystem((X1, X2), (-X1 + X2**2, -sp.sin(X2) + U), U, outputs=(X2,))
CIRCLE = o.SymbolicGenerator((W1, W2), (W2, -W1))
WING = o.CornerSystem(
    o.Box({"k": (1.0, 3.0)}),
    [[[-0.5, 1.0], [-1.0, -2.0]], [[-0.5, 1.0], [-3.0, -2.0]]],
    [[1.0], [0.0]],
    [[1.0, 0.0]],
)
SAMPLED_WING = o.CornerSystem(
    o.Box({"k": (0.2, 0.4)}),
    [[[0.9, 0.1], [-0.2, 0.7]], [[0.9, 0.1], [-0.4, 0.7]]],
    [[1.0], [0.0]],
    [[1.0, 0.0]],
    time="discrete",
)


@cache
def design(name: str) -> Any:
    return MAKERS[name]()


def _interlaced() -> Any:
    return InterlacedObserver.design(
        o.interlaced(SYMBOLIC, CIRCLE, 1, W1, degree=2), decay=0.5, start=[0.5, 0.0]
    )


def _servo() -> Any:
    """A regulator whose pendulum follows an oscillator."""
    upright = o.Persidskii(
        [[0.0, 1.0], [0.0, 0.0]], [0.0, 1.0], [1.0, 0.0], "sin", [0.0, 1.0], None, [1.0, 0.0]
    )
    circle = o.Generator([[0.0, 2.0], [-2.0, 0.0]])
    return o.design(upright, "regulator", decay=1.0, reference=circle, following=([[1.0, 0.0]], [[1.0, 0.0]]))


MAKERS = {
    "reduced order": lambda: o.design(PENDULUM, "reduced", decay=2.0),
    "reduced order, linear": lambda: o.design(CART, "reduced", decay=2.0),
    "reduced order, discrete": lambda: o.design(TANKS, "reduced", decay=0.5),
    "full order": lambda: o.design(PENDULUM, "full", decay=2.0),
    "full order, discrete": lambda: o.design(TANKS, "full", decay=0.2),
    "driven": lambda: o.design(DRIVEN, "driven", generator=CONSTANT, Pi=[[1.0], [2.0]], decay=1.0),
    "regulator": lambda: o.design(PENDULUM, "regulator", decay=1.0),
    "servo": _servo,
    "unknown input": lambda: UnknownInputObserver.design(WING, WING.box, decay=0.5),
    "unknown input, discrete": lambda: UnknownInputObserver.design(
        SAMPLED_WING, SAMPLED_WING.box, decay=0.15
    ),
    "interlaced": _interlaced,
}
