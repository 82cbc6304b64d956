"""Examples 5 to 7 of the thesis: figures, and the table on real data.

``python -m pages.observers.examples_5_7``; example 7 needs sniffer.csv in the folder that
POINTPRED_RECORDINGS names.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np

from pages import DOCS
from pages.arguments import parse
from pages.data import Table, keep
from pages.observers.examples_1_4 import OTHER, SEEN, TRUE, panels
from pointpred.columns import FloatArray
from pointpred.observers import (
    InvariantObserver,
    NonlinearRegressor,
    RecursiveLeastSquares,
    design_reduced_order,
    invariant_observer,
    simulate,
)
from pointpred.observers.examples import (
    UNMEASURED,
    fused,
    pushes,
    two_masses,
    two_sensors,
    vapours,
)

PAGES = DOCS / "guide" / "observers"
NAMES = ("tank temperature", "gas temperature", "tank pressure", "gas pressure")


def sniffer() -> tuple[FloatArray, FloatArray] | None:
    """The data of example 7, ``None`` where they are not at hand."""
    folder = os.environ.get("POINTPRED_RECORDINGS")
    path = Path(folder, "sniffer.csv") if folder else None
    if path is None or not path.is_file():
        return None
    data = np.genfromtxt(path, delimiter=",", skip_header=1)
    return data[:, :4], data[:, 4]


def recursion(rows: FloatArray, outputs: FloatArray, total: FloatArray, x: FloatArray) -> FloatArray:
    """(3.62) as printed, from a matrix that stands for the samples before."""
    for row, output in zip(rows, outputs, strict=True):
        total = total + np.outer(row, row)
        x = x + np.linalg.solve(total, row) * (output - row @ x)
    return x


def estimates(rows: FloatArray, outputs: FloatArray, ridge: float) -> FloatArray:
    """The estimate after each sample, NaN where there is none yet."""
    stage, estimate = RecursiveLeastSquares(4, ridge=ridge), np.full((len(rows), 4), np.nan)
    for i, (row, output) in enumerate(zip(rows, outputs, strict=True)):
        stage.update(row, float(output))
        values = stage.fit().values
        if values is not None:
            estimate[i] = values
    return estimate


def starts(rows: FloatArray, outputs: FloatArray) -> Table:
    """What each start makes of the data, as a table."""
    listed = {
        "ordinary least squares (LAPACK)": np.linalg.lstsq(rows, outputs, rcond=None)[0],
        "recursive, exact start": estimates(rows, outputs, 0.0)[-1],
        "recursive, ridge 0.01": estimates(rows, outputs, 0.01)[-1],
        "recursive, ridge 1": estimates(rows, outputs, 1.0)[-1],
        "as printed, begun from zero at the fourth sample": recursion(
            rows[3:], outputs[3:], rows[:3].T @ rows[:3], np.zeros(4)
        ),
    }
    return Table.of(("start", *NAMES), [(name, *(f"{v:.4f}" for v in x)) for name, x in listed.items()])


def _followed(observer: InvariantObserver, t: FloatArray) -> tuple[FloatArray, FloatArray]:
    """States of example 5 and what an observer makes of them."""
    plant = two_masses()

    def field(now: float, both: FloatArray) -> FloatArray:
        u = pushes(now)
        return np.concatenate([plant.field(now, both[:4], rho=u), observer.field(now, both[4:], both[:2], u)])

    start = [1.0, 0.0, 0.5, 0.0, *observer.invariant(0.0, [1.0, 0.0, 0.0, 0.0])]
    both = simulate(field, start, t, step_s=0.01)
    estimate = np.array([observer.estimate(now, row[4:], row[:2]) for now, row in zip(t, both, strict=True)])
    return both[:, :4], estimate


def example_5(file: Path) -> None:
    t, plant = np.arange(0.0, 15.0, 0.05), two_masses()
    observers = {
        "printed Upsilon": (invariant_observer(plant, UNMEASURED, [[-1, 0], [0, 0]]), SEEN),
        "diag(-1, 1), global": (invariant_observer(plant, UNMEASURED, [[-1, 0], [0, 1]]), OTHER),
        "chosen, y within f": (
            design_reduced_order(plant, UNMEASURED, decay=0.5, injection=True).observer,
            "tab:red",
        ),
    }
    runs = {name: (*_followed(observer, t), colour) for name, (observer, colour) in observers.items()}
    x = next(iter(runs.values()))[0]
    axes = []
    for i in (2, 3):
        lines = [(x[:, i], f"x{i + 1}", "black")]
        axes.append((f"x{i + 1}", lines + [(values[:, i], name, c) for name, (_, values, c) in runs.items()]))
    size = [
        (np.log10(np.linalg.norm(values - true, axis=1) + 1e-12), name, c)
        for name, (true, values, c) in runs.items()
    ]
    panels(file, t, [*axes, ("log10 error", size)])


def example_6(file: Path) -> None:
    t = np.arange(0.0, 40.0, 0.02)
    j, weight, x = two_sensors(t)
    stage = NonlinearRegressor(2, f="atan", gain=0.75)
    estimate = stage.walk(np.zeros(len(t), np.bool_), np.column_stack([t, j, fused(t), weight]))
    axes = [(f"x{i + 1}", [(x[:, i], f"x{i + 1}", TRUE), (estimate[:, i], "estimate", SEEN)]) for i in (0, 1)]
    panels(file, t, [*axes, ("error", [(np.linalg.norm(estimate - x, axis=1), "norm", "tab:red")])])


def example_7(file: Path) -> None:
    """On the real data where they are at hand, else on the stand-in, which the label says."""
    data = sniffer()
    rows, outputs = vapours() if data is None else data
    source = "stand-in" if data is None else "measured"
    exact, ridge, k = estimates(rows, outputs, 0.0), estimates(rows, outputs, 1.0), np.arange(len(rows)) + 1.0
    axes = [
        (name, [(exact[:, i], "exact start", TRUE), (ridge[:, i], "ridge 1", SEEN)])
        for i, name in enumerate(NAMES)
    ]
    axes.append(("vapours", [(outputs, source, TRUE), (rows @ exact[-1], "fitted", SEEN)]))
    panels(file, k, axes, "sample")


FIGURES: dict[str, Callable[[Path], None]] = {
    "example-5": example_5,
    "example-6": example_6,
    "example-7": example_7,
}


def main() -> None:
    """Draw every figure, and fill in the table where the data are at hand."""
    for name, draw in FIGURES.items():
        draw(PAGES / "figures" / f"{name}.svg")
        print(f"wrote {name}.svg")
    data = sniffer()
    if data is None:
        print("sniffer.csv is not at hand: the table of example 7 stays as it is")
    else:
        keep("observers", {"sniffer": starts(*data)})


if __name__ == "__main__":
    parse(__doc__)
    main()
