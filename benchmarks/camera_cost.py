"""Cost of steps of the camera's observer and filter, and of designs: ``python -m benchmarks.camera_cost``."""

from __future__ import annotations

import time
from contextlib import suppress
from typing import Any

import numpy as np

from benchmarks.machine import machine
from pages.arguments import parse
from pages.camera.tables import asked
from pages.data import Table, keep
from pointpred.errors import InfeasibleError
from pointpred_observers.camera import SCENARIOS, DepthObserver, PointFilter, camera_system, trajectory
from pointpred_observers.camera.samples import observed
from pointpred_observers.unknown_input.boxes import Box
from pointpred_observers.unknown_input.observer import UnknownInputObserver

FOCAL = 800.0
START = {"start_chi": 4.0, "start_eta": -1.6}


def costs() -> Table:
    """Microseconds a step of the compiled laws, through ``step`` alone, ``update`` and a table."""
    samples = observed(trajectory(SCENARIOS["paper"], np.arange(3301) / 330.0), focal_px=FOCAL)
    rows, values, records = [], [tuple(row) for row in samples.table.tolist()], samples.samples()
    stages: list[tuple[str, Any]] = [
        ("observer", DepthObserver(focal_px=FOCAL, **START)),
        ("filter (peer)", PointFilter(focal_px=FOCAL)),
    ]
    for name, stage in stages:
        ways = {
            "step": lambda stage=stage: [stage.step(stage._memory, row) for row in values],
            "update": lambda stage=stage: [stage.update(record) for record in records],
            "table": lambda stage=stage: stage.run(samples),
        }
        cells = []
        for run in ways.values():
            times = []
            for _ in range(15):
                stage.reset()
                start = time.perf_counter()
                run()
                times.append(time.perf_counter() - start)
            cells.append(f"{1e6 * min(times) / len(values):.2f}")
        rows.append((name, *cells))
    return Table.of(("us a sample", "step", "update", "in a table"), rows)


def design_costs() -> Table:
    """Seconds that a design takes, or its refusal, after a first one that imports the solver."""
    _design(*asked()[0][1:])
    rows = []
    for names, box, sigma in asked():
        start = time.perf_counter()
        _design(box, sigma)
        rows.append((*names, f"{time.perf_counter() - start:.2f}"))
    return Table.of(("eta 1/s", "sigma 1/s", "seconds"), rows)


def _design(box: Box, sigma: float) -> None:
    with suppress(InfeasibleError):
        UnknownInputObserver.design(camera_system(), box, sigma)


if __name__ == "__main__":
    parse(__doc__)
    keep("camera", {"cost": costs(), "design cost": design_costs()}, machine=machine())
