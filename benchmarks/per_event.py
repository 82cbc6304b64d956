"""What one event costs: ``make bench`` prints the table and writes it into docs/evidence/cost.md.

Every pipeline is measured in the same run, in turns, so that a slow moment of the machine hits all alike:
streaming (``update`` an event), frames of 32 events, whole trials; beside them the plain-Python run of the
same source and a naive KEP that refits with numpy.polyfit at every event. The nanoseconds belong to the
machine, which the page names; the ratios carry over better, but not exactly.
"""

from __future__ import annotations

import json
import os
import pickle
import platform
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from benchmarks.arguments import words
from benchmarks.naive_kep import NaiveKep
from pages.markdown import filled
from pointpred import REGISTRY, EventColumns, Pipeline, build, run
from pointpred.console import counted
from pointpred.scoring import prepare, replay
from pointpred.simulation import thesis_setup

PAGE = Path(__file__).parent.parent / "docs" / "evidence" / "cost.md"
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
    if not plain:
        actions["naive KEP (numpy.polyfit)", "streaming"] = NaiveKep().walk(events)
    for action in actions.values():
        action()  # compiled code is loaded here, not in the measurement
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
    command = [sys.executable, "-m", "benchmarks.per_event", PLAIN]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    table: dict[str, dict[str, float]] = json.loads(done.stdout)
    return table


def rows(compiled: dict[str, dict[str, float]], plain: dict[str, dict[str, float]]) -> list[str]:
    """The table in Markdown."""
    lines = [
        "| pipeline | streaming, ns | frame of 32, ns | whole trial, ns | plain Python, ns "
        "| plain / compiled | memory, bytes |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for name, cost in compiled.items():
        if name not in REGISTRY:
            lines.append(f"| {name} | {cost['streaming']:.0f} | | | | | grows |")
            continue
        slow = plain[name]["streaming"]
        size = len(pickle.dumps(build(name, cpi=2000.0)))
        lines.append(
            f"| `{name}` | {cost['streaming']:.0f} | {cost['frame']:.0f} | {cost['whole']:.0f} | {slow:.0f} "
            f"| {slow / cost['streaming']:.1f} | {size} |"
        )
    return lines


def scoring_rows() -> list[str]:
    """Events scored a second with all processors: replay and measures of 960 simulated trials."""
    prepared = prepare(thesis_setup(1))
    lines = [
        "| pipeline | million events a second, scored | us of processor an event |",
        "| --- | ---: | ---: |",
    ]
    for name in REGISTRY:
        pipeline = build(name, cpi=2000.0)
        replay(prepared, pipeline)  # compiled code is loaded here
        times, costs = [], []
        for _ in range(3):
            start = time.perf_counter()
            costs.append(replay(prepared, pipeline).us_per_event)
            times.append(time.perf_counter() - start)
        rate = len(prepared.events) / statistics.median(times) / 1e6
        lines.append(f"| `{name}` | {rate:.1f} | {statistics.median(costs):.2f} |")
    return lines


def machine(cpuinfo: Path = Path("/proc/cpuinfo")) -> str:
    """The processor that measures, as far as the system names it, its cores, and Python."""
    lines = cpuinfo.read_text(encoding="utf-8").splitlines() if cpuinfo.exists() else []
    named = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    model = named or platform.processor() or platform.machine()
    cores = counted(os.cpu_count() or 1, "core")
    return f"Measured on: {model}, {cores}, Python {platform.python_version()}."


def command_rows() -> list[str]:
    """Seconds until the command line has answered, with the compile cache present."""
    lines = ["| command | s |", "| --- | ---: |"]
    for arguments in (["--help"], ["predictors"], ["score", "--predictors", "switched"]):
        times = []
        for _ in range(4):
            start = time.perf_counter()
            subprocess.run([sys.executable, "-m", "pointpred", *arguments], check=True, capture_output=True)
            times.append(time.perf_counter() - start)
        lines.append(f"| `pointpred {' '.join(arguments)}` | {statistics.median(times[1:]):.2f} |")
    return lines


def main(wanted: list[str]) -> None:
    """Measure, print, and write the page; for ``PLAIN``, print what plain Python needs, and no more."""
    if wanted == [PLAIN]:
        print(json.dumps(measure(plain=True)))
        return
    print("measuring every pipeline in turns; this takes about two minutes", file=sys.stderr)
    page = PAGE.read_text(encoding="utf-8")
    parts = {
        "machine": [machine()],
        "cost": rows(measure(), measure_plain()),
        "scoring": scoring_rows(),
        "commands": command_rows(),
    }
    for name, lines in parts.items():
        text = "\n".join(lines)
        print(text, end="\n\n")
        page = filled(page, name, text)
    PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main(words(__doc__, named=PLAIN, known=[PLAIN], most=1))
