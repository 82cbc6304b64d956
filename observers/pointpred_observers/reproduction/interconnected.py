"""Figures 3.3 to 3.7 of the thesis: examples 1 to 4, systems that drive each other."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pointpred.drawing import Panel, drawing
from pointpred.records import FloatArray
from pointpred.reproduction.figure import Reproduction, Value, matrix_values
from pointpred_observers import steady_state_map, trajectory
from pointpred_observers.examples import Bioreactor, academic, chua_circuits, robotic_arm
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.reproduction.figures import figure, panel, panels
from pointpred_observers.simulations.trajectories import SeededSignal
from pointpred_observers.thesis import closed_loop, residuals

SIMULATED = "simulated, from the printed initial conditions"
INFLOWS = (12.7, 7.5)
"""The two levels of the square wave of example 2, in the order of the print."""
HALF_PERIOD_S = 20.0
"""How long each lasts; the thesis does not print it."""


@figure("3.3")
def figure_3_3(_: Path | None) -> Reproduction:
    """Example 1: outputs and states with their estimates.

    J has one row, 3/2 1/2, because H has one. The printed P, Q, Gamma, Xi and U satisfy no certificate; the
    printed gain M has another one. P^-1 U differs from the printed M by no more than the rounding of P and U.
    The noise is not printed: uniform within 0.05, seed 1.
    """
    plant, generator = academic()
    maps = steady_state_map(plant, generator)
    printed_p, printed_u = np.array([[1.129, 0.332], [0.332, 0.611]]), np.array([[-2.837], [-0.03]])
    design = DrivenObserver.design(
        plant, generator=generator, Pi=maps.Pi, gain=[[-2.973], [1.565]], decay=0.0
    )
    g, m, noise = design.generator, design.gain, SeededSignal(1, 1, 0.05, period_s=0.05)

    def field(t: float, both: Any) -> Any:
        w, x, z = both[:2], both[2:5], both[5:]
        dx = plant.field(t, x, g.L0 @ w + g.L1 @ plant.f(maps.J @ w), d=0.2 * np.sin(10.0 * t))
        y = plant.output(t, x, noise(t))
        ahead = g.S0 @ z + m @ (y - plant.C0 @ maps.Pi @ z)
        return np.concatenate([g.S0 @ w + 0.1 * np.cos(10.0 * t), dx, ahead])

    t = np.arange(0.0, 25.0, 0.05)
    both = trajectory(field, [0.125, 0.0, 0.5, -0.5, 0.5, 0.25, 0.0], t, step_s=0.01)
    w, x, z = both[:, :2], both[:, 2:5], both[:, 5:]
    y = x[:, 0] + np.array([noise(one)[0] for one in t])
    psi = (plant.C0 @ maps.Pi)[0]
    off = np.linalg.norm(x - w @ maps.Pi.T, axis=1)
    outputs = (y, "Y measured", "truth"), (w @ psi, "psi", "first"), (z @ psi, "psi^", "second")
    drawn = (
        panel("output", t, *outputs),
        *panels(("w1", "w2"), t, (w, "w#", "first"), (z, "w#^", "second")),
        panel("distance", t, (off, "norm of x - Pi w", "third")),
    )
    values = (
        *matrix_values("Pi", maps.Pi, [["-1/2", "0"], ["0", "-1/2"], ["3/2", "1/2"]]),
        *matrix_values("J", maps.J, [["3/2", "1/2"]]),
        *matrix_values("M = P^-1 U", np.linalg.solve(printed_p, printed_u), [["-2.973"], ["1.565"]]),
        Value("norm of w - w^ at 5 s", float(np.linalg.norm((w - z)[t.searchsorted(5.0)]))),
        Value("largest abs(w - w^) in the last 5 s", float(np.abs(w - z)[t >= 20.0].max())),
        Value("largest norm of x - Pi w in the last 5 s", float(off[t >= 20.0].max())),
    )
    return Reproduction(values, drawing("Figure 3.3, example 1", drawn), SIMULATED)


def inflow(t: Any) -> FloatArray:
    """The square wave of example 2, both S_in1 and S_in2."""
    high, low = INFLOWS
    return np.where(np.asarray(t) % (2.0 * HALF_PERIOD_S) < HALF_PERIOD_S, high, low)


def digestion(t: FloatArray, gain: tuple[float, float], *, projected: bool) -> FloatArray:
    """States x, w and estimates z of example 2 at the times t, with a gain of the observer."""
    reactor = Bioreactor()

    def field(now: float, states: Any) -> Any:
        return reactor.field(float(inflow(now)), states, gain, projected=projected)

    start = [1.0, 5.0, 0.1, 0.0, 1.0, 20.0]
    if projected:
        return trajectory(field, start, t, tolerance=1e-6)
    from scipy.integrate import solve_ivp

    # In steps of 20 ms whatever their error: an accurate integrator ends where Pi z meets the pole of f1.
    steps = solve_ivp(
        field, (t[0], t[-1]), start, "RK45", t, first_step=0.02, max_step=0.02, rtol=1e6, atol=1e6
    )
    return np.ascontiguousarray(steps.y.T)


@figure("3.4")
def figure_3_4(_: Path | None) -> Reproduction:
    """Example 2: x and Pi w of the bioreactor.

    Pi holds but is not unique: S_in1 = S_in2 is assumed. The period of the inflow is not printed: 40 s. Where
    the inflow jumps, (Pi w)2 jumps and x2 does not.
    """
    reactor, t = Bioreactor(), np.arange(0.0, 60.0, 0.1)
    states = digestion(t, (0.0, 0.0), projected=True)
    steady = np.column_stack([states[:, 2:4], inflow(t)]) @ reactor.printed_map[:2].T
    lines = (states, "x#", "first"), (steady, "(Pi w)#", "second")
    drawn = panels(("x1, biomass", "x2, substrate"), t, *lines)
    left = residuals(reactor.plant, reactor.generator, reactor.printed_map, relaxed=True)
    off = np.abs(states[:, :2] - steady)[np.searchsorted(t, HALF_PERIOD_S) - 1].tolist()
    place = f"at {HALF_PERIOD_S:g} s, before the inflow jumps"
    largest = max(float(np.abs(one).max()) for one in left.values())
    values = (
        Value("largest residual of the equalities with the printed Pi", largest, "0"),
        *(Value(f"abs(x{i} - (Pi w){i}) {place}", one) for i, one in enumerate(off, 1)),
    )
    return Reproduction(values, drawing("Figure 3.4, example 2: x and Pi w", drawn), SIMULATED)


@figure("3.5")
def figure_3_5(_: Path | None) -> Reproduction:
    """Example 2: the observer of w.

    With the printed gain and without projection the estimate becomes negative and stays there; with
    projection it converges more slowly than without any gain. (3.10) and (3.11) do not hold.
    """
    t, printed = np.arange(0.0, 60.0, 0.1), Bioreactor.PRINTED_GAIN
    none = digestion(t, (0.0, 0.0), projected=True)
    held, free = digestion(t, printed, projected=True), digestion(t, printed, projected=False)
    drawn = panels(
        ("w1, biomass", "w2, acids"),
        t,
        (none[:, 2:], "w#", "truth"),
        (none[:, 4:], "no gain", "third"),
        (held[:, 4:], "printed gain, projected", "first"),
        (free[:, 4:], "printed gain, not projected", "second"),
    )
    at = int(np.searchsorted(t, HALF_PERIOD_S)) - 1
    runs = {"no gain": none, "printed gain, projected": held}
    errors = {name: float(np.linalg.norm(run[at, 2:4] - run[at, 4:])) for name, run in runs.items()}
    values = tuple(Value(f"norm of w - w^ at {HALF_PERIOD_S:g} s, {name}", e) for name, e in errors.items())
    return Reproduction(values, drawing("Figure 3.5, example 2: the observer", drawn), SIMULATED)


def arm_beside_reference(start: float, t: FloatArray) -> FloatArray:
    """Example 3 from w(0) = start in all four states: x, w and the reference x, four columns each."""
    plant, regulator = robotic_arm()
    whole = regulator.beside(plant)

    def field(now: float, both: Any) -> Any:
        rho, reference = [1.0 if now % 1.0 < 0.5 else -1.0], both[8:]
        d = np.array([0.0, 0.5 * np.sin(5.0 * now), 0.0, 0.0])
        u = whole.L0 @ reference + whole.L1 @ plant.f(plant.H @ reference) + rho
        ahead = plant.field(now, reference, u)
        return np.concatenate([closed_loop(plant, regulator, now, both[:8], rho=rho, d=d), ahead])

    rest = [0.0, 0.0, 1.0, 0.0]
    return trajectory(field, [*rest, *[start] * 4, *rest], t, step_s=0.01)


@figure("3.6")
def figure_3_6(_: Path | None) -> Reproduction:
    """Example 3: the robotic arm, its observer and the reference.

    The observer converges as printed. From the printed start the arm comes back to the reference; from
    w(0) = (1, 1, 1, 1), drawn beside it, it does not: assumption 3.2.3 fails with the real B, which drives
    the motor only.
    """
    t = np.arange(0.0, 40.0, 0.1)
    late = t >= 35.0
    drawn: list[Panel] = []
    values: list[Value] = []
    for start in (15.0, 1.0):
        both, at = arm_beside_reference(start, t), f"w(0) = {start:g}"
        x, w, reference = both[:, :4], both[:, 4:8], both[:, 8:]
        error, off = np.linalg.norm(x - w, axis=1), np.linalg.norm(x - reference, axis=1)
        link = (reference[:, 2], "reference", "truth"), (x[:, 2], "x3", "first"), (w[:, 2], "w3", "second")
        drawn += [
            panel(at, t, (error, "norm of x - w", "first"), (off, "norm of x - reference", "second")),
            panel("link [rad]", t, *link),
        ]
        values += [
            Value(f"largest norm of x - w in the last 5 s, {at}", float(error[late].max())),
            Value(f"largest norm of x - reference in the last 5 s, {at}", float(off[late].max())),
        ]
    return Reproduction(tuple(values), drawing("Figure 3.6, example 3", drawn), SIMULATED)


@figure("3.7")
def figure_3_7(_: Path | None) -> Reproduction:
    """Example 4: two circuits and the observer with the printed gain.

    The first entry of L1 is -20/7, printed without its sign. The printed W is indefinite, so it bounds no
    sector, and no certificate covers the trajectory; the printed gain converges all the same.
    """
    plant, generator = chua_circuits()
    g, m = generator.beside(plant), np.array([[-0.34], [1.32], [5.35]])
    printed_w = np.array([[0.25, -2.5, 0.1], [-2.5, 0.0, 0.0], [0.1, 0.0, 0.0]])

    def field(t: float, both: Any) -> Any:
        w, x, z = both[:3], both[3:6], both[6:]
        f, fz = w[:1] ** 3, z[:1] ** 3
        wrong = plant.C0 @ x + x[:1] ** 3 - plant.C0 @ z - fz
        dx = plant.A0 @ x + plant.A1 @ x[:1] ** 3 + plant.B @ (g.L0 @ w + g.L1 @ f)
        return np.concatenate([g.S0 @ w + g.S1 @ f, dx, g.S0 @ z + g.S1 @ fz + m @ wrong])

    t = np.arange(0.0, 20.0, 0.02)
    both = trajectory(field, [0.2, 0.0, 0.2, 0.65, 0.0, 0.5, 0.0, 0.0, 0.0], t, step_s=0.005)
    w, x, z = both[:, :3], both[:, 3:6], both[:, 6:]
    error, apart = np.linalg.norm(w - z, axis=1), np.linalg.norm(x - w, axis=1)
    names = [f"state {i + 1}" for i in range(3)]
    drawn = panels(names, t, (w, "w", "truth"), (x, "x", "third"), (z, "w^", "second"))
    lines = (error, "norm of w - w^", "second"), (apart, "norm of x - w", "third")
    drawn.append(panel("distance", t, *lines, logarithmic=True))
    values = (
        *matrix_values("L0", g.L0, [["31.43", "0", "0"], ["-1.43", "0", "0"], ["0", "1.7143", "0"]]),
        *matrix_values("L1", g.L1, [["2.857"], ["10"], ["0"]]),
        *matrix_values("A0", plant.A0, [["-28.57", "10", "0"], ["1", "-1", "1"], ["0", "-16", "0"]]),
        Value("least eigenvalue of the printed W", float(np.linalg.eigvalsh(printed_w)[0])),
        Value("norm of w - w^ at 20 s", float(error[-1])),
        Value("norm of x - w at 20 s", float(apart[-1])),
    )
    return Reproduction(values, drawing("Figure 3.7, example 4", drawn), SIMULATED)
