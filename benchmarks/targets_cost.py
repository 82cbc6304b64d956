"""Cost of choosing among targets, by their number: ``python -m benchmarks.targets_cost``."""

from __future__ import annotations

import time

import numpy as np

from benchmarks.machine import machine
from pages.arguments import parse
from pages.data import Table, keep
from pointpred import PointerEvent, Prediction
from pointpred.targets import Chooser, around


def cost() -> Table:
    """Microseconds of one update of a chooser, by the number of targets."""
    rows = []
    for count in (1, 13, 100, 1000):
        generator = np.random.default_rng(count)
        places = [around(i, *generator.uniform(0.0, 2000.0, 2).tolist(), 40.0) for i in range(count)]
        cells = []
        for tail in (None, 4.0):
            chooser, t = Chooser(places), 0.0
            law = Prediction(0.0, 900.0, 500.0, (900.0, 100.0, 400.0), "ballistic", 0.3, tail)
            took = []
            for i in range(300):
                event = PointerEvent(0.001 * i, 3.0 * i, 2.0 * i)
                t = time.perf_counter()
                chooser.update(law, event)
                took.append(time.perf_counter() - t)
            cells.append(f"{1e6 * float(np.median(took[20:])):.0f}")
        rows.append((str(count), *cells))
    return Table.of(("targets", "normal law, us", "Student law, us"), rows)


if __name__ == "__main__":
    parse(__doc__)
    keep("targets", {"cost": cost()}, machine=machine())
