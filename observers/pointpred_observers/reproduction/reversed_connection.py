"""Figures 3.8 to 3.11 of the thesis: examples 5 to 7, observers from the reversed connection."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred.drawing import Look, drawing
from pointpred.errors import RecordingError
from pointpred.records import FloatArray
from pointpred.reproduction.figure import Reproduction, Value, matrix_values
from pointpred_observers import NonlinearRegressor, RecursiveLeastSquares, invariant_observer, trajectory
from pointpred_observers.examples import UNMEASURED, fused, pushes, two_masses, two_sensors, vapours
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver
from pointpred_observers.reproduction.figures import figure, panel, panels

SNIFFER = "sniffer.csv"
PREDICTORS = ("tank temperature", "gas temperature", "tank pressure", "gas pressure")
"""The four predictors of example 7, in the order of their columns."""


def observed_masses(observer: InvariantObserver, t: FloatArray) -> tuple[FloatArray, FloatArray]:
    """States of example 5 at the times t, and an observer's estimates of them."""
    plant = two_masses()

    def field(now: float, both: FloatArray) -> FloatArray:
        u = pushes(now)
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
    t, plant = np.arange(0.0, 15.0, 0.05), two_masses()
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
    j, weight, x = two_sensors(t)
    stage = NonlinearRegressor(2, f="atan", gain=0.75)
    estimate = stage.walk(np.zeros(len(t), np.bool_), np.column_stack([t, j, fused(t), weight]))
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
    rows, outputs = vapours() if measured is None else measured
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
