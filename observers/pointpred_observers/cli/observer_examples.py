"""The plants that ``pointpred observers example`` prints."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec


class Example(msgspec.Struct, frozen=True):
    """A plant, made when it is asked for, and what it is."""

    about: str
    plant: Callable[[], Any]


def motor() -> Any:
    """Angle, speed and current of a motor with friction under a voltage; the angle is measured."""
    from pointpred_observers import Persidskii

    a0 = [[0.0, 1.0, 0.0], [0.0, -1.0, 5.0], [0.0, -5.0, -100.0]]
    friction, argument, volt = [0.0, -2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 100.0]
    return Persidskii(a0, friction, argument, "tanh", B=volt, C0=[1.0, 0.0, 0.0])


def pendulum() -> Any:
    """Angle and speed of a damped pendulum under a torque; the angle is measured."""
    from pointpred_observers import Persidskii

    return Persidskii(
        [[0.0, 1.0], [0.0, -0.3]], [0.0, -9.81], [1.0, 0.0], "sin", [0.0, 1.0], None, [1.0, 0.0]
    )


def tank() -> Any:
    """Levels of two tanks in a row, sampled once a minute; the second is measured."""
    from pointpred_observers import Persidskii

    a0 = [[0.95, 0.0], [0.05, 0.93]]
    return Persidskii(a0, B=[0.1, 0.0], C0=[0.0, 1.0], time="discrete")


def wing() -> Any:
    """Speed and force of a wing in a wind that nobody measures; its stiffness k varies and is known."""
    from pointpred_observers import Box, CornerSystem

    corners = [[[-0.5, 1.0], [-stiffness, -2.0]] for stiffness in (1.0, 3.0)]
    return CornerSystem(Box({"k": (1.0, 3.0)}), corners, [[1.0], [0.0]], [[1.0, 0.0]])


def spring() -> Any:
    """Two states with a product between them, written as equations; the second is measured."""
    from pointpred_observers import SymbolicSystem
    from pointpred_observers.plants.polynomials import symbolic

    x1, x2, u = symbolic().symbols("x1 x2 u")
    return SymbolicSystem((x1, x2), (-x1 + x2**2, -x2 + u), u, outputs=(x2,))


def oscillator() -> Any:
    """The generator of a sine and a cosine, which drives the spring."""
    from pointpred_observers import SymbolicGenerator
    from pointpred_observers.plants.polynomials import symbolic

    w1, w2 = symbolic().symbols("w1 w2")
    return SymbolicGenerator((w1, w2), (w2, -w1))


def oven() -> Any:
    """Temperatures of an oven and of what stands in it, above the room's, 1/min; the first is measured."""
    from pointpred_observers import Persidskii

    return Persidskii([[-0.2, 0.1], [0.1, -0.15]], B=[0.1, 0.0], C0=[1.0, 0.0])


def heating() -> Any:
    """The generator of a constant, which heats the oven by a power that nobody measures."""
    from pointpred_observers import Generator

    return Generator([[0.0]], L0=[1.0])


PLANTS = (motor, pendulum, tank, wing, spring, oscillator, oven, heating)
EXAMPLES = {one.__name__: Example((one.__doc__ or "").rstrip("."), one) for one in PLANTS}
