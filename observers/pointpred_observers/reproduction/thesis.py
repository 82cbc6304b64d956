"""Figures of chapters 3 and 4 of the thesis: examples 1 to 9."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from pointpred.drawing import Look, Panel, drawing
from pointpred.errors import RecordingError
from pointpred.records import FloatArray
from pointpred.reproduction.figure import Reproduction, Value, matrix_values
from pointpred_observers import (
    NonlinearRegressor,
    RecursiveLeastSquares,
    examples,
    interlaced,
    invariant_observer,
    steady_state_map,
    trajectory,
)
from pointpred_observers.examples import UNMEASURED, Bioreactor
from pointpred_observers.interconnected.design import DrivenObserver
from pointpred_observers.plants.symbolic import SymbolicSteadyState
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver
from pointpred_observers.reproduction.figures import figure, panel, panels
from pointpred_observers.simulations.signals import SeededSignal
from pointpred_observers.thesis import closed_loop, residuals
from pointpred_observers.triangular.interlaced_observer import InterlacedObserver, driven_field, outputs_of

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
    plant, generator = examples.academic()
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
    plant, regulator = examples.robotic_arm()
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
    plant, generator = examples.chua_circuits()
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


SNIFFER = "sniffer.csv"
PREDICTORS = ("tank temperature", "gas temperature", "tank pressure", "gas pressure")
"""The four predictors of example 7, in the order of their columns."""


def observed_masses(observer: InvariantObserver, t: FloatArray) -> tuple[FloatArray, FloatArray]:
    """States of example 5 at the times t, and an observer's estimates of them."""
    plant = examples.two_masses()

    def field(now: float, both: FloatArray) -> FloatArray:
        u = examples.pushes(now)
        return np.concatenate([plant.field(now, both[:4], rho=u), observer.field(now, both[4:], both[:2], u)])

    start = [1.0, 0.0, 0.5, 0.0, *observer.invariant(0.0, [1.0, 0.0, 0.0, 0.0])]
    both = trajectory(field, start, t, step_s=0.01)
    estimate = [observer.estimate(now, row[4:], row[:2]) for now, row in zip(t, both, strict=True)]
    return both[:, :4], np.array(estimate)


@figure("3.8")
def figure_3_8(_: Path | None) -> Reproduction:
    """Example 5: the reduced-order observer of two masses.

    A0[4, 4] is -a1 - a2, as the printed S0 needs it, and Q has a second column for u1. The printed F and W
    are impossible; Upsilon = diag(-1, 1) has a certificate everywhere and is drawn beside the print.
    """
    t, plant = np.arange(0.0, 15.0, 0.05), examples.two_masses()
    printed = invariant_observer(plant, UNMEASURED, [[-1.0, 0.0], [0.0, 0.0]])
    looks: dict[str, tuple[InvariantObserver, Look]] = {
        "printed Upsilon": (printed, "second"),
        "diag(-1, 1), global": (invariant_observer(plant, UNMEASURED, [[-1.0, 0.0], [0.0, 1.0]]), "third"),
        "designed, y within f": (
            ReducedOrderObserver.design(plant, Pi=UNMEASURED, decay=0.5).observer,
            "first",
        ),
    }
    runs = {name: (*observed_masses(observer, t), look) for name, (observer, look) in looks.items()}
    x = next(iter(runs.values()))[0]
    estimated = [(estimate, name, look) for name, (_, estimate, look) in runs.items()]
    drawn = panels(("x1", "x2", "x3", "x4"), t, (x, "x#", "truth"), *estimated)[2:]
    errors = {name: np.linalg.norm(estimate - true, axis=1) for name, (true, estimate, _) in runs.items()}
    lines = [(errors[name] + 1e-12, name, look) for name, (_, _, look) in runs.items()]
    drawn.append(panel("norm of the error", t, *lines, logarithmic=True))
    now, at = printed.at(0.0), t.searchsorted(10.0)
    values = (
        *matrix_values("S0", now.S0, [["0", "1"], ["-3.6", "-2.6"]]),
        *matrix_values("S1", now.S1, [["0"], ["3"]]),
        *matrix_values("J", now.J, [["-1", "0"]]),
        # The print has one column, for u; ours has those of u and of u1.
        *matrix_values("O", now.O[:, :1], [["0"], ["1"]]),
        *matrix_values("B", now.B, [["0", "-1"], ["-0.6", "0.6"]]),
        *(Value(f"norm of the error at 10 s, {name}", float(one[at])) for name, one in errors.items()),
    )
    return Reproduction(values, drawing("Figure 3.8, example 5", drawn), "simulated, without noise")


@figure("3.9")
def figure_3_9(_: Path | None) -> Reproduction:
    """Example 6: nonlinear regression (the caption says example 2).

    The estimates converge, but the condition of theorem 3.3.3 does not hold on this example. The start of the
    estimate is not printed: 0.
    """
    t = np.arange(0.0, 40.0, 0.02)
    j, weight, x = examples.two_sensors(t)
    stage = NonlinearRegressor(2, f="atan", gain=0.75)
    estimate = stage.walk(np.zeros(len(t), np.bool_), np.column_stack([t, j, examples.fused(t), weight]))
    error = np.linalg.norm(estimate - x, axis=1)
    drawn = [
        *panels(("x1", "x2"), t, (x, "x#", "truth"), (estimate, "estimate", "second")),
        panel("error", t, (error, "norm", "first")),
    ]
    values = (
        Value("x1 at 0 s", float(x[0, 0]), "3"),
        Value("x2 at 0 s", float(x[0, 1]), "5"),
        Value("largest norm of the error in the last 10 s", float(error[t >= 30.0].max())),
    )
    return Reproduction(values, drawing("Figure 3.9, example 6", drawn), "simulated")


def sniffer(data: Path | None) -> tuple[FloatArray, FloatArray] | None:
    """The predictors and the output of example 7 from the file or its folder; ``None`` where none is named.

    Raises RecordingError for a file that is not there or is not the table of 125 rows and five columns.
    """
    if data is None:
        return None
    path = data / SNIFFER if data.is_dir() else data
    if not path.is_file():
        raise RecordingError(f"{path}: no such file; example 7 needs {SNIFFER}, the data of Weisberg 2005")
    try:
        table = np.genfromtxt(path, delimiter=",", skip_header=1, encoding="utf-8")
    except ValueError as unusable:
        raise RecordingError(f"{path}: is no table of numbers separated by commas: {unusable}") from unusable
    if table.ndim != 2 or table.shape[1] != 5 or not np.isfinite(table).all():
        raise RecordingError(
            f"{path}: needs five columns of numbers, the four predictors and the vapours, "
            f"received a table of shape {table.shape}"
        )
    return table[:, :4], table[:, 4]


def estimates(rows: FloatArray, outputs: FloatArray, ridge: float) -> FloatArray:
    """The estimate of recursive least squares after each sample, NaN where there is none yet."""
    stage, estimate = RecursiveLeastSquares(4, ridge=ridge), np.full((len(rows), 4), np.nan)
    for i, (row, output) in enumerate(zip(rows, outputs, strict=True)):
        stage.update(row, float(output))
        values = stage.fit().values
        if values is not None:
            estimate[i] = values
    return estimate


def _regression(data: Path | None) -> tuple[FloatArray, FloatArray, str]:
    """Predictors, output, and what they are."""
    measured = sniffer(data)
    rows, outputs = examples.vapours() if measured is None else measured
    return rows, outputs, "a stand-in for the data, simulated" if measured is None else "sniffer.csv"


@figure("3.10", reads=SNIFFER)
def figure_3_10(data: Path | None) -> Reproduction:
    """Example 7: parameters of the sniffer data by recursive least squares.

    Without sniffer.csv a simulated stand-in is used. (3.61) is singular for the first three samples: ours
    starts exactly from the fourth, and ends in ordinary least squares; a ridge of 1 does not. The parameters
    are not printed as numbers.
    """
    rows, outputs, source = _regression(data)
    exact, ridge = estimates(rows, outputs, 0.0), estimates(rows, outputs, 1.0)
    ordinary = np.linalg.lstsq(rows, outputs, rcond=None)[0].tolist()
    k = np.arange(len(rows)) + 1.0
    drawn, values = [], []
    for i, (name, reach) in enumerate(zip(PREDICTORS, (1.0, 1.0, 30.0, 30.0), strict=True)):
        lines = (
            (np.full(len(k), ordinary[i]), "least squares", "truth"),
            (exact[:, i], "exact start", "first"),
            (ridge[:, i], "ridge 1", "second"),
        )
        drawn.append(panel(name, k, *lines, x="sample", limits=(ordinary[i] - reach, ordinary[i] + reach)))
        values += [
            Value(f"{name}, recursive, at the end", float(exact[-1, i])),
            Value(f"{name}, least squares by LAPACK", ordinary[i]),
        ]
    return Reproduction(tuple(values), drawing("Figure 3.10, example 7: parameters", drawn), source)


@figure("3.11", reads=SNIFFER)
def figure_3_11(data: Path | None) -> Reproduction:
    """Example 7: given and estimated signal.

    As 3.10.
    """
    rows, outputs, source = _regression(data)
    fitted = rows @ estimates(rows, outputs, 0.0)[-1]
    k = np.arange(len(rows)) + 1.0
    values = (
        Value("samples", float(len(rows))),
        Value("RMS of given - estimated", float(np.sqrt(np.mean((outputs - fitted) ** 2)))),
    )
    lines = panel("vapours", k, (outputs, "given", "first"), (fitted, "estimated", "second"), x="sample")
    return Reproduction(values, drawing("Figure 3.11, example 7: signal", [lines]), source)


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

    system, generator = examples.interlaced_states()
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
    system, generator = examples.interlaced_masses()
    system = system.with_values({one: examples.SPRINGS[str(one)] for one in system.parameters()})
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
