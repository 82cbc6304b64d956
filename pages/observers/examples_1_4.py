"""The figures of examples 1 to 4 of the thesis."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from pages.thinning import thin
from pointpred.columns import FloatArray
from pointpred.observers import SeededSignal, closed_loop, design_observer, simulate, steady_state_map
from pointpred.observers.examples import Bioreactor, academic, chua_circuits, robotic_arm

TRUE, SEEN, OTHER = "tab:blue", "tab:orange", "tab:green"


def panels(
    file: Path,
    t: FloatArray,
    plots: list[tuple[str, list[tuple[FloatArray, str, str]]]],
    across: str = "t, s",
) -> None:
    """One panel a quantity, one line a signal: (values, label, colour)."""
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot as plt

    mpl.rcParams["svg.hashsalt"] = "pointpred"
    figure, axes = plt.subplots(
        len(plots), 1, figsize=(8.0, 2.2 * len(plots)), sharex=True, layout="constrained"
    )
    for axis, (title, lines) in zip(np.atleast_1d(axes), plots, strict=True):
        for values, label, colour in lines:
            axis.plot(t, values, label=label, color=colour, linewidth=1.2)
        axis.set_ylabel(title)
        axis.grid(alpha=0.3)
        axis.legend(loc="upper right", fontsize=8)
    np.atleast_1d(axes)[-1].set_xlabel(across)
    figure.savefig(file, metadata={"Date": None})
    thin(file)
    plt.close(figure)


def example_1(file: Path) -> None:
    """Outputs, the observer's state and the distance to the steady state, with the thesis's disturbances."""
    plant, generator = academic()
    maps = steady_state_map(plant, generator)
    design = design_observer(plant, generator, maps.Pi, gain=[[-2.973], [1.565]])
    g, m, noise = design.generator, design.gain, SeededSignal(1, 1, 0.05, period_s=0.05)

    def field(t: float, both: Any) -> Any:
        w, x, z = both[:2], both[2:5], both[5:]
        dx = plant.field(t, x, g.L0 @ w + g.L1 @ plant.f(maps.J @ w), d=0.2 * np.sin(10.0 * t))
        y = plant.output(t, x, noise(t))
        return np.concatenate(
            [g.S0 @ w + 0.1 * np.cos(10.0 * t), dx, g.S0 @ z + m @ (y - plant.C0 @ maps.Pi @ z)]
        )

    t = np.arange(0.0, 25.0, 0.05)
    both = simulate(field, [0.125, 0.0, 0.5, -0.5, 0.5, 0.25, 0.0], t, step_s=0.01)
    w, x, z = both[:, :2], both[:, 2:5], both[:, 5:]
    y = x[:, 0] + np.array([noise(one)[0] for one in t])
    psi = plant.C0 @ maps.Pi
    axes = [
        ("output", [(y, "Y measured", "0.7"), ((psi @ w.T)[0], "psi", TRUE), ((psi @ z.T)[0], "psi^", SEEN)]),
        ("w1", [(w[:, 0], "w1", TRUE), (z[:, 0], "w1^", SEEN)]),
        ("w2", [(w[:, 1], "w2", TRUE), (z[:, 1], "w2^", SEEN)]),
        ("x - Pi w", [(np.linalg.norm(x - w @ maps.Pi.T, axis=1), "norm", OTHER)]),
    ]
    panels(file, t, axes)


def example_2(file: Path) -> None:
    """The second stage, and the observer without a gain, with the printed one, and with projection."""
    reactor, t = Bioreactor(), np.arange(0.0, 60.0, 0.1)

    def run(gain: tuple[float, float], *, projected: bool) -> FloatArray:
        def field(now: float, states: Any) -> Any:
            inflow = 12.7 if now % 40.0 < 20.0 else 7.5
            return reactor.field(inflow, states, gain, projected=projected)

        return simulate(field, [1.0, 5.0, 0.1, 0.0, 1.0, 20.0], t, step_s=0.02)

    none = run((0.0, 0.0), projected=True)
    printed, free = run(reactor.PRINTED_GAIN, projected=True), run(reactor.PRINTED_GAIN, projected=False)
    axes = []
    for i, name in ((0, "w1, biomass"), (1, "w2, acids")):
        lines = [(none[:, 2 + i], "true", "black"), (none[:, 4 + i], "no gain", OTHER)]
        lines += [(printed[:, 4 + i], "printed gain, projected", SEEN)]
        axes.append((name, [*lines, (free[:, 4 + i], "printed gain, not projected", "tab:red")]))
    inflow = np.where(t % 40.0 < 20.0, 12.7, 7.5)
    x = np.column_stack([none[:, 2:4], inflow]) @ reactor.printed_map[:2].T
    axes.append(("x2, substrate", [(none[:, 1], "x2", TRUE), (x[:, 1], "(Pi w)2", SEEN)]))
    panels(file, t, axes)


def example_3(file: Path) -> None:
    """The observer's error, and how far the plant stays from the reference, from two starts."""
    plant, regulator = robotic_arm()

    def run(start: float, t: FloatArray) -> FloatArray:
        def field(now: float, both: Any) -> Any:
            rho, reference = [1.0 if now % 1.0 < 0.5 else -1.0], both[8:]
            d = np.array([0.0, 0.5 * np.sin(5.0 * now), 0.0, 0.0])
            u = regulator.L0 @ reference + regulator.L1 @ plant.f(plant.H @ reference) + rho
            ahead = plant.field(now, reference, u)
            return np.concatenate([closed_loop(plant, regulator, now, both[:8], rho=rho, d=d), ahead])

        begin = [0.0, 0.0, 1.0, 0.0, start, start, start, start, 0.0, 0.0, 1.0, 0.0]
        return simulate(field, begin, t, step_s=0.01)

    t = np.arange(0.0, 40.0, 0.1)
    axes = []
    for start in (15.0, 1.0):
        both = run(start, t)
        z = np.linalg.norm(both[:, :4] - both[:, 4:8], axis=1)
        off = np.linalg.norm(both[:, :4] - both[:, 8:], axis=1)
        axes.append(
            (f"w(0) = {start:g}", [(z, "norm of x - w", TRUE), (off, "norm of x - reference", "tab:red")])
        )
        link = [(both[:, 2], "x3", TRUE), (both[:, 6], "w3", SEEN), (both[:, 10], "reference", "black")]
        axes.append(("link, rad", link))
    panels(file, t, axes)


def example_4(file: Path) -> None:
    """The two circuits and the observer with the printed gain, then its error."""
    plant, generator = chua_circuits()
    g, m = generator.beside(plant), np.array([[-0.34], [1.32], [5.35]])

    def field(t: float, both: Any) -> Any:
        w, x, z = both[:3], both[3:6], both[6:]
        f, fz = w[:1] ** 3, z[:1] ** 3
        wrong = plant.C0 @ x + x[:1] ** 3 - plant.C0 @ z - fz
        dx = plant.A0 @ x + plant.A1 @ x[:1] ** 3 + plant.B @ (g.L0 @ w + g.L1 @ f)
        return np.concatenate([g.S0 @ w + g.S1 @ f, dx, g.S0 @ z + g.S1 @ fz + m @ wrong])

    t = np.arange(0.0, 20.0, 0.02)
    both = simulate(field, [0.2, 0.0, 0.2, 0.65, 0.0, 0.5, 0.0, 0.0, 0.0], t, step_s=0.005)
    axes = [
        (
            f"state {i + 1}",
            [(both[:, i], "w", TRUE), (both[:, 3 + i], "x", OTHER), (both[:, 6 + i], "w^", SEEN)],
        )
        for i in range(3)
    ]
    error = np.linalg.norm(both[:, :3] - both[:, 6:], axis=1)
    panels(file, t, [*axes, ("error", [(error, "norm of w - w^", "tab:red")])])


FIGURES: dict[str, Callable[[Path], None]] = {
    "example-1": example_1,
    "example-2": example_2,
    "example-3": example_3,
    "example-4": example_4,
}
