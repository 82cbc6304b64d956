"""Draw the figures of docs/guide/observers, examples 8 and 9: ``python -m pages.observers.examples_8_9``."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp

from pages import DOCS
from pages.arguments import parse
from pointpred.observers import (
    InterlacedObserver,
    SeededSignal,
    SymbolicGenerator,
    SymbolicSteadyState,
    SymbolicSystem,
    interlaced,
    simulate,
)

FOLDER = DOCS / "guide" / "observers" / "figures"
W1, W2, U = sp.symbols("w1 w2 u")
OSCILLATOR = SymbolicGenerator((W1, W2), (W2, -W1))
END_S, PERIOD_S = 30.0, 0.01
TIMES = np.arange(0.0, END_S, PERIOD_S)
DISTURBANCE, NOISE = 20.0, 0.2


def example_8() -> SymbolicSteadyState:
    """The academic example, (4.17)."""
    x1, x2, x3, x4 = x = sp.symbols("x1:5")
    field = (-x1 + x2**2 * x3, -x2 + x3, -(x3**3) + x4, -x4 + (1 + x3**2) * U)
    return interlaced(SymbolicSystem(x, field, U, outputs=(x3,)), OSCILLATOR, 2, W1, degree=3)


def example_9() -> SymbolicSteadyState:
    """Two masses on springs, in y1 = x1, y2 = x2, y3 = x1 - x3, y4 = x2 - x4."""
    y1, y2, y3, y4 = y = sp.symbols("y1:5")
    force = 3 * y3 + 3 * y3**3 + 0.6 * y4
    field = (y2, -force, y4, -2 * force + 0.6 * (y1 - y3) + 2 * (y2 - y4) - U)
    return interlaced(SymbolicSystem(y, field, U, outputs=(y3,)), OSCILLATOR, 2, W1 + W2, degree=3)


def driven(steady: SymbolicSteadyState, disturbance: float) -> Callable[[float, Any], np.ndarray]:
    """Generator and plant together, every row of the plant with ``disturbance`` sin 100 t."""
    states = steady.system.states
    plant = sp.lambdify((*states, steady.system.input), steady.system.field, modules="math")
    drive = sp.lambdify((W1, W2), OSCILLATOR.field, modules="math")
    push = sp.lambdify((W1, W2), steady.input, modules="math")

    def field(t: float, v: Any) -> np.ndarray:
        w1, w2, *x = np.asarray(v).tolist()
        shake = disturbance * np.sin(100.0 * t)
        return np.array([*drive(w1, w2), *(rate + shake for rate in plant(*x, push(w1, w2)))])

    return field


def estimated(
    steady: SymbolicSteadyState, rows: np.ndarray, rate: float, noise: float, **design: Any
) -> np.ndarray:
    """The observer's answers to noisy outputs of the plant: w, x and u a row."""
    observer = InterlacedObserver.design(steady, rate=rate, **design)
    symbols = steady.system.states
    outputs = sp.lambdify(symbols, steady.system.outputs, modules="numpy")(*rows[:, 2:].T)
    v = SeededSignal(8, 1, noise, period_s=PERIOD_S)
    measured = np.array(outputs).T + np.array([v(t) for t in TIMES])
    table = np.column_stack([TIMES, measured])
    return observer.walk(np.zeros(len(table), dtype=np.bool_), table)


def draw(path: Path, title: str, rows: np.ndarray, maps: np.ndarray, estimate: np.ndarray) -> None:
    """States above, their steady state and its estimate; the largest errors of both below."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(3, 2, figsize=(10.0, 8.0), sharex=True, layout="constrained")
    for i, ax in enumerate(axes.flat[:4]):
        ax.plot(TIMES, rows[:, i], "C0", lw=0.8, label="state")
        ax.plot(TIMES, maps[i], "k--", lw=1.0, label="steady state")
        ax.plot(TIMES, estimate[:, i], "C1", lw=0.8, label="estimate")
        ax.set(ylabel=f"x{i + 1}", title=title if i == 0 else "")
    axes.flat[0].legend(loc="upper right", fontsize="small")
    for ax, error, name in (
        (axes.flat[4], np.abs(rows - maps.T).max(axis=1), "state from steady state"),
        (axes.flat[5], np.abs(estimate - rows).max(axis=1), "estimate from state"),
    ):
        ax.semilogy(TIMES, error, "C2", lw=0.8)
        ax.set(xlabel="t [s]", ylabel=f"largest error,\n{name}")
    FOLDER.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=80, metadata={"Software": None})
    plt.close(figure)


def main() -> None:
    """Both figures."""
    steady = example_8()
    rows = simulate(driven(steady, DISTURBANCE), [1.0, 2.0, 0.5, 0.5, 0.5, 0.5], TIMES)
    estimate = estimated(steady, rows, 0.25, NOISE)
    maps = steady.function()(rows[:, :2].T)[:4]
    title = "Example 8, d = 20 sin 100 t, noise within 0.2"
    draw(FOLDER / "example-8.png", title, rows[:, 2:], maps, estimate[:, 2:6])

    steady = example_9()
    # All masses start at rest, x = 0, which is y = 0.
    rows = simulate(driven(steady, 0.0), [0.1, 0.0, 0.0, 0.0, 0.0, 0.0], TIMES)
    estimate = estimated(steady, rows, 0.25, 0.05, gain=[[0.33], [0.6]])
    maps = steady.function()(rows[:, :2].T)[:4]
    back = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [1, 0, -1, 0], [0, 1, 0, -1]])
    title = "Example 9, noise within 0.05"
    draw(FOLDER / "example-9.png", title, rows[:, 2:] @ back.T, back @ maps, estimate[:, 2:6] @ back.T)


if __name__ == "__main__":
    parse(__doc__)
    main()
