"""Figures 4.2 and 4.4 of the thesis: examples 8 and 9, interlaced systems."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.drawing import Panel, beside, drawing
from pointpred.records import FloatArray
from pointpred.reproduction.figure import Reproduction, Value
from pointpred_observers import (
    InterlacedObserver,
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    interlaced,
    trajectory,
)
from pointpred_observers.simulations.symbolic import driven_field, outputs_of
from pointpred_observers.trajectories import SeededSignal

END_S, PERIOD_S = 30.0, 0.01
STEP_S = 2.5e-3
"""A fortieth of the shortest period in the signals, that of sin 100 t being 63 ms."""
RATE = 0.25
"""The decay in 1/s that the observers are designed for."""


def oscillator() -> SymbolicGenerator:
    """w1' = w2, w2' = -w1, which drives both examples."""
    import sympy as sp

    w1, w2 = sp.symbols("w1 w2")
    return SymbolicGenerator((w1, w2), (w2, -w1))


def example_8() -> SymbolicSteadyState:
    """The steady state of the academic example, (4.17)."""
    import sympy as sp

    x1, x2, x3, x4 = x = sp.symbols("x1:5")
    u, generator = sp.Symbol("u"), oscillator()
    field = (-x1 + x2**2 * x3, -x2 + x3, -(x3**3) + x4, -x4 + (1 + x3**2) * u)
    return interlaced(SymbolicSystem(x, field, u, outputs=(x3,)), generator, 2, generator.states[0], degree=3)


def example_9() -> SymbolicSteadyState:
    """Two masses on springs, in y1 = x1, y2 = x2, y3 = x1 - x3, y4 = x2 - x4."""
    import sympy as sp

    y1, y2, y3, y4 = y = sp.symbols("y1:5")
    u, generator = sp.Symbol("u"), oscillator()
    force = 3 * y3 + 3 * y3**3 + 0.6 * y4
    field = (y2, -force, y4, -2 * force + 0.6 * (y1 - y3) + 2 * (y2 - y4) - u)
    system = SymbolicSystem(y, field, u, outputs=(y3,))
    return interlaced(system, generator, 2, sum(generator.states), degree=3)


def driven(steady: SymbolicSteadyState, disturbance: float) -> Callable[[float, Any], FloatArray]:
    """Generator and plant together, every row of the plant with ``disturbance`` sin 100 t."""
    rows = len(steady.system.states)
    return driven_field(steady, steady.system, lambda t: np.full(rows, disturbance * np.sin(100.0 * t)))


def observed(
    steady: SymbolicSteadyState, rows: FloatArray, t: FloatArray, noise: float, **design: Any
) -> FloatArray:
    """The observer's answers to noisy outputs of the plant: w, x and u a row."""
    observer = InterlacedObserver.design(steady, rate=RATE, **design)
    v = SeededSignal(8, 1, noise, period_s=PERIOD_S)
    measured = outputs_of(steady.system, rows[:, 2:]) + np.array([v(one) for one in t])
    table = np.column_stack([t, measured])
    return observer.walk(np.zeros(len(table), dtype=np.bool_), table)


def _panels(t: FloatArray, states: FloatArray, maps: FloatArray, estimate: FloatArray) -> list[Panel]:
    """States, their steady state and its estimate; then the largest errors of both."""
    panels = [
        Panel(
            f"x{i + 1}",
            beside(
                t,
                (maps[:, i], "steady state", "truth"),
                (states[:, i], "state", "first"),
                (estimate[:, i], "estimate", "second"),
            ),
        )
        for i in range(4)
    ]
    for name, error in (("state - steady state", states - maps), ("estimate - state", estimate - states)):
        largest = np.abs(error).max(axis=1)
        panels.append(Panel("largest error", beside(t, (largest, name, "third")), logarithmic=True))
    return panels


def coefficients(expression: Any, monomials: tuple[tuple[int, int], ...]) -> list[float]:
    """The coefficients of w1^i w2^j in a polynomial, for each (i, j)."""
    import sympy as sp

    polynomial = sp.Poly(sp.expand(expression), *sp.symbols("w1 w2"))
    return [float(polynomial.coeff_monomial(sp.prod(s**k for s, k in zip(sp.symbols("w1 w2"), powers,
                                                                          strict=True))))
            for powers in monomials]  # fmt: skip


CUBIC = ((3, 0), (2, 1), (1, 2), (0, 3))
MONOMIALS = {
    (1, 0): "w1",
    (0, 1): "w2",
    (2, 0): "w1^2",
    (3, 0): "w1^3",
    (2, 1): "w1^2 w2",
    (1, 2): "w1 w2^2",
    (0, 3): "w2^3",
}


def _listed(name: str, expression: Any, printed: dict[tuple[int, int], str]) -> list[Value]:
    """A value for each printed coefficient of a polynomial."""
    ours = coefficients(expression, tuple(printed))
    return [
        Value(f"{name}, coefficient of {MONOMIALS[powers]}", value, text)
        for value, (powers, text) in zip(ours, printed.items(), strict=True)
    ]


def figure_4_2(_: Path | None) -> Reproduction:
    """Example 8: states, steady state and estimates with the disturbance and noise."""
    import sympy as sp

    t = np.arange(0.0, END_S, PERIOD_S)
    steady = example_8()
    rows = trajectory(driven(steady, 20.0), [1.0, 2.0, 0.5, 0.5, 0.5, 0.5], t, step_s=STEP_S)
    estimate = observed(steady, rows, t, 0.2)[:, 2:6]
    maps = steady.function()(rows[:, :2].T)[:4].T
    numerator = sp.numer(sp.together(steady.input))
    late = t >= 20.0
    values = (
        *_listed("pi_1", steady.maps[0],
                 {(3, 0): "1/40", (0, 3): "-7/40", (2, 1): "-9/40", (1, 2): "7/40"}),
        *_listed("pi_2", steady.maps[1], {(1, 0): "1/2", (0, 1): "-1/2"}),
        *_listed("pi_3", steady.maps[2], {(1, 0): "1", (0, 1): "0"}),
        *_listed("pi_4", steady.maps[3], {(0, 1): "1", (2, 0): "1", (3, 0): "0"}),
        *_listed("numerator of u", numerator, {(1, 0): "-1", (0, 1): "0", (3, 0): "0", (2, 1): "3"}),
        Value("largest state - steady state after 20 s", float(np.abs(rows[late, 2:] - maps[late]).max())),
        Value("largest estimate - state after 20 s", float(np.abs(estimate[late] - rows[late, 2:]).max())),
    )  # fmt: skip
    title = "Figure 4.2, example 8, d = 20 sin 100 t, noise within 0.2"
    panels = _panels(t, rows[:, 2:], maps, estimate)
    return Reproduction(values, drawing(title, panels, columns=2), "simulated")


def figure_4_4(_: Path | None) -> Reproduction:
    """Example 9: the masses from rest, their steady state and its estimate with the printed gain."""
    t = np.arange(0.0, END_S, PERIOD_S)
    steady = example_9()
    rows = trajectory(driven(steady, 0.0), [0.1, 0.0, 0.0, 0.0, 0.0, 0.0], t, step_s=STEP_S)
    estimate = observed(steady, rows, t, 0.05, gain=[[0.33], [0.6]])[:, 2:6]
    maps = steady.function()(rows[:, :2].T)[:4].T
    back = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [1, 0, -1, 0], [0, 1, 0, -1]]).T
    states, maps, estimate = rows[:, 2:] @ back, maps @ back, estimate @ back
    late = t >= 20.0
    values = (
        *_tau("tau1", steady.maps[0], -3.0, ("-11/9", "4/3", "-4/3", "-11/9")),
        *_tau("tau2", steady.maps[1], 3.0, ("4/3", "1", "1", "4/3")),
        *_listed("u", steady.input, {(1, 0): "-8.16", (0, 1): "-1.84"}),
        Value("largest state - steady state after 20 s", float(np.abs(states[late] - maps[late]).max())),
        Value("largest estimate - state after 20 s", float(np.abs(estimate[late] - states[late]).max())),
    )
    title = "Figure 4.4, example 9, noise within 0.05"
    return Reproduction(
        values, drawing(title, _panels(t, states, maps, estimate), columns=2), "simulated, from rest"
    )


def _tau(name: str, y: Any, k2: float, printed: tuple[str, str, str, str]) -> list[Value]:
    """The cubic part of y over k2 with its sign, beside the printed coefficients in the order of CUBIC."""
    return _listed(name, y / k2, dict(zip(CUBIC, printed, strict=True)))
