"""Figures 4.2 and 4.4 of the thesis: examples 8 and 9, interlaced systems."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pointpred.drawing import Panel, drawing
from pointpred.records import FloatArray
from pointpred.reproduction.figure import Reproduction, Value
from pointpred_observers import interlaced, trajectory
from pointpred_observers.examples import SPRINGS, interlaced_masses, interlaced_states
from pointpred_observers.plants.symbolic import SymbolicSteadyState
from pointpred_observers.reproduction.figures import figure, panel, panels
from pointpred_observers.simulations.trajectories import SeededSignal
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver, driven_field, outputs_of

END_S, PERIOD_S = 30.0, 0.01
STEP_S = 2.5e-3
"""A fortieth of the shortest period in the signals, that of sin 100 t being 63 ms."""
DECAY = 0.25
"""The decay in 1/s that the observers are designed for."""
CUBIC = ("w1**3", "w1**2*w2", "w1*w2**2", "w2**3")


def observed(
    steady: SymbolicSteadyState, start: list[float], noise: float, push: float = 0.0, gain: Any = None
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Times; states of the plant, of its steady state and of the estimate from noisy outputs.

    ``push``: every row of the plant has ``push`` sin 100 t.
    """
    t, n = np.arange(0.0, END_S, PERIOD_S), len(steady.maps)
    field = driven_field(steady, steady.system, lambda now: np.full(n, push * np.sin(100.0 * now)))
    rows = trajectory(field, start, t, step_s=STEP_S)
    v = SeededSignal(8, 1, noise, period_s=PERIOD_S)
    measured = outputs_of(steady.system, rows[:, 2:]) + np.array([v(one) for one in t])
    stage = InterlacedObserver.design(steady, decay=DECAY, gain=gain).stage()
    estimate = stage.walk(np.zeros(len(t), np.bool_), np.column_stack([t, measured]))
    return t, rows[:, 2:], steady.function()(rows[:, :2].T)[:n].T, estimate[:, 2 : 2 + n]


def _compared(
    t: FloatArray, states: FloatArray, maps: FloatArray, estimate: FloatArray
) -> tuple[list[Panel], tuple[Value, ...]]:
    """Panels of the states, their steady state and its estimate; then the largest errors of both."""
    names = [f"x{i + 1}" for i in range(4)]
    lines = (maps, "steady state", "truth"), (states, "state", "first"), (estimate, "estimate", "second")
    drawn = panels(names, t, *lines)
    errors = {"state - steady state": states - maps, "estimate - state": estimate - states}
    for name, error in errors.items():
        drawn.append(panel("largest error", t, (np.abs(error).max(axis=1), name, "third"), logarithmic=True))
    late = t >= 20.0
    ends = {name: float(np.abs(error[late]).max()) for name, error in errors.items()}
    return drawn, tuple(Value(f"largest {name} after 20 s", end) for name, end in ends.items())


def _listed(name: str, expression: Any, printed: dict[str, str]) -> list[Value]:
    """A value for each printed coefficient of a polynomial."""
    import sympy as sp

    polynomial = sp.Poly(sp.expand(expression), *sp.symbols("w1 w2"))
    return [
        Value(
            f"{name}, coefficient of {monomial.replace('**', '^').replace('*', ' ')}",
            float(polynomial.coeff_monomial(sp.sympify(monomial))),
            text,
        )
        for monomial, text in printed.items()
    ]


@figure("4.2")
def figure_4_2(_: Path | None) -> Reproduction:
    """Example 8: an interlaced system, its steady state and its observer.

    The final list prints pi_4 = w2 + w1^2; the text before it has w2 + w1^3, which is right. The numerator of
    u lacks w1^3 + w2 in the print. The strength of the noise is not printed: uniform within 0.2.
    """
    import sympy as sp

    system, generator = interlaced_states()
    steady = interlaced(system, generator, 2, generator.states[0], degree=3)
    drawn, ends = _compared(*observed(steady, [1.0, 2.0, 0.5, 0.5, 0.5, 0.5], 0.2, 20.0))
    numerator = sp.numer(sp.together(steady.input))
    values = (
        *_listed("pi_1", steady.maps[0],
                 {"w1**3": "1/40", "w2**3": "-7/40", "w1**2*w2": "-9/40", "w1*w2**2": "7/40"}),
        *_listed("pi_2", steady.maps[1], {"w1": "1/2", "w2": "-1/2"}),
        *_listed("pi_3", steady.maps[2], {"w1": "1", "w2": "0"}),
        *_listed("pi_4", steady.maps[3], {"w2": "1", "w1**2": "1", "w1**3": "0"}),
        *_listed("numerator of u", numerator, {"w1": "-1", "w2": "0", "w1**3": "0", "w1**2*w2": "3"}),
        *ends,
    )  # fmt: skip
    title = "Figure 4.2, example 8, d = 20 sin 100 t, noise within 0.2"
    return Reproduction(values, drawing(title, drawn, columns=2), "simulated")


@figure("4.4")
def figure_4_4(_: Path | None) -> Reproduction:
    """Example 9: two masses on springs, their steady state and its estimate.

    tau1 and tau2 are other polynomials: the printed ones do not satisfy the equations of the masses. The
    linear part of u is right. The noise is not printed: uniform within 0.05.
    """
    system, generator = interlaced_masses()
    system = system.with_values({one: SPRINGS[str(one)] for one in system.parameters()})
    steady = interlaced(system, generator, 2, sum(generator.states), degree=3)
    t, *relative = observed(steady, [0.1, 0.0, 0.0, 0.0, 0.0, 0.0], 0.05, gain=[[0.33], [0.6]])
    back = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [1, 0, -1, 0], [0, 1, 0, -1]]).T
    drawn, ends = _compared(t, *(one @ back for one in relative))
    values = (
        *_listed(
            "tau1", steady.maps[0] / -3.0, dict(zip(CUBIC, ("-11/9", "4/3", "-4/3", "-11/9"), strict=True))
        ),
        *_listed("tau2", steady.maps[1] / 3.0, dict(zip(CUBIC, ("4/3", "1", "1", "4/3"), strict=True))),
        *_listed("u", steady.input, {"w1": "-8.16", "w2": "-1.84"}),
        *ends,
    )
    title = "Figure 4.4, example 9, noise within 0.05"
    return Reproduction(values, drawing(title, drawn, columns=2), "simulated, from rest")
