"""Cost of a step of the camera's observer and of its filter: ``python -m benchmarks.camera_cost``."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from benchmarks.machine import machine
from pages.arguments import parse
from pages.data import Table, keep
from pointpred.camera import SCENARIOS, DepthObserver, PointFilter, trajectory
from pointpred.camera.samples import observed

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


if __name__ == "__main__":
    parse(__doc__)
    keep("camera", {"cost": costs()}, machine=machine())
