"""What one event costs: ``make bench`` prints tables and keeps them.

Every pipeline is measured in the same run, in turns, so that a slow moment of the machine hits all alike:
streaming (``update`` an event), frames of 32 events, whole trials; beside them the plain-Python run of the
same source. The nanoseconds belong to the
machine, which the page names; the ratios carry over better, but not exactly.
"""

from __future__ import annotations

import json
import os
import pickle
import statistics
import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.machine import machine
from pointpred import REGISTRY, EventColumns, Pipeline, build, run
from pointpred.scoring import prepare, replay
from pointpred.simulation import thesis_setup

PLAIN = "plain"
"""What the process is told that measures the laws as plain Python."""
ROUNDS = 5
FRAME = 32


def reach(seconds: float = 1.0) -> EventColumns:
    """A generated reach at 1 kHz with jittered stamps and counts at 2000 CPI."""
    random = np.random.default_rng(4)
    t = np.arange(0.0, seconds, 0.001) + random.uniform(-2e-4, 2e-4, int(seconds * 1000))
    s = np.clip(t / (0.8 * seconds), 0.0, 1.0)
    way = 10 * s**3 - 15 * s**4 + 6 * s**5
    x, y = np.round(700 * way), np.round(200 * way)
    return EventColumns.of(t, x, y, np.diff(4 * x, prepend=0.0), np.diff(4 * y, prepend=0.0))


def nanoseconds(action: Callable[[], object], events: int) -> float:
    """Time one call and share it among the events it consumed."""
    start = time.perf_counter_ns()
    action()
    return (time.perf_counter_ns() - start) / events


def stream(pipeline: Pipeline, events: EventColumns) -> Callable[[], object]:
    """Feed records one by one, as a live source does."""
    records = list(events.events())

    def action() -> None:
        pipeline.reset()
        for record in records:
            pipeline.update(record)

    return action


def frames(pipeline: Pipeline, events: EventColumns) -> Callable[[], object]:
    """Feed tables of 32 rows, as the socket does."""
    cuts = range(0, len(events), FRAME)
    tables = [events.rows(at, min(at + FRAME, len(events))) for at in cuts]

    def action() -> None:
        pipeline.reset()
        for table in tables:
            run(pipeline, table)

    return action


def whole(pipeline: Pipeline, events: EventColumns) -> Callable[[], object]:
    """Feed a whole trial as one table."""

    def action() -> None:
        pipeline.reset()
        run(pipeline, events)

    return action


def measure(plain: bool = False) -> dict[str, dict[str, float]]:
    """Nanoseconds an event for every pipeline: the median of interleaved rounds."""
    events = reach()
    modes = {"streaming": stream} if plain else {"streaming": stream, "frame": frames, "whole": whole}
    actions = {
        (name, mode): make(build(name, cpi=2000.0), events)
        for name in REGISTRY
        for mode, make in modes.items()
    }
    for action in actions.values():
        action()  # what the first call takes longer is not measured
    rounds = 1 if plain else ROUNDS
    times: dict[tuple[str, str], list[float]] = {key: [] for key in actions}
    for _ in range(rounds):
        for key, action in actions.items():
            times[key].append(nanoseconds(action, len(events)))
    table: dict[str, dict[str, float]] = {}
    for (name, mode), values in times.items():
        table.setdefault(name, {})[mode] = statistics.median(values)
    return table


def measure_plain() -> dict[str, dict[str, float]]:
    """The streaming column once more, with the same source as plain Python in a process of its own."""
    environment = {**os.environ, "POINTPRED_COMPILED": "0"}
    command = [sys.executable, "-m", "evidence.costs.per_event", PLAIN]
    process = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    table: dict[str, dict[str, float]] = json.loads(process.stdout)
    return table


COST = (
    "pipeline",
    "streaming, ns",
    "frame of 32, ns",
    "whole trial, ns",
    "plain Python, ns",
    "plain / compiled",
    "memory, bytes",
)


def cost_rows(
    compiled: dict[str, dict[str, float]], plain: dict[str, dict[str, float]]
) -> list[tuple[str, ...]]:
    """Nanoseconds an event, a row a pipeline."""
    rows = []
    for name, cost in compiled.items():
        slow = plain[name]["streaming"]
        times = (f"{cost[mode]:.0f}" for mode in ("streaming", "frame", "whole"))
        size = len(pickle.dumps(build(name, cpi=2000.0)))
        rows.append((f"`{name}`", *times, f"{slow:.0f}", f"{slow / cost['streaming']:.1f}", f"{size}"))
    return rows


def scoring_rows() -> list[tuple[str, ...]]:
    """Events scored a second with all processors: replay and measures of 960 simulated trials."""
    prepared = prepare(thesis_setup(1))
    rows = []
    for name in REGISTRY:
        pipeline = build(name, cpi=2000.0)
        replay(prepared, pipeline)  # what the first call takes longer is not measured
        times, costs = [], []
        for _ in range(3):
            start = time.perf_counter()
            costs.append(replay(prepared, pipeline).us_per_event)
            times.append(time.perf_counter() - start)
        rate = len(prepared.events) / statistics.median(times) / 1e6
        rows.append((f"`{name}`", f"{rate:.1f}", f"{statistics.median(costs):.2f}"))
    return rows


def command_rows() -> list[tuple[str, ...]]:
    """Seconds until the command line has answered."""
    rows = []
    for arguments in (["--help"], ["predictors"], ["score", "--predictors", "switched"]):
        times = []
        for _ in range(4):
            start = time.perf_counter()
            subprocess.run([sys.executable, "-m", "pointpred", *arguments], check=True, capture_output=True)
            times.append(time.perf_counter() - start)
        rows.append((f"`pointpred {' '.join(arguments)}`", f"{statistics.median(times[1:]):.2f}"))
    return rows


def main(wanted: list[str]) -> None:
    """Measure and keep the numbers; for ``PLAIN``, print what plain Python needs, and no more."""
    if wanted == [PLAIN]:
        print(json.dumps(measure(plain=True)))
        return
    print("measuring every pipeline in turns; this takes about two minutes", file=sys.stderr)
    tables = {
        "cost": Table.of(COST, cost_rows(measure(), measure_plain())),
        "scoring": Table.of(
            ("pipeline", "million events a second, scored", "us of processor an event"), scoring_rows()
        ),
        "commands": Table.of(("command", "s"), command_rows()),
    }
    for one in tables.values():
        print("\n".join("  ".join(row) for row in one.texts()), end="\n\n")
    keep("costs", tables, part="events", machine=machine())


if __name__ == "__main__":
    main(parse(__doc__, metavar=PLAIN, choices=[PLAIN], most=1))
