"""Cost of template matching with 1, 64 and 1,000 templates: ``python -m benchmarks.ktm_cost``."""

from __future__ import annotations

import statistics
import time

import numpy as np

from benchmarks.machine import machine
from benchmarks.per_event import reach
from pages import PAGES
from pages.arguments import parse
from pages.data import Table, Tables, write
from pointpred import Pipeline, build
from pointpred.records import EventColumns, FloatArray

ROUNDS = 7
RATES_HZ = (1000, 125)
OTHERS = ("hold", "minimum-jerk", "kep-quartic", "switched")


def generated(count: int, seed: int = 5) -> FloatArray:
    """Templates of minimum-jerk movements of 50 to 1500 px in 0.3 to 2.5 s."""
    random = np.random.default_rng(seed)
    library = np.zeros((count, 2 + 61))
    for row in library:
        seconds, px = random.uniform(0.3, 2.5), random.uniform(50.0, 1500.0)
        share = np.clip(np.arange(0.0, seconds, 0.05) / seconds, 0.0, 1.0)
        way = px * share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
        row[0], row[1] = len(way), px
        row[3 : 2 + len(way)] = np.diff(way) * 20.0
    return library


def streamed(pipeline: Pipeline, events: EventColumns) -> FloatArray:
    """Microseconds of ``update`` for each event: the median over rounds."""
    records = list(events.events())
    times = np.empty((ROUNDS, len(records)))
    for spent in times:
        pipeline.reset()
        for k, record in enumerate(records):
            start = time.perf_counter_ns()
            pipeline.update(record)
            spent[k] = (time.perf_counter_ns() - start) / 1e3
    return np.asarray(np.median(times, axis=0))


def costs() -> Table:
    """A row a pipeline: microseconds an event, mean and largest, and the ratio to ``hold``."""
    pipelines = {f"`{name}`": build(name) for name in OTHERS}
    for count in (1, 64, 1000):
        label = f"`ktm`, {count} template{'s' if count > 1 else ''}"
        pipelines[label] = build("ktm", templates=0, library=generated(count))
    lines = []
    floors: dict[int, float] = {}
    for name, pipeline in pipelines.items():
        cells = []
        for rate in RATES_HZ:
            events = reach()
            events = EventColumns(events.table[:: 1000 // rate])
            streamed(pipeline, events)  # compiled code is loaded here
            spent = streamed(pipeline, events)
            mean = statistics.fmean(spent.tolist())
            floors.setdefault(rate, mean)
            cells += [f"{mean:.1f}", f"{spent.max():.0f}", f"{mean / floors[rate]:.1f}"]
        lines.append((name, *cells))
    header = [f"{what}, {rate} Hz" for rate in RATES_HZ for what in ("mean us", "largest us", "times `hold`")]
    return Table.of(("pipeline", *header), lines)


if __name__ == "__main__":
    parse(__doc__)
    write(Tables({"cost": costs()}, machine()), PAGES / "ktm" / "data.json")
