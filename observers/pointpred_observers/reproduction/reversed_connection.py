"""Figures 3.8 to 3.11 of the thesis: examples 5 to 7, observers from the reversed connection."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred.drawing import Look, Panel, beside, drawing
from pointpred.errors import RecordingError
from pointpred.records import FloatArray
from pointpred.reproduction.figure import Reproduction, Value, matrix_values
from pointpred_observers import NonlinearRegressor, RecursiveLeastSquares, invariant_observer, trajectory
from pointpred_observers.examples import UNMEASURED, fused, pushes, two_masses, two_sensors, vapours
from pointpred_observers.reduced_order.design import ReducedOrderObserver
from pointpred_observers.reduced_order.reversed_connection import InvariantObserver

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


def figure_3_8(_: Path | None) -> Reproduction:
    """Example 5: the states of the second mass by the printed, a global and a designed observer."""
    t, plant = np.arange(0.0, 15.0, 0.05), two_masses()
    printed = invariant_observer(plant, UNMEASURED, [[-1.0, 0.0], [0.0, 0.0]])
    looks: dict[str, tuple[InvariantObserver, Look]] = {
        "printed Upsilon": (printed, "second"),
        "diag(-1, 1), global": (invariant_observer(plant, UNMEASURED, [[-1.0, 0.0], [0.0, 1.0]]), "third"),
        "designed, y within f": (
            ReducedOrderObserver.design(plant, Pi=UNMEASURED, decay=0.5, injection=True).observer,
            "first",
        ),
    }
    runs = {name: (*observed_masses(observer, t), look) for name, (observer, look) in looks.items()}
    x = next(iter(runs.values()))[0]
    panels = [
        Panel(
            f"x{i + 1}",
            beside(
                t,
                (x[:, i], f"x{i + 1}", "truth"),
                *((estimate[:, i], name, look) for name, (_, estimate, look) in runs.items()),
            ),
        )
        for i in (2, 3)
    ]
    errors = {name: np.linalg.norm(estimate - true, axis=1) for name, (true, estimate, _) in runs.items()}
    lines = beside(t, *((errors[name] + 1e-12, name, look) for name, (_, _, look) in runs.items()))
    panels.append(Panel("norm of the error", lines, logarithmic=True))
    now = printed.at(0.0)
    values = (
        *matrix_values("S0", now.S0, [["0", "1"], ["-3.6", "-2.6"]]),
        *matrix_values("S1", now.S1, [["0"], ["3"]]),
        *matrix_values("J", now.J, [["-1", "0"]]),
        # The print has one column, for u; ours has those of u and of u1.
        *matrix_values("O", now.O[:, :1], [["0"], ["1"]]),
        *matrix_values("B", now.B, [["0", "-1"], ["-0.6", "0.6"]]),
        *(Value(f"norm of the error at 10 s, {name}", float(one[t.searchsorted(10.0)]))
          for name, one in errors.items()),
    )  # fmt: skip
    return Reproduction(values, drawing("Figure 3.8, example 5", panels), "simulated, without noise")


def figure_3_9(_: Path | None) -> Reproduction:
    """Example 6: two varying parameters and their estimates."""
    t = np.arange(0.0, 40.0, 0.02)
    j, weight, x = two_sensors(t)
    stage = NonlinearRegressor(2, f="atan", gain=0.75)
    estimate = stage.walk(np.zeros(len(t), np.bool_), np.column_stack([t, j, fused(t), weight]))
    error = np.linalg.norm(estimate - x, axis=1)
    panels = [
        Panel(f"x{i + 1}", beside(t, (x[:, i], f"x{i + 1}", "truth"), (estimate[:, i], "estimate", "second")))
        for i in (0, 1)
    ]
    panels.append(Panel("error", beside(t, (error, "norm", "first"))))
    values = (
        Value("x1 at 0 s", float(x[0, 0]), "3"),
        Value("x2 at 0 s", float(x[0, 1]), "5"),
        Value("largest norm of the error in the last 10 s", float(error[t >= 30.0].max())),
    )
    return Reproduction(values, drawing("Figure 3.9, example 6", panels), "simulated")


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


def figure_3_10(data: Path | None) -> Reproduction:
    """Example 7: the four parameters by recursive least squares, beside ordinary least squares."""
    rows, outputs, source = _regression(data)
    exact, ridge = estimates(rows, outputs, 0.0), estimates(rows, outputs, 1.0)
    ordinary = np.linalg.lstsq(rows, outputs, rcond=None)[0]
    k = np.arange(len(rows)) + 1.0
    panels = [
        Panel(
            name,
            beside(
                k,
                (np.full(len(k), ordinary[i]), "least squares", "truth"),
                (exact[:, i], "exact start", "first"),
                (ridge[:, i], "ridge 1", "second"),
            ),
            x="sample",
            limits=(float(ordinary[i] - reach), float(ordinary[i] + reach)),
        )
        for i, (name, reach) in enumerate(zip(PREDICTORS, (1.0, 1.0, 30.0, 30.0), strict=True))
    ]
    values = tuple(
        value
        for i, name in enumerate(PREDICTORS)
        for value in (
            Value(f"{name}, recursive, at the end", float(exact[-1, i])),
            Value(f"{name}, least squares by LAPACK", float(ordinary[i])),
        )
    )
    return Reproduction(values, drawing("Figure 3.10, example 7: parameters", panels), source)


def figure_3_11(data: Path | None) -> Reproduction:
    """Example 7: the measured output beside the fitted one."""
    rows, outputs, source = _regression(data)
    fitted = rows @ estimates(rows, outputs, 0.0)[-1]
    k = np.arange(len(rows)) + 1.0
    lines = beside(k, (outputs, "given", "first"), (fitted, "estimated", "second"))
    values = (
        Value("samples", float(len(rows))),
        Value("RMS of given - estimated", float(np.sqrt(np.mean((outputs - fitted) ** 2)))),
    )
    panels = [Panel("vapours", lines, x="sample")]
    return Reproduction(values, drawing("Figure 3.11, example 7: signal", panels), source)
